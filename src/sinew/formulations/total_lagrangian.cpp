#include <sinew/formulations/sweep_dispatch.hpp>
#include <sinew/formulations/total_lagrangian.hpp>

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
    const BodyRange& body = particles.bodies[b];
    const double most = *std::max_element(weights.stiffness_sum.begin() + body.begin, weights.stiffness_sum.begin() + body.end);
    const AnyMaterial& material = options.materials[b];
    const double stiffness = options.hourglass->coefficient() * youngs_modulus_of(material) * most;
    omega2 = std::max(omega2, 4.0 * stiffness / density_of(material) / (options.hourglass->conservative() ? 1.0 : D));
  }
  return omega2 > 0.0 ? 2.0 / std::sqrt(omega2) : infinity;
}

HourglassWeight weight_of(const std::optional<HourglassStiffness>& hourglass) {
  return hourglass && !hourglass->conservative() ? HourglassWeight::central : HourglassWeight::conservative;
}

}  // namespace

template <int D>
TotalLagrangian<D>::TotalLagrangian(const Particles<D>& particles, const std::vector<double>& support_radius,
                                    TotalLagrangianOptions options)
    : options_(std::move(options)),
      list_(build_pair_list(particles, support_radius)),
      weights_(make_pair_weights(particles, list_, support_radius, options_.kernel, options_.correction,
                                 weight_of(options_.hourglass))),
      chunks_(make_chunks(particles, list_)),
      chunk_summaries_(chunks_.size()) {
  if (options_.hourglass) hourglass_time_step_ = hourglass_limit(particles, weights_, options_);
}

template <int D>
ForceSummary TotalLagrangian<D>::sweep(const Particles<D>& particles, ForceStreams<D>& forces, RecordedState* record) const {
  for_each_chunk(chunks_, [&](const Chunk& chunk, int number) {
    const AnyMaterial& material = options_.materials[chunk.body];
    const double hourglass = options_.hourglass ? options_.hourglass->coefficient() * youngs_modulus_of(material) : 0.0;
    const SweepScalars scalars{density_of(material), options_.thickness, hourglass,
                               options_.hourglass && options_.hourglass->conservative()};
    chunk_summaries_[number] =
        sweep_any_chunk<D>({chunk, list_, particles, weights_, scalars, forces.stream[chunk.stream].data(), record}, material,
                           options_.plane_stress);
  });
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
ForceSummary TotalLagrangian<D>::internal_forces(const Particles<D>& particles, ForceStreams<D>& forces) const {
  return sweep(particles, forces, nullptr);
}

template <int D>
ForceSummary TotalLagrangian<D>::record(const Particles<D>& particles, RecordedState& state) const {
  if (!unused_forces_) unused_forces_ = std::make_unique<ForceStreams<D>>(particles.slots);
  return sweep(particles, *unused_forces_, &state);
}

template class TotalLagrangian<2>;
template class TotalLagrangian<3>;

}  // namespace sinew
