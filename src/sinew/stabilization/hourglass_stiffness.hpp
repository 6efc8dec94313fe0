#pragma once

#include <cmath>
#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/vec.hpp>
#include <string_view>

namespace sinew {

/// A stiffness against the part of a pair's motion that the deformation gradient does not see. Particle i gives itself
///
///     f = w (1 - (F_i X_ij).x_ij / |x_ij|^2) x_ij,    w = coefficient() E_i V_i V_j W_ij / r_ij^2   [N/m]
///
/// and particle j the opposite; f pulls a pair together that is longer than F_i says. Linear and angular momentum are conserved.
/// It is not exactly the gradient of a potential: the effect of a displacement on F_i is left out. Ganzenmueller (2015), eq.
/// 25-32.
struct HourglassStiffness {
  static constexpr std::string_view name = "hourglass_stiffness";
  static constexpr std::string_view summary = "Stiffness against zero-energy modes, along the line of each pair";
  static constexpr std::string_view source = "Ganzenmueller (2015), eq. 25-32; Islam & Peng (2019), eq. 42-47";
  static constexpr bool pairwise_linear = true;  ///< each pair force is a share of i plus a share of j

  double alpha = 50.0;
  Choice normalization{"half", {"half", "printed"}};

  static void describe(auto&& field, auto& m) {
    field("alpha", m.alpha, "1", "Coefficient of the hourglass stiffness.", non_negative, optional);
    field("normalization", m.normalization, "1",
          "half: alpha/4 a particle, which gives the published results; printed: alpha/2, as the first paper prints it.",
          any_number, optional);
  }

  /// alpha / 4 for "half" (Islam & Peng (2019), eq. 46), alpha / 2 for "printed" (Ganzenmueller (2015), eq. 32).
  double coefficient() const { return alpha * (normalization.value == "half" ? 0.25 : 0.5); }

  /// What i itself gives to its pair with j: a force on i [N] (and the opposite on j), and the work that this force has taken up [J]: half
  /// the force times the extension of the pair, written with squares, pull (|x|^2 - |X|^2) / 4. It is exact for small strains reached in
  /// proportion; there is no exact one, since the force has no potential. Zero for affine motions. It may be negative for single pairs.
  template <class T, int D>
  struct Share {
    Vec<T, D> force;
    T energy;
  };

  /// X: X_j - X_i, x: x_j - x_i [m]; weight: w [N/m]. Zero for x = 0.
  template <class T, int D>
  static SINEW_INLINE Share<T, D> pair_share(const Mat<T, D>& F, const Vec<T, D>& X, const Vec<T, D>& x, const T& weight) {
    const T square = guarded_square(x);
    const T excess = square - dot(F * X, x);
    const T pull = weight * excess / square;
    return {pull * x, T(0.25) * pull * (dot(x, x) - dot(X, X))};
  }

 private:
  /// |x|^2, made positive by an addend that is below rounding for every pair of separate particles.
  template <class T, int D>
  static SINEW_INLINE T guarded_square(const Vec<T, D>& x) {
    return dot(x, x) + T(1e-200);
  }
};

}  // namespace sinew
