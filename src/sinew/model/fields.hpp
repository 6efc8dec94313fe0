#pragma once
/// The quantities of particles, computed when somebody asks.

#include <sinew/formulations/formulation.hpp>
#include <sinew/model/field_names.hpp>
#include <sinew/particles/snapshot.hpp>
#include <span>
#include <string_view>

namespace sinew {

/// True for quantities that follow from F or P, which a sweep has to record first.
bool needs_record(std::string_view quantity);

/// What quantities are computed from. `record` may be null unless needs_record; `contact_forces` empty: nothing touches.
template <int D>
struct QuantitySource {
  const Particles<D>& particles;
  const Formulation<D>& solid;
  const RecordedState* record;
  const VectorField<D>* contact_forces = nullptr;
};

template <int D>
struct ParticleQuantity {
  static constexpr int most_components = 9;

  int components;  ///< as in FieldData: 1, 3, 6 (symmetric tensor) or 9
  /// The values of the particle in slots[k] go to the row rows[k] of `out`; without rows one after the other.
  void (*values)(const QuantitySource<D>& source, std::span<const int> slots, std::span<const int> rows, double* out);
};

/// The quantity of that name, to be found once and applied to many particles. Throws std::logic_error for a name that is none.
template <int D>
ParticleQuantity<D> particle_quantity(std::string_view name);

/// Which of three, or of nine components row by row, a name means: xx -> 0, xy -> 1, ... of a tensor, x y z of a vector; -1: magnitude.
int component_index(const QuantityInfo& quantity, std::string_view component);

/// The same for values of which there may be only six: XX YY ZZ XY YZ XZ of a symmetric tensor.
int stored_index(int component_index, int components);

}  // namespace sinew
