#pragma once
/// The constants of an isotropic elastic solid. A case gives any two of the five; the solver works with Lame's.

#include <cmath>
#include <limits>
#include <optional>
#include <sinew/core/device.hpp>
#include <sinew/core/params.hpp>
#include <string>

namespace sinew {

/// Isotropic elastic constants [Pa]; relations between them: Bonet & Wood (2008), sec. 6.5, or any text on elasticity.
struct ElasticConstants {
  static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
  double youngs_modulus = not_given, poissons_ratio = not_given;
  double bulk_modulus = not_given, shear_modulus = not_given, lame_lambda = not_given;

  static void describe(auto&& field, auto& m) {
    constexpr Range below_half{-1.0, 0.5, true, true, "greater than -1 and below 0.5"};
    field("youngs_modulus", m.youngs_modulus, "Pa", "Young's modulus E; give any two of the five constants.", positive, optional);
    field("poissons_ratio", m.poissons_ratio, "1", "Poisson's ratio nu; below 0.5, since 0.5 is incompressible.", below_half,
          optional);
    field("bulk_modulus", m.bulk_modulus, "Pa", "Bulk modulus K.", positive, optional);
    field("shear_modulus", m.shear_modulus, "Pa", "Shear modulus G = mu.", positive, optional);
    field("lame_lambda", m.lame_lambda, "Pa", "Lame's first constant lambda.", any_number, optional);
  }

  /// Computes all five from the two that were given. Returns what is wrong, or nothing. To be called once, after reading.
  std::optional<std::string> complete();

  SINEW_INLINE double mu() const { return shear_modulus; }
  SINEW_INLINE double lambda() const { return lame_lambda; }
};

}  // namespace sinew
