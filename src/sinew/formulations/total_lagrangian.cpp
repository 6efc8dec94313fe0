#include <sinew/formulations/separation.hpp>
#include <sinew/formulations/sweep_dispatch.hpp>
#include <sinew/formulations/total_lagrangian.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace sinew {

namespace {

double density_of(const AnyMaterial& material) {
  return std::visit([](const auto& m) { return m.density; }, material);
}
double youngs_modulus_of(const AnyMaterial& material) {
  return std::visit([](const auto& m) { return m.elastic.youngs_modulus; }, material);
}

/// Of the materials of all bodies.
template <int D>
std::vector<int> history_numbers(const TotalLagrangianOptions& options) {
  std::vector<int> numbers;
  for (std::size_t b = 0; b < options.materials.size(); ++b)
    numbers.push_back(material_point<D>(options.materials[b], options.damage_of(b), options.plane_stress).numbers);
  return numbers;
}

}  // namespace

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
    : options_(std::move(options)),
      comm_(comm),
      halo_(std::move(halo)),
      pairs_(std::move(pairs)),
      countdown_(pairs_.blocks),
      history_(particles.blocks, history_numbers<D>(options_)),
      summaries_(pairs_.blocks.all.size()),
      spilled_(pairs_.blocks.ghosts) {
  for (int b = 0; b < pairs_.blocks.count(); ++b) {
    const Block& block = pairs_.blocks.all[b];
    const auto runs = std::span(pairs_.blocks.runs).subspan(block.first_ghost, block.end_runs - block.first_ghost);
    const bool reaches_copies =
        std::any_of(runs.begin(), runs.end(), [&](const Run& run) { return run.slot >= particles.slots; });
    (reaches_copies ? edge_ : inner_).push_back(b);
  }
  choose_weights();
  comm_.together([&] { weights_ = make_pair_weights<D>({particles, pairs_}, support_radius, weight_options()); });
  limit_time_step(particles);
  if (options_.separates())
    cracks_ = Cracks<D>(comm_.maximum(
        std::accumulate(support_radius.begin(), support_radius.end(), 0.0, [](double a, double b) { return max(a, b); })));
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
    const double stiffness = options_.hourglass->coefficient() * youngs_modulus_of(material) * weights_.most_stiffness[b];
    omega2 = std::max(omega2, 4.0 * stiffness / density_of(material) / (options_.hourglass->conservative() ? 1.0 : D));
  }
  hourglass_time_step_ = omega2 > 0.0 ? 2.0 / std::sqrt(omega2) : infinity;
}

template <int D>
void TotalLagrangian<D>::choose_weights() {
  const WeightOptions options = weight_options();
  const auto entries = static_cast<std::size_t>(comm_.sum(static_cast<long>(pairs_.entries())));
  const std::size_t bytes = entries * lanes * sizeof(double) * (options.hourglass_weights() ? 2 : 1);
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

/// Room for every thread; only the first call and more threads allocate.
template <int D>
void TotalLagrangian<D>::prepare_scratch() {
  while (scratches_.size() < most_threads()) scratches_.emplace_back(pairs_, options_.viscosity.has_value());
}

template <int D>
SweepTask<D> TotalLagrangian<D>::task_of(int index, const PairSource<D>& source, const WeightOptions& weights, PointStep step,
                                         RecordedState* record) {
  const Block& block = pairs_.blocks.all[index];
  BlockScratch<D>& scratch = scratches_[this_thread()];
  scratch.bring_in(block, source.particles);
  if (options_.viscosity) scratch.bring_in_velocities(block, source.particles);
  if (block.has_list && options_.weights == WeightStorage::computed)
    scratch.bring_in_sizes(block, source.particles, weights_.radius.data());
  const AnyMaterial& material = options_.materials[block.body];
  const bool soft = !options_.hourglass || options_.hourglass->plastic_switch;
  return {block,
          source,
          weights_,
          weights,
          material_point<D>(material, options_.damage_of(block.body), options_.plane_stress),
          options_.thickness,
          density_of(material),
          options_.hourglass ? options_.hourglass->coefficient() : 0.0,
          soft ? 0.0 : youngs_modulus_of(material),
          options_.viscosity ? &*options_.viscosity : nullptr,
          std::sqrt(youngs_modulus_of(material) / density_of(material)),
          options_.wave_speed,
          std::visit([](const auto& m) { return m.elastic.lambda() + 2.0 * m.elastic.mu(); }, material),
          scratch,
          history_.of(index),
          step,
          record};
}

template <int D>
ForceSummary TotalLagrangian<D>::total(const std::vector<ForceSummary>& of_blocks) {
  ForceSummary total;
  for (const ForceSummary& part : of_blocks) {
    total.strain_energy += part.strain_energy;
    total.hourglass_energy += part.hourglass_energy;
    total.released += part.released;
    total.plastic_work += part.plastic_work;
    total.damage_work += part.damage_work;
    total.viscous_power += part.viscous_power;
    total.smallest_jacobian = std::min(total.smallest_jacobian, part.smallest_jacobian);
    total.largest_rate2 = std::max(total.largest_rate2, part.largest_rate2);
  }
  total.finite = std::isfinite(total.strain_energy);
  return total;
}

/// Calls work(block) for all blocks. Displacements of copies are on their way during the first half of the blocks that do not need them, forces on
/// copies during the second half.
template <int D>
template <class Work>
void TotalLagrangian<D>::sweep_blocks(Particles<D>& particles, Work&& work, bool forces_go_back) {
  const std::size_t half = edge_.empty() ? inner_.size() : inner_.size() / 2;
  const std::span<const int> inner(inner_), first = inner.first(half), second = inner.subspan(half);
  const bool many = particles.slots >= fewest_for_threads;
  prepare_scratch();
  if (options_.viscosity) {
    halo_.displacements.start(particles.velocity);
    halo_.displacements.finish();
  }
  halo_.displacements.start(particles.displacement);
  for_each_block(first, many, work, [&] { halo_.displacements.progress(); });
  halo_.displacements.finish();
  for_each_block(edge_, many, work, [] {});
  if (forces_go_back) halo_.forces.start(spilled_);
  for_each_block(second, many, work, [&] { halo_.forces.progress(); });
  if (forces_go_back) halo_.forces.finish();
}

template <int D>
ForceSummary TotalLagrangian<D>::internal_forces(Particles<D>& particles, VectorField<D>& forces, PointStep step, Finish finish,
                                                 RecordedState* record) {
  const PairSource<D> source{particles, pairs_};
  const WeightOptions weights = weight_options();
  const auto complete = [&](int index) {
    add_spilled(pairs_.blocks, index, spilled_, forces);
    finish(pairs_.blocks.all[index].begin, pairs_.blocks.all[index].end);
  };
  const auto work = [&](int index) {
    const SweepTask<D> task = task_of(index, source, weights, step, record);
    summaries_[index] = sweep_block<D>(task);
    task.scratch.hand_out(task.block, forces, spilled_);
    countdown_.done(index, complete);
  };
  countdown_.start();
  sweep_blocks(particles, work, true);
  for_each_block(
      pairs_.blocks.awaiting, true, [&](int index) { countdown_.received(index, complete); }, [] {});
  return total(summaries_);
}

template <int D>
ForceSummary TotalLagrangian<D>::record(Particles<D>& particles, RecordedState& state) {
  const PairSource<D> source{particles, pairs_};
  const WeightOptions weights = weight_options();
  const auto work = [&](int index) {
    const SweepTask<D> task = task_of(index, source, weights, {}, &state);
    recorded_[index] = sweep_block<D>(task);
    task.scratch.discard(task.block);
  };
  recorded_.resize(summaries_.size());
  sweep_blocks(particles, work, false);
  return total(recorded_);
}

/// Energies of the blocks that have changed; what they have lost is released.
template <int D>
void TotalLagrangian<D>::measure_again(const Particles<D>& particles, const std::vector<char>& changed) {
  const PairSource<D> source{particles, pairs_};
  const WeightOptions weights = weight_options();
  prepare_scratch();
  for (std::size_t b = 0; b < changed.size(); ++b) {
    if (!changed[b]) continue;
    const SweepTask<D> task = task_of(static_cast<int>(b), source, weights, {}, nullptr);
    const ForceSummary now = sweep_block<D>(task);
    task.scratch.discard(task.block);
    ForceSummary& summary = summaries_[b];
    summary.released += summary.strain_energy + summary.hourglass_energy - now.strain_energy - now.hourglass_energy;
    summary.strain_energy = now.strain_energy;
    summary.hourglass_energy = now.hourglass_energy;
  }
}

template <int D>
Separation<D> TotalLagrangian<D>::separation(const Particles<D>& particles, const WeightOptions& weights) {
  return Separation<D>({comm_, options_, weights, particles, pairs_, weights_, history_, cracks_});
}

template <int D>
bool TotalLagrangian<D>::separate(const Particles<D>& particles) {
  const WeightOptions weights = weight_options();
  const std::vector<char> changed = separation(particles, weights).cut_off_failed(summaries_);
  if (changed.empty()) return false;
  measure_again(particles, changed);
  limit_time_step(particles);
  return true;
}

template <int D>
void TotalLagrangian<D>::restore_cracks(const Particles<D>& particles, const std::vector<double>& failed,
                                        const std::vector<double>& most_stiffness) {
  const WeightOptions weights = weight_options();
  separation(particles, weights).cut_off_again(failed);
  weights_.most_stiffness = most_stiffness;
  limit_time_step(particles);
}

template <int D>
StoredEnergy TotalLagrangian<D>::stored_energy() const {
  std::vector<int> numbers;
  std::vector<double> partial;
  for (int b = 0; b < pairs_.blocks.count(); ++b) {
    numbers.push_back(pairs_.blocks.all[b].number);
    partial.insert(partial.end(), {summaries_[b].strain_energy, summaries_[b].hourglass_energy, summaries_[b].plastic_work,
                                   summaries_[b].damage_work});
  }
  const std::vector<double> sums = sum_over_blocks(comm_, numbers, partial, 4);
  return {sums[0], sums[1], sums[2], sums[3]};
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
  std::size_t bytes = pairs_.bytes() + weights_.bytes() + history_.bytes() + spilled_.bytes();
  for (const BlockScratch<D>& scratch : scratches_) bytes += scratch.bytes();
  return bytes;
}

template class TotalLagrangian<2>;
template class TotalLagrangian<3>;

}  // namespace sinew
