#include <sinew/core/error.hpp>
#include <sinew/neighbors/block_layout.hpp>
#include <sinew/neighbors/block_pairs.hpp>
#include <sinew/neighbors/lattice_reader.hpp>

#include <algorithm>

namespace sinew {

namespace {

/// What is known of a block before all blocks are put together.
template <int D>
struct Draft {
  std::vector<int> slot_at, slices;
  std::vector<Run> own, ghosts;
  LatticePatterns<D> lattice;  ///< of this block alone

  void take(const BlockLayout<D>& layout) {
    slot_at = layout.slot_at();
    slices = layout.slices();
    own.clear();
    ghosts.clear();
    layout.add_runs(true, own);
    layout.add_runs(false, ghosts);
  }
};

template <int D>
class BlockPairsMaker {
 public:
  /// `numbers`: of the blocks wanted.
  BlockPairsMaker(const Arrangement<D>& particles, const PairList& list, const std::vector<double>& radius,
                  const std::vector<int>& numbers)
      : particles_(particles),
        list_(list),
        reader_(particles, radius),
        numbers_(numbers),
        drafts_(numbers.size()) {
    for (std::size_t t = 0; t < most_threads(); ++t) layouts_.emplace_back(particles, list, grids_);
  }

  BlockPairs<D> make(bool look_for_lattice) {
    if (look_for_lattice) make_grids();
    for_each([&](int b, BlockLayout<D>& layout) {
      Draft<D>& draft = drafts_[b];
      if (look_for_lattice && is_lattice(range_of(b), layout, draft)) return;
      layout.own_first(range_of(b));
      draft.take(layout);
      draft.lattice = {};
      draft.lattice.of_slice.assign(draft.slices.size(), LatticePatterns<D>::none);
    });
    for (int b = 0; b < static_cast<int>(drafts_.size()); ++b) append(b);
    count_entries();
    pairs_.places = AlignedArray<PlaceIndex>(lanes * pairs_.entries());
    for_each([&](int b, BlockLayout<D>& layout) { write_entries(b, layout); });
    find_spills();
    pairs_.blocks.connect();
    return std::move(pairs_);
  }

 private:
  template <class Work>
  void for_each(Work&& work) {
    const int count = static_cast<int>(drafts_.size());
#pragma omp parallel for schedule(dynamic, 1) if (particles_.slots >= fewest_for_threads)
    for (int b = 0; b < count; ++b) work(b, layouts_[this_thread()]);
  }

  void make_grids() {
    for (const BodyRange& body : particles_.bodies) {
      std::vector<Point> points;
      for (int slot = body.begin; slot < body.begin + body.count; ++slot) points.push_back(particles_.reference(slot));
      grids_.emplace_back(points, body.spacing, D);
    }
  }

  /// Gives patterns to the slices of a block; true if most of them have one. Depends on the block and its ghosts alone.
  bool is_lattice(const BlockRange& block, BlockLayout<D>& layout, Draft<D>& draft) const {
    if (!layout.on_grid(block)) return false;
    draft.take(layout);
    const BlockShapes<D> shapes = reader_.read(layout, draft.slices);
    LatticeDictionary<D> dictionary(reader_, draft.lattice);
    std::vector<int> pattern;
    for (const SliceShape<D>& shape : shapes.distinct)
      pattern.push_back(shape.offsets.empty() ? LatticePatterns<D>::none : dictionary.number_of(shape));
    for (int shape : shapes.of_slice) draft.lattice.of_slice.push_back(pattern[shape]);
    return !shapes.of_slice.empty() && 2 * static_cast<std::size_t>(draft.lattice.slices()) >= draft.slices.size();
  }

  void append(int b) {
    Blocks& blocks = pairs_.blocks;
    const Draft<D>& draft = drafts_[b];
    const BlockRange& range = range_of(b);
    if (draft.slot_at.size() > place_limit) too_many_places(range);
    Block block{range.number, range.body, range.begin, range.end, static_cast<int>(draft.slot_at.size()), blocks.slot_at.size()};
    blocks.slot_at.insert(blocks.slot_at.end(), draft.slot_at.begin(), draft.slot_at.end());
    block.first_slice = blocks.slices();
    blocks.place_of_slice.insert(blocks.place_of_slice.end(), draft.slices.begin(), draft.slices.end());
    block.end_slice = blocks.slices();
    pairs_.lattice.append(draft.lattice);
    for (int pattern : draft.lattice.of_slice) (pattern == LatticePatterns<D>::none ? block.has_list : block.has_lattice) = true;
    block.first_own = static_cast<int>(blocks.runs.size());
    blocks.runs.insert(blocks.runs.end(), draft.own.begin(), draft.own.end());
    block.first_ghost = static_cast<int>(blocks.runs.size());
    for (Run run : draft.ghosts) {
      run.spill = blocks.ghosts;
      blocks.ghosts += run.length;
      blocks.runs.push_back(run);
    }
    block.end_runs = static_cast<int>(blocks.runs.size());
    blocks.all.push_back(block);
  }

  [[noreturn]] void too_many_places(const BlockRange& range) const {
    throw CaseError("body \"" + particles_.bodies[range.body].name + "\": a block of " + std::to_string(range.end - range.begin) +
                    " particles and all that they see are more than " + std::to_string(place_limit) +
                    " particles. Make [formulation] support smaller, or ask for fewer neighbors.");
  }

  void count_entries() {
    const Blocks& blocks = pairs_.blocks;
    pairs_.neighbor_count = list_.neighbor_count;
    pairs_.pairs = list_.pairs;
    pairs_.first_entry.assign(1, 0);
    for (const Block& block : blocks.all)
      for (int slice = block.first_slice; slice < block.end_slice; ++slice) {
        std::size_t longest = 0;
        const int* slots = blocks.slots_of(block) + blocks.place_of_slice[slice];
        for (int k = 0; pairs_.listed(slice) && k < lanes; ++k)
          if (block.owns(slots[k])) longest = std::max<std::size_t>(longest, list_.neighbor_count[slots[k]]);
        pairs_.first_entry.push_back(pairs_.first_entry.back() + longest);
      }
  }

  void write_entries(int b, BlockLayout<D>& layout) {
    const Block& block = pairs_.blocks.all[b];
    if (!block.has_list) return;
    layout.restore(range_of(b), drafts_[b].slot_at);
    std::vector<int> places;
    for (int slice = block.first_slice; slice < block.end_slice; ++slice) {
      const std::size_t first = pairs_.first_entry[slice], count = pairs_.first_entry[slice + 1] - first;
      PlaceIndex* entry = pairs_.places.data() + lanes * first;
      for (int k = 0; k < lanes && count > 0; ++k) {
        const int place = pairs_.blocks.place_of_slice[slice] + k;
        places.clear();
        if (layout.own(place)) layout.neighbors(place, places);
        for (std::size_t n = 0; n < count; ++n)
          entry[lanes * n + k] = static_cast<PlaceIndex>(n < places.size() ? places[n] : place);
      }
    }
  }

  void find_spills() {
    Blocks& blocks = pairs_.blocks;
    blocks.first_out.push_back(0);
    for (int b = 0; b < blocks.count(); ++b) {
      const Block& block = blocks.all[b];
      for (int r = block.first_ghost; r < block.end_runs; ++r) {
        const int to = particles_.block_of(blocks.runs[r].slot);
        if (static_cast<int>(blocks.out.size()) == blocks.first_out[b] || blocks.out.back().to != to)
          blocks.out.push_back({block.number, to, r, r});
        blocks.out.back().end_run = r + 1;
      }
      blocks.first_out.push_back(static_cast<int>(blocks.out.size()));
    }
  }

  const BlockRange& range_of(int b) const { return particles_.blocks[numbers_[b]]; }

  const Arrangement<D>& particles_;
  const PairList& list_;
  BlockPairs<D> pairs_;
  const LatticeReader<D> reader_;
  const std::vector<int>& numbers_;
  std::vector<Draft<D>> drafts_;
  std::vector<SlabGrid> grids_;
  std::vector<BlockLayout<D>> layouts_;
};

}  // namespace

template <int D>
std::vector<int> BlockPairs<D>::neighbors(int slot, const Arrangement<D>& particles) const {
  const Block& block = blocks.all[particles.block_of(slot)];
  const int* slots = blocks.slots_of(block);
  const auto runs = blocks.runs.begin();
  const auto run =
      std::upper_bound(runs + block.first_own, runs + block.first_ghost, slot, [](int s, const Run& r) { return s < r.slot; }) -
      1;
  const int place = run->place + slot - run->slot;
  const auto begin = blocks.place_of_slice.begin();
  const auto after = std::upper_bound(begin + block.first_slice, begin + block.end_slice, place);
  const int slice = static_cast<int>(after - begin) - 1, lane = place % lanes;
  std::vector<int> all;
  if (listed(slice))
    for (int n = 0; n < neighbor_count[slot]; ++n) all.push_back(entry(first_entry[slice] + n)[lane]);
  else
    for (int offset : lattice.offsets(lattice.of_slice[slice], lane)) all.push_back(place + offset);
  std::sort(all.begin(), all.end());
  for (int& neighbor : all) neighbor = slots[neighbor];
  return all;
}

template <int D>
std::size_t BlockPairs<D>::bytes() const {
  return blocks.bytes() + lattice.bytes() + first_entry.size() * sizeof(std::size_t) + places.bytes() +
         neighbor_count.size() * sizeof(int);
}

template <int D>
BlockPairs<D> make_block_pairs(const Arrangement<D>& particles, const std::vector<int>& blocks, PairList list,
                               const std::vector<double>& support_radius, bool look_for_lattice) {
  return BlockPairsMaker<D>(particles, list, support_radius, blocks).make(look_for_lattice);
}

template <int D>
BlockPairs<D> make_block_pairs(const Arrangement<D>& particles, PairList list, const std::vector<double>& support_radius,
                               bool look_for_lattice) {
  return make_block_pairs(particles, particles.block_numbers(), std::move(list), support_radius, look_for_lattice);
}

template struct BlockPairs<2>;
template struct BlockPairs<3>;
template BlockPairs<2> make_block_pairs<2>(const Arrangement<2>&, PairList, const std::vector<double>&, bool);
template BlockPairs<3> make_block_pairs<3>(const Arrangement<3>&, PairList, const std::vector<double>&, bool);
template BlockPairs<2> make_block_pairs<2>(const Arrangement<2>&, const std::vector<int>&, PairList, const std::vector<double>&,
                                           bool);
template BlockPairs<3> make_block_pairs<3>(const Arrangement<3>&, const std::vector<int>&, PairList, const std::vector<double>&,
                                           bool);

}  // namespace sinew
