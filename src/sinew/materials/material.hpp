#pragma once
/// What every material offers. Materials are written once, in three dimensions; `T` is double, Pack, or Dual of either.
///
///     struct Name {
///       static constexpr std::string_view name, summary, source;
///       using State = NoState;                       // history of one particle, a plain struct, owned by the solver
///       double density; ElasticConstants elastic; ...
///       static void describe(auto&& field, auto& m);
///       template <class T> Response<T, State> respond(const Mat3<T>& F, const State& old, double dt) const;
///       template <class T> Tangent<T> tangent(const Mat3<T>& F) const;      // dP/dF [Pa]; materials without history
///       template <class T> T acoustic_stiffness(const Mat3<T>& F) const;
///     };
///
/// `respond` is pure: it may be called any number of times; the solver commits the state that it returns.
/// `acoustic_stiffness` bounds from above the largest eigenvalue of the acoustic tensor A_iJkL N_J N_L over all unit N [Pa], with
/// equality in the unstrained state; sqrt of it over the reference density is the fastest wave speed in the reference frame.

#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/vec.hpp>
#include <sinew/materials/elastic_constants.hpp>
#include <sinew/materials/tangent.hpp>
#include <string_view>

namespace sinew {

struct NoState {};

/// P: first Piola-Kirchhoff stress [Pa], P = d energy / d F. energy: strain energy per reference volume [J/m^3].
template <class T, class State>
struct Response {
  Mat3<T> P;
  T energy;
  State state;
};

/// Largest eigenvalue of a symmetric 3 x 3 matrix, bounded from above to within rounding: mean + p y with p^2 = |deviator|^2 / 6
/// and y the largest root of y^3 - 3 y - det(deviator / p). Two steps of Newton's method from y = 2 stay above that root, since
/// it is the largest of three real ones. Exact when the two smaller eigenvalues are equal; never more than 0.3 p too large.
template <class T>
SINEW_INLINE T largest_eigenvalue_bound(const Mat3<T>& a) {
  using std::sqrt;
  const T mean = trace(a) * T(1.0 / 3.0);
  const Mat3<T> deviator = a - mean * Mat3<T>::identity();
  const T p = sqrt(double_dot(deviator, deviator) * T(1.0 / 6.0));
  const T ratio = determinant(deviator) / (p * p * p + T(1e-290));
  const T third = max(T(-2.0), min(T(2.0), ratio));
  T y(2.0);
  for (int step = 0; step < 2; ++step) y = y - (y * (y * y - T(3.0)) - third) / (T(3.0) * (y * y - T(1.0)));
  return mean + p * y;
}

}  // namespace sinew
