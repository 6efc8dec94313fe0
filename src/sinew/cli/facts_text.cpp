#include <sinew/cli/facts_text.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sinew/cli/number_format.hpp>
#include <sinew/cli/recorder.hpp>

namespace sinew {

namespace {

std::string body_text(const ModelFacts::Body& body, const UnitSystem& units) {
  const std::string length = units.name_of("m"), speed = units.name_of("m/s");
  return fmt::format(
      "body {} ({}): {} particles, spacing {}, volume {}, mass {}\n"
      "  wave speeds {} (longitudinal), {} (shear)\n",
      body.name, body.material, count_text(body.particles), quantity_text(body.spacing, length),
      quantity_text(body.volume, units.name_of("m^3")), quantity_text(body.mass, units.name_of("kg")),
      quantity_text(body.longitudinal_wave_speed, speed), quantity_text(body.shear_wave_speed, speed));
}

std::string regions_text(const ModelFacts& facts) {
  std::string text;
  for (const auto& [name, particles] : facts.regions)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count_text(particles));
  return text.empty() ? "" : "particles in regions: " + text + "\n";
}

/// Which way the pairs go.
std::string paths_text(const ModelFacts& facts) {
  const double share = 100.0 * facts.lattice_share;
  if (share == 0.0) return fmt::format("pairs: list for all particles, weights {}\n", facts.pair_weights);
  if (share == 100.0) return fmt::format("pairs: lattice for all particles ({} patterns)\n", facts.lattice_patterns);
  return fmt::format("pairs: lattice for {:.1f} % of the particles ({} patterns), list for the others, weights {}\n", share,
                     facts.lattice_patterns, facts.pair_weights);
}

/// How several ranks share the case.
std::string ranks_text(const ModelFacts& facts) {
  const RanksPlan& r = facts.ranks;
  if (r.ranks == 1) return "";
  return fmt::format(
      "{} ranks: at most {} particles each, {:.1f} % more pairs than the mean, {:.1f} % copies; a step sends {} in at most {} "
      "messages a rank\n",
      r.ranks, count_text(r.particles_most), 100.0 * r.pairs_imbalance, 100.0 * r.copies_share, bytes_text(r.bytes),
      r.messages_most);
}

bool is_free(const Case& c) {
  const auto zero = [](const Expression& e) { return e.is_constant() && e(0.0) == 0.0; };
  return c.boundary.empty() && c.walls.empty() && c.solver.damping == 0.0 &&
         std::all_of(c.body_force.begin(), c.body_force.end(), zero);
}

std::string momentum_line(const std::string& name, const Point& now, const Point& start, const std::string& unit) {
  return fmt::format("{} ({:.6g}, {:.6g}, {:.6g}) {}, at the start ({:.6g}, {:.6g}, {:.6g})", name, now[0], now[1], now[2], unit,
                     start[0], start[1], start[2]);
}

}  // namespace

double estimated_steps(const Case& c, const ModelFacts& facts) {
  const double steps = std::ceil(c.solver.end_time / facts.time_step);
  return c.solver.max_steps ? std::min(steps, static_cast<double>(*c.solver.max_steps)) : steps;
}

std::string facts_text(const Case& c, const ModelFacts& facts) {
  const UnitSystem& units = c.general.units;
  std::string text = fmt::format("case {}, {}D{}\n", c.general.name, c.general.dimension,
                                 c.general.reference.empty() ? "" : ", " + c.general.reference);
  for (const ModelFacts::Body& body : facts.bodies) text += body_text(body, units);
  text += regions_text(facts);
  text += fmt::format("{} particles with {} neighbors each on average (from {} to {})\n", count_text(facts.particles),
                      fmt::format("{:.3g}", facts.neighbors_mean), facts.neighbors_min, facts.neighbors_max);
  text += paths_text(facts);
  text += ranks_text(facts);
  text += fmt::format("time step {} (limited by: {}), about {} steps\n", quantity_text(facts.time_step, units.name_of("s")),
                      facts.time_step_limit, count_text(std::lround(std::min(estimated_steps(c, facts), 1e15))));
  text += fmt::format("memory {} ({:.0f} bytes a particle), built in {}", bytes_text(static_cast<double>(facts.memory_bytes)),
                      facts.bytes_per_particle, duration_text(facts.setup_seconds));
  for (const std::string& warning : facts.warnings) text += "\nwarning: " + warning;
  return text;
}

std::string balance_text(const Case& c, const Energies& e, const Momenta& m, const Momenta& initial) {
  const UnitSystem& units = c.general.units;
  std::string text = fmt::format(
      "energy [{}]: kinetic {:.6g}, strain {:.6g}, hourglass {:.6g}, contact {:.6g}, work done {:.6g}, dissipated {:.6g}",
      units.name_of("J"), e.kinetic, e.strain, e.hourglass, e.contact, e.external_work, e.dissipated);
  text += e.plastic_work > 0.0 ? fmt::format(", of it plastic work {:.6g}\n", e.plastic_work) : "\n";
  const double deformation = e.strain + e.plastic_work;
  if (deformation > 0.0 && e.hourglass > 0.1 * deformation)
    text += fmt::format(
        "  the hourglass energy is {:.0f} % of that of deformation: the particles are too coarse for this deformation, refine "
        "them\n",
        100.0 * e.hourglass / deformation);
  text += fmt::format("  balance: total + dissipated - work - initial = {:.3e} ({:.1e} of the largest of them)\n",
                      e.balance_error(), relative_balance_error(e));
  text += momentum_line("linear momentum", m.linear, initial.linear, units.name_of("kg m/s")) + "\n";
  text += momentum_line("angular momentum", m.angular, initial.angular, units.name_of("kg m^2/s"));
  if (is_free(c) && m.linear_scale > 0.0)
    text += fmt::format("\n  nothing acts from outside: linear momentum changed by {:.1e} of sum m |v|",
                        norm(m.linear - initial.linear) / m.linear_scale);
  return text;
}

}  // namespace sinew
