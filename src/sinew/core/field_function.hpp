#pragma once
/// A number as a function of place and time, as boundary conditions and loads use it. Where it came from does not matter here.

#include <cmath>
#include <functional>
#include <sinew/core/error.hpp>
#include <sinew/core/vec.hpp>
#include <string>

namespace sinew {

struct FieldFunction {
  std::function<double(const Point& X, const Point& x, double t)> value;  ///< X: reference place, x: current place
  bool depends_on_place = true;                                           ///< false: one evaluation serves a whole region
  std::string text;                                                       ///< as the user wrote it, for messages

  /// The value; SimulationError if it is not a finite number.
  double operator()(const Point& X, const Point& x, double t) const {
    const double result = value(X, x, t);
    if (!std::isfinite(result))
      throw SimulationError("\"" + text + "\" of a boundary or load is not a finite number at time " + std::to_string(t) + ".");
    return result;
  }
};

}  // namespace sinew
