#pragma once
/// Between the solver, which knows a material only as one of many, and the sweep, which is compiled once for each.

#include <sinew/formulations/total_lagrangian.hpp>

namespace sinew {

/// What a sweep needs to know of the body of a chunk.
struct SweepScalars {
  double density, thickness;
  double hourglass;   ///< coefficient times Young's modulus; 0 without
  bool conservative;  ///< which form of hourglass force
};

/// Everything that one sweep over a chunk reads and writes.
template <int D>
struct SweepTask {
  const Chunk& chunk;
  const PairList& list;
  const Particles<D>& particles;
  const PairWeights<D>& weights;
  SweepScalars scalars;
  double* force_rows;
  RecordedState* record;  ///< nullptr: forces only
};

/// Defined, with one sweep for each material, in sweep_2d.cpp and sweep_3d.cpp.
template <int D>
ForceSummary sweep_any_chunk(const SweepTask<D>& task, const AnyMaterial& material, bool plane_stress);
template <>
ForceSummary sweep_any_chunk<2>(const SweepTask<2>& task, const AnyMaterial& material, bool plane_stress);
template <>
ForceSummary sweep_any_chunk<3>(const SweepTask<3>& task, const AnyMaterial& material, bool plane_stress);

}  // namespace sinew
