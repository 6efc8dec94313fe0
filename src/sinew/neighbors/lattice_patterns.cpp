#include <sinew/neighbors/lattice_patterns.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace sinew {

namespace {

/// The neighbors of a slice at one distance in the computing order.
template <int D>
struct Offset {
  int offset = 0;
  std::uint8_t members = 0;
  Bond<D> bond;
};

/// All that a pattern depends on.
template <int D>
struct SliceShape {
  std::vector<Offset<D>> offsets;  ///< empty: no pattern
  std::array<double, lanes> volume{};
};

constexpr std::uint8_t everyone = 0xff;
constexpr int block = 256;                ///< slices that are read before the dictionary grows
constexpr std::size_t most_bonds = 4096;  ///< an arrangement with more is not regular

/// Reads the slices of one body.
template <int D>
class SliceReader {
 public:
  SliceReader(const Particles<D>& particles, const PairList& list, const std::vector<double>& radius)
      : particles_(particles),
        list_(list),
        radius_(radius) {
    double farthest = 0.0;
    for (int c = 0; c < D; ++c)
      for (int slot = 0; slot < particles.slots; ++slot) farthest = std::max(farthest, std::abs(particles.position.at(c, slot)));
    tolerance_ = 8.0 * 0x1p-52 * farthest;
  }

  bool same(const Bond<D>& a, const Bond<D>& b, double sign = 1.0) const {
    bool equal = a.volume == b.volume && a.radius == b.radius;
    for (int c = 0; c < D; ++c) equal = equal && std::abs(a.X[c] - sign * b.X[c]) <= tolerance_;
    return equal;
  }

  /// Merges the ascending neighbors of the eight particles by distance in the order. Empty where they do not look alike.
  SliceShape<D> read(int slice) const {
    SliceShape<D> shape;
    std::vector<Offset<D>>& found = shape.offsets;
    std::copy_n(particles_.volume.data() + lanes * slice, lanes, shape.volume.begin());
    int next[lanes] = {}, count[lanes], longest = 0;
    for (int k = 0; k < lanes; ++k) longest = std::max(longest, count[k] = list_.neighbor_count[lanes * slice + k]);
    const std::size_t most = longest + longest / 2 + 8, first = list_.first_entry[slice];
    for (;;) {
      int least = particles_.slots;
      for (int k = 0; k < lanes; ++k)
        if (next[k] < count[k]) least = std::min(least, list_.entry(first + next[k])[k] - k);
      if (least == particles_.slots) return shape;
      if (found.size() == most) return {};
      Offset<D> merged{least - lanes * slice, 0, {}};
      for (int k = 0; k < lanes; ++k) {
        if (next[k] == count[k] || list_.entry(first + next[k])[k] - k != least) continue;
        const Bond<D> bond = bond_of(lanes * slice + k, least + k);
        if (merged.members && !same(bond, merged.bond)) return {};
        if (!merged.members) merged.bond = bond;
        merged.members = static_cast<std::uint8_t>(merged.members | 1u << k);
        ++next[k];
      }
      found.push_back(merged);
    }
  }

 private:
  Bond<D> bond_of(int i, int j) const {
    return {particles_.position[j] - particles_.position[i], particles_.volume[j], radius_[i]};
  }

  const Particles<D>& particles_;
  const PairList& list_;
  const std::vector<double>& radius_;
  double tolerance_;
};

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

/// The patterns met so far.
template <int D>
class Dictionary {
 public:
  Dictionary(const SliceReader<D>& reader, LatticePatterns<D>& lattice) : reader_(reader), lattice_(lattice) {}

  /// The number of the pattern, new or known; `none` if there are too many bonds.
  int number_of(const SliceShape<D>& shape) {
    std::vector<int>& candidates = known_[hash(shape)];
    for (int p : candidates)
      if (matches(shape, sources_[p])) return p;
    if (lattice_.bonds.size() > most_bonds) return LatticePatterns<D>::none;
    add(shape);
    candidates.push_back(static_cast<int>(sources_.size()) - 1);
    return candidates.back();
  }

 private:
  static std::uint64_t hash(const SliceShape<D>& shape) {
    std::uint64_t h = 0xcbf29ce484222325ULL;
    for (const Offset<D>& o : shape.offsets) h = (h ^ (static_cast<std::uint64_t>(o.offset) << 8 | o.members)) * 0x100000001b3ULL;
    return h;
  }
  struct Source {
    std::vector<SinglePair> pairs;
    std::array<double, lanes> volume;
  };

  bool matches(const SliceShape<D>& a, const Source& b) const {
    const auto same_pair = [&](const Offset<D>& p, const SinglePair& q) {
      return p.offset == q.offset && p.members == q.members && reader_.same(p.bond, lattice_.bonds[q.bond]);
    };
    return a.volume == b.volume && std::equal(a.offsets.begin(), a.offsets.end(), b.pairs.begin(), b.pairs.end(), same_pair);
  }
  int bond_number(const Bond<D>& bond) {
    const auto at =
        std::find_if(lattice_.bonds.begin(), lattice_.bonds.end(), [&](const Bond<D>& b) { return reader_.same(b, bond); });
    if (at != lattice_.bonds.end()) return static_cast<int>(at - lattice_.bonds.begin());
    lattice_.bonds.push_back(bond);
    return static_cast<int>(lattice_.bonds.size()) - 1;
  }

  /// Pairs up what is complete and mirrored; the rest stays single.
  void add(const SliceShape<D>& shape) {
    const std::vector<Offset<D>>& offsets = shape.offsets;
    LatticePattern pattern{static_cast<int>(lattice_.mirrored.size()), 0, static_cast<int>(lattice_.single.size()), 0};
    std::vector<bool> taken(offsets.size(), false);
    std::vector<SinglePair> source;
    for (const Offset<D>& o : offsets) source.push_back({o.offset, bond_number(o.bond), o.members});
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
    sources_.push_back({std::move(source), shape.volume});
  }

  const SliceReader<D>& reader_;
  LatticePatterns<D>& lattice_;
  std::vector<Source> sources_;  ///< what each pattern was made of
  std::unordered_map<std::uint64_t, std::vector<int>> known_;
};

}  // namespace

template <int D>
int LatticePatterns<D>::slices() const {
  return static_cast<int>(std::count_if(of_slice.begin(), of_slice.end(), [](int p) { return p != none; }));
}

template <int D>
std::size_t LatticePatterns<D>::bytes() const {
  return of_slice.size() * sizeof(int) + patterns.size() * sizeof(LatticePattern) + mirrored.size() * sizeof(MirrorPair) +
         single.size() * sizeof(SinglePair) + bonds.size() * sizeof(Bond<D>);
}

template <int D>
LatticePatterns<D> no_lattice_patterns(const Particles<D>& particles) {
  LatticePatterns<D> lattice;
  lattice.of_slice.assign(particles.slots / lanes, LatticePatterns<D>::none);
  return lattice;
}

template <int D>
LatticePatterns<D> find_lattice_patterns(const Particles<D>& particles, const PairList& list,
                                         const std::vector<double>& support_radius) {
  LatticePatterns<D> lattice = no_lattice_patterns(particles);
  const SliceReader<D> reader(particles, list, support_radius);
  Dictionary<D> dictionary(reader, lattice);
  std::vector<SliceShape<D>> read(block);
  for (const BodyRange& body : particles.bodies) {
    const int begin = body.begin / lanes, end = body.end / lanes;
    int found = 0;
    for (int first = begin; first < end; first += block) {
      const int count = std::min(block, end - first);
#pragma omp parallel for schedule(dynamic, 16)
      for (int k = 0; k < count; ++k) read[k] = reader.read(first + k);
      for (int k = 0; k < count; ++k)
        if (!read[k].offsets.empty())
          found += (lattice.of_slice[first + k] = dictionary.number_of(read[k])) != LatticePatterns<D>::none;
    }
    if (2 * found < end - begin)
      std::fill(lattice.of_slice.begin() + begin, lattice.of_slice.begin() + end, LatticePatterns<D>::none);
  }
  return lattice;
}

template <int D>
std::vector<int> neighbors_of(int slot, const PairList& list, const LatticePatterns<D>& lattice) {
  const int slice = slot / lanes, lane = slot % lanes;
  std::vector<int> all;
  if (lattice.of_slice[slice] == LatticePatterns<D>::none) {
    for (int n = 0; n < list.neighbor_count[slot]; ++n) all.push_back(list.entry(list.first_entry[slice] + n)[lane]);
    return all;
  }
  const LatticePattern& pattern = lattice.patterns[lattice.of_slice[slice]];
  for (int k = pattern.first_mirrored; k < pattern.end_mirrored; ++k)
    for (int offset : {lattice.mirrored[k].forward, lattice.mirrored[k].backward}) all.push_back(slot + offset);
  for (int k = pattern.first_single; k < pattern.end_single; ++k)
    if (lattice.single[k].members >> lane & 1) all.push_back(slot + lattice.single[k].offset);
  std::sort(all.begin(), all.end());
  return all;
}

template <int D>
void drop_lattice_slices(PairList& list, const LatticePatterns<D>& lattice) {
  std::vector<std::size_t> first(list.first_entry.size(), 0);
  for (int s = 0; s < list.slices(); ++s)
    first[s + 1] =
        first[s] + (lattice.of_slice[s] == LatticePatterns<D>::none ? list.first_entry[s + 1] - list.first_entry[s] : 0);
  AlignedArray<int> kept(first.back() * lanes);
  for (int s = 0; s < list.slices(); ++s)
    std::copy_n(list.entry(list.first_entry[s]), lanes * (first[s + 1] - first[s]), kept.data() + lanes * first[s]);
  list.first_entry = std::move(first);
  list.neighbor = std::move(kept);
}

template struct LatticePatterns<2>;
template struct LatticePatterns<3>;
template LatticePatterns<2> no_lattice_patterns<2>(const Particles<2>&);
template LatticePatterns<3> no_lattice_patterns<3>(const Particles<3>&);
template LatticePatterns<2> find_lattice_patterns<2>(const Particles<2>&, const PairList&, const std::vector<double>&);
template LatticePatterns<3> find_lattice_patterns<3>(const Particles<3>&, const PairList&, const std::vector<double>&);
template void drop_lattice_slices<2>(PairList&, const LatticePatterns<2>&);
template void drop_lattice_slices<3>(PairList&, const LatticePatterns<3>&);
template std::vector<int> neighbors_of<2>(int, const PairList&, const LatticePatterns<2>&);
template std::vector<int> neighbors_of<3>(int, const PairList&, const LatticePatterns<3>&);

}  // namespace sinew
