#include <sinew/core/error.hpp>
#include <sinew/neighbors/cell_list.hpp>
#include <sinew/neighbors/pair_list.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {

namespace {

template <int D>
std::vector<Point> reference_points(const Particles<D>& particles, const BodyRange& body) {
  std::vector<Point> points(body.count);
  for (int i = 0; i < body.count; ++i) points[i] = particles.reference(body.begin + i);
  return points;
}

double largest_radius(const std::vector<double>& radius, const BodyRange& body) {
  return *std::max_element(radius.begin() + body.begin, radius.begin() + body.begin + body.count);
}

/// Calls use(slot, sorted neighbors) for every particle of the body, in parallel over slices.
template <class Use>
void for_each_row(const std::vector<Point>& points, const BodyRange& body, const std::vector<double>& radius,
                  const CellList& cells, Use&& use) {
#pragma omp parallel
  {
    std::vector<int> found;
#pragma omp for schedule(dynamic, 64)
    for (int i = 0; i < body.count; ++i) {
      found.clear();
      cells.for_each_within(points[i], radius[body.begin + i], [&](int j, double) {
        if (j != i) found.push_back(body.begin + j);
      });
      std::sort(found.begin(), found.end());
      use(body.begin + i, found);
    }
  }
}

}  // namespace

template <int D>
PairList build_pair_list(const Particles<D>& particles, const std::vector<double>& support_radius) {
  PairList list;
  const int slices = particles.slots / lanes;
  list.neighbor_count.assign(particles.slots, 0);
  std::vector<CellList> cells;
  std::vector<std::vector<Point>> points;
  for (const BodyRange& body : particles.bodies) {
    points.push_back(reference_points(particles, body));
    cells.emplace_back(points.back(), largest_radius(support_radius, body));
    for_each_row(points.back(), body, support_radius, cells.back(),
                 [&](int slot, const std::vector<int>& found) { list.neighbor_count[slot] = static_cast<int>(found.size()); });
  }

  list.first_entry.assign(slices + 1, 0);
  for (int s = 0; s < slices; ++s) {
    const auto* counts = list.neighbor_count.data() + lanes * s;
    list.first_entry[s + 1] = list.first_entry[s] + *std::max_element(counts, counts + lanes);
    for (int k = 0; k < lanes; ++k) list.pairs += counts[k];
  }
  list.neighbor = AlignedArray<int>(list.entries() * lanes);
  for (int s = 0; s < slices; ++s)
    for (std::size_t e = list.first_entry[s]; e < list.first_entry[s + 1]; ++e)
      for (int k = 0; k < lanes; ++k) list.neighbor[lanes * e + k] = lanes * s + k;
  for (std::size_t b = 0; b < cells.size(); ++b)
    for_each_row(points[b], particles.bodies[b], support_radius, cells[b], [&](int slot, const std::vector<int>& found) {
      std::size_t e = list.first_entry[slot / lanes];
      for (int j : found) list.neighbor[lanes * e++ + slot % lanes] = j;
    });
  return list;
}

template <int D>
std::vector<double> radius_of_neighbors(const Particles<D>& particles, double neighbors) {
  std::vector<double> radius(particles.slots, 0.0);
  const int wanted = static_cast<int>(std::lround(neighbors));
  for (const BodyRange& body : particles.bodies) {
    if (body.count < wanted + 2)
      throw CaseError("body \"" + body.name + "\" has " + std::to_string(body.count) + " particles, too few for neighbors = " +
                      std::to_string(wanted) + " around each. Make its spacing smaller or ask for fewer neighbors.");
    const std::vector<Point> points = reference_points(particles, body);
    const CellList cells(points, 2.0 * body.spacing);
    const double guess = body.spacing * (D == 3 ? std::cbrt(neighbors) : std::sqrt(neighbors));
#pragma omp parallel
    {
      std::vector<double> distances;
#pragma omp for schedule(dynamic, 64)
      for (int i = 0; i < body.count; ++i) {
        for (double search = guess;; search *= 1.5) {
          distances.clear();
          cells.for_each_within(points[i], search, [&](int j, double r2) {
            if (j != i) distances.push_back(r2);
          });
          if (static_cast<int>(distances.size()) > wanted) break;
        }
        std::nth_element(distances.begin(), distances.begin() + wanted, distances.end());
        const double outside = distances[wanted];
        const double inside = *std::max_element(distances.begin(), distances.begin() + wanted);
        radius[body.begin + i] = std::pow(0.5 * (std::pow(inside, 0.5 * D) + std::pow(outside, 0.5 * D)), 1.0 / D);
      }
    }
  }
  return radius;
}

int reach(const PairList& list, int begin, int end) {
  int most = 0;
  for (int s = begin / lanes; s < end / lanes; ++s)
    for (std::size_t e = list.first_entry[s]; e < list.first_entry[s + 1]; ++e)
      for (int k = 0; k < lanes; ++k) most = std::max(most, std::abs(list.entry(e)[k] - (lanes * s + k)));
  return most;
}

template PairList build_pair_list<2>(const Particles<2>&, const std::vector<double>&);
template PairList build_pair_list<3>(const Particles<3>&, const std::vector<double>&);
template std::vector<double> radius_of_neighbors<2>(const Particles<2>&, double);
template std::vector<double> radius_of_neighbors<3>(const Particles<3>&, double);

}  // namespace sinew
