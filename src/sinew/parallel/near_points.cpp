#include <sinew/parallel/near_points.hpp>

#include <algorithm>
#include <limits>

namespace sinew {

template <int D>
bool MovingBoxes<D>::Box::near(const Vec<double, D>& x, double reach) const {
  for (int c = 0; c < D; ++c)
    if (x[c] < low[c] - reach || x[c] > high[c] + reach) return false;
  return true;
}

template <int D>
bool MovingBoxes<D>::Box::near(const Box& other, double reach) const {
  for (int c = 0; c < D; ++c)
    if (other.high[c] < low[c] - reach || other.low[c] > high[c] + reach) return false;
  return true;
}

template <int D>
MovingBoxes<D>::MovingBoxes(const Comm& comm, const Particles<D>& particles, const VectorField<D>& positions) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr int width = 2 * D + 1;
  std::vector<double> rows;
  for (const BlockRange& block : particles.blocks) {
    Box box;
    for (int c = 0; c < D; ++c) box.low[c] = infinity, box.high[c] = -infinity;
    for (int slot = block.begin; slot < block.end; ++slot)
      for (int c = 0; c < D; ++c) {
        box.low[c] = std::min(box.low[c], positions.at(c, slot));
        box.high[c] = std::max(box.high[c], positions.at(c, slot));
      }
    rows.insert(rows.end(), box.low.c, box.low.c + D);
    rows.insert(rows.end(), box.high.c, box.high.c + D);
    rows.push_back(comm.rank());
  }
  rows = gather_over_blocks(comm, particles.block_numbers(), rows, width);
  for (int c = 0; c < D; ++c) low_[c] = infinity, high_[c] = -infinity;
  for (auto row = rows.begin(); row != rows.end(); row += width) {
    Box box;
    std::copy_n(row, D, box.low.c);
    std::copy_n(row + D, D, box.high.c);
    box.rank = static_cast<int>(row[2 * D]);
    for (int c = 0; c < D; ++c) low_[c] = std::min(low_[c], box.low[c]), high_[c] = std::max(high_[c], box.high[c]);
    boxes_.push_back(box);
  }
}

template <int D>
std::vector<std::vector<int>> MovingBoxes<D>::slots_for_ranks(const Comm& comm, const Particles<D>& particles,
                                                              const VectorField<D>& positions, double reach) const {
  std::vector<std::vector<int>> slots(comm.size());
  for (const BlockRange& block : particles.blocks)
    for (const Box& other : boxes_) {
      if (other.rank == comm.rank() || !boxes_[block.number].near(other, reach)) continue;
      for (int slot = block.begin; slot < block.end; ++slot)
        if (particles.user_index[slot] >= 0 && other.near(positions[slot], reach)) slots[other.rank].push_back(slot);
    }
  for (std::vector<int>& to : slots) {
    std::sort(to.begin(), to.end());
    to.erase(std::unique(to.begin(), to.end()), to.end());
  }
  return slots;
}

CopyPlan plan_copies(const Comm& comm, const std::vector<std::vector<int>>& slots, int own) {
  CopyPlan plan;
  std::vector<std::vector<int>> counts(comm.size());
  plan.received.assign(comm.size(), 0);
  for (int rank = 0; rank < comm.size(); ++rank) {
    const auto count = static_cast<int>(slots[rank].size());
    plan.sent.push_back(count);
    counts[rank] = {count};
    if (count == 0) continue;
    plan.send.push_back({rank, {}});
    for (const int slot : slots[rank]) {
      std::vector<Stretch>& stretches = plan.send.back().stretches;
      if (!stretches.empty() && stretches.back().begin + stretches.back().length == slot)
        ++stretches.back().length;
      else
        stretches.push_back({slot, 1});
    }
  }
  counts = comm.exchange(counts);
  for (int rank = 0; rank < comm.size(); ++rank) {
    const int count = rank == comm.rank() || counts[rank].empty() ? 0 : counts[rank][0];
    plan.received[rank] = count;
    if (count > 0) plan.receive.push_back({rank, {{own + plan.copies, count}}});
    plan.copies += count;
  }
  return plan;
}

template class MovingBoxes<2>;
template class MovingBoxes<3>;

}  // namespace sinew
