#pragma once
/// Given forces on sets of particles: total forces, tractions and pressures on surfaces. Directions and areas are those of the reference configuration, but for pressures that follow
/// the surface.

#include <sinew/core/field_function.hpp>
#include <sinew/core/function_ref.hpp>
#include <sinew/formulations/stencil.hpp>
#include <sinew/particles/particles.hpp>
#include <span>
#include <vector>

namespace sinew {

/// One component of a load: particle slots[k] receives share[k] * function [force].
struct LoadCondition {
  int component = 0;
  FieldFunction function;  ///< total force, or force per area
  std::vector<int> slots;
  std::vector<double> share;  ///< part of the total, or the area (times a component of the normal) of the particle
};

/// A pressure that follows the surface: a particle with the area A and the outward normal N before deformation receives -p A J F^-T N, F from its own stencil.
template <int D>
struct FollowerCondition {
  struct Surface {
    Stencil<D> stencil;
    Vec<double, D> normal_area;  ///< A N [length^(D-1)], times the thickness in 2D
  };
  FieldFunction pressure;
  std::vector<Surface> surfaces;
};

/// Of the loads that follow: displacements of copies of other ranks have to be up to date.
template <int D>
class Loads {
 public:
  Loads() = default;
  Loads(std::vector<LoadCondition> conditions, std::vector<FollowerCondition<D>> followers, const Particles<D>& particles);
  bool follow() const { return !followers_.empty(); }

  void remember(const Particles<D>& particles);
  /// Adds the loads of time t to the forces and counts their work since `remember` (not at the start, where `dt` is 0).
  void add(const Particles<D>& particles, double t, double dt, VectorField<D>& forces);
  /// The same without counting: for the stages of a step.
  void add(const Particles<D>& particles, double t, VectorField<D>& forces);
  /// Adds what the loads that follow change by if the displacements of `particles` change by `direction`.
  void add_change(const Particles<D>& particles, const VectorField<D>& direction, double t, VectorField<D>& forces) const;
  /// The derivative of minus these loads as matrices; see Formulation::for_each_stiffness.
  void for_each_stiffness(const Particles<D>& particles, double t,
                          FunctionRef<void(std::span<const int> slots, std::span<const double> matrix)> use) const;
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

  struct Follower {
    FollowerCondition<D> condition;
    std::vector<Vec<double, D>> previous_u, force;
  };
  void add_followers(const Particles<D>& particles, double t, double dt, VectorField<D>& forces);

  std::vector<Applied> conditions_;
  std::vector<Follower> followers_;
  std::vector<double> work_;
};

extern template class Loads<2>;
extern template class Loads<3>;

}  // namespace sinew
