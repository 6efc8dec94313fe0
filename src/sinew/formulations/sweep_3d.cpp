#include <sinew/formulations/sweep.hpp>

namespace sinew {

template <>
ForceSummary sweep_block<3>(const SweepTask<3>& task) {
  return choose_sweep(task);
}

}  // namespace sinew
