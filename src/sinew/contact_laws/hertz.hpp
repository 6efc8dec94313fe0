#pragma once

#include <cmath>
#include <limits>
#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/vec.hpp>
#include <string_view>

namespace sinew {

/// Two things that touch, as one of them sees it.
template <class T, int D>
struct Touch {
  T depth;             ///< how far they are inside each other; negative: not at all [length]
  Vec<T, D> normal;    ///< unit vector away from the other
  Vec<T, D> velocity;  ///< own velocity minus that of the other
  T radius;            ///< r_i r_j / (r_i + r_j); r_i against a wall [length]
  T width;             ///< thickness over r_i + r_j in the plane, 1 in space
  T mass;              ///< m_i m_j / (m_i + m_j); m_i against a wall
};

template <class T, int D>
struct ContactForce {
  Vec<T, D> force;
  T energy;      ///< elastic energy [energy]
  T dissipated;  ///< power of damping and friction [energy/time]
  T stiffness;   ///< derivative of the force by depth [force/length]
  T growth;      ///< stiffness over sqrt(depth), also where there is no contact yet
};

/// Bound of the squared rate 1/dt up to which a contact may be stepped over: the stiffness k = g sqrt(d) over mass, with room for what the depth grows
/// in the step at that speed of approach, d + v dt: dt^2 2 g sqrt(d) / m <= 1 and dt^2 2 g sqrt(v dt) / m <= 1.
template <class T, int D>
SINEW_INLINE T contact_rate2(const ContactForce<T, D>& contact, const T& approach, const T& mass) {
  using std::exp, std::log, std::sqrt;
  const T per_mass = T(2.0) / (mass + T(1e-300));
  const T growing = per_mass * contact.growth * sqrt(max(approach, T(0.0)));
  return max(per_mass * contact.stiffness, exp(T(0.8) * log(growing + T(1e-300))));
}

/// Repulsion of spheres of influence, with damping and Coulomb's friction:
///
///     F = 16/15 K d sqrt(d r),  energy 2/5 F d;   damping 2 zeta sqrt(k m) v_n, at most m v_n / (4 dt), never pulling;   friction up to mu F
///
/// d: depth, r: radius, k = 3/2 F/d, m: mass, see Touch. In the plane F counts for a thickness of r_i + r_j. Friction stops slip within a few steps where
/// it can: it is the smaller of mu F and m |v_t| / (4 dt), so that bodies at rest creep by about 4 F_t dt / m instead of sticking.
/// Ganzenmueller (2015), sec. 4.3; Hertz (1882). A sphere of modulus E* and radius r has 4/3 E* instead of 16/15 K.
struct HertzContact {
  static constexpr std::string_view name = "hertz";
  static constexpr std::string_view summary = "Repulsion that grows with depth^1.5, with optional damping and friction";
  static constexpr std::string_view source = "Ganzenmueller (2015), sec. 4.3; Hertz (1882)";
  static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
  double stiffness = not_given, friction = 0.0, damping = 0.0;

  static void describe(auto&& field, auto& m) {
    field("stiffness", m.stiffness, "Pa", "K; if not given, the smaller of the Young's moduli of the bodies that touch.",
          positive, optional);
    field("friction", m.friction, "1", "Coefficient of Coulomb's friction.", non_negative, optional);
    field("damping", m.damping, "1", "Part of the critical damping along the normal.", unit_interval, optional);
  }

  /// Zero where the depth is not positive. `dt`: length of the step; 0 at the start, where nothing is rubbed.
  template <class T, int D>
  SINEW_INLINE ContactForce<T, D> force(const Touch<T, D>& touch, double dt) const {
    using std::sqrt;
    const T depth = max(touch.depth, T(0.0));
    const T elastic = T(16.0 / 15.0 * stiffness) * touch.width * depth * sqrt(depth * touch.radius);
    const T growth = T(1.6 * stiffness) * touch.width * sqrt(touch.radius), k = growth * sqrt(depth);
    const T approach = -dot(touch.velocity, touch.normal);
    const T per_step = T(dt > 0.0 ? 0.25 / dt : 0.0) * touch.mass;  // what stops it in four steps
    const T normal = max(elastic + min(T(2.0 * damping) * sqrt(k * touch.mass), per_step) * approach, T(0.0));
    const Vec<T, D> slip = touch.velocity + approach * touch.normal;
    const T speed = sqrt(dot(slip, slip));
    const T drag = select(depth > T(0.0), min(T(friction) * normal / (speed + T(1e-300)), per_step), T(0.0));
    return {normal * touch.normal - drag * slip, T(0.4) * elastic * depth, (normal - elastic) * approach + drag * speed * speed,
            k, growth};
  }
};

}  // namespace sinew
