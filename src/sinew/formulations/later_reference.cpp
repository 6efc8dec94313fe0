#include <sinew/core/params.hpp>
#include <sinew/formulations/later_reference.hpp>
#include <sinew/neighbors/eight_of_block.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {

template <int D>
LaterReference<D>::LaterReference(Arrangement<D> whole, std::vector<int> owner, const Particles<D>& particles, double threshold,
                                  double thickness)
    : whole_(std::move(whole)),
      owner_(std::move(owner)),
      threshold_(threshold),
      thickness_(thickness),
      shift_(particles.slots),
      earlier_(particles.slots),
      first_volume_(particles.slots),
      looked_at_(particles.slots) {
  std::copy_n(particles.volume.data(), particles.slots, first_volume_.begin());
}

// --- when ----------------------------------------------------------------------------------------------------

/// The largest | |x| / |X| - 1 | of the pairs of this rank, and with that how far particles may move before one reaches the threshold.
template <int D>
double LaterReference<D>::longest(const Particles<D>& here, const BlockPairs<D>& pairs) {
  const auto count = static_cast<int>(pairs.blocks.all.size());
  scratch_.assign(2 * static_cast<std::size_t>(count), 0.0);
#pragma omp parallel for schedule(dynamic, 1) if (here.slots >= fewest_for_threads)
  for (int b = 0; b < count; ++b) {
    double longest2 = 1.0, shortest2 = 1.0, nearest2 = infinity;
    pairs.for_each_pair(pairs.blocks.all[b], [&](int i, int j) {
      const Vec<double, D> X = here.position[j] - here.position[i];
      const Vec<double, D> x = X + (here.displacement[j] - here.displacement[i]);
      const double before2 = dot(X, X), ratio2 = dot(x, x) / before2;
      longest2 = std::max(longest2, ratio2);
      shortest2 = std::min(shortest2, ratio2);
      nearest2 = std::min(nearest2, before2);
    });
    scratch_[2 * b] = std::max(std::sqrt(longest2) - 1.0, 1.0 - std::sqrt(shortest2));
    scratch_[2 * b + 1] = std::sqrt(nearest2);
  }
  double most = 0.0, nearest = infinity;
  for (int b = 0; b < count; ++b) {
    most = std::max(most, scratch_[2 * b]);
    nearest = std::min(nearest, scratch_[2 * b + 1]);
  }
  constexpr double rounding = 0.999;
  room_ = std::isfinite(nearest) ? rounding * 0.5 * nearest * (threshold_ - most) : infinity;
  return most;
}

template <int D>
bool LaterReference<D>::is_due(const Comm& comm, const Particles<D>& here, const BlockPairs<D>& pairs) {
  const double moved2 = room_ > 0.0 ? farthest_move2(here, looked_at_, scratch_) : infinity;
  const bool look = !(moved2 < room_ * room_);
  if (comm.maximum(look ? 1.0 : 0.0) == 0.0) return false;
  const double most = comm.maximum(longest(here, pairs));
  for (int c = 0; c < D; ++c) std::copy_n(here.displacement.component(c), here.slots, looked_at_.component(c));
  return most >= threshold_;
}

// --- what ----------------------------------------------------------------------------------------------------

template <int D>
Particles<D>& LaterReference<D>::follow(Particles<D>& particles, bool with_velocities) {
  if (!renewed()) return particles;
  for_each_piece(particles.slots, [&](int begin, int end) {
    for (int c = 0; c < D; ++c) {
      const double* __restrict u = particles.displacement.component(c), * __restrict shift = shift_.component(c);
      double* __restrict since = here_.displacement.component(c);
      for (int slot = begin; slot < end; ++slot) since[slot] = u[slot] - shift[slot];
      if (with_velocities)
        std::copy(particles.velocity.component(c) + begin, particles.velocity.component(c) + end,
                  here_.velocity.component(c) + begin);
    }
  });
  return here_;
}

/// Places and volumes of the own particles in the whole.
template <int D>
void LaterReference<D>::place_own(const Particles<D>& particles) {
  for (const BlockRange& block : particles.blocks) {
    const int to = whole_.blocks[block.number].begin - block.begin;
    for (int slot = block.begin; slot < block.end; ++slot) {
      Mat<double, D> F = Mat<double, D>::identity();
      for (int c = 0; c < D * D; ++c) F[c / D][c % D] += earlier_.at(c, slot);
      whole_.position.set(slot + to, particles.position[slot] + shift_[slot]);
      whole_.volume[slot + to] = first_volume_[slot] * determinant(F);
    }
  }
}

/// Those of others, and of the padding, which stands on the last particle.
template <int D>
void LaterReference<D>::place_others(const Comm& comm) {
  if (!comm.alone()) {
    std::vector<double> rows;
    const auto each = [&](int rank, auto&& use) {
      for (const BlockRange& block : whole_.blocks)
        for (int slot = block.begin; slot < block.end && owner_[block.number] == rank; ++slot) use(slot);
    };
    each(comm.rank(), [&](int slot) {
      for (int c = 0; c < D; ++c) rows.push_back(whole_.position.at(c, slot));
      rows.push_back(whole_.volume[slot]);
    });
    rows = comm.gather_all(rows);
    auto next = rows.begin();
    for (int rank = 0; rank < comm.size(); ++rank)
      each(rank, [&](int slot) {
        for (int c = 0; c < D; ++c) whole_.position.at(c, slot) = *next++;
        whole_.volume[slot] = *next++;
      });
  }
  for (const BodyRange& body : whole_.bodies)
    for (int slot = body.begin + body.count; slot < body.end; ++slot) whole_.position.set(slot, whole_.position[slot - 1]);
}

template <int D>
SharedPairs<D> LaterReference<D>::adopt_again(const Comm& comm, const Particles<D>& particles,
                                              const std::vector<double>& radius) {
  place_own(particles);
  place_others(comm);
  std::vector<double> of_whole(whole_.slots, 0.0);
  for (const BlockRange& block : particles.blocks)
    std::copy_n(radius.begin() + block.begin, block.end - block.begin, of_whole.begin() + whole_.blocks[block.number].begin);
  SharedPairs<D> shared = share_pairs(comm, whole_, owner_, of_whole, false);
  here_ = Particles<D>(part_of(whole_, shared.share), thickness_, shared.share.copied());
  std::copy_n(particles.mass.begin(), particles.slots, here_.mass.begin());
  looked_at_.clear();
  room_ = -1.0;
  return shared;
}

template <int D>
SharedPairs<D> LaterReference<D>::adopt(const Comm& comm, const Particles<D>& particles, const std::vector<double>& radius) {
  for (int c = 0; c < D; ++c) std::copy_n(particles.displacement.component(c), particles.slots, shift_.component(c));
  ++updates_;
  return adopt_again(comm, particles, radius);
}

template <int D>
std::size_t LaterReference<D>::bytes() const {
  return whole_.position.bytes() + whole_.volume.bytes() + shift_.bytes() + earlier_.bytes() + first_volume_.bytes() +
         here_.bytes() + looked_at_.bytes();
}

template class LaterReference<2>;
template class LaterReference<3>;

}  // namespace sinew
