#pragma once
/// SPH on the current configuration: kernel and neighbors follow the particles, the stress is that of the current volume.
///
///     L_i = 1/rho_i sum_j m_j (v_j - v_i) (x) grad_i W_ij B_i;   d F_i/dt = L_i F_i;   rho_i = rho_0 / det F_i
///     f_i = sum_j m_i m_j (sigma_i B_i^T / rho_i^2 + sigma_j B_j^T / rho_j^2) grad_i W_ij
///
/// B = I (conventional SPH) or the inverse of the moments sum_j m_j / rho_i x_ij (x) grad_i W_ij. The trace of L is the continuity equation d rho_i / dt = sum_j m_j
/// (v_i - v_j).grad_i W_ij; since L has the density of i itself, the power of f is that of the stresses, sum_i V_i sigma_i : L_i. Islam & Peng (2019), eq. 18-21; Gray, Monaghan & Swift
/// (2001); Bonet & Lok (1999) for B.
///
/// L is taken in the middle of a step, and F changes by (I - dt L/2)^-1 (I + dt L/2). Materials get F, or the rate of deformation if they are written in rates. All sums over neighbors have the order of
/// neighbors/moving_neighbors.hpp.

#include <sinew/formulations/formulation.hpp>
#include <sinew/formulations/moving_sweeps.hpp>
#include <sinew/formulations/updated_point.hpp>
#include <sinew/formulations/wall_particles.hpp>
#include <sinew/parallel/near_points.hpp>

namespace sinew {

struct UpdatedLagrangianOptions {
  static constexpr std::string_view name = "updated_lagrangian";
  AnyKernel kernel;
  double radius = 0.0;   ///< of the kernel, the same for all particles [length]
  double spacing = 0.0;  ///< of the particles [length]
  bool corrected = false;
  std::vector<AnyMaterial> materials;  ///< one a body
  std::vector<std::optional<AnyDamage>> damages{};
  double thickness = 1.0;
  std::optional<ArtificialViscosity> viscosity{};
  std::optional<ArtificialPressure> pressure{};
  std::optional<ArtificialStress> stress{};
  std::optional<NonNestedShear> shear{};

  bool repels() const { return pressure || stress; }
  bool has_rest() const { return repels() || explains() || corrected; }
  bool pressure_only() const { return shear && shear->printed(); }
  bool explains() const { return shear && !shear->printed(); }
  const AnyDamage* damage_of(std::size_t body) const {
    return body < damages.size() && damages[body] ? &*damages[body] : nullptr;
  }
};

template <int D>
class UpdatedLagrangian final : public Formulation<D> {
 public:
  using typename Formulation<D>::Finish;
  /// `pairs`, `halo`: of the reference configuration, which is where the initial F comes from. Collective.
  UpdatedLagrangian(const Particles<D>& particles, BlockPairs<D> pairs, UpdatedLagrangianOptions options, const Comm& comm,
                    Halo halo);

  /// Some particles are walls from now on. Not with corrected gradients.
  void stand_before(WallTable<D> walls);

  ForceSummary internal_forces(Particles<D>& particles, VectorField<D>& forces, PointStep step, Finish finish,
                               RecordedState* record = nullptr) override;
  ForceSummary record(Particles<D>& particles, RecordedState& state) override;
  void begin(Particles<D>& particles) override;
  void settle(Particles<D>& particles) override;
  FieldsToSave<D> fields_to_save() override;
  void restored(Particles<D>& particles) override;

  Vec<double, D> toward_neighbors(const Particles<D>& particles, int slot) const override;
  std::string_view weights_name() const override { return "computed"; }
  std::vector<std::string> warnings() const override;
  std::string advice() const override;
  std::size_t bytes() const override;

  const MovingNeighbors<D>& neighbors() const { return neighbors_; }
  long lists_made() const { return lists_made_; }
  const MatrixField<D>& velocity_gradient() const { return gradient_; }
  const UpdatedLagrangianOptions& options() const { return options_; }

 private:
  void find_neighbors(const Particles<D>& particles);
  bool moved_too_far(const Particles<D>& particles);
  void choose_skin();
  void make_list(const Particles<D>& particles, const VectorField<D>& displacement);
  void place_own(const Particles<D>& particles, const VectorField<D>& displacement);
  MovingGrid<D> grid_of(const Particles<D>& particles, double reach) const;
  void fetch_copies(const CopyPlan& plan);
  void make_rows();
  void make_room(const Particles<D>& particles, int points);
  void show_motion(const Particles<D>& particles);
  void find_velocity_gradients(double dt);
  MovingPoints<D> points() const { return {options_.kernel, options_.radius, numbers_, motion_, mass_}; }
  ForceSummary update_block(int block, const Particles<D>& particles, PointStep step, RecordedState* record);
  void update_slice(int block, const SliceSlots<D>& slots, const Particles<D>& particles, PointStep step, RecordedState* record,
                    UpdateSums& sums);
  void give_stress(int body, const SliceSlots<D>& slots, const Mat<Pack, D>& F, const PointResponse<D>& point);
  void keep_record(const SliceSlots<D>& slots, const Mat<Pack, D>& F, const PointResponse<D>& point, RecordedState& state) const;
  void show_stress();
  RepulsionRange repulsion_range() const;
  GradientSweep<D> gradient_sweep(const MovingNeighbors<D>& neighbors, double dt, MatrixField<D>& gradient);
  ForceSweep<D> force_sweep(const MovingNeighbors<D>& neighbors, double dt, VectorField<D>& forces);
  void mind_walls_in_gradients(double dt);
  void mind_walls_in_forces(double dt, VectorField<D>& forces);
  Pack hold_shear(const SliceSlots<D>& slots, const Particles<D>& particles, VectorField<D>& forces, double dt);
  void complete_block(int block, const Particles<D>& particles, VectorField<D>& forces, double dt);
  template <class Work>
  void of_all_blocks(Work&& work);

  using Formulation<D>::comm_, Formulation<D>::halo_, Formulation<D>::pairs_, Formulation<D>::history_,
      Formulation<D>::summaries_, Formulation<D>::thickness_;
  UpdatedLagrangianOptions options_;
  AlignedArray<double> radius_;  ///< by slot, for damage
  MovingNeighbors<D> neighbors_;
  VectorField<D> listed_at_;  ///< displacements when neighbors were found
  bool listed_ = false;
  double skin_ = 0.04;        ///< how much longer than the radius neighbors are looked for, as a part of it
  double steps_of_list_ = 0;  ///< for how many steps the list has held
  long lists_made_ = 0;

  // by point: slots, then copies
  int points_ = 0;
  std::vector<int> numbers_;
  VectorField<D> places_;          ///< where points were when neighbors were found
  AlignedArray<double> mass_;      ///< per thickness
  VectorField<2 * D + 1> motion_;  ///< x, v, 1 / rho
  VectorField<D * D + 1> stress_;  ///< T, c
  VectorField<D*(D + 1) / 2> repulsion_;
  VectorField<D * D + 1> explained_;  ///< L, shear modulus
  Exchange motion_exchange_, stress_exchange_, repulsion_exchange_, explained_exchange_;

  // by place
  AlignedArray<double> motion_rows_, stress_rows_, rest_rows_;

  // by slot
  MatrixField<D> deformation_;  ///< F - I
  MatrixField<D> gradient_, correction_;
  VectorField<D> pull_, held_;    ///< of NonNestedShear: how fast its force grows, and what it has grown to
  AlignedArray<double> modulus_;  ///< of it: shear modulus; and what is left of the force
  AlignedArray<double> left_, viscous_power_, viscous_rate_, repulsive_power_;
  AlignedArray<double> inverse_length2_;  ///< 1 / V^(2/D), 0 for padding
  AlignedArray<double> speed2_;           ///< squared wave speed in the reference frame
  WallParticles<D> walls_;
  MatrixField<D> slip_gradient_;  ///< scratch, of pairs with smooth walls, like the next two
  VectorField<D> slip_force_;
  AlignedArray<double> slip_power_;
  std::vector<ForceSummary> recorded_;
  std::vector<double> farthest2_;
};

extern template class UpdatedLagrangian<2>;
extern template class UpdatedLagrangian<3>;

}  // namespace sinew
