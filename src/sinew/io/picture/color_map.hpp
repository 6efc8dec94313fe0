#pragma once
/// Numbers to colors.

#include <cstdint>

namespace sinew {

/// Red, green and blue in sRGB, 0 to 1.
struct Rgb {
  double red = 0.0, green = 0.0, blue = 0.0;
};

enum class ColorMap {
  sequential,  ///< dark violet, green, yellow: equal steps look equally large (viridis)
  diverging,   ///< blue, white, red: white is the middle
};

/// The color at `fraction`, 0 to 1 (clamped); gray for not-a-number.
Rgb map_color(ColorMap map, double fraction);

/// 0xFFRRGGBB.
std::uint32_t pack_color(const Rgb& color);

/// (1 - weight) a + weight b.
Rgb mix(const Rgb& a, const Rgb& b, double weight);

}  // namespace sinew
