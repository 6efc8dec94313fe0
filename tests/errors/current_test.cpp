/// [formulation] model = "updated_lagrangian" with what it does not know, and materials written in rates.

#include "errors/wrong_case.hpp"

namespace sinew {

static const std::string current = "[formulation]\nmodel = \"updated_lagrangian\"\nkernel = \"cubic_spline\"\nsupport = 2.4\n";
static const std::string original =
    "[formulation]\nkernel = \"cubic_spline\"\nsupport = 2.4\nstabilization = [ { model = \"hourglass_stiffness\", alpha = 50.0 "
    "} ]\n";

static const std::vector<WrongCase> wrong_on_current{
    {"StiffnessOnCurrent", original, current + "stabilization = [ { model = \"hourglass_stiffness\", alpha = 50.0 } ]\n",
     "case.toml:20:17: [formulation]: stabilization \"hourglass_stiffness\" does not go with model = \"updated_lagrangian\""},
    {"PressureOnReference", "{ model = \"hourglass_stiffness\", alpha = 50.0 }", "{ model = \"artificial_pressure\" }",
     "case.toml:19:17: [formulation]: stabilization \"artificial_pressure\" does not go with model = \"total_lagrangian\""},
    {"TwoRepulsions", original,
     current + "stabilization = [ { model = \"artificial_pressure\" }, { model = \"artificial_stress\" } ]\n",
     "case.toml:20:17: [formulation]: artificial_pressure and artificial_stress are two forms of one repulsion; give only one of "
     "them"},
    {"TwoStiffnesses", "{ model = \"hourglass_stiffness\", alpha = 50.0 }",
     "{ model = \"hourglass_stiffness\" }, { model = \"non_nested_shear\" }",
     "case.toml:19:17: [formulation]: hourglass_stiffness, hourglass_energy and non_nested_shear are forms of one stiffness; "
     "give only one of "
     "them"},
    {"PrintedOnReference", "{ model = \"hourglass_stiffness\", alpha = 50.0 }",
     "{ model = \"non_nested_shear\", form = \"printed\" }",
     "case.toml:19:17: [formulation]: non_nested_shear has form = \"printed\" with model = \"updated_lagrangian\" only"},
    {"NeighborsOnCurrent", original, "[formulation]\nmodel = \"updated_lagrangian\"\nneighbors = 12\n",
     "case.toml:18:13: [formulation]: \"updated_lagrangian\" needs the same kernel radius for all particles; use \"support\""},
    {"BondsOnCurrent", original, current + "deformation_gradient = \"bond\"\nmomentum = \"adjoint\"\n",
     "case.toml:20:24: [formulation]: \"updated_lagrangian\" integrates the deformation gradient in time by itself; leave this "
     "out"},
    {"LinearOnCurrent", original, current + "correction = \"linear\"\n",
     "case.toml:20:14: [formulation]: \"updated_lagrangian\" knows the corrections \"none\" and \"gradient\""},
    {"WallOnReference", "velocity = [0, 0, 0]", "wall = \"no_slip\"",
     "case.toml:27:8: boundary 1: walls of particles belong to model = \"updated_lagrangian\"; with \"total_lagrangian\" "
     "prescribe "
     "the displacement, or its normal component, of particles of the body"},
    {"UnknownWall", "velocity = [0, 0, 0]", "wall = \"noslip\"",
     "case.toml:27:8: boundary 1: wall: unknown name \"noslip\". Did you mean \"no_slip\"?..."},
    {"SmoothWallWithoutNormal", "velocity = [0, 0, 0]", "wall = \"free_slip\"",
     "case.toml:27:8: boundary 1: free_slip needs the normal of the wall, normal = [...]"},
    {"RoughWallWithNormal", "velocity = [0, 0, 0]", "wall = \"no_slip\"\nnormal = [0, 0, 1]",
     "case.toml:28:10: boundary 1: a wall with no_slip has no normal"},
    {"UpdateOnCurrent", original, current + "reference_update = { threshold = 2 }\n",
     "case.toml:20:20: [formulation]: reference_update belongs to model = \"total_lagrangian\"; \"updated_lagrangian\" has no "
     "reference"},
    {"UpdateThreshold", original, original + "reference_update = { threshold = 0 }\n",
     "case.toml:20:34: [formulation]: reference_update: threshold must be greater than 0, found 0"},
    {"UpdateIsATable", original, original + "reference_update = 2\n",
     "case.toml:20:20: [formulation]: reference_update: expected a table such as { threshold = 2 }, found an integer"},
    {"UpdateOfBonds", original, original + "deformation_gradient = \"bond\"\nreference_update = {}\n",
     "case.toml:21:20: [formulation]: reference_update goes with deformation_gradient = \"direct\""},
    {"UpdateWithJst", "{ model = \"hourglass_stiffness\", alpha = 50.0 } ]", "{ model = \"jst\" } ]\nreference_update = {}",
     "case.toml:20:20: [formulation]: reference_update does not go with stabilization \"jst\""},
    {"FrictionAngle", "model = \"neo_hookean\"", "model = \"drucker_prager\"\nfriction_angle = 95\ncohesion = 0",
     "case.toml:13:18: material \"rubber\": friction_angle must be from 0 to below 90 (degrees), found 95"},
};
SINEW_WRONG_CASES(WrongOnCurrent, wrong_on_current);

/// The good case on the current configuration with one more piece replaced.
static std::string error_on_current(const std::string& text, const std::string& replacement) {
  std::string all = good_case;
  all.replace(all.find(original), original.size(), current);
  all.replace(all.find(text), text.size(), replacement);
  return error_of(all);
}

TEST(WrongOnCurrent, NoStages) {
  EXPECT_EQ(error_on_current("cfl = 0.3", "integrator = \"rk3\""),
            "case.toml:29:14: [solver]: \"updated_lagrangian\" goes with integrator \"velocity_verlet\"");
}
TEST(WrongOnCurrent, NoContact) {
  EXPECT_EQ(error_on_current("[solver]", "[[contact]]\nmodel = \"hertz\"\n[solver]"),
            "case.toml:28:1: [[contact]]: with \"updated_lagrangian\" bodies touch as neighbors of each other; leave this out");
}
TEST(WrongOnCurrent, NoHourglassError) {
  EXPECT_EQ(
      error_on_current("fields = [\"velocity\"]", "fields = [\"hourglass_error\"]"),
      "case.toml:33:10: [output]: fields: hourglass_error does not exist with \"updated_lagrangian\", whose deformation gradient "
      "is not one of displacements");
}

}  // namespace sinew
