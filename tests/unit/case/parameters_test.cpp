#include <gtest/gtest.h>

#include <sinew/io/read_toml.hpp>
#include <sinew/model/parameters.hpp>

namespace sinew {
namespace {

Constants parameters(const std::string& text, const Reading& reading = {}) {
  return evaluate_parameters(read_toml_text(text, "case.toml"), reading);
}

TEST(Parameters, MayBeDefinedInAnyOrder) {
  const Constants values = parameters("c = \"a+b\"\nb = \"2*a\"\na = 3\n");
  EXPECT_EQ(values.at("a"), 3.0);
  EXPECT_EQ(values.at("b"), 6.0);
  EXPECT_EQ(values.at("c"), 9.0);
}

TEST(Parameters, MayHaveUnits) {
  Reading reading;
  reading.units = {"mm", "kg", "ms", 1e-3, 1.0, 1e-3};
  const Constants values = parameters("m = 2\nE = \"100 GPa\"\nv = \"1 m/s\"\nlength = \"2 m\"\n", reading);
  EXPECT_DOUBLE_EQ(values.at("E"), 100.0);
  EXPECT_EQ(values.at("v"), 1.0);
  EXPECT_DOUBLE_EQ(values.at("length"), 2000.0);  // "2 m" is meters even where a parameter m exists
}

}  // namespace
}  // namespace sinew
