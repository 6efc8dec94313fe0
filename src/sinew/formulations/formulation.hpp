#pragma once
/// What every formulation offers to the model: forces of the particles of a case from their motion, with what belongs to them.

#include <memory>
#include <optional>
#include <sinew/core/function_ref.hpp>
#include <sinew/formulations/gradient_form.hpp>
#include <sinew/formulations/history.hpp>
#include <sinew/formulations/stencil.hpp>
#include <sinew/neighbors/block_pairs.hpp>
#include <sinew/neighbors/cracks.hpp>
#include <sinew/parallel/share.hpp>
#include <span>
#include <string>

namespace sinew {

/// What one evaluation of the forces says about the state, over all particles of this rank.
struct ForceSummary {
  double strain_energy = 0.0;     ///< sum V psi [energy]; not finite if any particle is not
  double hourglass_energy = 0.0;  ///< measure of the energy in the hourglass stiffness [energy]
  double released =
      0.0;  ///< what the hourglass stiffness has lost since the last step by flow, or the held non-nested shear has taken [energy]
  double plastic_work = 0.0;   ///< dissipated in all of the past [energy]
  double damage_work = 0.0;    ///< likewise by damage [energy]
  double viscous_power = 0.0;  ///< taken by artificial viscosity, JST dissipation, artificial stress and pressure [energy/time]
  double smallest_jacobian = 1.0;  ///< min det F
  double largest_rate2 = 0.0;      ///< max of (fastest wave speed / length)^2 [1/time^2]
  bool fails = false;              ///< whether the damage of a particle has become 1 in this step
  bool finite = true;              ///< whether all of it is a number
};

/// Sum and extremes of all.
ForceSummary total_of(const std::vector<ForceSummary>& of_blocks);

/// Point-wise results in computing order, for files and probes.
struct RecordedState {
  VectorField<9> deformation_gradient;  ///< row-major
  VectorField<9> stress;                ///< first Piola-Kirchhoff, likewise
  AlignedArray<double> energy_density;
  AlignedArray<double> hourglass_error;  ///< largest |F X - x| / |X| over the neighbors; empty if nobody wants it
  VectorField<4>
      inelastic;  ///< plastic strain, plastic work [pressure], temperature [K], damage; empty if no material has a history
  explicit RecordedState(int slots) : deformation_gradient(slots), stress(slots), energy_density(slots) {}
};

/// Energies of all particles of all ranks.
struct StoredEnergy {
  double strain = 0.0, hourglass = 0.0, plastic_work = 0.0, damage_work = 0.0;
};

/// Numbers and fields by slot that a restart needs.
template <int D>
struct FieldsToSave {
  template <int width>
  struct Named {
    std::string name;
    VectorField<width>* field;
  };
  struct Number {
    std::string name;
    double* value;
  };
  std::vector<Number> numbers;  ///< the same on all ranks
  std::vector<Named<D>> vectors;
  std::vector<Named<D * D>> matrices;
};

/// One that works block by block, and ranks own whole blocks.
template <int D>
class Formulation {
 public:
  virtual ~Formulation() = default;
  Formulation(const Formulation&) = delete;
  Formulation& operator=(const Formulation&) = delete;

  // The following are collective, since something travels between the ranks.

  /// Called with slots [begin, end) whose forces are complete, as soon as they are, from any thread.
  using Finish = FunctionRef<void(int begin, int end)>;
  /// Adds the pair forces of the current motion to `forces`; the materials go on from their histories as `step` says. With
  /// `record` it keeps F, P and energies of every particle besides.
  virtual ForceSummary internal_forces(Particles<D>& particles, VectorField<D>& forces, PointStep step, Finish finish,
                                       RecordedState* record = nullptr) = 0;
  /// The same for what it keeps alone; histories stay.
  virtual ForceSummary record(Particles<D>& particles, RecordedState& state) = 0;
  /// Of the state of the last evaluation of the forces.
  StoredEnergy stored_energy() const;

  /// What is integrated in time begins with the initial state of the particles.
  virtual void begin(Particles<D>& particles) = 0;
  /// Whether the rates at the start need an evaluation of their own, once prescribed velocities are known.
  virtual bool needs_first_rates() const { return false; }
  /// Takes the particles, which have been put back to their first places, as without strain; stresses stay. For materials that are written in rates.
  virtual void settle(Particles<D>& particles) = 0;
  /// For integrators of several stages: what is integrated beside the displacements, see RungeKutta3.
  virtual void begin_stages() {}
  virtual void advance_stage(double /*begin*/, double /*rest*/, double /*dt*/) {}

  /// After an evaluation of the forces: cuts off the particles that have failed in it, if they are to separate, or renews the reference configuration, if that is due. The energy that
  /// this takes is `released` in the summaries. Returns whether there was anything to do.
  virtual bool rearrange(Particles<D>& /*particles*/) { return false; }
  /// Cuts off particles again at a restart. `failed`: {number, contact radius} of each; `most_stiffness`: as it was, see below.
  virtual void restore_cracks(const Particles<D>& /*particles*/, const std::vector<double>& /*failed*/,
                              const std::vector<double>& /*most_stiffness*/) {}

  // For implicit solvers, of formulations that offer it.

  /// From now on each evaluation of the forces keeps the deformation that belongs to it.
  virtual void keep_linearization(const Particles<D>& /*particles*/) {}
  /// Adds what the internal forces change by, to first order, if the last evaluated displacements change by those of `particles`; histories stay those of the beginning of `step`. Damage
  /// and velocities do not enter.
  virtual void tangent_forces(Particles<D>& /*particles*/, VectorField<D>& /*forces*/, PointStep /*step*/) {}
  /// The same as matrices, one of each particle of this rank, from the main thread: use(slots, matrix) with the particle and its neighbors, copies among them, and the derivative of minus the forces between
  /// them, row-major, D numbers a slot; see NodalStiffness. Reach::nearest: with no more of the nearest neighbors than a gradient needs, which is an operator like the other one that couples fewer particles.
  using UseStiffness = FunctionRef<void(std::span<const int> slots, std::span<const double> matrix)>;
  using UseStencil = FunctionRef<void(std::span<const int> slots)>;
  enum class Reach { all, nearest };
  virtual void for_each_stiffness(const Particles<D>& /*particles*/, Reach /*reach*/, PointStep /*step*/, UseStiffness /*use*/) {}
  virtual void for_each_stencil(const Particles<D>& /*particles*/, Reach /*reach*/, UseStencil /*use*/) const {}
  /// Of a particle of this rank, in the reference configuration of the beginning.
  virtual Stencil<D> stencil_of(const Particles<D>& /*particles*/, int /*slot*/) const { return {}; }

  // From here on, every rank for itself.

  virtual bool separates() const { return false; }      ///< any body
  virtual long reference_updates() const { return 0; }  ///< how often the reference configuration has been renewed
  const Cracks<D>& cracks() const { return cracks_; }
  /// Largest sum of the hourglass weights of a particle so far, of each body [1/length^2].
  virtual std::vector<double> most_stiffness() const { return {}; }

  /// Beside histories.
  virtual FieldsToSave<D> fields_to_save() { return {}; }
  /// To be called when these have come back. Collective.
  virtual void restored(Particles<D>& /*particles*/) {}

  /// Of the last evaluation, block by block.
  const std::vector<ForceSummary>& block_summaries() const { return summaries_; }
  HistoryStore& history() { return history_; }
  /// Upper limit of the time step from the hourglass stiffness, 2 / omega; infinity without it.
  virtual double hourglass_time_step() const { return infinity; }
  /// Fastest damping by JST dissipation [1/time].
  virtual double dissipation_rate() const { return 0.0; }
  /// sum_j V_j |dW/dr| / r X_ij: points from a particle to its neighbors in the reference configuration [1/length].
  virtual Vec<double, D> toward_neighbors(const Particles<D>& particles, int slot) const = 0;
  /// How the weights of pairs are kept.
  virtual std::string_view weights_name() const = 0;
  /// Sentences about what may go wrong, for a run that begins and for one that has failed.
  virtual std::vector<std::string> warnings() const { return {}; }
  virtual std::string advice() const = 0;
  virtual std::size_t bytes() const = 0;

  /// Of the reference configuration.
  const BlockPairs<D>& pairs() const { return pairs_; }
  const LatticePatterns<D>& lattice() const { return pairs_.lattice; }
  const Halo& halo() const { return halo_; }
  /// Brings the vectors of copies from the ranks that have them. Collective.
  void update_copies(VectorField<D>& field) {
    halo_.displacements.start(field);
    halo_.displacements.finish();
  }
  double thickness() const { return thickness_; }

 protected:
  Formulation(const Comm& comm, BlockPairs<D> pairs, Halo halo, HistoryStore history, double thickness)
      : comm_(comm),
        halo_(std::move(halo)),
        pairs_(std::move(pairs)),
        history_(std::move(history)),
        summaries_(pairs_.blocks.all.size()),
        thickness_(thickness) {}

  void settle_histories(const std::vector<AnyMaterial>& materials);

  Comm comm_;
  Halo halo_;
  BlockPairs<D> pairs_;
  HistoryStore history_;
  Cracks<D> cracks_;
  std::vector<ForceSummary> summaries_;  ///< one a block, of the last evaluation of the forces
  double thickness_ = 1.0;
};

/// Of the materials of all bodies and their damage.
template <int D>
std::vector<int> history_numbers(const std::vector<AnyMaterial>& materials, const std::vector<std::optional<AnyDamage>>& damages,
                                 bool plane_stress);

}  // namespace sinew
