#include <sinew/neighbors/chunks.hpp>

#include <algorithm>

namespace sinew {

template <int D>
std::vector<Chunk> make_chunks(const Particles<D>& particles, const PairList& list) {
  constexpr int shortest = 256;  // slices: enough work to hide the start of a chunk
  std::vector<Chunk> chunks;
  for (std::size_t b = 0; b < particles.bodies.size(); ++b) {
    const BodyRange& body = particles.bodies[b];
    const int first = body.begin / lanes, slices = body.end / lanes - first;
    const int longest_reach = (reach(list, body.begin, body.end) + lanes - 1) / lanes;
    const int count = std::max(1, slices / std::max(shortest, 2 * longest_reach));
    for (int c = 0; c < count; ++c) {
      const auto cut = [&](int k) { return first + static_cast<int>(static_cast<long>(slices) * k / count); };
      chunks.push_back({static_cast<int>(b), cut(c), cut(c + 1), c % 2});
    }
  }
  return chunks;
}

template std::vector<Chunk> make_chunks<2>(const Particles<2>&, const PairList&);
template std::vector<Chunk> make_chunks<3>(const Particles<3>&, const PairList&);

}  // namespace sinew
