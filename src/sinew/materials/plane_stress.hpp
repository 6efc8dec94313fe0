#pragma once

#include <sinew/core/dual.hpp>
#include <sinew/materials/material.hpp>

namespace sinew {

/// A material in a state of plane stress: the stretch F33 through the thickness follows from P33 = 0, whatever F33 the caller
/// gives. The material is held by value, as the base, so that its density, constants and parameters stay where they were. For
/// materials without history and with F13 = F23 = F31 = F32 = 0, as a Mat3 or as a PlaneMatrix.
template <class Material>
struct PlaneStress : Material {
  using Bulk = Material;  ///< the law that holds once F33 is known
  static constexpr int most_steps = 50;
  static constexpr double tolerance = 1e-12;  ///< of the last Newton step over the stretch; its error is the square of that

  /// F33 with P33(F, F33) = 0 by Newton's method from F33 = 1, each step at most to half or twice the last value. A lane that has
  /// converged no longer moves, so the result of a lane does not depend on the others. Where F33 is far too large the slope of
  /// P33 may be negative; its absolute value still points to the root. Without a root (a St. Venant-Kirchhoff sheet stretched too
  /// far) the result tends to 0; with a stress that is not a number (J <= 0 in a logarithm) so is the response.
  template <class M>
  SINEW_POINTWISE ScalarOf<M> thickness_stretch(const M& F) const {
    using T = ScalarOf<M>;
    const Mat<T, 2> plane = in_plane<2>(F);
    T stretch(1.0);
    auto active = T(0.0) < T(1.0);
    for (int step = 0; step < most_steps && any(active); ++step) {
      const Dual<T> out_of_plane = stress_through_thickness(plane, stretch);
      const T change = out_of_plane.value / max(out_of_plane.slope, -out_of_plane.slope);
      const T next = min(T(2.0) * stretch, max(T(0.5) * stretch, stretch - change));
      stretch = select(active, next, stretch);
      active = active & (max(change, -change) > T(tolerance) * stretch);
    }
    return stretch;
  }

  /// The response of the material at the solved stretch; P33 is zero to within rounding. The energy is that of the plane-stress
  /// state, so that P is still its derivative in the plane.
  template <class M>
  SINEW_POINTWISE Response<M> respond(const M& F) const {
    return Material::respond(with_thickness(F, thickness_stretch(F)));
  }

  /// dP/dF in the plane with F33 following: A_ab - A_a33 A_33b / A_3333. Rows and columns of 33 are zero.
  template <class T>
  SINEW_POINTWISE Tangent<T> tangent(const Mat3<T>& F) const {
    constexpr int out = 8;
    const Tangent<T> A = Material::tangent(with_thickness(F, thickness_stretch(F)));
    Tangent<T> condensed;
    for (int a = 0; a < out; ++a)
      for (int b = 0; b < out; ++b) condensed[a][b] = A[a][b] - A[a][out] * A[out][b] / A[out][out];
    return condensed;
  }

  /// The bound of the material at the solved stretch. In the plane the true value is smaller, E / (1 - nu^2) in the unstrained
  /// state.
  template <class M>
  SINEW_POINTWISE ScalarOf<M> acoustic_stiffness(const M& F) const {
    return sinew::acoustic_stiffness(static_cast<const Material&>(*this), with_thickness(F, thickness_stretch(F)));
  }

 private:
  template <class T>
  static SINEW_INLINE Mat3<T> with_thickness(Mat3<T> F, const T& stretch) {
    F[2][2] = stretch;
    return F;
  }
  template <class T>
  static SINEW_INLINE PlaneMatrix<T> with_thickness(const PlaneMatrix<T>& F, const T& stretch) {
    return {F.in_plane, stretch};
  }

  /// P33 and its derivative with respect to F33. F is written out, since a matrix that is filled in loops goes through memory.
  template <class T>
  SINEW_INLINE Dual<T> stress_through_thickness(const Mat<T, 2>& plane, const T& stretch) const {
    const auto constant = [](const T& a) { return Dual<T>(a, T(0.0)); };
    const PlaneMatrix<Dual<T>> F{
        {{{constant(plane[0][0]), constant(plane[0][1])}, {constant(plane[1][0]), constant(plane[1][1])}}},
        Dual<T>(stretch, T(1.0))};
    return Material::respond(F).P.out_of_plane;
  }
};

}  // namespace sinew
