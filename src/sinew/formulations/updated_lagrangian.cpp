#include <sinew/formulations/updated_lagrangian.hpp>
#include <sinew/neighbors/eight_of_block.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {

template <int D>
UpdatedLagrangian<D>::UpdatedLagrangian(const Particles<D>& particles, BlockPairs<D> pairs, UpdatedLagrangianOptions options,
                                        const Comm& comm, Halo halo)
    : Formulation<D>(comm, std::move(pairs), std::move(halo),
                     HistoryStore(particles.blocks, history_numbers<D>(options.materials, options.damages, false)),
                     options.thickness),
      options_(std::move(options)),
      radius_(particles.slots),
      listed_at_(particles.slots),
      deformation_(particles.slots),
      gradient_(particles.slots),
      inverse_length2_(particles.slots),
      speed2_(particles.slots) {
  std::fill(radius_.begin(), radius_.end(), options_.radius);
  for (int slot = 0; slot < particles.slots; ++slot)
    if (particles.volume[slot] > 0.0) inverse_length2_[slot] = std::pow(particles.volume[slot], -2.0 / D);
  if (options_.corrected) correction_ = MatrixField<D>(particles.slots);
  if (options_.shear) pull_ = held_ = VectorField<D>(particles.slots);
  if (options_.shear) modulus_ = left_ = AlignedArray<double>(particles.slots);
  if (options_.viscosity) viscous_power_ = viscous_rate_ = AlignedArray<double>(particles.slots);
  if (options_.repels()) repulsive_power_ = AlignedArray<double>(particles.slots);
  make_room(particles, particles.slots);
}

/// Of the fields by point, with what never changes of the own ones.
template <int D>
void UpdatedLagrangian<D>::make_room(const Particles<D>& particles, int points) {
  points_ = points;
  numbers_.resize(points);
  std::copy_n(particles.user_index.data(), particles.slots, numbers_.begin());
  mass_ = AlignedArray<double>(points);
  for (int slot = 0; slot < particles.slots; ++slot) mass_[slot] = particles.mass[slot] / thickness_;
  places_ = VectorField<D>(points);
  motion_ = VectorField<2 * D + 1>(points);
  stress_ = VectorField<D * D + 1>(points);
  if (options_.repels()) repulsion_ = VectorField<D*(D + 1) / 2>(points);
  if (options_.explains()) explained_ = VectorField<D * D + 1>(points);
}

/// F of the initial displacements, as the corrected gradient in the reference configuration.
template <int D>
void UpdatedLagrangian<D>::begin(Particles<D>& particles) {
  halo_.displacements.start(particles.displacement);
  halo_.displacements.finish();
  const auto radial = [&](const Vec<double, D>& X) {
    const double r = norm(X);
    return std::visit([&](const auto& kernel) { return -kernel.template slope<D>(r, options_.radius) / r; }, options_.kernel);
  };
  for (const BlockRange& block : particles.blocks)
    for (int slot = block.begin; slot < block.end; ++slot) {
      if (particles.user_index[slot] < 0) continue;
      Mat<double, D> S, M;
      for (int j : pairs_.neighbors(slot, particles)) {
        const Vec<double, D> X = particles.position[j] - particles.position[slot];
        const double weight = particles.volume[j] * radial(X);
        S += outer(particles.displacement[j] - particles.displacement[slot], weight * X);
        M += outer(X, weight * X);
      }
      const bool enough = determinant(M) > 0.02 * std::pow(trace(M) / D, D);  // as in the sweeps, see correction_of
      const Mat<double, D> G = enough ? S * inverse(M) : Mat<double, D>{};
      for (int c = 0; c < D * D; ++c) deformation_.at(c, slot) = G[c / D][c % D];
    }
}

template <int D>
void UpdatedLagrangian<D>::settle(Particles<D>& particles) {
  this->settle_histories(options_.materials);
  begin(particles);
  listed_ = false;
}

template <int D>
FieldsToSave<D> UpdatedLagrangian<D>::fields_to_save() {
  FieldsToSave<D> fields{{{"skin", &skin_}, {"steps_of_list", &steps_of_list_}},
                         {{"listed_at", &listed_at_}},
                         {{"integrated_gradient", &deformation_}}};
  if (options_.shear) fields.vectors.push_back({"held_shear_force", &held_});
  return fields;
}

template <int D>
void UpdatedLagrangian<D>::restored(Particles<D>& particles) {
  make_list(particles, listed_at_);
}

template <int D>
Vec<double, D> UpdatedLagrangian<D>::toward_neighbors(const Particles<D>& particles, int slot) const {
  Vec<double, D> sum;
  for (int j : pairs_.neighbors(slot, particles)) {
    const Vec<double, D> X = particles.position[j] - particles.position[slot];
    const double r = norm(X);
    sum += std::visit([&](const auto& k) { return -particles.volume[j] * k.template slope<D>(r, options_.radius) / r; },
                      options_.kernel) *
           X;
  }
  return sum;
}

// --- neighbors -----------------------------------------------------------------------------------------------

template <int D>
bool UpdatedLagrangian<D>::moved_too_far(const Particles<D>& particles) {
  const double skin = skin_ * options_.radius;
  return comm_.maximum(farthest_move2(particles, listed_at_, farthest2_)) > 0.25 * skin * skin;
}

/// A step costs in proportion to (1 + skin)^D, a list is made every skin / (its change in a step) steps: so much that both together cost least.
template <int D>
void UpdatedLagrangian<D>::choose_skin() {
  constexpr double least = 0.01, most = 0.25, cost_of_list = 0.35;  // over D times that of the sweeps, measured
  const double change = skin_ / std::max(steps_of_list_, 1.0);
  skin_ = std::clamp(std::sqrt(cost_of_list * change), std::max(least, 0.5 * skin_), std::min(most, 2.0 * skin_));
}

/// Makes the list anew if two particles may have come to each other unseen, each having moved by half the skin.
template <int D>
void UpdatedLagrangian<D>::find_neighbors(const Particles<D>& particles) {
  if (listed_ && !moved_too_far(particles)) {
    ++steps_of_list_;
    return;
  }
  if (listed_) choose_skin();
  steps_of_list_ = 1;
  for_each_piece(particles.slots, [&](int begin, int end) {
    for (int c = 0; c < D; ++c)
      std::copy(particles.displacement.component(c) + begin, particles.displacement.component(c) + end,
                listed_at_.component(c) + begin);
  });
  make_list(particles, listed_at_);
}

/// Where the own particles are at these displacements.
template <int D>
void UpdatedLagrangian<D>::place_own(const Particles<D>& particles, const VectorField<D>& displacement) {
  for_each_piece(particles.slots, [&](int begin, int end) {
    for (int c = 0; c < D; ++c)
      for (int slot = begin; slot < end; ++slot) places_.at(c, slot) = particles.position.at(c, slot) + displacement.at(c, slot);
  });
}

/// At these displacements. A process alone allocates nothing here but for more neighbors than there have ever been.
template <int D>
void UpdatedLagrangian<D>::make_list(const Particles<D>& particles, const VectorField<D>& displacement) {
  const double reach = options_.radius * (1.0 + skin_);
  place_own(particles, displacement);
  if (comm_.alone()) {
    neighbors_.build(places_, numbers_, particles.slots, reach, grid_of(particles, reach));
  } else {
    const MovingBoxes<D> boxes(comm_, particles, places_);
    const auto all = static_cast<double>(comm_.sum(long{particles.count}));
    const CopyPlan plan = plan_copies(comm_, boxes.slots_for_ranks(comm_, particles, places_, reach), particles.slots);
    if (particles.slots + plan.copies != points_) {
      make_room(particles, particles.slots + plan.copies);
      place_own(particles, displacement);
    }
    fetch_copies(plan);
    comm_.together([&] {
      neighbors_.build(places_, numbers_, particles.slots, reach, MovingGrid<D>(reach, boxes.low(), boxes.high(), all));
    });
  }
  if (walls_.any()) walls_.find_pairs(neighbors_, numbers_);
  make_rows();
  listed_ = true;
  ++lists_made_;
}

/// Of a process alone.
template <int D>
MovingGrid<D> UpdatedLagrangian<D>::grid_of(const Particles<D>& particles, double reach) const {
  Vec<double, D> low, high;
  for (int c = 0; c < D; ++c) low[c] = infinity, high[c] = -infinity;
  for (int slot = 0; slot < particles.slots; ++slot)
    for (int c = 0; c < D && numbers_[slot] >= 0; ++c) {
      low[c] = std::min(low[c], places_.at(c, slot));
      high[c] = std::max(high[c], places_.at(c, slot));
    }
  return MovingGrid<D>(reach, low, high, particles.count);
}

/// Numbers, masses and positions of the copies; later their motion and stress travel in every step.
template <int D>
void UpdatedLagrangian<D>::fetch_copies(const CopyPlan& plan) {
  constexpr int width = D + 2;
  std::vector<double> rows;
  for (const Parcel& parcel : plan.send)
    for (const Stretch& stretch : parcel.stretches)
      for (int slot = stretch.begin; slot < stretch.begin + stretch.length; ++slot) {
        for (int c = 0; c < D; ++c) rows.push_back(places_.at(c, slot));
        rows.insert(rows.end(), {static_cast<double>(numbers_[slot]), mass_[slot]});
      }
  rows = comm_.exchange_rows(std::move(rows), width, plan.sent, plan.received);
  int point = points_ - plan.copies;
  for (auto row = rows.begin(); row != rows.end(); row += width, ++point) {
    for (int c = 0; c < D; ++c) places_.at(c, point) = row[c];
    numbers_[point] = static_cast<int>(row[D]);
    mass_[point] = row[D + 1];
  }
  const auto exchange = [&](int components) {
    return Exchange(comm_, components, VectorField<D>::stride_of(points_), plan.send, plan.receive);
  };
  motion_exchange_ = exchange(2 * D + 1);
  stress_exchange_ = exchange(D * D + 1);
  if (options_.repels()) repulsion_exchange_ = exchange(D * (D + 1) / 2);
  if (options_.explains()) explained_exchange_ = exchange(D * D + 1);
}

/// One more than there are places: a particle that is far from all others and has no mass.
template <int D>
void UpdatedLagrangian<D>::make_rows() {
  constexpr double far_away = 1e30;
  const std::size_t count = static_cast<std::size_t>(neighbors_.places()) + 1;
  if (motion_rows_.size() < count * moving_row) {
    const std::size_t room = count + count / 16;
    motion_rows_ = AlignedArray<double>(room * moving_row);
    stress_rows_ = AlignedArray<double>(room * moving_row);
    if (options_.has_rest()) rest_rows_ = AlignedArray<double>(room * rest_row);
  }
  const std::size_t last = count - 1;
  std::fill_n(motion_rows_.data() + last * moving_row, moving_row, 0.0);
  for (int c = 0; c < D; ++c) motion_rows_[last * moving_row + c] = far_away;
  std::fill_n(stress_rows_.data() + last * moving_row, moving_row, 0.0);
  if (options_.has_rest()) std::fill_n(rest_rows_.data() + last * rest_row, rest_row, 0.0);
}

template <int D>
std::vector<std::string> UpdatedLagrangian<D>::warnings() const {
  std::vector<std::string> warnings;
  if (!options_.repels() && !options_.shear)
    warnings.emplace_back(
        "conventional SPH on the current configuration tears under tension, and nothing is set against it "
        "(stabilization: non_nested_shear, artificial_stress or artificial_pressure).");
  if (options_.explains() && !options_.viscosity)
    warnings.emplace_back(
        "the objective form of non_nested_shear grows noise in long runs unless something damps it (add artificial_viscosity, "
        "alpha = 0.1 to 0.2).");
  return warnings;
}

template <int D>
std::string UpdatedLagrangian<D>::advice() const {
  if (options_.shear) return "too little dissipation (try artificial_viscosity, or a larger one)";
  return "the tensile instability (try stabilization = [{ model = \"non_nested_shear\" }])";
}

template <int D>
std::size_t UpdatedLagrangian<D>::bytes() const {
  std::size_t bytes = pairs_.bytes() + history_.bytes() + neighbors_.bytes();
  for (const AlignedArray<double>* array : {&radius_, &mass_, &motion_rows_, &stress_rows_, &rest_rows_, &modulus_, &left_,
                                            &viscous_power_, &viscous_rate_, &repulsive_power_, &inverse_length2_, &speed2_})
    bytes += array->bytes();
  bytes += motion_.bytes() + stress_.bytes() + repulsion_.bytes() + explained_.bytes();
  return bytes + listed_at_.bytes() + deformation_.bytes() + gradient_.bytes() + correction_.bytes() + pull_.bytes() +
         held_.bytes();
}

template class UpdatedLagrangian<2>;
template class UpdatedLagrangian<3>;

}  // namespace sinew
