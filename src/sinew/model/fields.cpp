#include <sinew/model/fields.hpp>

#include <cmath>
#include <map>
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

template <int D>
Mat3<double> gradient_at(const QuantitySource<D>& from, int slot) {
  return matrix_at(from.record->deformation_gradient, slot);
}

template <int D>
Mat3<double> first_stress_at(const QuantitySource<D>& from, int slot) {
  return matrix_at(from.record->stress, slot);
}

template <int D>
Mat3<double> cauchy_at(const QuantitySource<D>& from, int slot) {
  return cauchy_stress(gradient_at(from, slot), first_stress_at(from, slot));
}

template <int D>
Components strain_at(const QuantitySource<D>& from, int slot) {
  const Mat3<double> F = gradient_at(from, slot);
  return flat(0.5 * (transpose(F) * F - Mat3<double>::identity()));
}

template <int D>
Components density_at(const QuantitySource<D>& from, int slot) {
  return scalar(from.particles.bodies[from.particles.body_of(slot)].density / determinant(gradient_at(from, slot)));
}

template <int D>
Components position_at(const QuantitySource<D>& from, int slot) {
  const Point x = from.particles.current(slot);
  return {{x[0], x[1], x[2]}, 3};
}

template <int D>
const std::map<std::string_view, ParticleQuantity<D>>& quantities() {
  using Source = const QuantitySource<D>&;
  static const std::map<std::string_view, ParticleQuantity<D>> list{
      {"displacement", [](Source s, int i) { return from_vector(s.particles.displacement[i]); }},
      {"velocity", [](Source s, int i) { return from_vector(s.particles.velocity[i]); }},
      {"acceleration", [](Source s, int i) { return from_vector(s.particles.acceleration[i]); }},
      {"force", [](Source s, int i) { return from_vector(s.particles.acceleration[i], s.particles.mass[i]); }},
      {"position", position_at<D>},
      {"volume", [](Source s, int i) { return scalar(s.particles.volume[i] * s.solid.options().thickness); }},
      {"neighbors", [](Source s, int i) { return scalar(static_cast<double>(s.solid.pairs().neighbor_count[i])); }},
      {"deformation_gradient", [](Source s, int i) { return flat(gradient_at(s, i)); }},
      {"first_piola_kirchhoff_stress", [](Source s, int i) { return flat(first_stress_at(s, i)); }},
      {"green_lagrange_strain", strain_at<D>},
      {"cauchy_stress", [](Source s, int i) { return flat(cauchy_at(s, i)); }},
      {"von_mises_stress", [](Source s, int i) { return scalar(von_mises(cauchy_at(s, i))); }},
      {"pressure", [](Source s, int i) { return scalar(-trace(cauchy_at(s, i)) / 3.0); }},
      {"jacobian", [](Source s, int i) { return scalar(determinant(gradient_at(s, i))); }},
      {"density", density_at<D>},
      {"strain_energy_density", [](Source s, int i) { return scalar(s.record->energy_density[i]); }},
      {"hourglass_error", [](Source s, int i) { return scalar(s.record->hourglass_error[i]); }},
      {"thickness_stretch", [](Source s, int i) { return scalar(gradient_at(s, i)[2][2]); }},
  };
  return list;
}

const std::set<std::string_view> unrecorded{"displacement", "velocity",  "acceleration", "position",
                                            "volume",       "neighbors", "force"};

}  // namespace

bool needs_record(std::string_view quantity) { return !unrecorded.contains(quantity); }

template <int D>
ParticleQuantity<D> particle_quantity(std::string_view name) {
  const auto found = quantities<D>().find(name);
  if (found == quantities<D>().end()) throw std::logic_error("no such quantity: " + std::string(name));
  return found->second;
}

int component_index(const QuantityInfo& quantity, std::string_view component) {
  const auto axis = [](char c) { return c - 'x'; };
  if (component.empty() && quantity.kind == QuantityKind::scalar) return 0;
  if (component.empty() || component == "magnitude") return -1;
  if (component.size() == 1) return axis(component[0]);
  return 3 * axis(component[0]) + axis(component[1]);
}

template ParticleQuantity<2> particle_quantity<2>(std::string_view);
template ParticleQuantity<3> particle_quantity<3>(std::string_view);

}  // namespace sinew
