#pragma once
/// What every model of damage offers. Damage D goes from 0 to 1 and takes tension away: of the principal stresses those that pull are multiplied by
/// 1 - D; a failed particle still carries compression, unless it separates from its body.
///
///     struct Name {
///       static constexpr std::string_view name, summary, source;
///       static constexpr bool needs_flow = false;    // of a plastic material
///       CrackGrowth growth; ...
///       static void describe(auto&& field, auto& m);
///       static constexpr int numbers = 0;            // that it remembers of a particle besides; they start at 0
///       /// Where damage begins, or goes on.
///       template <class M> auto begins(const DamagePoint<M>& at, ScalarOf<M>* remembered) const;
///     };
///
/// Once begun it goes on: the cube root of D grows at the rate crack_speed c / R, c the speed of sound and R the kernel radius, so that a crack is not faster than a
/// part of the speed of sound. Ganzenmueller (2015), eq. 45-46.

#include <sinew/core/params.hpp>
#include <sinew/core/spectral.hpp>
#include <string_view>

namespace sinew {

/// What a particle shows to a model of damage.
template <class M>
struct DamagePoint {
  M F, P;
  ScalarOf<M> plastic_strain, plastic_increment, temperature;  ///< of a plastic material; otherwise 0
  double dt;
};

/// How damage goes on once it has begun, and what becomes of a particle at its end.
struct CrackGrowth {
  double crack_speed = 0.4;
  bool separate = false;

  static void describe(auto&& field, auto& m) {
    field("crack_speed", m.crack_speed, "1",
          "Growth rate of the cube root of the damage times kernel radius over speed of sound: what a crack makes of the speed "
          "of sound.",
          positive, optional);
    field("separate", m.separate, "1",
          "A failed particle loses its neighbors, and no others see each other through it; what has come apart meets by a "
          "[[contact]] with self. Otherwise pairs stay, and failed particles carry compression.",
          any_number, optional);
  }
  /// The cube root of D after a step.
  template <class T, class Mask>
  SINEW_INLINE T grow(const T& root, const Mask& active, const T& sound_times_dt_over_radius) const {
    return select(active, min(T(1.0), root + T(crack_speed) * sound_times_dt_over_radius), root);
  }
};

/// A stress without the share D of its pull.
template <class M>
struct DamagedStress {
  M P;                  ///< first Piola-Kirchhoff stress
  ScalarOf<M> pulling;  ///< part of the elastic energy that is in tension, as of squares of the principal stresses
};

template <class M>
SINEW_INLINE DamagedStress<M> damaged(const M& F, const M& P, const ScalarOf<M>& D) {
  using T = ScalarOf<M>;
  const M tau = P * transpose(F);
  const Spectrum<M> s = spectrum(T(0.5) * (tau + transpose(tau)));
  Vec3<T> left;
  T pull2(0.0);
  for (int a = 0; a < 3; ++a) {
    const T pull = max(s.values[a], T(0.0));
    left[a] = s.values[a] - D * pull;
    pull2 = pull2 + pull * pull;
  }
  return {compose(s.directions, left) * transpose(inverse(F)), pull2 / (dot(s.values, s.values) + T(1e-300))};
}

}  // namespace sinew
