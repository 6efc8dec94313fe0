#include <sinew/core/error.hpp>
#include <sinew/formulations/pair_weights.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sinew {

namespace {

template <int D>
Vec<double, D> reference_of(const Particles<D>& particles, int slot) {
  Vec<double, D> X;
  for (int c = 0; c < D; ++c) X[c] = particles.place_row(slot)[vector_width<D> + c];
  return X;
}

/// One particle and where its neighbors are listed.
template <int D>
struct Row {
  const Particles<D>& particles;
  const PairList& list;
  int slot;
  double radius;  ///< of its support
};

/// Everything that the neighbors of one particle say about it.
template <int D>
struct RowSums {
  Moments<D> moments;
  double nearest = infinity;
};

/// Calls use(place in the arrays, j, X_ij, r) for the neighbors of one particle.
template <int D, class Use>
void for_each_neighbor(const Row<D>& row, Use&& use) {
  const Vec<double, D> own = reference_of(row.particles, row.slot);
  const std::size_t first = row.list.first_entry[row.slot / lanes];
  for (int n = 0; n < row.list.neighbor_count[row.slot]; ++n) {
    const std::size_t at = lanes * (first + n) + row.slot % lanes;
    const Vec<double, D> X = reference_of(row.particles, row.list.neighbor[at]) - own;
    use(at, row.list.neighbor[at], X, norm(X));
  }
}

template <int D, class Kernel>
RowSums<D> row_sums(const Row<D>& row) {
  RowSums<D> sums;
  sums.moments.shepard_sum = row.particles.volume[row.slot] * Kernel::template value<D>(0.0, row.radius);
  for_each_neighbor(row, [&](std::size_t, int j, const Vec<double, D>& X, double r) {
    const double V = row.particles.volume[j], W = Kernel::template value<D>(r, row.radius);
    const Vec<double, D> base = (-V * Kernel::template slope<D>(r, row.radius) / r) * X;
    sums.moments.shepard_sum += V * W;
    sums.moments.gradient_sum += base;
    sums.moments.first += outer(X, base);
    sums.nearest = std::min(sums.nearest, r);
  });
  return sums;
}

template <int D>
[[noreturn]] void too_few_neighbors(const Particles<D>& particles, const PairList& list, int slot,
                                    const std::string& correction) {
  const Point X = particles.reference(slot);
  char place[96];
  std::snprintf(place, sizeof place, "(%.6g, %.6g, %.6g)", X[0], X[1], X[2]);
  throw CaseError(
      "body \"" + particles.bodies[particles.body_of(slot)].name + "\": particle " + std::to_string(particles.user_index[slot]) +
      " at " + place + " has " + std::to_string(list.neighbor_count[slot]) +
      " neighbors, too few (or all in one line) to correct its gradient. Make [formulation] support larger or spacing smaller, "
      "fill the shape there, or choose another correction than \"" +
      correction + "\".");
}

/// Writes the weights of the pairs of one particle and returns the sum of the hourglass weights. `scale`: of a_ij in the hourglass weight;
/// 0 for the central form, which uses W_ij.
template <int D, class Kernel, class Correction>
double fill_row(const Row<D>& row, const GradientMap<D>& map, double scale, PairWeights<D>& w) {
  double sum = 0.0;
  for_each_neighbor(row, [&](std::size_t at, int j, const Vec<double, D>& X, double r) {
    const double V = row.particles.volume[j], W = Kernel::template value<D>(r, row.radius);
    const double a = -Kernel::template slope<D>(r, row.radius) / r;
    w.stiffness[at] = scale > 0.0 ? V * a * scale : V * W / (r * r);
    sum += w.stiffness[at];
    if constexpr (Correction::radial) {
      w.gradient[at] = V * map.scale * a;
    } else {
      const Vec<double, D> g = V * map.apply(a, W, X);
      for (int c = 0; c < D; ++c) w.gradient[lanes * (at / lanes * D + c) + at % lanes] = g[c];
    }
  });
  return sum;
}

template <int D>
void store_correction(const Mat<double, D>& L, int slot, PairWeights<D>& w) {
  double* first = w.correction.data() + std::size_t(lanes) * symmetric_size<D> * (slot / lanes) + slot % lanes;
  for (int i = 0, c = 0; i < D; ++i)
    for (int j = i; j < D; ++j, ++c) first[lanes * c] = L[i][j];
}

}  // namespace

template <int D>
PairWeights<D> make_pair_weights(const Particles<D>& particles, const PairList& list, const std::vector<double>& support_radius,
                                 const AnyKernel& kernel, const AnyCorrection& correction, HourglassWeight hourglass) {
  PairWeights<D> w;
  w.radial = std::visit([](const auto& c) { return c.radial; }, correction);
  w.gradient = AlignedArray<double>(list.entries() * lanes * (w.radial ? 1 : D));
  w.stiffness = AlignedArray<double>(list.entries() * lanes);
  w.correction = AlignedArray<double>(std::size_t(particles.slots) * symmetric_size<D>);
  w.inverse_length2 = AlignedArray<double>(particles.slots);
  w.stiffness_sum = AlignedArray<double>(particles.slots);
  int bad = particles.slots;
  std::visit(
      [&]<class Kernel, class Correction>(const Kernel&, const Correction& c) {
#pragma omp parallel for schedule(dynamic, 256) reduction(min : bad)
        for (int slot = 0; slot < particles.slots; ++slot) {
          if (particles.user_index[slot] < 0) continue;
          const Row<D> row{particles, list, slot, support_radius[slot]};
          const RowSums<D> sums = row_sums<D, Kernel>(row);
          const GradientMap<D> map = c.map(sums.moments);
          if (!map.valid) bad = std::min(bad, slot);
          store_correction(map.L, slot, w);
          const double second_moment = trace(sums.moments.first);
          const double scale = hourglass == HourglassWeight::conservative && second_moment > 0.0 ? 1.0 / second_moment : 0.0;
          w.stiffness_sum[slot] = fill_row<D, Kernel, Correction>(row, map, scale, w);
          const double length = std::min(sums.nearest, std::pow(particles.volume[slot], 1.0 / D));
          w.inverse_length2[slot] = 1.0 / (length * length);
        }
      },
      kernel, correction);
  if (bad < particles.slots)
    too_few_neighbors(particles, list, bad, std::visit([](const auto& c) { return std::string(c.name); }, correction));
  return w;
}

template PairWeights<2> make_pair_weights<2>(const Particles<2>&, const PairList&, const std::vector<double>&, const AnyKernel&,
                                             const AnyCorrection&, HourglassWeight);
template PairWeights<3> make_pair_weights<3>(const Particles<3>&, const PairList&, const std::vector<double>&, const AnyKernel&,
                                             const AnyCorrection&, HourglassWeight);

}  // namespace sinew
