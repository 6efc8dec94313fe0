#include <algorithm>
#include <array>
#include <cmath>
#include <sinew/io/picture/color_map.hpp>

namespace sinew {

namespace {

constexpr Rgb hex(std::uint32_t code) { return {(code >> 16 & 255) / 255.0, (code >> 8 & 255) / 255.0, (code & 255) / 255.0}; }

constexpr Rgb missing = hex(0x9a9a9a);

/// Eleven samples of viridis (van der Walt and Smith 2015, public domain) at equal distances.
constexpr std::array viridis{hex(0x440154), hex(0x482475), hex(0x414487), hex(0x355f8d), hex(0x2a788e), hex(0x21918c),
                             hex(0x22a884), hex(0x44bf70), hex(0x7ad151), hex(0xbddf26), hex(0xfde725)};

/// Lightness rises and falls alike on both sides of a near-white middle.
constexpr std::array blue_white_red{hex(0x123a73), hex(0x1f5fa8), hex(0x4a8cc9), hex(0x8fbbe0), hex(0xcbdff0), hex(0xf4f3f1),
                                    hex(0xf6d5c6), hex(0xeba68f), hex(0xd96a58), hex(0xb9343a), hex(0x7a1029)};

template <std::size_t N>
Rgb sample(const std::array<Rgb, N>& points, double fraction) {
  const double place = std::clamp(fraction, 0.0, 1.0) * (N - 1);
  const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(place), N - 2);
  return mix(points[below], points[below + 1], place - static_cast<double>(below));
}

}  // namespace

Rgb mix(const Rgb& a, const Rgb& b, double weight) {
  return {a.red + weight * (b.red - a.red), a.green + weight * (b.green - a.green), a.blue + weight * (b.blue - a.blue)};
}

Rgb map_color(ColorMap map, double fraction) {
  if (std::isnan(fraction)) return missing;
  return map == ColorMap::sequential ? sample(viridis, fraction) : sample(blue_white_red, fraction);
}

std::uint32_t pack_color(const Rgb& color) {
  const auto byte = [](double value) { return static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0))); };
  return 0xff000000u | byte(color.red) << 16 | byte(color.green) << 8 | byte(color.blue);
}

}  // namespace sinew
