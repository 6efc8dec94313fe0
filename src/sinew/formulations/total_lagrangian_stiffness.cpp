/// The tangent as matrices of single particles.

#include <sinew/formulations/stencil.hpp>
#include <sinew/formulations/sweep_dispatch.hpp>
#include <sinew/formulations/total_lagrangian.hpp>

#include <cmath>

namespace sinew {

namespace {

/// From the neighbors of a particle to its stencil.
template <int D>
class StencilMaker {
 public:
  using Reach = typename Formulation<D>::Reach;
  StencilMaker(const Particles<D>& particles, const double* radius, const AnyKernel& kernel, const AnyCorrection& correction,
               bool hourglass, Reach reach)
      : particles_(particles),
        radius_(radius),
        kernel_(kernel),
        correction_(correction),
        hourglass_(hourglass),
        reach_(reach) {}

  const Stencil<D>& of(int slot, const std::vector<int>& neighbors) {
    std::visit([&]<class Kernel, class Correction>(const Kernel&,
                                                   const Correction& correction) { make<Kernel>(slot, neighbors, correction); },
               kernel_, correction_);
    return stencil_;
  }

 private:
  /// Moments of that roundness are enough for a gradient; a plane surface of a lattice has 0.5 and more.
  static constexpr double round_enough = 0.3;
  /// Of the nearest neighbors: the first multiple of V^(1/D) tried as their distance, and how it grows.
  static constexpr double first_distance = 1.3, growth = 1.2;

  struct Weights {
    double a, W;  ///< V_j |dW/dr| / r, V_j W
  };

  template <class Kernel, class Correction>
  void make(int slot, const std::vector<int>& neighbors, const Correction& correction) {
    const double infinite = std::numeric_limits<double>::infinity();
    double distance = reach_ == Reach::all ? infinite : first_distance * std::pow(particles_.volume[slot], 1.0 / D);
    for (;; distance *= growth) {
      const bool all = collect<Kernel>(slot, neighbors, distance);
      if (all || (roundness(moments_.first) > round_enough && stencil_.size() > D)) break;
    }
    weigh(correction.map(moments_));
  }

  /// Those that are not farther away than `distance`. Returns whether these are all.
  template <class Kernel>
  bool collect(int slot, const std::vector<int>& neighbors, double distance) {
    const double R = radius_[slot], own = particles_.volume[slot] * Kernel::template value<D>(0.0, R);
    stencil_.clear();
    weights_.clear();
    moments_ = {};
    moments_.shepard_sum = own;
    stencil_.slots.push_back(slot);
    stencil_.X.push_back({});
    weights_.push_back({0.0, own});
    for (const int j : neighbors) {
      Vec<double, D> X;
      for (int c = 0; c < D; ++c) X[c] = particles_.position.at(c, j) - particles_.position.at(c, slot);
      const double r = std::sqrt(dot(X, X));
      if (r > distance) continue;
      const double V = particles_.volume[j];
      add(j, X, {-V * Kernel::template slope<D>(r, R) / r, V * Kernel::template value<D>(r, R)});
    }
    return stencil_.slots.size() == neighbors.size() + 1;
  }

  void add(int slot, const Vec<double, D>& X, const Weights& w) {
    stencil_.slots.push_back(slot);
    stencil_.X.push_back(X);
    weights_.push_back(w);
    moments_.shepard_sum += w.W;
    moments_.gradient_sum += w.a * X;
    moments_.first += outer(w.a * X, X);
    moments_.kernel_first += w.W * X;
    moments_.kernel_second += outer(w.W * X, X);
    for (int g = 0; g < D; ++g) moments_.second[g] += outer((w.a * X[g]) * X, X);
  }

  void weigh(const GradientMap<D>& map) {
    Vec<double, D> own{};
    const double squares = trace(moments_.first);
    for (int n = 0; n < stencil_.size(); ++n) {
      stencil_.gradient.push_back(n == 0 ? own : map.apply(weights_[n].a, weights_[n].W, stencil_.X[n]));
      stencil_.gradient[0] -= n == 0 ? own : stencil_.gradient[n];
      if (hourglass_) stencil_.hourglass.push_back(squares > 0.0 ? weights_[n].a / squares : 0.0);
    }
  }

  const Particles<D>& particles_;
  const double* radius_;
  const AnyKernel& kernel_;
  const AnyCorrection& correction_;
  bool hourglass_;
  Reach reach_;
  Stencil<D> stencil_;
  std::vector<Weights> weights_;
  Moments<D> moments_;
};

/// Calls use(slot, its neighbors) for all particles of a block that have any.
template <int D, class Use>
void for_each_neighborhood(const BlockPairs<D>& pairs, const Block& block, Use&& use) {
  int current = -1;
  std::vector<int> neighbors;
  pairs.for_each_pair(block, [&](int i, int j) {
    if (i != current) {
      if (current >= 0) use(current, neighbors);
      current = i;
      neighbors.clear();
    }
    neighbors.push_back(j);
  });
  if (current >= 0) use(current, neighbors);
}

/// Of the particles of a block.
template <int D>
struct BlockTangents {
  std::vector<Mat<double, D * D>> A;
  std::vector<double> hourglass_modulus;
};

template <int D>
BlockTangents<D> tangents_of(const SweepTask<D>& task, const TangentPoint<D>& tangent) {
  const Block& block = task.block;
  BlockTangents<D> all;
  all.A.resize(block.end - block.begin);
  all.hourglass_modulus.resize(all.A.size());
  const int* slots = task.source.pairs.blocks.slots_of(block);
  PointTangent<D> eight;
  for (int slice = block.first_slice; slice < block.end_slice; ++slice) {
    const SliceSlots<D> at(task.source.pairs, block, slice);
    const SliceHistory<D> history{task.history, at, task.step, task.weights.radius.data()};
    tangent(Mat<Pack, D>::identity() + at.load_matrix(*task.linear.gradient), &history, eight);
    for (int k = 0; k < lanes; ++k) {
      const int slot = slots[task.source.pairs.blocks.place_of_slice[slice] + k];
      if (!block.owns(slot)) continue;
      for (int row = 0; row < D * D; ++row)
        for (int column = 0; column < D * D; ++column) all.A[slot - block.begin][row][column] = eight.A[row][column][k];
      all.hourglass_modulus[slot - block.begin] = eight.hourglass_modulus[k];
    }
  }
  return all;
}

}  // namespace

template <int D>
void TotalLagrangian<D>::for_each_stencil(const Particles<D>& particles, Reach reach, UseStencil use) const {
  StencilMaker<D> maker(particles, weights_.radius.data(), options_.kernel, options_.correction, false, reach);
  for (const Block& block : pairs_.blocks.all)
    for_each_neighborhood(pairs_, block,
                          [&](int slot, const std::vector<int>& neighbors) { use(maker.of(slot, neighbors).slots); });
}

template <int D>
Stencil<D> TotalLagrangian<D>::stencil_of(const Particles<D>& particles, int slot) const {
  StencilMaker<D> maker(particles, weights_.radius.data(), options_.kernel, options_.correction, false, Reach::all);
  return maker.of(slot, pairs_.neighbors(slot, particles));
}

template <int D>
void TotalLagrangian<D>::for_each_stiffness(const Particles<D>& particles, Reach reach, PointStep step, UseStiffness use) {
  const PairSource<D> source{particles, pairs_};
  const WeightOptions weights = weight_options();
  prepare_scratch();
  StencilMaker<D> maker(particles, weights_.radius.data(), options_.kernel, options_.correction, options_.hourglass.has_value(),
                        reach);
  NodalStiffness<D> nodal;
  for (int index = 0; index < pairs_.blocks.count(); ++index) {
    const Block& block = pairs_.blocks.all[index];
    const SweepTask<D> task = task_of(index, source, weights, step, nullptr);
    const BlockTangents<D> tangents = tangents_of(task, tangent_point<D>(options_.materials[block.body], options_.plane_stress));
    for_each_neighborhood(pairs_, block, [&](int slot, const std::vector<int>& neighbors) {
      const double volume = particles.volume[slot] * options_.thickness;
      const double modulus = task.fixed_modulus > 0.0 ? task.fixed_modulus : tangents.hourglass_modulus[slot - block.begin];
      const Stencil<D>& stencil = maker.of(slot, neighbors);
      use(stencil.slots, nodal.of(stencil, tangents.A[slot - block.begin], volume, volume * task.hourglass * modulus));
    });
  }
}

#define SINEW_INSTANTIATE(D)                                                                        \
  template void TotalLagrangian<D>::for_each_stencil(const Particles<D>&, Reach, UseStencil) const; \
  template Stencil<D> TotalLagrangian<D>::stencil_of(const Particles<D>&, int) const;               \
  template void TotalLagrangian<D>::for_each_stiffness(const Particles<D>&, Reach, PointStep, UseStiffness);
SINEW_INSTANTIATE(2)
SINEW_INSTANTIATE(3)

}  // namespace sinew
