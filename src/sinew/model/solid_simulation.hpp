#pragma once
/// The run of a case in D dimensions: explicit, implicit or static.

#include <exception>
#include <limits>
#include <optional>
#include <sinew/core/timer.hpp>
#include <sinew/formulations/angular_projection.hpp>
#include <sinew/implicit/implicit_solver.hpp>
#include <sinew/model/conditions.hpp>
#include <sinew/model/contacts.hpp>
#include <sinew/model/probes.hpp>
#include <sinew/model/simulation.hpp>
#include <sinew/model/solid_setup.hpp>
#include <sinew/model/totals.hpp>
#include <sinew/parallel/user_order.hpp>
#include <sinew/time/runge_kutta.hpp>
#include <sinew/time/step_size.hpp>
#include <sinew/time/velocity_verlet.hpp>

namespace sinew {

/// Where a state has lost its meaning.
struct WorstParticle {
  int slot = -1, number = std::numeric_limits<int>::max();  ///< number: in the user's order
  double measure = infinity, jacobian = 0.0;
};

template <int D>
class SolidSimulation final : public Simulation {
 public:
  SolidSimulation(const Case& c, const Comm& comm);

  const ModelFacts& facts() const override { return facts_; }
  double time() const override { return time_; }
  double end_time() const override { return case_.solver.end_time; }
  long steps() const override { return steps_; }
  double stable_time_step() const override { return implicit_ ? next_step_ : step_size_(summary_, contact_); }
  void step(double most) override;
  void stop_when(const std::function<bool()>& stop) override {
    if (implicit_) implicit_->stop_when(stop);
  }
  void expect_record() override { record_expected_ = true; }

  Energies energies() override;
  Momenta momenta() override { return totals().momenta; }
  double imbalance() override;
  bool probes_need_record() const override { return probes_.need_record(); }
  std::vector<double> probe_values() override;
  std::vector<std::string> probe_units() const override { return probes_.units(); }
  void fill_snapshot(const std::vector<std::string>& fields, Snapshot& snapshot) override;
  Snapshot snapshot(const std::vector<std::string>& fields) override;

  std::string state_hash() const override;
  SavedState save() override;
  void restore(const SavedState& state) override;
  void take_over(SavedState state, const Handover& handover) override;
  RanksPlan plan(int ranks) const override { return plan_for(solid_->pairs(), ranks); }
  std::map<std::string, double> pass_seconds() const override;
  std::map<std::string, double> equation_counts() override;

 private:
  SolidSimulation(const Case& c, const Comm& comm, const std::vector<GeneratedBody>& bodies, const Stopwatch& watch);
  SolidSimulation(const Case& c, const Comm& comm, const std::vector<GeneratedBody>& bodies, SolidSetup<D> setup,
                  const Stopwatch& watch);
  void start();
  void find_first_rates();
  void check_initial_state() const;
  void advance_in_stages(double dt);
  void make_implicit_solver();
  double solve_step(double most);
  void adapt_step(double dt, const NewtonResult& result);
  [[noreturn]] void fail_to_solve(double dt, const NewtonResult& result);
  void save_implicit(SavedState& state) const;
  void restore_implicit(const SavedState& state);
  bool is_static() const { return implicit_ && implicit_->is_static(); }
  void update_forces(double dt);
  ForceSummary internal_forces(PointStep step, const AccelerateAndKick<D>& kick, RecordedState* recorded);
  void mind_arrangement();
  void count_dissipation(double dt);
  void check_same_parts(const SavedState& state);
  void save_contacts(SavedState& state);
  void restore_contacts(const SavedState& state);
  void check_state();
  [[noreturn]] void fail(const std::string& cause);
  WorstParticle worst_particle();
  RecordedState& room_for_record();
  const RecordedState& record();
  const Totals& totals();
  const StoredEnergy& stored_energy();
  void describe(Snapshot& snapshot) const;
  void share_limits();
  /// Formulas of conditions may fail where they are evaluated, on the ranks that have those particles. These go on to where all can be told.
  template <class Action>
  void guard(Action&& action) {
    try {
      action();
    } catch (...) {
      if (!error_) error_ = std::current_exception();
    }
  }
  void collect_bodies(const std::vector<GeneratedBody>& bodies);
  void collect_ranks();
  void warn_of_supersonic_motion();
  void collect_facts(const std::vector<GeneratedBody>& bodies, double setup_seconds);

  Case case_;
  Comm comm_;
  ModelFacts facts_;
  Particles<D> particles_;
  Regions regions_;
  std::unique_ptr<Formulation<D>> solid_;
  VectorField<D> forces_;
  PrescribedMotion<D> motion_;
  Loads<D> loads_;
  Contacts<D> contacts_;
  Vec<double, D> gravity_;  ///< body force that is the same everywhere and always [length/time^2]
  Probes<D> probes_;
  StepSize step_size_;
  std::optional<RungeKuttaStep<D>> stages_;  ///< nothing: velocity Verlet
  std::optional<AngularProjection<D>> projection_;
  std::optional<ImplicitSolver<D>> implicit_;            ///< nothing: explicit
  double next_step_ = 0.0, largest_displacement_ = 0.0;  ///< next: to be tried
  ImplicitCounts counts_;
  UserOrder order_;
  PassTimer timer_{"drift", "boundary", "contact", "forces and kick", "rearrangement", "time step", "equations"};

  double time_ = 0.0;
  long steps_ = 0;
  ForceSummary summary_;  ///< of the current state; its limits (Jacobian, rate) are those of all ranks
  ContactSums contact_;   ///< of all ranks; only what limits the time step
  double first_time_step_ = 0.0;
  std::vector<double> dissipated_, dissipation_rate_;  ///< by damping and viscosity, of each block [energy], [energy/time]
  std::vector<double> kinetic_;                        ///< scratch
  double initial_energy_ = 0.0, initial_gravity_work_ = 0.0;
  std::unique_ptr<RecordedState> record_;
  std::exception_ptr error_;  ///< of this rank, for share_limits() to tell all
  bool record_expected_ = false, wants_hourglass_error_ = false;
  Totals totals_;
  StoredEnergy stored_;
  long recorded_step_ = -1, totals_step_ = -1, stored_step_ = -1;  ///< of which state they are
};

}  // namespace sinew
