/// PlaneMatrix against the 3 x 3 matrix that it stands for: its operations, and every material on both.

#include <sinew/materials/plane_stress.hpp>
#include <unit/physics/material_support.hpp>
#include <unit/physics/random_states.hpp>

namespace sinew {
namespace {

using namespace testing_support;

/// The largest absolute value in a number; slopes count too.
double largest_part(double a) { return std::abs(a); }
double largest_part(Pack a) { return largest(abs(a)); }
template <class T>
double largest_part(const Dual<T>& a) {
  return std::max(largest_part(a.value), largest_part(a.slope));
}
template <class T>
double largest_part(const Mat3<T>& a) {
  double worst = 0.0;
  for (int k = 0; k < 9; ++k) worst = std::max(worst, largest_part(a[k / 3][k % 3]));
  return worst;
}

/// Within 1e-14 of the largest entry, or of 1 where all are smaller: the moduli here are about 1.
template <class Value>
void expect_same(const Value& plane, const Value& space) {
  EXPECT_LT(largest_part(plane - space), 1e-14 * std::max(1.0, largest_part(space)));
}

/// A matrix near the identity, other numbers in every lane.
void fill(PlaneMatrix<double>& F, std::mt19937_64& random) {
  F = {random_matrix<2>(random, 0.4, 0.4), std::uniform_real_distribution<double>(0.6, 1.5)(random)};
}
void fill(PlaneMatrix<Pack>& F, std::mt19937_64& random) {
  for (int lane = 0; lane < lanes; ++lane) {
    PlaneMatrix<double> one;
    fill(one, random);
    for (int k = 0; k < 4; ++k) F.in_plane[k / 2][k % 2].set(lane, one.in_plane[k / 2][k % 2]);
    F.out_of_plane.set(lane, one.out_of_plane);
  }
}
template <class T>
void fill(PlaneMatrix<Dual<T>>& F, std::mt19937_64& random) {
  PlaneMatrix<T> value, slope;
  fill(value, random);
  fill(slope, random);
  for (int k = 0; k < 4; ++k) F.in_plane[k / 2][k % 2] = {value.in_plane[k / 2][k % 2], slope.in_plane[k / 2][k % 2] - T(0.5)};
  F.out_of_plane = {value.out_of_plane, slope.out_of_plane - T(1.0)};
}
template <class T>
PlaneMatrix<T> random_plane_state(std::mt19937_64& random) {
  PlaneMatrix<T> F;
  fill(F, random);
  return F;
}

template <class T>
class PlaneMatrixOf : public ::testing::Test {
 protected:
  std::mt19937_64 random{41};
};
using Scalars = ::testing::Types<double, Pack, Dual<double>, Dual<Pack>>;
TYPED_TEST_SUITE(PlaneMatrixOf, Scalars);

TYPED_TEST(PlaneMatrixOf, OperationsAreThoseOfTheMatrixInSpace) {
  using T = TypeParam;
  using M = PlaneMatrix<T>;
  for (int trial = 0; trial < 100; ++trial) {
    const M a = random_plane_state<T>(this->random), b = random_plane_state<T>(this->random);
    const Mat3<T> A = in_space(a), B = in_space(b);
    const T s = b.in_plane[0][1];
    expect_same(in_space(a + b), A + B);
    expect_same(in_space(a - b), A - B);
    expect_same(in_space(s * a), s * A);
    expect_same(in_space(a * b), A * B);
    expect_same(in_space(transpose(a)), transpose(A));
    expect_same(in_space(cofactor(a)), cofactor(A));
    expect_same(in_space(inverse(a)), inverse(A));
    expect_same(trace(a), trace(A));
    expect_same(double_dot(a, b), double_dot(A, B));
    expect_same(determinant(a), determinant(A));
    M sum = a, difference = a;
    sum += b;
    difference -= b;
    expect_same(in_space(sum), A + B);
    expect_same(in_space(difference), A - B);
  }
  expect_same(in_space(M::identity()), Mat3<T>::identity());
}

TEST(PlaneMatrix, KnowsItsPlaceInSpace) {
  const PlaneMatrix<double> a{{{{1, 2}, {3, 4}}}, 7.0};
  EXPECT_EQ(distance(in_space(a), Mat3<double>{{{1, 2, 0}, {3, 4, 0}, {0, 0, 7}}}), 0.0);
  EXPECT_EQ(distance(in_plane<2>(a), a.in_plane), 0.0);
  static_assert(std::is_same_v<ScalarOf<PlaneMatrix<Dual<Pack>>>, Dual<Pack>>);
  static_assert(std::is_same_v<ScalarOf<Mat3<Pack>>, Pack>);
}

template <class Material>
class MaterialInThePlane : public ::testing::Test {
 protected:
  std::mt19937_64 random{43};

  template <class T, class Law>
  void expect_same_answers(const Law& material) {
    for (int trial = 0; trial < 100; ++trial) {
      const PlaneMatrix<T> F = random_plane_state<T>(random);
      const auto plane = material.respond(F);
      const auto space = material.respond(in_space(F));
      expect_same(in_space(plane.P), space.P);
      expect_same(plane.energy, space.energy);
    }
  }
  template <class Law>
  void expect_same_answers_of_all_scalars(const Law& material) {
    expect_same_answers<double>(material);
    expect_same_answers<Pack>(material);
    expect_same_answers<Dual<double>>(material);
    expect_same_answers<Dual<Pack>>(material);
  }
};
TYPED_TEST_SUITE(MaterialInThePlane, MaterialTypes, MaterialNames);

TYPED_TEST(MaterialInThePlane, RespondsAsInSpace) {
  this->expect_same_answers_of_all_scalars(with_lame<TypeParam>(1.2, 0.8));
  this->expect_same_answers_of_all_scalars(with_lame<TypeParam>(-0.3, 0.8));
}

TYPED_TEST(MaterialInThePlane, RespondsAsInSpaceInPlaneStress) {
  this->expect_same_answers_of_all_scalars(PlaneStress<TypeParam>{with_lame<TypeParam>(1.2, 0.8)});
}

/// The bound of the largest eigenvalue is exact for a PlaneMatrix, so that the stiffness may be smaller, never larger; that it is still
/// a bound is tested in acoustic_test.cpp.
TYPED_TEST(MaterialInThePlane, AcousticStiffnessIsNotLooserThanInSpace) {
  for (const double lambda : {-0.3, 1.2, 40.0}) {
    const auto material = with_lame<TypeParam>(lambda, 0.8);
    const double at_rest = acoustic_stiffness(material, PlaneMatrix<double>::identity());
    EXPECT_NEAR(at_rest, lambda + 1.6, 1e-14 * at_rest);
    for (int trial = 0; trial < 100; ++trial) {
      const auto F = random_plane_state<Dual<Pack>>(this->random);
      const Pack plane = acoustic_stiffness(material, F).value, space = acoustic_stiffness(material, in_space(F)).value;
      for (int lane = 0; lane < lanes; ++lane) EXPECT_LE(plane[lane], space[lane] + 1e-13 * (1.0 + lambda));
    }
  }
}

TYPED_TEST(MaterialInThePlane, PackAndDualGiveTheStiffnessOfEachLane) {
  const auto material = with_lame<TypeParam>(1.2, 0.8);
  const auto F = random_plane_state<Dual<Pack>>(this->random);
  PlaneMatrix<Pack> packed;
  for (int k = 0; k < 4; ++k) packed.in_plane[k / 2][k % 2] = F.in_plane[k / 2][k % 2].value;
  packed.out_of_plane = F.out_of_plane.value;
  const Pack stiffness = acoustic_stiffness(material, packed), dual = acoustic_stiffness(material, F).value;
  for (int lane = 0; lane < lanes; ++lane) {
    PlaneMatrix<double> one;
    for (int k = 0; k < 4; ++k) one.in_plane[k / 2][k % 2] = packed.in_plane[k / 2][k % 2][lane];
    one.out_of_plane = packed.out_of_plane[lane];
    expect_same(stiffness[lane], acoustic_stiffness(material, one));
    expect_same(dual[lane], acoustic_stiffness(material, one));
  }
}

}  // namespace
}  // namespace sinew
