/// Of SolidSimulation: what leaves it (files, restart) and what is watched (a state that is no longer usable).

#include <sinew/model/fields.hpp>
#include <sinew/model/solid_simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

namespace sinew {

namespace {

template <int D>
std::vector<double> in_users_order(const VectorField<D>& field, const Particles<D>& particles) {
  std::vector<double> out(particles.slot_of.size() * D);
  for (int slot = 0; slot < particles.slots; ++slot)  // in computing order, as in fill
    if (const int i = particles.user_index[slot]; i >= 0)
      for (int c = 0; c < D; ++c) out[std::size_t(i) * D + c] = field.at(c, slot);
  return out;
}

template <int D>
void from_users_order(const std::vector<double>& in, const std::vector<int>& slots, VectorField<D>& field) {
  std::size_t k = 0;
  for (int slot : slots)
    for (int c = 0; c < D; ++c) field.at(c, slot) = in.at(k++);
}

/// A quantity of all particles, and where it goes.
template <int D>
struct Output {
  ParticleQuantity<D> quantity;
  double* values;
};

/// Block by block, so that what one quantity has read (F, P) is in the cache for the next; in computing order, since more is read than written.
template <int D>
void fill(const std::vector<Output<D>>& outputs, const QuantitySource<D>& source) {
  constexpr int block = 256;
  const std::vector<int>& user_index = source.particles.user_index;
  const int end = source.particles.slots;
#pragma omp parallel for schedule(static) if (source.particles.count >= fewest_for_threads)
  for (int begin = 0; begin < end; begin += block) {
    std::array<int, block> slots, rows;
    std::size_t count = 0;
    for (int slot = begin; slot < std::min(begin + block, end); ++slot)
      if (user_index[slot] >= 0) slots[count] = slot, rows[count++] = user_index[slot];
    for (const Output<D>& out : outputs) out.quantity.values(source, {slots.data(), count}, {rows.data(), count}, out.values);
  }
}

/// What a failed run may try about its zero-energy modes.
std::string hourglass_advice(const std::optional<HourglassStiffness>& hourglass) {
  if (!hourglass) return "zero-energy modes, which nothing controls (try stabilization = [{ model = \"hourglass_stiffness\" }])";
  if (!hourglass->conservative())
    return "the central hourglass force, which can feed motion (try normalization = \"conservative\")";
  return "zero-energy modes (try a larger alpha of hourglass_stiffness)";
}

}  // namespace

/// What never changes while a simulation runs.
template <int D>
void SolidSimulation<D>::describe(Snapshot& s) const {
  s.dimension = D;
  s.length_unit = case_.general.units.name_of("m");
  s.time_unit = case_.general.units.name_of("s");
  for (const BodyRange& body : particles_.bodies) s.body_names.push_back(body.name);
  for (int slot : particles_.slot_of) {
    s.size.push_back(std::pow(particles_.volume[slot], 1.0 / D));
    s.body.push_back(particles_.body_of(slot));
  }
}

template <int D>
void SolidSimulation<D>::fill_snapshot(const std::vector<std::string>& fields, Snapshot& s) {
  const std::size_t count = particles_.slot_of.size();
  if (s.body.empty()) describe(s);
  s.time = time_;
  s.step = steps_;
  s.position.resize(count);
  s.fields.resize(fields.size());
  std::vector<Output<D>> outputs{{particle_quantity<D>("position"), s.position.front().c}};
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const ParticleQuantity<D> quantity = particle_quantity<D>(fields[f]);
    s.fields[f].name = fields[f];
    s.fields[f].unit = case_.general.units.name_of(find_quantity(fields[f])->unit);
    s.fields[f].components = quantity.components;
    s.fields[f].values.resize(count * quantity.components);
    outputs.push_back({quantity, s.fields[f].values.data()});
  }
  if (std::find(fields.begin(), fields.end(), "hourglass_error") != fields.end()) wants_hourglass_error_ = true;
  const bool recorded = std::any_of(fields.begin(), fields.end(), [](const std::string& name) { return needs_record(name); });
  fill(outputs, {particles_, solid_, recorded ? &record() : nullptr});
}

/// FNV-1a of the bits of x and v, in the user's order.
template <int D>
std::string SolidSimulation<D>::state_hash() const {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add = [&hash](double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);  // -0 counts as 0
    for (int byte = 0; byte < 8; ++byte) hash = (hash ^ ((bits >> (8 * byte)) & 0xff)) * 0x100000001b3ULL;
  };
  for (int slot : particles_.slot_of)
    for (int c = 0; c < D; ++c) {
      add(particles_.current(slot)[c]);
      add(particles_.velocity.at(c, slot));
    }
  return fmt::format("{:016x}", hash);
}

template <int D>
SavedState SolidSimulation<D>::save() const {
  SavedState s{time_, steps_, {}, {}};
  s.arrays["displacement"] = in_users_order(particles_.displacement, particles_);
  s.arrays["reference_position"] = in_users_order(particles_.position, particles_);
  s.arrays["velocity"] = in_users_order(particles_.velocity, particles_);
  s.arrays["acceleration"] = in_users_order(particles_.acceleration, particles_);
  s.arrays["reactions"] = motion_.reactions();
  s.arrays["loads"] = loads_.forces();
  s.numbers = {{"reaction_work", motion_.work()},
               {"load_work", loads_.work()},
               {"dissipated", dissipated_},
               {"dissipation_rate", dissipation_rate_},
               {"initial_energy", initial_energy_},
               {"initial_gravity_work", initial_gravity_work_},
               {"first_time_step", first_time_step_},
               {"strain_energy", summary_.strain_energy},
               {"hourglass_energy", summary_.hourglass_energy},
               {"smallest_jacobian", summary_.smallest_jacobian},
               {"largest_rate2", summary_.largest_rate2}};
  return s;
}

template <int D>
void SolidSimulation<D>::restore(const SavedState& s) {
  if (in_users_order(particles_.position, particles_) != s.arrays.at("reference_position"))
    throw CaseError("the checkpoint belongs to other particles than the case makes now. Resume with the case that wrote it.");
  from_users_order(s.arrays.at("displacement"), particles_.slot_of, particles_.displacement);
  from_users_order(s.arrays.at("velocity"), particles_.slot_of, particles_.velocity);
  from_users_order(s.arrays.at("acceleration"), particles_.slot_of, particles_.acceleration);
  motion_.restore(s.arrays.at("reactions"), s.numbers.at("reaction_work"));
  loads_.restore(s.arrays.at("loads"), s.numbers.at("load_work"));
  time_ = s.time;
  steps_ = s.step;
  dissipated_ = s.numbers.at("dissipated");
  dissipation_rate_ = s.numbers.at("dissipation_rate");
  initial_energy_ = s.numbers.at("initial_energy");
  initial_gravity_work_ = s.numbers.at("initial_gravity_work");
  first_time_step_ = s.numbers.at("first_time_step");
  summary_ = {s.numbers.at("strain_energy"), s.numbers.at("hourglass_energy"), s.numbers.at("smallest_jacobian"),
              s.numbers.at("largest_rate2")};
  recorded_step_ = totals_step_ = -1;
}

/// Stops a run whose numbers have lost their meaning, at the step in which it happens.
template <int D>
void SolidSimulation<D>::check_state() {
  if (!std::isfinite(summary_.strain_energy)) fail("a stress is not finite");
  if (summary_.smallest_jacobian <= 0.0) fail("its volume has become zero or negative (det F <= 0)");
  if (stable_time_step() < 1e-6 * first_time_step_) fail("the stable time step has fallen below a millionth of the first one");
}

template <int D>
void SolidSimulation<D>::fail(const std::string& cause) {
  recorded_step_ = -1;
  const RecordedState& state = record();
  std::vector<double> jacobian(particles_.slot_of.size());
  particle_quantity<D>("jacobian").values({particles_, solid_, &state}, particles_.slot_of, {}, jacobian.data());
  std::size_t worst_number = 0;
  double least = infinity;
  for (std::size_t i = 0; i < jacobian.size(); ++i) {
    const bool finite = std::isfinite(jacobian[i]) && std::isfinite(state.energy_density[particles_.slot_of[i]]);
    const double measure = finite ? jacobian[i] : -infinity;
    if (measure < least) least = measure, worst_number = i;
  }
  const int worst = particles_.slot_of[worst_number];
  const Point x = particles_.current(worst);
  const BodyRange& body = particles_.bodies[particles_.body_of(worst)];
  throw SimulationError(
      fmt::format("unstable at time {:.6g} {}, step {}: particle {} of body \"{}\" at ({:.6g}, {:.6g}, {:.6g}): {} (det F = "
                  "{:.3g}). Likely causes: a load "
                  "or velocity that the particles cannot resolve, too large a time step (try [solver] cfl = {:.2g}), or {}.",
                  time_, case_.general.units.name_of("s"), steps_, particles_.user_index[worst], body.name, x[0], x[1], x[2],
                  cause, jacobian[worst_number], 0.5 * case_.solver.cfl, hourglass_advice(solid_.options().hourglass)));
}

template void SolidSimulation<2>::fill_snapshot(const std::vector<std::string>&, Snapshot&);
template void SolidSimulation<3>::fill_snapshot(const std::vector<std::string>&, Snapshot&);
template std::string SolidSimulation<2>::state_hash() const;
template std::string SolidSimulation<3>::state_hash() const;
template SavedState SolidSimulation<2>::save() const;
template SavedState SolidSimulation<3>::save() const;
template void SolidSimulation<2>::restore(const SavedState&);
template void SolidSimulation<3>::restore(const SavedState&);
template void SolidSimulation<2>::check_state();
template void SolidSimulation<3>::check_state();
template void SolidSimulation<2>::fail(const std::string&);
template void SolidSimulation<3>::fail(const std::string&);

}  // namespace sinew
