#include <sinew/parallel/user_order.hpp>

#include <algorithm>
#include <numeric>

namespace sinew {

UserRange user_range(std::size_t total, int rank, int ranks) {
  const auto begin = [&](int r) { return total * static_cast<std::size_t>(r) / static_cast<std::size_t>(ranks); };
  return {begin(rank), begin(rank + 1) - begin(rank), total, rank == 0};
}

UserOrder::UserOrder(const Comm& comm, const std::vector<int>& user_index) : comm_(comm) {
  std::vector<int> own;
  for (std::size_t slot = 0; slot < user_index.size(); ++slot)
    if (user_index[slot] >= 0) {
      slots_.push_back(static_cast<int>(slot));
      own.push_back(user_index[slot]);
    }
  range_ = user_range(static_cast<std::size_t>(comm.sum(static_cast<long>(own.size()))), comm.rank(), comm.size());
  if (comm.alone()) {
    numbers_ = std::move(own);
  } else {
    there_ = route_there(own);
    back_ = route_back();
  }
}

/// Each particle goes to the rank in whose range it is, and to those whose range ends just before it.
UserOrder::Route UserOrder::route_there(const std::vector<int>& own) const {
  std::vector<int> by_number(own.size());
  std::iota(by_number.begin(), by_number.end(), 0);
  std::sort(by_number.begin(), by_number.end(), [&](int a, int b) { return own[a] < own[b]; });
  Route route;
  std::vector<std::vector<int>> places(comm_.size());
  auto next = by_number.begin();
  for (int rank = 0; rank < comm_.size(); ++rank) {
    const UserRange range = user_range(range_.total, rank, comm_.size());
    const auto first = static_cast<int>(range.first), end = first + static_cast<int>(range.rows());
    while (next != by_number.begin() && own[*(next - 1)] >= first) --next;
    for (; next != by_number.end() && own[*next] < end; ++next) {
      route.row.push_back(*next);
      places[rank].push_back(own[*next] - first);
    }
    route.counts.push_back(static_cast<int>(places[rank].size()));
  }
  for (const std::vector<int>& from : comm_.exchange(places)) {
    route.arriving.insert(route.arriving.end(), from.begin(), from.end());
    route.arriving_counts.push_back(static_cast<int>(from.size()));
  }
  return route;
}

/// The same the other way round, but for the rows behind the ranges.
UserOrder::Route UserOrder::route_back() const {
  Route back;
  std::size_t k = 0;
  std::vector<std::vector<int>> kept(comm_.size());  // for each sender: which of what it sent goes back
  for (int rank = 0; rank < comm_.size(); ++rank) {
    for (int n = 0; n < there_.arriving_counts[rank]; ++n, ++k) {
      if (static_cast<std::size_t>(there_.arriving[k]) >= range_.count) continue;
      back.row.push_back(there_.arriving[k]);
      kept[rank].push_back(n);
    }
    back.counts.push_back(static_cast<int>(kept[rank].size()));
  }
  std::size_t first = 0;
  const std::vector<std::vector<int>> sent = comm_.exchange(kept);
  for (int rank = 0; rank < comm_.size(); ++rank) {
    for (const int n : sent[rank]) back.arriving.push_back(there_.row[first + n]);
    back.arriving_counts.push_back(static_cast<int>(sent[rank].size()));
    first += there_.counts[rank];
  }
  return back;
}

std::vector<double> UserOrder::travel(const std::vector<double>& rows, int width, const Route& route, std::size_t count) const {
  std::vector<double> sent(route.row.size() * width), placed(count * width);
  for (std::size_t k = 0; k < route.row.size(); ++k)
    std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(route.row[k]) * width, width, sent.begin() + k * width);
  const std::vector<double> come = comm_.exchange_rows(std::move(sent), width, route.counts, route.arriving_counts);
  for (std::size_t k = 0; k < route.arriving.size(); ++k)
    std::copy_n(come.begin() + k * width, width, placed.begin() + static_cast<std::ptrdiff_t>(route.arriving[k]) * width);
  return placed;
}

std::vector<double> UserOrder::to_range(const std::vector<double>& rows, int width) const {
  if (!comm_.alone()) return travel(rows, width, there_, range_.rows());
  std::vector<double> sorted(rows.size());
  for (std::size_t k = 0; k < numbers_.size(); ++k)
    std::copy_n(rows.begin() + k * width, width, sorted.begin() + static_cast<std::ptrdiff_t>(numbers_[k]) * width);
  return sorted;
}

std::vector<double> UserOrder::from_range(const std::vector<double>& rows, int width) const {
  if (!comm_.alone()) return travel(rows, width, back_, slots_.size());
  std::vector<double> own(rows.size());
  for (std::size_t k = 0; k < numbers_.size(); ++k)
    std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(numbers_[k]) * width, width, own.begin() + k * width);
  return own;
}

std::vector<double> UserOrder::whole(std::vector<double> rows, int width) const {
  rows.resize(range_.count * width);
  return comm_.gather_rows(rows, width);
}

std::size_t UserOrder::bytes() const {
  std::size_t numbers = slots_.size() + numbers_.size();
  for (const Route* route : {&there_, &back_}) numbers += route->row.size() + route->arriving.size();
  return numbers * sizeof(int);
}

}  // namespace sinew
