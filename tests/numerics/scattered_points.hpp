#pragma once
/// Points of all kinds of places: dense and sparse, far from one another, at one place, on a line.

#include <cmath>
#include <functional>
#include <random>
#include <sinew/particles/generate/point_set.hpp>

namespace sinew::testing {

using Random = std::mt19937_64;

inline PointSet points_at(std::vector<Point> positions) {
  PointSet points;
  points.volume.assign(positions.size(), 1.0);
  points.position = std::move(positions);
  points.spacing = 1.0;
  return points;
}

/// Calls place() for each coordinate of `count` points.
template <int D, class Place>
std::vector<Point> scattered(int count, Place&& place) {
  std::vector<Point> points(count);
  for (Point& p : points)
    for (int c = 0; c < D; ++c) p[c] = place(c);
  return points;
}

template <int D>
std::vector<Point> in_box(int count, const Point& size, Random& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  return scattered<D>(count, [&](int c) { return size[c] * unit(random); });
}

/// Dense clusters, some of them far away, and isolated points between and beyond them.
template <int D>
std::vector<Point> clusters(Random& random) {
  std::normal_distribution<double> near(0.0, 1.5);
  std::vector<Point> points = in_box<D>(60, {{300.0, 200.0, 100.0}}, random);
  for (const Point& center : {Point{{0, 0, 0}}, Point{{40, 30, 20}}, Point{{-2e3, 5e3, 10}}, Point{{1e9, 0, 0}}})
    for (Point p : scattered<D>(150, [&](int) { return near(random); })) {
      for (int c = 0; c < D; ++c) p[c] += center[c];
      points.push_back(p);
    }
  return points;
}

/// Whole coordinates in a small box: many points with the same coordinate along their row, and some at one place.
template <int D>
std::vector<Point> coincident(Random& random) {
  std::vector<Point> points = in_box<D>(500, {{9.0, 8.0, 7.0}}, random);
  for (Point& p : points)
    for (int c = 0; c < D; ++c) p[c] = std::floor(p[c]);
  return points;
}

/// Calls check(name, points) for clouds of all kinds.
template <int D>
void for_each_cloud(const std::function<void(const std::string& name, const std::vector<Point>&)>& check) {
  Random random(31);
  check("clusters", clusters<D>(random));
  check("coincident", coincident<D>(random));
  check("compact", in_box<D>(700, D == 3 ? Point{{9, 10, 8}} : Point{{30, 25, 0}}, random));
  check("sparse", in_box<D>(300, {{60, 50, 40}}, random));
  check("long", in_box<D>(400, {{2, 300, 1.5}}, random));
  check("line", in_box<D>(200, {{0, 150, 0}}, random));
  if constexpr (D == 3) check("flat", in_box<D>(600, {{0.3, 25, 30}}, random));
  check("one", in_box<D>(1, {{1, 1, 1}}, random));
}

}  // namespace sinew::testing
