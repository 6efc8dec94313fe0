#include <sinew/formulations/sweep.hpp>

namespace sinew {

template <>
ForceSummary sweep_block<2>(const SweepTask<2>& task) {
  return choose_sweep(task);
}

}  // namespace sinew
