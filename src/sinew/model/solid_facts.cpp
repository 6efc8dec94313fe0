/// Of SolidSimulation: what was built, in numbers that a user can check.

#include <sinew/model/solid_simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sinew {

namespace {

template <int D>
ModelFacts::Body facts_of(const BodyRange& range, const BodyCase& c, const Particles<D>& particles, double thickness) {
  ModelFacts::Body body{range.name, "", range.count, 0.0, 0.0, range.spacing, 0.0, 0.0};
  for (int slot = range.begin; slot < range.end; ++slot) {
    body.volume += particles.volume[slot] * thickness;
    body.mass += particles.mass[slot];
  }
  std::visit(
      [&](const auto& m) {
        body.material = m.name;
        body.longitudinal_wave_speed = std::sqrt((m.elastic.lambda() + 2.0 * m.elastic.mu()) / m.density);
        body.shear_wave_speed = std::sqrt(m.elastic.mu() / m.density);
      },
      c.material);
  return body;
}

}  // namespace

template <int D>
void SolidSimulation<D>::collect_facts(const std::vector<GeneratedBody>& bodies, double setup_seconds) {
  const BlockPairs<D>& list = solid_.pairs();
  facts_.particles = particles_.count;
  facts_.pairs = static_cast<long>(list.pairs);
  facts_.neighbors_min = list.neighbor_count[particles_.slot_of.front()];
  for (int slot : particles_.slot_of) {
    facts_.neighbors_min = std::min(facts_.neighbors_min, list.neighbor_count[slot]);
    facts_.neighbors_max = std::max(facts_.neighbors_max, list.neighbor_count[slot]);
  }
  facts_.neighbors_mean = static_cast<double>(list.pairs) / particles_.count;
  facts_.time_step = stable_time_step();
  facts_.time_step_limit = step_size_.limit(summary_);
  facts_.memory_bytes = particles_.bytes() + solid_.bytes() + forces_.bytes();
  facts_.bytes_per_particle = static_cast<double>(facts_.memory_bytes) / particles_.count;
  facts_.blocks = list.blocks.count();
  facts_.lattice_share = static_cast<double>(solid_.lattice().slices()) / list.blocks.slices();
  facts_.lattice_patterns = static_cast<int>(solid_.lattice().patterns.size());
  facts_.pair_weights = name_of(solid_.options().weights);
  facts_.setup_seconds = setup_seconds;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    facts_.bodies.push_back(facts_of(particles_.bodies[b], case_.bodies[b], particles_, solid_.options().thickness));
    for (const std::string& warning : bodies[b].points.warnings)
      facts_.warnings.push_back(fmt::format("body \"{}\": {}", case_.bodies[b].name, warning));
  }
  for (const auto& [name, slots] : regions_) facts_.regions[name] = static_cast<long>(slots.size());
  if (bodies.size() > 1) facts_.warnings.push_back("the bodies do not act on each other: there is no contact between them.");
  if (!solid_.options().hourglass) facts_.warnings.push_back("zero-energy modes are not controlled: stabilization is off.");
}

template void SolidSimulation<2>::collect_facts(const std::vector<GeneratedBody>&, double);
template void SolidSimulation<3>::collect_facts(const std::vector<GeneratedBody>&, double);

}  // namespace sinew
