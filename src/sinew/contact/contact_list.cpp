/// Of PairContacts: who may touch whom.

#include <sinew/contact/pair_contacts.hpp>
#include <sinew/neighbors/cell_list.hpp>

#include <algorithm>
#include <limits>

namespace sinew {

/// Around the current places of all blocks of the case, by their numbers.
template <int D>
struct PairContacts<D>::Boxes {
  struct Box {
    Vec<double, D> low, high;
    int body = 0, rank = 0;

    bool reaches(const Vec<double, D>& x, double reach) const {
      for (int c = 0; c < D; ++c)
        if (x[c] < low[c] - reach || x[c] > high[c] + reach) return false;
      return true;
    }
    bool reaches(const Box& other, double reach) const {
      for (int c = 0; c < D; ++c)
        if (other.high[c] < low[c] - reach || other.low[c] > high[c] + reach) return false;
      return true;
    }
  };
  std::vector<Box> all;

  Boxes(const Comm& comm, const Particles<D>& particles) {
    constexpr int width = 2 * D + 2;
    std::vector<double> rows;
    for (const BlockRange& block : particles.blocks) {
      Vec<double, D> low, high;
      for (int c = 0; c < D; ++c)
        low[c] = std::numeric_limits<double>::infinity(), high[c] = -std::numeric_limits<double>::infinity();
      for (int slot = block.begin; slot < block.end; ++slot)
        for (int c = 0; c < D; ++c) {
          const double x = particles.position.at(c, slot) + particles.displacement.at(c, slot);
          low[c] = std::min(low[c], x);
          high[c] = std::max(high[c], x);
        }
      rows.insert(rows.end(), low.c, low.c + D);
      rows.insert(rows.end(), high.c, high.c + D);
      rows.insert(rows.end(), {static_cast<double>(block.body), static_cast<double>(comm.rank())});
    }
    rows = gather_over_blocks(comm, particles.block_numbers(), rows, width);
    for (auto row = rows.begin(); row != rows.end(); row += width) {
      Box box;
      std::copy_n(row, D, box.low.c);
      std::copy_n(row + D, D, box.high.c);
      box.body = static_cast<int>(row[2 * D]);
      box.rank = static_cast<int>(row[2 * D + 1]);
      all.push_back(box);
    }
  }

  /// Boxes of others that particles of block `number` may touch.
  std::vector<Box> partners_of(int number, const ContactTable& table, double reach) const {
    std::vector<Box> partners;
    for (const Box& box : all)
      if (table.law(all[number].body, box.body) >= 0 && all[number].reaches(box, reach)) partners.push_back(box);
    return partners;
  }
};

template <int D>
void PairContacts<D>::Point::append_to(std::vector<double>& rows) const {
  rows.insert(rows.end(), reference.c, reference.c + D);
  rows.insert(rows.end(),
              {radius, support, inverse_mass, static_cast<double>(body), static_cast<double>(number), at_crack ? 1.0 : 0.0});
}

template <int D>
typename PairContacts<D>::Point PairContacts<D>::Point::from_row(const double* row) {
  Point p{{}, row[D], row[D + 1], row[D + 2], static_cast<int>(row[D + 3]), static_cast<int>(row[D + 4]), row[D + 5] != 0.0};
  std::copy_n(row, D, p.reference.c);
  return p;
}

template <int D>
typename PairContacts<D>::Point PairContacts<D>::point_of(const Particles<D>& particles, int slot) const {
  const int body = particles.body_of(slot);
  const double inverse_mass = table_.driven[body] ? 0.0 : 1.0 / particles.mass[slot];
  Point point{particles.position[slot], radius_[slot], support_[slot], inverse_mass, body, particles.user_index[slot], false};
  if (!cracks_) return point;
  point.at_crack = cracks_->near(point.reference, body);
  if (const auto* failed = cracks_->find(point.number)) point.radius = failed->radius;
  return point;
}

/// Those of one body touch only if they were apart at the start, or have come apart.
template <int D>
bool PairContacts<D>::may_touch(const Point& a, const Point& b) const {
  if (a.number == b.number || table_.law(a.body, b.body) < 0) return false;
  if (a.body != b.body) return true;
  const Vec<double, D> apart = a.reference - b.reference;
  const double support = std::max(a.support, b.support);
  return dot(apart, apart) > support * support || (a.at_crack && b.at_crack && cracks_->cuts(a.reference, b.reference, a.body));
}

/// Own particles near boxes that they may touch become points.
template <int D>
void PairContacts<D>::choose_own(const Particles<D>& particles, const Boxes& boxes) {
  slots_.clear();
  points_.clear();
  first_of_block_.clear();
  for (const BlockRange& block : particles.blocks) {
    first_of_block_.push_back(static_cast<int>(slots_.size()));
    const auto partners = boxes.partners_of(block.number, table_, reach_);
    for (int slot = block.begin; slot < block.end && !partners.empty(); ++slot) {
      const Vec<double, D> x = particles.position[slot] + particles.displacement[slot];
      if (std::none_of(partners.begin(), partners.end(), [&](const auto& box) { return box.reaches(x, reach_); })) continue;
      slots_.push_back(slot);
      points_.push_back(point_of(particles, slot));
    }
  }
  first_of_block_.push_back(static_cast<int>(slots_.size()));
}

/// Numbers of the points near boxes of each rank, ascending.
template <int D>
std::vector<std::vector<int>> PairContacts<D>::points_for_ranks(const Particles<D>& particles, const Boxes& boxes) const {
  std::vector<std::vector<int>> to(comm_.size());
  for (std::size_t b = 0; b < particles.blocks.size(); ++b)
    for (const auto& box : boxes.partners_of(particles.blocks[b].number, table_, reach_))
      for (int k = first_of_block_[b]; k < first_of_block_[b + 1] && box.rank != comm_.rank(); ++k)
        if (box.reaches(particles.position[slots_[k]] + particles.displacement[slots_[k]], reach_)) to[box.rank].push_back(k);
  for (std::vector<int>& points : to) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }
  return to;
}

/// Points near boxes of other ranks go there. Their places and velocities will travel in every step.
template <int D>
void PairContacts<D>::fetch_copies(const Particles<D>& particles, const Boxes& boxes) {
  const auto own = static_cast<int>(points_.size());
  const std::vector<std::vector<int>> to = points_for_ranks(particles, boxes);
  std::vector<int> send(comm_.size()), receive(comm_.size());
  std::vector<std::vector<int>> counts(comm_.size());
  std::vector<double> rows;
  std::vector<Parcel> out, in;
  for (int rank = 0; rank < comm_.size(); ++rank) {
    for (const int point : to[rank]) points_[point].append_to(rows);
    send[rank] = static_cast<int>(to[rank].size());
    counts[rank] = {send[rank]};
    if (send[rank] == 0) continue;
    out.push_back({rank, {}});
    for (const int point : to[rank]) out.back().stretches.push_back({point, 1});
  }
  counts = comm_.exchange(counts);
  int next = own;
  for (int rank = 0; rank < comm_.size(); ++rank) {
    receive[rank] = counts[rank].empty() ? 0 : counts[rank][0];
    if (receive[rank] > 0) in.push_back({rank, {{next, receive[rank]}}});
    next += receive[rank];
  }
  rows = comm_.exchange_rows(std::move(rows), Point::width, send, receive);
  for (std::size_t row = 0; row < rows.size(); row += Point::width) points_.push_back(Point::from_row(rows.data() + row));
  motion_ = VectorField<2 * D>(points_.size());
  exchange_ = Exchange(comm_, 2 * D, VectorField<2 * D>::stride_of(points_.size()), out, in);
}

template <int D>
void PairContacts<D>::find_partners() {
  std::vector<sinew::Point> places(points_.size());
  for (std::size_t k = 0; k < points_.size(); ++k)
    for (int c = 0; c < D; ++c) places[k][c] = motion_.at(c, static_cast<int>(k));
  partner_.clear();
  first_partner_.assign(1, 0);
  if (places.empty()) return;
  const CellList cells(places, reach_ - skin_);
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    cells.for_each_within(places[i], reach_, [&](int j, double distance2) {
      const double most = near * (points_[i].radius + points_[j].radius) + skin_;
      if (distance2 < most * most && may_touch(points_[i], points_[j])) partner_.push_back(j);
    });
    std::sort(partner_.begin() + static_cast<std::ptrdiff_t>(first_partner_[i]), partner_.end(),
              [&](int a, int b) { return points_[a].number < points_[b].number; });
    first_partner_.push_back(partner_.size());
  }
}

template <int D>
void PairContacts<D>::make_list(const Particles<D>& particles) {
  const Boxes boxes(comm_, particles);
  choose_own(particles, boxes);
  fetch_copies(particles, boxes);
  refresh(particles);
  find_partners();
  for (int c = 0; c < D; ++c) std::copy_n(particles.displacement.component(c), particles.slots, listed_at_.component(c));
  ++lists_made_;
  list_is_stale_ = false;
}

template struct PairContacts<2>::Point;
template struct PairContacts<3>::Point;
template typename PairContacts<2>::Point PairContacts<2>::point_of(const Particles<2>&, int) const;
template typename PairContacts<3>::Point PairContacts<3>::point_of(const Particles<3>&, int) const;
template bool PairContacts<2>::may_touch(const Point&, const Point&) const;
template bool PairContacts<3>::may_touch(const Point&, const Point&) const;
template void PairContacts<2>::choose_own(const Particles<2>&, const Boxes&);
template void PairContacts<3>::choose_own(const Particles<3>&, const Boxes&);
template std::vector<std::vector<int>> PairContacts<2>::points_for_ranks(const Particles<2>&, const Boxes&) const;
template std::vector<std::vector<int>> PairContacts<3>::points_for_ranks(const Particles<3>&, const Boxes&) const;
template void PairContacts<2>::fetch_copies(const Particles<2>&, const Boxes&);
template void PairContacts<3>::fetch_copies(const Particles<3>&, const Boxes&);
template void PairContacts<2>::find_partners();
template void PairContacts<3>::find_partners();
template void PairContacts<2>::make_list(const Particles<2>&);
template void PairContacts<3>::make_list(const Particles<3>&);

}  // namespace sinew
