#pragma once
/// Weights of pairs that need what both ends know of their neighbors. All particles of a body have one support radius.

#include <sinew/formulations/map_field.hpp>
#include <sinew/formulations/pair_weights.hpp>

namespace sinew {

/// Fills the arrays of `weights` that WeightOptions::mutual() asks for: force vectors 1/2 V_j (g_ij - g_ji), or those of the average over bonds and what the neighbor gives to
/// its own average. `maps`: of all particles and copies.
template <int D>
void add_mutual_weights(const PairSource<D>& source, const WeightOptions& options, MapField<D>& maps, PairWeights<D>& weights);

}  // namespace sinew
