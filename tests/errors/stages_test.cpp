/// [[stage]] and [study] safety.

#include "errors/wrong_case.hpp"

namespace sinew {

static const std::string end = "end_time = 0.5\n[output]\nevery = \"end_time/50\"\n";
static const std::string stages = "[[stage]]\nname = \"a\"\nduration = 0.2\n[[stage]]\nname = \"b\"\nduration = 0.3\n";

/// The good case in stages, with more in the last of them.
static std::string in_stages(const std::string& more) { return stages + more + "[output]\n"; }

static const std::vector<WrongCase> wrong_stages{
    {"EndTimeToo", "[output]\nevery", in_stages("") + "every",
     "case.toml:30:12: [solver]: with [[stage]] the run ends with the last stage; leave end_time out"},
    {"NoDuration", end, "[[stage]]\nname = \"a\"\n[output]\n",
     "case.toml:30:1: stage 1: \"duration\" is missing. How long it lasts, at most."},
    {"OtherSection", end, in_stages("contact = 3\n"),
     "case.toml:36:1: stage 2: unknown key \"contact\". Known keys: material, formulation, boundary, body_force, solver, name, "
     "duration, residual, settle."},
    {"SameName", end, "[[stage]]\nname = \"a\"\nduration = 1\n[[stage]]\nname = \"a\"\nduration = 1\n[output]\n",
     "case.toml:33:1: the name \"a\" of a stage is already taken; choose another"},
    {"WrongInside", end, in_stages("solver = { cfl = 2 }\n"),
     "case.toml:36:18: [solver]: cfl must be greater than 0 and at most 1, found 2"},
    {"ResidualWithoutWeight", end, in_stages("residual = 0.1\n"),
     "case.toml:33:1: stage \"b\": residual is a part of the weight, and there is no constant [body_force]"},
    {"SettledRubber", end, in_stages("settle = true\n"),
     "case.toml:33:1: stage \"b\": settle keeps the stress of particles that go back, which body \"column\" cannot: only "
     "materials "
     "that are written in rates (hypoelastic, drucker_prager, mu_i_rheology), without damage, do not need the deformation for "
     "it"},
    {"UnknownMaterial", end, in_stages("[stage.material.rubbr]\ndensity = 1\n"),
     "case.toml:36:17: stage 2: unknown [material.NAME] \"rubbr\". Did you mean \"rubber\"?..."},
    {"OtherMaterial", end,
     in_stages("[stage.material.rubber]\nmodel = \"linear_elastic\"\ndensity = 1\nyoungs_modulus = 1\npoissons_ratio = 0.3\n"),
     "case.toml:33:1: stage \"b\": the material of body \"column\" changes its model; stages may change its parameters only"},
    {"SafetyProbe", "[[expect]]", "[study]\nvary = { \"parameters.n\" = [4, 5] }\nsafety = { probe = \"tap\" }\n[[expect]]",
     "case.toml:40:20: [study]: safety: unknown probe \"tap\". Did you mean \"tip\"? Known probes: tip."},
    {"SafetyOfTwo", "[[expect]]",
     "[study]\nvary = { \"parameters.n\" = [4, 5], \"parameters.omega\" = [1] }\nsafety = { probe = \"tip\" }\n[[expect]]",
     "case.toml:40:10: [study]: safety: vary must have one key, the factor that reduces the strength"},
    {"SafetyWithoutStudy", "probe.tip.min", "safety_factor",
     "case.toml:39:12: expect 1: safety_factor needs a [study] with safety = { probe = ... }"},
};
SINEW_WRONG_CASES(WrongStages, wrong_stages);

}  // namespace sinew
