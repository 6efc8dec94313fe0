#include <algorithm>
#include <array>
#include <cstdint>
#include <sinew/io/vtk_array.hpp>
#include <stdexcept>
#include <utility>
#include <vector>
#include <zlib.h>

namespace sinew {

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18;  // large enough to compress well, small enough to share among threads
constexpr int compression_level = 1;
constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> entities{
    {{"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}}};

using Bytes = std::vector<std::byte>;

/// Empty if zlib fails.
Bytes compress_block(std::span<const std::byte> data) {
  uLongf size = compressBound(static_cast<uLong>(data.size()));
  Bytes out(size);
  const int result = compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
                               static_cast<uLong>(data.size()), compression_level);
  out.resize(result == Z_OK ? size : 0);
  return out;
}

}  // namespace

std::string base64(std::span<const std::byte> data) {
  std::string text;
  text.reserve((data.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < data.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, data.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < left ? std::to_integer<std::uint32_t>(data[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? alphabet[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string encode_vtk_array(std::span<const std::byte> data) {
  const std::size_t blocks = (data.size() + block_bytes - 1) / block_bytes;
  std::vector<Bytes> compressed(blocks);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t begin = b * block_bytes;
    compressed[b] = compress_block(data.subspan(begin, std::min(block_bytes, data.size() - begin)));
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
