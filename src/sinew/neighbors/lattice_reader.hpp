#pragma once
/// Finds lattice patterns, while pairs are laid out.

#include <cstdint>
#include <sinew/neighbors/block_layout.hpp>
#include <sinew/neighbors/lattice_patterns.hpp>
#include <unordered_map>
#include <vector>

namespace sinew {

/// The neighbors of a slice at one distance in places.
template <int D>
struct Offset {
  int offset = 0;
  std::uint8_t members = 0;  ///< all eight if all own particles of the slice have one
  Bond<D> bond;
};

/// All that a pattern depends on.
template <int D>
struct SliceShape {
  std::vector<Offset<D>> offsets;  ///< empty: no pattern
  SliceVolumes volume{};
};

/// Shapes of the slices of a block, each kept once.
template <int D>
struct BlockShapes {
  std::vector<SliceShape<D>> distinct;
  std::vector<int> of_slice;  ///< slice -> shape; empty if less than half of them have one
};

template <int D>
class LatticeReader {
 public:
  LatticeReader(const Arrangement<D>& particles, const std::vector<double>& radius);

  /// Shapes of slices of a block, which begin at these places.
  BlockShapes<D> read(const BlockLayout<D>& layout, const std::vector<int>& slices) const;
  bool same(const Bond<D>& a, const Bond<D>& b, double sign = 1.0) const;

 private:
  void read(const BlockLayout<D>& layout, int place, std::vector<int> (&rows)[lanes], SliceShape<D>& shape) const;
  bool same(const SliceShape<D>& a, const SliceShape<D>& b) const;
  Bond<D> bond_of(int i, int j) const;

  const Arrangement<D>& particles_;
  const std::vector<double>& radius_;
  double tolerance_ = 0.0;
};

/// The patterns met so far in a block.
template <int D>
class LatticeDictionary {
 public:
  LatticeDictionary(const LatticeReader<D>& reader, LatticePatterns<D>& lattice) : reader_(reader), lattice_(lattice) {}

  /// The number of the pattern, new or known; `none` if there are too many bonds.
  int number_of(const SliceShape<D>& shape);

 private:
  bool matches(const SliceShape<D>& shape, int pattern) const;
  int bond_number(const Bond<D>& bond);
  void add(const SliceShape<D>& shape);

  const LatticeReader<D>& reader_;
  LatticePatterns<D>& lattice_;
  std::vector<std::vector<SinglePair>> sources_;  ///< what each pattern was made of
  std::unordered_map<std::uint64_t, std::vector<int>> known_;
};

extern template class LatticeReader<2>;
extern template class LatticeReader<3>;
extern template class LatticeDictionary<2>;
extern template class LatticeDictionary<3>;

}  // namespace sinew
