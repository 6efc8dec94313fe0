#pragma once
/// What a law gives to RateForm:
///
///     struct Name {
///       static constexpr std::string_view name, summary, source;
///       static void describe(auto&& field, auto& m);
///       template <class M> Flowed<M> flow(const M& trial, const ElasticConstants& elastic, double dt) const;
///       template <class M> ScalarOf<M> flow_stress(const M& stress) const;   // size sqrt(3 J2) of the deviator with which slow flow goes on at this pressure [Pa]
///     };
///
/// `trial`: the Cauchy stress if nothing flowed in this step [Pa].

#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/plane_matrix.hpp>
#include <sinew/materials/elastic_constants.hpp>
#include <string_view>

namespace sinew {

/// The stress after a step, and what has flowed in it.
template <class M>
struct Flowed {
  M stress;                 ///< Cauchy [Pa]
  ScalarOf<M> strain{0.0};  ///< growth of the equivalent plastic strain [1]
  ScalarOf<M> work{0.0};    ///< dissipated per current volume [J/m^3]
};

/// A stress as pressure, deviator and its size.
template <class M>
struct StressInvariants {
  using T = ScalarOf<M>;
  T pressure;  ///< -tr(sigma) / 3
  M deviator;
  T shear;  ///< sqrt(J2) = sqrt(s:s / 2)

  explicit SINEW_INLINE StressInvariants(const M& stress) {
    using std::sqrt;
    pressure = T(-1.0 / 3.0) * trace(stress);
    deviator = stress + pressure * M::identity();
    shear = sqrt(T(0.5) * double_dot(deviator, deviator) + T(1e-300));
  }
};

}  // namespace sinew
