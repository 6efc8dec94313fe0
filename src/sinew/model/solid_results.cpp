#include <sinew/model/solid_simulation.hpp>

namespace sinew {

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
  if (stored_step_ != steps_) stored_ = solid_->stored_energy();
  stored_step_ = steps_;
  return stored_;
}

template <int D>
RecordedState& SolidSimulation<D>::room_for_record() {
  if (!record_) {
    record_ = std::make_unique<RecordedState>(particles_.slots);
    if (solid_->history().width() > 0) record_->inelastic = VectorField<4>(particles_.slots);
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
  if (recorded_step_ != steps_) solid_->record(particles_, state);
  recorded_step_ = steps_;
  return state;
}

template <int D>
std::vector<double> SolidSimulation<D>::probe_values() {
  const RecordedState* state = probes_.need_record() ? &record() : nullptr;
  return probes_.values(
      {comm_, particles_, *solid_, motion_, contacts_, state, energies(), momenta(), time_, stable_time_step()});
}

#define SINEW_INSTANTIATE(D)                                        \
  template Energies SolidSimulation<D>::energies();                 \
  template const Totals& SolidSimulation<D>::totals();              \
  template const StoredEnergy& SolidSimulation<D>::stored_energy(); \
  template RecordedState& SolidSimulation<D>::room_for_record();    \
  template const RecordedState& SolidSimulation<D>::record();       \
  template std::vector<double> SolidSimulation<D>::probe_values();
SINEW_INSTANTIATE(2)
SINEW_INSTANTIATE(3)

}  // namespace sinew
