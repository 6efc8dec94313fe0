/// Sweeps before and after the one over the materials, for methods that need gradients, Laplacians or stresses of neighbors. All pairs are listed, with vectors (but for Laplacians).

#include <sinew/formulations/bond_sums.hpp>
#include <sinew/formulations/pair_force.hpp>
#include <sinew/formulations/slice_slots.hpp>
#include <sinew/formulations/sweep_dispatch.hpp>
#include <sinew/formulations/weight_source.hpp>
#include <sinew/neighbors/listed_pairs.hpp>

namespace sinew {

namespace {

/// Calls use(pairs, slice, its slots) for all slices of a block.
template <int D, class Use>
void for_each_slice(const NeighborTask<D>& task, const StoredVectors<D>& weights, Use&& use) {
  BlockScratch<D>& scratch = task.scratch;
  const ListedPairsData<D> data{task.source.pairs, scratch.place_rows(), scratch.velocity_rows(), scratch.force_rows(),
                                scratch.kept()};
  ListedPairs<D, StoredVectors<D>, false> pairs(data, weights);
  for (int slice = task.block.first_slice; slice < task.block.end_slice; ++slice) {
    pairs.enter(slice);
    use(pairs, slice, SliceSlots<D>(task.source.pairs, task.block, slice));
  }
}

/// Force of a pair from what the average makes of the stress.
template <int D>
struct AdjointShares {
  Mat<Pack, D> Q;

  template <class Weight>
  SINEW_INLINE Vec<Pack, D> operator()(const Weight& w, const Vec<Pack, D>&, const Vec<Pack, D>& X) const {
    return Q * w.vector(X);
  }
};

}  // namespace

template <int D>
void find_gradients(const NeighborTask<D>& task, MatrixField<D>& gradients) {
  for_each_slice<D>(task, {nullptr, nullptr}, [&](auto& pairs, int, const SliceSlots<D>& slots) {
    slots.store_matrix(pairs.gradient(task.scratch.vectors(), task.weights.pairs.gradient.data()), gradients);
  });
}

template <int D>
void find_laplacians(const NeighborTask<D>& task) {
  for_each_slice<D>(task, {nullptr, nullptr}, [&](auto& pairs, int, const SliceSlots<D>& slots) {
    const Vec<Pack, D> sum = pairs.sum_differences(task.scratch.vectors(), task.weights.pairs.dissipation.data());
    for (int c = 0; c < D; ++c) slots.store(task.laplacian_scale * sum[c], task.matrices.laplacian.component(c));
  });
}

template <int D>
void exchange_corrected_laplacians(const NeighborTask<D>& task) {
  const StoredPairs<double>& weights = task.weights.pairs;
  const StoredVectors<D> vectors{nullptr, nullptr, nullptr, nullptr, weights.dissipation.data()};
  const VectorRows<D> velocities{task.scratch.velocity_rows()};
  for_each_slice<D>(task, vectors, [&](auto& pairs, int slice, const SliceSlots<D>&) {
    const Pack volume = task.weights.constants[task.weights.constants_of[slice]].volume;
    UnexplainedVelocities<D> shares{pairs.gradient(velocities, weights.gradient.data()), (0.5 * task.laplacian_scale) * volume};
    pairs.exchange_moving(shares);
  });
}

/// t_ij = Q_i V_j g_ij, see StressOfBonds.
template <int D>
void give_adjoint_forces(const NeighborTask<D>& task) {
  const StoredPairs<double>& weights = task.weights.pairs;
  const MatrixRows<D> stresses = task.scratch.matrices();
  for_each_slice<D>(task, {weights.gradient.data(), weights.gradient.data(), nullptr, weights.average_of_other.data()},
                    [&](auto& pairs, int slice, const SliceSlots<D>& slots) {
                      const Mat<Pack, D> K = task.weights.own_average[task.weights.constants_of[slice]].matrix();
                      StressOfBonds<D> bonds{slots.load_matrix(task.matrices.stress) * K};
                      pairs.first_visit_with(stresses, bonds);
                      pairs.exchange(AdjointShares<D>{bonds.sum});
                    });
}

template void find_gradients<2>(const NeighborTask<2>&, MatrixField<2>&);
template void find_gradients<3>(const NeighborTask<3>&, MatrixField<3>&);
template void exchange_corrected_laplacians<2>(const NeighborTask<2>&);
template void exchange_corrected_laplacians<3>(const NeighborTask<3>&);
template void find_laplacians<2>(const NeighborTask<2>&);
template void find_laplacians<3>(const NeighborTask<3>&);
template void give_adjoint_forces<2>(const NeighborTask<2>&);
template void give_adjoint_forces<3>(const NeighborTask<3>&);

}  // namespace sinew
