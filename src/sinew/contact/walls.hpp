#pragma once
/// Rigid walls: surfaces that push particles away. They stand still or move as given, without turning.

#include <sinew/contact/contact_sums.hpp>
#include <sinew/contact_laws/registry.hpp>
#include <sinew/core/field_function.hpp>
#include <sinew/particles/particles.hpp>
#include <string>
#include <vector>

namespace sinew {

/// A wall as the case describes it.
struct WallCondition {
  std::string name;
  AnyWallShape shape;
  HertzContact law;  ///< its stiffness is ignored
  enum class Motion { none, displacement, velocity } motion = Motion::none;
  std::array<FieldFunction, 3> function;  ///< of time alone [length] or [length/time]
  std::vector<double> stiffness;          ///< of each body; 0: the wall does not act on it
};

template <int D>
class Walls {
 public:
  Walls() = default;
  Walls(std::vector<WallCondition> walls, const Particles<D>& particles, double thickness);

  bool empty() const { return walls_.empty(); }
  /// Walls move to where they are at time t, and push: forces are added to both fields, what they do to the sums of the blocks. `dt`: since the last
  /// call, 0 at the start.
  void push(const Particles<D>& particles, double t, double dt, VectorField<D>& forces, VectorField<D>& contact_forces,
            std::vector<ContactSums>& sums);

  /// Index of a wall; -1: none of that name.
  int index_of(const std::string& name) const;
  /// Force of a wall on the particles of each block [force].
  const std::vector<Vec<double, D>>& forces_of(int wall) const { return walls_[wall].force; }
  /// How far into a wall particles are, at most, as a part of their radius, and how many centers are behind it.
  struct Overlap {
    double most = 0.0;
    long behind = 0;
  };
  Overlap overlap(int wall, const Particles<D>& particles) const;
  const std::string& name(int wall) const { return walls_[wall].condition.name; }
  int count() const { return static_cast<int>(walls_.size()); }

  /// What a restart needs: offsets of the walls, and forces block by block (D numbers a wall).
  std::vector<double> offsets() const;
  std::vector<double> block_forces(int block) const;
  void restore(const std::vector<double>& offsets, const std::vector<std::vector<double>>& block_forces);

 private:
  struct Wall {
    WallCondition condition;
    Vec<double, D> offset, velocity;    ///< from where the shape was given; of the last step
    Vec<double, D> moved;               ///< in the last step
    std::vector<Vec<double, D>> force;  ///< on the particles of each block
  };
  /// Where forces go, and the length of the step.
  struct Push {
    VectorField<D>&forces, &contact_forces;
    double dt;
  };
  void move(Wall& wall, double t, double dt) const;
  template <class Shape>
  void push_block(Wall& wall, const Shape& shape, const Particles<D>& particles, int block, const Push& push, ContactSums& sums);

  std::vector<Wall> walls_;
  AlignedArray<double> radius_;
  double thickness_ = 1.0;
};

extern template class Walls<2>;
extern template class Walls<3>;

}  // namespace sinew
