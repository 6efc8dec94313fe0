#pragma once
/// Deformation gradients and rotations for tests, from a fixed seed, and a distance between matrices.

#include <algorithm>
#include <cmath>
#include <random>
#include <sinew/core/vec.hpp>

namespace sinew::testing_support {

/// I plus entries in [-amplitude, amplitude], drawn again until the determinant is above `least_determinant`.
template <int D>
Mat<double, D> random_matrix(std::mt19937_64& random, double amplitude, double least_determinant) {
  std::uniform_real_distribution<double> entry(-amplitude, amplitude);
  Mat<double, D> F;
  do {
    F = Mat<double, D>::identity();
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) F[i][j] += entry(random);
  } while (determinant(F) <= least_determinant);
  return F;
}

inline Mat3<double> random_gradient(std::mt19937_64& random, double amplitude = 0.5, double least_determinant = 0.3) {
  return random_matrix<3>(random, amplitude, least_determinant);
}

inline Vec3<double> random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> gauss;
  const Vec3<double> v{{gauss(random), gauss(random), gauss(random)}};
  return (1.0 / norm(v)) * v;
}

/// A rotation by a random angle about a random axis (Rodrigues' formula).
inline Mat3<double> random_rotation(std::mt19937_64& random) {
  const Vec3<double> n = random_direction(random);
  const double angle = std::uniform_real_distribution<double>(0.3, 3.0)(random);
  const Mat3<double> spin{{{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}}};
  return Mat3<double>::identity() + std::sin(angle) * spin + (1.0 - std::cos(angle)) * (spin * spin);
}

/// The largest difference of two entries.
template <int D>
double distance(const Mat<double, D>& a, const Mat<double, D>& b) {
  double worst = 0.0;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) worst = std::max(worst, std::abs(a[i][j] - b[i][j]));
  return worst;
}

}  // namespace sinew::testing_support
