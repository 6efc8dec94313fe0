#include <sinew/formulations/sweep_dispatch.hpp>
#include <sinew/formulations/total_lagrangian.hpp>
#include <sinew/neighbors/listed_pairs.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {

namespace {

double density_of(const AnyMaterial& material) {
  return std::visit([](const auto& m) { return m.density; }, material);
}
double youngs_modulus_of(const AnyMaterial& material) {
  return std::visit([](const auto& m) { return m.elastic.youngs_modulus; }, material);
}

/// 2 / omega of the stiffest hourglass mode. Each pair has the shares of both ends, and a mode may move both ends against each other:
/// omega^2 <= 4 c E / rho sum_j w_ij, c the coefficient and w_ij the weights; only 1/D of it where the force is along the pair.
template <int D>
double hourglass_limit(const Particles<D>& particles, const PairWeights<D>& weights, const TotalLagrangianOptions& options) {
  double omega2 = 0.0;
  for (std::size_t b = 0; b < particles.bodies.size(); ++b) {
    const AnyMaterial& material = options.materials[b];
    const double stiffness = options.hourglass->coefficient() * youngs_modulus_of(material) * weights.most_stiffness[b];
    omega2 = std::max(omega2, 4.0 * stiffness / density_of(material) / (options.hourglass->conservative() ? 1.0 : D));
  }
  return omega2 > 0.0 ? 2.0 / std::sqrt(omega2) : infinity;
}

}  // namespace

template <int D>
TotalLagrangian<D>::TotalLagrangian(const Particles<D>& particles, const std::vector<double>& support_radius,
                                    TotalLagrangianOptions options)
    : options_(std::move(options)),
      slots_(particles.slots),
      list_(build_pair_list(particles, support_radius)),
      chunks_(make_chunks(particles, list_)),
      countdown_(chunks_) {
  lattice_ = options_.lattice && weight_options().radial() ? find_lattice_patterns(particles, list_, support_radius)
                                                           : no_lattice_patterns(particles);
  drop_lattice_slices(list_, lattice_);
  choose_weights();
  weights_ = make_pair_weights<D>({particles, list_, lattice_}, support_radius, weight_options());
  chunk_summaries_.resize(chunks_.size());
  if (list_.entries() > 0) {
    place_rows_ = AlignedArray<double>(std::size_t(place_width<D>) * slots_);
    for (int slot = 0; slot < slots_; ++slot)
      for (int c = 0; c < D; ++c)
        place_rows_[std::size_t(place_width<D>) * slot + vector_width<D> + c] = particles.position.at(c, slot);
  }
  if (options_.hourglass) hourglass_time_step_ = hourglass_limit(particles, weights_, options_);
}

template <int D>
void TotalLagrangian<D>::choose_weights() {
  const WeightOptions options = weight_options();
  const std::size_t bytes = list_.entries() * lanes * sizeof(double) * (options.hourglass_weights() ? 2 : 1);
  if (!options.radial())
    options_.weights = WeightStorage::stored;
  else if (options.storage == WeightStorage::automatic)
    options_.weights = bytes <= most_stored_bytes ? WeightStorage::stored : WeightStorage::computed;
}

template <int D>
WeightOptions TotalLagrangian<D>::weight_options() const {
  HourglassWeight hourglass = HourglassWeight::none;
  if (options_.hourglass)
    hourglass = options_.hourglass->conservative() ? HourglassWeight::conservative : HourglassWeight::central;
  return {options_.kernel, options_.correction, hourglass, options_.weights};
}

template <int D>
ForceStreams<D> TotalLagrangian<D>::make_streams() const {
  return ForceStreams<D>(slots_, list_.entries() > 0 || lattice_.slices() == 0, lattice_.slices() > 0);
}

/// Copies the displacements to the rows, and sees to it that every thread has room; only the first call and more threads allocate.
template <int D>
void TotalLagrangian<D>::prepare_scratch(const Particles<D>& particles) const {
  if (list_.entries() == 0) return;
  const std::size_t threads = most_threads();
  std::size_t longest = 0;
  for (int s = 0; kept_.size() < threads && s < list_.slices(); ++s)
    longest = std::max(longest, list_.first_entry[s + 1] - list_.first_entry[s]);
  while (kept_.size() < threads) kept_.emplace_back(longest * numbers_kept<D> * lanes);
  for_each_piece(slots_, [&](int begin, int end) {
    for (int c = 0; c < D; ++c) {
      const double* u = particles.displacement.component(c);
      double* row = place_rows_.data() + c;
      for (int slot = begin; slot < end; ++slot) row[std::size_t(place_width<D>) * slot] = u[slot];
    }
  });
}

template <int D>
ForceSummary TotalLagrangian<D>::sweep(const Particles<D>& particles, ForceStreams<D>& forces, RecordedState* record,
                                       Finish finish) const {
  prepare_scratch(particles);
  const PairSource<D> source{particles, list_, lattice_};
  const WeightOptions weights = weight_options();
  const auto work = [&](const Chunk& chunk, int number) {
    const AnyMaterial& material = options_.materials[chunk.body];
    const double hourglass = options_.hourglass ? options_.hourglass->coefficient() * youngs_modulus_of(material) : 0.0;
    double* kept = kept_.empty() ? nullptr : kept_[this_thread()].data();
    chunk_summaries_[number] =
        sweep_chunk<D>({chunk, source, weights_, weights, material_point<D>(material, options_.plane_stress), options_.thickness,
                        density_of(material), hourglass, place_rows_.data(), kept, forces, record});
  };
  for_each_chunk(chunks_, countdown_, work,
                 [&](const Chunk& chunk) { finish(lanes * chunk.first_slice, lanes * chunk.end_slice); });
  ForceSummary total;
  for (const ForceSummary& part : chunk_summaries_) {
    total.strain_energy += part.strain_energy;
    total.hourglass_energy += part.hourglass_energy;
    total.smallest_jacobian = std::min(total.smallest_jacobian, part.smallest_jacobian);
    total.largest_rate2 = std::max(total.largest_rate2, part.largest_rate2);
  }
  return total;
}

template <int D>
Vec<double, D> TotalLagrangian<D>::toward_neighbors(const Particles<D>& particles, int slot) const {
  Vec<double, D> sum;
  std::visit(
      [&]<class Kernel>(const Kernel&) {
        for (int j : neighbors(slot)) {
          const Vec<double, D> X = particles.position[j] - particles.position[slot];
          sum += radial_weight<Kernel, false>(X, particles.volume[j], weights_.radius[slot]).gradient * X;
        }
      },
      options_.kernel);
  return sum;
}

template <int D>
std::size_t TotalLagrangian<D>::bytes() const {
  return list_.bytes() + lattice_.bytes() + weights_.bytes() + place_rows_.bytes();
}

template <int D>
ForceSummary TotalLagrangian<D>::internal_forces(const Particles<D>& particles, ForceStreams<D>& forces) const {
  return sweep(particles, forces, nullptr, [](int, int) {});
}

template <int D>
ForceSummary TotalLagrangian<D>::internal_forces(const Particles<D>& particles, ForceStreams<D>& forces, Finish finish) const {
  return sweep(particles, forces, nullptr, finish);
}

template <int D>
ForceSummary TotalLagrangian<D>::record(const Particles<D>& particles, RecordedState& state) const {
  if (!unused_forces_) unused_forces_ = std::make_unique<ForceStreams<D>>(make_streams());
  return sweep(particles, *unused_forces_, &state, [&](int begin, int end) { unused_forces_->clear(begin, end); });
}

template class TotalLagrangian<2>;
template class TotalLagrangian<3>;

}  // namespace sinew
