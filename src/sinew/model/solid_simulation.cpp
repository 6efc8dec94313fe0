#include <sinew/model/solid_simulation.hpp>
#include <sinew/model/staged_simulation.hpp>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace sinew {

namespace {

std::vector<GeneratedBody> bodies_of(const Case& c, const Comm& comm) {
  std::vector<GeneratedBody> bodies;
  comm.together([&] { bodies = generate_bodies(c, comm); });
  return bodies;
}

/// Rate of damping times time step that the integrator can do with.
double borne_damping(const Case& c) { return c.solver.integrator == RungeKutta3::name ? 2.5 : 1.25; }

}  // namespace

template <int D>
SolidSimulation<D>::SolidSimulation(const Case& c, const Comm& comm)
    : SolidSimulation(c, comm, bodies_of(c, comm), Stopwatch{}) {}

template <int D>
SolidSimulation<D>::SolidSimulation(const Case& c, const Comm& comm, const std::vector<GeneratedBody>& bodies,
                                    const Stopwatch& watch)
    : SolidSimulation(c, comm, bodies, set_up<D>(c, bodies, comm), watch) {}

template <int D>
SolidSimulation<D>::SolidSimulation(const Case& c, const Comm& comm, const std::vector<GeneratedBody>& bodies,
                                    SolidSetup<D> setup, const Stopwatch& watch)
    : case_(c),
      comm_(comm),
      particles_(std::move(setup.particles)),
      regions_(std::move(setup.regions)),
      solid_(std::move(setup.solid)),
      forces_(particles_.slots),
      motion_(make_prescribed_motion(c, regions_, particles_, comm, facts_.warnings)),
      loads_(make_loads(c, regions_, particles_, *solid_, comm, facts_.warnings)),
      contacts_(make_contacts(c, particles_, setup.support_radius, comm)),
      gravity_(constant_body_force<D>(c)),
      probes_(c, regions_),
      step_size_{c.solver.cfl, solid_->hourglass_time_step(), borne_damping(c) / solid_->dissipation_rate(),
                 c.solver.time_step.value_or(0.0)},
      order_(comm, particles_.user_index),
      dissipated_(particles_.blocks.size(), 0.0),
      dissipation_rate_(particles_.blocks.size(), 0.0) {
  if (c.solver.integrator == RungeKutta3::name) stages_.emplace(particles_.slots);
  if (c.formulation.project_angular_momentum) projection_.emplace();
  if (!c.solver.is_explicit()) make_implicit_solver();
  wants_hourglass_error_ = probes_.need_hourglass_error();
  set_initial_state(c, regions_, comm, particles_);
  start();
  collect_facts(bodies, watch.seconds());
}

/// Forces and accelerations of the initial state, at time 0.
template <int D>
void SolidSimulation<D>::start() {
  motion_.remember(particles_);
  guard([&] { motion_.move(particles_, 0.0, 0.0); });
  solid_->begin(particles_);
  update_forces(0.0);
  check_initial_contacts(case_, contacts_, particles_, comm_);
  first_time_step_ = stable_time_step();
  check_initial_state();
  if (!is_static()) comm_.together([&] { motion_.begin(particles_, first_time_step_, case_.solver.damping); });
  if (solid_->needs_first_rates()) find_first_rates();
  count_dissipation(0.0);
  initial_energy_ = energies().total() + energies().dissipated;
  initial_gravity_work_ = totals().gravity_work;
}

/// Of gradients that are integrated in time, now that prescribed particles have their velocities.
template <int D>
void SolidSimulation<D>::find_first_rates() {
  solid_->internal_forces(particles_, forces_, {0.0, HistoryUse::respond}, [](int, int) {});
  forces_.clear();
}

template <int D>
void SolidSimulation<D>::check_initial_state() const {
  comm_.together([&] {
    if (!std::isfinite(first_time_step_))
      throw CaseError("nothing limits the time step: all bodies are rigid. Give [solver] time_step.");
    if (summary_.smallest_jacobian > 0.0) return;
    throw CaseError(
        fmt::format("the initial state turns particles inside out (smallest det F = {:.3g}). Check [[initial]] displacement and "
                    "stretch, and the "
                    "displacements of [[boundary]] at time 0.",
                    summary_.smallest_jacobian));
  });
}

template <int D>
void SolidSimulation<D>::step(double most) {
  double dt = std::min(stable_time_step(), most);
  timer_.begin();
  motion_.remember(particles_);
  loads_.remember(particles_);
  timer_.mark("boundary");
  if (implicit_) {
    dt = solve_step(most);
    timer_.mark("equations");
  } else if (stages_) {
    advance_in_stages(dt);
  } else {
    kick_and_drift(particles_, dt, case_.solver.damping);
    timer_.mark("drift");
    guard([&] { motion_.move(particles_, time_, dt); });
  }
  time_ += dt;
  ++steps_;
  update_forces(dt);
  check_state();
}

/// All stages of a step, each with new forces but for the last, of which they belong to the new state. Histories stay those of the beginning.
template <int D>
void SolidSimulation<D>::advance_in_stages(double dt) {
  const double damping = case_.solver.damping;
  stages_->begin(particles_);
  solid_->begin_stages();
  for (const RungeKutta3::Stage& stage : RungeKutta3::stage) {
    const double when = time_ + stage.when * dt;
    stages_->advance(particles_, stage, dt, damping);
    solid_->advance_stage(stage.begin, stage.rest, dt);
    timer_.mark("drift");
    guard([&] { motion_.impose(particles_, when, dt); });
    timer_.mark("boundary");
    if (&stage == &RungeKutta3::stage[RungeKutta3::stages - 1]) return;
    if (loads_.follow()) solid_->update_copies(particles_.displacement);
    guard([&] { loads_.add(particles_, when, forces_); });
    timer_.mark("boundary");
    internal_forces({stage.when * dt, HistoryUse::respond}, {particles_, forces_, gravity_, 0.0, 0.0}, nullptr);
    timer_.mark("forces and kick");
  }
}

/// Adds the internal forces to those that are there, and kicks.
template <int D>
ForceSummary SolidSimulation<D>::internal_forces(PointStep step, const AccelerateAndKick<D>& kick, RecordedState* recorded) {
  if (!projection_) return solid_->internal_forces(particles_, forces_, step, kick, recorded);
  projection_->begin(comm_, particles_, forces_);
  const ForceSummary summary = solid_->internal_forces(
      particles_, forces_, step, [](int, int) {}, recorded);
  projection_->project(comm_, particles_, forces_);
  for_each_piece(particles_.slots, kick);
  return summary;
}

template <int D>
void SolidSimulation<D>::update_forces(double dt) {
  if (loads_.follow()) solid_->update_copies(particles_.displacement);
  guard([&] { loads_.add(particles_, time_, dt, forces_); });
  timer_.mark("boundary");
  guard([&] { contacts_.push(particles_, time_, dt, forces_); });
  timer_.mark("contact");
  RecordedState* const recorded = std::exchange(record_expected_, false) ? &room_for_record() : nullptr;
  const bool kicks = !stages_ && !implicit_;
  const AccelerateAndKick<D> kick{particles_, forces_, gravity_, kicks ? dt : 0.0, kicks ? case_.solver.damping : 0.0};
  summary_ = internal_forces({dt, HistoryUse::advance}, kick, recorded);
  if (recorded) recorded_step_ = steps_;
  timer_.mark("forces and kick");
  if (solid_->rearrange(particles_)) mind_arrangement();
  timer_.mark("rearrangement");
  if (implicit_ && !is_static()) implicit_->put_accelerations();
  if (is_static())
    motion_.hold_still(particles_, dt > 0.0);
  else
    guard([&] { motion_.hold(particles_, time_, dt, case_.solver.damping); });
  if (time_ > 0.0) count_dissipation(dt);
  timer_.mark("boundary");
  share_limits();
  timer_.mark("time step");
}

/// What depends on who sees whom.
template <int D>
void SolidSimulation<D>::mind_arrangement() {
  if (solid_->separates()) contacts_.pairs().mind(solid_->cracks());
  step_size_.hourglass_limit = solid_->hourglass_time_step();
  recorded_step_ = -1;
}

/// What steers the run is the largest of all ranks.
template <int D>
void SolidSimulation<D>::share_limits() {
  contact_ = {};
  for (std::size_t b = 0; b < particles_.blocks.size(); ++b) {
    contact_.rate2 = std::max(contact_.rate2, contacts_.sums()[b].rate2);
    contact_.approach = std::max(contact_.approach, contacts_.sums()[b].approach);
  }
  double limits[] = {summary_.finite ? 0.0 : 1.0,
                     -summary_.smallest_jacobian,
                     summary_.largest_rate2,
                     error_ ? 1.0 : 0.0,
                     contact_.rate2,
                     contact_.approach};
  comm_.maximum(limits);
  if (limits[3] > 0.0)
    comm_.together([&] {
      if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    });
  summary_.finite = limits[0] == 0.0;
  summary_.smallest_jacobian = -limits[1];
  summary_.largest_rate2 = limits[2];
  contact_.rate2 = limits[4];
  contact_.approach = limits[5];
}

/// What the hourglass stiffness has lost, and by the trapezoidal rule the powers of damping, c sum m v^2, viscosity and JST dissipation.
template <int D>
void SolidSimulation<D>::count_dissipation(double dt) {
  const double damping = case_.solver.damping;
  if (damping > 0.0) kinetic_energies(particles_, kinetic_);
  for (std::size_t b = 0; b < dissipated_.size(); ++b) {
    const ForceSummary& block = solid_->block_summaries()[b];
    const double rate = block.viscous_power + (damping > 0.0 ? 2.0 * damping * kinetic_[b] : 0.0);
    dissipated_[b] += block.released + 0.5 * dt * (dissipation_rate_[b] + rate);
    dissipation_rate_[b] = rate;
  }
}

/// Waiting for other ranks is part of "forces and kick".
template <int D>
std::map<std::string, double> SolidSimulation<D>::pass_seconds() const {
  std::map<std::string, double> seconds(timer_.seconds().begin(), timer_.seconds().end());
  if (!comm_.alone())
    seconds["waiting for other ranks"] = solid_->halo().displacements.seconds_waited() +
                                         solid_->halo().matrices.seconds_waited() + solid_->halo().forces.seconds_waited();
  return seconds;
}

template class SolidSimulation<2>;
template class SolidSimulation<3>;

std::unique_ptr<Simulation> Simulation::build(const Case& c, const Comm& comm) {
  if (!c.stages.empty()) return std::make_unique<StagedSimulation>(c, comm);
  if (c.general.dimension == 2) return std::make_unique<SolidSimulation<2>>(c, comm);
  return std::make_unique<SolidSimulation<3>>(c, comm);
}

}  // namespace sinew
