#pragma once
/// Contact of particles of different bodies, or of one that has folded or come apart: those that may touch soon are on a list, which is made anew when
/// something has moved far enough. Each rank computes the forces on its own particles, in the order of the numbers of those that they touch; so both
/// ends of a pair have exactly opposite forces, and results do not depend on who has which block.

#include <sinew/contact/contact_sums.hpp>
#include <sinew/contact_laws/registry.hpp>
#include <sinew/neighbors/cracks.hpp>
#include <sinew/parallel/exchange.hpp>
#include <sinew/particles/particles.hpp>
#include <vector>

namespace sinew {

/// Which bodies touch which, and how.
struct ContactTable {
  int bodies = 0;
  std::vector<HertzContact> laws;
  std::vector<int> law_of;   ///< bodies x bodies, symmetric; -1: they pass through each other
  std::vector<char> driven;  ///< of each body: it moves as given, as if its mass were infinite

  bool any() const { return !laws.empty(); }
  bool touches(int body) const {
    for (int other = 0; other < bodies; ++other)
      if (law(body, other) >= 0) return true;
    return false;
  }
  int law(int body, int other) const { return law_of[static_cast<std::size_t>(body) * bodies + other]; }
};

template <int D>
class PairContacts {
 public:
  PairContacts() = default;
  /// `support_radius`: per slot; particles of one body that were closer than that at the start do not touch.
  PairContacts(ContactTable table, const Particles<D>& particles, const std::vector<double>& support_radius, double thickness,
               const Comm& comm);

  bool any() const { return table_.any(); }
  bool touches_itself(int body) const { return any() && table_.law(body, body) >= 0; }
  /// Adds the contact forces of the current state to both fields. `dt`: since the last call, 0 at the start. Collective.
  void push(const Particles<D>& particles, double dt, VectorField<D>& forces, VectorField<D>& contact_forces,
            std::vector<ContactSums>& sums);
  /// Deepest overlap of different bodies, as a part of the sum of the radii, and how many pairs overlap by more than `allowed`. Collective.
  struct Overlap {
    double most = 0.0;
    long pairs = 0;  ///< seen from both sides
    int body = 0, other = 0;
  };
  Overlap overlap(double allowed) const;
  /// Particles of one body also touch where they have come apart. To be called when there are new cracks; they stay with the caller.
  void mind(const Cracks<D>& cracks) {
    cracks_ = &cracks;
    list_is_stale_ = true;
  }
  long lists_made() const { return lists_made_; }
  std::size_t bytes() const;

 private:
  /// What never changes of a particle that may touch others.
  struct Point {
    Vec<double, D> reference;
    double radius, support, inverse_mass;
    int body, number;  ///< number: in the user's order
    bool at_crack;     ///< whether it may have come apart from others

    static constexpr int width = D + 6;  ///< numbers in which it travels
    void append_to(std::vector<double>& rows) const;
    static Point from_row(const double* row);
  };
  struct Boxes;

  /// Pairs closer than that times the sum of their radii are looked at for the time step; beyond, a list need not have them.
  static constexpr double near = 1.25;

  bool moved_too_far(const Particles<D>& particles);
  void make_list(const Particles<D>& particles);
  void choose_own(const Particles<D>& particles, const Boxes& boxes);
  std::vector<std::vector<int>> points_for_ranks(const Particles<D>& particles, const Boxes& boxes) const;
  void fetch_copies(const Particles<D>& particles, const Boxes& boxes);
  void find_partners();
  void refresh(const Particles<D>& particles);
  void push_block(int block, double dt, VectorField<D>& forces, VectorField<D>& contact_forces, ContactSums& sums) const;
  Point point_of(const Particles<D>& particles, int slot) const;
  bool may_touch(const Point& a, const Point& b) const;
  Vec<double, D> place(int point) const;
  Vec<double, D> velocity(int point) const;

  ContactTable table_;
  Comm comm_;
  const Cracks<D>* cracks_ = nullptr;
  bool list_is_stale_ = true;
  double thickness_ = 1.0, reach_ = 0.0, skin_ = 0.0;
  AlignedArray<double> radius_, support_;
  VectorField<D> listed_at_;   ///< displacements when the list was made
  std::vector<int> slots_;     ///< of own particles that may touch, ascending
  std::vector<Point> points_;  ///< of those, then of copies from other ranks
  VectorField<2 * D> motion_;  ///< places and velocities of all points
  Exchange exchange_;          ///< of those of copies
  std::vector<int> first_of_block_;
  std::vector<std::size_t> first_partner_;
  std::vector<int> partner_;       ///< of each own point: those that it may touch, by their numbers
  std::vector<double> farthest2_;  ///< scratch, one a block
  long lists_made_ = 0;
};

extern template class PairContacts<2>;
extern template class PairContacts<3>;

}  // namespace sinew
