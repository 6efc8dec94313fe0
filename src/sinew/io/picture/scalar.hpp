#pragma once
/// The one number per particle that a picture shows.

#include <sinew/io/picture.hpp>
#include <sinew/io/picture/color_map.hpp>
#include <string>
#include <vector>

namespace sinew {

/// At most so many labels along a color bar.
inline constexpr int most_color_ticks = 7;

struct PictureScalar {
  std::vector<double> values;  ///< in the displayed unit
  std::string label;           ///< "von Mises stress [MPa]"
  ColorMap map = ColorMap::sequential;
  double low = 0.0, high = 1.0;       ///< range of the colors, low < high
  bool below = false, above = false;  ///< some values lie outside of the range

  Rgb color(double value) const { return map_color(map, (value - low) / (high - low)); }
};

/// Throws CaseError that names the known fields or components.
PictureScalar select_scalar(const Snapshot& snapshot, const PictureOptions& options);

/// "von_mises_stress" -> "von Mises stress".
std::string plain_words(const std::string& name);

}  // namespace sinew
