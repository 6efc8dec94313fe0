#pragma once
/// What happens at a particle of the current configuration between its velocity gradient and its stress.

#include <sinew/core/vec.hpp>
#include <sinew/formulations/material_point.hpp>

namespace sinew {

/// (I - A)^-1 (I + A) - I = 2 (I - A)^-1 A with A = dt L / 2: by how much F changes in a step, to second order, and a rotation if L is a spin.
template <int D>
SINEW_INLINE Mat<Pack, D> change_of_gradient(const Mat<Pack, D>& L, double dt) {
  const Mat<Pack, D> A = Pack(0.5 * dt) * L;
  return Pack(2.0) * (inverse(Mat<Pack, D>::identity() - A) * A);
}

/// The rotation of a step by the spin of L.
template <int D>
SINEW_INLINE Mat<Pack, D> rotation_of(const Mat<Pack, D>& L, double dt) {
  return Mat<Pack, D>::identity() + change_of_gradient(Pack(0.5) * (L - transpose(L)), dt);
}

/// Cauchy stress in the plane or in space, and a third of its trace.
template <int D>
struct CauchyStress {
  Mat<Pack, D> in_plane;
  Pack mean;

  CauchyStress(const PointResponse<D>& point, const Mat<Pack, D>& F) {
    const Pack inverse_J = 1.0 / point.jacobian;
    in_plane = inverse_J * (point.P * transpose(F));
    Pack sum = trace(in_plane);
    if constexpr (D == 2) sum += inverse_J * point.thickness_stress * point.thickness_stretch;
    mean = (1.0 / 3.0) * sum;
  }
};

/// Sums and extremes over the slices of a block, lane by lane.
struct UpdateSums {
  Pack energy{0.0}, plastic_work{0.0}, damage_work{0.0}, jacobian{infinity}, left{1.0};
};

}  // namespace sinew
