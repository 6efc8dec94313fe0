#pragma once

#include <sinew/core/dual.hpp>
#include <sinew/materials/history_numbers.hpp>
#include <sinew/materials/material.hpp>
#include <sinew/materials/rates/rate_law.hpp>

namespace sinew {

/// History of a particle whose material is written in rates.
template <class M>
struct RateHistory {
  using T = ScalarOf<M>;
  T strain{0.0};  ///< equivalent plastic strain [1]
  T work{0.0};    ///< plastic work per reference volume, dissipated [J/m^3]
  M stress{};     ///< Cauchy [Pa]
  M gradient{};   ///< F - I after the last step

  static void numbers(auto& history, auto&& use) {
    use(history.strain);
    use(history.work);
    symmetric_numbers(history.stress, use);
    all_numbers(history.gradient, use);
  }
};

/// A material whose Cauchy stress is integrated in time, with the Jaumann rate:
///
///     d sigma / dt = w sigma - sigma w + 2 G dev(d) + K tr(d) I - (what flows),   d and w: symmetric and skew part of l = dF/dt F^-1
///
/// From F_n to F_n+1: l dt = 2 (F_n+1 - F_n) (F_n+1 + F_n)^-1, the gradient of the step's displacements in its middle; sigma and the first half of what it gains turn by
/// (I - w dt/2)^-1 (I + w dt/2), so that a rotation of any size changes none of its invariants. Hughes & Winget (1980), who turn none of the gain, which is of first order. P = J sigma F^-T. The energy J (J2 / (2 G) + p^2 / (2 K)) is that of small elastic strains. Limits: isotropic; elastic strains are small; not plane stress.
template <class Law>
struct RateForm {
  static constexpr std::string_view name = Law::name, summary = Law::summary, source = Law::source;
  template <class M>
  using History = RateHistory<M>;
  static constexpr int first_shape = 2;   ///< number of the history from which on it is the stress
  static constexpr bool in_rates = true;  ///< only the change of F in a step counts
  double density = 0.0;
  ElasticConstants elastic;
  Law law;

  static void describe(auto&& field, auto& m) {
    field("density", m.density, "kg/m^3", "Reference mass density.", positive);
    ElasticConstants::describe(field, m.elastic);
    Law::describe(field, m.law);
  }

  template <class M>
  SINEW_INLINE Response<M> respond(const M& F, History<M>& history, double dt) const {
    using T = ScalarOf<M>;
    const M I = M::identity(), before = I + history.gradient;
    const M l = T(2.0) * ((F - before) * inverse(F + before));
    const M spin = T(0.5) * (l - transpose(l)), d = l - spin;
    const M turn = inverse(I - T(0.5) * spin) * (I + T(0.5) * spin);
    const T growth = trace(d), K(elastic.bulk_modulus), G(elastic.shear_modulus);
    const M half = G * d + (T(0.5) * (K - T(2.0 / 3.0) * G) * growth) * I;
    const M trial = turn * (history.stress + half) * transpose(turn) + half;
    const Flowed<M> flowed = law.flow(trial, elastic, dt);
    history.stress = flowed.stress;
    history.strain = history.strain + flowed.strain;
    history.work = history.work + determinant(F) * flowed.work;
    history.gradient = F - I;
    return recall(F, history);
  }

  template <class M>
  SINEW_INLINE Response<M> recall(const M& F, const History<M>& history) const {
    using T = ScalarOf<M>;
    const StressInvariants<M> at(history.stress);
    const T energy =
        T(0.5 / elastic.shear_modulus) * at.shear * at.shear + T(0.5 / elastic.bulk_modulus) * at.pressure * at.pressure;
    return {history.stress * cofactor(F), determinant(F) * energy};
  }

  /// For small changes from F: the history goes on as if F were (J^(1/D)) I, D the dimensions in which it deforms. What is left of it says the volume, however far the material has flowed.
  template <class M>
  SINEW_INLINE M forget_shape(const M& F, History<M>& history) const {
    const M round = round_of(F);
    history.gradient = round - M::identity();
    return round;
  }

  /// By dual numbers, one column after the other.
  template <class T>
  SINEW_POINTWISE Tangent<T> tangent(const Mat3<T>& F, const History<Mat3<T>>& old, double dt) const {
    Tangent<T> A;
    for (int column = 0; column < 9; ++column) {
      History<Mat3<Dual<T>>> history;
      Mat3<Dual<T>> at;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          at[i][j] = Dual<T>(F[i][j], T(3 * i + j == column ? 1.0 : 0.0));
          history.stress[i][j] = Dual<T>(old.stress[i][j], T(0.0));
          history.gradient[i][j] = Dual<T>(old.gradient[i][j], T(0.0));
        }
      const Mat3<Dual<T>> P = respond(at, history, dt).P;
      for (int row = 0; row < 9; ++row) A[row][column] = P[row / 3][row % 3].slope;
    }
    return A;
  }

  /// In the current frame the tangent is at most lambda + 2 mu plus twice the stress, and flow lowers it; |F^-T N|^2 is at most the largest eigenvalue of C^-1.
  template <class M>
  SINEW_INLINE AcousticBound<ScalarOf<M>> acoustic_bound(const M& F, const M& P) const {
    using std::sqrt;
    using T = ScalarOf<M>;
    const M tau = P * transpose(F);
    return {T(0.0), T(elastic.lambda() + 2.0 * elastic.mu()) * determinant(F) + T(2.0) * sqrt(double_dot(tau, tau))};
  }

  /// Where it has flowed, the hourglass stiffness may be no more than that of the flow, as with metals: Ganzenmueller (2015), sec. 4.5. Never quite nothing, so that what is left of it in a step
  /// is a number.
  template <class M>
  SINEW_INLINE ScalarOf<M> hourglass_modulus(const History<M>& history) const {
    using T = ScalarOf<M>;
    constexpr double least = 1e-6;
    const T E(elastic.youngs_modulus);
    return select(history.strain > T(0.0), max(min(law.flow_stress(history.stress), E), T(least) * E), E);
  }
  template <class M>
  SINEW_INLINE ScalarOf<M> temperature(const History<M>&) const {
    return ScalarOf<M>(0.0);
  }

 private:
  template <class T>
  static SINEW_INLINE Mat3<T> round_of(const Mat3<T>& F) {
    using std::cbrt;
    return cbrt(determinant(F)) * Mat3<T>::identity();
  }
  template <class T>
  static SINEW_INLINE PlaneMatrix<T> round_of(const PlaneMatrix<T>& F) {
    using std::sqrt;
    return {sqrt(determinant(F.in_plane)) * Mat<T, 2>::identity(), F.out_of_plane};
  }
};

}  // namespace sinew
