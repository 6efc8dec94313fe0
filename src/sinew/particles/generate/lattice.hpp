#pragma once
/// Regular and disturbed arrangements of particles, shared by all shapes that are filled with a lattice.

#include <cstdint>
#include <sinew/core/params.hpp>
#include <sinew/particles/generate/options.hpp>
#include <sinew/particles/generate/point_set.hpp>
#include <string>

namespace sinew {

enum class Lattice { square, triangular, cubic, fcc };

/// How particles are arranged inside a shape.
struct LatticeParams {
  double spacing = 0.0;
  Choice lattice{"auto", {"auto", "square", "triangular", "cubic", "fcc"}};
  double jitter = 0.0;
  int seed = 1;

  static void describe(auto&& field, auto& m) {
    constexpr Range jitter_range{0.0, 0.45, false, false, "from 0 to 0.45"};
    field("spacing", m.spacing, "m", "Distance between neighboring particles.", positive);
    field("lattice", m.lattice, "1", "Arrangement of the particles; auto is square in 2D and cubic in 3D.", any_number, optional);
    field("jitter", m.jitter, "1", "Largest random displacement per component, as a fraction of the spacing.", jitter_range,
          optional);
    field("seed", m.seed, "1", "Start of the random numbers of the jitter.", non_negative, optional);
  }

  /// The lattice with `auto` resolved. CaseError if it does not exist in that dimension, or the spacing is not usable.
  Lattice resolve(const GenerateOptions& options) const;
};

/// Uniform in [0, 1), a function of the three numbers alone (splitmix64, Steele, Lea and Flood 2014, of their mixture), so that
/// neither the order of the particles nor the machine changes it.
double counter_uniform(std::uint64_t seed, std::uint64_t index, std::uint64_t component);

/// Moves every component of every point by a uniform amount in [-jitter, jitter] * spacing; z stays in two dimensions.
void apply_jitter(const LatticeParams& params, int dimension, PointSet& points);

}  // namespace sinew
