#pragma once

#include <sinew/particles/generate/lattice.hpp>
#include <sinew/particles/generate/point_set.hpp>

namespace sinew {

/// The points between two concentric spheres (circles in 2D).
struct BallShell {
  Point center;
  double inner_radius, outer_radius;

  /// 4/3 pi (R^3 - r^3), or pi (R^2 - r^2).
  double volume(int dimension) const;
};

/// The points of the lattice inside, with equal volumes that sum to the exact one. The lattice is symmetric about the center.
PointSet ball_shell(const BallShell& shell, const LatticeParams& arrangement, const std::string& shape,
                    const GenerateOptions& options);

}  // namespace sinew
