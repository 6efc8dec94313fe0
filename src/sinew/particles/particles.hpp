#pragma once
/// The particles of all bodies in computing order, block after block. Each body starts on a full slice of eight; what is left of its last slice is
/// padding: particles of no volume and no mass that see nobody.

#include <sinew/core/pack.hpp>
#include <sinew/particles/generate/point_set.hpp>
#include <sinew/particles/vector_field.hpp>
#include <string>
#include <vector>

namespace sinew {

/// Slots [begin, end) of one body in computing order, full slices; `count` of them are particles, the rest padding.
struct BodyRange {
  std::string name;
  int begin = 0, end = 0, count = 0;
  double spacing = 0.0;  ///< nominal particle spacing [length]
  double density = 0.0;  ///< reference mass density
};

/// Slots [begin, end) of a block, a compact piece of a body. `number`: its place in the order of all blocks of the case.
struct BlockRange {
  int body = 0, begin = 0, end = 0, number = 0;

  bool owns(int slot) const { return slot >= begin && slot < end; }
};
/// Particles in a block at most, unless the case says otherwise: little enough for the caches, enough to have few neighbors outside. A constant of
/// the program, so that sums have the same order everywhere. Tests lower it.
inline int largest_block = 16384;

/// Reference configuration in computing order.
template <int D>
struct Arrangement {
  int count = 0;  ///< particles
  int slots = 0;  ///< places in computing order, a multiple of eight
  std::vector<BodyRange> bodies;
  std::vector<BlockRange> blocks;
  VectorField<D> position;      ///< reference position X [length]
  AlignedArray<double> volume;  ///< reference volume, per thickness in 2D [length^D]
  std::vector<int> user_index;  ///< slot -> number in the user's order, -1 for padding
  std::vector<int> slot_of;     ///< number in the user's order -> slot; empty for one rank's part of a case

  Point reference(int slot) const;  ///< X, with z = 0 in two dimensions
  int body_of(int slot) const;
  int block_of(int slot) const;
  std::vector<int> block_numbers() const;
};

/// Particles and their state. Behind the `slots` of particles stand copies of `copies` particles of other ranks, of which reference position,
/// volume and displacement are known.
template <int D>
struct Particles : Arrangement<D> {
  int copies = 0;
  VectorField<D> displacement;  ///< u [length]; kept instead of the current position: F - I is then as accurate as u itself
  VectorField<D> velocity;      ///< [length/time]
  VectorField<D> acceleration;  ///< [length/time^2], of the last force evaluation
  AlignedArray<double> mass;    ///< [mass]; 0 for padding

  Particles() = default;
  /// At rest in the reference configuration. `thickness`: of a plane body, 1 in 3D.
  Particles(Arrangement<D> arrangement, double thickness, int copies = 0);

  Point current(int slot) const;  ///< x = X + u
  std::size_t bytes() const;
};

/// What a body brings: its points, in the user's order, and the density that gives them mass.
struct BodyPoints {
  std::string name;
  const PointSet* points;
  double density;
  double spacing;
};

/// Puts all bodies into computing order, in blocks of at most so many particles.
template <int D>
Arrangement<D> arrange(const std::vector<BodyPoints>& bodies, int block_size = largest_block);
template <int D>
Particles<D> make_particles(const std::vector<BodyPoints>& bodies, double thickness) {
  return Particles<D>(arrange<D>(bodies), thickness);
}

extern template struct Arrangement<2>;
extern template struct Arrangement<3>;
extern template struct Particles<2>;
extern template struct Particles<3>;

}  // namespace sinew
