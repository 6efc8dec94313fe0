#pragma once
/// Round numbers for axes and the units to show them in.

#include <string>
#include <vector>

namespace sinew {

struct Ticks {
  std::vector<double> at;         ///< rising, all inside the range
  std::vector<std::string> text;  ///< with a true minus sign and equal decimals
};

/// At most `most` (>= 2) multiples of 1, 2, 2.5 or 5 times a power of ten in [low, high]; none unless low < high.
Ticks nice_ticks(double low, double high, int most);

/// The largest of 1, 2 or 5 times a power of ten that is at most `limit` (> 0).
double round_down_nicely(double limit);

/// A number as written in text: "0.25", "−3", "1500".
std::string drawn_number(double value);

/// How to show values that are stored in some unit: shown = factor * stored, called `name`.
struct DisplayUnit {
  double factor = 1.0;
  std::string name;
};

/// Chooses a prefix (Pa, J, N, W, m, s) or a power of ten so that `largest` needs few digits: 2e7 "Pa" -> 1e-6, "MPa". Names are
/// made readable: "kg/m^3" -> "kg/m³". The name is empty for pure numbers ("1").
DisplayUnit display_unit(const std::string& unit, double largest);

}  // namespace sinew
