#include <sinew/formulations/wall_particles.hpp>

namespace sinew {

template <int D>
WallParticles<D>::WallParticles(WallTable<D> table) : table_(std::move(table)) {
  for (const WallSurface<D>& surface : table_.surfaces)
    if (surface.slips) slipping_.push_back({{}, surface.normal});
}

template <int D>
void WallParticles<D>::find_pairs(const MovingNeighbors<D>& neighbors, std::span<const int> numbers) {
  walls_.clear();
  sources_.clear();
  for (int s = 0; s < neighbors.slices(); ++s) {
    const MovingSlice slice = neighbors.slice(s);
    for (int k = 0; k < lanes; ++k) {
      if (slice.own[k] == neighbors.nobody()) continue;
      const int slot = neighbors.point_at(slice.own[k] / lanes);
      if (!table_.is_wall(numbers[slot])) continue;
      walls_.push_back(slot);
      for (int n = 0; n < slice.length; ++n) {
        const int offset = slice.places[lanes * n + k];
        if (offset == neighbors.nobody()) continue;
        const int point = neighbors.point_at(offset / lanes);
        if (!table_.is_wall(numbers[point])) sources_.push_back({slot, point});
      }
    }
  }
  std::size_t smooth = 0;
  for (std::size_t c = 0; c < table_.surfaces.size(); ++c)
    if (table_.surfaces[c].slips)
      slipping_[smooth++].pairs.take_part(neighbors, [&](int point, int other) {
        const auto surface = static_cast<signed char>(c);
        const signed char here = table_.of_number[numbers[point]], there = table_.of_number[numbers[other]];
        return (here == surface && there == WallTable<D>::none) || (here == WallTable<D>::none && there == surface);
      });
}

namespace {

template <int D>
Vec<double, D> place_of(const MovingPoints<D>& points, int point) {
  Vec<double, D> x;
  for (int c = 0; c < D; ++c) x[c] = points.motion.at(c, point);
  return x;
}

template <int D>
double specific_volume(const MovingPoints<D>& points, int point) {
  return points.motion.at(2 * D, point);
}

template <int D>
Mat<double, D> stress_of(const MovingPoints<D>& points, const VectorField<D * D + 1>& stress, int point) {
  const double volume = specific_volume(points, point);
  Mat<double, D> sigma;
  for (int c = 0; c < D * D; ++c) sigma[c / D][c % D] = stress.at(c, point) / (volume * volume);
  return sigma;
}

/// Without shear across the normal.
template <int D>
Mat<double, D> smooth(const Mat<double, D>& sigma, const Vec<double, D>& normal) {
  const Vec<double, D> traction = sigma * normal, shear = traction - dot(traction, normal) * normal;
  return sigma - (outer(shear, normal) + outer(normal, shear));
}

}  // namespace

template <int D>
void WallParticles<D>::extrapolate(const MovingPoints<D>& points, VectorField<D * D + 1>& stress) const {
  for (const int slot : walls_)
    for (int c = 0; c < D * D; ++c) stress.at(c, slot) = 0.0;
  for (std::size_t begin = 0, end; begin < sources_.size(); begin = end) {
    const int slot = sources_[begin].slot;
    Mat<double, D> sum;
    double weights = 0.0;
    for (end = begin; end < sources_.size() && sources_[end].slot == slot; ++end) {
      const int point = sources_[end].point;
      const Vec<double, D> x = place_of(points, slot) - place_of(points, point);
      const double r = norm(x);
      if (r >= points.radius) continue;
      const double volume = specific_volume(points, point), V = points.mass[point] * volume;
      const double W =
          V * std::visit([&](const auto& kernel) { return kernel.template value<D>(r, points.radius); }, points.kernel);
      Mat<double, D> sigma = stress_of(points, stress, point);
      for (int a = 0; a < D; ++a) sigma[a][a] -= table_.gravity[a] * x[a] / volume;
      sum += W * sigma;
      weights += W;
    }
    if (weights == 0.0) continue;
    const WallSurface<D>& surface = table_.of(points.numbers[slot]);
    sum = (1.0 / weights) * sum;
    if (surface.slips) sum = smooth(sum, surface.normal);
    const double volume = specific_volume(points, slot);
    for (int c = 0; c < D * D; ++c) stress.at(c, slot) = volume * volume * sum[c / D][c % D];
  }
}

template class WallParticles<2>;
template class WallParticles<3>;

}  // namespace sinew
