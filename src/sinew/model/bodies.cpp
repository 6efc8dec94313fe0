#include <sinew/model/bodies.hpp>
#include <sinew/neighbors/cell_list.hpp>
#include <sinew/particles/generate/mean_spacing.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace sinew {

namespace {

/// Bytes that a run will need for one particle: state, and one index and two weights a pair.
double bytes_per_particle(const Case& c) {
  const int d = c.general.dimension;
  const double support = c.formulation.support.value_or(FormulationCase::default_support);
  const double ball = d == 3 ? 4.0 / 3.0 * std::numbers::pi * std::pow(support, 3) : std::numbers::pi * support * support;
  const double neighbors = c.formulation.neighbors.value_or(ball);
  const double doubles_a_pair = std::visit([](const auto& k) { return k.radial; }, c.formulation.correction) ? 2.0 : 1.0 + d;
  return 600.0 + neighbors * (4.0 + 8.0 * doubles_a_pair);
}

/// What all ranks of a machine need for one particle of the case. Each sets up the whole before it keeps its share.
double bytes_on_machine(const Case& c, const Comm& comm) {
  constexpr double set_up = 200.0;
  if (comm.alone()) return bytes_per_particle(c);
  return comm.node_size() * (set_up + bytes_per_particle(c) / comm.size());
}

constexpr double memory_share = 0.9;  // of the machine's memory; the system needs the rest

/// Points of a file may repeat; two at one place have no distance to weigh.
void check_coincidence(const BodyCase& c, const GeneratedBody& body) {
  const std::vector<Point>& points = body.points.position;
  const CellList cells(points, body.spacing);
  for (std::size_t i = 0; i < points.size(); ++i)
    cells.for_each_within(points[i], 1e-6 * body.spacing, [&](int j, double) {
      if (static_cast<std::size_t>(j) != i)
        throw CaseError(c.geometry_place, fmt::format("body \"{}\": points {} and {} (counted from 0) are at the same place, "
                                                      "({:.6g}, {:.6g}, {:.6g}). Remove one of them.",
                                                      c.name, i, j, points[i][0], points[i][1], points[i][2]));
    });
}

/// A body closer to another one than half a spacing counts as overlapping.
void check_overlap(const Case& c, const std::vector<GeneratedBody>& bodies) {
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    const CellList cells(bodies[a].points.position, bodies[a].spacing);
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      const double limit = 0.5 * std::min(bodies[a].spacing, bodies[b].spacing);
      for (const Point& p : bodies[b].points.position)
        cells.for_each_within(p, limit, [&](int, double r2) {
          throw CaseError(
              c.bodies[b].place,
              fmt::format("body \"{}\" overlaps body \"{}\" at ({:.6g}, {:.6g}, {:.6g}), where two of their particles "
                          "are only {:.3g} apart. Move them apart, or make one body of the two.",
                          c.bodies[b].name, c.bodies[a].name, p[0], p[1], p[2], std::sqrt(r2)));
        });
    }
  }
}

}  // namespace

double machine_memory() {
  double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  std::ifstream limit("/sys/fs/cgroup/memory.max");
  double container = 0.0;
  if (limit >> container && container > 0.0) bytes = std::min(bytes, container);
  return bytes;
}

std::vector<GeneratedBody> generate_bodies(const Case& c, const Comm& comm) {
  std::vector<GeneratedBody> bodies;
  double particles = 0.0;
  for (const BodyCase& body : c.bodies) {
    const double most = std::min(2e9, memory_share * machine_memory() / bytes_on_machine(c, comm) - particles);
    const GenerateOptions options{c.general.dimension, c.folder, body.geometry_place, most};
    GeneratedBody made{std::visit([&](const auto& g) { return g.generate(options); }, body.geometry), 0.0};
    if (made.points.size() == 0)
      throw CaseError(body.geometry_place,
                      fmt::format("body \"{}\" has no particles. Make its spacing smaller than its shape.", body.name));
    made.spacing = mean_spacing(made.points, c.general.dimension);
    particles += static_cast<double>(made.points.size());
    if (made.points.spacing == 0.0) check_coincidence(body, made);
    bodies.push_back(std::move(made));
  }
  check_overlap(c, bodies);
  return bodies;
}

}  // namespace sinew
