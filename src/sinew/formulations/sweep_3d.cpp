#include <sinew/formulations/sweep.hpp>

namespace sinew {

template <>
ForceSummary sweep_any_chunk<3>(const SweepTask<3>& task, const AnyMaterial& any, bool) {
  return std::visit([&](const auto& material) { return sweep_chunk_of<3>(task, material); }, any);
}

}  // namespace sinew
