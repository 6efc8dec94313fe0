#pragma once
/// Memory for many small arrays of which the number is not known before. What is kept stays in place.

#include <algorithm>
#include <cstring>
#include <sinew/particles/aligned_array.hpp>
#include <vector>

namespace sinew {

/// Takes memory in pieces that grow: huge pages where there is much to keep, which costs far less than as many small ones.
class Store {
 public:
  /// Copies the first `count` values.
  template <class T>
  const T* keep(const std::vector<T>& values, std::size_t count) {
    constexpr std::size_t line = 64;
    const std::size_t bytes = (count * sizeof(T) + line - 1) / line * line;
    if (pieces_.empty() || used_ + bytes > pieces_.back().size()) {
      const std::size_t next = pieces_.empty() ? smallest_piece : std::min(2 * pieces_.back().size(), largest_piece);
      pieces_.emplace_back(std::max(bytes, next));
      used_ = 0;
    }
    char* kept = pieces_.back().data() + used_;
    if (count > 0) std::memcpy(kept, values.data(), count * sizeof(T));
    used_ += bytes;
    return reinterpret_cast<const T*>(kept);
  }

 private:
  static constexpr std::size_t smallest_piece = std::size_t{1} << 16, largest_piece = std::size_t{1} << 22;
  std::vector<AlignedArray<char>> pieces_;
  std::size_t used_ = 0;  ///< of the last piece
};

}  // namespace sinew
