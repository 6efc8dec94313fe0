#pragma once
/// Which nodes meet in a matrix.

#include <sinew/implicit/nonlinear_system.hpp>

namespace sinew {

/// Nodes are numbered through all ranks, those of this one from `first` on.
struct Sparsity {
  int first = 0, total = 0;
  std::vector<std::vector<int>> columns;  ///< of each node of this rank, ascending
};

/// From the groups of all ranks, each of which may have rows of others.
Sparsity find_sparsity(const Comm& comm, const NonlinearSystem& system, bool exact);

}  // namespace sinew
