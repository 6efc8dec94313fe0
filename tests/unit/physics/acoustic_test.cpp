#include <unit/physics/material_support.hpp>
#include <unit/physics/random_states.hpp>
#include <vector>

namespace sinew {
namespace {

using namespace testing_support;

/// A_iJkL N_J N_L.
Mat3<double> acoustic_tensor(const Tangent<double>& A, const Vec3<double>& N) {
  Mat3<double> Q;
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 9; ++column) Q[row / 3][column / 3] += A[row][column] * N[row % 3] * N[column % 3];
  return Q;
}

/// The largest eigenvalue of a symmetric matrix by Jacobi's rotations; unlike the closed form it is accurate for equal
/// eigenvalues.
double largest_eigenvalue(Mat3<double> a) {
  for (int sweep = 0; sweep < 5; ++sweep)
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      if (a[p][q] == 0.0) continue;
      const double angle = 0.5 * std::atan2(2.0 * a[p][q], a[q][q] - a[p][p]);
      Mat3<double> rotation = Mat3<double>::identity();
      rotation[p][p] = rotation[q][q] = std::cos(angle);
      rotation[p][q] = std::sin(angle);
      rotation[q][p] = -std::sin(angle);
      a = transpose(rotation) * a * rotation;
      a[p][q] = a[q][p] = 0.0;
    }
  return std::max({a[0][0], a[1][1], a[2][2]});
}

TEST(LargestEigenvalueBound, IsNeverBelowAndNearlyExact) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  for (int trial = 0; trial < 2000; ++trial) {
    Mat3<double> a;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) a[i][j] = a[j][i] = entry(random);
    const Mat3<double> deviator = a - (trace(a) / 3.0) * Mat3<double>::identity();
    const double size = std::sqrt(double_dot(a, a)), spread = std::sqrt(double_dot(deviator, deviator) / 6.0),
                 exact = largest_eigenvalue(a);
    EXPECT_GE(largest_eigenvalue_bound(a), exact - 1e-14 * size);
    EXPECT_LE(largest_eigenvalue_bound(a), exact + 0.56 * spread);
  }
}

TEST(LargestEigenvalueBound, KnownSpectra) {
  const auto of = [](double x, double y, double z) {
    return largest_eigenvalue_bound(Mat3<double>{{{x, 0, 0}, {0, y, 0}, {0, 0, z}}});
  };
  EXPECT_DOUBLE_EQ(of(2, 2, 2), 2.0);
  EXPECT_DOUBLE_EQ(of(1, 5, 1), 5.0);
  EXPECT_EQ(of(0, 0, 0), 0.0);
  EXPECT_GE(of(5, 1, 5), 5.0);
  EXPECT_LE(of(5, 1, 5), 5.75);
}

TEST(LargestEigenvalueBound, IsExactInThePlane) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  for (int trial = 0; trial < 2000; ++trial) {
    const double off_diagonal = entry(random);
    const PlaneMatrix<double> a{{{{entry(random), off_diagonal}, {off_diagonal, entry(random)}}}, entry(random)};
    EXPECT_NEAR(largest_eigenvalue_bound(a), largest_eigenvalue(in_space(a)), 2e-15);
  }
  EXPECT_EQ(largest_eigenvalue_bound(PlaneMatrix<double>::identity()), 1.0);
}

template <class Material>
class AcousticStiffness : public ::testing::Test {};
TYPED_TEST_SUITE(AcousticStiffness, MaterialTypes, MaterialNames);

/// Compares with the largest value over 2000 directions at 200 random deformations, for a compressible and a nearly
/// incompressible solid.
TYPED_TEST(AcousticStiffness, BoundsTheAcousticTensorTightly) {
  std::mt19937_64 random(23);
  std::vector<Vec3<double>> directions;
  for (int k = 0; k < 2000; ++k) directions.push_back(random_direction(random));
  double loosest = 0.0;
  for (const double lambda : {1.2, 40.0}) {
    const auto material = with_lame<TypeParam>(lambda, 0.8);
    for (int trial = 0; trial < 100; ++trial) {
      const Mat3<double> F = random_gradient(random, trial % 2 == 0 ? 0.2 : 0.6);
      const Tangent<double> A = material.tangent(F);
      double sampled = -1e300;
      for (const Vec3<double>& N : directions) sampled = std::max(sampled, largest_eigenvalue(acoustic_tensor(A, N)));
      const double bound = acoustic_stiffness(material, F);
      EXPECT_GE(bound, sampled - 1e-12 * std::sqrt(double_dot(A, A)));
      EXPECT_LE(bound, sampled * 2.5) << "J = " << determinant(F);
      loosest = std::max(loosest, bound / sampled);
    }
  }
  this->RecordProperty("loosest", std::to_string(loosest));
}

/// The same for plane states as PlaneMatrix; the directions are still all of those in space.
TYPED_TEST(AcousticStiffness, BoundsTheAcousticTensorOfPlaneStates) {
  std::mt19937_64 random(29);
  std::vector<Vec3<double>> directions;
  for (int k = 0; k < 2000; ++k) directions.push_back(random_direction(random));
  for (const double lambda : {1.2, 40.0}) {
    const auto material = with_lame<TypeParam>(lambda, 0.8);
    for (int trial = 0; trial < 50; ++trial) {
      const double stretch = std::uniform_real_distribution<double>(0.6, 1.5)(random);
      const PlaneMatrix<double> F{random_matrix<2>(random, trial % 2 == 0 ? 0.2 : 0.6, 0.3), stretch};
      const Tangent<double> A = material.tangent(in_space(F));
      double sampled = -1e300;
      for (const Vec3<double>& N : directions) sampled = std::max(sampled, largest_eigenvalue(acoustic_tensor(A, N)));
      const double bound = acoustic_stiffness(material, F);
      EXPECT_GE(bound, sampled - 1e-12 * std::sqrt(double_dot(A, A)));
      EXPECT_LE(bound, sampled * 2.5) << "J = " << determinant(F);
    }
  }
}

/// The acoustic tensor in the frame of a later reference configuration, per volume of the first: that for N = earlier^T n, n the unit vectors of that frame.
TYPED_TEST(AcousticStiffness, BoundsTheAcousticTensorOfALaterReference) {
  std::mt19937_64 random(31);
  std::vector<Vec3<double>> directions;
  for (int k = 0; k < 1000; ++k) directions.push_back(random_direction(random));
  double loosest = 0.0;
  for (int trial = 0; trial < 100; ++trial) {
    const auto material = with_lame<TypeParam>(trial % 3 == 0 ? 40.0 : 1.2, 0.8);
    const Mat3<double> since = random_gradient(random, trial % 2 == 0 ? 0.1 : 0.4), earlier = random_gradient(random, 0.6);
    const Mat3<double> F = since * earlier;
    const Tangent<double> A = material.tangent(F);
    double sampled = -1e300;
    for (const Vec3<double>& n : directions)
      sampled = std::max(sampled, largest_eigenvalue(acoustic_tensor(A, transpose(earlier) * n)));
    const double bound = largest_of_later<Mat3<double>>(material.acoustic_bound(F), since, earlier);
    EXPECT_GE(bound, sampled - 1e-12 * std::sqrt(double_dot(A, A)));
    loosest = std::max(loosest, bound / sampled);
  }
  this->RecordProperty("loosest", std::to_string(loosest));
}

TYPED_TEST(AcousticStiffness, IsTheModulusOfPlaneWavesInTheReference) {
  for (const double lambda : {-0.3, 1.2, 40.0}) {
    const auto material = with_lame<TypeParam>(lambda, 0.8);
    EXPECT_NEAR(acoustic_stiffness(material, Mat3<double>::identity()), lambda + 1.6, 1e-12 * (lambda + 1.6));
  }
}

}  // namespace
}  // namespace sinew
