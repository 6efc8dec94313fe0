#pragma once
/// Between particles as ranks have them and the user's order, as files want it, on the root.

#include <sinew/parallel/comm.hpp>
#include <span>
#include <vector>

namespace sinew {

class UserOrder {
 public:
  UserOrder() = default;
  /// `user_index`: slot -> number in the user's order, -1 for padding. Collective.
  UserOrder(const Comm& comm, const std::vector<int>& user_index);

  /// Slots of the particles of this rank, ascending.
  const std::vector<int>& slots() const { return slots_; }
  /// Rows of `width` numbers of the particles of this rank, in the order of slots(); on the root those of all particles, in the user's order,
  /// nothing elsewhere. Collective.
  std::vector<double> gather(std::vector<double> rows, int width) const;
  /// The other way round. Collective.
  std::vector<double> scatter(const std::vector<double>& all, int width) const;

 private:
  Comm comm_;
  std::vector<int> slots_;
  std::vector<int> numbers_;  ///< on the root: numbers in the user's order, rank after rank
};

}  // namespace sinew
