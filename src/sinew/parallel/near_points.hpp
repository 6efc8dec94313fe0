#pragma once
/// Which particles other ranks have to know when everything moves: those near the boxes around their blocks.

#include <sinew/parallel/exchange.hpp>
#include <sinew/particles/particles.hpp>
#include <vector>

namespace sinew {

/// The boxes around all blocks of all ranks, at the current positions.
template <int D>
class MovingBoxes {
 public:
  /// Collective. Positions: by slot.
  MovingBoxes(const Comm& comm, const Particles<D>& particles, const VectorField<D>& positions);

  /// Around everything.
  const Vec<double, D>& low() const { return low_; }
  const Vec<double, D>& high() const { return high_; }
  /// Slots of own particles closer than `reach` to a block of each rank, ascending; none for this one.
  std::vector<std::vector<int>> slots_for_ranks(const Comm& comm, const Particles<D>& particles, const VectorField<D>& positions,
                                                double reach) const;

 private:
  struct Box {
    Vec<double, D> low, high;
    int rank = 0;
    bool near(const Vec<double, D>& x, double reach) const;
    bool near(const Box& other, double reach) const;
  };
  std::vector<Box> boxes_;  ///< by the numbers of the blocks
  Vec<double, D> low_, high_;
};

/// How copies come: those of rank after rank, behind `own` places.
struct CopyPlan {
  std::vector<Parcel> send, receive;
  std::vector<int> sent, received;  ///< particles to and from each rank
  int copies = 0;
};

/// Collective. slots[r]: those that go to rank r.
CopyPlan plan_copies(const Comm& comm, const std::vector<std::vector<int>>& slots, int own);

extern template class MovingBoxes<2>;
extern template class MovingBoxes<3>;

}  // namespace sinew
