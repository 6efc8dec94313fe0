#include <sinew/model/conditions.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace sinew {

namespace {

FieldFunction field_function(const Expression& expression) {
  return {[expression](const Point& X, const Point& x, double t) { return expression(X, x, t); }, expression.depends_on_place(),
          expression.text()};
}

/// The same, in proportion to time where the case says so; see SolverCase::ramp.
FieldFunction load_function(const Case& c, const Expression& expression) {
  FieldFunction function = field_function(expression);
  if (!c.solver.is_static() || !c.solver.ramp || expression.depends_on_time()) return function;
  function.value = [expression, end = c.solver.end_time](const Point& X, const Point& x, double t) {
    return t / end * expression(X, x, t);
  };
  return function;
}

/// CaseError unless the expression is a finite number on all of the particles at time 0.
template <int D>
void check_finite(const Expression& expression, const std::vector<int>& slots, const Particles<D>& particles,
                  const Place& place) {
  for (int slot : slots) {
    const Point X = particles.reference(slot);
    if (!std::isfinite(expression(X, particles.current(slot), 0.0)))
      throw CaseError(place, fmt::format("\"{}\" is not a finite number at X = {:.6g}, Y = {:.6g}, Z = {:.6g}, t = 0",
                                         expression.text(), X[0], X[1], X[2]));
    if (!expression.depends_on_place()) return;
  }
}

template <int D>
void check_values(const BoundaryCase& b, const Regions& regions, const Particles<D>& particles) {
  for (const auto& value : b.value)
    if (value) check_finite(*value, regions.at(b.region).slots, particles, b.place);
}

bool is_motion(BoundaryCase::Kind kind) {
  using Kind = BoundaryCase::Kind;
  return kind == Kind::displacement || kind == Kind::velocity || kind == Kind::wall;
}

/// Unit vector away from the neighbors of a particle.
template <int D>
Vec<double, D> outward_normal(const Particles<D>& particles, const Formulation<D>& solid, int slot) {
  const Vec<double, D> inward = solid.toward_neighbors(particles, slot);
  const double length = norm(inward);
  return length > 0.0 ? (-1.0 / length) * inward : inward;
}

template <int D>
std::vector<double> shares_by_volume(const Region& region, const Particles<D>& particles) {
  std::vector<double> shares;
  for (int slot : region.slots) shares.push_back(particles.volume[slot] / region.volume);
  return shares;
}

template <int D>
std::vector<double> areas(const BoundaryCase& b, const Region& region, const Particles<D>& particles, double thickness) {
  std::vector<double> area = shares_by_volume(region, particles);
  for (std::size_t k = 0; k < area.size(); ++k)
    area[k] = b.area ? *b.area * area[k] : thickness * std::pow(particles.volume[region.slots[k]], (D - 1.0) / D);
  return area;
}

/// Where the particles themselves give the normals of a pressure, those at edges and corners lean outward, and a flat face gets less
/// than p A; say so if any leans more than 25 degrees from the mean.
template <int D>
void warn_of_oblique_normals(const BoundaryCase& b, const Region& region, const Particles<D>& particles,
                             const Formulation<D>& solid, const Comm& comm, std::vector<std::string>& warnings) {
  if (b.normal) return;
  std::vector<double> sums(D * particles.blocks.size(), 0.0);
  for (int slot : region.slots) {
    const Vec<double, D> normal = outward_normal(particles, solid, slot);
    for (int c = 0; c < D; ++c) sums[D * particles.block_of(slot) + c] += normal[c];
  }
  sums = sum_over_blocks(comm, particles.block_numbers(), sums, D);
  Vec<double, D> mean;
  for (int c = 0; c < D; ++c) mean[c] = sums[c];
  const double total = norm(mean);
  long leaning = 0;
  for (int slot : region.slots) leaning += dot(outward_normal(particles, solid, slot), mean) < 0.906 * total;
  leaning = comm.sum(leaning);
  if (leaning > 0)
    warnings.push_back(fmt::format(
        "pressure on region \"{}\": {} of its {} particles, at edges and corners, have normals that lean from the mean one; "
        "on a flat face give normal = [...].",
        b.region, leaning, region.particles));
}

/// A pressure p on an area with outward normal N is the force -p N A; component by component. `on_areas`: the pressure, with the areas as shares.
template <int D>
void add_pressure(const BoundaryCase& b, const LoadCondition& on_areas, const Particles<D>& particles,
                  const Formulation<D>& solid, std::vector<LoadCondition>& loads) {
  for (int c = 0; c < D; ++c) {
    LoadCondition load = on_areas;
    load.component = c;
    for (std::size_t k = 0; k < load.slots.size(); ++k)
      load.share[k] *= -(b.normal ? (*b.normal)[c] / norm(*b.normal) : outward_normal(particles, solid, load.slots[k])[c]);
    loads.push_back(std::move(load));
  }
}

/// The same on the surface as it is deformed.
template <int D>
FollowerCondition<D> follower_pressure(const BoundaryCase& b, const LoadCondition& on_areas, const Particles<D>& particles,
                                       const Formulation<D>& solid) {
  FollowerCondition<D> follower{on_areas.function, {}};
  for (std::size_t k = 0; k < on_areas.slots.size(); ++k) {
    const int slot = on_areas.slots[k];
    Vec<double, D> normal = outward_normal(particles, solid, slot);
    for (int c = 0; c < D && b.normal; ++c) normal[c] = (*b.normal)[c] / norm(*b.normal);
    follower.surfaces.push_back({solid.stencil_of(particles, slot), on_areas.share[k] * normal});
  }
  return follower;
}

/// Whether the body force is not the same everywhere and at all times.
bool is_load(const Case& c) {
  const auto constant = [](const Expression& e) { return e.is_constant(); };
  return c.solver.is_static() || !std::all_of(c.body_force.begin(), c.body_force.end(), constant);
}

/// Mass times acceleration on every particle.
template <int D>
void add_body_force(const Case& case_, const std::vector<int>& slots, const Particles<D>& particles,
                    std::vector<LoadCondition>& loads) {
  for (int c = 0; c < D; ++c) {
    LoadCondition load{c, load_function(case_, case_.body_force[c]), slots, {}};
    for (int slot : slots) load.share.push_back(particles.mass[slot]);
    loads.push_back(std::move(load));
  }
}

/// Value of an expression of [[initial]] at a particle; CaseError unless it is a finite number.
double initial_value(const InitialCase& initial, const Expression& expression, const Point& X) {
  const double value = expression(X, X, 0.0);
  if (!std::isfinite(value))
    throw CaseError(initial.place,
                    fmt::format("initial: \"{}\" gives {} for the particle at ({:.6g}, {:.6g}, {:.6g}), not a finite "
                                "number",
                                expression.text(), value, X[0], X[1], X[2]));
  return value;
}

/// All components of all particles of rigid bodies have to be prescribed, as {slot, component}.
template <int D>
void check_rigid_bodies(const Case& c, const Particles<D>& particles, const std::set<std::pair<int, int>>& prescribed) {
  for (const BlockRange& block : particles.blocks) {
    const BodyCase& body = c.bodies[block.body];
    if (!std::holds_alternative<Rigid>(body.material)) continue;
    for (int slot = block.begin; slot < block.end; ++slot)
      for (int component = 0; component < D; ++component)
        if (!prescribed.contains({slot, component}))
          throw CaseError(
              body.place,
              fmt::format(
                  "body \"{}\" is rigid, but the motion of its particle at ({:.6g}, {:.6g}, {:.6g}) along {} is not prescribed. "
                  "Give a [[boundary]] with velocity or displacement of all components for the whole body.",
                  body.name, particles.reference(slot)[0], particles.reference(slot)[1], particles.reference(slot)[2],
                  "xyz"[component]));
  }
}

}  // namespace

template <int D>
Vec<double, D> constant_body_force(const Case& c) {
  Vec<double, D> gravity;
  for (int i = 0; i < D && !is_load(c); ++i) gravity[i] = c.body_force[i](0.0);
  return gravity;
}

template <int D>
PrescribedMotion<D> make_prescribed_motion(const Case& c, const Regions& regions, const Particles<D>& particles, const Comm& comm,
                                           std::vector<std::string>& warnings) {
  std::vector<MotionCondition> conditions;
  std::set<std::pair<int, int>> taken;  // slot, component
  long shared = 0;
  for (auto b = c.boundary.rbegin(); b != c.boundary.rend(); ++b) {
    if (!is_motion(b->kind)) continue;
    comm.together([&] { check_values(*b, regions, particles); });
    for (int component = 0; component < D; ++component) {
      if (!b->value[component]) continue;
      const bool displacement = b->kind == BoundaryCase::Kind::displacement;
      MotionCondition m{displacement ? MotionCondition::Kind::displacement : MotionCondition::Kind::velocity,
                        component,
                        displacement ? load_function(c, *b->value[component]) : field_function(*b->value[component]),
                        {}};
      for (int slot : regions.at(b->region).slots)
        if (taken.insert({slot, component}).second)
          m.slots.push_back(slot);
        else
          ++shared;
      conditions.push_back(std::move(m));
    }
  }
  comm.together([&] { check_rigid_bodies(c, particles, taken); });
  shared = comm.sum(shared);
  if (shared > 0)
    warnings.push_back(fmt::format(
        "{} components of particles are prescribed by more than one [[boundary]]; the last one in the file holds.", shared));
  return {std::move(conditions), particles};
}

template <int D>
WallTable<D> make_walls(const Case& c, const Regions& regions, const Particles<D>& particles, const Comm& comm) {
  WallTable<D> walls;
  std::vector<int> numbers;
  for (const BoundaryCase& b : c.boundary) {
    if (b.kind != BoundaryCase::Kind::wall) continue;
    WallSurface<D> surface;
    surface.slips = b.normal.has_value();
    for (int i = 0; i < D && b.normal; ++i) surface.normal[i] = (*b.normal)[i] / norm(*b.normal);
    for (const int slot : regions.at(b.region).slots)
      numbers.insert(numbers.end(), {particles.user_index[slot], static_cast<int>(walls.surfaces.size())});
    walls.surfaces.push_back(surface);
  }
  if (walls.empty()) return walls;
  numbers = comm.gather_all(numbers);
  walls.of_number.assign(comm.sum(long{particles.count}), WallTable<D>::none);
  for (std::size_t k = 0; k < numbers.size(); k += 2)
    walls.of_number[numbers[k]] = std::max(walls.of_number[numbers[k]], static_cast<signed char>(numbers[k + 1]));
  walls.gravity = constant_body_force<D>(c);
  return walls;
}

template <int D>
Loads<D> make_loads(const Case& c, const Regions& regions, const Particles<D>& particles, const Formulation<D>& solid,
                    const Comm& comm, std::vector<std::string>& warnings) {
  std::vector<LoadCondition> loads;
  std::vector<FollowerCondition<D>> followers;
  for (const BoundaryCase& b : c.boundary) {
    if (is_motion(b.kind)) continue;
    comm.together([&] { check_values(b, regions, particles); });
    const Region& region = regions.at(b.region);
    const bool force = b.kind == BoundaryCase::Kind::force;
    const std::vector<double> share =
        force ? shares_by_volume(region, particles) : areas(b, region, particles, c.general.thickness);
    if (b.kind == BoundaryCase::Kind::pressure) {
      const LoadCondition on_areas{0, load_function(c, *b.value[0]), region.slots, share};
      if (b.follower)
        followers.push_back(follower_pressure(b, on_areas, particles, solid));
      else
        add_pressure(b, on_areas, particles, solid, loads);
      warn_of_oblique_normals(b, region, particles, solid, comm, warnings);
      continue;
    }
    for (int component = 0; component < D; ++component)
      if (b.value[component]) loads.push_back({component, load_function(c, *b.value[component]), region.slots, share});
  }
  const std::vector<int>& all = regions.at("all").slots;
  comm.together([&] {
    for (const Expression& acceleration : c.body_force) check_finite(acceleration, all, particles, Place{"[body_force]"});
  });
  if (is_load(c)) add_body_force(c, all, particles, loads);
  return {std::move(loads), std::move(followers), particles};
}

template <int D>
void set_initial_state(const Case& c, const Regions& regions, const Comm& comm, Particles<D>& particles) {
  const auto set = [&](const InitialCase& initial) {
    for (int slot : regions.at(initial.region).slots) {
      const Point X = particles.reference(slot);
      for (int i = 0; i < D; ++i) {
        if (initial.stretch) particles.displacement.at(i, slot) = ((*initial.stretch)[i] - 1.0) * X[i];
        if (initial.displacement) particles.displacement.at(i, slot) = initial_value(initial, (*initial.displacement)[i], X);
        if (initial.velocity) particles.velocity.at(i, slot) = initial_value(initial, (*initial.velocity)[i], X);
      }
    }
  };
  for (const InitialCase& initial : c.initial) comm.together([&] { set(initial); });
}

template Vec<double, 2> constant_body_force<2>(const Case&);
template Vec<double, 3> constant_body_force<3>(const Case&);
template PrescribedMotion<2> make_prescribed_motion<2>(const Case&, const Regions&, const Particles<2>&, const Comm&,
                                                       std::vector<std::string>&);
template PrescribedMotion<3> make_prescribed_motion<3>(const Case&, const Regions&, const Particles<3>&, const Comm&,
                                                       std::vector<std::string>&);
template WallTable<2> make_walls<2>(const Case&, const Regions&, const Particles<2>&, const Comm&);
template WallTable<3> make_walls<3>(const Case&, const Regions&, const Particles<3>&, const Comm&);
template Loads<2> make_loads<2>(const Case&, const Regions&, const Particles<2>&, const Formulation<2>&, const Comm&,
                                std::vector<std::string>&);
template Loads<3> make_loads<3>(const Case&, const Regions&, const Particles<3>&, const Formulation<3>&, const Comm&,
                                std::vector<std::string>&);
template void set_initial_state<2>(const Case&, const Regions&, const Comm&, Particles<2>&);
template void set_initial_state<3>(const Case&, const Regions&, const Comm&, Particles<3>&);

}  // namespace sinew
