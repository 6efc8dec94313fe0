#pragma once
/// What every correction offers: from sums over the neighbors of one particle, the map that turns the weights of a kernel into
/// the gradient weights g_ij of that particle,
///
///     grad f(X_i) ~ sum_j V_j (f_j - f_i) g_ij.
///
/// X_ij = X_j - X_i, W_ij the kernel and a_ij = |dW/dr| / r >= 0, so that a_ij X_ij is the gradient of W_ij with respect to X_i.
///
///     struct Name {
///       static constexpr std::string_view name, summary, source;
///       static constexpr bool radial;                // g_ij = M^-1 (a_ij X_ij): scale 1, no shift, L the inverse of M
///       static constexpr bool higher_moments;        // it needs them
///       static void describe(auto&& field, auto& m);
///       template <int D> GradientMap<D> map(const Moments<D>& moments) const;
///     };
///
/// `map` carries SINEW_POINTWISE, so that a device has it too (tools/check_device.py).

#include <sinew/core/vec.hpp>
#include <string_view>

namespace sinew {

/// Sums over the neighbors j != i of one particle; only `shepard_sum` includes the particle itself, by V_i W(0).
template <int D>
struct Moments {
  double shepard_sum = 0.0;       ///< sum V_j W_ij [1]
  Vec<double, D> gradient_sum{};  ///< sum V_j a_ij X_ij [1/length]
  Mat<double, D> first{};         ///< sum V_j a_ij X_ij (x) X_ij [1], symmetric and positive semi-definite

  // Higher moments, for corrections that ask for them.
  Vec<double, D> kernel_first{};   ///< sum V_j W_ij X_ij [length]
  Mat<double, D> kernel_second{};  ///< sum V_j W_ij X_ij (x) X_ij [length^2]
  Mat<double, D> second[D]{};      ///< second[g]: sum V_j a_ij X_ij,g X_ij (x) X_ij [length]
};

/// det M / (tr M / D)^D: 1 for equal eigenvalues, about the ratio of the smallest to the largest otherwise, 0 for points in one line or plane. Independent of units.
template <int D>
SINEW_POINTWISE double roundness(const Mat<double, D>& M) {
  double isotropic = 1.0;
  for (int i = 0; i < D; ++i) isotropic *= trace(M) / D;
  return trace(M) > 0.0 ? determinant(M) / isotropic : 0.0;
}
/// Moments that are flatter than that count as singular.
inline constexpr double flattest_moment = 1e-6;

/// g_ij = (scale + tilt.X_ij) a_ij L X_ij - W_ij (shift + bend X_ij), and the kernel W_ij (kernel_scale + tilt.X_ij), whose sum V_j W_ij is 1 with the particle
/// itself, if somebody has summed it. Where `valid` is false, the moments do not allow the correction (too few neighbors,
/// or neighbors all in one line or plane) and the map leaves the weights as they are.
template <int D>
struct GradientMap {
  Mat<double, D> L = Mat<double, D>::identity();
  double scale = 1.0, kernel_scale = 1.0;
  Vec<double, D> shift{}, tilt{};
  Mat<double, D> bend{};
  bool valid = true;

  /// All gradients zero.
  static GradientMap nothing() { return {{}, 0.0, 0.0, {}, {}, {}, false}; }
  SINEW_INLINE Vec<double, D> apply(double a, double W, const Vec<double, D>& X) const {
    return ((scale + dot(tilt, X)) * a) * (L * X) - W * (shift + bend * X);
  }
  SINEW_INLINE double kernel(double W, const Vec<double, D>& X) const { return W * (kernel_scale + dot(tilt, X)); }
};

/// 1 / sum V_j W_ij, the factor of the kernel of those that do not correct it otherwise; 1 where nobody has summed it.
template <int D>
SINEW_POINTWISE double partition_of_unity(const Moments<D>& moments) {
  return moments.shepard_sum > 0.0 ? 1.0 / moments.shepard_sum : 1.0;
}

}  // namespace sinew
