#pragma once
/// A case, built and able to run. The dimension is chosen here; nothing above knows it at compile time.

#include <functional>
#include <map>
#include <memory>
#include <sinew/model/case.hpp>
#include <sinew/parallel/plan.hpp>
#include <sinew/particles/snapshot.hpp>
#include <string>
#include <vector>

namespace sinew {

/// What a model is made of, for `check`, the log and the summary. Quantities in the case's own units.
struct ModelFacts {
  long particles = 0;
  long pairs = 0;  ///< directed pairs
  int neighbors_min = 0, neighbors_max = 0;
  double neighbors_mean = 0.0;
  double time_step = 0.0;       ///< stable step of the initial state
  std::string time_step_limit;  ///< "wave speed" or "hourglass stiffness" or "fixed"
  std::size_t memory_bytes = 0;
  double bytes_per_particle = 0.0;
  int blocks = 0;
  RanksPlan ranks;             ///< how the ranks share the case, and what they send each other in a step
  double lattice_share = 0.0;  ///< part of the slices of eight particles that go without a pair list
  int lattice_patterns = 0;
  std::string pair_weights;  ///< of the others: "stored", "single" or "computed"
  double setup_seconds = 0.0;
  struct Body {
    std::string name, material;
    long particles = 0;
    double volume = 0.0, mass = 0.0, spacing = 0.0;
    double longitudinal_wave_speed = 0.0, shear_wave_speed = 0.0;
  };
  std::vector<Body> bodies;
  std::map<std::string, long> regions;  ///< named region -> particles in it
  std::vector<std::string> warnings;
};

struct Energies {
  double kinetic = 0.0, strain = 0.0;
  double hourglass = 0.0;      ///< of the hourglass stiffness; a measure only for its central forms, which have no potential
  double contact = 0.0;        ///< of elastic contact
  double external_work = 0.0;  ///< of reactions, loads, moving walls and body force since the start
  double plastic_work = 0.0, damage_work = 0.0;
  double dissipated = 0.0;  ///< by damping, contact, plastic flow, damage, and what the hourglass stiffness has lost to it
  double initial = 0.0;     ///< total of the initial state
  double total() const { return kinetic + strain + hourglass + contact; }
  /// total + dissipated - external_work - initial: 0 for exact time integration, but for central hourglass forces.
  double balance_error() const { return total() + dissipated - external_work - initial; }
};

struct Momenta {
  Point linear, angular;      ///< sum m v, sum m x cross v (about the origin)
  double linear_scale = 0.0;  ///< sum m |v|, for judging the balance
};

/// Everything that a restart needs beside the case.
struct SavedState {
  double time = 0.0;
  long step = 0;
  std::map<std::string, double> numbers;
  std::map<std::string, std::vector<double>> arrays;  ///< the same on all ranks
  struct Field {
    int width = 1;
    std::vector<double> rows;
  };
  UserRange range;                      ///< of the user's order, that this rank has
  std::map<std::string, Field> fields;  ///< range.count rows of `width` numbers each
};

/// How one simulation follows another.
struct Handover {
  double balance_error = 0.0;  ///< of the energies of the one before
  bool settled = false;        ///< only stresses go on, with the particles at rest where they first were
};

/// Thrown by a step that was asked to stop; the state is that before it. On all ranks.
struct StepStopped {};

/// Where ranks share a case, every call that is not const is collective, and so is state_hash(). All ranks get the same answers, but for what has a value for each
/// particle.
class Simulation {
 public:
  /// Builds particles, neighbors, weights, regions and conditions, and evaluates the initial forces. Throws CaseError.
  static std::unique_ptr<Simulation> build(const Case& c, const Comm& comm = Comm());
  virtual ~Simulation() = default;

  virtual const ModelFacts& facts() const = 0;
  virtual double time() const = 0;
  virtual double end_time() const = 0;              ///< as far as it is known
  virtual std::string stage() const { return ""; }  ///< name of the present one; empty if there are none
  virtual long steps() const = 0;
  virtual double stable_time_step() const = 0;  ///< for the next step
  /// Steps that solve equations ask this, on all ranks, now and then, and throw StepStopped if it is so. Others are short.
  virtual void stop_when(const std::function<bool()>& /*stop*/) {}
  /// One step of min(stable_time_step(), most). Throws SimulationError when the state is no longer usable: time, particle, cause.
  virtual void step(double most) = 0;
  /// F and stresses of the state after the next step will be asked for: that step keeps them, so that it takes no sweep of its own.
  virtual void expect_record() = 0;

  // What follows costs about one step for a state when first asked; then it is kept until the next step.
  virtual Energies energies() = 0;
  virtual Momenta momenta() = 0;
  /// Sum of mass times acceleration, over the weight of all particles: what is missing to balance. Infinity without a constant body force.
  virtual double imbalance() = 0;
  virtual bool probes_need_record() const = 0;     ///< of F or stresses, see expect_record
  virtual std::vector<double> probe_values() = 0;  ///< of Case::probes, in order
  virtual std::vector<std::string> probe_units() const = 0;
  /// Into an empty snapshot, or one that this simulation filled before: its memory is used again, and what never changes (size, body,
  /// names, units) is kept. Where ranks share a case each gets a range of the particles.
  virtual void fill_snapshot(const std::vector<std::string>& fields, Snapshot& snapshot) = 0;
  /// Of all particles, on the root.
  virtual Snapshot snapshot(const std::vector<std::string>& fields) = 0;

  virtual std::string state_hash() const = 0;  ///< of positions and velocities of all particles, by their numbers
  virtual SavedState save() = 0;
  virtual void restore(const SavedState& state) = 0;
  /// Goes on from the last state of another simulation of the same bodies, with the conditions and materials of this one.
  virtual void take_over(SavedState state, const Handover& handover) = 0;
  /// What so many ranks would have to do and to send, counted for a process alone.
  virtual RanksPlan plan(int ranks) const = 0;
  virtual std::map<std::string, double> pass_seconds() const = 0;  ///< wall time of the passes of all steps so far
  /// Of steps that solve equations: newton_iterations, linear_iterations, cut_backs so far; matrix_entries. Empty for explicit ones.
  virtual std::map<std::string, double> equation_counts() { return {}; }
};

}  // namespace sinew
