#pragma once
/// All that touches in a case.

#include <sinew/contact/walls.hpp>

namespace sinew {

template <int D>
class Contacts {
 public:
  Contacts() = default;
  Contacts(Walls<D> walls, const Particles<D>& particles) : walls_(std::move(walls)) {
    if (any()) forces_ = VectorField<D>(particles.slots);
  }

  /// Whether there is anything to touch.
  bool any() const { return !walls_.empty(); }
  /// Adds the contact forces at time t to `forces`. `dt`: since the last call, 0 at the start.
  void push(const Particles<D>& particles, double t, double dt, VectorField<D>& forces) {
    if (!any()) return;
    forces_.clear();
    walls_.push(particles, t, dt, forces, forces_);
  }

  /// Contact forces of the last call, per slot; empty if there is nothing to touch.
  const VectorField<D>& forces() const { return forces_; }
  VectorField<D>& forces() { return forces_; }
  /// Of a block of this rank.
  ContactSums sums(int block) const { return any() ? walls_.sums()[block] : ContactSums{}; }
  void restore_sums(int block, const ContactSums& sums) { walls_.sums()[block] = sums; }
  Walls<D>& walls() { return walls_; }
  const Walls<D>& walls() const { return walls_; }

 private:
  Walls<D> walls_;
  VectorField<D> forces_;
};

}  // namespace sinew
