#include <sinew/model/regions.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sinew {

namespace {

/// Numbers of one body's particles in the user's order.
struct NamedRange {
  std::string name;
  int first, count;
};

template <int D>
std::vector<NamedRange> user_ranges(const Arrangement<D>& particles) {
  std::vector<NamedRange> ranges;
  int first = 0;
  for (const BodyRange& body : particles.bodies) {
    ranges.push_back({body.name, first, body.count});
    first += body.count;
  }
  return ranges;
}

bool inside(const std::array<Point, 2>& box, const Point& X, int dimension) {
  for (int c = 0; c < dimension; ++c)
    if (X[c] < box[0][c] || X[c] > box[1][c]) return false;
  return true;
}

bool satisfies(const RegionCase& region, const Point& X, int dimension) {
  if (region.box && !inside(*region.box, X, dimension)) return false;
  if (!region.where) return true;
  const double holds = (*region.where)(X, X, 0.0);
  if (std::isnan(holds))
    throw CaseError(region.place, fmt::format("region \"{}\": where gives no number at ({:.6g}, {:.6g}, {:.6g})", region.name,
                                              X[0], X[1], X[2]));
  return holds != 0.0;
}

template <int D>
[[noreturn]] void selects_nothing(const RegionCase& region, const Arrangement<D>& particles) {
  Point low, high;
  for (int c = 0; c < D; ++c) low[c] = std::numeric_limits<double>::infinity(), high[c] = -low[c];
  for (int slot : particles.slot_of)
    for (int c = 0; c < D; ++c) {
      low[c] = std::min(low[c], particles.reference(slot)[c]);
      high[c] = std::max(high[c], particles.reference(slot)[c]);
    }
  std::string extent;
  for (int c = 0; c < D; ++c) extent += fmt::format("{}{} from {:.6g} to {:.6g}", c ? ", " : "", "XYZ"[c], low[c], high[c]);
  throw CaseError(
      region.place,
      fmt::format("region \"{}\" selects no particle. Particles have {} (a particle stands in the middle of its cell, half a "
                  "spacing inside the surface).",
                  region.name, extent));
}

/// Of the candidates the one nearest to the point; the first of several at the same distance.
template <int D>
int nearest_of(const std::vector<int>& candidates, const Point& target, const Arrangement<D>& particles) {
  int best = candidates.front();
  double least = std::numeric_limits<double>::infinity();
  for (int slot : candidates) {
    const Point d = particles.reference(slot) - target;
    if (dot(d, d) < least * (1.0 - 1e-12)) {
      least = dot(d, d);
      best = slot;
    }
  }
  return best;
}

template <int D>
std::vector<int> select(const RegionCase& region, const Case& c, const std::vector<GeneratedBody>& bodies,
                        const Arrangement<D>& particles) {
  std::vector<int> found;
  const std::vector<NamedRange> ranges = user_ranges(particles);
  for (std::size_t b = 0; b < ranges.size(); ++b) {
    if (!region.body.empty() && ranges[b].name != region.body) continue;
    std::vector<char> in_set(ranges[b].count, region.set.empty());
    if (!region.set.empty()) {
      const auto set = bodies[b].points.sets.find(region.set);
      if (set == bodies[b].points.sets.end()) continue;
      for (int i : set->second) in_set[i] = 1;
    }
    for (int i = 0; i < ranges[b].count; ++i) {
      const int slot = particles.slot_of[ranges[b].first + i];
      if (in_set[i] && satisfies(region, particles.reference(slot), c.general.dimension)) found.push_back(slot);
    }
  }
  if (found.empty()) selects_nothing(region, particles);
  if (region.nearest) found = {nearest_of(found, *region.nearest, particles)};
  std::sort(found.begin(), found.end());  // as they lie in memory
  return found;
}

void check_set_name(const RegionCase& region, const Case& c, const std::vector<GeneratedBody>& bodies) {
  if (region.set.empty()) return;
  std::vector<std::string> known;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (region.body.empty() || c.bodies[b].name == region.body)
      for (const auto& [name, points] : bodies[b].points.sets) known.push_back(name);
  if (std::find(known.begin(), known.end(), region.set) == known.end())
    throw CaseError(region.place, "region \"" + region.name + "\": " + unknown_name_message("mesh set", region.set, known));
}

}  // namespace

template <int D>
Regions select_regions(const Case& c, const std::vector<GeneratedBody>& bodies, const Arrangement<D>& all) {
  Regions regions;
  for (const auto& [name, region] : c.regions) {
    check_set_name(region, c, bodies);
    Region& selected = regions[name];
    selected.slots = select(region, c, bodies, all);
    selected.particles = static_cast<long>(selected.slots.size());
    for (int slot : selected.slots) selected.volume += all.volume[slot];
  }
  return regions;
}

void keep_own(Regions& regions, const Share& share) {
  for (auto& [name, region] : regions) {
    std::vector<int> own;
    for (int slot : region.slots)
      if (const int here = share.local_of[slot]; here != Blocks::nobody && here < share.slots) own.push_back(here);
    region.slots = std::move(own);
  }
}

template Regions select_regions<2>(const Case&, const std::vector<GeneratedBody>&, const Arrangement<2>&);
template Regions select_regions<3>(const Case&, const std::vector<GeneratedBody>&, const Arrangement<3>&);

}  // namespace sinew
