#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <sinew/io/vtk_array.hpp>
#include <stdexcept>
#include <utility>
#include <vector>
#include <zlib.h>

namespace sinew {

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18;  // large enough to compress well, small enough for the cache
constexpr int compression_level = 1;
constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> entities{
    {{"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}}};

using Bytes = std::vector<std::byte>;

/// Twelve bits as two characters: half the look-ups of one character at a time.
constexpr auto character_pairs = [] {
  std::array<std::array<char, 2>, 4096> pairs{};
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {alphabet[i >> 6], alphabet[i & 63]};
  return pairs;
}();

/// Computed numbers hardly ever repeat: looking for strings that occurred before takes three times as long and gains nothing.
int strategy(ArrayContent content) { return content == ArrayContent::computed ? Z_RLE : Z_DEFAULT_STRATEGY; }

/// Empty if zlib fails.
Bytes compress_block(std::span<const std::byte> data, ArrayContent content) {
  constexpr int window_bits = 15, memory_level = 8;  // zlib's own defaults
  z_stream stream{};
  if (deflateInit2(&stream, compression_level, Z_DEFLATED, window_bits, memory_level, strategy(content)) != Z_OK) return {};
  Bytes out(deflateBound(&stream, static_cast<uLong>(data.size())));
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(data.data()));  // zlib only reads it
  stream.avail_in = static_cast<uInt>(data.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int result = deflate(&stream, Z_FINISH);
  out.resize(result == Z_STREAM_END ? stream.total_out : 0);
  deflateEnd(&stream);
  return out;
}

}  // namespace

std::string base64(std::span<const std::byte> data) {
  std::string text((data.size() + 2) / 3 * 4, '=');
  const auto put = [](char* to, std::uint32_t word) {
    std::memcpy(to, character_pairs[word >> 12].data(), 2);
    std::memcpy(to + 2, character_pairs[word & 4095].data(), 2);
  };
  const auto byte = [&data](std::size_t i) { return std::to_integer<std::uint32_t>(data[i]); };
  const std::size_t rest = data.size() % 3, whole = data.size() - rest;
  char* to = text.data();
  for (std::size_t i = 0; i < whole; i += 3, to += 4) put(to, byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2));
  if (rest > 0) {
    char last[4];
    put(last, byte(whole) << 16 | (rest > 1 ? byte(whole + 1) << 8 : 0));
    std::memcpy(to, last, rest + 1);
  }
  return text;
}

std::string encode_vtk_array(std::span<const std::byte> data, ArrayContent content) {
  const std::size_t blocks = (data.size() + block_bytes - 1) / block_bytes;
  std::vector<Bytes> compressed(blocks);
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t begin = b * block_bytes;
    compressed[b] = compress_block(data.subspan(begin, std::min(block_bytes, data.size() - begin)), content);
  }
  std::vector<std::uint32_t> header{static_cast<std::uint32_t>(blocks), static_cast<std::uint32_t>(block_bytes),
                                    static_cast<std::uint32_t>(data.size() % block_bytes)};
  Bytes body;
  for (const Bytes& block : compressed) {
    if (block.empty()) throw std::runtime_error("zlib could not compress a block");
    header.push_back(static_cast<std::uint32_t>(block.size()));
    body.insert(body.end(), block.begin(), block.end());
  }
  return base64(std::as_bytes(std::span(header))) + base64(body);
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
