#pragma once
/// Threads of this process.

#include <omp.h>

#include <cstddef>

namespace sinew {

/// Fewer particles than this are done by one thread: starting and joining a team would cost more than it saves. Tests lower it.
inline int fewest_for_threads = 16384;

/// Threads that a loop may use, and the number of the one that asks.
inline std::size_t most_threads() { return static_cast<std::size_t>(omp_get_max_threads()); }
inline std::size_t this_thread() { return static_cast<std::size_t>(omp_get_thread_num()); }

/// Calls work(begin, end) for pieces of [0, slots) on whole slices, on all threads. For work in which particles do not meet.
template <class Work>
void for_each_piece(int slots, Work&& work) {
  constexpr int piece = 2048;
  const int count = (slots + piece - 1) / piece;
#pragma omp parallel for schedule(static) if (slots >= fewest_for_threads)
  for (int p = 0; p < count; ++p) work(p * piece, slots < (p + 1) * piece ? slots : (p + 1) * piece);
}

}  // namespace sinew
