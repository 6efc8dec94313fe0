#pragma once
/// How the deformation gradient is made, how its stress becomes force, and what of it is known of all particles.

#include <sinew/particles/vector_field.hpp>
#include <string_view>

namespace sinew {

enum class DeformationGradient {
  direct,           ///< F_i from the displacements
  rate,             ///< F_i from its rate in time, which comes from the velocities. Wiragunarsa et al. (2024), eq. 24
  bond,             ///< the kernel average of the gradients of the bonds of i. Wiragunarsa et al. (2024), eq. 36-41
  bond_variational  ///< the same, with the force that is minus the gradient of its energy
};
std::string_view name_of(DeformationGradient form);

enum class MomentumForm {
  adjoint,   ///< f_i = sum_j V_i V_j (P_i g_ij - P_j g_ji). Ganzenmueller (2015), eq. 24
  symmetric  ///< f_i = 1/2 sum_j V_i V_j (P_i + P_j) (g_ij - g_ji). Wiragunarsa et al. (2024), eq. 22
};
std::string_view name_of(MomentumForm form);

/// A D x D matrix a particle, row by row: component D r + c.
template <int D>
using MatrixField = VectorField<D * D>;

}  // namespace sinew
