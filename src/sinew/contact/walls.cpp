#include <sinew/contact/radius.hpp>
#include <sinew/contact/walls.hpp>
#include <sinew/neighbors/eight_of_block.hpp>

namespace sinew {

template <int D>
Walls<D>::Walls(std::vector<WallCondition> walls, const Particles<D>& particles, double thickness) : thickness_(thickness) {
  if (!walls.empty()) radius_ = contact_radii(particles);
  for (WallCondition& wall : walls)
    walls_.push_back({std::move(wall), {}, {}, {}, std::vector<Vec<double, D>>(particles.blocks.size())});
}

template <int D>
void Walls<D>::move(Wall& wall, double t, double dt) const {
  using Motion = WallCondition::Motion;
  const WallCondition& c = wall.condition;
  for (int i = 0; i < D && c.motion != Motion::none; ++i) {
    const double before = wall.offset[i];
    wall.offset[i] =
        c.motion == Motion::displacement ? c.function[i]({}, {}, t) : before + dt * c.function[i]({}, {}, t - 0.5 * dt);
    wall.moved[i] = wall.offset[i] - before;
    wall.velocity[i] = dt > 0.0 ? wall.moved[i] / dt : 0.0;
  }
}

template <int D>
template <class Shape>
void Walls<D>::push_block(Wall& wall, const Shape& shape, const Particles<D>& particles, int block, const Push& push,
                          ContactSums& sums) {
  HertzContact law = wall.condition.law;
  law.stiffness = wall.condition.stiffness[particles.blocks[block].body];
  Vec<Pack, D> offset, velocity, total;
  for (int c = 0; c < D; ++c) offset[c] = Pack(wall.offset[c]), velocity[c] = Pack(wall.velocity[c]);
  Pack energy, power, rate2, approach, deepest;
  for_each_eight(particles.blocks[block], [&](const EightOfBlock& eight) {
    const Pack mass = eight(particles.mass.data());
    const auto real = mass > Pack(0.0);  // the rest is padding, or beyond the block
    const Pack radius = select(real, eight(radius_.data()), Pack(1.0));
    const Gap<Pack, D> gap = shape.gap(eight(particles.position) + eight(particles.displacement) - offset);
    const auto near = (gap.distance < 2.0 * radius) & real;
    if (!any(near)) return;
    const Vec<Pack, D> v = eight(particles.velocity) - velocity;
    const Pack depth = select(real, radius - gap.distance, Pack(-1.0));
    const Pack width = D == 2 ? Pack(thickness_) / (2.0 * radius) : Pack(1.0);
    const auto contact = law.force(Touch<Pack, D>{depth, gap.normal, v, radius, width, mass}, push.dt);
    eight.add(contact.force, push.forces);
    eight.add(contact.force, push.contact_forces);
    total += contact.force;
    energy += contact.energy;
    power += contact.dissipated;
    const Pack coming = -dot(v, gap.normal);
    rate2 = max(rate2, select(near, contact_rate2(contact, coming, mass), Pack(0.0)));
    deepest = max(deepest, depth / (2.0 * radius));
    approach = max(approach, select(near, coming / radius, Pack(0.0)));
  });
  Vec<double, D>& force = wall.force[block];
  for (int c = 0; c < D; ++c) {
    const double now = sum(total[c]);
    sums.work += 0.5 * (force[c] + now) * wall.moved[c] * (push.dt > 0.0);
    force[c] = now;
  }
  sums.energy += sum(energy);
  sums.dissipated += push.dt * sum(power);
  sums.rate2 = std::max(sums.rate2, largest(rate2));
  sums.approach = std::max(sums.approach, largest(approach));
  sums.depth = std::max(sums.depth, largest(deepest));
}

template <int D>
void Walls<D>::push(const Particles<D>& particles, double t, double dt, VectorField<D>& forces, VectorField<D>& contact_forces,
                    std::vector<ContactSums>& sums) {
  const auto blocks = static_cast<int>(particles.blocks.size());
  for (Wall& wall : walls_) {
    move(wall, t, dt);
    std::visit(
        [&](const auto& shape) {
#pragma omp parallel for schedule(dynamic, 1) if (particles.slots >= fewest_for_threads)
          for (int b = 0; b < blocks; ++b)
            if (wall.condition.stiffness[particles.blocks[b].body] > 0.0)
              this->push_block(wall, shape, particles, b, {forces, contact_forces, dt}, sums[b]);
        },
        wall.condition.shape);
  }
}

template <int D>
int Walls<D>::index_of(const std::string& name) const {
  for (int w = 0; w < count(); ++w)
    if (walls_[w].condition.name == name) return w;
  return -1;
}

template <int D>
typename Walls<D>::Overlap Walls<D>::overlap(int index, const Particles<D>& particles) const {
  const Wall& wall = walls_[index];
  Overlap overlap;
  for (const BlockRange& block : particles.blocks)
    for (int slot = block.begin; slot < block.end && wall.condition.stiffness[block.body] > 0.0; ++slot) {
      if (particles.mass[slot] <= 0.0) continue;
      const Vec<double, D> x = particles.position[slot] + particles.displacement[slot] - wall.offset;
      const double distance = std::visit([&](const auto& shape) { return shape.gap(x).distance; }, wall.condition.shape);
      overlap.most = std::max(overlap.most, 1.0 - distance / radius_[slot]);
      overlap.behind += distance < 0.0;
    }
  return overlap;
}

template <int D>
std::vector<double> Walls<D>::offsets() const {
  std::vector<double> all;
  for (const Wall& wall : walls_) all.insert(all.end(), wall.offset.c, wall.offset.c + D);
  return all;
}

template <int D>
std::vector<double> Walls<D>::block_forces(int block) const {
  std::vector<double> all;
  for (const Wall& wall : walls_) all.insert(all.end(), wall.force[block].c, wall.force[block].c + D);
  return all;
}

template <int D>
void Walls<D>::restore(const std::vector<double>& offsets, const std::vector<std::vector<double>>& block_forces) {
  for (int w = 0; w < count(); ++w)
    for (int c = 0; c < D; ++c) {
      walls_[w].offset[c] = offsets[D * w + c];
      for (std::size_t b = 0; b < block_forces.size(); ++b) walls_[w].force[b][c] = block_forces[b][D * w + c];
    }
}

template class Walls<2>;
template class Walls<3>;

}  // namespace sinew
