#include <sinew/materials/plane_stress.hpp>
#include <unit/physics/material_support.hpp>
#include <unit/physics/random_states.hpp>

namespace sinew {
namespace {

using namespace testing_support;

template <class Material>
class PlaneStressContract : public ::testing::Test {
 protected:
  PlaneStress<Material> material{with_lame<Material>(1.2, 0.8)};
  std::mt19937_64 random{31};
  /// A random deformation in the plane, with an F33 that has to be ignored.
  Mat3<double> plane_gradient() { return embed(random_matrix<2>(random, 0.4, 0.4), -7.0); }
};
TYPED_TEST_SUITE(PlaneStressContract, MaterialTypes, MaterialNames);

TYPED_TEST(PlaneStressContract, StressThroughTheThicknessVanishes) {
  for (int trial = 0; trial < 200; ++trial) {
    const Mat3<double> F = this->plane_gradient();
    EXPECT_NEAR(this->material.respond(F).P[2][2], 0.0, 1e-14);
    EXPECT_GT(this->material.thickness_stretch(F), 0.0);
  }
}

TYPED_TEST(PlaneStressContract, StressIsTheDerivativeOfTheEnergy) {
  const double step = 1e-5;
  for (int trial = 0; trial < 20; ++trial) {
    const Mat3<double> F = this->plane_gradient();
    const Mat3<double> P = this->material.respond(F).P;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        Mat3<double> more = F, less = F;
        more[i][j] += step;
        less[i][j] -= step;
        const double slope = (this->material.respond(more).energy - this->material.respond(less).energy) / (2.0 * step);
        EXPECT_NEAR(P[i][j], slope, 1e-8);
      }
  }
}

TYPED_TEST(PlaneStressContract, TangentIsTheDerivativeOfTheStress) {
  for (int trial = 0; trial < 20; ++trial) {
    const Mat3<double> F = this->plane_gradient();
    const Tangent<double> A = this->material.tangent(F), dual = dual_tangent(this->material, F);
    for (const int row : {0, 1, 3, 4})
      for (const int column : {0, 1, 3, 4}) EXPECT_NEAR(A[row][column], dual[row][column], 1e-10);
  }
}

/// In the reference the tangent is that of Hooke's law with the plane-stress constant lambda* = 2 lambda mu / (lambda + 2 mu).
TYPED_TEST(PlaneStressContract, ObeysHookesLawForPlaneStress) {
  const Tangent<double> A = this->material.tangent(Mat3<double>::identity());
  const double reduced = 2.0 * 1.2 * 0.8 / (1.2 + 1.6);
  EXPECT_NEAR(A[0][0], reduced + 1.6, 1e-13);
  EXPECT_NEAR(A[0][4], reduced, 1e-13);
  EXPECT_NEAR(A[1][3], 0.8, 1e-13);
  EXPECT_EQ(A[8][8], 0.0);
}

TYPED_TEST(PlaneStressContract, PackGivesTheValuesOfItsLanes) {
  Mat3<Pack> packed;
  std::array<Mat3<double>, lanes> F;
  for (int lane = 0; lane < lanes; ++lane) {
    F[lane] = this->plane_gradient();
    if (lane == 2) F[lane] = Mat3<double>::identity();
    for (int k = 0; k < 9; ++k) packed[k / 3][k % 3].set(lane, F[lane][k / 3][k % 3]);
  }
  const Pack stretch = this->material.thickness_stretch(packed);
  const Pack stiffness = this->material.acoustic_stiffness(packed);
  const auto P = this->material.respond(packed).P;
  for (int lane = 0; lane < lanes; ++lane) {
    EXPECT_NEAR(stretch[lane], this->material.thickness_stretch(F[lane]), 1e-14);
    EXPECT_NEAR(stiffness[lane], this->material.acoustic_stiffness(F[lane]), 1e-12 * stiffness[lane]);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(P[k / 2][k % 2][lane], this->material.respond(F[lane]).P[k / 2][k % 2], 1e-13);
  }
}

/// A lane of a pack moves the same way whatever its neighbors are.
TYPED_TEST(PlaneStressContract, LanesDoNotDependOnOneAnother) {
  for (int trial = 0; trial < 300; ++trial) {
    const Mat3<double> F = this->plane_gradient(), other = this->plane_gradient();
    const Mat3<Pack> alone = as<Pack>(F);
    Mat3<Pack> mixed = as<Pack>(other);
    for (int k = 0; k < 9; ++k) mixed[k / 3][k % 3].set(0, F[k / 3][k % 3]);
    EXPECT_EQ(this->material.thickness_stretch(alone)[0], this->material.thickness_stretch(mixed)[0]);
  }
}

TYPED_TEST(PlaneStressContract, IsFoundForExtremeStretchesOfTheSheet) {
  const bool softens = std::is_same_v<TypeParam, StVenantKirchhoff> || std::is_same_v<TypeParam, LinearElastic>;
  for (const double sheet : {0.5, 0.8, softens ? 1.2 : 5.0}) {
    const Mat3<double> F{{{sheet, 0, 0}, {0, sheet, 0}, {0, 0, 1}}};
    EXPECT_NEAR(this->material.respond(F).P[2][2], 0.0, 1e-13) << sheet;
  }
}

/// A strip pulled along x with free sides: the linear solid gives E e along x and the thickness 1 - nu e.
TEST(PlaneStress, UniaxialClosedForm) {
  PlaneStress<LinearElastic> strip;
  strip.elastic.youngs_modulus = 30.0;
  strip.elastic.poissons_ratio = 0.3;
  ASSERT_EQ(strip.elastic.complete(), std::nullopt);
  const double e = 0.02;
  const Mat3<double> F{{{1 + e, 0, 0}, {0, 1 - 0.3 * e, 0}, {0, 0, 1}}};
  EXPECT_NEAR(strip.thickness_stretch(F), 1 - 0.3 * e, 1e-15);
  const auto r = strip.respond(F);
  EXPECT_NEAR(r.P[0][0], 30.0 * e, 1e-14);
  EXPECT_NEAR(r.P[1][1], 0.0, 1e-14);
  EXPECT_NEAR(r.energy, 0.5 * 30.0 * e * e, 1e-15);
}

/// St. Venant-Kirchhoff: S33 = 0 is linear in the square of the thickness.
TEST(PlaneStress, ThicknessOfStVenantKirchhoff) {
  const PlaneStress<StVenantKirchhoff> sheet{with_lame<StVenantKirchhoff>(1.2, 0.8)};
  const Mat3<double> F{{{1.2, 0.1, 0}, {-0.2, 0.9, 0}, {0, 0, 1}}};
  const double in_plane_growth = 1.44 + 0.01 + 0.04 + 0.81 - 2.0;
  EXPECT_NEAR(sheet.thickness_stretch(F), std::sqrt(1.0 - 1.2 / 2.8 * in_plane_growth), 1e-15);
}

TEST(PlaneStress, KeepsTheDescriptionOfItsMaterial) {
  PlaneStress<NeoHookean> sheet;
  int parameters = 0;
  sheet.describe([&](auto&&...) { ++parameters; }, sheet);
  EXPECT_EQ(parameters, 6);
  EXPECT_EQ(sheet.name, "neo_hookean");
}

}  // namespace
}  // namespace sinew
