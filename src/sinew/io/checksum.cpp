#include <sinew/io/checksum.hpp>

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <zlib.h>

namespace sinew {

namespace {

constexpr std::size_t piece = std::size_t{1} << 24;
constexpr std::string_view mark = "\nsinew crc32 ";

/// Continues a checksum with some bytes of a file. A file that ends too early changes it.
std::uint32_t crc32_of_bytes(std::ifstream& file, ByteRange range, std::uint32_t crc) {
  std::string some;
  file.seekg(static_cast<std::streamoff>(range.begin));
  while (range.length > 0) {
    some.resize(std::min(piece, range.length));
    file.read(some.data(), static_cast<std::streamsize>(some.size()));
    if (!file) return ~crc;
    crc = crc32_of(some, crc);
    range.length -= some.size();
  }
  return crc;
}

}  // namespace

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before) {
  uLong crc = before;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size())))  // zlib counts in 32 bits
    crc = crc32(crc, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(std::min(piece, bytes.size())));
  return static_cast<std::uint32_t>(crc);
}

std::uint32_t crc32_of_all(const Comm& comm, std::span<const double> values) {
  const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  const double own[] = {static_cast<double>(crc32_of(bytes)), static_cast<double>(bytes.size())};
  const std::vector<double> all = comm.gather_all(own);
  uLong crc = 0;
  for (std::size_t k = 0; k < all.size(); k += 2)
    crc = crc32_combine(crc, static_cast<uLong>(all[k]), static_cast<z_off_t>(all[k + 1]));
  return static_cast<std::uint32_t>(crc);
}

std::string checksum_line(const std::string& path, std::size_t size, const std::vector<ByteRange>& without) {
  std::ifstream file(path, std::ios::binary);
  std::uint32_t crc = 0;
  std::size_t begin = 0;
  std::string ranges;
  for (const ByteRange& range : without) {
    crc = crc32_of_bytes(file, {begin, range.begin - begin}, crc);
    begin = range.begin + range.length;
    ranges += fmt::format(" {}+{}", range.begin, range.length);
  }
  crc = crc32_of_bytes(file, {begin, size - begin}, crc);
  return fmt::format("{}{:08x}{}{}\n", mark, crc, ranges.empty() ? "" : " without", ranges);
}

bool has_right_checksum(const std::string& path) {
  constexpr std::size_t longest_line = 4096;
  const std::size_t size = std::filesystem::file_size(path);
  std::ifstream file(path, std::ios::binary);
  std::string end(std::min(longest_line, size), '\0');
  file.seekg(static_cast<std::streamoff>(size - end.size()));
  file.read(end.data(), static_cast<std::streamsize>(end.size()));
  const std::size_t at = end.rfind(mark);
  if (!file || at == std::string::npos) return false;
  const std::string line = end.substr(at);
  const std::size_t covered = size - line.size();
  std::vector<ByteRange> without;
  std::size_t reached = 0;
  const std::size_t first = std::min(line.find(" without"), line.size() - 1);
  for (std::size_t next = first; (next = line.find(' ', next + 1)) != std::string::npos;) {
    std::size_t begin = 0, length = 0;
    if (std::sscanf(line.c_str() + next, " %zu+%zu", &begin, &length) != 2) return false;
    if (begin < reached || begin > covered || length > covered - begin) return false;
    without.push_back({begin, length});
    reached = begin + length;
  }
  return checksum_line(path, covered, without) == line;
}

}  // namespace sinew
