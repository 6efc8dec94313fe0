#pragma once
/// One good case and what becomes of it: each wrong case is the good one with a piece of text replaced.

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <sinew/io/read_toml.hpp>
#include <sinew/model/case.hpp>
#include <string>

namespace sinew {

inline const std::string good_case = R"([case]
name = "column"
dimension = 3
[parameters]
n = 6
omega = 105.0
[[body]]
name = "column"
geometry = { shape = "box", low = [0, 0, 0], high = [1, 1, 6], spacing = "1/n" }
material = "rubber"
[material.rubber]
model = "neo_hookean"
density = 1100.0
youngs_modulus = "17 MPa"
poissons_ratio = 0.45
[formulation]
kernel = "cubic_spline"
support = 2.4
stabilization = [ { model = "hourglass_stiffness", alpha = 50.0 } ]
[region]
foot = { body = "column", where = "Z < 1/n" }
[[initial]]
region = "column"
velocity = ["-y*omega", "x*omega", 0]
[[boundary]]
region = "foot"
velocity = [0, 0, 0]
[solver]
cfl = 0.3
end_time = 0.5
[output]
every = "end_time/50"
fields = ["velocity"]
[[probe]]
name = "tip"
quantity = "displacement"
component = "z"
[[expect]]
quantity = "probe.tip.min"
value = -0.1
tolerance = 0.05
)";

/// The good case with the first `text` replaced by `replacement`. A message that ends with "..." leaves open how the
/// real one goes on, since lists of names grow.
struct WrongCase {
  std::string name, text, replacement, message;
  friend std::ostream& operator<<(std::ostream& out, const WrongCase& wrong) { return out << wrong.name; }
};

inline std::string error_of(const std::string& text) {
  try {
    make_case(read_toml_text(text, "case.toml"), "");
  } catch (const CaseError& error) {
    return error.what();
  }
  return "no error";
}

inline void expect_same_message(std::string message, std::string expected) {
  if (expected.ends_with("...")) {
    expected.resize(expected.size() - 3);
    message.resize(std::min(message.size(), expected.size()));
  }
  EXPECT_EQ(message, expected);
}

inline void expect_message(const WrongCase& wrong) {
  std::string text = good_case;
  const std::size_t at = text.find(wrong.text);
  ASSERT_NE(at, std::string::npos) << "the good case does not contain: " << wrong.text;
  text.replace(at, wrong.text.size(), wrong.replacement);
  expect_same_message(error_of(text), wrong.message);
}

/// Defines the test suite `suite`, one test for each row of `rows`.
#define SINEW_WRONG_CASES(suite, rows)                               \
  class suite : public ::testing::TestWithParam<WrongCase> {};       \
  TEST_P(suite, HasItsMessage) { expect_message(GetParam()); }       \
  INSTANTIATE_TEST_SUITE_P(Errors, suite, ::testing::ValuesIn(rows), \
                           [](const ::testing::TestParamInfo<WrongCase>& row) { return row.param.name; })

}  // namespace sinew
