/// Regions, initial and boundary conditions that are wrong.

#include "errors/wrong_case.hpp"

namespace sinew {

static const std::vector<WrongCase> wrong_conditions{
    {"UnknownKeyInRegion", "where =", "were =",
     "case.toml:21:27: region \"foot\": unknown key \"were\". Did you mean \"where\"? Known keys: body, where, box, nearest, "
     "set."},
    {"UnknownKeyInInitial", "velocity = [\"", "speed = [\"",
     "case.toml:24:1: initial 1: unknown key \"speed\". Known keys: region, velocity, displacement, stretch."},
    {"UnknownKeyInBoundary", "velocity = [0, 0, 0]", "velosity = [0, 0, 0]",
     "case.toml:27:1: boundary 1: unknown key \"velosity\". Did you mean \"velocity\"? Known keys: region, displacement, "
     "velocity, force, traction, pressure, wall, normal, area, follower."},
    {"UnknownKeyInBodyForce", "[solver]", "[body_force]\ngravity = [0, 0, 0]\n[solver]",
     "case.toml:29:1: [body_force]: unknown key \"gravity\". Known keys: acceleration."},
    {"RegionOfUnknownBody", "body = \"column\"", "body = \"colum\"",
     "case.toml:21:17: region \"foot\": unknown body \"colum\". Did you mean \"column\"? Known bodies: column."},
    {"RegionCalledAsBody",
     "foot =", "column =", "case.toml:21:1: the name \"column\" of a region is already taken; choose another"},
    {"RegionCalledAll", "foot =", "all =", "case.toml:21:1: a region cannot be called \"all\", which means all particles"},
    {"RegionEmpty", "{ body = \"column\", where = \"Z < 1/n\" }", "{}",
     "case.toml:21:8: region \"foot\": give at least one of body, where, box, nearest, set"},
    {"RegionIsString", "{ body = \"column\", where = \"Z < 1/n\" }", "\"Z < 1/n\"",
     "case.toml:21:8: region \"foot\": expected a table, found a string"},
    {"BoxWithoutHigh", "where = \"Z < 1/n\"", "box = { low = [0, 0, 0] }",
     "case.toml:21:33: region \"foot\": box: \"high\" is missing; a box is { low = [...], high = [...] }"},
    {"BoxTurnedRound", "where = \"Z < 1/n\"", "box = { low = [0, 0, 1], high = [1, 1, 0] }",
     "case.toml:21:33: region \"foot\": box: low must not be above high"},
    {"NearestTooShort", "where = \"Z < 1/n\"", "nearest = [0, 0]",
     "case.toml:21:37: region \"foot\": nearest: expected 3 components, since dimension = 3, found 2"},
    {"BoundaryOfUnknownRegion", "region = \"foot\"", "region = \"food\"",
     "case.toml:26:10: boundary 1: unknown region \"food\". Did you mean \"foot\"? Known regions: all, column, foot."},
    {"InitialOfUnknownRegion", "region = \"column\"", "region = \"colum\"",
     "case.toml:23:10: initial 1: unknown region \"colum\". Did you mean \"column\"? Known regions: all, column, foot."},
    {"RegionMissing", "region = \"foot\"\n", "", "case.toml:25:1: boundary 1: \"region\" is missing. Where it holds."},
    {"InlineRegionUnknownKey", "region = \"foot\"", "region = { wher = \"Z<1\" }",
     "case.toml:26:12: boundary 1: region: unknown key \"wher\". Did you mean \"where\"? Known keys: body, where, box, nearest, "
     "set."},
    {"InlineRegionUnknownBody", "region = \"foot\"", "region = { body = \"foot\" }",
     "case.toml:26:19: boundary 1: region: unknown body \"foot\". Known bodies: column."},
    {"InlineRegionIsNoName", "[[boundary]]\nregion = \"foot\"",
     "[[boundary]]\nregion = { where = \"Z<1\" }\nvelocity = [0, 0, 0]\n[[boundary]]\nregion = \"boundary 1\"",
     "case.toml:29:10: boundary 2: unknown region \"boundary 1\". Known regions: all, column, foot."},
    {"VectorTooShort", "velocity = [0, 0, 0]", "velocity = [0, 0]",
     "case.toml:27:12: boundary 1: velocity: expected 3 components, since dimension = 3, found 2"},
    {"VectorIsNumber", "velocity = [0, 0, 0]", "velocity = 0",
     "case.toml:27:12: boundary 1: velocity: expected an array of 3 components, found an integer"},
    {"FreeForce", "velocity = [0, 0, 0]", "force = [\"free\", 0, 0]",
     "case.toml:27:10: boundary 1: force[0]: \"free\" can only stand in a prescribed displacement or velocity; write 0 here"},
    {"NothingPrescribed", "velocity = [0, 0, 0]\n", "",
     "case.toml:25:1: boundary 1: nothing is prescribed; give one of displacement, velocity, force, traction, pressure, wall"},
    {"TwoPrescribed", "velocity = [0, 0, 0]", "velocity = [0, 0, 0]\ntraction = [0, 0, 1]",
     "case.toml:25:1: boundary 1: \"velocity\" and \"traction\" are both given; write one [[boundary]] for each"},
    {"PressureIsVector", "velocity = [0, 0, 0]", "pressure = [0, 0, 1]",
     "case.toml:27:12: boundary 1: pressure: expected a number or an expression, found an array"},
    {"NormalWithoutPressure", "velocity = [0, 0, 0]", "velocity = [0, 0, 0]\nnormal = [0, 0, 1]",
     "case.toml:28:10: boundary 1: \"normal\" belongs to pressure and wall only"},
    {"AreaOfForce", "velocity = [0, 0, 0]", "force = [0, 0, 0]\narea = 1",
     "case.toml:28:8: boundary 1: \"area\" belongs to traction and pressure only"},
    {"InitialWithNothing", "velocity = [\"-y*omega\", \"x*omega\", 0]", "",
     "case.toml:22:1: initial 1: give at least one of velocity, displacement, stretch"},
    {"InitialWithTwoPositions", "velocity = [\"-y*omega\", \"x*omega\", 0]", "displacement = [0, 0, 0]\nstretch = [1, 1, 1]",
     "case.toml:22:1: initial 1: \"displacement\" and \"stretch\" both set the positions; give only one of them"},
    {"NegativeStretch", "velocity = [\"-y*omega\", \"x*omega\", 0]", "stretch = [1, -1, 1]",
     "case.toml:24:15: initial 1: stretch[1] must be greater than 0, found -1"},
    {"BoundaryIsTable", "[[boundary]]", "[boundary]",
     "case.toml:25:1: \"boundary\": expected a list of tables, each written as [[boundary]], found a table"},
};
SINEW_WRONG_CASES(WrongConditions, wrong_conditions);

}  // namespace sinew
