#pragma once

#include <sinew/corrections/correction.hpp>

namespace sinew {

/// g_ij = a_ij X_ij: the gradient of the kernel as it is. Gradients are wrong near surfaces and on irregular particles.
struct NoCorrection {
  static constexpr std::string_view name = "none";
  static constexpr std::string_view summary = "The gradient of the kernel as it is";
  static constexpr std::string_view source = "Gingold & Monaghan (1977)";
  static constexpr bool radial = false, higher_moments = false;
  static void describe(auto&&, auto&) {}

  template <int D>
  SINEW_POINTWISE GradientMap<D> map(const Moments<D>& moments) const {
    GradientMap<D> map;
    map.kernel_scale = partition_of_unity(moments);
    return map;
  }
};

}  // namespace sinew
