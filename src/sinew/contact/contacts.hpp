#pragma once
/// All that touches in a case.

#include <sinew/contact/pair_contacts.hpp>
#include <sinew/contact/walls.hpp>

namespace sinew {

template <int D>
class Contacts {
 public:
  Contacts(Walls<D> walls, PairContacts<D> pairs, const Particles<D>& particles)
      : walls_(std::move(walls)),
        pairs_(std::move(pairs)),
        sums_(particles.blocks.size()) {
    if (any()) forces_ = VectorField<D>(particles.slots);
  }

  /// Whether there is anything to touch.
  bool any() const { return !walls_.empty() || pairs_.any(); }
  /// Adds the contact forces at time t to `forces`. `dt`: since the last call, 0 at the start. Collective.
  void push(const Particles<D>& particles, double t, double dt, VectorField<D>& forces) {
    if (!any()) return;
    forces_.clear();
    for (ContactSums& sums : sums_) sums.begin_step();
    if (!walls_.empty()) walls_.push(particles, t, dt, forces, forces_, sums_);
    if (pairs_.any()) pairs_.push(particles, dt, forces, forces_, sums_);
  }

  /// Contact forces of the last call, per slot; empty if there is nothing to touch.
  const VectorField<D>& forces() const { return forces_; }
  VectorField<D>& forces() { return forces_; }
  /// Of the blocks of this rank.
  const std::vector<ContactSums>& sums() const { return sums_; }
  std::vector<ContactSums>& sums() { return sums_; }
  Walls<D>& walls() { return walls_; }
  const Walls<D>& walls() const { return walls_; }
  const PairContacts<D>& pairs() const { return pairs_; }
  PairContacts<D>& pairs() { return pairs_; }
  std::size_t bytes() const { return forces_.bytes() + (pairs_.any() ? pairs_.bytes() : 0); }

 private:
  Walls<D> walls_;
  PairContacts<D> pairs_;
  std::vector<ContactSums> sums_;
  VectorField<D> forces_;
};

}  // namespace sinew
