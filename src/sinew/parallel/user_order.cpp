#include <sinew/parallel/user_order.hpp>

#include <algorithm>

namespace sinew {

UserOrder::UserOrder(const Comm& comm, const std::vector<int>& user_index) : comm_(comm) {
  std::vector<int> own;
  for (std::size_t slot = 0; slot < user_index.size(); ++slot)
    if (user_index[slot] >= 0) {
      slots_.push_back(static_cast<int>(slot));
      own.push_back(user_index[slot]);
    }
  numbers_ = comm_.gather(own);
}

std::vector<double> UserOrder::gather(std::vector<double> rows, int width) const {
  const std::vector<double> by_rank = comm_.gather_rows(rows, width);
  std::vector<double> all = std::move(rows);
  all.resize(by_rank.size());
  for (std::size_t k = 0; k < numbers_.size(); ++k)
    std::copy_n(by_rank.begin() + k * width, width, all.begin() + static_cast<std::size_t>(numbers_[k]) * width);
  return all;
}

std::vector<double> UserOrder::scatter(const std::vector<double>& all, int width) const {
  std::vector<double> by_rank(numbers_.size() * width), rows(slots_.size() * width);
  for (std::size_t k = 0; k < numbers_.size(); ++k)
    std::copy_n(all.begin() + static_cast<std::size_t>(numbers_[k]) * width, width, by_rank.begin() + k * width);
  comm_.scatter_rows(by_rank, width, rows);
  return rows;
}

}  // namespace sinew
