/// Laws of contact and shapes of walls against closed forms.

#include <gtest/gtest.h>

#include <random>
#include <sinew/contact_laws/registry.hpp>

namespace sinew {
namespace {

HertzContact law(double friction, double damping) {
  HertzContact h;
  h.stiffness = 2.0, h.friction = friction, h.damping = damping;
  return h;
}

Touch<double, 3> touch(double depth, const Vec3<double>& velocity = {}) { return {depth, {{0, 0, 1}}, velocity, 0.25, 1.0, 3.0}; }

TEST(Hertz, ForceAndEnergyAreThoseOfTheFormula) {
  const auto f = law(0.0, 0.0).force(touch(0.09), 0.0);
  const double expected = 16.0 / 15.0 * 2.0 * 0.09 * std::sqrt(0.09 * 0.25);
  EXPECT_NEAR(f.force[2], expected, 1e-15);
  EXPECT_EQ(f.force[0], 0.0);
  EXPECT_NEAR(f.energy, 0.4 * expected * 0.09, 1e-15);
  EXPECT_EQ(f.dissipated, 0.0);
}

TEST(Hertz, StiffnessAndForceAreDerivatives) {
  const double h = 1e-6;
  for (const double depth : {0.01, 0.1, 0.3}) {
    const auto more = law(0, 0).force(touch(depth + h), 0), less = law(0, 0).force(touch(depth - h), 0),
               at = law(0, 0).force(touch(depth), 0);
    EXPECT_NEAR((more.force[2] - less.force[2]) / (2 * h), at.stiffness, 1e-8);
    EXPECT_NEAR((more.energy - less.energy) / (2 * h), at.force[2], 1e-8);
  }
}

/// At that rate neither the stiffness now nor after the step's approach is more than 1/dt^2 half the mass.
TEST(Hertz, RateHasRoomForTheApproach) {
  for (const double depth : {-0.1, 0.0, 0.02})
    for (const double speed : {0.0, 0.3, 50.0}) {
      const auto f = law(0, 0).force(touch(depth), 0);
      const double dt = 1.0 / std::sqrt(contact_rate2(f, speed, 3.0));
      if (!(dt < 1e10)) continue;  // nothing there
      const double later = law(0, 0).force(touch(std::max(depth, 0.0) + speed * dt), 0).stiffness;
      EXPECT_LE(dt * dt * later / 3.0, 1.0 + 1e-12);
      EXPECT_GE(dt * dt * later / 3.0, 0.3) << "and not far below";
    }
}

TEST(Hertz, NothingWithoutContact) {
  const auto f = law(0.5, 0.3).force(touch(-0.01, {{1, 2, -3}}), 1e-3);
  EXPECT_EQ(norm(f.force), 0.0);
  EXPECT_EQ(f.energy, 0.0);
  EXPECT_EQ(f.dissipated, 0.0);
  EXPECT_EQ(f.stiffness, 0.0);
}

/// Damping takes energy when they come together and when they part, and never pulls.
TEST(Hertz, DampingTakesEnergyAndNeverPulls) {
  for (const double speed : {-2.0, -0.1, 0.1, 5.0}) {
    const auto f = law(0.0, 0.2).force(touch(0.05, {{0, 0, speed}}), 1e-3);
    const double elastic = law(0.0, 0.0).force(touch(0.05), 0.0).force[2];
    EXPECT_GE(f.force[2], 0.0);
    EXPECT_GT(f.dissipated, 0.0);
    EXPECT_NEAR(f.dissipated, -(f.force[2] - elastic) * speed, 1e-14);
    if (f.force[2] > 0.0) {
      EXPECT_NEAR(f.force[2], elastic - 2.0 * 0.2 * std::sqrt(f.stiffness * 3.0) * speed, 1e-14);
    }
  }
}

/// Stiff damping is held to what a step can resolve, m v / (4 dt).
TEST(Hertz, DampingIsNoMoreThanAStepResolves) {
  const double elastic = law(0.0, 0.0).force(touch(0.05), 0.0).force[2];
  EXPECT_NEAR(law(0.0, 0.5).force(touch(0.05, {{0, 0, -0.1}}), 1.0).force[2], elastic + 0.25 * 3.0 * 0.1, 1e-14);
}

/// Friction follows the whole normal force, with its damping; there is none where damping has taken it all.
TEST(Hertz, FrictionFollowsTheWholeNormalForce) {
  const auto coming = law(0.4, 0.2).force(touch(0.05, {{3, 4, -2}}), 0.1);
  EXPECT_GT(coming.force[2], 1.5 * law(0.0, 0.0).force(touch(0.05), 0.0).force[2]);
  EXPECT_NEAR(coming.force[0], -0.4 * coming.force[2] * 0.6, 1e-14);
  const auto parting = law(0.4, 0.2).force(touch(0.05, {{3, 4, 5}}), 1e-3);
  EXPECT_EQ(parting.force[2], 0.0);
  EXPECT_EQ(parting.force[0], 0.0);
}

/// Fast slip: mu F against it. Slow slip: no more than stops it.
TEST(Hertz, FrictionIsCoulombs) {
  const auto f = law(0.4, 0.0).force(touch(0.05, {{3, 4, 0}}), 1e-1);
  EXPECT_NEAR(f.force[0], -0.4 * f.force[2] * 0.6, 1e-14);
  EXPECT_NEAR(f.force[1], -0.4 * f.force[2] * 0.8, 1e-14);
  EXPECT_NEAR(f.dissipated, 0.4 * f.force[2] * 5.0, 1e-14);
  const auto slow = law(0.4, 0.0).force(touch(0.05, {{1e-6, 0, 0}}), 1e-3);
  EXPECT_NEAR(slow.force[0], -0.25 * 3.0 * 1e-6 / 1e-3, 1e-15);
  EXPECT_EQ(law(0.4, 0.0).force(touch(0.05, {{1, 0, 0}}), 0.0).force[0], 0.0) << "nothing is rubbed at the start";
}

/// The normal is the gradient of the distance, of length one, for points outside, inside and in corners.
template <int D, class Shape>
void check_shape(const Shape& shape, double least, double most) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> place(least, most);
  const double h = 1e-6;
  for (int trial = 0; trial < 300; ++trial) {
    Vec<double, D> x;
    Vec<Pack, D> packed;
    for (int c = 0; c < D; ++c) x[c] = place(random), packed[c] = Pack(x[c]);
    const Gap<double, D> gap = shape.gap(x);
    EXPECT_NEAR(norm(gap.normal), 1.0, 1e-12);
    EXPECT_NEAR(shape.gap(packed).distance[3], gap.distance, 4e-16);
    for (int c = 0; c < D; ++c) {
      Vec<double, D> more = x, less = x;
      more[c] += h, less[c] -= h;
      EXPECT_NEAR((shape.gap(more).distance - shape.gap(less).distance) / (2 * h), gap.normal[c], 1e-4);
    }
  }
}

TEST(WallShapes, NormalAndGradientAgree) {
  for (const bool inside : {false, true}) {
    PlaneWall plane{{{0.1, 0.2, 0.3}}, {{1, 2, -2}}};
    EXPECT_EQ(plane.complete(), std::nullopt);
    check_shape<3>(plane, -1, 1);
    check_shape<3>(BoxWall{{{-0.3, -0.5, -0.2}}, {{0.4, 0.6, 0.7}}, inside}, -1, 1);
    check_shape<2>(BoxWall{{{-0.3, -0.5, 0}}, {{0.4, 0.6, 0}}, inside}, -1, 1);
    check_shape<3>(SphereWall{{{0.1, 0, 0}}, 0.5, inside}, -1, 1);
    check_shape<2>(SphereWall{{{0.1, 0, 0}}, 0.5, inside}, -1, 1);
    CylinderWall cylinder{{{0.1, 0, 0}}, {{1, 1, 0}}, 0.5, inside};
    EXPECT_EQ(cylinder.complete(), std::nullopt);
    check_shape<3>(cylinder, -1, 1);
    check_shape<2>(cylinder, -1, 1);
  }
}

TEST(WallShapes, Distances) {
  const auto at = [](double x, double y, double z) { return Vec3<double>{{x, y, z}}; };
  PlaneWall plane{{{0, 0, 1}}, {{0, 0, 5}}};
  EXPECT_EQ(plane.complete(), std::nullopt);
  EXPECT_DOUBLE_EQ(plane.gap(at(7, 8, 3)).distance, 2.0);
  const BoxWall box{{{0, 0, 0}}, {{2, 2, 2}}, false}, room{{{0, 0, 0}}, {{2, 2, 2}}, true};
  EXPECT_DOUBLE_EQ(box.gap(at(5, 6, 1)).distance, 5.0);
  EXPECT_DOUBLE_EQ(box.gap(at(0.5, 1, 1)).distance, -0.5);
  EXPECT_DOUBLE_EQ(room.gap(at(0.5, 1, 1)).distance, 0.5);
  EXPECT_DOUBLE_EQ((room.gap(at(0.5, 1, 1)).normal[0]), 1.0);
  EXPECT_DOUBLE_EQ((SphereWall{{{0, 0, 0}}, 1.0, false}.gap(at(3, 0, 4)).distance), 4.0);
  EXPECT_DOUBLE_EQ((SphereWall{{{0, 0, 0}}, 6.0, true}.gap(at(3, 0, 4)).distance), 1.0);
  CylinderWall cylinder{{{0, 0, 0}}, {{0, 3, 0}}, 1.0, false};
  EXPECT_EQ(cylinder.complete(), std::nullopt);
  EXPECT_DOUBLE_EQ(cylinder.gap(at(3, 77, 4)).distance, 4.0);
}

TEST(WallShapes, SayWhatIsWrong) {
  EXPECT_TRUE(PlaneWall{}.complete().value_or("").find("normal") != std::string::npos);
  EXPECT_TRUE((BoxWall{{{1, 0, 0}}, {{0, 1, 1}}, false}.complete().value_or("").find("smaller") != std::string::npos));
  EXPECT_TRUE((CylinderWall{{}, {}, 1.0, false}.complete().value_or("").find("axis") != std::string::npos));
}

}  // namespace
}  // namespace sinew
