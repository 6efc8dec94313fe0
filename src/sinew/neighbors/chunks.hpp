#pragma once
/// Fixed chunks: the order of a body is cut into pieces that depend on the case alone, never on the machine. A chunk adds its pair forces,
/// in list order, to one of two streams (even and odd chunks). A chunk is at least twice as long as the reach of its pairs, so
/// chunks of one stream never write the same row: any number of threads gives the same bits.

#include <sinew/neighbors/pair_list.hpp>
#include <vector>

namespace sinew {

struct Chunk {
  int body = 0;
  int first_slice = 0, end_slice = 0;
  int stream = 0;  ///< 0 or 1
};

template <int D>
std::vector<Chunk> make_chunks(const Particles<D>& particles, const PairList& list);

/// Fewer particles than this are done by one thread: starting and joining a team would cost more than it saves.
inline constexpr int fewest_for_threads = 16384;

/// Calls work(chunk, number) for every chunk, on all threads.
template <class Work>
void for_each_chunk(const std::vector<Chunk>& chunks, Work&& work) {
  const int count = static_cast<int>(chunks.size());
  const bool many = !chunks.empty() && lanes * chunks.back().end_slice >= fewest_for_threads;
#pragma omp parallel for schedule(dynamic, 1) if (count > 1 && many)
  for (int c = 0; c < count; ++c) work(chunks[c], c);
}

/// Calls work(begin, end) for pieces of [0, slots) on whole slices, on all threads. For work in which particles do not meet.
template <class Work>
void for_each_piece(int slots, Work&& work) {
  constexpr int piece = 2048;
  const int count = (slots + piece - 1) / piece;
#pragma omp parallel for schedule(static) if (slots >= fewest_for_threads)
  for (int p = 0; p < count; ++p) work(p * piece, slots < (p + 1) * piece ? slots : (p + 1) * piece);
}

/// Forces as vector rows in two streams.
template <int D>
struct ForceStreams {
  AlignedArray<double> stream[2];
  explicit ForceStreams(int slots)
      : stream{AlignedArray<double>(std::size_t(slots) * vector_width<D>),
               AlignedArray<double>(std::size_t(slots) * vector_width<D>)} {}
  std::size_t bytes() const { return stream[0].bytes() + stream[1].bytes(); }
};

}  // namespace sinew
