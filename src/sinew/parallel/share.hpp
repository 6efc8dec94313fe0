#pragma once
/// What one rank has of a case: some blocks, and copies of the particles of other ranks that their pairs reach ("halo").

#include <sinew/neighbors/block_pairs.hpp>
#include <sinew/parallel/exchange.hpp>
#include <vector>

namespace sinew {

struct Share {
  std::vector<int> owner;     ///< number of a block -> rank
  std::vector<int> blocks;    ///< numbers of the own ones, ascending
  std::vector<int> local_of;  ///< slot of the whole -> slot here; Blocks::nobody: neither own nor copied
  int slots = 0;              ///< of own particles and padding; copies follow

  struct Copies {
    int rank;                ///< to which they belong
    std::vector<int> slots;  ///< of the whole, ascending
  };
  std::vector<Copies> copies;  ///< by rank

  int copied() const;
};

/// The share of a rank, once the pairs of its blocks are known.
template <int D>
Share make_share(const Comm& comm, const Arrangement<D>& all, std::vector<int> owner, const Blocks& blocks);

/// The reference configuration of the share.
template <int D>
Arrangement<D> part_of(const Arrangement<D>& all, const Share& share);

/// The exchanges of a step: displacements of copies come in (and other vectors, and matrices), forces on them go back.
struct Halo {
  Exchange displacements;
  Exchange matrices;
  Exchange forces;
};

/// Turns the pairs of the own blocks from slots of the whole to slots of the share, tells the other ranks which of their particles these see,
/// and makes room for the forces that come from theirs. Collective.
template <int D>
Halo distribute(const Comm& comm, const Share& share, BlockPairs<D>& pairs);

/// A configuration as one rank has it.
template <int D>
struct SharedPairs {
  BlockPairs<D> pairs;
  Share share;
  Halo halo;
};

/// The pairs of a rank. `radius`: of the supports of its particles, by slot of the whole, 0 of others. Collective.
template <int D>
SharedPairs<D> share_pairs(const Comm& comm, const Arrangement<D>& all, std::vector<int> owner, const std::vector<double>& radius,
                           bool look_for_lattice);

}  // namespace sinew
