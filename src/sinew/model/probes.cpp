#include <sinew/model/fragments.hpp>
#include <sinew/model/probes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace sinew {

namespace {

/// Component of a vector total; -1: magnitude.
double component_of(const Point& v, int component) { return component < 0 ? norm(v) : v[component]; }

/// Component of a quantity that has so many of them in a row; -1: magnitude.
double component_of(const double* values, int components, int component) {
  if (component >= 0) return values[stored_index(component, components)];
  double square = 0.0;
  for (int k = 0; k < components; ++k) square += values[k] * values[k];
  return std::sqrt(square);
}

double energy_of(std::string_view name, const Energies& e) {
  if (name == "energy.kinetic") return e.kinetic;
  if (name == "energy.strain") return e.strain;
  if (name == "energy.hourglass") return e.hourglass;
  if (name == "energy.contact") return e.contact;
  if (name == "energy.external_work") return e.external_work;
  if (name == "energy.dissipated") return e.dissipated;
  if (name == "energy.plastic_work") return e.plastic_work;
  if (name == "energy.damage_work") return e.damage_work;
  if (name == "energy.balance_error") return e.balance_error();
  return e.total();
}

bool is_of_fragments(std::string_view name) { return name == "fragments" || name == "largest_fragment" || name == "debris"; }

}  // namespace

template <int D>
Probes<D>::Probes(const Case& c, const Regions& regions) : units_(c.general.units) {
  std::vector<std::string> variables{"t"};
  for (const ProbeCase& p : c.probes) {
    Probe probe{p, nullptr, Expression(), 0, -1, {}};
    if (p.expression.empty()) {
      probe.quantity = find_quantity(p.quantity);
      probe.component = component_index(*probe.quantity, p.component);
      for (std::size_t w = 0; w < c.walls.size(); ++w)
        if (c.walls[w].name == p.wall) probe.wall = static_cast<int>(w);
      probe.slots = regions.at(p.region.empty() ? "all" : p.region).slots;
      need_hourglass_error_ = need_hourglass_error_ || p.quantity == "hourglass_error";
      need_record_ = need_record_ || is_of_fragments(p.quantity) || (!probe.quantity->is_total && needs_record(p.quantity));
    } else {
      probe.formula = Expression::over(variables, p.expression, c.parameters, p.place);
    }
    variables.push_back(p.name);
    probes_.push_back(std::move(probe));
  }
}

/// Calls use(slot, value) for the particles of a probe, in order.
template <int D>
template <class Use>
void Probes<D>::for_each_value(const Probe& probe, const ProbedState<D>& state, Use&& use) const {
  const ParticleQuantity<D> quantity = particle_quantity<D>(probe.c.quantity);
  const QuantitySource<D> source{state.particles, state.solid, state.record, &state.contacts.forces()};
  constexpr std::size_t together = 128;
  std::array<double, together * ParticleQuantity<D>::most_components> values;
  for (std::size_t begin = 0; begin < probe.slots.size(); begin += together) {
    const std::span some = std::span(probe.slots).subspan(begin, std::min(together, probe.slots.size() - begin));
    quantity.values(source, some, {}, values.data());
    for (std::size_t k = 0; k < some.size(); ++k) {
      const double value = component_of(values.data() + k * quantity.components, quantity.components, probe.component);
      const auto& exact = probe.c.exact;
      use(some[k],
          exact ? value - (*exact)(state.particles.reference(some[k]), state.particles.current(some[k]), state.time) : value);
    }
  }
}

/// Sums block by block: they do not depend on who has which block.
template <int D>
double Probes<D>::over_particles(const Probe& probe, const ProbedState<D>& state) const {
  std::vector<double> sums(2 * state.particles.blocks.size(), 0.0);
  const bool squares = probe.c.reduce == "rms";
  double least = infinity, most = -infinity;
  int block = 0;
  for_each_value(probe, state, [&](int slot, double value) {
    while (slot >= state.particles.blocks[block].end) ++block;
    const double weight = squares ? state.particles.volume[slot] : 1.0;
    sums[2 * block] += squares ? weight * value * value : value;
    sums[2 * block + 1] += weight;
    least = std::min(least, value);
    most = std::max(most, value);
  });
  if (probe.c.reduce == "min") return -state.comm.maximum(-least) + 0.0;  // one zero, whichever came first
  if (probe.c.reduce == "max") return state.comm.maximum(most) + 0.0;
  sums = sum_over_blocks(state.comm, state.particles.block_numbers(), sums, 2);
  if (squares) return std::sqrt(sums[0] / sums[1]);
  return probe.c.reduce == "sum" ? sums[0] : sums[0] / sums[1];
}

template <int D>
double Probes<D>::total(const Probe& probe, const ProbedState<D>& state) const {
  const std::string& name = probe.c.quantity;
  if (name == "time_step") return state.time_step;
  if (name == "reference_updates") return static_cast<double>(state.solid.reference_updates());
  if (name == "contact_depth") {
    double deepest = 0.0;
    for (const ContactSums& sums : state.contacts.sums()) deepest = std::max(deepest, sums.depth);
    return state.comm.maximum(deepest);
  }
  if (name == "linear_momentum") return component_of(state.momenta.linear, probe.component);
  if (name == "angular_momentum") return component_of(state.momenta.angular, probe.component);
  const auto sum_of = [&](const std::vector<Vec<double, D>>& of_blocks) {
    std::vector<double> sums;
    for (const Vec<double, D>& of_block : of_blocks) sums.insert(sums.end(), of_block.c, of_block.c + D);
    sums = sum_over_blocks(state.comm, state.particles.block_numbers(), sums, D);
    Point sum;
    std::copy(sums.begin(), sums.end(), sum.c);
    return component_of(sum, probe.component);
  };
  if (is_of_fragments(name)) {
    const Fragments pieces = find_fragments(state.comm, state.particles, state.solid, *state.record);
    if (name == "fragments") return static_cast<double>(pieces.count);
    return name == "debris" ? pieces.debris : pieces.largest;
  }
  if (name == "reaction_force") return sum_of(state.motion.reactions_on(probe.slots));
  if (name == "wall_force") return sum_of(state.contacts.walls().forces_of(probe.wall));
  return energy_of(name, state.energies);
}

template <int D>
std::vector<double> Probes<D>::values(const ProbedState<D>& state) const {
  std::vector<double> known{state.time};  // t and the probes so far, as the formulas name them
  for (const Probe& probe : probes_) {
    if (!probe.quantity)
      known.push_back(probe.formula.at(known));
    else
      known.push_back(probe.quantity->is_total ? total(probe, state) : over_particles(probe, state));
  }
  return {known.begin() + 1, known.end()};
}

template <int D>
std::vector<std::string> Probes<D>::units() const {
  std::vector<std::string> units;
  for (const Probe& probe : probes_) units.push_back(probe.quantity ? units_.name_of(probe.quantity->unit) : "");
  return units;
}

template class Probes<2>;
template class Probes<3>;

}  // namespace sinew
