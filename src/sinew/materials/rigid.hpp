#pragma once

#include <sinew/materials/material.hpp>

namespace sinew {

/// A body that does not resist deformation because it has none: all of its particles move as given (tools, clamps), and others touch it. No stress, no waves,
/// so that its particles do not limit the time step, however small they are.
struct Rigid {
  static constexpr std::string_view name = "rigid";
  static constexpr std::string_view summary = "Tool whose particles all move as prescribed; no stress";
  static constexpr std::string_view source = "Ganzenmueller (2015), sec. 4.3 (compression tool)";
  static constexpr ElasticConstants elastic{0.0, 0.0, 0.0, 0.0, 0.0};
  double density = 0.0;

  static void describe(auto&& field, auto& m) { field("density", m.density, "kg/m^3", "Mass density.", positive); }

  template <class M>
  SINEW_INLINE Response<M> respond(const M&) const {
    return {};
  }
  template <class T>
  SINEW_POINTWISE Tangent<T> tangent(const Mat3<T>&) const {
    return {};
  }
  template <class M>
  SINEW_INLINE ScalarOf<M> acoustic_bound(const M&) const {
    return 0.0;
  }
};

}  // namespace sinew
