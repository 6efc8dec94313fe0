#include <sinew/formulations/sweep.hpp>
#include <sinew/materials/plane_stress.hpp>

namespace sinew {

template <>
ForceSummary sweep_any_chunk<2>(const SweepTask<2>& task, const AnyMaterial& any, bool plane_stress) {
  return std::visit(
      [&]<class Material>(const Material& material) {
        if (plane_stress) return sweep_chunk_of<2>(task, PlaneStress<Material>{material});
        return sweep_chunk_of<2>(task, material);
      },
      any);
}

}  // namespace sinew
