#pragma once
/// Units of mechanics: text -> factor to SI and dimension. Used to read "17 MPa" and to convert it into the system of a case.

#include <optional>
#include <string>
#include <string_view>

namespace sinew {

/// Exponents of length, mass, time and temperature.
struct Dimensions {
  int length = 0, mass = 0, time = 0, temperature = 0;
  friend bool operator==(const Dimensions&, const Dimensions&) = default;
};

struct Unit {
  double factor = 1.0;  ///< value in SI = factor * value in this unit
  Dimensions dimensions;
};

/// Parses "MPa", "kg/m^3", "mm/ms", "N m", "kN/mm^2", "1/s", "rad/s", "1". Nothing if any part is unknown.
std::optional<Unit> parse_unit(std::string_view text);

/// A consistent system: the sizes in SI of its length, mass and time. SI by default. Temperatures are in K in all of them.
struct UnitSystem {
  std::string length = "m", mass = "kg", time = "s";
  double length_factor = 1.0, mass_factor = 1.0, time_factor = 1.0;

  /// Size of one unit of the given dimension, in SI.
  double factor(const Dimensions& d) const;
  /// Name of the system's unit for a quantity that in SI is called `si_name`: ("Pa") -> "GPa" for mm, kg, ms; falls back to a product.
  std::string name_of(std::string_view si_name) const;
};

}  // namespace sinew
