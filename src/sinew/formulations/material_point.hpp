#pragma once
/// Between a material, known only as one of many, and the sweep, which is compiled once for all of them: the response of eight particles at
/// once behind one call a slice.

#include <sinew/core/pack.hpp>
#include <sinew/materials/registry.hpp>

namespace sinew {

template <int D>
struct PointResponse {
  Mat<Pack, D> P;               ///< first Piola-Kirchhoff stress in the plane (2D) or in space [pressure]
  Pack energy;                  ///< strain energy per reference volume [pressure]
  Pack jacobian;                ///< det F, in three dimensions
  Pack acoustic_stiffness;      ///< bound of density times the squared wave speed in the reference frame [pressure]
  Pack thickness_stretch{1.0};  ///< F33
  Pack thickness_stress{0.0};   ///< P33 in 2D [pressure]
};

/// Fills `response` for the deformation gradient F.
template <int D>
struct MaterialPoint {
  using Function = void (*)(const void* material, const Mat<Pack, D>& F, PointResponse<D>& response);
  const void* material;
  Function function;
  void operator()(const Mat<Pack, D>& F, PointResponse<D>& response) const { function(material, F, response); }
};

/// The material stays with the caller. `plane_stress`: only in 2D.
template <int D>
MaterialPoint<D> material_point(const AnyMaterial& material, bool plane_stress);

}  // namespace sinew
