#include <sinew/model/fields.hpp>

#include <cmath>
#include <set>
#include <stdexcept>

namespace sinew {

namespace {

Mat3<double> matrix_at(const AlignedArray<double>& values, int slot) {
  Mat3<double> m;
  for (int k = 0; k < 9; ++k) m[k / 3][k % 3] = values[9 * std::size_t(slot) + k];
  return m;
}

Components scalar(double value) { return {{value}, 1}; }

Components flat(const Mat3<double>& m) {
  Components tensor{{}, 9};
  for (int k = 0; k < 9; ++k) tensor.value[k] = m[k / 3][k % 3];
  return tensor;
}

/// A vector as three components.
template <int D>
Components from_vector(const Vec<double, D>& v, double factor = 1.0) {
  Components vector{{}, 3};
  for (int c = 0; c < D; ++c) vector.value[c] = factor * v[c];
  return vector;
}

/// sigma = P F^T / J.
Mat3<double> cauchy_stress(const Mat3<double>& F, const Mat3<double>& P) { return (1.0 / determinant(F)) * (P * transpose(F)); }

/// sqrt(3/2 s:s), s the deviator.
double von_mises(Mat3<double> s) {
  const double mean = trace(s) / 3.0;
  for (int i = 0; i < 3; ++i) s[i][i] -= mean;
  return std::sqrt(1.5 * double_dot(s, s));
}

Components recorded_quantity(std::string_view q, int slot, double density, const RecordedState& state) {
  const Mat3<double> F = matrix_at(state.deformation_gradient, slot), P = matrix_at(state.stress, slot);
  if (q == "deformation_gradient") return flat(F);
  if (q == "first_piola_kirchhoff_stress") return flat(P);
  if (q == "green_lagrange_strain") return flat(0.5 * (transpose(F) * F - Mat3<double>::identity()));
  if (q == "cauchy_stress") return flat(cauchy_stress(F, P));
  if (q == "von_mises_stress") return scalar(von_mises(cauchy_stress(F, P)));
  if (q == "pressure") return scalar(-trace(cauchy_stress(F, P)) / 3.0);
  if (q == "jacobian") return scalar(determinant(F));
  if (q == "density") return scalar(density / determinant(F));
  if (q == "strain_energy_density") return scalar(state.energy_density[slot]);
  if (q == "hourglass_error") return scalar(state.hourglass_error[slot]);
  if (q == "thickness_stretch") return scalar(F[2][2]);
  throw std::logic_error("no such quantity: " + std::string(q));
}

const std::set<std::string_view> unrecorded{"displacement", "velocity",  "acceleration", "position",
                                            "volume",       "neighbors", "force"};

}  // namespace

bool needs_record(std::string_view quantity) { return !unrecorded.contains(quantity); }

template <int D>
Components particle_quantity(std::string_view q, int slot, const Particles<D>& particles, const TotalLagrangian<D>& solid,
                             const RecordedState* state) {
  if (q == "displacement") return from_vector(particles.displacement[slot]);
  if (q == "velocity") return from_vector(particles.velocity[slot]);
  if (q == "acceleration") return from_vector(particles.acceleration[slot]);
  if (q == "force") return from_vector(particles.acceleration[slot], particles.mass[slot]);
  if (q == "position") {
    const Point x = particles.current(slot);
    return {{x[0], x[1], x[2]}, 3};
  }
  if (q == "volume") return scalar(particles.volume[slot] * solid.options().thickness);
  if (q == "neighbors") return scalar(static_cast<double>(solid.pairs().neighbor_count[slot]));
  return recorded_quantity(q, slot, particles.bodies[particles.body_of(slot)].density, *state);
}

int component_index(const QuantityInfo& quantity, std::string_view component) {
  const auto axis = [](char c) { return c - 'x'; };
  if (component.empty() && quantity.kind == QuantityKind::scalar) return 0;
  if (component.empty() || component == "magnitude") return -1;
  if (component.size() == 1) return axis(component[0]);
  return 3 * axis(component[0]) + axis(component[1]);
}

template Components particle_quantity<2>(std::string_view, int, const Particles<2>&, const TotalLagrangian<2>&,
                                         const RecordedState*);
template Components particle_quantity<3>(std::string_view, int, const Particles<3>&, const TotalLagrangian<3>&,
                                         const RecordedState*);

}  // namespace sinew
