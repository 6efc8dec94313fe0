#pragma once
/// Total-Lagrangian SPH: kernel, gradient and stress in the reference configuration.
///
///     F_i = I + sum_j V_j (u_j - u_i) (x) g_ij                         Ganzenmueller (2015), eq. 17
///     f_i = sum_j V_i V_j (P_i g_ij - P_j g_ji) + hourglass forces     Ganzenmueller (2015), eq. 24 and 32
///
/// The force is minus the gradient of sum V_i psi(F_i). It is summed in scatter form: particle i, right after its own F_i and P_i are
/// known, adds t_ij = V_i V_j P_i g_ij to itself and subtracts it from j. So one sweep needs no stress of a neighbor, and radii may differ. Block by
/// block: each adds up in places of its own, see neighbors/blocks.hpp.

#include <sinew/formulations/formulation.hpp>
#include <sinew/formulations/later_reference.hpp>
#include <sinew/formulations/pair_weights.hpp>
#include <sinew/formulations/particle_matrices.hpp>
#include <sinew/neighbors/block_scratch.hpp>
#include <sinew/stabilization/registry.hpp>

namespace sinew {

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
  std::vector<double> hourglass_factors{};  ///< of the coefficient of the hourglass stiffness, one a body; empty: 1

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
  /// Of the hourglass stiffness of a body, 0 without one; see HourglassStiffness::coefficient.
  double hourglass_coefficient(std::size_t body) const {
    if (!hourglass) return 0.0;
    return hourglass->coefficient() * (hourglass_factors.empty() ? 1.0 : hourglass_factors[body]);
  }
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

/// Whether pairs of regular arrangements can go without a list.
bool may_use_lattice(const TotalLagrangianOptions& options);

template <int D>
struct SweepTask;
template <int D>
struct NeighborTask;
template <int D>
class Separation;

template <int D>
class TotalLagrangian final : public Formulation<D> {
 public:
  using typename Formulation<D>::Finish;
  /// All particles of a case. `support_radius`: per slot [length]. The particles stay with the caller; only their reference configuration is used here.
  TotalLagrangian(const Particles<D>& particles, const std::vector<double>& support_radius, TotalLagrangianOptions options);
  /// The particles of this rank with their pairs, and how it talks to the others. Radii of copies are not needed. Collective.
  TotalLagrangian(const Particles<D>& particles, BlockPairs<D> pairs, const std::vector<double>& support_radius,
                  TotalLagrangianOptions options, const Comm& comm, Halo halo);

  ForceSummary internal_forces(Particles<D>& particles, VectorField<D>& forces, PointStep step, Finish finish,
                               RecordedState* record = nullptr) override;
  ForceSummary internal_forces(Particles<D>& particles, VectorField<D>& forces) {
    return internal_forces(particles, forces, {0.0, HistoryUse::advance}, [](int, int) {});
  }
  ForceSummary record(Particles<D>& particles, RecordedState& state) override;

  /// Gradients that are integrated in time (DeformationGradient::rate) begin as those of the current displacements.
  void begin(Particles<D>& particles) override;
  void settle(Particles<D>&) override { this->settle_histories(options_.materials); }
  bool needs_first_rates() const override { return !matrices_.rate.empty(); }
  void begin_stages() override { matrices_.remember(); }
  void advance_stage(double begin, double rest, double dt) override { matrices_.advance(begin, rest, dt); }
  ParticleMatrices<D>& matrices() { return matrices_; }
  const ParticleMatrices<D>& matrices() const { return matrices_; }

  void keep_linearization(const Particles<D>& particles) override { linearized_ = MatrixField<D>(particles.slots); }
  void tangent_forces(Particles<D>& particles, VectorField<D>& forces, PointStep step) override;
  using typename Formulation<D>::Reach, typename Formulation<D>::UseStiffness, typename Formulation<D>::UseStencil;
  void for_each_stiffness(const Particles<D>& particles, Reach reach, PointStep step, UseStiffness use) override;
  void for_each_stencil(const Particles<D>& particles, Reach reach, UseStencil use) const override;
  Stencil<D> stencil_of(const Particles<D>& particles, int slot) const override;

  /// Lets the reference configuration be renewed from now on.
  void renew_by(std::unique_ptr<LaterReference<D>> later) { later_ = std::move(later); }
  long reference_updates() const override { return later_ ? later_->updates() : 0; }
  /// Besides those that have failed, those are cut off that would be left with too few neighbors.
  bool rearrange(Particles<D>& particles) override;
  void restore_cracks(const Particles<D>& particles, const std::vector<double>& failed,
                      const std::vector<double>& most_stiffness) override;
  bool separates() const override { return options_.separates(); }
  std::vector<double> most_stiffness() const override { return weights_.most_stiffness; }
  FieldsToSave<D> fields_to_save() override;
  void restored(Particles<D>& particles) override;

  double hourglass_time_step() const override { return hourglass_time_step_; }
  double dissipation_rate() const override { return dissipation_rate_; }
  Vec<double, D> toward_neighbors(const Particles<D>& particles, int slot) const override;
  std::string_view weights_name() const override { return name_of(storage_); }
  std::vector<std::string> warnings() const override;
  std::string advice() const override;
  const TotalLagrangianOptions& options() const { return options_; }
  std::size_t bytes() const override;

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
  void take_reference(const Particles<D>& particles, const std::vector<double>& support_radius);
  void sort_blocks(const Particles<D>& particles);
  void make_weights(const Particles<D>& particles, const std::vector<double>& support_radius);
  void make_matrices(const Particles<D>& particles);
  void make_dissipation();
  void bring_in_dissipated(const Block& block, const Particles<D>& particles, BlockScratch<D>& scratch) const;

  Particles<D>& seen(Particles<D>& particles) {
    return later_ ? later_->follow(particles, options_.needs_velocities()) : particles;
  }
  bool renew_reference(Particles<D>& particles);
  void remember_deformation(Particles<D>& particles);
  void replace_reference(SharedPairs<D> shared, Particles<D>& particles, std::vector<double> radius);
  bool separate(const Particles<D>& particles);
  Separation<D> separation(const Particles<D>& particles, const WeightOptions& weights);
  void measure_again(const Particles<D>& particles, const std::vector<char>& changed);
  void limit_time_step(const Particles<D>& particles);

  WeightOptions weight_options() const;
  void choose_weights();
  void prepare_scratch();

  using Formulation<D>::comm_, Formulation<D>::halo_, Formulation<D>::pairs_, Formulation<D>::history_, Formulation<D>::cracks_,
      Formulation<D>::summaries_;
  TotalLagrangianOptions options_;
  WeightStorage storage_ = WeightStorage::automatic;  ///< as chosen by the options and the number of pairs
  std::unique_ptr<LaterReference<D>> later_;          ///< nullptr: the reference configuration stays
  std::vector<int> inner_, edge_;                     ///< blocks that reach no copies, and those that do
  std::optional<BlockCountdown> countdown_;
  PairWeights<D> weights_;
  double hourglass_time_step_ = infinity, dissipation_rate_ = 0.0;
  std::vector<JstDissipation::Coefficients> dissipation_;  ///< one a body
  ParticleMatrices<D> matrices_;
  MatrixField<D> linearized_;               ///< for implicit solvers: F - I of the last evaluation; empty otherwise
  std::vector<ForceSummary> recorded_;      ///< scratch, like the summaries, of record()
  VectorField<D> spilled_;                  ///< scratch: forces on ghosts
  std::vector<BlockScratch<D>> scratches_;  ///< one a thread
};

extern template class TotalLagrangian<2>;
extern template class TotalLagrangian<3>;

}  // namespace sinew
