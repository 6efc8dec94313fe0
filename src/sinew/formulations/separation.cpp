#include <sinew/formulations/separation.hpp>
#include <sinew/particles/particle_size.hpp>

#include <algorithm>
#include <map>

namespace sinew {

template <int D>
std::vector<char> Separation<D>::cut_off_failed(const std::vector<ForceSummary>& summaries) {
  std::vector<char> changed;
  Failed failed = gather(find(summaries));
  if (!failed.empty()) changed.resize(summaries.size());
  for (; !failed.empty(); failed = gather(failed)) failed = cut_off(failed, changed);
  return changed;
}

template <int D>
void Separation<D>::cut_off_again(const std::vector<double>& number_and_radius) {
  std::map<int, double> radius_of;
  for (std::size_t k = 0; k < number_and_radius.size(); k += 2)
    radius_of[static_cast<int>(number_and_radius[k])] = number_and_radius[k + 1];
  Failed here;
  for (const BlockRange& block : s_.particles.blocks)
    for (int slot = block.begin; slot < block.end; ++slot)
      if (const auto found = radius_of.find(s_.particles.user_index[slot]); found != radius_of.end())
        here.push_back(particle(slot, found->second));
  std::vector<char> changed(s_.particles.blocks.size());
  cut_off(gather(here), changed);
}

/// On this rank.
template <int D>
typename Separation<D>::Failed Separation<D>::find(const std::vector<ForceSummary>& summaries) const {
  Failed failed;
  for (std::size_t b = 0; b < summaries.size(); ++b) {
    const BlockRange& block = s_.particles.blocks[b];
    if (!summaries[b].fails || !s_.options.separates(block.body)) continue;
    const History history = history_of(block.begin);
    const double* damage = history.first + history.damage * history.count - block.begin;
    for (int slot = block.begin; slot < block.end; ++slot)
      if (damage[slot] >= 1.0 && !s_.cracks.find(s_.particles.user_index[slot])) fail(slot, failed);
  }
  return failed;
}

/// Those of all ranks, by their numbers.
template <int D>
typename Separation<D>::Failed Separation<D>::gather(const Failed& here) const {
  Failed all;
  if (!s_.comm.any(!here.empty())) return all;
  std::vector<double> rows;
  for (const FailedParticle<D>& failed : here) failed.append_to(rows);
  rows = s_.comm.gather_all(rows);
  for (auto row = rows.begin(); row != rows.end(); row += FailedParticle<D>::width)
    all.push_back(FailedParticle<D>::from_row(&*row));
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  return all;
}

/// Cuts their pairs and makes weights anew. Returns the particles of this rank that keep too few neighbors by that: they fail as well.
template <int D>
typename Separation<D>::Failed Separation<D>::cut_off(const Failed& failed, std::vector<char>& changed) const {
  s_.cracks.add(failed);
  Failed left_alone;
  for (std::size_t b = 0; b < s_.pairs.blocks.all.size(); ++b) {
    const Block& block = s_.pairs.blocks.all[b];
    const std::vector<int> slices = cut_pairs<D>(s_.pairs, block, s_.particles, s_.weights.radius, failed);
    if (slices.empty()) continue;
    changed[b] = 1;
    for (const int slot : renew_weights<D>({s_.particles, s_.pairs}, block, slices, s_.weight_options, s_.weights))
      if (!s_.cracks.find(s_.particles.user_index[slot])) fail(slot, left_alone);
  }
  return left_alone;
}

/// It keeps no elastic strain, now that it will have F = I.
template <int D>
void Separation<D>::fail(int slot, Failed& failed) const {
  const History history = history_of(slot);
  for (int number = history.first_shape; number < history.damage; ++number) history.first[number * history.count] = 0.0;
  history.first[history.damage * history.count] = 1.0;
  failed.push_back(particle(slot, room(slot)));
}

template <int D>
FailedParticle<D> Separation<D>::particle(int slot, double radius) const {
  const double spacing = 2.0 * contact_radius<D>(s_.particles.volume[slot]);
  return {s_.particles.position[slot], FailedParticle<D>::reach_in_spacings * spacing, radius, s_.particles.body_of(slot),
          s_.particles.user_index[slot]};
}

/// The radius with which it touches none of its neighbors yet, so that contact begins without force; at most that of its volume, and at least a tenth of it.
template <int D>
double Separation<D>::room(int slot) const {
  const Particles<D>& p = s_.particles;
  const double most = contact_radius<D>(p.volume[slot]);
  double room = most;
  for (const int j : s_.pairs.neighbors(slot, p)) {
    if (j == slot) continue;
    const Vec<double, D> apart = p.position[j] - p.position[slot] + p.displacement[j] - p.displacement[slot];
    room = std::min(room, norm(apart) - contact_radius<D>(p.volume[j]));
  }
  return std::max(room, 0.1 * most);
}

template <int D>
typename Separation<D>::History Separation<D>::history_of(int slot) const {
  const int block = s_.particles.block_of(slot), body = s_.particles.blocks[block].body;
  const HistorySlots slots = s_.history.of(block);
  const MaterialPoint<D> point = material_point<D>(s_.options.materials[body], s_.options.damage_of(body), false);
  return {slots.values + slot - slots.first, slots.count, point.first_shape, point.damage_step.first_number};
}

template class Separation<2>;
template class Separation<3>;

}  // namespace sinew
