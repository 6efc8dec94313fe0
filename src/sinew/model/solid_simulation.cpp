#include <sinew/model/solid_options.hpp>
#include <sinew/model/solid_simulation.hpp>
#include <sinew/time/velocity_verlet.hpp>

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

}  // namespace

template <int D>
SolidSimulation<D>::SolidSimulation(const Case& c, const Comm& comm)
    : SolidSimulation(c, comm, bodies_of(c, comm), Stopwatch{}) {}

template <int D>
SolidSimulation<D>::SolidSimulation(const Case& c, const Comm& comm, const std::vector<GeneratedBody>& bodies,
                                    const Stopwatch& watch)
    : SolidSimulation(c, comm, bodies, set_up<D>(c, bodies, total_lagrangian_options(c), comm), watch) {}

template <int D>
SolidSimulation<D>::SolidSimulation(const Case& c, const Comm& comm, const std::vector<GeneratedBody>& bodies,
                                    SolidSetup<D> setup, const Stopwatch& watch)
    : case_(c),
      comm_(comm),
      particles_(std::move(setup.particles)),
      regions_(std::move(setup.regions)),
      solid_(particles_, std::move(setup.pairs), setup.support_radius, total_lagrangian_options(c), comm, std::move(setup.halo)),
      forces_(particles_.slots),
      motion_(make_prescribed_motion(c, regions_, particles_, comm, facts_.warnings)),
      loads_(make_loads(c, regions_, particles_, solid_, comm, facts_.warnings)),
      contacts_(make_contacts(c, particles_, setup.support_radius, comm)),
      gravity_(constant_body_force<D>(c)),
      probes_(c, regions_),
      step_size_{c.solver.cfl, solid_.hourglass_time_step(), c.solver.time_step.value_or(0.0)},
      order_(comm, particles_.user_index),
      dissipated_(particles_.blocks.size(), 0.0),
      dissipation_rate_(particles_.blocks.size(), 0.0) {
  if (c.solver.integrator == RungeKutta3::name) stages_.emplace(particles_.slots);
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
  update_forces(0.0);
  check_initial_contacts(case_, contacts_, particles_, comm_);
  first_time_step_ = stable_time_step();
  check_initial_state();
  comm_.together([&] { motion_.begin(particles_, first_time_step_, case_.solver.damping); });
  if (case_.solver.damping > 0.0) count_dissipation(0.0);
  initial_energy_ = energies().total() + energies().dissipated;
  initial_gravity_work_ = totals().gravity_work;
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
  const double dt = std::min(stable_time_step(), most);
  timer_.begin();
  motion_.remember(particles_);
  loads_.remember(particles_);
  timer_.mark("boundary");
  if (stages_) {
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
  for (const RungeKutta3::Stage& stage : RungeKutta3::stage) {
    const double when = time_ + stage.when * dt;
    stages_->advance(particles_, stage, dt, damping);
    timer_.mark("drift");
    guard([&] { motion_.impose(particles_, when, dt); });
    timer_.mark("boundary");
    if (&stage == &RungeKutta3::stage[RungeKutta3::stages - 1]) return;
    guard([&] { loads_.add(particles_, when, forces_); });
    timer_.mark("boundary");
    solid_.internal_forces(particles_, forces_, {stage.when * dt, HistoryUse::respond},
                           AccelerateAndKick<D>{particles_, forces_, gravity_, 0.0, 0.0});
    timer_.mark("forces and kick");
  }
}

template <int D>
void SolidSimulation<D>::update_forces(double dt) {
  guard([&] { loads_.add(particles_, time_, dt, forces_); });
  timer_.mark("boundary");
  guard([&] { contacts_.push(particles_, time_, dt, forces_); });
  timer_.mark("contact");
  RecordedState* const recorded = std::exchange(record_expected_, false) ? &room_for_record() : nullptr;
  const AccelerateAndKick<D> kick{particles_, forces_, gravity_, stages_ ? 0.0 : dt, stages_ ? 0.0 : case_.solver.damping};
  summary_ = solid_.internal_forces(particles_, forces_, {dt, HistoryUse::advance}, kick, recorded);
  if (recorded) recorded_step_ = steps_;
  timer_.mark("forces and kick");
  if (solid_.options().separates() && solid_.separate(particles_)) mind_cracks();
  timer_.mark("separation");
  for (std::size_t b = 0; b < dissipated_.size(); ++b)
    dissipated_[b] += solid_.block_summaries()[b].released + dt * solid_.block_summaries()[b].viscous_power;
  guard([&] { motion_.hold(particles_, time_, dt, case_.solver.damping); });
  if (case_.solver.damping > 0.0) count_dissipation(dt);
  timer_.mark("boundary");
  share_limits();
  timer_.mark("time step");
}

/// What depends on who sees whom.
template <int D>
void SolidSimulation<D>::mind_cracks() {
  contacts_.pairs().mind(solid_.cracks());
  step_size_.hourglass_limit = solid_.hourglass_time_step();
  recorded_step_ = -1;
}

/// Formulas of conditions may fail where they are evaluated, on the ranks that have those particles. These go on to where all can be told.
template <int D>
template <class Action>
void SolidSimulation<D>::guard(Action&& action) {
  try {
    action();
  } catch (...) {
    if (!error_) error_ = std::current_exception();
  }
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

/// Trapezoidal rule for the power of the damping, c sum m v^2.
template <int D>
void SolidSimulation<D>::count_dissipation(double dt) {
  kinetic_energies(particles_, kinetic_);
  for (std::size_t b = 0; b < kinetic_.size(); ++b) {
    const double rate = 2.0 * case_.solver.damping * kinetic_[b];
    dissipated_[b] += 0.5 * dt * (dissipation_rate_[b] + rate);
    dissipation_rate_[b] = rate;
  }
}

template <int D>
Energies SolidSimulation<D>::energies() {
  std::vector<double> partial;
  for (std::size_t b = 0; b < dissipated_.size(); ++b) {
    const ContactSums contact = contacts_.sums()[b];
    partial.insert(partial.end(),
                   {motion_.work()[b] + loads_.work()[b] + contact.work, dissipated_[b] + contact.dissipated, contact.energy});
  }
  const std::vector<double> sums = sum_over_blocks(comm_, particles_.block_numbers(), partial, 3);
  Energies e;
  e.kinetic = totals().kinetic;
  e.strain = stored_energy().strain;
  e.hourglass = stored_energy().hourglass;
  e.external_work = sums[0] + totals().gravity_work - initial_gravity_work_;
  e.contact = sums[2];
  e.plastic_work = stored_energy().plastic_work;
  e.damage_work = stored_energy().damage_work;
  e.dissipated = sums[1] + e.plastic_work + e.damage_work;
  e.initial = initial_energy_;
  return e;
}

template <int D>
const Totals& SolidSimulation<D>::totals() {
  if (totals_step_ != steps_) totals_ = totals_of(comm_, particles_, gravity_);
  totals_step_ = steps_;
  return totals_;
}

template <int D>
const StoredEnergy& SolidSimulation<D>::stored_energy() {
  if (stored_step_ != steps_) stored_ = solid_.stored_energy();
  stored_step_ = steps_;
  return stored_;
}

template <int D>
RecordedState& SolidSimulation<D>::room_for_record() {
  if (!record_) {
    record_ = std::make_unique<RecordedState>(particles_.slots);
    if (solid_.history().width() > 0) record_->inelastic = VectorField<4>(particles_.slots);
  }
  if (wants_hourglass_error_ && record_->hourglass_error.size() != static_cast<std::size_t>(particles_.slots)) {
    record_->hourglass_error = AlignedArray<double>(particles_.slots);
    recorded_step_ = -1;
  }
  return *record_;
}

template <int D>
const RecordedState& SolidSimulation<D>::record() {
  RecordedState& state = room_for_record();
  if (recorded_step_ != steps_) solid_.record(particles_, state);
  recorded_step_ = steps_;
  return state;
}

template <int D>
std::vector<double> SolidSimulation<D>::probe_values() {
  const RecordedState* state = probes_.need_record() ? &record() : nullptr;
  return probes_.values({comm_, particles_, solid_, motion_, contacts_, state, energies(), momenta(), time_, stable_time_step()});
}

/// Waiting for other ranks is part of "forces and kick".
template <int D>
std::map<std::string, double> SolidSimulation<D>::pass_seconds() const {
  std::map<std::string, double> seconds(timer_.seconds().begin(), timer_.seconds().end());
  if (!comm_.alone())
    seconds["waiting for other ranks"] = solid_.halo().displacements.seconds_waited() + solid_.halo().forces.seconds_waited();
  return seconds;
}

template class SolidSimulation<2>;
template class SolidSimulation<3>;

std::unique_ptr<Simulation> Simulation::build(const Case& c, const Comm& comm) {
  if (c.general.dimension == 2) return std::make_unique<SolidSimulation<2>>(c, comm);
  return std::make_unique<SolidSimulation<3>>(c, comm);
}

}  // namespace sinew
