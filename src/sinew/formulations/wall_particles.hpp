#pragma once
/// Walls made of particles on the current configuration ("dummy particles"): they move as prescribed and have the stress that the material before them would have there.
///
///     sigma_w,aa = sum_f V_f W_wf (sigma_f,aa - rho_f g_a (x_w - x_f)_a) / sum_f V_f W_wf,   other components without the weight
///
/// f: particles that are no wall. Adami, Hu & Adams (2012), eq. 27, component by component as customary for soils. The material sees a rough wall (no slip) with its own
/// velocity. From what pairs with a smooth one (free slip) add to velocity gradients and forces the tangential part is taken off, and its stress has no shear across the normal.

#include <sinew/kernels/registry.hpp>
#include <sinew/neighbors/moving_neighbors.hpp>
#include <sinew/particles/aligned_array.hpp>

namespace sinew {

template <int D>
struct WallSurface {
  bool slips = false;
  Vec<double, D> normal{};  ///< unit vector, where it slips
};

/// What belongs to walls of all ranks.
template <int D>
struct WallTable {
  static constexpr signed char none = -1;
  std::vector<WallSurface<D>> surfaces;
  std::vector<signed char> of_number;  ///< of each particle in the user's order: its surface, or none
  Vec<double, D> gravity{};

  bool empty() const { return surfaces.empty(); }
  bool is_wall(int number) const { return number >= 0 && of_number[number] != none; }
  const WallSurface<D>& of(int number) const { return surfaces[of_number[number]]; }
};

/// Particles as the sweeps see them, by point.
template <int D>
struct MovingPoints {
  const AnyKernel& kernel;
  double radius;
  std::span<const int> numbers;
  const VectorField<2 * D + 1>& motion;  ///< x, v, 1 / rho
  const AlignedArray<double>& mass;      ///< per thickness
};

template <int D>
class WallParticles {
 public:
  WallParticles() = default;
  explicit WallParticles(WallTable<D> table);
  bool any() const { return !table_.empty(); }

  /// To be called with every new list of neighbors.
  void find_pairs(const MovingNeighbors<D>& neighbors, std::span<const int> numbers);
  /// Slots of this rank.
  const std::vector<int>& slots() const { return walls_; }
  /// Of a smooth wall: the pairs of the material with it, for sweeps over these alone.
  struct Slipping {
    MovingNeighbors<D> pairs;
    Vec<double, D> normal;
  };
  const std::vector<Slipping>& slipping() const { return slipping_; }
  /// Stress of walls from that of the others: T = sigma / rho^2, the first D^2 components of `stress`.
  void extrapolate(const MovingPoints<D>& points, VectorField<D * D + 1>& stress) const;

 private:
  struct Pair {
    int slot, point;
  };

  WallTable<D> table_;
  std::vector<int> walls_;          ///< slots of this rank
  std::vector<Pair> sources_;       ///< {wall, other}, wall after wall
  std::vector<Slipping> slipping_;  ///< one a smooth surface
};

extern template class WallParticles<2>;
extern template class WallParticles<3>;

}  // namespace sinew
