#include <sinew/formulations/mutual_weights.hpp>
#include <sinew/formulations/sweep_dispatch.hpp>
#include <sinew/formulations/total_lagrangian.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace sinew {

template <int D>
TotalLagrangian<D>::TotalLagrangian(const Particles<D>& particles, const std::vector<double>& support_radius,
                                    TotalLagrangianOptions options)
    : TotalLagrangian(
          particles,
          make_block_pairs(particles, build_pair_list(particles, support_radius), support_radius, may_use_lattice(options)),
          support_radius, options, Comm(), Halo()) {}

template <int D>
TotalLagrangian<D>::TotalLagrangian(const Particles<D>& particles, BlockPairs<D> pairs, const std::vector<double>& support_radius,
                                    TotalLagrangianOptions options, const Comm& comm, Halo halo)
    : Formulation<D>(comm, std::move(pairs), std::move(halo),
                     HistoryStore(particles.blocks, history_numbers<D>(options.materials, options.damages, options.plane_stress)),
                     options.thickness),
      options_(std::move(options)) {
  take_reference(particles, support_radius);
  if (options_.separates())
    cracks_ = Cracks<D>(comm_.maximum(
        std::accumulate(support_radius.begin(), support_radius.end(), 0.0, [](double a, double b) { return max(a, b); })));
}

/// Everything that belongs to a reference configuration and its pairs.
template <int D>
void TotalLagrangian<D>::take_reference(const Particles<D>& particles, const std::vector<double>& support_radius) {
  countdown_.emplace(pairs_.blocks);
  spilled_ = VectorField<D>(pairs_.blocks.ghosts);
  scratches_.clear();
  sort_blocks(particles);
  choose_weights();
  make_weights(particles, support_radius);
  make_matrices(particles);
  make_dissipation();
  limit_time_step(particles);
}

/// By whether they reach copies.
template <int D>
void TotalLagrangian<D>::sort_blocks(const Particles<D>& particles) {
  inner_.clear();
  edge_.clear();
  for (int b = 0; b < pairs_.blocks.count(); ++b) {
    const Block& block = pairs_.blocks.all[b];
    const auto runs = std::span(pairs_.blocks.runs).subspan(block.first_ghost, block.end_runs - block.first_ghost);
    const bool reaches_copies =
        std::any_of(runs.begin(), runs.end(), [&](const Run& run) { return run.slot >= particles.slots; });
    (reaches_copies ? edge_ : inner_).push_back(b);
  }
}

/// Weights that need both ends of a pair are made when the maps of copies have come.
template <int D>
void TotalLagrangian<D>::make_weights(const Particles<D>& particles, const std::vector<double>& support_radius) {
  const PairSource<D> source{particles, pairs_};
  const WeightOptions options = weight_options();
  const std::size_t places = static_cast<std::size_t>(particles.slots) + particles.copies;
  MapField<D> maps;
  comm_.together([&] {
    if (options.mutual()) maps = MapField<D>(places);
    weights_ = make_pair_weights<D>(source, support_radius, options, options.mutual() ? &maps : nullptr);
  });
  if (options.mutual()) {
    for (MatrixField<D>& part : maps.parts) {
      halo_.matrices.start(part);
      halo_.matrices.finish();
    }
    add_mutual_weights(source, options, maps, weights_);
  }
}

template <int D>
void TotalLagrangian<D>::make_matrices(const Particles<D>& particles) {
  const std::size_t places = static_cast<std::size_t>(particles.slots) + particles.copies;
  const bool rate = options_.deformation_gradient == DeformationGradient::rate;
  matrices_.slots = particles.slots;
  if (options_.deformation_gradient != DeformationGradient::direct) matrices_.gradient = MatrixField<D>(places);
  if (rate) matrices_.rate = MatrixField<D>(particles.slots);
  if (rate && options_.stages) matrices_.remembered = MatrixField<D>(particles.slots);
  if (options_.deformation_gradient == DeformationGradient::bond_variational) matrices_.stress = MatrixField<D>(places);
  if (options_.jst && options_.jst->eta4 > 0.0) matrices_.laplacian = VectorField<D>(places);
}

/// Coefficients of JST dissipation of each body. The eigenvalues of its Laplacian are not larger than twice the largest sum of its weights (Gershgorin).
template <int D>
void TotalLagrangian<D>::make_dissipation() {
  dissipation_.clear();
  dissipation_rate_ = 0.0;
  if (!options_.jst) return;
  comm_.maximum(weights_.most_trace);
  comm_.maximum(weights_.most_slope);
  std::vector<double> smallest(options_.materials.size(), infinity);
  for (const Block& block : pairs_.blocks.all)
    for (int slot = block.begin; slot < block.end; ++slot)
      smallest[block.body] = std::min(smallest[block.body], weights_.radius[slot]);
  for (double& radius : smallest) radius = -radius;
  comm_.maximum(smallest);
  const double customary = std::visit([](const auto& kernel) { return kernel.customary_h; }, options_.kernel);
  for (std::size_t b = 0; b < options_.materials.size(); ++b) {
    const double c = std::sqrt(longitudinal_modulus_of(options_.materials[b]) / density_of(options_.materials[b]));
    dissipation_.push_back(options_.jst->coefficients(c, -smallest[b] / customary));
    const double most = weights_.most_trace[b] > 0.0 ? 4.0 * D * weights_.most_slope[b] / weights_.most_trace[b] : 0.0;
    dissipation_rate_ = std::max(dissipation_rate_, dissipation_[b].rate(most));
  }
}

/// 2 / omega of the stiffest hourglass mode. Each pair has the shares of both ends, and a mode may move both ends against each other:
/// omega^2 <= 4 c E / rho sum_j w_ij, c the coefficient and w_ij the weights; only 1/D of it where the force is along the pair.
template <int D>
void TotalLagrangian<D>::limit_time_step(const Particles<D>& particles) {
  comm_.maximum(weights_.most_stiffness);
  if (!options_.hourglass) return;
  double omega2 = 0.0;
  for (std::size_t b = 0; b < particles.bodies.size(); ++b) {
    const AnyMaterial& material = options_.materials[b];
    const double stiffness = options_.hourglass_coefficient(b) * youngs_modulus_of(material) * weights_.most_stiffness[b];
    omega2 = std::max(omega2, 4.0 * stiffness / density_of(material) / (options_.hourglass->conservative() ? 1.0 : D));
  }
  hourglass_time_step_ = omega2 > 0.0 ? 2.0 / std::sqrt(omega2) : infinity;
}

template <int D>
void TotalLagrangian<D>::choose_weights() {
  const WeightOptions options = weight_options();
  const auto entries = static_cast<std::size_t>(comm_.sum(static_cast<long>(pairs_.entries())));
  const std::size_t bytes = entries * lanes * sizeof(double) * (options.hourglass_weights() ? 2 : 1);
  storage_ = options_.weights;
  if (!options.radial())
    storage_ = WeightStorage::stored;
  else if (storage_ == WeightStorage::automatic)
    storage_ = bytes <= most_stored_bytes ? WeightStorage::stored : WeightStorage::computed;
}

template <int D>
WeightOptions TotalLagrangian<D>::weight_options() const {
  HourglassWeight hourglass = HourglassWeight::none;
  if (options_.hourglass)
    hourglass = options_.hourglass->conservative() ? HourglassWeight::conservative : HourglassWeight::central;
  WeightOptions options{options_.kernel, options_.correction, hourglass, storage_};
  options.lenient = later_ && later_->renewed();
  if (options_.averages())
    options.average =
        options_.deformation_gradient == DeformationGradient::bond_variational ? BondAverage::mutual : BondAverage::own;
  options.symmetric = options_.momentum == MomentumForm::symmetric;
  options.vectors = options_.deformation_gradient == DeformationGradient::rate || options_.corrects_laplacian();
  options.dissipation = options_.jst.has_value();
  options.by_distance = options_.wave_speed == WaveSpeed::reference;
  return options;
}

template <int D>
Vec<double, D> TotalLagrangian<D>::toward_neighbors(const Particles<D>& particles, int slot) const {
  Vec<double, D> sum;
  std::visit(
      [&]<class Kernel>(const Kernel&) {
        for (int j : pairs_.neighbors(slot, particles)) {
          const Vec<double, D> X = particles.position[j] - particles.position[slot];
          sum += radial_weight<Kernel, false>(X, particles.volume[j], weights_.radius[slot]).gradient * X;
        }
      },
      options_.kernel);
  return sum;
}

template <int D>
std::size_t TotalLagrangian<D>::bytes() const {
  std::size_t bytes =
      matrices_.bytes() + linearized_.bytes() + pairs_.bytes() + weights_.bytes() + history_.bytes() + spilled_.bytes();
  for (const BlockScratch<D>& scratch : scratches_) bytes += scratch.bytes();
  return bytes;
}

template class TotalLagrangian<2>;
template class TotalLagrangian<3>;

}  // namespace sinew
