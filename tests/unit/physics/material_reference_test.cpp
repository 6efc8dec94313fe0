#include <unit/physics/material_support.hpp>
#include <unit/physics/random_states.hpp>

namespace sinew {
namespace {

using namespace testing_support;

/// What a material gives at one deformation gradient, computed apart from this program, for lambda = 1.2 and mu = 0.8.
struct Numbers {
  double energy;
  Mat3<double> P;
  std::array<double, 5> tangent;  ///< A_00, A_04, A_13, A_57 and the trace
  double tolerance;
};

template <class Material>
void expect_numbers(const Numbers& expected) {
  const Mat3<double> F{{{1.1, 0.2, 0.0}, {-0.1, 0.9, 0.05}, {0.03, 0.0, 1.05}}};
  const Material material = with_lame<Material>(1.2, 0.8);
  const auto r = material.respond(F);
  const Tangent<double> A = material.tangent(F);
  EXPECT_NEAR(determinant(F), 1.0608, 1e-14);
  EXPECT_NEAR(r.energy, expected.energy, expected.tolerance);
  EXPECT_LT(distance(r.P, expected.P), expected.tolerance);
  EXPECT_NEAR(A[0][0], expected.tangent[0], expected.tolerance);
  EXPECT_NEAR(A[0][4], expected.tangent[1], expected.tolerance);
  EXPECT_NEAR(A[1][3], expected.tangent[2], expected.tolerance);
  EXPECT_NEAR(A[5][7], expected.tangent[3], expected.tolerance);
  EXPECT_NEAR(trace(A), expected.tangent[4], expected.tolerance);
}

TEST(MaterialNumbers, LinearElastic) {
  expect_numbers<LinearElastic>(
      {0.02486, {{{0.22, 0.08, 0.024}, {0.08, -0.1, 0.04}, {0.024, 0.04, 0.14}}}, {2.8, 1.2, 0.8, 0.8, 13.2}, 1e-14});
}

TEST(MaterialNumbers, StVenantKirchhoff) {
  expect_numbers<StVenantKirchhoff>(
      {0.0289563835,
       {{{0.331286, 0.111508, 0.03052}, {0.066434, -0.021614, 0.039757}, {0.0307278, 0.04092, 0.199653}}},
       {3.70226, 1.172, 0.768, 0.756, 15.34598},
       5.1e-7});
}

TEST(MaterialNumbers, NeoHookean) {
  expect_numbers<NeoHookean>({0.0252315805,
                              {{{0.2304265348, 0.0867941015, 0.0185592419},
                                {0.0643496589, -0.0739231242, 0.0358757240},
                                {0.0171262067, 0.0378058631, 0.1457468784}}},
                              {2.3309730399, 1.1494409762, 0.6834064655, 0.7555515199, 12.8685257204},
                              6e-11});
}

TEST(MaterialNumbers, NeoHookeanIsochoric) {
  expect_numbers<NeoHookeanIsochoric>({0.0245471922,
                                       {{{0.2202904254, 0.0833048435, 0.0178787134},
                                         {0.0621434419, -0.0725926691, 0.0344835613},
                                         {0.0164522196, 0.0364196013, 0.1387924696}}},
                                       {2.3890649493, 1.4876483097, 0.6549955157, 0.7287513198, 13.5643395867},
                                       6e-11});
}

/// Simple shear by g: shear stress mu g for both neo-Hookean solids, and no change of volume.
TEST(MaterialNumbers, SimpleShear) {
  const Mat3<double> F{{{1, 0.7, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_NEAR((with_lame<NeoHookean>(1.2, 0.8).respond(F).P[0][1]), 0.8 * 0.7, 1e-14);
  EXPECT_NEAR((with_lame<NeoHookeanIsochoric>(1.2, 0.8).respond(F).P[0][1]), 0.8 * 0.7, 1e-14);
}

/// Uniaxial tension of 1 MPa on a bar of length 8 m and section 6 m^2, E = 30 GPa: extension 2.66667e-4 m, energy 800 J.
TEST(MaterialNumbers, BarInTension) {
  LinearElastic bar;
  bar.elastic.youngs_modulus = 30e9;
  bar.elastic.poissons_ratio = 0.3;
  ASSERT_EQ(bar.elastic.complete(), std::nullopt);
  const double strain = 1e6 / 30e9;
  EXPECT_NEAR(8.0 * strain, 2.66667e-4, 5e-10);
  Mat3<double> F = (1.0 - 0.3 * strain) * Mat3<double>::identity();
  F[0][0] = 1.0 + strain;
  const auto r = bar.respond(F);
  EXPECT_NEAR(r.P[0][0], 1e6, 1e-4);
  EXPECT_NEAR(r.P[1][1], 0.0, 1e-4);
  EXPECT_NEAR(48.0 * r.energy, 800.0, 1e-9);
}

/// The Hessian of the determinant against dual numbers of the cofactor matrix.
TEST(Tangents, HessianOfTheDeterminant) {
  std::mt19937_64 random(2);
  const Mat3<double> F = random_gradient(random);
  const Tangent<double> hessian = determinant_hessian(F);
  for (int column = 0; column < 9; ++column) {
    Mat3<Dual<double>> seeded = as<Dual<double>>(F);
    seeded[column / 3][column % 3].slope = 1.0;
    const auto H = cofactor(seeded);
    for (int row = 0; row < 9; ++row) EXPECT_NEAR(hessian[row][column], H[row / 3][row % 3].slope, 1e-15);
  }
}

}  // namespace
}  // namespace sinew
