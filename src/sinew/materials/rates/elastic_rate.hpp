#pragma once

#include <sinew/materials/rates/rate_law.hpp>

namespace sinew {

/// Nothing flows.
struct ElasticRate {
  static constexpr std::string_view name = "hypoelastic";
  static constexpr std::string_view summary = "Linear elasticity in rates, with the Jaumann rate of the Cauchy stress";
  static constexpr std::string_view source = "Gray, Monaghan & Swift (2001); Islam & Peng (2019), eq. 9";

  static void describe(auto&&, auto&) {}

  template <class M>
  SINEW_INLINE Flowed<M> flow(const M& trial, const ElasticConstants&, double) const {
    return {trial};
  }
  template <class M>
  SINEW_INLINE ScalarOf<M> flow_stress(const M&) const {
    return infinity;
  }
};

}  // namespace sinew
