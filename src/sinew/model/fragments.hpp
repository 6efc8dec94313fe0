#pragma once
/// The pieces into which bodies have broken: particles that are not failed, linked to those of their neighbors in the reference configuration that are not failed either.

#include <sinew/formulations/formulation.hpp>

namespace sinew {

struct Fragments {
  long count = 0;        ///< pieces of at least one particle
  double largest = 0.0;  ///< mass of the heaviest [mass]
  double debris = 0.0;   ///< mass of the failed particles, which belong to no piece [mass]
};

/// `state`: has the damage of the particles. The same numbers on any number of ranks. Collective.
template <int D>
Fragments find_fragments(const Comm& comm, const Particles<D>& particles, const Formulation<D>& solid,
                         const RecordedState& state);

}  // namespace sinew
