/// Of SolidSimulation: what was built, in numbers that a user can check.

#include <sinew/model/solid_simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sinew {

namespace {

ModelFacts::Body facts_of(const BodyRange& range, const BodyCase& c) {
  ModelFacts::Body body{range.name, "", 0, 0.0, 0.0, range.spacing, 0.0, 0.0};
  std::visit(
      [&](const auto& m) {
        body.material = m.name;
        body.longitudinal_wave_speed = std::sqrt((m.elastic.lambda() + 2.0 * m.elastic.mu()) / m.density);
        body.shear_wave_speed = std::sqrt(m.elastic.mu() / m.density);
      },
      c.material);
  return body;
}

bool separates(const BodyCase& body) {
  return body.damage && std::visit([](const auto& model) { return model.growth.separate; }, *body.damage);
}

}  // namespace

/// Particles, volumes and masses of all bodies, with what belongs to all ranks.
template <int D>
void SolidSimulation<D>::collect_bodies(const std::vector<GeneratedBody>& bodies) {
  const std::size_t count = bodies.size();
  std::vector<double> sums(2 * count * particles_.blocks.size(), 0.0);
  for (std::size_t b = 0; b < particles_.blocks.size(); ++b) {
    const BlockRange& block = particles_.blocks[b];
    double* of_body = sums.data() + 2 * (count * b + block.body);
    for (int slot = block.begin; slot < block.end; ++slot) {
      of_body[0] += particles_.volume[slot] * solid_->thickness();
      of_body[1] += particles_.mass[slot];
    }
  }
  sums = sum_over_blocks(comm_, particles_.block_numbers(), sums, static_cast<int>(2 * count));
  for (std::size_t b = 0; b < count; ++b) {
    facts_.bodies.push_back(facts_of(particles_.bodies[b], case_.bodies[b]));
    facts_.bodies.back().particles = static_cast<long>(bodies[b].points.size());
    facts_.bodies.back().volume = sums[2 * b];
    facts_.bodies.back().mass = sums[2 * b + 1];
    for (const std::string& warning : bodies[b].points.warnings)
      facts_.warnings.push_back(fmt::format("body \"{}\": {}", case_.bodies[b].name, warning));
  }
}

/// How the ranks share the case, and what they send each other.
template <int D>
void SolidSimulation<D>::collect_ranks() {
  const Halo& halo = solid_->halo();
  const auto sent = static_cast<double>(halo.displacements.bytes() + halo.forces.bytes());
  RanksPlan& ranks = facts_.ranks;
  ranks.ranks = comm_.size();
  ranks.particles_most = static_cast<long>(comm_.maximum(particles_.count));
  ranks.pairs_most = static_cast<long>(comm_.maximum(static_cast<double>(solid_->pairs().pairs)));
  ranks.pairs_imbalance = static_cast<double>(ranks.pairs_most) * comm_.size() / static_cast<double>(facts_.pairs) - 1.0;
  ranks.copies_share = static_cast<double>(comm_.sum(long{particles_.copies})) / static_cast<double>(facts_.particles);
  ranks.bytes = static_cast<double>(comm_.sum(static_cast<long>(sent)));
  ranks.bytes_most = comm_.maximum(sent);
  ranks.messages_most = static_cast<int>(comm_.maximum(halo.displacements.messages() + halo.forces.messages()));
  if (const long idle = comm_.sum(particles_.count == 0 ? 1L : 0L); idle > 0)
    facts_.warnings.push_back(fmt::format(
        "{} of {} ranks have nothing to do: the case has {} block{} of particles, and one rank computes a block. Use fewer "
        "ranks or a smaller [solver] block_size.",
        idle, comm_.size(), facts_.blocks, facts_.blocks == 1 ? "" : "s"));
}

/// What moves faster than waves in the softest body makes shocks, which need viscosity, if anything resolves them.
template <int D>
void SolidSimulation<D>::warn_of_supersonic_motion() {
  double fastest2 = 0.0, slowest_wave = infinity;
  for (int slot : order_.slots()) fastest2 = std::max(fastest2, dot(particles_.velocity[slot], particles_.velocity[slot]));
  const double fastest = std::sqrt(comm_.maximum(fastest2));
  for (const ModelFacts::Body& body : facts_.bodies)
    if (body.longitudinal_wave_speed > 0.0) slowest_wave = std::min(slowest_wave, body.longitudinal_wave_speed);
  if (fastest > slowest_wave)
    facts_.warnings.push_back(
        fmt::format("something moves at {:.4g} at the start, faster than the waves of the slowest body ({:.4g}): shocks that "
                    "particles cannot resolve. "
                    "Is a unit wrong? Otherwise try artificial_viscosity.",
                    fastest, slowest_wave));
}

template <int D>
void SolidSimulation<D>::collect_facts(const std::vector<GeneratedBody>& bodies, double setup_seconds) {
  const BlockPairs<D>& list = solid_->pairs();
  const LatticePatterns<D>& lattice = solid_->lattice();
  long counts[] = {
      particles_.count,
      static_cast<long>(list.pairs),
      lattice.slices(),
      list.blocks.slices(),
      list.blocks.count(),
      static_cast<long>(lattice.patterns.size()),
      static_cast<long>(particles_.bytes() + solid_->bytes() + forces_.bytes() + order_.bytes() + contacts_.bytes())};
  comm_.sum(counts);
  facts_.particles = counts[0];
  facts_.pairs = counts[1];
  double most = 0.0, least = infinity;
  for (int slot : order_.slots()) {
    least = std::min<double>(least, list.neighbor_count[slot]);
    most = std::max<double>(most, list.neighbor_count[slot]);
  }
  facts_.neighbors_min = static_cast<int>(-comm_.maximum(-least));
  facts_.neighbors_max = static_cast<int>(comm_.maximum(most));
  facts_.neighbors_mean = static_cast<double>(facts_.pairs) / static_cast<double>(facts_.particles);
  facts_.time_step = stable_time_step();
  facts_.time_step_limit = implicit_ ? "as given" : step_size_.limit(summary_, contact_);
  facts_.memory_bytes = static_cast<std::size_t>(counts[6]);
  facts_.bytes_per_particle = static_cast<double>(facts_.memory_bytes) / static_cast<double>(facts_.particles);
  facts_.blocks = static_cast<int>(counts[4]);
  facts_.lattice_share = static_cast<double>(counts[2]) / static_cast<double>(counts[3]);
  facts_.lattice_patterns = static_cast<int>(counts[5]);
  facts_.pair_weights = solid_->weights_name();
  facts_.setup_seconds = setup_seconds;
  collect_bodies(bodies);
  collect_ranks();
  for (const auto& [name, region] : regions_) facts_.regions[name] = region.particles;
  warn_of_supersonic_motion();
  if (bodies.size() > 1 && !contacts_.pairs().any() && case_.formulation.model == "total_lagrangian")
    facts_.warnings.push_back("the bodies do not act on each other: there is no [[contact]] between them.");
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (separates(case_.bodies[b]) && !contacts_.pairs().touches_itself(static_cast<int>(b)))
      facts_.warnings.push_back(fmt::format(
          "body \"{}\" comes apart where it fails, but has no [[contact]] with self: its pieces will pass through each other.",
          case_.bodies[b].name));
  for (const std::string& warning : solid_->warnings()) facts_.warnings.push_back(warning);
}

template void SolidSimulation<2>::collect_facts(const std::vector<GeneratedBody>&, double);
template void SolidSimulation<3>::collect_facts(const std::vector<GeneratedBody>&, double);

}  // namespace sinew
