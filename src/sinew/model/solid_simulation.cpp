#include <sinew/model/solid_simulation.hpp>
#include <sinew/time/velocity_verlet.hpp>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace sinew {

namespace {

template <int D>
Particles<D> particles_of(const Case& c, const std::vector<GeneratedBody>& bodies) {
  std::vector<BodyPoints> points;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    points.push_back({c.bodies[b].name, &bodies[b].points,
                      std::visit([](const auto& m) { return m.density; }, c.bodies[b].material), bodies[b].spacing});
  return make_particles<D>(points, c.general.thickness);
}

template <int D>
std::vector<double> support_radii(const Case& c, const Particles<D>& particles) {
  if (c.formulation.neighbors) return radius_of_neighbors(particles, *c.formulation.neighbors);
  std::vector<double> radius(particles.slots, 0.0);
  for (const BodyRange& body : particles.bodies)
    for (int slot = body.begin; slot < body.end; ++slot)
      radius[slot] = c.formulation.support.value_or(FormulationCase::default_support) * body.spacing;
  return radius;
}

WeightStorage weight_storage(const std::string& name) {
  for (WeightStorage storage : {WeightStorage::stored, WeightStorage::single, WeightStorage::computed})
    if (name == name_of(storage)) return storage;
  return WeightStorage::automatic;
}

TotalLagrangianOptions options_of(const Case& c) {
  TotalLagrangianOptions options{
      .kernel = c.formulation.kernel, .correction = c.formulation.correction, .hourglass = {}, .materials = {}};
  options.plane_stress = c.general.plane == PlaneState::stress;
  options.thickness = c.general.thickness;
  for (const AnyStabilization& s : c.formulation.stabilizations)
    if (std::get<HourglassStiffness>(s).alpha > 0.0) options.hourglass = std::get<HourglassStiffness>(s);
  for (const BodyCase& body : c.bodies) options.materials.push_back(body.material);
  options.weights = weight_storage(c.solver.pair_weights);
  options.lattice = c.solver.lattice == "auto";
  if (c.general.dimension == 3) options.plane_stress = false, options.thickness = 1.0;
  return options;
}

}  // namespace

template <int D>
SolidSimulation<D>::SolidSimulation(const Case& c) : SolidSimulation(c, generate_bodies(c), Stopwatch{}) {}

template <int D>
SolidSimulation<D>::SolidSimulation(const Case& c, const std::vector<GeneratedBody>& bodies, const Stopwatch& watch)
    : case_(c),
      particles_(particles_of<D>(c, bodies)),
      regions_(select_regions(c, bodies, particles_)),
      solid_(particles_, support_radii(c, particles_), options_of(c)),
      forces_(particles_.slots),
      motion_(make_prescribed_motion(c, regions_, particles_, facts_.warnings)),
      loads_(make_loads(c, regions_, particles_, solid_, facts_.warnings)),
      gravity_(constant_body_force<D>(c)),
      probes_(c, regions_),
      step_size_{c.solver.cfl, solid_.hourglass_time_step(), c.solver.time_step.value_or(0.0)} {
  wants_hourglass_error_ = probes_.need_hourglass_error();
  set_initial_state(c, regions_, particles_);
  start();
  collect_facts(bodies, watch.seconds());
}

/// Forces and accelerations of the initial state, at time 0.
template <int D>
void SolidSimulation<D>::start() {
  motion_.remember(particles_);
  motion_.move(particles_, 0.0, 0.0);
  update_forces(0.0);
  initial_energy_ = energies().total();
  initial_gravity_work_ = gravity_work(gravity_, particles_);
  first_time_step_ = stable_time_step();
  if (!(summary_.smallest_jacobian > 0.0))
    throw CaseError(
        fmt::format("the initial state turns particles inside out (smallest det F = {:.3g}). Check [[initial]] displacement and "
                    "stretch, and the "
                    "displacements of [[boundary]] at time 0.",
                    summary_.smallest_jacobian));
}

template <int D>
void SolidSimulation<D>::step(double most) {
  const double dt = std::min(stable_time_step(), most);
  timer_.begin();
  motion_.remember(particles_);
  loads_.remember(particles_);
  timer_.mark("boundary");
  kick_and_drift(particles_, dt, case_.solver.damping);
  timer_.mark("drift");
  motion_.move(particles_, time_, dt);
  time_ += dt;
  ++steps_;
  update_forces(dt);
  check_state();
}

template <int D>
void SolidSimulation<D>::update_forces(double dt) {
  loads_.add(particles_, time_, dt, forces_);
  timer_.mark("boundary");
  RecordedState* const recorded = std::exchange(record_expected_, false) ? &room_for_record() : nullptr;
  summary_ = solid_.internal_forces(particles_, forces_,
                                    AccelerateAndKick<D>{particles_, forces_, gravity_, dt, case_.solver.damping}, recorded);
  if (recorded) recorded_step_ = steps_;
  timer_.mark("forces and kick");
  motion_.hold(particles_, time_, dt, case_.solver.damping);
  if (case_.solver.damping > 0.0) count_dissipation(dt);
  timer_.mark("boundary");
}

/// Trapezoidal rule for the power of the damping, c sum m v^2.
template <int D>
void SolidSimulation<D>::count_dissipation(double dt) {
  const double rate = 2.0 * case_.solver.damping * kinetic_energy(particles_);
  dissipated_ += 0.5 * dt * (dissipation_rate_ + rate);
  dissipation_rate_ = rate;
}

template <int D>
Energies SolidSimulation<D>::energies() {
  Energies e;
  e.kinetic = totals().kinetic;
  e.strain = summary_.strain_energy;
  e.hourglass = summary_.hourglass_energy;
  e.external_work = motion_.work() + loads_.work() + totals().gravity_work - initial_gravity_work_;
  e.dissipated = dissipated_;
  e.initial = initial_energy_;
  return e;
}

template <int D>
const Totals& SolidSimulation<D>::totals() {
  if (totals_step_ != steps_) totals_ = totals_of(particles_, gravity_);
  totals_step_ = steps_;
  return totals_;
}

template <int D>
RecordedState& SolidSimulation<D>::room_for_record() {
  if (!record_) record_ = std::make_unique<RecordedState>(particles_.slots);
  if (wants_hourglass_error_ && record_->hourglass_error.size() == 0) {
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
  return probes_.values({particles_, solid_, motion_, state, energies(), momenta(), time_, stable_time_step()});
}

template class SolidSimulation<2>;
template class SolidSimulation<3>;

std::unique_ptr<Simulation> Simulation::build(const Case& c) {
  if (c.general.dimension == 2) return std::make_unique<SolidSimulation<2>>(c);
  return std::make_unique<SolidSimulation<3>>(c);
}

}  // namespace sinew
