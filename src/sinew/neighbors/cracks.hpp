#pragma once
/// Where bodies have come apart, in the reference configuration: a failed particle sees nobody any more, and no pair of others sees each other through it.
/// This is the visibility criterion of meshless methods, with failed particles for the surface of the crack. Belytschko, Lu & Gu (1994).

#include <cstdint>
#include <sinew/neighbors/block_pairs.hpp>
#include <span>
#include <unordered_map>
#include <vector>

namespace sinew {

/// A particle that has separated from its body.
template <int D>
struct FailedParticle {
  Vec<double, D> place;  ///< reference position [length]
  double reach;          ///< pairs that pass by closer than that are cut [length]
  double radius;         ///< with which it touches others from now on: the room that it had when it failed [length]
  int body, number;      ///< number: in the user's order

  /// In spacings. A full plane of a cubic lattice lets no pair through (0.577 would be enough); nor does it cut pairs beside it (from 0.707 on).
  static constexpr double reach_in_spacings = 0.6;

  /// Whether it is in the way from a to b, or at one of them. The same for both directions, bit by bit.
  bool stands_between(const Vec<double, D>& a, const Vec<double, D>& b) const;

  static constexpr int width = D + 4;  ///< numbers in which it travels
  void append_to(std::vector<double>& rows) const;
  static FailedParticle from_row(const double* row);
};

/// All failed particles of a case, known to every rank.
template <int D>
class Cracks {
 public:
  /// `farthest`: the largest support radius of a particle [length].
  explicit Cracks(double farthest = 1.0) : edge_(farthest) {}

  void add(std::span<const FailedParticle<D>> failed);
  bool empty() const { return all_.empty(); }
  const std::vector<FailedParticle<D>>& all() const { return all_; }
  /// nullptr: has not failed.
  const FailedParticle<D>* find(int number) const;
  /// Whether there may be a cut pair at this place.
  bool near(const Vec<double, D>& place, int body) const;
  /// Whether the pair of particles at a and b, no farther apart than `farthest`, is cut.
  bool cuts(const Vec<double, D>& a, const Vec<double, D>& b, int body) const;

 private:
  using Cell = std::array<std::int64_t, D>;
  std::int64_t cell_along(double coordinate) const;
  static std::uint64_t key(const Cell& cell);
  template <class Test>
  bool any_in_box(Vec<double, D> low, Vec<double, D> high, Test&& test) const;

  double edge_, most_reach_ = 0.0;
  std::vector<FailedParticle<D>> all_;
  std::unordered_map<int, int> of_number_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

/// Takes the pairs of a block that some failed particles cut out of its lists: what is left in their place is fill. `radius`: support radius, by slot.
/// Returns the slices that have changed. The block has no lattice.
template <int D>
std::vector<int> cut_pairs(BlockPairs<D>& pairs, const Block& block, const Particles<D>& particles,
                           const AlignedArray<double>& radius, std::span<const FailedParticle<D>> failed);

extern template struct FailedParticle<2>;
extern template struct FailedParticle<3>;
extern template class Cracks<2>;
extern template class Cracks<3>;

}  // namespace sinew
