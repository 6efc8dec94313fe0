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

/// A quantity of one particle. `state` may be null unless needs_record.
template <int D>
Components particle_quantity(std::string_view quantity, int slot, const Particles<D>& particles, const TotalLagrangian<D>& solid,
                             const RecordedState* state);

/// Which of the values of a quantity a component name means: xx -> 0, xy -> 1, ... of a tensor, x y z of a vector; -1: magnitude.
int component_index(const QuantityInfo& quantity, std::string_view component);

}  // namespace sinew
