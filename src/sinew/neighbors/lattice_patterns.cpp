#include <sinew/neighbors/lattice_patterns.hpp>

#include <algorithm>

namespace sinew {

template <int D>
int LatticePatterns<D>::slices() const {
  return static_cast<int>(std::count_if(of_slice.begin(), of_slice.end(), [](int p) { return p != none; }));
}

template <int D>
void LatticePatterns<D>::append(const LatticePatterns& block) {
  const int first_pattern = static_cast<int>(patterns.size()), first_bond = static_cast<int>(bonds.size());
  const int first_mirrored = static_cast<int>(mirrored.size()), first_single = static_cast<int>(single.size());
  for (int pattern : block.of_slice) of_slice.push_back(pattern == none ? none : first_pattern + pattern);
  for (const LatticePattern& p : block.patterns)
    patterns.push_back({p.first_mirrored + first_mirrored, p.end_mirrored + first_mirrored, p.first_single + first_single,
                        p.end_single + first_single});
  for (const MirrorPair& p : block.mirrored) mirrored.push_back({p.forward, p.backward, p.bond + first_bond});
  for (const SinglePair& p : block.single) single.push_back({p.offset, p.bond + first_bond, p.members});
  volumes.insert(volumes.end(), block.volumes.begin(), block.volumes.end());
  bonds.insert(bonds.end(), block.bonds.begin(), block.bonds.end());
  farthest = std::max(farthest, block.farthest);
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
