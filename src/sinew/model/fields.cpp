#include <sinew/model/fields.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace sinew {

namespace {

/// Up to eight particles, one a lane; lanes that are left repeat the last one.
struct Eight {
  int count;
  int slot[lanes];
  bool in_a_row = true;

  explicit Eight(std::span<const int> slots) : count(static_cast<int>(std::min<std::size_t>(slots.size(), lanes))) {
    for (int k = 0; k < lanes; ++k) {
      slot[k] = slots[std::min(k, count - 1)];
      in_a_row = in_a_row && slot[k] == slot[0] + k;
    }
  }
  Pack of(const double* values) const { return in_a_row ? Pack::load_unaligned(values + slot[0]) : Pack::gather(values, slot); }
  template <int D>
  Vec<Pack, D> of(const VectorField<D>& field) const {
    Vec<Pack, D> v;
    for (int c = 0; c < D; ++c) v[c] = of(field.component(c));
    return v;
  }
  /// value(slot) of each.
  template <class Value>
  Pack each(const Value& value) const {
    Pack p;
    for (int k = 0; k < lanes; ++k) p.set(k, value(slot[k]));
    return p;
  }
};

SINEW_INLINE Mat3<Pack> matrices_at(const VectorField<9>& values, const Eight& at) {
  Mat3<Pack> m;
  for (int c = 0; c < 9; ++c) m[c / 3][c % 3] = at.of(values.component(c));
  return m;
}

/// A tensor of which files hold six components.
struct Symmetric {
  Mat3<Pack> m;
};

// The components of a value, as they follow each other in files.
std::array<Pack, 1> components(Pack p) { return {p}; }
std::array<Pack, 3> components(const Vec<Pack, 2>& v) { return {v[0], v[1], Pack(0.0)}; }
std::array<Pack, 3> components(const Vec<Pack, 3>& v) { return {v[0], v[1], v[2]}; }
std::array<Pack, 6> components(const Symmetric& s) { return {s.m[0][0], s.m[1][1], s.m[2][2], s.m[0][1], s.m[1][2], s.m[0][2]}; }
std::array<Pack, 9> components(const Mat3<Pack>& m) {
  return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]};
}

/// Lane k to the k-th row, or to row rows[k].
template <std::size_t N>
SINEW_INLINE void put(const std::array<Pack, N>& parts, int count, const int* rows, double* out) {
  alignas(64) double lane[N][lanes];
  for (std::size_t c = 0; c < N; ++c) parts[c].store(lane[c]);
  for (int k = 0; k < count; ++k)
    for (std::size_t c = 0; c < N; ++c) out[N * (rows ? rows[k] : k) + c] = lane[c][k];
}

/// From the values of eight particles, at(source, eight), to a loop over many in which it is inlined.
template <int D, class At>
ParticleQuantity<D> quantity(At) {
  using Parts = decltype(components(At{}(std::declval<const QuantitySource<D>&>(), std::declval<const Eight&>())));
  constexpr std::size_t count = std::tuple_size_v<Parts>;
  return {count, [](const QuantitySource<D>& source, std::span<const int> slots, std::span<const int> rows, double* out) {
            for (std::size_t begin = 0; begin < slots.size(); begin += lanes) {
              const Eight some(slots.subspan(begin));
              const auto parts = components(At{}(source, some));
              if (rows.empty())
                put(parts, some.count, nullptr, out + count * begin);
              else
                put(parts, some.count, rows.data() + begin, out);
            }
          }};
}

/// sigma = P F^T / J.
SINEW_INLINE Mat3<Pack> cauchy_stress(const Mat3<Pack>& F, const Mat3<Pack>& P) {
  return (1.0 / determinant(F)) * (P * transpose(F));
}

/// E = (F^T F - I) / 2.
Mat3<Pack> green_lagrange(const Mat3<Pack>& F) { return 0.5 * (transpose(F) * F - Mat3<Pack>::identity()); }

/// sqrt(3/2 s:s), s the deviator.
SINEW_INLINE Pack von_mises(Mat3<Pack> s) {
  const Pack mean = trace(s) / 3.0;
  for (int i = 0; i < 3; ++i) s[i][i] -= mean;
  return sqrt(1.5 * double_dot(s, s));
}

template <int D>
Mat3<Pack> gradient_at(const QuantitySource<D>& from, const Eight& at) {
  return matrices_at(from.record->deformation_gradient, at);
}

template <int D>
Mat3<Pack> first_stress_at(const QuantitySource<D>& from, const Eight& at) {
  return matrices_at(from.record->stress, at);
}

template <int D>
SINEW_INLINE Mat3<Pack> cauchy_at(const QuantitySource<D>& from, const Eight& at) {
  return cauchy_stress(gradient_at(from, at), first_stress_at(from, at));
}

/// rho = rho_0 / J.
template <int D>
Pack density_at(const QuantitySource<D>& from, const Eight& at) {
  const Particles<D>& p = from.particles;
  return at.each([&](int slot) { return p.bodies[p.body_of(slot)].density; }) / determinant(gradient_at(from, at));
}

template <int D>
Vec<Pack, D> contact_force_at(const QuantitySource<D>& from, const Eight& at) {
  if (!from.contact_forces || from.contact_forces->empty()) return {};
  return at.of(*from.contact_forces);
}

/// A component of RecordedState::inelastic.
template <int component, int D>
Pack inelastic_at(const QuantitySource<D>& from, const Eight& at) {
  const VectorField<4>& inelastic = from.record->inelastic;
  return inelastic.empty() ? Pack(0.0) : at.of(inelastic.component(component));
}

template <int D>
const std::map<std::string_view, ParticleQuantity<D>>& quantities() {
  using S = const QuantitySource<D>&;
  using At = const Eight&;
  static const std::map<std::string_view, ParticleQuantity<D>> list{
      {"displacement", quantity<D>([](S s, At i) { return i.of(s.particles.displacement); })},
      {"velocity", quantity<D>([](S s, At i) { return i.of(s.particles.velocity); })},
      {"acceleration", quantity<D>([](S s, At i) { return i.of(s.particles.acceleration); })},
      {"force", quantity<D>([](S s, At i) { return i.of(s.particles.mass.data()) * i.of(s.particles.acceleration); })},
      {"contact_force", quantity<D>([](S s, At i) { return contact_force_at(s, i); })},
      {"position", quantity<D>([](S s, At i) { return i.of(s.particles.position) + i.of(s.particles.displacement); })},
      {"volume", quantity<D>([](S s, At i) { return i.of(s.particles.volume.data()) * s.solid.thickness(); })},
      {"neighbors", quantity<D>([](S s, At i) { return i.each([&](int k) { return s.solid.pairs().neighbor_count[k]; }); })},
      {"deformation_gradient", quantity<D>([](S s, At i) { return gradient_at(s, i); })},
      {"first_piola_kirchhoff_stress", quantity<D>([](S s, At i) { return first_stress_at(s, i); })},
      {"green_lagrange_strain", quantity<D>([](S s, At i) { return Symmetric{green_lagrange(gradient_at(s, i))}; })},
      {"cauchy_stress", quantity<D>([](S s, At i) { return Symmetric{cauchy_at(s, i)}; })},
      {"von_mises_stress", quantity<D>([](S s, At i) { return von_mises(cauchy_at(s, i)); })},
      {"pressure", quantity<D>([](S s, At i) { return -trace(cauchy_at(s, i)) / 3.0; })},
      {"jacobian", quantity<D>([](S s, At i) { return determinant(gradient_at(s, i)); })},
      {"density", quantity<D>([](S s, At i) { return density_at(s, i); })},
      {"strain_energy_density", quantity<D>([](S s, At i) { return i.of(s.record->energy_density.data()); })},
      {"hourglass_error", quantity<D>([](S s, At i) { return i.of(s.record->hourglass_error.data()); })},
      {"thickness_stretch", quantity<D>([](S s, At i) { return gradient_at(s, i)[2][2]; })},
      {"plastic_strain", quantity<D>([](S s, At i) { return inelastic_at<0>(s, i); })},
      {"plastic_work", quantity<D>([](S s, At i) { return inelastic_at<1>(s, i); })},
      {"damage", quantity<D>([](S s, At i) { return inelastic_at<3>(s, i); })},
      {"temperature", quantity<D>([](S s, At i) { return inelastic_at<2>(s, i); })},
  };
  return list;
}

const std::set<std::string_view> unrecorded{"displacement", "velocity",  "acceleration", "position",
                                            "volume",       "neighbors", "force",        "contact_force"};

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

int stored_index(int component_index, int components) {
  constexpr int of_six[9] = {0, 3, 5, 3, 1, 4, 5, 4, 2};
  return components == 6 ? of_six[component_index] : component_index;
}

template ParticleQuantity<2> particle_quantity<2>(std::string_view);
template ParticleQuantity<3> particle_quantity<3>(std::string_view);

}  // namespace sinew
