/// Of SolidSimulation: restart, the hash of the state, and what is watched (a state that is no longer usable).

#include <sinew/model/fields.hpp>
#include <sinew/model/solid_simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <span>

namespace sinew {

namespace {

template <int D>
SavedState::Field in_users_order(const VectorField<D>& field, const UserOrder& order) {
  std::vector<double> rows;
  rows.reserve(order.slots().size() * D);
  for (int slot : order.slots())
    for (int c = 0; c < D; ++c) rows.push_back(field.at(c, slot));
  rows = order.to_range(rows, D);
  rows.resize(order.range().count * D);
  return {D, std::move(rows)};
}

template <int D>
void from_users_order(const SavedState::Field& in, const UserOrder& order, VectorField<D>& field) {
  const std::vector<double> rows = order.from_range(in.rows, D);
  std::size_t k = 0;
  for (int slot : order.slots())
    for (int c = 0; c < D; ++c) field.at(c, slot) = rows[k++];
}

/// Calls use(row, number, value) for all numbers of the histories of the particles, row by row of the order's slots.
template <int D, class Use>
void for_each_number(HistoryStore& history, const Particles<D>& particles, const UserOrder& order, Use&& use) {
  for (std::size_t row = 0; row < order.slots().size(); ++row) {
    const int slot = order.slots()[row], block = particles.block_of(slot);
    const HistorySlots of_block = history.of(block);
    for (int n = 0; n < history.numbers(block); ++n)
      use(row, n, of_block.values[static_cast<std::size_t>(n) * of_block.count + slot - of_block.first]);
  }
}

template <int D>
SavedState::Field in_users_order(HistoryStore& history, const Particles<D>& particles, const UserOrder& order) {
  const int width = history.width();
  std::vector<double> rows(order.slots().size() * width, 0.0);
  for_each_number(history, particles, order, [&](std::size_t row, int n, double value) { rows[row * width + n] = value; });
  rows = order.to_range(rows, width);
  rows.resize(order.range().count * width);
  return {width, std::move(rows)};
}

template <int D>
void from_users_order(const SavedState::Field& in, const Particles<D>& particles, const UserOrder& order, HistoryStore& history) {
  const std::vector<double> rows = order.from_range(in.rows, in.width);
  for_each_number(history, particles, order, [&](std::size_t row, int n, double& value) { value = rows[row * in.width + n]; });
}

/// Rows {condition, particle, value} by condition and particle.
std::vector<double> sorted_rows(const std::vector<double>& rows) {
  std::vector<std::array<double, 3>> sorted;
  for (std::size_t k = 0; k < rows.size(); k += 3) sorted.push_back({rows[k], rows[k + 1], rows[k + 2]});
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> all;
  for (const auto& row : sorted) all.insert(all.end(), row.begin(), row.end());
  return all;
}

/// The value of a row of them; 0 if there is none.
double value_of(const std::vector<double>& rows, int condition, int particle) {
  std::size_t begin = 0, end = rows.size() / 3;
  const auto before = [&](std::size_t row) {
    return rows[3 * row] != condition ? rows[3 * row] < condition : rows[3 * row + 1] < particle;
  };
  while (begin < end) {
    const std::size_t middle = (begin + end) / 2;
    if (before(middle))
      begin = middle + 1;
    else
      end = middle;
  }
  const bool found = 3 * begin < rows.size() && rows[3 * begin] == condition && rows[3 * begin + 1] == particle;
  return found ? rows[3 * begin + 2] : 0.0;
}

}  // namespace

/// For each particle a hash of its number and of the bits of x and v; their sum does not depend on an order.
template <int D>
std::string SolidSimulation<D>::state_hash() const {
  const auto mixed = [](std::uint64_t h) {  // the finalizer of SplitMix64 (Steele, Lea, Flood 2014)
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ULL;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebULL;
    return h ^ (h >> 31);
  };
  std::uint64_t sum = 0;
  for (int slot : order_.slots()) {
    auto hash = static_cast<std::uint64_t>(particles_.user_index[slot]) + 1;
    const auto add = [&](double value) {
      hash = mixed(hash + 0x9e3779b97f4a7c15ULL + std::bit_cast<std::uint64_t>(value + 0.0));  // -0 counts as 0
    };
    for (int c = 0; c < D; ++c) {
      add(particles_.current(slot)[c]);
      add(particles_.velocity.at(c, slot));
    }
    sum += hash;
  }
  return fmt::format("{:016x}", comm_.sum(sum));
}

template <int D>
SavedState SolidSimulation<D>::save() {
  SavedState s{time_, steps_, {}, {}, order_.range(), {}};
  s.fields["displacement"] = in_users_order(particles_.displacement, order_);
  s.fields["reference_position"] = in_users_order(particles_.position, order_);
  s.fields["velocity"] = in_users_order(particles_.velocity, order_);
  s.fields["acceleration"] = in_users_order(particles_.acceleration, order_);
  const FieldsToSave<D> fields = solid_->fields_to_save();
  for (const auto& [name, value] : fields.numbers) s.numbers[name] = *value;
  for (const auto& [name, field] : fields.vectors) s.fields[name] = in_users_order(*field, order_);
  for (const auto& [name, field] : fields.matrices) s.fields[name] = in_users_order(*field, order_);
  if (solid_->history().width() > 0) s.fields["history"] = in_users_order(solid_->history(), particles_, order_);
  std::vector<double> of_blocks, reactions;
  for (std::size_t b = 0; b < particles_.blocks.size(); ++b)
    of_blocks.insert(of_blocks.end(), {motion_.work()[b], loads_.work()[b], dissipated_[b], dissipation_rate_[b]});
  save_contacts(s);
  if (contacts_.any()) s.fields["contact_force"] = in_users_order(contacts_.forces(), order_);
  if (!solid_->cracks().empty()) {
    s.arrays["most_stiffness"] = solid_->most_stiffness();
    for (const auto& failed : solid_->cracks().all())
      s.arrays["failed"].insert(s.arrays["failed"].end(), {static_cast<double>(failed.number), failed.radius});
  }
  s.arrays["blocks"] = gather_over_blocks(comm_, particles_.block_numbers(), of_blocks, 4);
  for (const auto& r : motion_.reactions())
    reactions.insert(reactions.end(), {double(r.condition), double(particles_.user_index[r.slot]), r.value});
  s.arrays["reactions"] = sorted_rows(comm_.gather_all(reactions));
  s.numbers.insert({{"initial_energy", initial_energy_},
                    {"initial_gravity_work", initial_gravity_work_},
                    {"first_time_step", first_time_step_},
                    {"strain_energy", stored_energy().strain},
                    {"hourglass_energy", stored_energy().hourglass},
                    {"plastic_work", stored_energy().plastic_work},
                    {"damage_work", stored_energy().damage_work},
                    {"smallest_jacobian", summary_.smallest_jacobian},
                    {"largest_rate2", summary_.largest_rate2}});
  if (implicit_) save_implicit(s);
  return s;
}

template <int D>
void SolidSimulation<D>::restore(const SavedState& s) {
  const bool same = in_users_order(particles_.position, order_).rows == s.fields.at("reference_position").rows;
  comm_.together([&] {
    if (s.arrays.at("blocks").size() != 4 * static_cast<std::size_t>(facts_.blocks))
      throw CaseError("the checkpoint was written with another [solver] block_size. Resume with the same.");
    check_same_parts(s);
    if (!same)
      throw CaseError("the checkpoint belongs to other particles than the case makes now. Resume with the case that wrote it.");
  });
  from_users_order(s.fields.at("displacement"), order_, particles_.displacement);
  from_users_order(s.fields.at("velocity"), order_, particles_.velocity);
  from_users_order(s.fields.at("acceleration"), order_, particles_.acceleration);
  const FieldsToSave<D> fields = solid_->fields_to_save();
  for (const auto& [name, value] : fields.numbers) *value = s.numbers.at(name);
  for (const auto& [name, field] : fields.vectors) from_users_order(s.fields.at(name), order_, *field);
  for (const auto& [name, field] : fields.matrices) from_users_order(s.fields.at(name), order_, *field);
  if (solid_->history().width() > 0) from_users_order(s.fields.at("history"), particles_, order_, solid_->history());
  if (const auto failed = s.arrays.find("failed"); failed != s.arrays.end()) {
    solid_->restore_cracks(particles_, failed->second, s.arrays.at("most_stiffness"));
  }
  solid_->restored(particles_);
  mind_arrangement();
  time_ = s.time;
  steps_ = s.step;
  const std::vector<double>&of_blocks = s.arrays.at("blocks"), &reactions = s.arrays.at("reactions");
  std::vector<double> motion_work, load_work;
  for (std::size_t b = 0; b < particles_.blocks.size(); ++b) {
    const double* of_block = of_blocks.data() + 4 * std::size_t(particles_.blocks[b].number);
    motion_work.push_back(of_block[0]);
    load_work.push_back(of_block[1]);
    dissipated_[b] = of_block[2];
    dissipation_rate_[b] = of_block[3];
  }
  motion_.restore([&](int condition, int slot) { return value_of(reactions, condition, particles_.user_index[slot]); },
                  std::move(motion_work));
  if (loads_.follow()) solid_->update_copies(particles_.displacement);
  loads_.restore(particles_, time_, std::move(load_work));
  if (contacts_.any()) {
    restore_contacts(s);
    from_users_order(s.fields.at("contact_force"), order_, contacts_.forces());
  }
  initial_energy_ = s.numbers.at("initial_energy");
  initial_gravity_work_ = s.numbers.at("initial_gravity_work");
  first_time_step_ = s.numbers.at("first_time_step");
  summary_.smallest_jacobian = s.numbers.at("smallest_jacobian");
  summary_.largest_rate2 = s.numbers.at("largest_rate2");
  stored_ = {s.numbers.at("strain_energy"), s.numbers.at("hourglass_energy"), s.numbers.at("plastic_work"),
             s.numbers.at("damage_work")};
  if (implicit_) restore_implicit(s);
  recorded_step_ = totals_step_ = -1;
  stored_step_ = steps_;
}

/// Stops a run whose numbers have lost their meaning, at the step in which it happens.
template <int D>
void SolidSimulation<D>::check_state() {
  if (!summary_.finite) fail("a stress is not finite");
  if (summary_.smallest_jacobian <= 0.0) fail("its volume has become zero or negative (det F <= 0)");
  if (stable_time_step() < 1e-6 * first_time_step_) fail("the stable time step has fallen below a millionth of the first one");
}

/// The first, in the user's order, of the particles of this rank with the smallest det F; those where something is not finite come before.
template <int D>
WorstParticle SolidSimulation<D>::worst_particle() {
  recorded_step_ = -1;
  const RecordedState& state = record();
  const std::vector<int>& slots = order_.slots();
  std::vector<double> jacobian(slots.size());
  particle_quantity<D>("jacobian").values({particles_, *solid_, &state}, slots, {}, jacobian.data());
  WorstParticle worst;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const bool finite = std::isfinite(jacobian[k]) && std::isfinite(state.energy_density[slots[k]]);
    const WorstParticle here{slots[k], particles_.user_index[slots[k]], finite ? jacobian[k] : -infinity, jacobian[k]};
    if (here.measure < worst.measure || (here.measure == worst.measure && here.number < worst.number)) worst = here;
  }
  return worst;
}

/// The rank with the worst particle of all says what happened.
template <int D>
void SolidSimulation<D>::fail(const std::string& cause) {
  const WorstParticle worst = worst_particle();
  const double least = -comm_.maximum(-worst.measure);
  const double number = -comm_.maximum(worst.measure == least ? -worst.number : -infinity);
  const bool here = worst.measure == least && worst.number == number;
  std::string text;
  if (here) {
    const Point x = particles_.current(worst.slot);
    const BodyRange& body = particles_.bodies[particles_.body_of(worst.slot)];
    text = fmt::format(
        "unstable at time {:.6g} {}, step {}: particle {} of body \"{}\" at ({:.6g}, {:.6g}, {:.6g}): {} (det F = "
        "{:.3g}). Likely causes: a load "
        "or velocity that the particles cannot resolve, too large a time step (try [solver] cfl = {:.2g}), or {}.",
        time_, case_.general.units.name_of("s"), steps_, worst.number, body.name, x[0], x[1], x[2], cause, worst.jacobian,
        0.5 * case_.solver.cfl, solid_->advice());
  }
  comm_.together([&] {
    if (here) throw SimulationError(text);
  });
  std::abort();  // one of the ranks has it
}

template std::string SolidSimulation<2>::state_hash() const;
template std::string SolidSimulation<3>::state_hash() const;
template SavedState SolidSimulation<2>::save();
template SavedState SolidSimulation<3>::save();
template void SolidSimulation<2>::restore(const SavedState&);
template void SolidSimulation<3>::restore(const SavedState&);
template void SolidSimulation<2>::check_state();
template void SolidSimulation<3>::check_state();
template void SolidSimulation<2>::fail(const std::string&);
template void SolidSimulation<3>::fail(const std::string&);

}  // namespace sinew
