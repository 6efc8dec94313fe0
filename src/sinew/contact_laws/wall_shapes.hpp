#pragma once
/// Surfaces of rigid walls: how far a point is outside, and in which direction. `inside = true` turns a shape into the container around it.

#include <cmath>
#include <optional>
#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/vec.hpp>
#include <string>
#include <string_view>

namespace sinew {

template <class T, int D>
struct Gap {
  T distance;        ///< of a point from the surface; negative behind it [length]
  Vec<T, D> normal;  ///< unit vector away from the surface
};

namespace detail {
template <class T, int D>
SINEW_INLINE Vec<T, D> from(const Vec<T, D>& x, const Point& origin) {
  Vec<T, D> r;
  for (int c = 0; c < D; ++c) r[c] = x[c] - T(origin[c]);
  return r;
}

/// Of a ball about the origin of r.
template <class T, int D>
SINEW_INLINE Gap<T, D> round_gap(const Vec<T, D>& r, double radius, bool inside) {
  using std::sqrt;
  const T length = sqrt(dot(r, r));
  const T sign(inside ? -1.0 : 1.0);
  return {sign * (length - T(radius)), (sign / (length + T(1e-300))) * r};
}
}  // namespace detail

/// A half space: everything behind the plane.
struct PlaneWall {
  static constexpr std::string_view name = "plane";
  static constexpr std::string_view summary = "Flat wall without end";
  Point point, normal;

  static void describe(auto&& field, auto& m) {
    field("point", m.point, "m", "A point on the surface.", any_number);
    field("normal", m.normal, "1", "Direction away from the wall, towards the bodies; of any length.", any_number);
  }
  std::optional<std::string> complete() {
    const double length = norm(normal);
    if (length == 0.0) return "normal must not be the zero vector";
    normal = (1.0 / length) * normal;
    return std::nullopt;
  }
  template <class T, int D>
  SINEW_INLINE Gap<T, D> gap(const Vec<T, D>& x) const {
    Vec<T, D> n;
    for (int c = 0; c < D; ++c) n[c] = T(normal[c]);
    return {dot(detail::from(x, point), n), n};
  }
};

/// A solid box, or with `inside` a hollow one; of its faces the nearest acts.
struct BoxWall {
  static constexpr std::string_view name = "box";
  static constexpr std::string_view summary = "Box with faces along the axes, solid or (inside) hollow";
  Point low, high;
  bool inside = false;

  static void describe(auto&& field, auto& m) {
    field("low", m.low, "m", "Corner with the smallest coordinates.", any_number);
    field("high", m.high, "m", "Corner with the largest coordinates.", any_number);
    field("inside", m.inside, "1", "The bodies are inside.", any_number, optional);
  }
  std::optional<std::string> complete() const {
    for (int c = 0; c < 3; ++c)
      if (low[c] > high[c] || (low[c] == high[c] && c < 2))
        return "every coordinate of \"low\" has to be smaller than that of \"high\"";
    return std::nullopt;
  }
  template <class T, int D>
  SINEW_INLINE Gap<T, D> gap(const Vec<T, D>& x) const {
    using std::sqrt;
    Vec<T, D> beyond, sense;  // of the nearest face along each axis
    T depth(-1e300), outside2(0.0);
    for (int c = 0; c < D; ++c) {
      const T above = x[c] - T(high[c]), below = T(low[c]) - x[c];
      beyond[c] = max(above, below);
      sense[c] = select(above < below, T(-1.0), T(1.0));
      depth = max(depth, beyond[c]);
      const T out = max(beyond[c], T(0.0));
      outside2 = outside2 + out * out;
    }
    const T distance = sqrt(outside2), per_length = T(1.0) / (distance + T(1e-300));
    const auto out = outside2 > T(0.0);
    Vec<T, D> normal;
    T free(1.0);  // until a face has been found
    for (int c = 0; c < D; ++c) {
      const T nearest = select(beyond[c] >= depth, free, T(0.0));
      free = free - nearest;
      normal[c] = sense[c] * select(out, max(beyond[c], T(0.0)) * per_length, nearest);
    }
    const T sign(inside ? -1.0 : 1.0);
    return {sign * select(out, distance, depth), sign * normal};
  }
};

struct SphereWall {
  static constexpr std::string_view name = "sphere";
  static constexpr std::string_view summary = "Ball (a disk in 2D), solid or (inside) hollow";
  Point center;
  double radius = 0.0;
  bool inside = false;

  static void describe(auto&& field, auto& m) {
    field("center", m.center, "m", "Center.", any_number);
    field("radius", m.radius, "m", "Radius.", positive);
    field("inside", m.inside, "1", "The bodies are inside.", any_number, optional);
  }
  template <class T, int D>
  SINEW_INLINE Gap<T, D> gap(const Vec<T, D>& x) const {
    return detail::round_gap(detail::from(x, center), radius, inside);
  }
};

/// Without end along its axis; in the plane the axis stands upright on it.
struct CylinderWall {
  static constexpr std::string_view name = "cylinder";
  static constexpr std::string_view summary = "Cylinder without end (a disk in 2D), solid or (inside) hollow";
  Point point, axis{{0.0, 0.0, 1.0}};
  double radius = 0.0;
  bool inside = false;

  static void describe(auto&& field, auto& m) {
    field("point", m.point, "m", "A point on the axis.", any_number);
    field("axis", m.axis, "1", "Direction of the axis, of any length; [0, 0, 1] if not given, and always in two dimensions.",
          any_number, optional);
    field("radius", m.radius, "m", "Radius.", positive);
    field("inside", m.inside, "1", "The bodies are inside.", any_number, optional);
  }
  std::optional<std::string> complete() {
    const double length = norm(axis);
    if (length == 0.0) return "axis must not be the zero vector";
    axis = (1.0 / length) * axis;
    return std::nullopt;
  }
  template <class T, int D>
  SINEW_INLINE Gap<T, D> gap(const Vec<T, D>& x) const {
    Vec<T, D> r = detail::from(x, point);
    if constexpr (D == 3) {
      const Vec<T, 3> along{{T(axis[0]), T(axis[1]), T(axis[2])}};
      r -= dot(r, along) * along;
    }
    return detail::round_gap(r, radius, inside);
  }
};

}  // namespace sinew
