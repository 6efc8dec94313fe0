#include <sinew/implicit/equilibrium.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sinew {

template <int D>
Equilibrium<D>::Equilibrium(const Comm& comm, Particles<D>& particles, Formulation<D>& solid, Loads<D>& loads,
                            const PrescribedMotion<D>& motion, double stiffness)
    : comm_(comm),
      particles_(particles),
      solid_(solid),
      loads_(loads),
      fixed_(particles.slots + particles.copies),
      forces_(particles.slots),
      direction_(particles.slots + particles.copies),
      stiffness_(stiffness) {
  solid_.keep_linearization(particles_);
  motion.for_each([&](int slot, int component) { fixed_.at(component, slot) = 1.0; });
  number_nodes();
}

/// Rank after rank, slot after slot.
template <int D>
void Equilibrium<D>::number_nodes() {
  numbers_.assign(particles_.slots + particles_.copies, -1);
  for (int slot = 0; slot < particles_.slots; ++slot)
    if (particles_.user_index[slot] >= 0) slots_.push_back(slot);
  const int count = nodes();
  const std::vector<int> counts = comm_.gather_all(std::span<const int>(&count, 1));
  int first = 0;
  for (int rank = 0; rank < comm_.rank(); ++rank) first += counts[rank];
  for (int node = 0; node < count; ++node) {
    direction_.at(0, slots_[node]) = first + node;
    for (int c = 0; c < D; ++c)
      if (is_given(slots_[node], c)) given_.push_back(D * node + c);
  }
  solid_.update_copies(direction_);
  solid_.update_copies(fixed_);
  for (const int slot : slots_) numbers_[slot] = static_cast<int>(direction_.at(0, slot));
  for (int copy = particles_.slots; copy < particles_.slots + particles_.copies; ++copy)
    numbers_[copy] = static_cast<int>(direction_.at(0, copy));
  direction_.clear();
}

template <int D>
void Equilibrium<D>::set_step(double time, double dt, const Inertia* inertia) {
  time_ = time;
  dt_ = dt;
  inertia_ = inertia;
}

template <int D>
std::vector<double> Equilibrium<D>::values_of(const VectorField<D>& field) const {
  std::vector<double> values;
  values.reserve(D * slots_.size());
  for (const int slot : slots_)
    for (int c = 0; c < D; ++c) values.push_back(field.at(c, slot));
  return values;
}

template <int D>
void Equilibrium<D>::put(std::span<const double> values, VectorField<D>& field) const {
  for (int node = 0; node < nodes(); ++node)
    for (int c = 0; c < D; ++c) field.at(c, slots_[node]) = values[D * node + c];
}

template <int D>
std::vector<double> Equilibrium<D>::coordinates() const {
  return values_of(particles_.position);
}

/// |R| is compared with all forces that come from outside: loads on free components, what holds the given ones, and inertia.
template <int D>
bool Equilibrium<D>::residual(std::span<const double> u, std::span<double> r) {
  put(u);
  forces_.clear();
  if (loads_.follow()) solid_.update_copies(particles_.displacement);
  comm_.together([&] { loads_.add(particles_, time_, forces_); });
  std::vector<double> squares(particles_.blocks.size(), 0.0);
  const auto add_square = [&](int slot, double force) { squares[particles_.block_of(slot)] += force * force; };
  for (const int slot : slots_)
    for (int c = 0; c < D; ++c)
      if (!is_given(slot, c)) add_square(slot, forces_.at(c, slot));
  const ForceSummary summary = solid_.internal_forces(particles_, forces_, point_step(), [](int, int) {});
  for (int k = 0; k < D * nodes(); ++k) {
    const int slot = slots_[k / D];
    const double force = forces_.at(k % D, slot), m = particles_.mass[slot];
    r[k] = 0.0;
    if (is_given(k)) {
      add_square(slot, force);
    } else if (inertia_) {
      const double moved = u[k] - inertia_->displacement[k], v = inertia_->velocity[k] + inertia_->rate * moved;
      add_square(slot, m * inertia_->mass * moved);
      r[k] = m * inertia_->mass * moved - inertia_->now * (force - inertia_->damping * m * v) - inertia_->force[k];
    } else {
      r[k] = -force;
    }
  }
  scale_ = std::sqrt(sum_over_blocks(comm_, particles_.block_numbers(), squares, 1)[0]);
  most_scale_ = std::max(most_scale_, scale_);
  return !comm_.any(!summary.finite || !(summary.smallest_jacobian > 0.0) || !std::isfinite(summary.strain_energy));
}

/// Minus the tangent forces of the change value(node, component).
template <int D>
template <class Value>
void Equilibrium<D>::multiply(const Value& value, std::span<double> out) {
  for (int node = 0; node < nodes(); ++node)
    for (int c = 0; c < D; ++c) direction_.at(c, slots_[node]) = value(node, c);
  forces_.clear();
  std::swap(particles_.displacement, direction_);
  solid_.tangent_forces(particles_, forces_, point_step());
  std::swap(particles_.displacement, direction_);
  loads_.add_change(particles_, direction_, time_, forces_);
  for (int k = 0; k < D * nodes(); ++k)
    out[k] = is_given(k) ? 0.0
                         : inertial_stiffness() * mass_of(k) * direction_.at(k % D, slots_[k / D]) -
                               share_of_forces() * forces_.at(k % D, slots_[k / D]);
}

template <int D>
void Equilibrium<D>::product(std::span<const double> v, std::span<double> out) {
  multiply([&](int node, int c) { return is_given(slots_[node], c) ? 0.0 : v[D * node + c]; }, out);
  for (const int unknown : given_) out[unknown] = stiffness_ * v[unknown];
}

template <int D>
void Equilibrium<D>::product_of_given(std::span<const double> v, std::span<double> out) {
  multiply([&](int node, int c) { return is_given(slots_[node], c) ? v[D * node + c] : 0.0; }, out);
}

/// Rows and columns of given components have nothing but their diagonal.
template <int D>
void Equilibrium<D>::for_each_matrix(bool exact, Use use) {
  double factor = share_of_forces();
  const auto number = [&](std::span<const int> slots, std::span<const double> matrix) {
    const std::size_t size = D * slots.size();
    group_.clear();
    group_matrix_.assign(matrix.begin(), matrix.end());
    for (double& entry : group_matrix_) entry *= factor;
    for (std::size_t n = 0; n < slots.size(); ++n) {
      group_.push_back(numbers_[slots[n]]);
      for (int c = 0; c < D; ++c)
        for (std::size_t k = 0; is_given(slots[n], c) && k < size; ++k)
          group_matrix_[(D * n + c) * size + k] = group_matrix_[k * size + D * n + c] = 0.0;
    }
    use(group_, group_matrix_);
  };
  solid_.for_each_stiffness(particles_, reach_of(exact), point_step(), number);
  if (exact) loads_.for_each_stiffness(particles_, time_, number);
  if (!inertia_) return;
  factor = inertial_stiffness();
  std::array<double, D * D> mass{};
  for (const int slot : slots_) {
    for (int c = 0; c < D; ++c) mass[D * c + c] = particles_.mass[slot];
    number(std::span<const int>(&slot, 1), mass);
  }
}

template <int D>
void Equilibrium<D>::for_each_group(bool exact, FunctionRef<void(std::span<const int>)> use) const {
  std::vector<int> group;
  solid_.for_each_stencil(particles_, reach_of(exact), [&](std::span<const int> slots) {
    group.clear();
    for (const int slot : slots) group.push_back(numbers_[slot]);
    use(group);
  });
}

template class Equilibrium<2>;
template class Equilibrium<3>;

}  // namespace sinew
