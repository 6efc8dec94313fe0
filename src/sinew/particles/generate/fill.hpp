#pragma once
/// Filling a shape with the points of a lattice.

#include <array>
#include <cstddef>
#include <sinew/particles/generate/lattice.hpp>
#include <sinew/particles/generate/point_set.hpp>

namespace sinew {

/// A block with sides along the axes.
struct Bounds {
  Point low, high;
};

/// All four lattices as equally thick layers along each axis, a site where three layers meet (two in 2D). Square and cubic: every
/// site is a point. Triangular and fcc: `alternate`, the sites with even i + j + k are.
struct Layers {
  std::array<int, 3> count{1, 1, 1};
  Point thickness;
  Point low;  ///< outer side of the first layers
  bool alternate = false;
  int parity = 0;  ///< of i + j + k where there is a point

  /// round(side / thickness) layers, at least one, in the middle of the block.
  static Layers inside(const Bounds& block, Lattice lattice, double spacing, const GenerateOptions& options);
  /// As `inside`, but a triangular or fcc lattice has a point in the middle of the block, so that it is symmetric about it.
  static Layers about_center(const Bounds& block, Lattice lattice, double spacing, const GenerateOptions& options);

  std::size_t site_count() const;
  Point site(int i, int j, int k) const;
  /// s^2, sqrt(3)/2 s^2, s^3 or s^3/sqrt(2), where s is the distance between nearest neighbors.
  double cell_volume(int dimension) const;
};

/// The points of the lattice for which `contains(point)` holds, each with the volume of its cell.
template <class Contains>
PointSet fill(const Layers& layers, double spacing, int dimension, Contains&& contains) {
  PointSet set;
  set.spacing = spacing;
  set.position.reserve(layers.site_count() / (layers.alternate ? 2 : 1) + 1);
  for (int k = 0; k < layers.count[2]; ++k)
    for (int j = 0; j < layers.count[1]; ++j)
      for (int i = layers.alternate ? (j + k + layers.parity) % 2 : 0; i < layers.count[0]; i += layers.alternate ? 2 : 1) {
        const Point p = layers.site(i, j, k);
        if (contains(p)) set.position.push_back(p);
      }
  set.volume.assign(set.size(), layers.cell_volume(dimension));
  return set;
}

/// Points nearer to the surface of a shape than this fraction of the spacing count as outside, so that rounding does not decide.
inline constexpr double surface_tolerance = 1e-9;

/// Scales the volumes so that their sum is `exact`, and warns if that changes them by more than 5 %. CaseError if there are no
/// points.
void scale_to_volume(PointSet& points, double exact, const std::string& shape, const GenerateOptions& options);

}  // namespace sinew
