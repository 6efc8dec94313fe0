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
};

/// g_ij = L (scale a_ij X_ij) - W_ij shift. Where `valid` is false, the moments do not allow the correction (too few neighbors,
/// or neighbors all in one line or plane) and the map leaves the weights as they are.
template <int D>
struct GradientMap {
  Mat<double, D> L = Mat<double, D>::identity();
  double scale = 1.0;
  Vec<double, D> shift{};
  bool valid = true;

  SINEW_INLINE Vec<double, D> apply(double a, double W, const Vec<double, D>& X) const {
    return (scale * a) * (L * X) - W * shift;
  }
};

}  // namespace sinew
