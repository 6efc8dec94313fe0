#include <gtest/gtest.h>

#include <sinew/core/pack.hpp>
#include <sinew/core/vec.hpp>
#include <unit/physics/random_states.hpp>

namespace sinew {
namespace {

using testing_support::distance;
using testing_support::random_matrix;

template <int D>
void expect_inverse_and_cofactor() {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const auto A = random_matrix<D>(random, 0.6, 0.1);
    EXPECT_LT(distance(A * inverse(A), Mat<double, D>::identity()), 1e-12);
    EXPECT_LT(distance(inverse(A) * A, Mat<double, D>::identity()), 1e-12);
    EXPECT_LT(distance(transpose(cofactor(A)) * A, determinant(A) * Mat<double, D>::identity()), 1e-13);
  }
}

TEST(SmallMatrix, InverseAndCofactor) {
  expect_inverse_and_cofactor<2>();
  expect_inverse_and_cofactor<3>();
}

TEST(SmallMatrix, DeterminantOfKnownMatrices) {
  EXPECT_DOUBLE_EQ(determinant(Mat<double, 2>{{{1, 2}, {3, 4}}}), -2.0);
  EXPECT_DOUBLE_EQ(determinant(Mat3<double>{{{2, 0, 1}, {1, 3, 2}, {1, 1, 4}}}), 18.0);
}

TEST(SmallMatrix, ProductsAndTransposes) {
  const Mat3<double> A{{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}}, B{{{0, 1, 0}, {2, 0, 1}, {1, 1, 1}}};
  const Vec3<double> a{{1, -2, 3}}, b{{2, 0, 1}};
  EXPECT_EQ(transpose(A)[0][2], 7.0);
  EXPECT_EQ((A * B)[0][1], 4.0);
  EXPECT_EQ((A * B)[2][2], 18.0);
  EXPECT_EQ(distance(transpose(A * B), transpose(B) * transpose(A)), 0.0);
  EXPECT_EQ((A * a)[1], 12.0);
  EXPECT_EQ(dot(A * a, b), dot(a, transpose(A) * b));
  EXPECT_EQ(double_dot(A, outer(a, b)), dot(a, A * b));
  EXPECT_EQ(double_dot(A, B), trace(transpose(A) * B));
  const Vec3<double> c = cross(a, b);
  EXPECT_EQ(c[0], -2.0);
  EXPECT_EQ(c[1], 5.0);
  EXPECT_EQ(c[2], 4.0);
  EXPECT_DOUBLE_EQ(norm(Vec<double, 2>{{3, 4}}), 5.0);
}

TEST(SmallMatrix, EmbedAndInPlaneUndoEachOther) {
  const Mat<double, 2> A{{{1, 2}, {3, 4}}};
  const Mat3<double> B = embed(A, 7.0);
  EXPECT_EQ(B[2][2], 7.0);
  EXPECT_EQ(B[0][2], 0.0);
  EXPECT_EQ(B[2][1], 0.0);
  EXPECT_EQ(distance(in_plane<2>(B), A), 0.0);
  EXPECT_EQ(distance(embed(B, 1.0), B), 0.0);
}

}  // namespace
}  // namespace sinew
