#pragma once
/// Total-Lagrangian SPH: kernel, gradient and stress in the reference configuration.
///
///     F_i = I + sum_j V_j (u_j - u_i) (x) g_ij                         Ganzenmueller (2015), eq. 17
///     f_i = sum_j V_i V_j (P_i g_ij - P_j g_ji) + hourglass forces     Ganzenmueller (2015), eq. 24 and 32
///
/// The force is minus the gradient of sum V_i psi(F_i). It is summed in scatter form: particle i, right after its own F_i and P_i are
/// known, adds t_ij = V_i V_j P_i g_ij to itself and subtracts it from j. So one sweep needs no stress of a neighbor, and radii may differ. Block by
/// block: each adds up in places of its own, see neighbors/blocks.hpp.

#include <memory>
#include <optional>
#include <sinew/core/function_ref.hpp>
#include <sinew/formulations/history.hpp>
#include <sinew/formulations/pair_weights.hpp>
#include <sinew/formulations/particle_matrices.hpp>
#include <sinew/neighbors/block_scratch.hpp>
#include <sinew/neighbors/cracks.hpp>
#include <sinew/parallel/share.hpp>
#include <sinew/stabilization/registry.hpp>

namespace sinew {

/// What one evaluation of the forces says about the state, over all particles of this rank.
struct ForceSummary {
  double strain_energy = 0.0;     ///< sum V psi [energy]; not finite if any particle is not
  double hourglass_energy = 0.0;  ///< measure of the energy in the hourglass stiffness [energy]
  double released = 0.0;       ///< what the hourglass stiffness has lost since the last step, since flow has softened it [energy]
  double plastic_work = 0.0;   ///< dissipated in all of the past [energy]
  double damage_work = 0.0;    ///< likewise by damage [energy]
  double viscous_power = 0.0;  ///< taken by artificial viscosity and JST dissipation [energy/time]
  double smallest_jacobian = 1.0;  ///< min det F
  double largest_rate2 = 0.0;      ///< max of (fastest wave speed / length)^2 [1/time^2]
  bool fails = false;              ///< whether the damage of a particle has become 1 in this step
  bool finite = true;              ///< whether all of it is a number
};

/// Point-wise results in computing order, for files and probes.
struct RecordedState {
  VectorField<9> deformation_gradient;  ///< row-major
  VectorField<9> stress;                ///< first Piola-Kirchhoff, likewise
  AlignedArray<double> energy_density;
  AlignedArray<double> hourglass_error;  ///< largest |F X - x| / |X| over the neighbors; empty if nobody wants it
  VectorField<4>
      inelastic;  ///< plastic strain, plastic work [pressure], temperature [K], damage; empty if no material has a history
  explicit RecordedState(int slots) : deformation_gradient(slots), stress(slots), energy_density(slots) {}
};

/// Which wave limits the time step, and across which distance.
enum class WaveSpeed {
  bound,  ///< bound for the current stiffness, in the reference frame; the smaller of V^(1/D) and the reference distance of the nearest neighbor
  stretch,  ///< sqrt((lambda + 2 mu) / rho_0) over the smallest principal stretch; current distance of the nearest neighbor. Wiragunarsa et al. (2024), eq. 31-32
  reference  ///< sqrt((lambda + 2 mu) / rho_0); reference distance of the nearest neighbor. Likewise, as its cheaper form
};
std::string_view name_of(WaveSpeed speed);

struct TotalLagrangianOptions {
  AnyKernel kernel;
  AnyCorrection correction;
  std::optional<HourglassStiffness> hourglass;
  std::vector<AnyMaterial> materials;  ///< one a body
  bool plane_stress = false;
  double thickness = 1.0;
  WeightStorage weights = WeightStorage::automatic;
  bool lattice = true;  ///< look for regular arrangements
  std::optional<ArtificialViscosity> viscosity{};
  std::optional<JstDissipation> jst{};
  DeformationGradient deformation_gradient = DeformationGradient::direct;
  MomentumForm momentum = MomentumForm::adjoint;
  bool stages = false;  ///< several evaluations a step: gradients that are integrated in time go on in advance_gradients()
  std::vector<std::optional<AnyDamage>> damages{};  ///< one a body, or empty: none
  WaveSpeed wave_speed = WaveSpeed::bound;

  /// nullptr: none.
  const AnyDamage* damage_of(std::size_t body) const {
    return body < damages.size() && damages[body] ? &*damages[body] : nullptr;
  }
  /// Whether its failed particles lose their neighbors.
  bool separates(std::size_t body) const {
    const AnyDamage* damage = damage_of(body);
    return damage && std::visit([](const auto& model) { return model.growth.separate; }, *damage);
  }
  bool separates() const;  ///< any body
  bool averages() const { return deformation_gradient >= DeformationGradient::bond; }
  bool corrects_laplacian() const { return jst && jst->corrected(); }
  bool outer_laplacian() const { return jst && (jst->eta4 > 0.0 || !jst->corrected()); }
  bool needs_velocities() const { return viscosity || jst || deformation_gradient == DeformationGradient::rate; }
  /// The sweep over the materials needs velocities of neighbors.
  bool sweeps_velocities() const {
    return viscosity || deformation_gradient == DeformationGradient::rate || (corrects_laplacian() && jst->eta2 > 0.0);
  }
  /// All but the original method: its extensions work with pair lists.
  bool extended() const {
    return jst || deformation_gradient != DeformationGradient::direct || momentum != MomentumForm::adjoint;
  }
};

/// Energies of all particles of all ranks.
struct StoredEnergy {
  double strain = 0.0, hourglass = 0.0, plastic_work = 0.0, damage_work = 0.0;
};

/// Whether pairs of regular arrangements can go without a list.
bool may_use_lattice(const TotalLagrangianOptions& options);

template <int D>
struct SweepTask;
template <int D>
struct NeighborTask;
template <int D>
class Separation;

template <int D>
class TotalLagrangian {
 public:
  /// All particles of a case. `support_radius`: per slot [length]. The particles stay with the caller; only their reference configuration is used here.
  TotalLagrangian(const Particles<D>& particles, const std::vector<double>& support_radius, TotalLagrangianOptions options);
  /// The particles of this rank with their pairs, and how it talks to the others. Radii of copies are not needed. Collective.
  TotalLagrangian(const Particles<D>& particles, BlockPairs<D> pairs, const std::vector<double>& support_radius,
                  TotalLagrangianOptions options, const Comm& comm, Halo halo);
  TotalLagrangian(const TotalLagrangian&) = delete;
  TotalLagrangian& operator=(const TotalLagrangian&) = delete;

  // The following are collective, since displacements of copies come in and forces on them go back.

  /// Called with slots [begin, end) whose forces are complete, as soon as they are, from any thread.
  using Finish = FunctionRef<void(int begin, int end)>;
  /// Adds the pair forces of the current displacements to `forces`; the materials go on from their histories as `step` says. With
  /// `record` it keeps F, P and energies of every particle besides.
  ForceSummary internal_forces(Particles<D>& particles, VectorField<D>& forces, PointStep step, Finish finish,
                               RecordedState* record = nullptr);
  ForceSummary internal_forces(Particles<D>& particles, VectorField<D>& forces) {
    return internal_forces(particles, forces, {0.0, HistoryUse::advance}, [](int, int) {});
  }
  /// Gradients that are integrated in time (DeformationGradient::rate) begin as those of the current displacements.
  void begin_gradients(Particles<D>& particles);
  ParticleMatrices<D>& matrices() { return matrices_; }
  const ParticleMatrices<D>& matrices() const { return matrices_; }

  /// The same sweep for what it keeps alone; histories stay.
  ForceSummary record(Particles<D>& particles, RecordedState& state);
  /// Of the state of the last evaluation of the forces.
  StoredEnergy stored_energy() const;
  /// Of the last evaluation, block by block.
  const std::vector<ForceSummary>& block_summaries() const { return summaries_; }
  HistoryStore& history() { return history_; }

  /// Cuts off the particles that have failed in the last evaluation of the forces, if they are to separate, and those that would be left with too few
  /// neighbors. The elastic energy that this takes is `released` in the summaries. Returns whether there were any. Collective.
  bool separate(const Particles<D>& particles);
  /// The same at a restart. `failed`: {number, contact radius} of each; `most_stiffness`: as it was, see below. Collective.
  void restore_cracks(const Particles<D>& particles, const std::vector<double>& failed,
                      const std::vector<double>& most_stiffness);
  const Cracks<D>& cracks() const { return cracks_; }
  /// Largest sum of the hourglass weights of a particle so far, of each body [1/length^2].
  const std::vector<double>& most_stiffness() const { return weights_.most_stiffness; }

  /// Upper limit of the time step from the hourglass stiffness, 2 / omega; infinity without it.
  double hourglass_time_step() const { return hourglass_time_step_; }
  /// Fastest damping by JST dissipation [1/time].
  double dissipation_rate() const { return dissipation_rate_; }
  /// sum_j V_j |dW/dr| / r X_ij: points from a particle to its neighbors [1/length].
  Vec<double, D> toward_neighbors(const Particles<D>& particles, int slot) const;
  const BlockPairs<D>& pairs() const { return pairs_; }
  const LatticePatterns<D>& lattice() const { return pairs_.lattice; }
  const TotalLagrangianOptions& options() const { return options_; }
  const Halo& halo() const { return halo_; }
  std::size_t bytes() const;

 private:
  SweepTask<D> task_of(int block, const PairSource<D>& source, const WeightOptions& weights, PointStep step,
                       RecordedState* record);
  NeighborTask<D> neighbor_task(int block, const PairSource<D>& source);
  struct Traffic {
    bool displacements = true, forces = false;
  };
  template <class Work>
  void sweep_blocks(Particles<D>& particles, Work&& work, const Traffic& traffic);
  template <class Work>
  void sweep_all(Particles<D>& particles, Work&& work);
  template <class Work>
  void sweep_to_forces(Particles<D>& particles, VectorField<D>& forces, Finish finish, const Traffic& traffic, Work&& work);
  void bring_copies(Particles<D>& particles);
  void prepare(Particles<D>& particles);
  void find_gradients_of(const VectorField<D>& field, Particles<D>& particles, MatrixField<D>& gradients);
  void find_laplacians_of_all(Particles<D>& particles);
  void add_adjoint_forces(Particles<D>& particles, VectorField<D>& forces, Finish finish);
  double laplacian_scale(int body) const;
  void make_weights(const Particles<D>& particles, const std::vector<double>& support_radius);
  void make_matrices(const Particles<D>& particles);
  void make_dissipation();
  void bring_in_dissipated(const Block& block, const Particles<D>& particles, BlockScratch<D>& scratch) const;
  static ForceSummary total(const std::vector<ForceSummary>& of_blocks);

  Separation<D> separation(const Particles<D>& particles, const WeightOptions& weights);
  void measure_again(const Particles<D>& particles, const std::vector<char>& changed);
  void limit_time_step(const Particles<D>& particles);

  WeightOptions weight_options() const;
  void choose_weights();
  void prepare_scratch();

  TotalLagrangianOptions options_;
  Comm comm_;
  Halo halo_;
  BlockPairs<D> pairs_;
  std::vector<int> inner_, edge_;  ///< blocks that reach no copies, and those that do
  BlockCountdown countdown_;
  PairWeights<D> weights_;
  double hourglass_time_step_ = infinity, dissipation_rate_ = 0.0;
  std::vector<JstDissipation::Coefficients> dissipation_;  ///< one a body
  ParticleMatrices<D> matrices_;
  HistoryStore history_;
  Cracks<D> cracks_;
  std::vector<ForceSummary> summaries_;     ///< one a block, of the last evaluation of the forces
  std::vector<ForceSummary> recorded_;      ///< scratch, likewise of record()
  VectorField<D> spilled_;                  ///< scratch: forces on ghosts
  std::vector<BlockScratch<D>> scratches_;  ///< one a thread
};

extern template class TotalLagrangian<2>;
extern template class TotalLagrangian<3>;

}  // namespace sinew
