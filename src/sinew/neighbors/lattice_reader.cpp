#include <sinew/neighbors/lattice_reader.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {

namespace {

constexpr std::uint8_t everyone = 0xff;
constexpr std::size_t most_bonds = 4096;  ///< an arrangement with more is not regular

/// Whether reading eight in a row for one of the pairs meets what was written for the other.
bool overlap(const MirrorPair& a, const MirrorPair& b) {
  const auto near = [](int p, int q) { return std::abs(p - q) < lanes; };
  return near(a.forward, b.forward) || near(a.forward, b.backward) || near(a.backward, b.forward) || near(a.backward, b.backward);
}
bool overlap(const SinglePair& a, const SinglePair& b) { return std::abs(a.offset - b.offset) < lanes; }

/// Puts pairs whose rows overlap as far apart as possible: a load that overlaps a store just before it waits until that is in the cache.
template <class Pair>
void spread(std::vector<Pair>& pairs, int begin) {
  const int count = static_cast<int>(pairs.size());
  for (int place = begin; place < count; ++place) {
    int best = place, best_age = -1, best_rest = -1;
    for (int k = place; k < count; ++k) {
      int age = 0, rest = 0;
      while (place - age > begin && !overlap(pairs[place - age - 1], pairs[k])) ++age;
      if (place - age == begin) age = count;
      for (int other = place; other < count; ++other) rest += overlap(pairs[other], pairs[k]);
      if (age > best_age || (age == best_age && rest > best_rest)) best = k, best_age = age, best_rest = rest;
    }
    std::rotate(pairs.begin() + place, pairs.begin() + best, pairs.begin() + best + 1);
  }
}

template <int D>
std::uint64_t hash(const SliceShape<D>& shape) {
  std::uint64_t h = 0xcbf29ce484222325ULL;
  for (const Offset<D>& o : shape.offsets) h = (h ^ (static_cast<std::uint64_t>(o.offset) << 8 | o.members)) * 0x100000001b3ULL;
  return h;
}

}  // namespace

template <int D>
LatticeReader<D>::LatticeReader(const Arrangement<D>& particles, const std::vector<double>& radius)
    : particles_(particles),
      radius_(radius) {
  double farthest = 0.0;
  for (int c = 0; c < D; ++c)
    for (int slot = 0; slot < particles.slots; ++slot) farthest = std::max(farthest, std::abs(particles.position.at(c, slot)));
  tolerance_ = 8.0 * 0x1p-52 * farthest;
}

template <int D>
bool LatticeReader<D>::same(const Bond<D>& a, const Bond<D>& b, double sign) const {
  bool equal = a.volume == b.volume && a.radius == b.radius;
  for (int c = 0; c < D; ++c) equal = equal && std::abs(a.X[c] - sign * b.X[c]) <= tolerance_;
  return equal;
}

template <int D>
Bond<D> LatticeReader<D>::bond_of(int i, int j) const {
  return {particles_.position[j] - particles_.position[i], particles_.volume[j], radius_[i]};
}

template <int D>
bool LatticeReader<D>::same(const SliceShape<D>& a, const SliceShape<D>& b) const {
  return a.volume == b.volume && std::equal(a.offsets.begin(), a.offsets.end(), b.offsets.begin(), b.offsets.end(),
                                            [this](const Offset<D>& p, const Offset<D>& q) {
                                              return p.offset == q.offset && p.members == q.members && same(p.bond, q.bond);
                                            });
}

template <int D>
BlockShapes<D> LatticeReader<D>::read(const BlockLayout<D>& layout, const std::vector<int>& slices) const {
  BlockShapes<D> shapes;
  std::unordered_map<std::uint64_t, std::vector<int>> known;
  std::vector<int> rows[lanes];
  SliceShape<D> shape;
  std::size_t without = 0;
  for (int place : slices) {
    read(layout, place, rows, shape);
    if (shape.offsets.empty() && 2 * ++without > slices.size()) return {};
    std::vector<int>& candidates = known[hash(shape)];
    const auto found = std::find_if(candidates.begin(), candidates.end(), [&](int k) { return same(shapes.distinct[k], shape); });
    if (found == candidates.end()) {
      shapes.of_slice.push_back(static_cast<int>(shapes.distinct.size()));
      candidates.push_back(shapes.of_slice.back());
      shapes.distinct.push_back(shape);
    } else {
      shapes.of_slice.push_back(*found);
    }
  }
  return shapes;
}

/// Merges the ascending neighbors of the own particles by distance in places. Empty where they do not look alike.
template <int D>
void LatticeReader<D>::read(const BlockLayout<D>& layout, int place, std::vector<int> (&rows)[lanes],
                            SliceShape<D>& shape) const {
  std::vector<Offset<D>>& found = shape.offsets;
  found.clear();
  shape.volume = {};
  const std::vector<int>& slot_at = layout.slot_at();
  std::size_t next[lanes] = {}, longest = 0;
  std::uint8_t own = 0;
  for (int k = 0; k < lanes; ++k) {
    rows[k].clear();
    if (!layout.own(place + k)) continue;
    own = static_cast<std::uint8_t>(own | 1U << k);
    layout.neighbors(place + k, rows[k]);
    longest = std::max(longest, rows[k].size());
    shape.volume[k] = particles_.volume[slot_at[place + k]];
  }
  constexpr int nothing = 1 << 30;
  for (;;) {
    int least = nothing;
    for (int k = 0; k < lanes; ++k)
      if (next[k] < rows[k].size()) least = std::min(least, rows[k][next[k]] - k);
    if (least == nothing) return;
    if (found.size() == longest + longest / 2 + 8) return found.clear();
    Offset<D> merged{least - place, 0, {}};
    for (int k = 0; k < lanes; ++k) {
      if (next[k] == rows[k].size() || rows[k][next[k]] - k != least) continue;
      const Bond<D> bond = bond_of(slot_at[place + k], slot_at[least + k]);
      if (merged.members != 0 && !same(bond, merged.bond)) return found.clear();
      if (merged.members == 0) merged.bond = bond;
      merged.members = static_cast<std::uint8_t>(merged.members | 1U << k);
      ++next[k];
    }
    if (merged.members == own) merged.members = everyone;
    found.push_back(merged);
  }
}

/// The number of the pattern, new or known; `none` if there are too many bonds.
template <int D>
int LatticeDictionary<D>::number_of(const SliceShape<D>& shape) {
  std::vector<int>& candidates = known_[hash(shape)];
  for (int p : candidates)
    if (matches(shape, p)) return p;
  if (lattice_.bonds.size() > most_bonds) return LatticePatterns<D>::none;
  add(shape);
  candidates.push_back(static_cast<int>(sources_.size()) - 1);
  return candidates.back();
}

template <int D>
bool LatticeDictionary<D>::matches(const SliceShape<D>& shape, int pattern) const {
  const auto same_pair = [&](const Offset<D>& p, const SinglePair& q) {
    return p.offset == q.offset && p.members == q.members && reader_.same(p.bond, lattice_.bonds[q.bond]);
  };
  const std::vector<SinglePair>& source = sources_[pattern];
  return shape.volume == lattice_.volumes[pattern] &&
         std::equal(shape.offsets.begin(), shape.offsets.end(), source.begin(), source.end(), same_pair);
}

template <int D>
int LatticeDictionary<D>::bond_number(const Bond<D>& bond) {
  const auto at =
      std::find_if(lattice_.bonds.begin(), lattice_.bonds.end(), [&](const Bond<D>& b) { return reader_.same(b, bond); });
  if (at != lattice_.bonds.end()) return static_cast<int>(at - lattice_.bonds.begin());
  lattice_.bonds.push_back(bond);
  return static_cast<int>(lattice_.bonds.size()) - 1;
}

/// Pairs up what is complete and mirrored; the rest stays single.
template <int D>
void LatticeDictionary<D>::add(const SliceShape<D>& shape) {
  const std::vector<Offset<D>>& offsets = shape.offsets;
  LatticePattern pattern{static_cast<int>(lattice_.mirrored.size()), 0, static_cast<int>(lattice_.single.size()), 0};
  std::vector<bool> taken(offsets.size(), false);
  std::vector<SinglePair> source;
  for (const Offset<D>& o : offsets) {
    source.push_back({o.offset, bond_number(o.bond), o.members});
    lattice_.farthest = std::max(lattice_.farthest, std::abs(o.offset));
  }
  for (std::size_t a = 0; a < offsets.size(); ++a) {
    if (taken[a]) continue;
    std::size_t b = offsets.size();
    if (offsets[a].members == everyone)
      for (b = a + 1; b < offsets.size(); ++b)
        if (!taken[b] && offsets[b].members == everyone && reader_.same(offsets[a].bond, offsets[b].bond, -1.0)) break;
    if (b < offsets.size()) {
      taken[b] = true;
      lattice_.mirrored.push_back({source[a].offset, source[b].offset, source[a].bond});
    } else {
      lattice_.single.push_back(source[a]);
    }
  }
  spread(lattice_.mirrored, pattern.first_mirrored);
  spread(lattice_.single, pattern.first_single);
  pattern.end_mirrored = static_cast<int>(lattice_.mirrored.size());
  pattern.end_single = static_cast<int>(lattice_.single.size());
  lattice_.patterns.push_back(pattern);
  lattice_.volumes.push_back(shape.volume);
  sources_.push_back(std::move(source));
}

template class LatticeReader<2>;
template class LatticeReader<3>;
template class LatticeDictionary<2>;
template class LatticeDictionary<3>;

}  // namespace sinew
