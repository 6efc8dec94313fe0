#include <algorithm>
#include <sinew/particles/order.hpp>
#include <sinew/particles/particles.hpp>

namespace sinew {

template <int D>
Point Particles<D>::reference(int slot) const {
  Point p;
  for (int c = 0; c < D; ++c) p[c] = position.at(c, slot);
  return p;
}

template <int D>
Point Particles<D>::current(int slot) const {
  Point p = reference(slot);
  for (int c = 0; c < D; ++c) p[c] += displacement.at(c, slot);
  return p;
}

template <int D>
int Particles<D>::body_of(int slot) const {
  int b = 0;
  while (slot >= bodies[b].end) ++b;
  return b;
}

template <int D>
int Particles<D>::block_of(int slot) const {
  const auto after =
      std::upper_bound(blocks.begin(), blocks.end(), slot, [](int s, const BlockRange& block) { return s < block.begin; });
  return static_cast<int>(after - blocks.begin()) - 1;
}

template <int D>
std::size_t Particles<D>::bytes() const {
  return position.bytes() + displacement.bytes() + velocity.bytes() + acceleration.bytes() + volume.bytes() + mass.bytes() +
         (user_index.size() + slot_of.size()) * sizeof(int);
}

template <int D>
Particles<D> make_particles(const std::vector<BodyPoints>& bodies, double thickness) {
  Particles<D> p;
  for (const BodyPoints& body : bodies) {
    const int count = static_cast<int>(body.points->size());
    const int padded = whole_slices(count);
    p.bodies.push_back({body.name, p.slots, p.slots + padded, count, body.spacing, body.density});
    p.slots += padded;
    p.count += count;
  }
  const auto slots = static_cast<std::size_t>(p.slots);
  p.position = p.displacement = p.velocity = p.acceleration = VectorField<D>(slots);
  p.volume = AlignedArray<double>(slots);
  p.mass = AlignedArray<double>(slots);
  p.user_index.assign(slots, -1);
  p.slot_of.reserve(p.count);

  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const PointSet& points = *bodies[b].points;
    const BodyRange& range = p.bodies[b];
    const int first = static_cast<int>(p.slot_of.size());
    p.slot_of.resize(first + range.count);
    const BlockOrder order = block_order(points.position, bodies[b].spacing, D, largest_block);
    for (int begin = 0; const int end : order.block_end) {
      p.blocks.push_back({static_cast<int>(b), range.begin + begin, range.begin + end});
      begin = end;
    }
    for (int slot = range.begin; slot < range.end; ++slot) {
      const bool padding = slot - range.begin >= range.count;
      const int point = order.number[padding ? range.count - 1 : slot - range.begin];
      for (int c = 0; c < D; ++c) p.position.at(c, slot) = points.position[point][c];
      if (padding) continue;
      p.volume[slot] = points.volume[point];
      p.mass[slot] = bodies[b].density * thickness * points.volume[point];
      p.user_index[slot] = first + point;
      p.slot_of[first + point] = slot;
    }
  }
  return p;
}

template struct Particles<2>;
template struct Particles<3>;
template Particles<2> make_particles<2>(const std::vector<BodyPoints>&, double);
template Particles<3> make_particles<3>(const std::vector<BodyPoints>&, double);

}  // namespace sinew
