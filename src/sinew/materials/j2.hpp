#pragma once

#include <sinew/core/matrix_functions.hpp>
#include <sinew/materials/hardening/hardening.hpp>
#include <sinew/materials/history_numbers.hpp>
#include <sinew/materials/material.hpp>

namespace sinew {

/// History of a plastic particle.
template <class M>
struct PlasticHistory {
  using T = ScalarOf<M>;
  T strain{0.0};  ///< equivalent plastic strain e_p [1]
  T work{0.0};    ///< plastic work per reference volume, dissipated [J/m^3]
  M metric{};     ///< C_p^-1 - I, C_p the plastic right Cauchy-Green tensor [1]

  static void numbers(auto& history, auto&& use) {
    use(history.strain);
    use(history.work);
    symmetric_numbers(history.metric, use);
  }
};

/// Plasticity of metals at finite strain: F = F_e F_p, a Kirchhoff stress that is linear in the logarithm of the elastic stretches, von Mises' yield
/// surface, associated flow, isotropic hardening.
///
///     b_e = F C_p^-1 F^T;   h = dev(ln b_e);   tau = mu h + K ln(J) I;   q = sqrt(3/2) |mu h| <= sigma_y(e_p, ...)
///
/// The return to the yield surface is radial, since flow keeps the principal axes: with D the increment of e_p, q falls by 3 mu D and
/// q - 3 mu D = sigma_y(e_p + D, D / dt). Then C_p^-1 = F^-1 b_e F^-T with b_e = J^(2/3) exp(h). The energy is mu/4 |h|^2 + K/2 ln(J)^2, the
/// plastic work sigma_y D.
/// Weber & Anand (1990); Bonet & Wood (2008), sec. 7.6 and box 7.1; Ganzenmueller (2015), sec. 4.5. The temperature that softens in a step is that of its
/// start. Limits: isotropic; J > 0 (NaN below); plane strain or three dimensions, not plane stress.
template <class Hardening>
struct J2 {
  static constexpr std::string_view name = Hardening::name, summary = Hardening::summary, source = Hardening::source;
  template <class M>
  using History = PlasticHistory<M>;
  static constexpr int first_shape = 2;  ///< number of the history from which on it is the metric
  double density = 0.0;
  ElasticConstants elastic;
  Hardening hardening;

  static void describe(auto&& field, auto& m) {
    field("density", m.density, "kg/m^3", "Reference mass density.", positive);
    ElasticConstants::describe(field, m.elastic);
    Hardening::describe(field, m.hardening);
  }

  template <class M>
  SINEW_INLINE Response<M> respond(const M& F, History<M>& history, double dt) const {
    using std::exp;
    using T = ScalarOf<M>;
    const Trial<M> trial = trial_state(F, history);
    const Flow<T> flow = flow_from(trial.q, history, dt);
    const M h = flow.left * trial.h;
    const Response<M> response = response_of(F, trial, h);
    const auto flows = flow.increment > T(0.0);
    if (!any(flows)) return response;
    const M to_reference = (exp(T(1.0 / 3.0) * trial.log_J) / trial.J) * transpose(cofactor(F));  // J^(1/3) F^-1
    const M metric = to_reference * exp_of_deviator(h) * transpose(to_reference) - M::identity();
    history.metric = select_matrix(flows, metric, history.metric);
    history.strain = history.strain + flow.increment;
    history.work = history.work + flow.stress * flow.increment;
    return response;
  }

  template <class M>
  SINEW_INLINE Response<M> recall(const M& F, const History<M>& history) const {
    const Trial<M> trial = trial_state(F, history);
    return response_of(F, trial, trial.h);
  }

  /// Consistent with the step from `old`: the derivative of the stress that `respond` gives, by the principal axes. Simo & Hughes (1998), sec. 8.3.
  template <class T>
  SINEW_POINTWISE Tangent<T> tangent(const Mat3<T>& F, const History<Mat3<T>>& old, double dt) const {
    const Spectrum<Mat3<T>> b = spectrum(elastic_finger(F, old));
    const Trial<Mat3<T>> trial = trial_state(F, old);
    const Moduli<T> moduli = moduli_of(b.values, trial.log_J, flow_from(trial.q, old, dt), slope_after(trial.q, old, dt));
    const Mat3<T> inverse_F = inverse(F), &Q = b.directions;
    const Mat3<T> tau = compose(Q, moduli.tau);
    Tangent<T> A;
    for (int column = 0; column < 9; ++column) {
      Mat3<T> change;
      change[column / 3][column % 3] = T(1.0);
      const Mat3<T> l = change * inverse_F;
      const Mat3<T> tau_change = Q * moduli.apply(transpose(Q) * l * Q) * transpose(Q);
      const Mat3<T> P_change = (tau_change - tau * transpose(l)) * transpose(inverse_F);
      for (int row = 0; row < 9; ++row) A[row][column] = P_change[row / 3][row % 3];
    }
    return A;
  }

  /// In the current frame the elastic tangent is at most lambda + 2 mu plus twice the Kirchhoff stress, and flow lowers it; |F^-T N|^2 is at most the
  /// largest eigenvalue of C^-1.
  template <class M>
  SINEW_INLINE AcousticBound<ScalarOf<M>> acoustic_bound(const M& F, const M& P) const {
    using std::sqrt;
    using T = ScalarOf<M>;
    const M tau = P * transpose(F);
    return {T(0.0), T(elastic.lambda() + 2.0 * elastic.mu()) + T(2.0) * sqrt(double_dot(tau, tau))};
  }

  /// Where plastic strain is, the hourglass stiffness may be no more than that of the flow. Ganzenmueller (2015), sec. 4.5.
  template <class M>
  SINEW_INLINE ScalarOf<M> hourglass_modulus(const History<M>& history) const {
    using T = ScalarOf<M>;
    return select(history.strain > T(0.0), T(hardening.yield_stress), T(elastic.youngs_modulus));
  }

  /// [K]; 0 where the law of hardening knows none.
  template <class M>
  SINEW_INLINE ScalarOf<M> temperature(const History<M>& history) const {
    if constexpr (requires { hardening.temperature(history.work, density); })
      return hardening.temperature(history.work, density);
    else
      return ScalarOf<M>(0.0);
  }

 private:
  /// The elastic state if nothing flows in this step.
  template <class M>
  struct Trial {
    M h;  ///< dev(ln b_e)
    ScalarOf<M> J, log_J, q;
  };
  template <class T>
  struct Flow {
    T increment;  ///< D
    T left;       ///< part of h that is left
    T stress;     ///< sigma_y after the flow
  };

  /// b_e if nothing flows.
  template <class M>
  static SINEW_INLINE M elastic_finger(const M& F, const History<M>& history) {
    return F * (M::identity() + history.metric) * transpose(F);
  }

  template <class M>
  SINEW_INLINE Trial<M> trial_state(const M& F, const History<M>& history) const {
    using std::log, std::sqrt;
    using T = ScalarOf<M>;
    const T J = determinant(F);
    const M h = deviator_of_log(elastic_finger(F, history));
    return {h, J, log(J), T(elastic.mu()) * sqrt(T(1.5) * double_dot(h, h))};
  }

  template <class M>
  SINEW_INLINE Response<M> response_of(const M& F, const Trial<M>& trial, const M& h) const {
    using T = ScalarOf<M>;
    const T mu(elastic.mu()), K(elastic.bulk_modulus);
    const M tau = mu * h + (K * trial.log_J) * M::identity();
    return {(T(1.0) / trial.J) * (tau * cofactor(F)), T(0.25) * mu * double_dot(h, h) + T(0.5) * K * trial.log_J * trial.log_J};
  }

  template <class M>
  SINEW_INLINE Flow<ScalarOf<M>> flow_from(const ScalarOf<M>& q, const History<M>& history, double dt) const {
    using T = ScalarOf<M>;
    const PlasticPoint<T> at{history.strain, T(0.0), strength_left(history)};
    const T mu3(3.0 * elastic.mu());
    const FlowStress<T> start = hardening.flow_stress(at);
    const T excess = max(q - start.value, T(0.0));
    T D = excess / (mu3 + start.strain_slope);
    if constexpr (!Hardening::linear)
      if (any(D > T(0.0))) D = solve(q, excess / mu3, at, dt);
    return {D, T(1.0) - mu3 * D / (q + T(1e-300)), q - mu3 * D};
  }

  /// d sigma_y / d D at the end of a step.
  template <class M>
  SINEW_INLINE ScalarOf<M> slope_after(const ScalarOf<M>& q, const History<M>& history, double dt) const {
    using T = ScalarOf<M>;
    const T D = flow_from(q, history, dt).increment;
    return slope_in_step(hardening.flow_stress(PlasticPoint<T>{history.strain + D, rate_of(D, dt), strength_left(history)}), dt);
  }
  template <class T>
  static SINEW_INLINE T slope_in_step(const FlowStress<T>& flow, double dt) {
    return flow.strain_slope + (dt > 0.0 ? T(1.0 / dt) : T(0.0)) * flow.rate_slope;
  }

  template <class M>
  SINEW_INLINE ScalarOf<M> strength_left(const History<M>& history) const {
    if constexpr (requires { hardening.strength_left(history.work); })
      return hardening.strength_left(temperature(history));
    else
      return ScalarOf<M>(1.0);
  }

  template <class T>
  static SINEW_INLINE T rate_of(const T& D, double dt) {
    return dt > 0.0 ? D * T(1.0 / dt) : T(0.0);
  }

  /// D with q - 3 mu D = sigma_y(e_p + D, D / dt) by Newton's method from `guess`, 0 where that is 0; where a step leaves what is known to hold the
  /// root it is halved. The error is the square of the last change. Laws that depend on ln D are solved for ln D.
  template <class T>
  SINEW_INLINE T solve(const T& q, const T& guess, const PlasticPoint<T>& start, double dt) const {
    constexpr int most_steps = 60;
    constexpr double tolerance = 1e-8;
    using std::exp;
    const T mu3(3.0 * elastic.mu());
    PlasticPoint<T> at = start;
    T low(0.0), high = q / mu3, D = guess;
    auto active = guess > T(0.0);
    for (int step = 0; step < most_steps && any(active); ++step) {
      at.strain = start.strain + D;
      at.rate = rate_of(D, dt);
      const FlowStress<T> flow = hardening.flow_stress(at);
      const T excess = q - mu3 * D - flow.value;
      low = select(excess > T(0.0), D, low);
      high = select(excess > T(0.0), high, D);
      const T change_of_D = excess / (mu3 + slope_in_step(flow, dt));
      T next = Hardening::depends_on_rate ? D * exp(change_of_D / max(D, T(1e-300))) : D + change_of_D;
      next = select((next >= low) & (next <= high), next, T(0.5) * (low + high));
      const T change = select(active, next - D, T(0.0));
      D = D + change;
      active = active & (max(change, -change) > T(tolerance) * D);
    }
    return D;
  }

  /// Principal Kirchhoff stresses and how they change with the velocity gradient l in principal axes, where the trial b_e changes by l b + b l^T.
  template <class T>
  struct Moduli {
    Vec3<T> tau, stretch2;
    Mat3<T> normal;  ///< d tau_a / d ln l_b

    SINEW_INLINE Mat3<T> apply(const Mat3<T>& l) const {
      Mat3<T> change;
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          change[a][a] += normal[a][b] * l[b][b];
          if (a != b) change[a][b] = secant(a, b) * (l[a][b] * stretch2[b] + stretch2[a] * l[b][a]);
        }
      return change;
    }

   private:
    /// (tau_a - tau_b) / (l_a^2 - l_b^2), or its limit for equal stretches.
    SINEW_INLINE T secant(int a, int b) const {
      const T gap = stretch2[a] - stretch2[b], sum = stretch2[a] + stretch2[b];
      const auto far = max(gap, -gap) > T(1e-7) * sum;
      return select(far, (tau[a] - tau[b]) / select(far, gap, T(1.0)), (normal[a][a] - normal[a][b]) / sum);
    }
  };

  /// `slope`: d sigma_y / d D.
  template <class T>
  SINEW_INLINE Moduli<T> moduli_of(const Vec3<T>& stretch2, const T& log_J, const Flow<T>& flow, const T& slope) const {
    using std::log;
    const T mu(elastic.mu()), K(elastic.bulk_modulus), mu3 = T(3.0) * mu;
    Vec3<T> h{{log(stretch2[0]), log(stretch2[1]), log(stretch2[2])}};
    const T mean = T(1.0 / 3.0) * (h[0] + h[1] + h[2]);
    for (int a = 0; a < 3; ++a) h[a] -= mean;
    const T size2 = dot(h, h) + T(1e-300);
    const T soft = select(flow.increment > T(0.0), mu3 / (mu3 + slope) - (T(1.0) - flow.left), T(0.0));
    Moduli<T> moduli{{}, stretch2, {}};
    for (int a = 0; a < 3; ++a) {
      moduli.tau[a] = mu * flow.left * h[a] + K * log_J;
      for (int b = 0; b < 3; ++b)
        moduli.normal[a][b] = K + T(2.0) * mu * (flow.left * T(a == b ? 2.0 / 3.0 : -1.0 / 3.0) - soft * h[a] * h[b] / size2);
    }
    return moduli;
  }
};

}  // namespace sinew
