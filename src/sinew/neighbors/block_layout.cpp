#include <sinew/neighbors/block_layout.hpp>

#include <algorithm>
#include <numeric>

namespace sinew {

template <int D>
void BlockLayout<D>::find_ghosts(const BlockRange& block) {
  place_of_.resize(particles_.slots, Blocks::nobody);
  for (int slot : slot_at_)
    if (slot != Blocks::nobody) place_of_[slot] = Blocks::nobody;
  for (int slot : ghosts_) place_of_[slot] = Blocks::nobody;
  block_ = block;
  ghosts_.clear();
  for (int slot = block.begin; slot < block.end; ++slot) {
    const int* next = list_.neighbor.data() + lanes * list_.first_entry[slot / lanes] + slot % lanes;
    for (int n = 0; n < list_.neighbor_count[slot]; ++n, next += lanes)
      if (!block.owns(*next) && place_of_[*next] == Blocks::nobody) {
        place_of_[*next] = 0;
        ghosts_.push_back(*next);
      }
  }
}

template <int D>
void BlockLayout<D>::give_places() {
  for (std::size_t place = 0; place < slot_at_.size(); ++place)
    if (slot_at_[place] != Blocks::nobody) place_of_[slot_at_[place]] = static_cast<int>(place);
}

template <int D>
void BlockLayout<D>::own_first(const BlockRange& block) {
  find_ghosts(block);
  std::sort(ghosts_.begin(), ghosts_.end());
  const int own = block.end - block.begin;
  slot_at_.assign(whole_slices(whole_slices(own) + static_cast<int>(ghosts_.size())), Blocks::nobody);
  std::iota(slot_at_.begin(), slot_at_.begin() + own, block.begin);
  std::copy(ghosts_.begin(), ghosts_.end(), slot_at_.begin() + whole_slices(own));
  give_places();
}

/// Place in the row, layer and slab.
template <int D>
std::array<std::int64_t, 3> BlockLayout<D>::bins_of(int slot) const {
  const SlabGrid& grid = grids_[block_.body];
  const Point X = particles_.reference(slot);
  const auto bin = [&](int axis) { return static_cast<std::int64_t>(grid.bin(X, axis)); };
  return {bin(grid.fastest), grid.layers > 1 ? bin(grid.middle) : 0, bin(grid.slowest)};
}

template <int D>
bool BlockLayout<D>::on_grid(const BlockRange& block) {
  find_ghosts(block);
  members_.resize(block.end - block.begin);
  std::iota(members_.begin(), members_.end(), block.begin);
  members_.insert(members_.end(), ghosts_.begin(), ghosts_.end());
  std::array<std::int64_t, 3> low = bins_of(block.begin), size = low;
  bins_.clear();
  for (int slot : members_) {
    bins_.push_back(bins_of(slot));
    for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], bins_.back()[k]), size[k] = std::max(size[k], bins_.back()[k]);
  }
  double places = 1.0;
  for (int k = 0; k < 3; ++k) places *= static_cast<double>(size[k] = size[k] - low[k] + 1);
  slot_at_.clear();
  const double most = std::min(2.0 * static_cast<double>(members_.size()) + 1000.0, static_cast<double>(place_limit));
  if (places > most) return false;
  slot_at_.assign(whole_slices(static_cast<int>(places)), Blocks::nobody);
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const auto& bin = bins_[m];
    int& at = slot_at_[((bin[2] - low[2]) * size[1] + bin[1] - low[1]) * size[0] + bin[0] - low[0]];
    if (at != Blocks::nobody) return slot_at_.clear(), false;
    at = members_[m];
  }
  give_places();
  return true;
}

template <int D>
void BlockLayout<D>::restore(const BlockRange& block, const std::vector<int>& slot_at) {
  place_of_.resize(particles_.slots, Blocks::nobody);
  block_ = block;
  slot_at_ = slot_at;
  give_places();
}

template <int D>
void BlockLayout<D>::neighbors(int place, std::vector<int>& places) const {
  const int slot = slot_at_[place], count = list_.neighbor_count[slot];
  places.resize(count);
  const int* next = list_.neighbor.data() + lanes * list_.first_entry[slot / lanes] + slot % lanes;
  for (int n = 0; n < count; ++n, next += lanes) places[n] = place_of_[*next];
  if (!std::is_sorted(places.begin(), places.end())) std::sort(places.begin(), places.end());
}

template <int D>
std::vector<int> BlockLayout<D>::slices() const {
  std::vector<int> first;
  for (int place = 0; place < static_cast<int>(slot_at_.size()); place += lanes)
    for (int k = 0; k < lanes; ++k)
      if (own(place + k)) {
        first.push_back(place);
        break;
      }
  return first;
}

template <int D>
void BlockLayout<D>::add_runs(bool own_ones, std::vector<Run>& runs) const {
  const std::size_t first = runs.size();
  int end_of_owner = 0;  // a run has one owner
  for (int place = 0; place < static_cast<int>(slot_at_.size()); ++place) {
    const int slot = slot_at_[place];
    if (slot == Blocks::nobody || own(place) != own_ones) continue;
    Run* last = runs.size() > first ? &runs.back() : nullptr;
    if (last && last->slot + last->length == slot && last->place + last->length == place && slot < end_of_owner) {
      ++last->length;
    } else {
      runs.push_back({slot, place, 1, 0});
      end_of_owner = particles_.blocks[particles_.block_of(slot)].end;
    }
  }
  std::sort(runs.begin() + static_cast<std::ptrdiff_t>(first), runs.end(),
            [](const Run& a, const Run& b) { return a.slot < b.slot; });
}

template class BlockLayout<2>;
template class BlockLayout<3>;

}  // namespace sinew
