#pragma once
/// What a law of hardening offers to J2 (materials/j2.hpp), which turns it into a material of that name.
///
///     struct Name {
///       static constexpr std::string_view name, summary, source;
///       static constexpr bool linear = false;           // the flow stress is a linear function of the plastic strain alone
///       static constexpr bool depends_on_rate = false;  // it grows with the logarithm of the rate
///       double yield_stress; ...                     // of the virgin material [Pa]
///       static void describe(auto&& field, auto& m);
///       template <class T> FlowStress<T> flow_stress(const PlasticPoint<T>& at) const;
///       template <class T> T temperature(const T& plastic_work, double density) const;    // [K]; only where it is known, and with it
///       template <class T> T strength_left(const T& temperature) const;                   // factor of the flow stress
///     };

#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <string_view>

namespace sinew {

template <class T>
struct PlasticPoint {
  T strain;         ///< equivalent plastic strain [1]
  T rate;           ///< its rate [1/s]; 0: as slow as the law knows
  T strength_left;  ///< factor of the flow stress, for laws with a temperature
};

template <class T>
struct FlowStress {
  T value;         ///< [Pa]
  T strain_slope;  ///< derivative with respect to the plastic strain [Pa]
  T rate_slope;    ///< and to its rate [Pa s]
};

/// x^y for x >= 0 and y > 0.
template <class T>
SINEW_INLINE T power(const T& x, double y) {
  using std::exp, std::log;
  return exp(T(y) * log(x));
}

}  // namespace sinew
