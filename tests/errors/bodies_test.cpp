/// [case], [[body]], [material], [formulation] that are wrong.

#include "errors/wrong_case.hpp"

namespace sinew {

static const std::vector<WrongCase> wrong_bodies{
    {"UnknownSection", "[output]", "[outputs]",
     "case.toml:31:2: unknown key \"outputs\". Did you mean \"output\"? Known keys: case, parameters, body, material, "
     "formulation, region, initial, boundary, body_force, contact, wall, solver, stage, output, probe, expect, study."},
    {"UnknownKeyInCase", "name = \"column\"\ndim", "nam = \"column\"\ndim",
     "case.toml:2:1: [case]: unknown key \"nam\". Did you mean \"name\"? Known keys: name, reference, dimension, plane, "
     "thickness, units, tier."},
    {"UnknownKeyInBody", "material = \"rubber\"", "material = \"rubber\"\nstabilisation = []",
     "case.toml:11:1: body \"column\": unknown key \"stabilisation\". Known keys: name, geometry, material."},
    {"UnknownKeyInGeometry", "low =", "lo =",
     "case.toml:9:29: body \"column\": geometry: unknown key \"lo\". Did you mean \"low\"? Known keys: shape, low, high, "
     "spacing, lattice, jitter, seed, on_faces."},
    {"UnknownKeyInMaterial", "poissons_ratio", "poisson_ratio",
     "case.toml:15:1: material \"rubber\": unknown key \"poisson_ratio\". Did you mean \"poissons_ratio\"? Known keys: model, "
     "density, youngs_modulus, poissons_ratio, bulk_modulus, shear_modulus, lame_lambda."},
    {"UnknownKeyInFormulation", "stabilization =", "stabilisation =",
     "case.toml:19:1: [formulation]: unknown key \"stabilisation\". Did you mean \"stabilization\"? Known keys: model, kernel, "
     "support, neighbors, correction, deformation_gradient, momentum, project_angular_momentum, stabilization, "
     "reference_update."},
    {"UnknownKeyInStabilization", "alpha", "alfa",
     "case.toml:19:52: [formulation]: stabilization 1: unknown key \"alfa\". Known keys: model, alpha, normalization, "
     "plastic_switch."},
    {"SectionIsNumber", "[output]\n", "output.every = 1\n[outputx]\n",
     "case.toml:32:2: unknown key \"outputx\". Did you mean \"output\"? Known keys: case, parameters, body, material, "
     "formulation, region, initial, boundary, body_force, contact, wall, solver, stage, output, probe, expect, study."},
    {"DimensionFour", "dimension = 3", "dimension = 4", "case.toml:3:13: [case]: dimension must be 2 or 3, found 4"},
    {"DimensionMissing", "dimension = 3\n", "", "case.toml:1:1: [case]: \"dimension\" is missing. Number of dimensions."},
    {"PlaneInThreeDimensions", "dimension = 3", "dimension = 3\nplane = \"stress\"",
     "case.toml:4:9: [case]: \"plane\" belongs to two-dimensional cases, but dimension = 3; remove it"},
    {"UnknownPlane", "dimension = 3", "dimension = 2\nplane = \"stres\"",
     "case.toml:4:9: [case]: plane: unknown name \"stres\". Did you mean \"stress\"? Known names: strain, stress."},
    {"UnknownUnits", "dimension = 3", "dimension = 3\nunits = \"imperial\"",
     "case.toml:4:9: [case]: units must be \"SI\" or { length = \"mm\", mass = \"kg\", time = \"ms\" }, found \"imperial\""},
    {"UnitsIncomplete", "dimension = 3", "dimension = 3\nunits = { length = \"mm\", mass = \"kg\" }",
     "case.toml:4:9: [case]: units: \"time\" is missing; a system of units is { length = \"mm\", mass = \"kg\", time = \"ms\" }"},
    {"UnitsOfWrongKind", "dimension = 3", "dimension = 3\nunits = { length = \"kg\", mass = \"kg\", time = \"s\" }",
     "case.toml:4:20: [case]: units: length must be a unit of length, found \"kg\""},
    {"BodyIsTable", "[[body]]", "[body]",
     "case.toml:7:1: \"body\": expected a list of tables, each written as [[body]], found a table"},
    {"BodyWithoutName", "name = \"column\"\ngeometry", "geometry",
     "case.toml:7:1: body 1: \"name\" is missing. Name of the body, by which regions and messages call it."},
    {"BodyWithoutMaterial", "material = \"rubber\"\n", "",
     "case.toml:7:1: body \"column\": \"material\" is missing. Name of a [material.NAME] table, or the same table inline."},
    {"BodyNameTwice", "[material.rubber]",
     "[[body]]\nname = \"column\"\ngeometry = { shape = \"points\", file = \"a.csv\" }\nmaterial = \"rubber\"\n[material.rubber]",
     "case.toml:12:8: the name \"column\" of a body is already taken; choose another"},
    {"BodyCalledAll", "name = \"column\"\ngeometry", "name = \"all\"\ngeometry",
     "case.toml:8:8: a body cannot be called \"all\", which means all particles"},
    {"NameIsNumber", "name = \"column\"\ngeometry", "name = 3\ngeometry",
     "case.toml:8:8: body 1: name: expected a string (text in quotes), found an integer"},
    {"UnknownMaterial", "material = \"rubber\"", "material = \"ruber\"",
     "case.toml:10:12: body \"column\": unknown material \"ruber\". Did you mean \"rubber\"? Known materials: rubber."},
    {"UnknownMaterialModel", "neo_hookean", "neo_hokean",
     "case.toml:12:9: material \"rubber\": unknown material model \"neo_hokean\". Did you mean \"neo_hookean\"? Known material "
     "models: ..."},
    {"MaterialModelMissing", "model = \"neo_hookean\"\n", "",
     "case.toml:11:1: material \"rubber\": \"model\" is missing. It names the material model, for example \"linear_elastic\""},
    {"MaterialIsNumber", "material = \"rubber\"", "material = 7",
     "case.toml:10:12: body \"column\": material: expected a name, or table with \"model\", found an integer"},
    {"InlineMaterialUnknownKey", "material = \"rubber\"",
     "material = { model = \"linear_elastic\", density = 1, youngs_modulus = 1, poissons_ratio = 0, colour = 1 }",
     "case.toml:10:93: body \"column\": material: unknown key \"colour\". Known keys: model, density, youngs_modulus, "
     "poissons_ratio, bulk_modulus, shear_modulus, lame_lambda."},
    {"OneElasticConstant", "poissons_ratio = 0.45\n", "",
     "case.toml:11:1: material \"rubber\": give exactly two of youngs_modulus, poissons_ratio, bulk_modulus, shear_modulus, "
     "lame_lambda; given: youngs_modulus"},
    {"ThreeElasticConstants", "poissons_ratio = 0.45", "poissons_ratio = 0.45\nbulk_modulus = 1e6",
     "case.toml:11:1: material \"rubber\": give exactly two of youngs_modulus, poissons_ratio, bulk_modulus, shear_modulus, "
     "lame_lambda; given: youngs_modulus, poissons_ratio, bulk_modulus"},
    {"DensityMissing", "density = 1100.0\n", "",
     "case.toml:11:1: material \"rubber\": \"density\" is missing. Reference mass density."},
    {"UnknownShape", "\"box\"", "\"bocks\"",
     "case.toml:9:22: body \"column\": geometry: unknown shape \"bocks\". Known shapes: ..."},
    {"ShapeMissing", "shape = \"box\", ", "",
     "case.toml:9:12: body \"column\": geometry: \"shape\" is missing. It names the shape, for example \"box\""},
    {"GeometryIsNumber", "geometry = {", "geometry = 3 #",
     "case.toml:9:12: body \"column\": geometry: expected a table with \"shape\", found an integer"},
    {"UnknownLattice", "spacing = \"1/n\"", "spacing = 0.1, lattice = \"cubik\"",
     "case.toml:9:89: body \"column\": geometry: lattice: unknown name \"cubik\". Did you mean \"cubic\"? Known names: auto, "
     "square, triangular, cubic, fcc."},
    {"CoordinatesAreNumber", "low = [0, 0, 0]", "low = 0",
     "case.toml:9:35: body \"column\": geometry: low: expected an array of numbers, found an integer"},
    {"CoordinateIsWord", "low = [0, 0, 0]", "low = [0, \"left\", 0]",
     "case.toml:9:39: body \"column\": geometry: low[1]: expected a number; in the expression \"left\": unknown name \"left\". "
     "Known names: n, omega, e, pi."},
    {"UnknownKernel", "cubic_spline", "cubic_splin",
     "case.toml:17:10: [formulation]: kernel: unknown kernel \"cubic_splin\". Did you mean \"cubic_spline\"? Known kernels: ..."},
    {"UnknownCorrection", "support = 2.4", "support = 2.4\ncorrection = \"gradiant\"",
     "case.toml:19:14: [formulation]: correction: unknown correction \"gradiant\". Did you mean \"gradient\"? Known corrections: "
     "..."},
    {"UnknownFormulation", "support = 2.4", "model = \"eulerian\"",
     "case.toml:18:9: [formulation]: model: unknown name \"eulerian\". Known names: total_lagrangian, updated_lagrangian."},
    {"UnknownStabilization", "hourglass_stiffness", "hourglass_stifness",
     "case.toml:19:29: [formulation]: stabilization 1: unknown stabilization \"hourglass_stifness\". Did you mean "
     "\"hourglass_stiffness\"? Known stabilizations: ..."},
    {"StabilizationTwice", "alpha = 50.0 } ]", "alpha = 50.0 }, \"hourglass_stiffness\" ]",
     "case.toml:19:68: [formulation]: stabilization: the same model is given twice"},
    {"SupportAndNeighbors", "support = 2.4", "support = 2.4\nneighbors = 12",
     "case.toml:19:13: [formulation]: \"support\" and \"neighbors\" both set the kernel radius; give only one of them"},
    {"NeighborsWithJst", "support = 2.4\nstabilization = [", "neighbors = 30\nstabilization = [ { model = \"jst\" },",
     "case.toml:18:13: [formulation]: \"neighbors\" gives each particle a kernel radius of its own, and stabilization \"jst\" "
     "needs "
     "the same for all of a body; use \"support\""},
    {"NeighborsWithBonds", "support = 2.4", "neighbors = 30\ndeformation_gradient = \"bond\"",
     "case.toml:18:13: [formulation]: \"neighbors\" gives each particle a kernel radius of its own, and momentum = \"symmetric\" "
     "needs the same for all of a body; use \"support\""},
    {"SymmetricVariational", "support = 2.4",
     "support = 2.4\ndeformation_gradient = \"bond_variational\"\nmomentum = \"symmetric\"",
     "case.toml:20:12: [formulation]: the force of \"bond_variational\" is the gradient of its energy; momentum must be "
     "\"adjoint\""},
    {"BondsThatSeparate", "poissons_ratio = 0.45\n[formulation]\n",
     "poissons_ratio = 0.45\ndamage = { model = \"principal_strain\", threshold = 0.5, separate = true "
     "}\n[formulation]\ndeformation_gradient = "
     "\"bond\"\n",
     "case.toml:18:24: [formulation]: body \"column\" comes apart (separate = true), which needs deformation_gradient = "
     "\"direct\" "
     "and momentum = \"adjoint\""},
    {"UnknownDeformationGradient", "support = 2.4", "deformation_gradient = \"bonds\"",
     "case.toml:18:24: [formulation]: deformation_gradient: unknown name \"bonds\". Did you mean \"bond\"? Known names: direct, "
     "rate, bond, bond_variational."},
};
SINEW_WRONG_CASES(WrongBodies, wrong_bodies);

TEST(WrongBodies, NoBody) {
  EXPECT_EQ(error_of("[case]\ndimension = 3\n"),
            "case.toml: there is no body; a case needs at least one [[body]] with name, geometry and material");
}

}  // namespace sinew
