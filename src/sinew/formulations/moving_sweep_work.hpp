#pragma once
/// The bodies of the sweeps in moving_sweeps.hpp: eight particles and their pairs.

#include <sinew/formulations/moving_sweeps.hpp>

namespace sinew {

/// From one particle to another in the current configuration.
template <int D>
struct MovingPair {
  Vec<Pack, D> x;         ///< x_j - x_i
  Pack square, distance;  ///< |x|^2, |x|
  Pack weight;            ///< |dW/dr| / r

  template <class Kernel>
  static SINEW_INLINE MovingPair along(const Vec<Pack, D>& x, double radius) {
    MovingPair pair;
    pair.x = x;
    pair.square = dot(x, x) + Pack(1e-200);
    pair.distance = sqrt(pair.square);
    pair.weight = -(Kernel::template slope<D>(pair.distance, radius) / pair.distance);
    return pair;
  }
};

/// Lane k to slot slots[k], where there is one.
struct SlotsOfSlice {
  int slot[lanes];

  template <int D>
  SlotsOfSlice(const MovingNeighbors<D>& neighbors, const MovingSlice& slice) {
    for (int k = 0; k < lanes; ++k) slot[k] = slice.own[k] == neighbors.nobody() ? -1 : neighbors.point_at(slice.own[k] / lanes);
  }
  void store(const Pack& values, double* by_slot) const {
    for (int k = 0; k < lanes; ++k)
      if (slot[k] >= 0) by_slot[slot[k]] = values[k];
  }
  void add(const Pack& values, double* by_slot) const {
    for (int k = 0; k < lanes; ++k)
      if (slot[k] >= 0) by_slot[slot[k]] += values[k];
  }
};

/// Inverse of a moment matrix; the identity where there are too few neighbors for one, or they are nearly on a line or plane.
template <int D>
SINEW_INLINE Mat<Pack, D> correction_of(const Mat<Pack, D>& moments) {
  constexpr double least_mean = 0.02, flattest = 0.02;
  const Pack mean = (1.0 / D) * trace(moments);
  const auto enough = (mean > Pack(least_mean)) & (determinant(moments) > flattest * power<D>(mean));
  const Mat<Pack, D> inverted = inverse(moments), identity = Mat<Pack, D>::identity();
  Mat<Pack, D> B;
  for (int r = 0; r < D; ++r)
    for (int c = 0; c < D; ++c) B[r][c] = select(enough, inverted[r][c], identity[r][c]);
  return B;
}

/// `more`: corrected or with the printed non-nested shear.
template <int D, class Kernel, bool more>
void sweep_slice(const GradientSweep<D>& sweep, const MovingSlice& slice) {
  const double* rows = sweep.pairs.motion;
  const PlacePart<D> i = load_place<D>(rows, slice.own);
  const MotionPart<D> motion = load_motion<D>(rows, slice.own);
  Mat<Pack, D> L, M;
  Vec<Pack, D> pull;
  for (int n = 0; n < slice.length; ++n) {
    const int* offset = slice.places + static_cast<std::ptrdiff_t>(lanes) * n;
    const PlacePart<D> j = load_place<D>(rows, offset);
    const MotionPart<D> motion_j = load_motion<D>(rows, offset);
    const Vec<Pack, D> v = motion_j.v - motion.v;
    const auto pair = MovingPair<D>::template along<Kernel>(j.x - i.x - Pack(sweep.half_step) * v, sweep.pairs.radius);
    const Vec<Pack, D> gradient = (pair.weight * j.mass) * pair.x;
    L += outer(v, gradient);
    if constexpr (more) {
      if (sweep.corrected) M += outer(pair.x, gradient);
      if (sweep.shear)
        pull += NonNestedShear::pull(pair.x, v, pair.weight * j.mass * motion_j.specific_volume, 1.0 / pair.square);
    }
  }
  const SlotsOfSlice slots(sweep.pairs.neighbors, slice);
  L = motion.specific_volume * L;
  if (sweep.corrected) {
    const Mat<Pack, D> B = correction_of(motion.specific_volume * M);
    L = L * B;
    for (int c = 0; c < D * D; ++c) slots.store(B[c / D][c % D], sweep.correction.component(c));
  }
  for (int c = 0; c < D * D; ++c) slots.store(L[c / D][c % D], sweep.gradient.component(c));
  if (sweep.shear)
    for (int c = 0; c < D; ++c) slots.store(motion.specific_volume * pull[c], sweep.pull.component(c));
}

/// What a slice of particles has and collects while it meets its neighbors. `viscous`: needs velocities; `more`: everything else that a case may ask for.
template <int D, bool viscous, bool more>
struct MovingForces {
  const ForceSweep<D>& sweep;
  PlacePart<D> place;
  MotionPart<D> motion;
  StressPart<D> stress;
  Mat<Pack, D> repulsion;
  GradientPart<D> gradient;
  Vec<Pack, D> acceleration, pull;
  Pack viscous_power{0.0}, resistance{0.0}, repulsive_power{0.0};

  MovingForces(const ForceSweep<D>& all, const int* own)
      : sweep(all),
        place(load_place<D>(all.pairs.motion, own)),
        motion(load_motion<D>(all.pairs.motion, own)),
        stress(load_stress<D>(all.stress, all.rest, all.lower, own)) {
    if (all.repels) repulsion = load_repulsion<D>(all.rest, own);
    if (all.explains) gradient = load_gradient<D>(all.rest, own);
  }

  template <class Kernel>
  SINEW_INLINE void meet(const int* offset) {
    const PlacePart<D> j = load_place<D>(sweep.pairs.motion, offset);
    const auto pair = MovingPair<D>::template along<Kernel>(j.x - place.x, sweep.pairs.radius);
    const StressPart<D> stress_j = load_stress<D>(sweep.stress, sweep.rest, more && sweep.lower, offset);
    const Pack weight = pair.weight * j.mass;
    Vec<Pack, D> share = (stress.T + stress_j.T) * pair.x;
    if constexpr (viscous || more) {
      const MotionPart<D> motion_j = load_motion<D>(sweep.pairs.motion, offset);
      const Vec<Pack, D> v = motion_j.v - motion.v;
      if (sweep.viscosity) {
        const Pack volume = 0.5 * (motion.specific_volume + motion_j.specific_volume);
        share -= resist_approach(pair, v, volume, 0.5 * (stress.sound_speed + stress_j.sound_speed), weight) * pair.x;
      }
      if constexpr (more) {
        if (sweep.repels) share += push_apart<Kernel>(pair, v, offset, weight);
        if (sweep.explains) resist_unexplained(pair, v, load_gradient<D>(sweep.rest, offset), weight * motion_j.specific_volume);
      }
    }
    acceleration += weight * share;
  }

 private:
  /// pi_ij, see ArtificialViscosity. `volume`: 1 / rho of the pair.
  SINEW_INLINE Pack resist_approach(const MovingPair<D>& pair, const Vec<Pack, D>& v, const Pack& volume, const Pack& sound_speed,
                                    const Pack& weight) {
    const Pack h(sweep.smoothing_length), mu = ArtificialViscosity::approach(pair.x, v, h);
    const Pack pi = volume * sweep.viscosity->strength(mu, sound_speed);
    viscous_power -= weight * pi * dot(pair.x, v);
    resistance += weight * volume * sweep.viscosity->resistance(pair.x, mu, h, sound_speed) * pair.distance;
    return pi;
  }
  /// ArtificialStress or ArtificialPressure.
  template <class Kernel>
  SINEW_INLINE Vec<Pack, D> push_apart(const MovingPair<D>& pair, const Vec<Pack, D>& v, const int* offset, const Pack& weight) {
    const Pack W = Kernel::template value<D>(pair.distance, sweep.pairs.radius) * sweep.range.inverse_weight;
    const Pack part = exp(sweep.range.exponent * log(W));
    const Vec<Pack, D> push = part * ((repulsion + load_repulsion<D>(sweep.rest, offset)) * pair.x);
    repulsive_power += weight * dot(push, v);
    return push;
  }
  /// The objective form of NonNestedShear.
  SINEW_INLINE void resist_unexplained(const MovingPair<D>& pair, const Vec<Pack, D>& v, const GradientPart<D>& gradient_j,
                                       const Pack& weight) {
    const Vec<Pack, D> middle = pair.x - Pack(sweep.half_step) * v;
    const Vec<Pack, D> e = v - 0.5 * ((gradient.L + gradient_j.L) * middle);
    pull += NonNestedShear::pull(pair.x, e, (0.5 * weight) * (gradient.modulus + gradient_j.modulus), 1.0 / pair.square);
  }
};

template <int D, class Kernel, bool viscous, bool more>
void sweep_slice(const ForceSweep<D>& sweep, const MovingSlice& slice) {
  MovingForces<D, viscous, more> forces(sweep, slice.own);
  for (int n = 0; n < slice.length; ++n) forces.template meet<Kernel>(slice.places + static_cast<std::ptrdiff_t>(lanes) * n);
  const SlotsOfSlice slots(sweep.pairs.neighbors, slice);
  const Pack mass = sweep.thickness * forces.place.mass;
  for (int c = 0; c < D; ++c) slots.add(mass * forces.acceleration[c], sweep.forces.component(c));
  if (sweep.repels) slots.store(0.5 * mass * forces.repulsive_power, sweep.repulsive_power);
  if (sweep.viscosity) {
    slots.store(0.5 * mass * forces.viscous_power, sweep.viscous_power);
    slots.store(forces.resistance, sweep.viscous_rate);
  }
  if (sweep.explains)
    for (int c = 0; c < D; ++c) slots.store(mass * forces.motion.specific_volume * forces.pull[c], sweep.pull.component(c));
}

template <class Sweep, class Work>
void sweep_all_slices(const Sweep& sweep, Work&& work) {
  std::visit(
      [&](const auto& kernel) { sweep.pairs.neighbors.for_each_slice([&](const MovingSlice& slice) { work(kernel, slice); }); },
      sweep.pairs.kernel);
}

template <int D>
void sweep_gradients(const GradientSweep<D>& sweep) {
  const bool more = sweep.corrected || sweep.shear;
  sweep_all_slices(sweep, [&]<class Kernel>(const Kernel&, const MovingSlice& slice) {
    more ? sweep_slice<D, Kernel, true>(sweep, slice) : sweep_slice<D, Kernel, false>(sweep, slice);
  });
}

template <int D>
void sweep_forces(const ForceSweep<D>& sweep) {
  const bool more = sweep.repels || sweep.explains || sweep.lower;
  sweep_all_slices(sweep, [&]<class Kernel>(const Kernel&, const MovingSlice& slice) {
    if (more)
      sweep_slice<D, Kernel, true, true>(sweep, slice);
    else if (sweep.viscosity)
      sweep_slice<D, Kernel, true, false>(sweep, slice);
    else
      sweep_slice<D, Kernel, false, false>(sweep, slice);
  });
}

}  // namespace sinew
