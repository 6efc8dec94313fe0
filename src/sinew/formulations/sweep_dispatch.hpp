#pragma once
/// Between the solver and the sweep, which is compiled once for each kind of weights and of hourglass force.

#include <sinew/formulations/total_lagrangian.hpp>

namespace sinew {

/// Everything that one sweep over a chunk reads and writes.
template <int D>
struct SweepTask {
  const Chunk& chunk;
  const PairSource<D>& source;
  const PairWeights<D>& weights;
  const WeightOptions& options;
  MaterialPoint<D> material;
  double thickness, density;
  double hourglass;          ///< coefficient times Young's modulus; 0 without
  const double* place_rows;  ///< of all particles, {u, X}; nullptr if no slice has a pair list
  double* kept;              ///< room of this thread, see ListedPairs
  ForceStreams<D>& forces;
  RecordedState* record;  ///< nullptr: forces only
};

/// Defined in sweep_2d.cpp and sweep_3d.cpp.
template <int D>
ForceSummary sweep_chunk(const SweepTask<D>& task);
template <>
ForceSummary sweep_chunk<2>(const SweepTask<2>& task);
template <>
ForceSummary sweep_chunk<3>(const SweepTask<3>& task);

}  // namespace sinew
