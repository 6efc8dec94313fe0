/// Files that are no TOML, and overrides that are wrong.

#include "errors/wrong_case.hpp"

namespace sinew {

static const std::vector<WrongCase> wrong_toml{
    {"ValueMissing", "cfl = 0.3", "cfl =", "case.toml:29:6: not valid TOML: expected value, saw the end of the line"},
    {"QuoteMissing", "\"rubber\"", "\"rubber",
     "case.toml:10:19: not valid TOML: the closing quote of a string is missing on this line"},
    {"WordWithoutQuotes", "\"rubber\"", "rubber",
     "case.toml:10:12: not valid TOML: this is no value; text needs quotes around it"},
    {"BracketMissing", "velocity = [0, 0, 0]", "velocity = [0, 0, 0",
     "case.toml:28:1: not valid TOML: expected comma or closing ']', saw '['"},
    {"EqualSignMissing", "cfl = 0.3", "cfl 0.3", "case.toml:29:5: not valid TOML: expected '=', saw '0'"},
    {"KeyTwice", "cfl = 0.3", "cfl = 0.3\ncfl = 0.2",
     "case.toml:30:7: not valid TOML: cannot redefine existing floating-point 'cfl'"},
    {"TableTwice", "[output]", "[solver]", "case.toml:31:1: not valid TOML: cannot redefine existing table 'solver'"},
    {"Date", "cfl = 0.3", "cfl = 2024-01-01", "case.toml:29:7: dates and times are not used in a case; put the value in quotes"},
};
SINEW_WRONG_CASES(WrongToml, wrong_toml);

TEST(WrongToml, FileMissing) {
  try {
    read_toml_file("nowhere/case.toml");
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_STREQ(error.what(), "cannot open the case file \"nowhere/case.toml\": there is no such file");
  }
}

static std::string error_of_override(const std::string& path, const std::string& value) {
  try {
    Node root = read_toml_text(good_case, "case.toml");
    override_value(root, path, read_toml_value(value, Place{"--set " + path + "=" + value}));
    make_case(root, "");
  } catch (const CaseError& error) {
    return error.what();
  }
  return "no error";
}

TEST(WrongOverride, HasItsMessage) {
  EXPECT_EQ(error_of_override("parameters.m", "16"),
            "--set parameters.m=16: unknown parameter \"m\". Did you mean \"n\"? Known parameters: n, omega.");
  EXPECT_EQ(
      error_of_override("solver.clf", "0.1"),
      "--set solver.clf=0.1: [solver]: unknown key \"clf\". Did you mean \"cfl\"? Known keys: mode, integrator, cfl, wave_speed, "
      "end_time, max_steps, time_step, damping, pair_weights, lattice, block_size, ramp, longest_step, tolerance, "
      "most_iterations, linear_solver, petsc, numerical_damping, step_error.");
  EXPECT_EQ(error_of_override("solvers.cfl", "0.1"),
            "--set solvers.cfl=0.1: unknown key \"solvers\". Did you mean \"solver\"? Known keys: case, parameters, body, "
            "material, formulation, region, initial, boundary, body_force, contact, wall, solver, stage, output, probe, expect, "
            "study.");
  EXPECT_EQ(error_of_override("solver.cfl", "2"),
            "--set solver.cfl=2: [solver]: cfl must be greater than 0 and at most 1, found 2");
  EXPECT_EQ(error_of_override("solver.cfl.x", "2"),
            "--set solver.cfl.x=2: \"solver.cfl\" is a number and has nothing inside, so there is no \"solver.cfl.x\"");
  EXPECT_EQ(error_of_override("body.1.material", "rubber"),
            "--set body.1.material=rubber: \"body\" has no entry 1; it has 1, counted from 0");
  EXPECT_EQ(error_of_override("body.colum.material", "rubber"),
            "--set body.colum.material=rubber: \"body\": unknown name \"colum\". Did you mean \"column\"? Known names: column.");
  EXPECT_EQ(error_of_override("body..material", "rubber"),
            "--set body..material=rubber: \"body..material\" is not a key path; it looks like parameters.n or body.0.material");
  EXPECT_EQ(error_of_override("body.column.geometry.low", "[0, 0"),
            "--set body.column.geometry.low=[0, 0: [0, 0 is not a valid TOML value");
  expect_same_message(error_of_override("formulation.kernel", "spikey"),
                      "--set formulation.kernel=spikey: [formulation]: kernel: unknown kernel \"spikey\". Did you mean "
                      "\"spiky\"? Known kernels: ...");
}

}  // namespace sinew
