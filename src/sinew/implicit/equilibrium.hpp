#pragma once
/// Balance of the forces on the particles of a case at one time, as equations for their displacements:
///
///     R(u) = -(internal + hourglass + external forces) = 0 at all components that are free;   u = the given value at the others
///
/// Materials go on from their histories at the beginning of a step. In motion the forces that are missing are those of inertia, see Newmark. Where the formulas of loads ask for the current place, the derivative leaves that out.

#include <sinew/formulations/boundary/loads.hpp>
#include <sinew/formulations/boundary/prescribed_motion.hpp>
#include <sinew/formulations/formulation.hpp>
#include <sinew/implicit/nonlinear_system.hpp>

namespace sinew {

/// Inertia and damping in a step that ends with the displacements u: a = mass (u - displacement), v = velocity + rate (u - displacement).
struct Inertia {
  double mass = 0.0;                           ///< [1/time^2]
  double rate = 0.0;                           ///< [1/time]
  double now = 1.0;                            ///< part of the forces that is of the end of the step
  double damping = 0.0;                        ///< every particle gets the force -damping m v [1/time]
  std::vector<double> displacement, velocity;  ///< of each unknown, without what this step's acceleration adds
  std::vector<double> force;                   ///< the part that is of its beginning
};

template <int D>
class Equilibrium final : public NonlinearSystem {
 public:
  /// All of it stays with the caller. `stiffness`: of a typical particle [force/length].
  Equilibrium(const Comm& comm, Particles<D>& particles, Formulation<D>& solid, Loads<D>& loads,
              const PrescribedMotion<D>& motion, double stiffness);

  /// From now on it is about a step of length dt that ends at `time`. `inertia`: nullptr for statics; stays with the caller.
  void set_step(double time, double dt, const Inertia* inertia);
  double mass_of(int unknown) const { return particles_.mass[slots_[unknown / D]]; }

  /// Displacements of the nodes of this rank.
  std::vector<double> displacements() const { return values_of(particles_.displacement); }
  void put(std::span<const double> u) { put(u, particles_.displacement); }
  /// The same of any field of the particles.
  std::vector<double> values_of(const VectorField<D>& field) const;
  void put(std::span<const double> values, VectorField<D>& field) const;
  bool is_given(int unknown) const { return is_given(slots_[unknown / D], unknown % D); }

  int dimension() const override { return D; }
  int nodes() const override { return static_cast<int>(slots_.size()); }
  std::vector<double> coordinates() const override;
  bool residual(std::span<const double> u, std::span<double> r) override;
  double most_scale() const { return most_scale_; }
  void restore_most_scale(double value) { most_scale_ = value; }
  double scale() const override { return inertia_ ? most_scale_ : scale_; }
  void product(std::span<const double> v, std::span<double> out) override;
  /// The part of the derivative that product() leaves out: of free components by changes of given ones.
  void product_of_given(std::span<const double> v, std::span<double> out);
  void for_each_matrix(bool exact, Use use) override;
  void for_each_group(bool exact, FunctionRef<void(std::span<const int>)> use) const override;
  const std::vector<int>& given() const override { return given_; }
  double given_diagonal() const override { return stiffness_; }

 private:
  using Reach = typename Formulation<D>::Reach;
  static Reach reach_of(bool exact) { return exact ? Reach::all : Reach::nearest; }
  PointStep point_step() const { return {dt_, HistoryUse::respond}; }
  void number_nodes();
  bool is_given(int slot, int component) const { return fixed_.at(component, slot) != 0.0; }
  /// Of the forces at the end of the step, and what the displacement of a particle adds by inertia, over its mass.
  double share_of_forces() const { return inertia_ ? inertia_->now : 1.0; }
  double inertial_stiffness() const {
    return inertia_ ? inertia_->mass + inertia_->now * inertia_->damping * inertia_->rate : 0.0;
  }
  template <class Value>
  void multiply(const Value& value, std::span<double> out);

  Comm comm_;
  Particles<D>& particles_;
  Formulation<D>& solid_;
  Loads<D>& loads_;
  std::vector<int> slots_;    ///< of each node
  std::vector<int> numbers_;  ///< of the node in a slot, through all ranks, copies included; -1: none
  VectorField<D> fixed_;      ///< 1 where a component is given, likewise
  std::vector<int> given_;    ///< unknowns of this rank
  VectorField<D> forces_, direction_;
  std::vector<double> group_matrix_;
  std::vector<int> group_;
  const Inertia* inertia_ = nullptr;
  double stiffness_, time_ = 0.0, dt_ = 0.0, scale_ = 0.0, most_scale_ = 0.0;  ///< most: of the run so far
};

extern template class Equilibrium<2>;
extern template class Equilibrium<3>;

}  // namespace sinew
