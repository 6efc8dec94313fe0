/// Probes against formulas over the particles.

#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

/// The error of a field that is known: zero against itself, and the norm of what was added, over uneven volumes.
TEST(Probes, ErrorAgainstAFormula) {
  const std::string more =
      "[[probe]]\nname = \"none\"\nquantity = \"velocity\"\ncomponent = \"x\"\nexact = \"3*sin(2*Y) + t\"\nreduce = \"rms\"\n"
      "[[probe]]\nname = \"shift\"\nquantity = \"velocity\"\ncomponent = \"x\"\nexact = \"3*sin(2*Y) - 0.25\"\nreduce = \"rms\"\n"
      "[[probe]]\nname = \"mean\"\nquantity = \"velocity\"\ncomponent = \"x\"\nexact = \"3*sin(2*Y) - 0.25\"\n"
      "[[probe]]\nname = \"slope\"\nquantity = \"velocity\"\ncomponent = \"x\"\nexact = \"3*sin(2*Y) - X\"\nreduce = \"rms\"\n";
  const auto simulation = simulation_of(free_block(2, more));
  const std::vector<double> probes = simulation->probe_values();
  EXPECT_NEAR(probes[0], 0.0, 1e-15);
  EXPECT_NEAR(probes[1], 0.25, 1e-14);
  EXPECT_NEAR(probes[2], 0.25, 1e-14);
  EXPECT_NEAR(probes[3], std::sqrt(4.0 / 3.0), 5e-3) << "root of the mean of X^2 over [0, 2], on disturbed particles";
}

TEST(Probes, TotalsHaveNoFormula) {
  try {
    simulation_of(free_block(2, "[[probe]]\nname = \"energy\"\nquantity = \"energy.total\"\nexact = \"1\"\n"));
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("energy.total is one number already"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sinew
