/// Of SolidSimulation: what a run in stages needs.

#include <sinew/model/solid_simulation.hpp>

#include <cmath>

namespace sinew {

template <int D>
double SolidSimulation<D>::imbalance() {
  const double g = norm(gravity_);
  if (g == 0.0) return infinity;
  std::vector<double> sums;
  of_each_block<2>(
      particles_,
      [&](const BlockRange& block) -> std::array<double, 2> {
        Pack missing(0.0), weight(0.0);
        for_each_eight(block, [&](const EightOfBlock& eight) {
          const Vec<Pack, D> a = eight(particles_.acceleration);
          const Pack mass = eight(particles_.mass.data());
          missing += mass * sqrt(dot(a, a));
          weight += mass;
        });
        return {sum(missing), sum(weight)};
      },
      sums);
  sums = sum_over_blocks(comm_, particles_.block_numbers(), sums, 2);
  return sums[0] / (g * sums[1]);
}

namespace {

/// The first places, at rest, in the first configuration.
void put_back(SavedState& s) {
  for (const char* name : {"displacement", "velocity", "acceleration"}) {
    std::vector<double>& rows = s.fields.at(name).rows;
    std::fill(rows.begin(), rows.end(), 0.0);
  }
  if (const auto updates = s.numbers.find("reference_updates"); updates != s.numbers.end()) updates->second = 0.0;
}

}  // namespace

/// Energy that comes or goes by the new conditions and materials counts as if it had been there from the beginning: the balance stays as it was.
template <int D>
void SolidSimulation<D>::take_over(SavedState s, const Handover& handover) {
  if (handover.settled) put_back(s);
  restore(s);
  if (handover.settled) solid_->settle(particles_);
  guard([&] { motion_.move(particles_, time_, 0.0); });
  update_forces(0.0);
  recorded_step_ = totals_step_ = stored_step_ = -1;
  first_time_step_ = stable_time_step();
  check_initial_state();
  initial_energy_ += energies().balance_error() - handover.balance_error;
}

template double SolidSimulation<2>::imbalance();
template double SolidSimulation<3>::imbalance();
template void SolidSimulation<2>::take_over(SavedState, const Handover&);
template void SolidSimulation<3>::take_over(SavedState, const Handover&);

}  // namespace sinew
