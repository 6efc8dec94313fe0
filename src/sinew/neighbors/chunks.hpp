#pragma once
/// Fixed chunks: the order of a body is cut into pieces that depend on the case alone, never on the machine. A chunk adds its pair forces,
/// in list order, to one of two streams (even and odd chunks). A chunk is at least twice as long as the reach of its pairs, so
/// chunks of one stream never write the same row: any number of threads gives the same bits.

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <sinew/neighbors/pair_list.hpp>
#include <sinew/particles/rows.hpp>
#include <vector>

namespace sinew {

struct Chunk {
  int body = 0;
  int first_slice = 0, end_slice = 0;
  int stream = 0;  ///< 0 or 1
};

template <int D>
std::vector<Chunk> make_chunks(const Particles<D>& particles, const PairList& list);

/// Fewer particles than this are done by one thread: starting and joining a team would cost more than it saves. Tests lower it.
inline int fewest_for_threads = 16384;

/// Threads that a loop may use, and the number of the one that asks.
inline std::size_t most_threads() { return static_cast<std::size_t>(omp_get_max_threads()); }
inline std::size_t this_thread() { return static_cast<std::size_t>(omp_get_thread_num()); }

/// Counts, for each chunk, how many of itself and its two neighbors in the body are still to be done.
class ChunkCountdown {
 public:
  explicit ChunkCountdown(const std::vector<Chunk>& chunks) : chunks_(chunks), left_(chunks.size()) {}

  void start() {
    for (int c = 0; c < count(); ++c) left_[c].store(1 + beside(c, c - 1) + beside(c, c + 1), std::memory_order_relaxed);
  }
  /// To be called when chunk c is done: calls finish(chunk) for every chunk of which that was the last neighbor.
  template <class Finish>
  void done(int c, Finish&& finish) {
    for (int n = c - 1; n <= c + 1; ++n)
      if ((n == c || beside(c, n)) && left_[n].fetch_sub(1, std::memory_order_acq_rel) == 1) finish(chunks_[n]);
  }

 private:
  int count() const { return static_cast<int>(chunks_.size()); }
  bool beside(int c, int n) const { return n >= 0 && n < count() && chunks_[n].body == chunks_[c].body; }

  const std::vector<Chunk>& chunks_;
  std::vector<std::atomic<int>> left_;
};

/// Calls work(chunk, number) for every chunk and finish(chunk) for those whose rows no chunk will write any more, on all threads.
template <class Work, class Finish>
void for_each_chunk(const std::vector<Chunk>& chunks, ChunkCountdown& countdown, Work&& work, Finish&& finish) {
  const int count = static_cast<int>(chunks.size());
  const bool many = !chunks.empty() && lanes * chunks.back().end_slice >= fewest_for_threads;
  countdown.start();
#pragma omp parallel for schedule(dynamic, 1) if (count > 1 && many)
  for (int c = 0; c < count; ++c) {
    work(chunks[c], c);
    countdown.done(c, finish);
  }
}

/// Calls work(begin, end) for pieces of [0, slots) on whole slices, on all threads. For work in which particles do not meet.
template <class Work>
void for_each_piece(int slots, Work&& work) {
  constexpr int piece = 2048;
  const int count = (slots + piece - 1) / piece;
#pragma omp parallel for schedule(static) if (slots >= fewest_for_threads)
  for (int p = 0; p < count; ++p) work(p * piece, slots < (p + 1) * piece ? slots : (p + 1) * piece);
}

/// Pair forces, in two streams. Slices with a pair list add to vector rows, slices of a lattice to fields; what no slice uses is empty.
template <int D>
struct ForceStreams {
  AlignedArray<double> rows[2];
  VectorField<D> fields[2];

  ForceStreams(int slots, bool with_rows, bool with_fields) {
    for (int s = 0; s < 2; ++s) {
      if (with_rows) rows[s] = AlignedArray<double>(std::size_t(slots) * vector_width<D>);
      if (with_fields) fields[s] = VectorField<D>(slots);
    }
  }
  bool has_rows() const { return rows[0].size() > 0; }
  bool has_fields() const { return !fields[0].empty(); }

  /// Adds to one component of the force on a particle.
  void add(int component, int slot, double force) {
    (has_rows() ? rows[0][std::size_t(vector_width<D>) * slot + component] : fields[0].at(component, slot)) += force;
  }
  /// The sum of all streams.
  Vec<double, D> on(int slot) const {
    Vec<double, D> f;
    for (int c = 0; c < D; ++c) {
      if (has_rows()) f[c] += rows[0][std::size_t(vector_width<D>) * slot + c] + rows[1][std::size_t(vector_width<D>) * slot + c];
      if (has_fields()) f[c] += fields[0].at(c, slot) + fields[1].at(c, slot);
    }
    return f;
  }
  /// Zeros for slots [begin, end).
  void clear(int begin, int end) {
    for (int s = 0; s < 2; ++s) {
      if (has_rows())
        std::fill(rows[s].data() + std::size_t(vector_width<D>) * begin, rows[s].data() + std::size_t(vector_width<D>) * end,
                  0.0);
      for (int c = 0; has_fields() && c < D; ++c) std::fill(fields[s].component(c) + begin, fields[s].component(c) + end, 0.0);
    }
  }
  std::size_t bytes() const { return rows[0].bytes() + rows[1].bytes() + fields[0].bytes() + fields[1].bytes(); }
};

/// Writes one component of the forces on slots [begin, end) to `total` and clears the streams there.
template <int D>
void take_forces(ForceStreams<D>& forces, int component, int begin, int end, double* __restrict total) {
  std::fill(total + begin, total + end, 0.0);
  if (forces.has_rows()) {
    constexpr std::size_t n = vector_width<D>;
    double* __restrict even = forces.rows[0].data() + component;
    double* __restrict odd = forces.rows[1].data() + component;
    for (int slot = begin; slot < end; ++slot) {
      total[slot] += even[n * slot] + odd[n * slot];
      even[n * slot] = odd[n * slot] = 0.0;
    }
  }
  if (forces.has_fields()) {
    double* __restrict even = forces.fields[0].component(component);
    double* __restrict odd = forces.fields[1].component(component);
    for (int slot = begin; slot < end; ++slot) {
      total[slot] += even[slot] + odd[slot];
      even[slot] = odd[slot] = 0.0;
    }
  }
}

}  // namespace sinew
