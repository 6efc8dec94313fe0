#include <sinew/formulations/damage_point.hpp>
#include <sinew/materials/plane_stress.hpp>

#include <stdexcept>

namespace sinew {

namespace {

// All is known before anything is stored, since to the compiler `out` might be where F and the constants of the material are.

// What a response does not change stays as it is: plastic state and damage of materials that have none.

template <int D>
SINEW_INLINE void put_scalars(const Pack& energy, const Pack& jacobian, const Pack& stiffness, const Pack& modulus,
                              PointResponse<D>& out) {
  out.energy = energy;
  out.jacobian = jacobian;
  out.acoustic_stiffness = stiffness;
  out.hourglass_modulus = modulus;
}
SINEW_INLINE void put(const Mat3<Pack>& F, const Response<Mat3<Pack>>& r, const Pack& stiffness, const Pack& modulus,
                      PointResponse<3>& out) {
  const Pack jacobian = determinant(F);
  out.P = r.P;
  put_scalars(r.energy, jacobian, stiffness, modulus, out);
}
SINEW_INLINE void put(const PlaneMatrix<Pack>& F, const Response<PlaneMatrix<Pack>>& r, const Pack& stiffness,
                      const Pack& modulus, PointResponse<2>& out) {
  const Pack jacobian = determinant(F), stretch = F.out_of_plane;
  out.P = r.P.in_plane;
  out.thickness_stretch = stretch;
  out.thickness_stress = r.P.out_of_plane;
  put_scalars(r.energy, jacobian, stiffness, modulus, out);
}

/// The matrix with which materials of D dimensions work, with F33 = 1 in the plane.
SINEW_INLINE const Mat3<Pack>& strained(const Mat<Pack, 3>& F) { return F; }
SINEW_INLINE PlaneMatrix<Pack> strained(const Mat<Pack, 2>& F) { return {F, Pack(1.0)}; }

template <int D, class Bound, class M>
SINEW_INLINE Pack stiffness_of(const Bound& bound, const M& F, const SliceHistory<D>* slice) {
  if (slice && slice->later) return largest_of_later<M>(bound, strained(slice->later->since), strained(slice->later->earlier));
  return largest_of<M>(bound, F);
}

template <int D, class Material>
void respond_elastic(const void* pointer, const Mat<Pack, D>& plane, const SliceHistory<D>* slice, PointResponse<D>& out) {
  const Material& material = *static_cast<const Material*>(pointer);
  const auto& F = strained(plane);
  const auto r = material.respond(F);
  put(F, r, stiffness_of(material.acoustic_bound(F), F, slice), Pack(material.elastic.youngs_modulus), out);
}

template <class Material>
void respond_in_plane_stress(const void* pointer, const Mat<Pack, 2>& plane, const SliceHistory<2>*, PointResponse<2>& out) {
  const Material& material = *static_cast<const Material*>(pointer);
  const Pack stretch = PlaneStress<Material>{material}.thickness_stretch(PlaneMatrix<Pack>{plane, Pack(1.0)});
  const PlaneMatrix<Pack> F{plane, stretch};
  const auto r = material.respond(F);
  put(F, r, acoustic_stiffness(material, F), Pack(material.elastic.youngs_modulus), out);
}

/// Calls use(history number, its values in the block) for all numbers of a slice.
template <class History, int D, class Use>
SINEW_INLINE void for_each_number(History& history, const SliceHistory<D>& slice, Use&& use) {
  double* values = slice.block.values;
  History::numbers(history, [&](Pack& number) {
    use(number, values);
    values += slice.block.count;
  });
}

SINEW_INLINE const Mat<Pack, 3>& plane_of(const Mat3<Pack>& F) { return F; }
SINEW_INLINE const Mat<Pack, 2>& plane_of(const PlaneMatrix<Pack>& F) { return F.in_plane; }

/// Of a history before a step.
struct Before {
  Pack modulus, strain, work;
};

/// Stores the new history where it is to be kept, and tells of it.
template <int D, class Material, class History>
SINEW_INLINE void finish_history(const Material& material, History& history, const Before& before, const SliceHistory<D>& slice,
                                 PointResponse<D>& out) {
  out.hourglass_left = material.hourglass_modulus(history) / before.modulus;
  out.plastic = {history.strain, history.work, material.temperature(history), history.strain - before.strain,
                 history.work - before.work};
  if (slice.step.keep())
    for_each_number(history, slice,
                    [&](const Pack& number, double* values) { slice.slots.store(number, values, slice.block.first); });
}

template <int D, class Material>
void respond_with_history(const void* pointer, const Mat<Pack, D>& plane, const SliceHistory<D>* slice, PointResponse<D>& out) {
  const Material& material = *static_cast<const Material*>(pointer);
  const auto& F = strained(plane);
  using M = std::remove_cvref_t<decltype(F)>;
  typename Material::template History<M> history;
  for_each_number(history, *slice,
                  [&](Pack& number, const double* values) { number = slice->slots.load(values, slice->block.first); });
  const Before before{material.hourglass_modulus(history), history.strain, history.work};
  Response<M> r = slice->step.respond() ? material.respond(F, history, slice->step.dt) : material.recall(F, history);
  if constexpr (requires { Material::in_rates; })
    if (slice->shapeless) {
      const M round = material.forget_shape(F, history);
      *slice->shapeless = plane_of(round);
      r = material.recall(round, history);
      put(round, r, acoustic_stiffness(material, round, r.P), before.modulus, out);
      return finish_history(material, history, before, *slice, out);
    }
  put(F, r, stiffness_of(material.acoustic_bound(F, r.P), F, slice), before.modulus, out);
  finish_history(material, history, before, *slice, out);
}

/// How many numbers a history has.
template <int D, class Material>
int count_numbers() {
  using M = std::remove_cvref_t<decltype(strained(Mat<Pack, D>{}))>;
  typename Material::template History<M> history;
  int count = 0;
  decltype(history)::numbers(history, [&](const Pack&) { ++count; });
  return count;
}

template <int D, class Material>
MaterialPoint<D> point_of(const Material& material, [[maybe_unused]] bool plane_stress) {
  if constexpr (HasHistory<Material>) {
    if (plane_stress) throw std::logic_error("a material with history in plane stress");
    return {&material, respond_with_history<D, Material>, count_numbers<D, Material>(), Material::first_shape};
  } else {
    if constexpr (D == 2 && !std::is_same_v<Material, Rigid>)
      if (plane_stress) return {&material, respond_in_plane_stress<Material>, 0};
    return {&material, respond_elastic<D, Material>, 0};
  }
}

}  // namespace

template <int D>
MaterialPoint<D> material_point(const AnyMaterial& any, const AnyDamage* damage, bool plane_stress) {
  MaterialPoint<D> point = std::visit([&](const auto& material) { return point_of<D>(material, plane_stress); }, any);
  if (!damage) return point;
  if (plane_stress) throw std::logic_error("damage in plane stress");
  point.damage = std::visit([](const auto& model) -> const void* { return &model; }, *damage);
  point.damage_function = damage_function<D>(*damage);
  point.damage_step = {point.numbers,
                       std::visit(
                           [](const auto& material) {
                             return std::sqrt((material.elastic.lambda() + 2.0 * material.elastic.mu()) / material.density);
                           },
                           any)};
  point.numbers += numbers_of(*damage);
  return point;
}

template MaterialPoint<2> material_point<2>(const AnyMaterial&, const AnyDamage*, bool);
template MaterialPoint<3> material_point<3>(const AnyMaterial&, const AnyDamage*, bool);

}  // namespace sinew
