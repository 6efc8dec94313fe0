/// [solver], [output], [[probe]], [[expect]], [study] that are wrong.

#include "errors/wrong_case.hpp"

namespace sinew {

static const std::vector<WrongCase> wrong_outputs{
    {"UnknownKeyInSolver", "cfl =", "clf =",
     "case.toml:29:1: [solver]: unknown key \"clf\". Did you mean \"cfl\"? Known keys: mode, integrator, cfl, wave_speed, "
     "end_time, "
     "max_steps, time_step, damping, pair_weights, lattice, block_size, ramp, longest_step, tolerance, most_iterations, "
     "linear_solver, petsc, numerical_damping, step_error."},
    {"UnknownKeyInOutput", "every =", "evry =",
     "case.toml:32:1: [output]: unknown key \"evry\". Did you mean \"every\"? Known keys: every, history_every, "
     "checkpoint_every, fields, precision, picture_field, picture."},
    {"UnknownKeyInProbe", "component =", "componet =",
     "case.toml:37:1: probe \"tip\": unknown key \"componet\". Did you mean \"component\"? Known keys: name, quantity, region, "
     "reduce, exact, component, wall, expression."},
    {"UnknownKeyInExpect", "tolerance =", "tolerence =",
     "case.toml:41:1: expect 1: unknown key \"tolerence\". Did you mean \"tolerance\"? Known keys: quantity, value, tolerance, "
     "absolute, exact, with, why, source, note, tier."},
    {"UnknownKeyInStudy", "[[expect]]", "[study]\nvery = {}\n[[expect]]",
     "case.toml:39:1: [study]: unknown key \"very\". Did you mean \"vary\"? Known keys: vary, safety."},
    {"EndTimeZero", "end_time = 0.5", "end_time = 0", "case.toml:30:12: [solver]: end_time must be greater than 0, found 0"},
    {"EndTimeMissing", "end_time = 0.5", "max_stepss = 5",
     "case.toml:30:1: [solver]: unknown key \"max_stepss\". Did you mean \"max_steps\"? Known keys: mode, integrator, cfl, "
     "wave_speed, "
     "end_time, max_steps, time_step, damping, pair_weights, lattice, block_size, ramp, longest_step, tolerance, "
     "most_iterations, linear_solver, petsc, numerical_damping, step_error."},
    {"NoEnd", "end_time = 0.5\n", "",
     "case.toml:28:1: [solver]: \"end_time\" is missing. Give the time at which the run ends, or max_steps."},
    {"CflTooLarge", "cfl = 0.3", "cfl = 1.5", "case.toml:29:7: [solver]: cfl must be greater than 0 and at most 1, found 1.5"},
    {"CflZero", "cfl = 0.3", "cfl = 0", "case.toml:29:7: [solver]: cfl must be greater than 0 and at most 1, found 0"},
    {"TimeStepNegative", "cfl = 0.3", "cfl = 0.3\ntime_step = -1e-3",
     "case.toml:30:13: [solver]: time_step must be greater than 0, found -0.001"},
    {"MaxStepsNotWhole", "cfl = 0.3", "max_steps = 1.5",
     "case.toml:29:13: [solver]: max_steps must be a whole number, found 1.5"},
    {"UnknownMode", "cfl = 0.3", "mode = \"implict\"",
     "case.toml:29:8: [solver]: mode: unknown name \"implict\". Did you mean \"implicit\"? Known names: explicit, implicit, "
     "static."},
    {"UnknownIntegrator", "cfl = 0.3", "integrator = \"verlet\"",
     "case.toml:29:14: [solver]: integrator: unknown name \"verlet\". Did you mean \"velocity_verlet\"? Known names: "
     "velocity_verlet, rk3, newmark, hht_alpha."},
    {"NegativeOutputInterval", "\"end_time/50\"", "-1", "case.toml:32:9: [output]: every must be 0 or greater, found -1"},
    {"UnknownOutputField", "fields = [\"velocity\"]", "fields = [\"velocity\", \"von_mises\"]",
     "case.toml:33:23: [output]: fields: unknown name \"von_mises\". Did you mean \"von_mises_stress\"? Known names: "
     "displacement, ..."},
    {"FieldsAreString", "fields = [\"velocity\"]", "fields = \"velocity\"",
     "case.toml:33:10: [output]: fields: expected an array of strings, found a string (\"velocity\")"},
    {"UnknownPrecision", "every =", "precision = \"float\"\nevery =",
     "case.toml:32:13: [output]: precision: unknown name \"float\". Known names: double, single."},
    {"PictureWithFolder", "every =", "picture = \"a/b.png\"\nevery =",
     "case.toml:32:11: [output]: picture must be a file name that ends with .png, without folders, found \"a/b.png\""},
    {"UnknownPictureField", "every =", "picture_field = \"speed\"\nevery =",
     "case.toml:32:17: [output]: picture_field: unknown name \"speed\". Known names: displacement, ..."},
    {"UnknownQuantity", "\"displacement\"", "\"energy.kinetik\"",
     "case.toml:36:12: probe \"tip\": quantity: unknown name \"energy.kinetik\". Did you mean \"energy.kinetic\"? Known names: "
     "displacement, ..."},
    {"ComponentMissing", "component = \"z\"\n", "",
     "case.toml:34:1: probe \"tip\": \"component\" is missing; displacement needs one of x, y, z, magnitude"},
    {"UnknownComponent", "component = \"z\"", "component = \"w\"",
     "case.toml:37:13: probe \"tip\": component of displacement: unknown name \"w\". Did you mean \"x\"? Known names: x, y, z, "
     "magnitude."},
    {"ComponentOfScalar", "\"displacement\"", "\"pressure\"",
     "case.toml:37:13: probe \"tip\": pressure is a scalar and has no component; remove it"},
    {"UnknownReduce", "component = \"z\"", "component = \"z\"\nreduce = \"average\"",
     "case.toml:38:10: probe \"tip\": reduce: unknown name \"average\". Known names: sum, mean, rms, min, max."},
    {"MeanOfEnergy", "quantity = \"displacement\"\ncomponent = \"z\"", "quantity = \"energy.total\"\nreduce = \"mean\"",
     "case.toml:37:10: probe \"tip\": energy.total is one number already, so reduce can only be \"sum\""},
    {"ReactionWithoutRegion", "\"displacement\"", "\"reaction_force\"",
     "case.toml:34:1: probe \"tip\": \"region\" is missing; it says on which particles the reaction force is summed"},
    {"ProbeOfUnknownRegion", "component = \"z\"", "component = \"z\"\nregion = \"tipp\"",
     "case.toml:38:10: probe \"tip\": unknown region \"tipp\". Known regions: all, column, foot."},
    {"ProbeNameTwice", "[[expect]]", "[[probe]]\nname = \"tip\"\nquantity = \"jacobian\"\n[[expect]]",
     "case.toml:39:8: the name \"tip\" of a probe is already taken; choose another"},
    {"ProbeNameNotWord", "name = \"tip\"", "name = \"the tip\"",
     "case.toml:35:8: the probe name \"the tip\" must consist of letters, digits and _, and begin with a letter"},
    {"ProbeNameIsParameter", "name = \"tip\"", "name = \"omega\"",
     "case.toml:35:8: the probe name \"omega\" already means something in expressions; choose another"},
    {"ProbeWithNothing", "quantity = \"displacement\"\ncomponent = \"z\"\n", "",
     "case.toml:34:1: probe \"tip\": nothing is measured; give \"quantity\" or \"expression\""},
    {"ProbeWithBoth", "component = \"z\"", "expression = \"t\"",
     "case.toml:36:12: probe \"tip\": \"expression\" is a formula over other probes and cannot have \"quantity\""},
    {"ProbeOfUnknownProbe", "[[expect]]", "[[probe]]\nname = \"a\"\nexpression = \"2*tap\"\n[[expect]]",
     "case.toml:40:14: probe \"a\": in the expression \"2*tap\": unknown name \"tap\". Did you mean \"tip\"? Known names: tip, "
     "t, end_time, n, omega, e, pi."},
    {"ExpectOfUnknownProbe", "probe.tip.min", "probe.tap.min",
     "case.toml:39:12: expect 1: unknown probe \"tap\". Did you mean \"tip\"? Known probes: tip."},
    {"ExpectUnknownReduction", "probe.tip.min", "probe.tip.minimum",
     "case.toml:39:12: expect 1: unknown reduction \"minimum\". Did you mean \"min\"? Known reductions: final, min, max, at(t), "
     "range, drift, period, frequency, rate."},
    {"ExpectWithoutProbe", "probe.tip.min", "tip.min",
     "case.toml:39:12: expect 1: quantity must look like probe.NAME.final, found \"tip.min\""},
    {"ExpectAfterTheEnd", "probe.tip.min", "probe.tip.at(2*end_time)",
     "case.toml:39:12: expect 1: \"probe.tip.at(2*end_time)\" is later than end_time, the end of the run"},
    {"ExpectRateWithoutStudy", "probe.tip.min", "probe.tip.rate",
     "case.toml:39:12: expect 1: a rate needs several runs; add [study] with vary"},
    {"ToleranceMissing", "tolerance = 0.05\n", "",
     "case.toml:38:1: expect 1: \"tolerance\" (relative) or \"absolute\" is missing"},
    {"ToleranceTwice", "tolerance = 0.05", "tolerance = 0.05\nabsolute = 0.1",
     "case.toml:42:12: expect 1: \"tolerance\" (relative) and \"absolute\" are both given; give only one of them"},
    {"RelativeToZero", "value = -0.1", "value = 0",
     "case.toml:41:13: expect 1: a relative tolerance means nothing for value = 0; give \"absolute\""},
    {"ExactWithoutRate", "tolerance = 0.05", "tolerance = 0.05\nexact = 1",
     "case.toml:42:9: expect 1: \"exact\" belongs to rate only"},
    {"WithUnknownKey", "tolerance = 0.05",
     "tolerance = 0.05\nwith = { \"parameters.n\" = 8 }\n[study]\nvary = { \"parameters.omega\" = [1, 2] }",
     "case.toml:42:8: expect 1: with: unknown key \"parameters.n\". Known keys: parameters.omega."},
    {"VaryEmpty", "[[expect]]", "[study]\nvary = {}\n[[expect]]",
     "case.toml:39:8: [study]: vary must not be empty; for example { \"parameters.n\" = [4, 8] }"},
    {"VaryNothing", "[[expect]]", "[study]\nvary = { \"parameters.n\" = [] }\n[[expect]]",
     "case.toml:39:27: [study]: vary: parameters.n: at least one value is needed"},
    {"VaryUnknownParameter", "[[expect]]", "[study]\nvary = { \"parameters.m\" = [4, 8] }\n[[expect]]",
     "case.toml:39:10: [study]: vary: unknown parameter \"m\". Did you mean \"n\"? Known parameters: n, omega."},
    {"UnknownTier", "tolerance = 0.05", "tolerance = 0.05\ntier = \"slow\"",
     "case.toml:42:8: expect 1: tier: unknown name \"slow\". Known names: quick, full."},
};
SINEW_WRONG_CASES(WrongOutputs, wrong_outputs);

}  // namespace sinew
