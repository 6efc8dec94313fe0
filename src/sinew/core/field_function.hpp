#pragma once
/// A number as a function of place and time, as boundary conditions and loads use it. Where it came from does not matter here.

#include <functional>
#include <sinew/core/vec.hpp>

namespace sinew {

struct FieldFunction {
  std::function<double(const Point& X, const Point& x, double t)> value;  ///< X: reference place, x: current place
  bool depends_on_place = true;                                           ///< false: one evaluation serves a whole region
};

}  // namespace sinew
