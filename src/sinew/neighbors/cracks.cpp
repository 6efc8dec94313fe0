#include <sinew/neighbors/cracks.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace sinew {

template <int D>
bool FailedParticle<D>::stands_between(const Vec<double, D>& a, const Vec<double, D>& b) const {
  const bool ordered = std::lexicographical_compare(a.c, a.c + D, b.c, b.c + D);
  const Vec<double, D>&from = ordered ? a : b, &to = ordered ? b : a;
  const Vec<double, D> way = to - from, here = place - from;
  const double t = dot(here, way) / dot(way, way);
  if (!(t >= 0.0 && t <= 1.0)) return false;
  const Vec<double, D> beside = here - t * way;
  return dot(beside, beside) < reach * reach;
}

template <int D>
void FailedParticle<D>::append_to(std::vector<double>& rows) const {
  rows.insert(rows.end(), place.c, place.c + D);
  rows.insert(rows.end(), {reach, radius, static_cast<double>(body), static_cast<double>(number)});
}

template <int D>
FailedParticle<D> FailedParticle<D>::from_row(const double* row) {
  FailedParticle p{{}, row[D], row[D + 1], static_cast<int>(row[D + 2]), static_cast<int>(row[D + 3])};
  std::copy_n(row, D, p.place.c);
  return p;
}

template <int D>
std::int64_t Cracks<D>::cell_along(double coordinate) const {
  return static_cast<std::int64_t>(std::floor(coordinate / edge_));
}

/// Cells far apart may share one; they are then looked at in vain.
template <int D>
std::uint64_t Cracks<D>::key(const Cell& cell) {
  std::uint64_t key = 0;
  for (const std::int64_t along : cell) key = (key << 21) ^ (static_cast<std::uint64_t>(along) & ((1U << 21) - 1));
  return key;
}

template <int D>
void Cracks<D>::add(std::span<const FailedParticle<D>> failed) {
  for (const FailedParticle<D>& p : failed) {
    Cell cell;
    for (int c = 0; c < D; ++c) cell[c] = cell_along(p.place[c]);
    cells_[key(cell)].push_back(static_cast<int>(all_.size()));
    of_number_[p.number] = static_cast<int>(all_.size());
    most_reach_ = std::max(most_reach_, p.reach);
    all_.push_back(p);
  }
}

template <int D>
const FailedParticle<D>* Cracks<D>::find(int number) const {
  const auto found = of_number_.find(number);
  return found == of_number_.end() ? nullptr : &all_[found->second];
}

/// Whether a failed particle in (the cells of) a box passes the test.
template <int D>
template <class Test>
bool Cracks<D>::any_in_box(Vec<double, D> low, Vec<double, D> high, Test&& test) const {
  if (empty()) return false;
  Cell first, last, cell;
  for (int c = 0; c < D; ++c) first[c] = cell_along(low[c] - most_reach_), last[c] = cell_along(high[c] + most_reach_);
  for (cell = first; cell[0] <= last[0];) {
    const auto found = cells_.find(key(cell));
    if (found != cells_.end())
      for (const int k : found->second)
        if (test(all_[k])) return true;
    for (int c = D - 1; c >= 0; --c) {  // the next cell, the last axis first
      if (++cell[c] <= last[c] || c == 0) break;
      cell[c] = first[c];
    }
  }
  return false;
}

template <int D>
bool Cracks<D>::near(const Vec<double, D>& place, int body) const {
  Vec<double, D> low = place, high = place;
  for (int c = 0; c < D; ++c) low[c] -= edge_, high[c] += edge_;
  return any_in_box(low, high, [&](const FailedParticle<D>& k) {
    const Vec<double, D> apart = k.place - place;
    const double most = edge_ + k.reach;
    return k.body == body && dot(apart, apart) <= most * most;
  });
}

template <int D>
bool Cracks<D>::cuts(const Vec<double, D>& a, const Vec<double, D>& b, int body) const {
  Vec<double, D> low, high;
  for (int c = 0; c < D; ++c) low[c] = std::min(a[c], b[c]), high[c] = std::max(a[c], b[c]);
  return any_in_box(low, high, [&](const FailedParticle<D>& k) { return k.body == body && k.stands_between(a, b); });
}

namespace {

/// Those of the body that are close enough to a box to cut pairs of particles in it.
template <int D>
std::vector<FailedParticle<D>> close_to(const Vec<double, D>& low, const Vec<double, D>& high, double radius, int body,
                                        std::span<const FailedParticle<D>> failed) {
  std::vector<FailedParticle<D>> close;
  for (const FailedParticle<D>& k : failed) {
    bool inside = k.body == body;
    for (int c = 0; c < D; ++c)
      inside = inside && k.place[c] >= low[c] - radius - k.reach && k.place[c] <= high[c] + radius + k.reach;
    if (inside) close.push_back(k);
  }
  return close;
}

}  // namespace

template <int D>
std::vector<int> cut_pairs(BlockPairs<D>& pairs, const Block& block, const Particles<D>& particles,
                           const AlignedArray<double>& radius, std::span<const FailedParticle<D>> failed) {
  Vec<double, D> low = particles.position[block.begin], high = low;
  double farthest = 0.0;
  for (int slot = block.begin; slot < block.end; ++slot) {
    farthest = std::max(farthest, radius[slot]);
    for (int c = 0; c < D; ++c) {
      low[c] = std::min(low[c], particles.position.at(c, slot));
      high[c] = std::max(high[c], particles.position.at(c, slot));
    }
  }
  const std::vector<FailedParticle<D>> of_block = close_to<D>(low, high, farthest, block.body, failed);
  std::vector<int> changed;
  const int* slots = pairs.blocks.slots_of(block);
  for (int slice = block.first_slice; slice < block.end_slice && !of_block.empty(); ++slice)
    for (int lane = 0; lane < lanes; ++lane) {
      const int place = pairs.blocks.place_of_slice[slice] + lane;
      if (!block.owns(slots[place])) continue;
      const Vec<double, D> X = particles.position[slots[place]];
      const std::vector<FailedParticle<D>> close = close_to<D>(X, X, radius[slots[place]], block.body, of_block);
      if (close.empty()) continue;
      for (std::size_t e = pairs.first_entry[slice]; e < pairs.first_entry[slice + 1]; ++e) {
        PlaceIndex& neighbor = pairs.places[lanes * e + lane];
        if (neighbor == place) continue;
        const Vec<double, D> other = particles.position[slots[neighbor]];
        if (std::none_of(close.begin(), close.end(), [&](const auto& k) { return k.stands_between(X, other); })) continue;
        neighbor = static_cast<PlaceIndex>(place);
        if (changed.empty() || changed.back() != slice) changed.push_back(slice);
      }
    }
  return changed;
}

template struct FailedParticle<2>;
template struct FailedParticle<3>;
template class Cracks<2>;
template class Cracks<3>;
template std::vector<int> cut_pairs<2>(BlockPairs<2>&, const Block&, const Particles<2>&, const AlignedArray<double>&,
                                       std::span<const FailedParticle<2>>);
template std::vector<int> cut_pairs<3>(BlockPairs<3>&, const Block&, const Particles<3>&, const AlignedArray<double>&,
                                       std::span<const FailedParticle<3>>);

}  // namespace sinew
