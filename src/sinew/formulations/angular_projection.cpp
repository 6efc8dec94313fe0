#include <sinew/formulations/angular_projection.hpp>
#include <sinew/neighbors/eight_of_block.hpp>

namespace sinew {

namespace {

constexpr int width = 17;  ///< body, mass, sum m x, sum x cross f, sum f, sum m x (x) x
using Row = std::array<double, width>;

template <int D>
Row sums_of(const Particles<D>& particles, const VectorField<D>& forces, const BlockRange& block) {
  Pack mass;
  Vec<Pack, 3> place, moment, force;
  Mat<Pack, 3> second;
  for_each_eight(block, [&](const EightOfBlock& load) {
    const Pack m = load(particles.mass.data());
    Vec<Pack, 3> x, f;
    for (int c = 0; c < D; ++c) {
      x[c] = load(particles.position.component(c)) + load(particles.displacement.component(c));
      f[c] = load(forces.component(c));
    }
    mass += m;
    place += m * x;
    moment += cross(x, f);
    force += f;
    second += outer(m * x, x);
  });
  Row row{static_cast<double>(block.body), sum(mass)};
  int next = 2;
  for (const Vec<Pack, 3>* v : {&place, &moment, &force})
    for (int c = 0; c < 3; ++c) row[next++] = sum((*v)[c]);
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) row[next++] = sum(second[i][j]);
  return row;
}

Point point_at(const double* from) { return {{from[0], from[1], from[2]}}; }

}  // namespace

/// Of each body, block after block.
template <int D>
std::vector<typename AngularProjection<D>::Motion> AngularProjection<D>::motions(const Comm& comm, const Particles<D>& particles,
                                                                                 const VectorField<D>& forces) {
  std::vector<double> rows;
  of_each_block<width>(
      particles, [&](const BlockRange& block) { return sums_of(particles, forces, block); }, rows);
  rows = gather_over_blocks(comm, particles.block_numbers(), rows, width);
  std::vector<Motion> motions(particles.bodies.size());
  for (std::size_t at = 0; at < rows.size(); at += width) {
    const double* row = rows.data() + at;
    Motion& motion = motions[static_cast<std::size_t>(row[0])];
    motion.mass += row[1];
    motion.place += point_at(row + 2);
    motion.moment += point_at(row + 5);
    motion.force += point_at(row + 8);
    for (int i = 0, c = 11; i < 3; ++i)
      for (int j = i; j < 3; ++j, ++c) {
        motion.second[i][j] += row[c];
        motion.second[j][i] = motion.second[i][j];
      }
  }
  return motions;
}

/// By which the moment of a body's internal forces turns it.
template <int D>
Point AngularProjection<D>::angular_acceleration(const Motion& before, const Motion& after, const Point& center) {
  const Point moment = after.moment - before.moment - cross(center, after.force - before.force);
  if (norm(moment) == 0.0) return {};  // of tools, which may have no inertia about some axis
  const Mat<double, 3> second = after.second - after.mass * outer(center, center);
  const Mat<double, 3> inertia = trace(second) * Mat<double, 3>::identity() - second;
  if constexpr (D == 2) return {{0.0, 0.0, moment[2] / inertia[2][2]}};
  return inverse(inertia) * moment;
}

template <int D>
void AngularProjection<D>::begin(const Comm& comm, const Particles<D>& particles, const VectorField<D>& forces) {
  before_ = motions(comm, particles, forces);
}

template <int D>
void AngularProjection<D>::project(const Comm& comm, const Particles<D>& particles, VectorField<D>& forces) {
  const std::vector<Motion> after = motions(comm, particles, forces);
  for (const BlockRange& block : particles.blocks) {
    const Motion& motion = after[block.body];
    const Point center = (1.0 / motion.mass) * motion.place;
    const Point turn = angular_acceleration(before_[block.body], motion, center);
    for (int slot = block.begin; slot < block.end; ++slot) {
      const Point change = particles.mass[slot] * cross(turn, particles.current(slot) - center);
      for (int c = 0; c < D; ++c) forces.at(c, slot) -= change[c];
    }
  }
}

template class AngularProjection<2>;
template class AngularProjection<3>;

}  // namespace sinew
