#pragma once
/// Given forces on sets of particles: total forces, tractions and pressures on surfaces. All are dead loads: directions and areas are those of the
/// reference configuration.

#include <sinew/core/field_function.hpp>
#include <sinew/particles/particles.hpp>
#include <vector>

namespace sinew {

/// One component of a load: particle slots[k] receives share[k] * function [force].
struct LoadCondition {
  int component = 0;
  FieldFunction function;  ///< total force, or force per area
  std::vector<int> slots;
  std::vector<double> share;  ///< part of the total, or the area (times a component of the normal) of the particle
};

template <int D>
class Loads {
 public:
  Loads() = default;
  Loads(std::vector<LoadCondition> conditions, const Particles<D>& particles);

  void remember(const Particles<D>& particles);
  /// Adds the loads of time t to the forces and counts their work since `remember` (not at the start, where `dt` is 0).
  void add(const Particles<D>& particles, double t, double dt, VectorField<D>& forces);
  /// The same without counting: for the stages of a step.
  void add(const Particles<D>& particles, double t, VectorField<D>& forces);
  /// Done so far on the particles of each block [energy].
  const std::vector<double>& work() const { return work_; }
  /// Restart at time t: takes over the work; the forces follow from places and time.
  void restore(const Particles<D>& particles, double t, std::vector<double> work);

 private:
  struct Entry {
    int slot, block;
    double share, previous_u = 0.0, force = 0.0;
  };
  struct Applied {
    int component;
    FieldFunction function;
    std::vector<Entry> entries;
  };
  /// Calls use(applied, entry, force) with the force of time t.
  template <class Use>
  void for_each(const Particles<D>& particles, double t, Use&& use);

  std::vector<Applied> conditions_;
  std::vector<double> work_;
};

extern template class Loads<2>;
extern template class Loads<3>;

}  // namespace sinew
