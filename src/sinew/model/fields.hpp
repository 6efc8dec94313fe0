#pragma once
/// The quantities of single particles, computed when somebody asks.

#include <sinew/formulations/total_lagrangian.hpp>
#include <sinew/model/field_names.hpp>
#include <sinew/particles/snapshot.hpp>
#include <string_view>

namespace sinew {

/// The values of a quantity of one particle: 1, 3 (vector) or 9 (tensor, row-major).
struct Components {
  double value[9] = {};
  int count = 1;
};

/// True for quantities that follow from F or P, which a sweep has to record first.
bool needs_record(std::string_view quantity);

/// What quantities are computed from. `record` may be null unless needs_record.
template <int D>
struct QuantitySource {
  const Particles<D>& particles;
  const TotalLagrangian<D>& solid;
  const RecordedState* record;
};

/// A quantity of the particle in a slot.
template <int D>
using ParticleQuantity = Components (*)(const QuantitySource<D>& source, int slot);

/// The quantity of that name, to be found once and applied to many particles. Throws std::logic_error for a name that is none.
template <int D>
ParticleQuantity<D> particle_quantity(std::string_view name);

/// Which of the values of a quantity a component name means: xx -> 0, xy -> 1, ... of a tensor, x y z of a vector; -1: magnitude.
int component_index(const QuantityInfo& quantity, std::string_view component);

}  // namespace sinew
