#pragma once
/// Plastic materials with numbers and what tests ask of their states.

#include <unit/physics/material_support.hpp>
#include <unit/physics/random_states.hpp>

namespace sinew::testing_support {

using PlasticTypes = AsTestTypes<PlasticMaterials>::Type;

inline void set_numbers(LinearHardening& h) { h = {0.01, 0.05}; }
inline void set_numbers(VoceHardening& h) { h = {0.01, 0.016, 8.0, 0.01}; }
inline void set_numbers(JohnsonCookHardening& h) {
  h.yield_stress = 0.01, h.hardening_modulus = 0.02, h.hardening_exponent = 0.4;
  h.rate_coefficient = 0.03, h.reference_rate = 0.1;
  h.thermal_exponent = 1.1, h.reference_temperature = 300.0, h.melting_temperature = 1300.0, h.specific_heat = 2e-5;
}

/// K = 2, mu = 0.8, yield stress 0.01.
template <class Material>
Material plastic() {
  Material m = with_lame<Material>(2.0 - 1.6 / 3.0, 0.8);
  set_numbers(m.hardening);
  return m;
}

template <class M>
double von_mises_of(const M& tau) {
  const M s = tau - (trace(tau) / 3.0) * M::identity();
  return std::sqrt(1.5 * double_dot(s, s));
}

/// Kirchhoff stress.
template <class M>
M kirchhoff(const M& P, const M& F) {
  return P * transpose(F);
}

/// The response, compiled once for a material, whose own functions become part of every caller.
template <class Material, class M, class History, class T>
[[gnu::noinline]] auto respond(const Material& material, const M& F, History& history, const T& dt) {
  return material.respond(F, history, dt);
}
/// The tangent likewise.
template <class Material, class M, class History>
[[gnu::noinline]] auto tangent(const Material& material, const M& F, const History& history, double dt) {
  return material.tangent(F, history, dt);
}

/// A virgin particle that has gone through some random steps; F is where it is now.
template <class Material>
PlasticHistory<Mat3<double>> random_history(const Material& m, std::mt19937_64& random, Mat3<double>& F, double amplitude = 0.02,
                                            double dt = 0.01) {
  PlasticHistory<Mat3<double>> history;
  F = random_rotation(random);
  for (int step = 0; step < 5; ++step) {
    F = random_gradient(random, amplitude) * F;
    respond(m, F, history, dt);
  }
  return history;
}

}  // namespace sinew::testing_support
