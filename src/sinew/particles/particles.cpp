#include <algorithm>
#include <sinew/particles/order.hpp>
#include <sinew/particles/particles.hpp>

namespace sinew {

template <int D>
Point Arrangement<D>::reference(int slot) const {
  Point p;
  for (int c = 0; c < D; ++c) p[c] = position.at(c, slot);
  return p;
}

template <int D>
int Arrangement<D>::body_of(int slot) const {
  int b = 0;
  while (slot >= bodies[b].end) ++b;
  return b;
}

template <int D>
int Arrangement<D>::block_of(int slot) const {
  const auto after =
      std::upper_bound(blocks.begin(), blocks.end(), slot, [](int s, const BlockRange& block) { return s < block.begin; });
  return static_cast<int>(after - blocks.begin()) - 1;
}

template <int D>
std::vector<int> Arrangement<D>::block_numbers() const {
  std::vector<int> numbers;
  for (const BlockRange& block : blocks) numbers.push_back(block.number);
  return numbers;
}

template <int D>
Particles<D>::Particles(Arrangement<D> arrangement, double thickness, int copies_)
    : Arrangement<D>(std::move(arrangement)),
      copies(copies_),
      displacement(static_cast<std::size_t>(this->slots) + copies_),
      velocity(static_cast<std::size_t>(this->slots) + copies),
      acceleration(this->slots),
      mass(this->slots) {
  for (const BodyRange& body : this->bodies)
    for (int slot = body.begin; slot < body.end; ++slot) mass[slot] = body.density * thickness * this->volume[slot];
}

template <int D>
Point Particles<D>::current(int slot) const {
  Point p = this->reference(slot);
  for (int c = 0; c < D; ++c) p[c] += displacement.at(c, slot);
  return p;
}

template <int D>
std::size_t Particles<D>::bytes() const {
  return this->position.bytes() + displacement.bytes() + velocity.bytes() + acceleration.bytes() + this->volume.bytes() +
         mass.bytes() + (this->user_index.size() + this->slot_of.size()) * sizeof(int);
}

template <int D>
Arrangement<D> arrange(const std::vector<BodyPoints>& bodies, int block_size) {
  Arrangement<D> all;
  for (const BodyPoints& body : bodies) {
    const int count = static_cast<int>(body.points->size());
    const int padded = whole_slices(count);
    all.bodies.push_back({body.name, all.slots, all.slots + padded, count, body.spacing, body.density});
    all.slots += padded;
    all.count += count;
  }
  const auto slots = static_cast<std::size_t>(all.slots);
  all.position = VectorField<D>(slots);
  all.volume = AlignedArray<double>(slots);
  all.user_index.assign(slots, -1);
  all.slot_of.reserve(all.count);

  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const PointSet& points = *bodies[b].points;
    const BodyRange& range = all.bodies[b];
    const int first = static_cast<int>(all.slot_of.size());
    all.slot_of.resize(first + range.count);
    const BlockOrder order = block_order(points.position, bodies[b].spacing, D, block_size);
    for (int begin = 0; const int end : order.block_end) {
      const int number = static_cast<int>(all.blocks.size());
      all.blocks.push_back({static_cast<int>(b), range.begin + begin, range.begin + end, number});
      begin = end;
    }
    for (int slot = range.begin; slot < range.end; ++slot) {
      const bool padding = slot - range.begin >= range.count;
      const int point = order.number[padding ? range.count - 1 : slot - range.begin];
      for (int c = 0; c < D; ++c) all.position.at(c, slot) = points.position[point][c];
      if (padding) continue;
      all.volume[slot] = points.volume[point];
      all.user_index[slot] = first + point;
      all.slot_of[first + point] = slot;
    }
  }
  return all;
}

template struct Arrangement<2>;
template struct Arrangement<3>;
template struct Particles<2>;
template struct Particles<3>;
template Arrangement<2> arrange<2>(const std::vector<BodyPoints>&, int);
template Arrangement<3> arrange<3>(const std::vector<BodyPoints>&, int);

}  // namespace sinew
