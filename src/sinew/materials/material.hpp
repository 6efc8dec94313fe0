#pragma once
/// What every material offers. Materials are written once, in three dimensions, for a type M of matrices: Mat3<T>, or PlaneMatrix<T> of
/// a plane state, which costs less. T = ScalarOf<M> is double, Pack, or Dual of either. Formulas use what both matrices have: sums,
/// products, M::identity(), transpose, trace, double_dot, determinant, cofactor, inverse, largest_eigenvalue_bound (below). Should a
/// law need more, write that function for both.
///
///     struct Name {
///       static constexpr std::string_view name, summary, source;
///       double density; ElasticConstants elastic; ...
///       static void describe(auto&& field, auto& m);
///       template <class M> Response<M> respond(const M& F) const;
///       template <class T> Tangent<T> tangent(const Mat3<T>& F) const;      // dP/dF [Pa]
///       template <class M> AcousticBound<ScalarOf<M>> acoustic_bound(const M& F) const;   // or ScalarOf<M>: its fiber part alone
///     };
///
/// A material with history has instead
///
///       template <class M> using History = ...;      // of one particle: a plain struct, all zeros in the virgin state
///       template <class M> Response<M> respond(const M& F, History<M>& history, double dt) const;  // makes the old history the new one
///       template <class M> Response<M> recall(const M& F, const History<M>& history) const;        // of a history that is new already
///       template <class T> Tangent<T> tangent(const Mat3<T>& F, const History<Mat3<T>>& old, double dt) const;
///       template <class M> AcousticBound<ScalarOf<M>> acoustic_bound(const M& F, const M& P) const;
///
/// The solver owns the histories and decides when the new one is kept. A history lists its numbers in `numbers(history, use)`, so that it can be
/// stored; see J2 for what else it may say about itself.
///
/// All but `describe` carry SINEW_INLINE or SINEW_POINTWISE, so that a device has them too (tools/check_device.py).
/// `acoustic_bound` bounds from above the largest eigenvalue of the acoustic tensor A_iJkL N_J N_L over all unit N, see AcousticBound, with
/// equality in the unstrained state; sqrt of acoustic_stiffness() over the reference density is the fastest wave speed in the reference frame. It
/// may be tighter for a PlaneMatrix than for the same state as a Mat3.

#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/plane_matrix.hpp>
#include <sinew/materials/elastic_constants.hpp>
#include <sinew/materials/tangent.hpp>
#include <string_view>

namespace sinew {

/// P: first Piola-Kirchhoff stress [Pa]. energy: strain energy per reference volume [J/m^3]; without history P = d energy / d F.
template <class M>
struct Response {
  M P;
  ScalarOf<M> energy;
};

template <class Material>
concept HasHistory = requires {
  typename Material::template History<Mat3<double>>;
};

/// Largest eigenvalue of a symmetric 3 x 3 matrix, bounded from above to within rounding. It is mean + p y with p^2 = |deviator|^2 / 6 and y the
/// largest root of y^3 - 3 y = t, t = det(deviator) / p^3. One step of Newton's method from y = 2 stays above that root, since it is the largest
/// of three real ones, and gives y = (16 + t) / 9: mean + (16 p + det(deviator) / p^2) / 9. Exact when the two smaller eigenvalues are equal;
/// never more than 0.56 p too large.
template <class T>
SINEW_INLINE T largest_eigenvalue_bound(const Mat3<T>& a) {
  using std::sqrt;
  const T mean = trace(a) * T(1.0 / 3.0);
  const Mat3<T> deviator = a - mean * Mat3<T>::identity();
  const T p2 = double_dot(deviator, deviator) * T(1.0 / 6.0);
  return mean + (T(16.0) * sqrt(p2) + determinant(deviator) / (p2 + T(1e-290))) * T(1.0 / 9.0);
}

/// Exact for a plane state: the larger of component 33 and of m + sqrt(((a11 - a22) / 2)^2 + a12^2), m the mean of a11 and a22.
template <class T>
SINEW_INLINE T largest_eigenvalue_bound(const PlaneMatrix<T>& a) {
  using std::sqrt;
  const Mat<T, 2>& plane = a.in_plane;
  const T mean = T(0.5) * trace(plane), half_difference = T(0.5) * (plane[0][0] - plane[1][1]);
  return max(mean + sqrt(half_difference * half_difference + plane[0][1] * plane[0][1]), a.out_of_plane);
}

/// For any vector N, not only unit ones, fiber |N|^2 + area |F^-T N|^2 is not less than the largest eigenvalue of the acoustic tensor A_iJkL N_J N_L [Pa].
/// The first part is that of stretched fibers, the second that of compressed layers. `spare` may be taken off for the largest of all unit vectors.
template <class T>
struct AcousticBound {
  T fiber, area, spare{0.0};
};

/// Largest eigenvalue of C^-1, C = F^T F, bounded from above.
template <class M>
SINEW_INLINE ScalarOf<M> largest_inverse_stretch2(const M& F) {
  const M inverse_F = inverse(F);
  return largest_eigenvalue_bound(inverse_F * transpose(inverse_F));
}

/// The bound for unit vectors.
template <class M>
SINEW_INLINE ScalarOf<M> largest_of(const AcousticBound<ScalarOf<M>>& bound, const M& F) {
  return bound.fiber - bound.spare + bound.area * largest_inverse_stretch2(F);
}
template <class M>
SINEW_INLINE ScalarOf<M> largest_of(const ScalarOf<M>& fiber, const M&) {
  return fiber;
}

/// The same in the frame of a later reference configuration, per volume of the first one: F = since * earlier. With N the vector of that frame the bound is taken for earlier^T N.
template <class M>
SINEW_INLINE ScalarOf<M> largest_of_later(const AcousticBound<ScalarOf<M>>& bound, const M& since, const M& earlier) {
  return bound.fiber * largest_eigenvalue_bound(earlier * transpose(earlier)) + bound.area * largest_inverse_stretch2(since);
}
template <class M>
SINEW_INLINE ScalarOf<M> largest_of_later(const ScalarOf<M>& fiber, const M&, const M& earlier) {
  return max(fiber, ScalarOf<M>(0.0)) * largest_eigenvalue_bound(earlier * transpose(earlier));
}

/// Of a material at F, with P as well if it has a history [Pa].
template <class Material, class M, class... Stress>
SINEW_INLINE ScalarOf<M> acoustic_stiffness(const Material& material, const M& F, const Stress&... P) {
  return largest_of<M>(material.acoustic_bound(F, P...), F);
}

}  // namespace sinew
