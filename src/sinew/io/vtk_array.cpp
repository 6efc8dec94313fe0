#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <sinew/io/vtk_array.hpp>
#include <utility>

namespace sinew {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> entities{
    {{"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}}};

/// Twelve bits as two characters: half the look-ups of one character at a time, and still in the innermost cache.
constexpr auto character_pairs = [] {
  std::array<std::array<char, 2>, 4096> pairs{};
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {alphabet[i >> 6], alphabet[i & 63]};
  return pairs;
}();

constexpr std::size_t length_of_base64(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

/// The upper 12 `pairs` bits of the word as characters.
template <int pairs>
void put_characters(char* to, std::uint64_t word) {
  for (int k = 0; k < pairs; ++k) std::memcpy(to + 2 * k, character_pairs[(word >> (52 - 12 * k)) & 4095].data(), 2);
}

/// Eight bytes, the first one in the highest bits.
std::uint64_t big_endian(const std::byte* from) {
  static_assert(std::endian::native == std::endian::little);  // as the byte_order in the files says
  std::uint64_t word;
  std::memcpy(&word, from, sizeof word);
  return __builtin_bswap64(word);
}

/// Six bytes become eight characters in one go; up to eight are read, so the last ones go one group of three at a time.
void encode(std::span<const std::byte> data, char* to) {
  std::size_t i = 0;
  for (; i + 8 <= data.size(); i += 6, to += 8) put_characters<4>(to, big_endian(data.data() + i));
  for (; i < data.size(); i += 3, to += 4) {
    std::byte group[8] = {};
    const std::size_t size = std::min<std::size_t>(3, data.size() - i);
    std::memcpy(group, data.data() + i, size);
    put_characters<2>(to, big_endian(group));
    for (std::size_t k = size; k < 3; ++k) to[k + 1] = '=';
  }
}

}  // namespace

std::string base64(std::span<const std::byte> data) {
  std::string text(length_of_base64(data.size()), '=');
  encode(data, text.data());
  return text;
}

std::size_t VtkArrayStream::length(std::size_t bytes) { return length_of_base64(sizeof(std::uint64_t) + bytes); }

VtkArrayStream::VtkArrayStream(PartFile& file, std::size_t bytes, std::size_t place, const Range& range) : file_(file) {
  const std::uint64_t header = bytes;
  const auto next_group = [](std::size_t byte) { return (byte + 2) / 3 * 3; };
  const std::size_t whole = bytes + sizeof header, from = range.leads ? 0 : range.begin + sizeof header;
  const std::size_t to = range.end == bytes ? whole : next_group(range.end + sizeof header);
  skip_ = next_group(from) - from;
  left_ = to > next_group(from) ? to - next_group(from) : 0;
  file_.seek(place + next_group(from) / 3 * 4);
  if (range.leads) put(std::as_bytes(std::span(&header, 1)));
}

void VtkArrayStream::put(std::span<const std::byte> data) {
  const std::size_t before = std::min(skip_, data.size());
  skip_ -= before;
  data = data.subspan(before, std::min(left_, data.size() - before));
  left_ -= data.size();
  while (!data.empty()) {
    const std::size_t size = std::min(data.size(), block_.size() - used_);
    std::memcpy(block_.data() + used_, data.data(), size);
    used_ += size;
    data = data.subspan(size);
    if (used_ == block_.size()) write_block();
  }
}

void VtkArrayStream::end() { write_block(); }

void VtkArrayStream::write_block() {
  std::array<char, length_of_base64(std::tuple_size_v<decltype(block_)>)> text;
  encode(std::span(block_).first(used_), text.data());
  if (used_ > 0) file_.write({text.data(), length_of_base64(used_)});
  used_ = 0;
}

std::string xml_escape(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto entity = std::find_if(entities.begin(), entities.end(), [c](const auto& e) { return e.second[0] == c; });
    if (entity == entities.end())
      out += c;
    else
      out += entity->first;
  }
  return out;
}

std::string xml_unescape(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const auto entity =
        std::find_if(entities.begin(), entities.end(), [text](const auto& e) { return text.starts_with(e.first); });
    if (entity == entities.end()) {
      out += text.front();
      text.remove_prefix(1);
    } else {
      out += entity->second;
      text.remove_prefix(entity->first.size());
    }
  }
  return out;
}

}  // namespace sinew
