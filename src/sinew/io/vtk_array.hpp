#pragma once
/// Arrays as the XML formats of VTK hold them.

#include <algorithm>
#include <array>
#include <cstddef>
#include <sinew/io/file.hpp>
#include <span>
#include <string>
#include <string_view>

namespace sinew {

/// RFC 4648, with padding.
std::string base64(std::span<const std::byte> data);

/// The text of a binary inline <DataArray> with header_type UInt64 and no compressor: base64 of the number of bytes and the bytes
/// in one go. The bytes come piece by piece and go to the file block by block, so no array is ever in memory as a text. Of several writers each brings the
/// bytes of its range and the first two of the next; groups of three, which become four characters, belong to whom their first byte belongs.
class VtkArrayStream {
 public:
  /// All of `bytes`.
  VtkArrayStream(PartFile& file, std::size_t bytes) : VtkArrayStream(file, bytes, 0, {0, bytes, true}) {}
  /// Bytes [begin, end); before them the number of bytes if this writer leads.
  struct Range {
    std::size_t begin, end;
    bool leads;
  };
  /// Some of an array of `bytes` whose text begins at `place` of the file.
  VtkArrayStream(PartFile& file, std::size_t bytes, std::size_t place, const Range& range);
  void put(std::span<const std::byte> data);
  void end();  ///< what is left; to be called once, after all bytes
  /// Characters of the text.
  static std::size_t length(std::size_t bytes);

 private:
  void write_block();

  PartFile& file_;
  std::array<std::byte, 49152> block_;  // a multiple of three: only the last block needs padding
  std::size_t used_ = 0;
  std::size_t skip_, left_;  ///< bytes that belong to the writer before, and that are still to be taken after them
};

/// value(0), value(1), ... value(count - 1), each computed when it is written.
template <class T, class Value>
void put_values(VtkArrayStream& stream, std::size_t count, const Value& value) {
  std::array<T, 1024> some;
  for (std::size_t begin = 0; begin < count; begin += some.size()) {
    const std::size_t size = std::min(some.size(), count - begin);
    for (std::size_t k = 0; k < size; ++k) some[k] = static_cast<T>(value(begin + k));
    stream.put(std::as_bytes(std::span(some).first(size)));
  }
}

/// The text with & < > " replaced by entities, and back.
std::string xml_escape(std::string_view text);
std::string xml_unescape(std::string_view text);

}  // namespace sinew
