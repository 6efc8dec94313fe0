#include <sinew/parallel/share.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace sinew {

namespace {

/// Numbers the slots of own blocks, body after body, each body in whole slices.
template <int D>
void number_own(const Arrangement<D>& all, Share& share) {
  share.local_of.assign(all.slots, Blocks::nobody);
  int body = -1;
  for (const int number : share.blocks) {
    const BlockRange& block = all.blocks[number];
    if (block.body != body) share.slots = whole_slices(share.slots), body = block.body;
    for (int slot = block.begin; slot < block.end; ++slot) share.local_of[slot] = share.slots++;
  }
  share.slots = whole_slices(share.slots);
}

void add_stretch(std::vector<Stretch>& stretches, int begin, int length) {
  if (!stretches.empty() && stretches.back().begin + stretches.back().length == begin)
    stretches.back().length += length;
  else
    stretches.push_back({begin, length});
}

/// Places of forces on ghosts that other ranks own, by rank. They are described to these: from, to, runs, then slot and length of each run.
std::vector<Parcel> parcels_of_spills(const Share& share, const Blocks& blocks, std::vector<std::vector<int>>& described) {
  std::map<int, Parcel> parcels;
  for (std::size_t s = 0; s < blocks.out.size(); ++s) {
    if (blocks.told[s] != Blocks::nobody) continue;
    const Spill& spill = blocks.out[s];
    const int rank = share.owner[spill.to];
    Parcel& parcel = parcels.try_emplace(rank, Parcel{rank, {}}).first->second;
    described[rank].insert(described[rank].end(), {spill.from, spill.to, spill.end_run - spill.first_run});
    for (int r = spill.first_run; r < spill.end_run; ++r) {
      const Run& run = blocks.runs[r];
      described[rank].insert(described[rank].end(), {run.slot, run.length});
      add_stretch(parcel.stretches, run.spill, run.length);
    }
  }
  std::vector<Parcel> all;
  for (auto& [rank, parcel] : parcels) all.push_back(std::move(parcel));
  return all;
}

/// Appends the spills that another rank has described, and says where their forces will be received.
Parcel append_received(int rank, const std::vector<int>& description, const Share& share, Blocks& blocks) {
  Parcel parcel{rank, {}};
  for (auto next = description.begin(); next != description.end();) {
    Spill spill{next[0], next[1], static_cast<int>(blocks.runs.size()), 0};
    const int count = next[2];
    next += 3;
    for (int r = 0; r < count; ++r, next += 2) {
      blocks.runs.push_back({share.local_of[next[0]], 0, next[1], blocks.ghosts});
      add_stretch(parcel.stretches, blocks.ghosts, next[1]);
      blocks.ghosts += next[1];
    }
    spill.end_run = static_cast<int>(blocks.runs.size());
    blocks.received.push_back(spill);
  }
  return parcel;
}

/// From slots of the whole to slots of the share.
template <int D>
void renumber(BlockPairs<D>& pairs, const Share& share) {
  Blocks& blocks = pairs.blocks;
  std::vector<int> counts(share.slots, 0);
  for (std::size_t slot = 0; slot < share.local_of.size(); ++slot)
    if (const int here = share.local_of[slot]; here != Blocks::nobody && here < share.slots)
      counts[here] = pairs.neighbor_count[slot];
  pairs.neighbor_count = std::move(counts);
  for (Block& block : blocks.all) {
    const int length = block.end - block.begin;
    block.begin = share.local_of[block.begin];
    block.end = block.begin + length;
  }
  for (Run& run : blocks.runs) run.slot = share.local_of[run.slot];
  for (int& slot : blocks.slot_at)
    if (slot != Blocks::nobody) slot = share.local_of[slot];
}

/// Displacements and matrices of copies, in the order in which they are kept here; no forces yet.
template <int D>
Halo halo_of_copies(const Comm& comm, const Share& share) {
  std::vector<std::vector<int>> wanted(comm.size());
  std::vector<Parcel> in, out;
  int next = share.slots;
  for (const Share::Copies& from : share.copies) {
    const int count = static_cast<int>(from.slots.size());
    wanted[from.rank] = from.slots;
    in.push_back({from.rank, {{next, count}}});
    next += count;
  }
  const std::vector<std::vector<int>> asked = comm.exchange(wanted);
  for (int rank = 0; rank < comm.size(); ++rank) {
    Parcel parcel{rank, {}};
    for (const int slot : asked[rank]) add_stretch(parcel.stretches, share.local_of[slot], 1);
    if (!parcel.stretches.empty()) out.push_back(std::move(parcel));
  }
  return {{comm, D, VectorField<D>::stride_of(next), out, in}, {comm, D * D, VectorField<D * D>::stride_of(next), out, in}, {}};
}

}  // namespace

int Share::copied() const {
  std::size_t count = 0;
  for (const Copies& from : copies) count += from.slots.size();
  return static_cast<int>(count);
}

template <int D>
Share make_share(const Comm& comm, const Arrangement<D>& all, std::vector<int> owner, const Blocks& blocks) {
  Share share;
  share.owner = std::move(owner);
  for (const Block& block : blocks.all) share.blocks.push_back(block.number);
  number_own(all, share);
  std::map<int, std::set<int>> wanted;
  for (const Spill& spill : blocks.out) {
    const int rank = share.owner[spill.to];
    if (rank == comm.rank()) continue;
    for (int r = spill.first_run; r < spill.end_run; ++r)
      for (int k = 0; k < blocks.runs[r].length; ++k) wanted[rank].insert(blocks.runs[r].slot + k);
  }
  int next = share.slots;
  for (const auto& [rank, slots] : wanted) {
    share.copies.push_back({rank, {slots.begin(), slots.end()}});
    for (const int slot : slots) share.local_of[slot] = next++;
  }
  return share;
}

template <int D>
Arrangement<D> part_of(const Arrangement<D>& all, const Share& share) {
  Arrangement<D> part;
  part.slots = share.slots;
  for (const BodyRange& body : all.bodies) part.bodies.push_back({body.name, 0, 0, 0, body.spacing, body.density});
  for (const int number : share.blocks) {
    const BlockRange& block = all.blocks[number];
    const int begin = share.local_of[block.begin], length = block.end - block.begin;
    part.blocks.push_back({block.body, begin, begin + length, number});
    BodyRange& body = part.bodies[block.body];
    if (body.count == 0) body.begin = begin;
    body.count += length;
    body.end = whole_slices(begin + length);
    part.count += length;
  }
  for (std::size_t b = 0; b < part.bodies.size(); ++b)
    if (part.bodies[b].count == 0) part.bodies[b].begin = part.bodies[b].end = b > 0 ? part.bodies[b - 1].end : 0;
  const std::size_t places = static_cast<std::size_t>(share.slots) + share.copied();
  part.position = VectorField<D>(places);
  part.volume = AlignedArray<double>(places);
  part.user_index.assign(share.slots, -1);
  for (int slot = 0; slot < all.slots; ++slot) {
    const int here = share.local_of[slot];
    if (here == Blocks::nobody) continue;
    for (int c = 0; c < D; ++c) part.position.at(c, here) = all.position.at(c, slot);
    part.volume[here] = all.volume[slot];
    if (here < share.slots) part.user_index[here] = all.user_index[slot];
  }
  for (const BodyRange& body : part.bodies)  // padding stands on the last particle
    for (int slot = body.begin + body.count; slot < body.end; ++slot)
      for (int c = 0; c < D; ++c) part.position.at(c, slot) = part.position.at(c, slot - 1);
  return part;
}

template <int D>
Halo distribute(const Comm& comm, const Share& share, BlockPairs<D>& pairs) {
  Blocks& blocks = pairs.blocks;
  std::vector<std::vector<int>> described(comm.size());
  const std::vector<Parcel> out = parcels_of_spills(share, blocks, described);
  const std::vector<std::vector<int>> descriptions = comm.exchange(described);
  renumber(pairs, share);
  std::vector<Parcel> in;
  for (int rank = 0; rank < comm.size(); ++rank)
    if (!descriptions[rank].empty()) in.push_back(append_received(rank, descriptions[rank], share, blocks));
  blocks.connect();
  Halo halo = halo_of_copies<D>(comm, share);
  halo.forces = {comm, D, VectorField<D>::stride_of(blocks.ghosts), out, in};
  return halo;
}

template <int D>
SharedPairs<D> share_pairs(const Comm& comm, const Arrangement<D>& all, std::vector<int> owner, const std::vector<double>& radius,
                           bool look_for_lattice) {
  SharedPairs<D> shared;
  comm.together([&] {
    std::vector<int> own;
    for (std::size_t b = 0; b < owner.size(); ++b)
      if (owner[b] == comm.rank()) own.push_back(static_cast<int>(b));
    shared.pairs = make_block_pairs(all, own, build_pair_list(all, radius), radius, look_for_lattice);
  });
  shared.share = make_share(comm, all, std::move(owner), shared.pairs.blocks);
  shared.halo = distribute(comm, shared.share, shared.pairs);
  return shared;
}

template SharedPairs<2> share_pairs<2>(const Comm&, const Arrangement<2>&, std::vector<int>, const std::vector<double>&, bool);
template SharedPairs<3> share_pairs<3>(const Comm&, const Arrangement<3>&, std::vector<int>, const std::vector<double>&, bool);
template Share make_share<2>(const Comm&, const Arrangement<2>&, std::vector<int>, const Blocks&);
template Share make_share<3>(const Comm&, const Arrangement<3>&, std::vector<int>, const Blocks&);
template Arrangement<2> part_of<2>(const Arrangement<2>&, const Share&);
template Arrangement<3> part_of<3>(const Arrangement<3>&, const Share&);
template Halo distribute<2>(const Comm&, const Share&, BlockPairs<2>&);
template Halo distribute<3>(const Comm&, const Share&, BlockPairs<3>&);

}  // namespace sinew
