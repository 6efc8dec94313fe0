#pragma once
/// The tangent of a material, known only as one of many, for eight particles at once: what the sweep over the pairs asks it when it is linear in the displacements.

#include <sinew/formulations/material_point.hpp>

namespace sinew {

/// A = dP/dF in the plane (2D, with F33 fixed, or such that P33 = 0) or in space: row D i + J, column D k + L [pressure].
template <int D>
struct PointTangent {
  Mat<Pack, D * D> A;
  Pack hourglass_modulus;  ///< see PointResponse; it depends on the history alone

  SINEW_INLINE Mat<Pack, D> operator*(const Mat<Pack, D>& dF) const {
    Mat<Pack, D> dP;
    for (int row = 0; row < D * D; ++row)
      for (int column = 0; column < D * D; ++column) dP[row / D][row % D] += A[row][column] * dF[column / D][column % D];
    return dP;
  }
};

/// Fills `out` for the deformation gradient F.
template <int D>
struct TangentPoint {
  using Function = void (*)(const void* material, const Mat<Pack, D>& F, const SliceHistory<D>* history, PointTangent<D>& out);
  const void* material = nullptr;
  Function function = nullptr;

  /// `history`: may be nullptr where there are no numbers.
  void operator()(const Mat<Pack, D>& F, const SliceHistory<D>* history, PointTangent<D>& out) const {
    function(material, F, history, out);
  }
};

/// The material stays with the caller. `plane_stress`: only in 2D, and only without history.
template <int D>
TangentPoint<D> tangent_point(const AnyMaterial& material, bool plane_stress);

}  // namespace sinew
