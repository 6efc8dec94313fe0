#include <unit/physics/material_support.hpp>
#include <unit/physics/random_states.hpp>

namespace sinew {
namespace {

using namespace testing_support;

template <class Material>
class MaterialContract : public ::testing::Test {
 protected:
  Material material = with_lame<Material>(1.2, 0.8);
  std::mt19937_64 random{17};
  static constexpr bool small_strain = std::is_same_v<Material, LinearElastic>;
};
TYPED_TEST_SUITE(MaterialContract, MaterialTypes, MaterialNames);

TYPED_TEST(MaterialContract, ReferenceIsFreeOfStressAndEnergy) {
  const auto r = this->material.respond(Mat3<double>::identity());
  EXPECT_LT(distance(r.P, Mat3<double>{}), 1e-15);
  EXPECT_NEAR(r.energy, 0.0, 1e-15);
}

TYPED_TEST(MaterialContract, StressTurnsWithTheBody) {
  double worst = 0.0;
  for (int trial = 0; trial < 100; ++trial) {
    const Mat3<double> F = random_gradient(this->random), Q = random_rotation(this->random);
    worst = std::max(worst, distance(this->material.respond(Q * F).P, Q * this->material.respond(F).P));
  }
  if (this->small_strain)
    EXPECT_GT(worst, 0.1) << "small-strain elasticity must not pass this test";
  else
    EXPECT_LT(worst, 1e-12);
}

TYPED_TEST(MaterialContract, KirchhoffStressIsSymmetric) {
  double worst = 0.0;
  for (int trial = 0; trial < 100; ++trial) {
    const Mat3<double> F = random_gradient(this->random);
    const Mat3<double> tau = this->material.respond(F).P * transpose(F);
    worst = std::max(worst, distance(tau, transpose(tau)));
  }
  if (this->small_strain)
    EXPECT_GT(worst, 0.1) << "small-strain elasticity must not pass this test";
  else
    EXPECT_LT(worst, 1e-12);
}

TYPED_TEST(MaterialContract, StressIsTheDerivativeOfTheEnergy) {
  for (int trial = 0; trial < 50; ++trial) {
    const Mat3<double> F = random_gradient(this->random);
    const Mat3<double> P = this->material.respond(F).P;
    for (int k = 0; k < 9; ++k) {
      Mat3<Dual<double>> seeded = as<Dual<double>>(F);
      seeded[k / 3][k % 3].slope = 1.0;
      EXPECT_NEAR(this->material.respond(seeded).energy.slope, P[k / 3][k % 3], 1e-11 * (1.0 + std::abs(P[k / 3][k % 3])));
    }
  }
}

TYPED_TEST(MaterialContract, TangentIsTheDerivativeOfTheStress) {
  const double step = 1e-5;
  for (int trial = 0; trial < 50; ++trial) {
    const Mat3<double> F = random_gradient(this->random);
    const Tangent<double> A = this->material.tangent(F);
    const double scale = std::sqrt(double_dot(A, A));
    EXPECT_LT(distance(A, dual_tangent(this->material, F)), 1e-12 * scale);
    EXPECT_LT(distance(A, transpose(A)), 1e-12 * scale);
    for (int column = 0; column < 9; ++column) {
      Mat3<double> more = F, less = F;
      more[column / 3][column % 3] += step;
      less[column / 3][column % 3] -= step;
      const Mat3<double> slope = (0.5 / step) * (this->material.respond(more).P - this->material.respond(less).P);
      for (int row = 0; row < 9; ++row) EXPECT_NEAR(A[row][column], slope[row / 3][row % 3], 1e-7 * scale);
    }
  }
}

TYPED_TEST(MaterialContract, ObeysHookesLawAtSmallStrain) {
  const LinearElastic hooke = with_lame<LinearElastic>(1.2, 0.8);
  const Mat3<double> I = Mat3<double>::identity();
  EXPECT_LT(distance(this->material.tangent(I), hooke.tangent(I)), 1e-14);
  const Mat3<double> F = I + 1e-6 * Mat3<double>{{{1, 2, -1}, {0.5, -2, 1}, {0, 1, 3}}};
  EXPECT_LT(distance(this->material.respond(F).P, hooke.respond(F).P), 1e-10);
}

TYPED_TEST(MaterialContract, PackGivesTheValuesOfItsLanes) {
  Mat3<Pack> packed;
  Mat3<Dual<Pack>> seeded;
  std::array<Mat3<double>, lanes> F;
  for (int lane = 0; lane < lanes; ++lane) {
    F[lane] = random_gradient(this->random);
    for (int k = 0; k < 9; ++k) packed[k / 3][k % 3].set(lane, F[lane][k / 3][k % 3]);
  }
  for (int k = 0; k < 9; ++k) seeded[k / 3][k % 3] = Dual<Pack>(packed[k / 3][k % 3], Pack(k == 1 ? 1.0 : 0.0));
  const auto r = this->material.respond(packed);
  const auto derivative = this->material.respond(seeded);
  const Pack stiffness = acoustic_stiffness(this->material, packed);
  for (int lane = 0; lane < lanes; ++lane) {
    const auto single = this->material.respond(F[lane]);
    const auto tangent = this->material.tangent(F[lane]);
    EXPECT_NEAR(r.energy[lane], single.energy, 1e-13 * (1.0 + single.energy));
    EXPECT_NEAR(stiffness[lane], acoustic_stiffness(this->material, F[lane]), 1e-12 * stiffness[lane]);
    for (int k = 0; k < 9; ++k) {
      EXPECT_NEAR(r.P[k / 3][k % 3][lane], single.P[k / 3][k % 3], 1e-12);
      EXPECT_NEAR(derivative.P[k / 3][k % 3].slope[lane], tangent[k][1], 1e-11);
    }
  }
}

TYPED_TEST(MaterialContract, SaysWhatItIs) {
  EXPECT_FALSE(TypeParam::name.empty() || TypeParam::summary.empty() || TypeParam::source.empty());
}

TEST(Materials, NamesAreTheAgreedOnes) {
  EXPECT_EQ(Materials::names(), (std::vector<std::string>{"linear_elastic", "st_venant_kirchhoff", "neo_hookean",
                                                          "neo_hookean_isochoric", "j2_plastic", "j2_voce", "johnson_cook",
                                                          "hypoelastic", "drucker_prager", "mu_i_rheology", "rigid"}));
}

}  // namespace
}  // namespace sinew
