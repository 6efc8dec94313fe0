#pragma once
/// The two sweeps over pairs of the current configuration, compiled once for all kernels of a dimension.

#include <sinew/formulations/moving_rows.hpp>
#include <sinew/kernels/registry.hpp>
#include <sinew/neighbors/moving_neighbors.hpp>
#include <sinew/stabilization/registry.hpp>

namespace sinew {

/// Places at which a sweep finds particles and their kernel.
template <int D>
struct MovingPairs {
  const MovingNeighbors<D>& neighbors;
  const AnyKernel& kernel;
  double radius;         ///< of the kernel [length]
  const double* motion;  ///< motion rows by place
};

/// Velocity gradients L_i = sum_j m_j / rho_i (v_j - v_i) (x) grad_i W_ij B_i in the middle of a step, by slot.
template <int D>
struct GradientSweep {
  MovingPairs<D> pairs;
  double half_step;  ///< [time]
  bool corrected;    ///< B_i = (sum_j m_j / rho_i x_ij (x) grad_i W_ij)^-1, otherwise I
  bool shear;        ///< whether the printed non-nested shear is wanted
  VectorField<D * D>& gradient;
  VectorField<D * D>& correction;  ///< B, where `corrected`
  VectorField<D>& pull;            ///< sum_j V_j pull_ij / rho_i, where `shear`; see NonNestedShear
};
template <int D>
void sweep_velocity_gradients(const GradientSweep<D>& sweep);

/// How strong the repulsion of a pair is: (W_ij / W(d))^n.
struct RepulsionRange {
  double inverse_weight = 0.0;  ///< 1 / W(d)
  double exponent = 0.0;        ///< n
};

/// Forces f_i = sum_j m_i m_j (T_i + T_j) grad_i W_ij with what the stabilizations add, by slot.
template <int D>
struct ForceSweep {
  MovingPairs<D> pairs;
  const double* stress;  ///< stress rows by place
  const double* rest;    ///< rest rows, or nullptr
  bool lower;            ///< T is not symmetric
  bool repels;           ///< there is an artificial stress or pressure
  bool explains;         ///< the objective form of NonNestedShear
  RepulsionRange range;
  const ArtificialViscosity* viscosity;  ///< or nullptr
  double smoothing_length;
  double half_step;
  double thickness;
  VectorField<D>& forces;   ///< added to
  VectorField<D>& pull;     ///< sum_j G_ij V_i V_j pull_ij, where `explains`
  double* viscous_power;    ///< by slot, of viscosity [energy/time]
  double* viscous_rate;     ///< by slot: how fast it takes motion away [1/time]
  double* repulsive_power;  ///< by slot, taken by repulsion [energy/time]
};
template <int D>
void sweep_moving_forces(const ForceSweep<D>& sweep);

}  // namespace sinew
