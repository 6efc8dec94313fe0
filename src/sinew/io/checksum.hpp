#pragma once
/// CRC-32 of what several ranks have, and of files but for some of their bytes.

#include <cstdint>
#include <sinew/parallel/comm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0);
/// Of the numbers of all ranks, rank after rank. Collective.
std::uint32_t crc32_of_all(const Comm& comm, std::span<const double> values);

/// Bytes [begin, begin + length) of a file.
struct ByteRange {
  std::size_t begin, length;
};

/// The line that ends a file: the checksum of the first `size` bytes without those of the ranges, which ascend.
std::string checksum_line(const std::string& path, std::size_t size, const std::vector<ByteRange>& without);
/// Whether such a line ends the file, and is right.
bool has_right_checksum(const std::string& path);

}  // namespace sinew
