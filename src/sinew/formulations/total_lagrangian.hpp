#pragma once
/// Total-Lagrangian SPH: kernel, gradient and stress in the reference configuration.
///
///     F_i = I + sum_j V_j (u_j - u_i) (x) g_ij                         Ganzenmueller (2015), eq. 17
///     f_i = sum_j V_i V_j (P_i g_ij - P_j g_ji) + hourglass forces     Ganzenmueller (2015), eq. 24 and 32
///
/// The force is minus the gradient of sum V_i psi(F_i). It is summed in scatter form: particle i, right after its own F_i and P_i are
/// known, adds t_ij = V_i V_j P_i g_ij to itself and subtracts it from j. So one sweep needs no stress of a neighbor, and radii may differ.

#include <memory>
#include <optional>
#include <sinew/core/function_ref.hpp>
#include <sinew/formulations/material_point.hpp>
#include <sinew/formulations/pair_weights.hpp>
#include <sinew/neighbors/chunks.hpp>
#include <sinew/stabilization/registry.hpp>

namespace sinew {

/// What one evaluation of the forces says about the state, over all particles.
struct ForceSummary {
  double strain_energy = 0.0;      ///< sum V psi [energy]; not finite if any particle is not
  double hourglass_energy = 0.0;   ///< measure of the energy in the hourglass stiffness [energy]
  double smallest_jacobian = 1.0;  ///< min det F
  double largest_rate2 = 0.0;      ///< max of (fastest wave speed / length)^2 [1/time^2]
};

/// Point-wise results in computing order, for files and probes.
struct RecordedState {
  AlignedArray<double> deformation_gradient;  ///< slot after slot, 9 components, row-major
  AlignedArray<double> stress;                ///< first Piola-Kirchhoff, likewise
  AlignedArray<double> energy_density;
  AlignedArray<double> hourglass_error;  ///< largest |F X - x| / |X| over the neighbors
  explicit RecordedState(int slots)
      : deformation_gradient(9 * std::size_t(slots)),
        stress(9 * std::size_t(slots)),
        energy_density(slots),
        hourglass_error(slots) {}
};

struct TotalLagrangianOptions {
  AnyKernel kernel;
  AnyCorrection correction;
  std::optional<HourglassStiffness> hourglass;
  std::vector<AnyMaterial> materials;  ///< one a body
  bool plane_stress = false;
  double thickness = 1.0;
  WeightStorage weights = WeightStorage::automatic;
  bool lattice = true;  ///< look for regular arrangements
};

template <int D>
class TotalLagrangian {
 public:
  /// `support_radius`: per slot. The particles stay with the caller; only their reference configuration is used here.
  TotalLagrangian(const Particles<D>& particles, const std::vector<double>& support_radius, TotalLagrangianOptions options);

  /// Room for the pair forces, zeros.
  ForceStreams<D> make_streams() const;
  /// Called with slots [begin, end) whose forces are complete, as soon as they are, from any thread.
  using Finish = FunctionRef<void(int begin, int end)>;
  /// Adds the pair forces of the current displacements to the streams.
  ForceSummary internal_forces(const Particles<D>& particles, ForceStreams<D>& forces, Finish finish) const;
  ForceSummary internal_forces(const Particles<D>& particles, ForceStreams<D>& forces) const;
  /// The same sweep, keeping F, P and energies of every particle.
  ForceSummary record(const Particles<D>& particles, RecordedState& state) const;

  /// Upper limit of the time step from the hourglass stiffness, 2 / omega; infinity without it.
  double hourglass_time_step() const { return hourglass_time_step_; }
  /// sum_j V_j |dW/dr| / r X_ij: points from a particle to its neighbors [1/length].
  Vec<double, D> toward_neighbors(const Particles<D>& particles, int slot) const;
  std::vector<int> neighbors(int slot) const { return neighbors_of(slot, list_, lattice_); }
  const PairList& pairs() const { return list_; }  ///< of slices without a lattice pattern; the counts are complete
  const LatticePatterns<D>& lattice() const { return lattice_; }
  const std::vector<Chunk>& chunks() const { return chunks_; }
  const TotalLagrangianOptions& options() const { return options_; }
  std::size_t bytes() const;

 private:
  ForceSummary sweep(const Particles<D>& particles, ForceStreams<D>& forces, RecordedState* record, Finish finish) const;

  WeightOptions weight_options() const;
  void choose_weights();
  void prepare_scratch(const Particles<D>& particles) const;

  TotalLagrangianOptions options_;
  int slots_;
  PairList list_;
  std::vector<Chunk> chunks_;
  mutable ChunkCountdown countdown_;
  LatticePatterns<D> lattice_;
  PairWeights<D> weights_;
  double hourglass_time_step_ = infinity;
  mutable std::vector<ForceSummary> chunk_summaries_;       ///< scratch, one a chunk
  mutable AlignedArray<double> place_rows_;                 ///< scratch: {u, X} of all particles, if any slice has a pair list
  mutable std::vector<AlignedArray<double>> kept_;          ///< scratch, one a thread: the pairs of a slice
  mutable std::unique_ptr<ForceStreams<D>> unused_forces_;  ///< scratch of `record`
};

extern template class TotalLagrangian<2>;
extern template class TotalLagrangian<3>;

}  // namespace sinew
