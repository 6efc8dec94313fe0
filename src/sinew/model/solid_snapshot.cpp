/// Of SolidSimulation: what files and pictures show.

#include <sinew/model/fields.hpp>
#include <sinew/model/solid_simulation.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace sinew {

namespace {

/// A quantity of all particles, and where it goes.
template <int D>
struct Output {
  ParticleQuantity<D> quantity;
  double* values;
};

/// To the given rows, or without rows one after the other. Some slots at a time, so that what one quantity has read (F, P) is in the cache for the next; in computing order, since more
/// is read than written.
template <int D>
void fill(const std::vector<Output<D>>& outputs, const QuantitySource<D>& source, const std::vector<int>& slots,
          const std::vector<int>& rows) {
  constexpr std::size_t together = 256;
  const auto count = static_cast<std::ptrdiff_t>(slots.size());
#pragma omp parallel for schedule(static) if (count >= fewest_for_threads)
  for (std::ptrdiff_t begin = 0; begin < count; begin += together) {
    const std::size_t size = std::min(together, slots.size() - begin);
    const std::span some = std::span(slots).subspan(begin, size);
    for (const Output<D>& out : outputs)
      if (rows.empty())
        out.quantity.values(source, some, {}, out.values + begin * out.quantity.components);
      else
        out.quantity.values(source, some, std::span(rows).subspan(begin, size), out.values);
  }
}

void set_points(const std::vector<double>& coordinates, std::vector<Point>& points) {
  points.resize(coordinates.size() / 3);
  for (std::size_t k = 0; k < points.size(); ++k) std::copy_n(coordinates.begin() + 3 * k, 3, points[k].c);
}

}  // namespace

/// What never changes while a simulation runs.
template <int D>
void SolidSimulation<D>::describe(Snapshot& s) const {
  s = {};
  s.dimension = D;
  if (!comm_.alone()) s.range = order_.range();
  s.length_unit = case_.general.units.name_of("m");
  s.time_unit = case_.general.units.name_of("s");
  for (const BodyRange& body : particles_.bodies) s.body_names.push_back(body.name);
  std::vector<double> rows;
  for (int slot : order_.slots()) {
    rows.push_back(std::pow(particles_.volume[slot], 1.0 / D));
    rows.push_back(particles_.body_of(slot));
  }
  rows = order_.to_range(rows, 2);
  for (std::size_t k = 0; k < rows.size(); k += 2) {
    s.size.push_back(rows[k]);
    s.body.push_back(static_cast<int>(rows[k + 1]));
  }
}

/// A process alone fills the rows of the snapshot themselves, one of several ranks rows of its own, which then go where they belong.
template <int D>
void SolidSimulation<D>::fill_snapshot(const std::vector<std::string>& fields, Snapshot& s) {
  const std::vector<int>& slots = order_.slots();
  if (comm_.any(s.body_names.empty())) describe(s);
  s.time = time_;
  s.step = steps_;
  s.position.resize(slots.size());
  s.fields.resize(fields.size());
  std::vector<Output<D>> outputs{{particle_quantity<D>("position"), slots.empty() ? nullptr : s.position.front().c}};
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const ParticleQuantity<D> quantity = particle_quantity<D>(fields[f]);
    s.fields[f].name = fields[f];
    s.fields[f].unit = case_.general.units.name_of(find_quantity(fields[f])->unit);
    s.fields[f].components = quantity.components;
    s.fields[f].values.resize(slots.size() * quantity.components);
    outputs.push_back({quantity, s.fields[f].values.data()});
  }
  if (std::find(fields.begin(), fields.end(), "hourglass_error") != fields.end()) wants_hourglass_error_ = true;
  const bool recorded = std::any_of(fields.begin(), fields.end(), [](const std::string& name) { return needs_record(name); });
  fill(outputs, {particles_, *solid_, recorded ? &record() : nullptr, &contacts_.forces()}, slots, order_.numbers());
  if (comm_.alone()) return;
  std::vector<double> position;
  for (const Point& x : s.position) position.insert(position.end(), x.c, x.c + 3);
  set_points(order_.to_range(position, 3), s.position);
  for (FieldData& field : s.fields) field.values = order_.to_range(field.values, field.components);
}

template <int D>
Snapshot SolidSimulation<D>::snapshot(const std::vector<std::string>& fields) {
  Snapshot s;
  fill_snapshot(fields, s);
  if (comm_.alone()) return s;
  std::vector<double> rows;
  for (std::size_t k = 0; k < s.position.size(); ++k)
    rows.insert(rows.end(), {s.position[k][0], s.position[k][1], s.position[k][2], s.size[k], static_cast<double>(s.body[k])});
  rows = order_.whole(std::move(rows), 5);
  const std::size_t count = rows.size() / 5;
  s.range.reset();
  s.position.resize(count), s.size.resize(count), s.body.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    std::copy_n(rows.begin() + 5 * k, 3, s.position[k].c);
    s.size[k] = rows[5 * k + 3];
    s.body[k] = static_cast<int>(rows[5 * k + 4]);
  }
  for (FieldData& field : s.fields) field.values = order_.whole(std::move(field.values), field.components);
  return s;
}

template void SolidSimulation<2>::fill_snapshot(const std::vector<std::string>&, Snapshot&);
template void SolidSimulation<3>::fill_snapshot(const std::vector<std::string>&, Snapshot&);
template Snapshot SolidSimulation<2>::snapshot(const std::vector<std::string>&);
template Snapshot SolidSimulation<3>::snapshot(const std::vector<std::string>&);

}  // namespace sinew
