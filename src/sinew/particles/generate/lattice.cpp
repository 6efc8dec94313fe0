#include <sinew/particles/generate/lattice.hpp>

#include <cmath>
#include <sinew/particles/generate/rounded_text.hpp>

namespace sinew {

namespace {

/// One step of splitmix64 from the state `x`.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace

Lattice LatticeParams::resolve(const GenerateOptions& options) const {
  if (!(spacing > 0.0) || !std::isfinite(spacing))
    options.fail("\"spacing\" is " + rounded_text(spacing) + "; it must be greater than 0.");
  const bool plane = options.dimension == 2;
  const std::string& chosen = lattice.value;
  if (chosen == "auto") return plane ? Lattice::square : Lattice::cubic;
  if (plane && chosen == "square") return Lattice::square;
  if (plane && chosen == "triangular") return Lattice::triangular;
  if (!plane && chosen == "cubic") return Lattice::cubic;
  if (!plane && chosen == "fcc") return Lattice::fcc;
  options.fail("the lattice \"" + chosen + "\" does not exist in " + std::to_string(options.dimension) + "D; use " +
               (plane ? "\"square\" or \"triangular\"." : "\"cubic\" or \"fcc\"."));
}

double counter_uniform(std::uint64_t seed, std::uint64_t index, std::uint64_t component) {
  return static_cast<double>(mix(mix(mix(seed) ^ index) ^ component) >> 11) * 0x1p-53;
}

void apply_jitter(const LatticeParams& params, int dimension, PointSet& points) {
  if (params.jitter == 0.0) return;
  const double reach = params.jitter * params.spacing;
  const auto seed = static_cast<std::uint64_t>(params.seed);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int d = 0; d < dimension; ++d)
      points.position[i][d] += reach * (2.0 * counter_uniform(seed, i, static_cast<std::uint64_t>(d)) - 1.0);
}

}  // namespace sinew
