#pragma once

#include <cmath>
#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/vec.hpp>
#include <string_view>

namespace sinew {

/// A stiffness against the part of a pair's motion that the deformation gradient does not see, e_ij = x_ij - F_i X_ij. Particle i gives itself
/// a force and particle j the opposite, in one of two forms:
///
///     conservative:  f = w e_ij,                             w = alpha/32 E_i V_i V_j a_ij / sum_k V_k a_ik r_ik^2
///     central:       f = w (e_ij.x_ij / |x_ij|^2) x_ij,      w = alpha/4 or alpha/2 times E_i V_i V_j W_ij / r_ij^2
///
/// with a_ij = |dW/dr| / r [1/m^(D+2)], f in N and w in N/m. Conservative is the gradient of sum w |e|^2 / 2, since F_i (with the gradient correction) is what minimizes
/// that sum; it is the energy of Ren et al. (2020), eq. 21-27, with alpha E / 64 as its penalty modulus. Central is the published force, Ganzenmueller
/// (2015), eq. 25-32, and Islam & Peng (2019), eq. 42-47; the switch is from the former, sec. 4.5. Central has no potential: undamped, it feeds high-frequency
/// motion at large strains or on uneven particles until the run fails (docs/decisions/0003). Both conserve linear and angular momentum.
struct HourglassStiffness {
  static constexpr std::string_view name = "hourglass_stiffness";
  static constexpr std::string_view summary = "Stiffness against zero-energy modes";
  static constexpr std::string_view source =
      "Ganzenmueller (2015), eq. 25-32; Islam & Peng (2019), eq. 42-47; Ren et al. (2020), eq. 21-27";
  static constexpr bool in_reference = true, in_current = false;  ///< configurations for which it is made
  static constexpr bool pairwise_linear = true;                   ///< each pair force is a share of i plus a share of j

  double alpha = 50.0;
  Choice normalization{"conservative", {"conservative", "half", "printed"}};
  bool plastic_switch = true;

  static void describe(auto&& field, auto& m) {
    field("alpha", m.alpha, "1", "Coefficient of the hourglass stiffness.", non_negative, optional);
    field("normalization", m.normalization, "1",
          "conservative: gradient of an energy, about as stiff as half; half: the published central force with alpha/4 a "
          "particle, which gives the "
          "published results; printed: with alpha/2, as the first paper prints it.",
          any_number, optional);
    field("plastic_switch", m.plastic_switch, "1",
          "Where plastic strain is, the yield stress of the virgin material takes the place of Young's modulus; otherwise the "
          "control resists plastic flow.",
          any_number, optional);
  }

  bool conservative() const { return normalization.value == "conservative"; }

  /// Factor of E_i V_i V_j times the weight of the pair, see above.
  double coefficient() const {
    if (conservative()) return alpha / 32.0;
    return alpha * (normalization.value == "half" ? 0.25 : 0.5);
  }

  /// What i itself gives to its pair with j: a force on i [N] (and the opposite on j), and the energy that goes with it [J].
  template <class T, int D>
  struct Share {
    Vec<T, D> force;
    T energy;
  };

  /// X: X_j - X_i, x: x_j - x_i [m]; weight: w [N/m].
  template <class T, int D>
  static SINEW_INLINE Share<T, D> conservative_share(const Mat<T, D>& F, const Vec<T, D>& X, const Vec<T, D>& x,
                                                     const T& weight) {
    const Vec<T, D> e = x - F * X;
    return {weight * e, T(0.5) * weight * dot(e, e)};
  }

  /// The energy is the work taken up by the force if the pair came here in proportion, half force times extension, in squares: pull
  /// (|x|^2 - |X|^2) / 4. Exact for small strains only, there being no potential; it may be negative for single pairs. Zero for x = 0.
  template <class T, int D>
  static SINEW_INLINE Share<T, D> central_share(const Mat<T, D>& F, const Vec<T, D>& X, const Vec<T, D>& x, const T& weight) {
    const T square = guarded_square(x);
    const T pull = weight * (square - dot(F * X, x)) / square;
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
