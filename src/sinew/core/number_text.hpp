#pragma once
/// Numbers as text that reads back to the same bits.

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace sinew {

/// The shortest text that reads back to exactly `value`: "0.1", "17000000", "1e-09".
inline std::string number_text(double value) {
  std::array<char, 64> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  std::string text(buffer.data(), end);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos || std::abs(value) < 1.0 || std::abs(value) >= 1e15) return text;
  const auto [plain_end, plain_error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
  return {buffer.data(), plain_end};
}

}  // namespace sinew
