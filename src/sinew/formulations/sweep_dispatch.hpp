#pragma once
/// Between the solver and the sweep, which is compiled once for each kind of weights and of hourglass force.

#include <sinew/formulations/later_reference.hpp>
#include <sinew/formulations/tangent_point.hpp>
#include <sinew/formulations/total_lagrangian.hpp>
#include <sinew/neighbors/block_scratch.hpp>

namespace sinew {

/// For implicit solvers: the deformation around which a sweep is linear, F - I by slot.
template <int D>
struct Linearization {
  MatrixField<D>* gradient = nullptr;  ///< nullptr: nobody wants it
  bool applies =
      false;  ///< the displacements are changes from that deformation, and the forces are to be their changes; otherwise it is to be kept
  TangentPoint<D> tangent{};

  bool keeps() const { return gradient && !applies; }
};

/// Everything that one sweep over a block reads and writes.
template <int D>
struct SweepTask {
  const Block& block;
  const PairSource<D>& source;
  const PairWeights<D>& weights;
  const WeightOptions& options;
  MaterialPoint<D> material;
  double thickness, density;
  double hourglass;                      ///< coefficient; 0 without
  double fixed_modulus;                  ///< of the hourglass stiffness; 0: what the material says
  const ArtificialViscosity* viscosity;  ///< nullptr: none
  double sound_speed;                    ///< for it: sqrt(E / rho)
  WaveSpeed wave_speed;
  double stiffness;  ///< lambda + 2 mu, for it
  BlockScratch<D>& scratch;
  HistorySlots history;
  PointStep step;
  RecordedState* record;  ///< nullptr: forces only
  DeformationGradient form;
  ParticleMatrices<D>& matrices;
  double rate_step;                          ///< how far the integrated gradients are to go [time]
  double laplacian_scale;                    ///< 2 C of JstDissipation; 0 without
  bool outer_laplacian;                      ///< the vectors in the scratch are to be smoothed by it
  double corrected_harmonic;                 ///< of JstDissipation, where it is exchanged by pairs; 0 otherwise [length^2/time]
  const LaterReference<D>* later = nullptr;  ///< if the reference configuration has been renewed
  Linearization<D> linear{};
};

/// Defined in sweep_2d.cpp and sweep_3d.cpp.
template <int D>
ForceSummary sweep_block(const SweepTask<D>& task);
template <>
ForceSummary sweep_block<2>(const SweepTask<2>& task);
template <>
ForceSummary sweep_block<3>(const SweepTask<3>& task);

/// For sweeps before and after it, which ask no material: what they read and write.
template <int D>
struct NeighborTask {
  const Block& block;
  const PairSource<D>& source;
  const PairWeights<D>& weights;
  BlockScratch<D>& scratch;
  ParticleMatrices<D>& matrices;
  double laplacian_scale;  ///< 2 C of JstDissipation
};

// Defined in neighbor_sweeps.cpp.

/// Gradients of the vectors in the scratch: F - I, if these are the displacements.
template <int D>
void find_gradients(const NeighborTask<D>& task, MatrixField<D>& gradients);
/// Laplacians of the vectors in the scratch.
template <int D>
void find_laplacians(const NeighborTask<D>& task);
/// The same of the velocities, but for linear fields, and times the volume; exchanged like forces. See JstDissipation.
template <int D>
void exchange_corrected_laplacians(const NeighborTask<D>& task);
/// The forces by which the energy of averages over bonds resists the change of the gradients that they average, from the stresses in the scratch.
template <int D>
void give_adjoint_forces(const NeighborTask<D>& task);

}  // namespace sinew
