#pragma once
/// The parameter visitor. Every model declares each parameter once, in
///
///     static void describe(auto&& field, auto& m) {
///       field("alpha", m.alpha, "1", "Coefficient of the hourglass stiffness.", non_negative, optional);
///     }
///
/// and the case reader, its checks, the generated reference, the schema and the command line all read that declaration.
/// A member may be double, int, bool, std::string, std::vector<double> or Choice. A parameter marked `optional` keeps the value
/// with which the member is initialized; every other one has to be given.

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;
  std::string_view text = "any number";

  constexpr bool contains(double v) const { return (low_open ? v > low : v >= low) && (high_open ? v < high : v <= high); }
};

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Range any_number{};
inline constexpr Range positive{0.0, infinity, true, true, "greater than 0"};
inline constexpr Range non_negative{0.0, infinity, false, true, "0 or greater"};
inline constexpr Range at_least_one{1.0, infinity, false, true, "1 or greater"};
inline constexpr Range unit_interval{0.0, 1.0, false, false, "from 0 to 1"};

enum class Need { required, optional };
inline constexpr Need required = Need::required;
inline constexpr Need optional = Need::optional;

/// A name out of a fixed list.
struct Choice {
  std::string value;
  std::vector<std::string_view> allowed;
};

}  // namespace sinew
