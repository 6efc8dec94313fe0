#include <sinew/contact/pair_contacts.hpp>
#include <sinew/contact/radius.hpp>
#include <sinew/neighbors/eight_of_block.hpp>

namespace sinew {

template <int D>
PairContacts<D>::PairContacts(ContactTable table, const Particles<D>& particles, const std::vector<double>& support_radius,
                              double thickness, const Comm& comm)
    : table_(std::move(table)),
      comm_(comm),
      thickness_(thickness) {
  if (!any()) return;
  radius_ = contact_radii(particles);
  support_ = AlignedArray<double>(support_radius.size());
  std::copy(support_radius.begin(), support_radius.end(), support_.begin());
  double largest_radius = 0.0, smallest_radius = infinity;
  for (const BlockRange& block : particles.blocks)
    for (int slot = block.begin; slot < block.end && table_.touches(block.body); ++slot) {
      largest_radius = std::max(largest_radius, radius_[slot]);
      smallest_radius = std::min(smallest_radius, radius_[slot]);
    }
  largest_radius = comm_.maximum(largest_radius);
  skin_ = -comm_.maximum(-smallest_radius);
  reach_ = near * 2.0 * largest_radius + skin_;
  listed_at_ = VectorField<D>(particles.slots);
}

/// Whether two particles may have come to each other unseen: each has moved by half the skin.
template <int D>
bool PairContacts<D>::moved_too_far(const Particles<D>& particles) {
  return comm_.maximum(farthest_move2(particles, listed_at_, farthest2_)) > 0.25 * skin_ * skin_;
}

template <int D>
Vec<double, D> PairContacts<D>::place(int point) const {
  Vec<double, D> x;
  for (int c = 0; c < D; ++c) x[c] = motion_.at(c, point);
  return x;
}

template <int D>
Vec<double, D> PairContacts<D>::velocity(int point) const {
  Vec<double, D> v;
  for (int c = 0; c < D; ++c) v[c] = motion_.at(D + c, point);
  return v;
}

/// Places and velocities of the own points, then those of the copies.
template <int D>
void PairContacts<D>::refresh(const Particles<D>& particles) {
  for (std::size_t k = 0; k < slots_.size(); ++k)
    for (int c = 0; c < D; ++c) {
      motion_.at(c, k) = particles.position.at(c, slots_[k]) + particles.displacement.at(c, slots_[k]);
      motion_.at(D + c, k) = particles.velocity.at(c, slots_[k]);
    }
  exchange_.start(motion_);
  exchange_.finish();
}

template <int D>
void PairContacts<D>::push_block(int block, double dt, VectorField<D>& forces, VectorField<D>& contact_forces,
                                 ContactSums& sums) const {
  double power = 0.0;
  for (int i = first_of_block_[block]; i < first_of_block_[block + 1]; ++i) {
    const Point& own = points_[i];
    const Vec<double, D> x = place(i), v = velocity(i);
    Vec<double, D> force;
    double rate2 = 0.0;
    for (std::size_t n = first_partner_[i]; n < first_partner_[i + 1]; ++n) {
      const int j = partner_[n];
      const Point& other = points_[j];
      const Vec<double, D> apart = x - place(j);
      const double distance2 = dot(apart, apart), touching = own.radius + other.radius;
      if (distance2 > near * near * touching * touching) continue;
      const double distance = std::sqrt(distance2);
      const Vec<double, D> normal = (1.0 / (distance + 1e-300)) * apart, slip = v - velocity(j);
      const double mass = 1.0 / (own.inverse_mass + other.inverse_mass), coming = -dot(slip, normal);
      const auto contact = table_.laws[table_.law(own.body, other.body)].force(
          Touch<double, D>{touching - distance, normal, slip, own.radius * other.radius / touching,
                           D == 2 ? thickness_ / touching : 1.0, mass},
          dt);
      force += contact.force;
      sums.energy += 0.5 * contact.energy;  // the other half belongs to the other particle
      power += 0.5 * contact.dissipated;
      rate2 += contact_rate2(contact, coming, mass);
      sums.approach = std::max(sums.approach, coming / touching);
      sums.depth = std::max(sums.depth, 1.0 - distance / touching);
    }
    sums.rate2 = std::max(sums.rate2, rate2);
    for (int c = 0; c < D; ++c) {
      forces.at(c, slots_[i]) += force[c];
      contact_forces.at(c, slots_[i]) += force[c];
    }
  }
  sums.dissipated += dt * power;
}

template <int D>
void PairContacts<D>::push(const Particles<D>& particles, double dt, VectorField<D>& forces, VectorField<D>& contact_forces,
                           std::vector<ContactSums>& sums) {
  if (list_is_stale_ || moved_too_far(particles))
    make_list(particles);
  else
    refresh(particles);
  const auto blocks = static_cast<int>(particles.blocks.size());
#pragma omp parallel for schedule(dynamic, 1) if (partner_.size() > 4096)
  for (int b = 0; b < blocks; ++b) push_block(b, dt, forces, contact_forces, sums[b]);
}

template <int D>
typename PairContacts<D>::Overlap PairContacts<D>::overlap(double allowed) const {
  Overlap overlap;
  for (std::size_t i = 0; i < slots_.size(); ++i)
    for (std::size_t n = first_partner_[i]; n < first_partner_[i + 1]; ++n) {
      const int j = partner_[n];
      if (points_[i].body == points_[j].body) continue;
      const double depth = 1.0 - norm(place(i) - place(j)) / (points_[i].radius + points_[j].radius);
      overlap.pairs += depth > allowed;
      if (depth <= overlap.most) continue;
      overlap.most = depth;
      overlap.body = std::min(points_[i].body, points_[j].body);
      overlap.other = std::max(points_[i].body, points_[j].body);
    }
  const double most = comm_.maximum(overlap.most),
               pair = overlap.most == most ? overlap.body * table_.bodies + overlap.other : -1;
  const auto named = static_cast<int>(comm_.maximum(pair));
  overlap.most = most;
  overlap.pairs = comm_.sum(overlap.pairs);
  if (named >= 0) overlap.body = named / table_.bodies, overlap.other = named % table_.bodies;
  return overlap;
}

template <int D>
std::size_t PairContacts<D>::bytes() const {
  return listed_at_.bytes() + motion_.bytes() + radius_.bytes() + support_.bytes() + points_.size() * sizeof(Point) +
         partner_.size() * sizeof(int) + first_partner_.size() * sizeof(std::size_t);
}

template class PairContacts<2>;
template class PairContacts<3>;

}  // namespace sinew
