#include <sinew/neighbors/lattice_patterns.hpp>

#include <algorithm>

namespace sinew {

template <int D>
int LatticePatterns<D>::slices() const {
  return static_cast<int>(std::count_if(of_slice.begin(), of_slice.end(), [](int p) { return p != none; }));
}

template <int D>
std::vector<int> LatticePatterns<D>::offsets(int pattern, int lane) const {
  std::vector<int> all;
  const LatticePattern& p = patterns[pattern];
  for (int k = p.first_mirrored; k < p.end_mirrored; ++k)
    for (int offset : {mirrored[k].forward, mirrored[k].backward}) all.push_back(offset);
  for (int k = p.first_single; k < p.end_single; ++k)
    if ((single[k].members >> lane & 1) != 0) all.push_back(single[k].offset);
  return all;
}

template <int D>
std::size_t LatticePatterns<D>::bytes() const {
  return of_slice.size() * sizeof(int) + patterns.size() * (sizeof(LatticePattern) + sizeof(SliceVolumes)) +
         mirrored.size() * sizeof(MirrorPair) + single.size() * sizeof(SinglePair) + bonds.size() * sizeof(Bond<D>);
}

template struct LatticePatterns<2>;
template struct LatticePatterns<3>;

}  // namespace sinew
