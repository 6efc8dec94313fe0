#include <sinew/implicit/sparsity.hpp>

#include <algorithm>

namespace sinew {

namespace {

/// Sorted, each once.
void tidy(std::vector<int>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// First node of each rank, and the number of all.
std::vector<int> first_nodes(const Comm& comm, int nodes) {
  std::vector<int> first{0};
  for (const int count : comm.gather_all(std::span<const int>(&nodes, 1))) first.push_back(first.back() + count);
  return first;
}

}  // namespace

Sparsity find_sparsity(const Comm& comm, const NonlinearSystem& system, bool exact) {
  const std::vector<int> first = first_nodes(comm, system.nodes());
  Sparsity s{first[comm.rank()], first.back(), {}};
  s.columns.resize(system.nodes());
  std::vector<std::vector<int>> to(comm.size());  // row, how many columns, columns; for other ranks
  constexpr std::size_t often = 512;
  system.for_each_group(exact, [&](std::span<const int> nodes) {
    for (const int row : nodes) {
      if (row >= s.first && row < s.first + system.nodes()) {
        std::vector<int>& columns = s.columns[row - s.first];
        columns.insert(columns.end(), nodes.begin(), nodes.end());
        if (columns.size() > often && columns.size() > 2 * columns.capacity() / 3) tidy(columns);
        continue;
      }
      std::vector<int>& message = to[std::upper_bound(first.begin(), first.end(), row) - first.begin() - 1];
      message.push_back(row);
      message.push_back(static_cast<int>(nodes.size()));
      message.insert(message.end(), nodes.begin(), nodes.end());
    }
  });
  if (!comm.alone())
    for (const std::vector<int>& message : comm.exchange(to))
      for (std::size_t at = 0; at < message.size(); at += 2 + message[at + 1]) {
        std::vector<int>& columns = s.columns[message[at] - s.first];
        columns.insert(columns.end(), message.begin() + at + 2, message.begin() + at + 2 + message[at + 1]);
      }
  for (int row = 0; row < system.nodes(); ++row) {
    s.columns[row].push_back(s.first + row);
    tidy(s.columns[row]);
    s.columns[row].shrink_to_fit();
  }
  return s;
}

}  // namespace sinew
