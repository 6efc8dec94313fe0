#pragma once
/// Between particles as ranks have them and the user's order, as files want it: each rank gets a piece of it, equal to within a particle.

#include <sinew/parallel/comm.hpp>
#include <sinew/particles/snapshot.hpp>
#include <vector>

namespace sinew {

/// The piece of one of `ranks`.
UserRange user_range(std::size_t total, int rank, int ranks);

class UserOrder {
 public:
  UserOrder() = default;
  /// `user_index`: slot -> number in the user's order, -1 for padding. Collective.
  UserOrder(const Comm& comm, const std::vector<int>& user_index);

  /// Slots of the particles of this rank, ascending.
  const std::vector<int>& slots() const { return slots_; }
  /// Numbers of these in the user's order, of a process alone; empty for one of several ranks.
  const std::vector<int>& numbers() const { return numbers_; }
  const UserRange& range() const { return range_; }
  /// From rows of `width` numbers of the particles of this rank, in the order of slots(), to range().rows() rows. Collective.
  std::vector<double> to_range(const std::vector<double>& rows, int width) const;
  /// From range().count rows to those of slots(). Collective.
  std::vector<double> from_range(const std::vector<double>& rows, int width) const;
  /// Rows of all particles on the root, from range().rows() rows; nothing elsewhere. Collective.
  std::vector<double> whole(std::vector<double> rows, int width) const;
  std::size_t bytes() const;

 private:
  /// Rows that travel: which one goes to which rank, and where those that come belong.
  struct Route {
    std::vector<int> row, counts;                ///< sent, rank after rank
    std::vector<int> arriving, arriving_counts;  ///< row here of each that comes
  };
  std::vector<double> travel(const std::vector<double>& rows, int width, const Route& route, std::size_t count) const;
  Route route_there(const std::vector<int>& own) const;
  Route route_back() const;

  Comm comm_;
  std::vector<int> slots_, numbers_;
  UserRange range_;
  Route there_, back_;  ///< empty for a process alone
};

}  // namespace sinew
