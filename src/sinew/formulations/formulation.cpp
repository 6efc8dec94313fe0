#include <sinew/formulations/formulation.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {

ForceSummary total_of(const std::vector<ForceSummary>& of_blocks) {
  ForceSummary total;
  for (const ForceSummary& part : of_blocks) {
    total.strain_energy += part.strain_energy;
    total.hourglass_energy += part.hourglass_energy;
    total.released += part.released;
    total.plastic_work += part.plastic_work;
    total.damage_work += part.damage_work;
    total.viscous_power += part.viscous_power;
    total.smallest_jacobian = std::min(total.smallest_jacobian, part.smallest_jacobian);
    total.largest_rate2 = std::max(total.largest_rate2, part.largest_rate2);
  }
  total.finite = std::isfinite(total.strain_energy);
  return total;
}

template <int D>
StoredEnergy Formulation<D>::stored_energy() const {
  std::vector<int> numbers;
  std::vector<double> partial;
  for (int b = 0; b < pairs_.blocks.count(); ++b) {
    numbers.push_back(pairs_.blocks.all[b].number);
    partial.insert(partial.end(), {summaries_[b].strain_energy, summaries_[b].hourglass_energy, summaries_[b].plastic_work,
                                   summaries_[b].damage_work});
  }
  const std::vector<double> sums = sum_over_blocks(comm_, numbers, partial, 4);
  return {sums[0], sums[1], sums[2], sums[3]};
}

/// F = I, no plastic strain, no work. These two are the first numbers of every history.
template <int D>
void Formulation<D>::settle_histories(const std::vector<AnyMaterial>& materials) {
  for (int b = 0; b < pairs_.blocks.count(); ++b) {
    const Block& block = pairs_.blocks.all[b];
    const MaterialPoint<D> point = material_point<D>(materials[block.body], nullptr, false);
    if (point.numbers == 0) continue;
    const HistorySlots slots = history_.of(b);
    for (int slice = block.first_slice; slice < block.end_slice; ++slice) {
      const Mat<Pack, D> I = Mat<Pack, D>::identity();
      Mat<Pack, D> shapeless = I;
      const SliceHistory<D> history{slots, SliceSlots<D>(pairs_, block, slice), {0.0, HistoryUse::forget}, nullptr, &shapeless};
      PointResponse<D> response;
      point(I, &history, response);
    }
    std::fill_n(slots.values, 2 * static_cast<std::ptrdiff_t>(slots.count), 0.0);
  }
}

template <int D>
std::vector<int> history_numbers(const std::vector<AnyMaterial>& materials, const std::vector<std::optional<AnyDamage>>& damages,
                                 bool plane_stress) {
  std::vector<int> numbers;
  for (std::size_t b = 0; b < materials.size(); ++b) {
    const AnyDamage* damage = b < damages.size() && damages[b] ? &*damages[b] : nullptr;
    numbers.push_back(material_point<D>(materials[b], damage, plane_stress).numbers);
  }
  return numbers;
}

template class Formulation<2>;
template class Formulation<3>;
template std::vector<int> history_numbers<2>(const std::vector<AnyMaterial>&, const std::vector<std::optional<AnyDamage>>&, bool);
template std::vector<int> history_numbers<3>(const std::vector<AnyMaterial>&, const std::vector<std::optional<AnyDamage>>&, bool);

}  // namespace sinew
