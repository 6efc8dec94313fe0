#include <sinew/formulations/tangent_point.hpp>
#include <sinew/materials/plane_stress.hpp>

#include <stdexcept>

namespace sinew {

namespace {

template <int D>
void put(const Tangent<Pack>& A, const Pack& modulus, PointTangent<D>& out) {
  for (int row = 0; row < D * D; ++row)
    for (int column = 0; column < D * D; ++column) out.A[row][column] = A[3 * (row / D) + row % D][3 * (column / D) + column % D];
  out.hourglass_modulus = modulus;
}

template <int D, class Material>
void elastic_tangent(const void* pointer, const Mat<Pack, D>& F, const SliceHistory<D>*, PointTangent<D>& out) {
  const Material& material = *static_cast<const Material*>(pointer);
  put(material.tangent(embed(F, Pack(1.0))), Pack(material.elastic.youngs_modulus), out);
}

template <class Material>
void plane_stress_tangent(const void* pointer, const Mat<Pack, 2>& F, const SliceHistory<2>*, PointTangent<2>& out) {
  const Material& material = *static_cast<const Material*>(pointer);
  put(PlaneStress<Material>{material}.tangent(embed(F, Pack(1.0))), Pack(material.elastic.youngs_modulus), out);
}

using Space = Mat3<Pack>;
using Plane = PlaneMatrix<Pack>;

SINEW_INLINE PlasticHistory<Space> in_space(const PlasticHistory<Space>& history) { return history; }
SINEW_INLINE RateHistory<Space> in_space(const RateHistory<Space>& history) { return history; }
SINEW_INLINE PlasticHistory<Space> in_space(const PlasticHistory<Plane>& history) {
  return {history.strain, history.work, in_space(history.metric)};
}
SINEW_INLINE RateHistory<Space> in_space(const RateHistory<Plane>& history) {
  return {history.strain, history.work, in_space(history.stress), in_space(history.gradient)};
}

/// The numbers of a history are stored for the matrices of a plane state in two dimensions.
template <class Material, int D>
typename Material::template History<Space> load_history(const SliceHistory<D>& slice) {
  typename Material::template History<std::conditional_t<D == 3, Space, Plane>> stored;
  const double* values = slice.block.values;
  decltype(stored)::numbers(stored, [&](Pack& number) {
    number = slice.slots.load(values, slice.block.first);
    values += slice.block.count;
  });
  return in_space(stored);
}

template <int D, class Material>
void tangent_with_history(const void* pointer, const Mat<Pack, D>& F, const SliceHistory<D>* slice, PointTangent<D>& out) {
  const Material& material = *static_cast<const Material*>(pointer);
  const auto history = load_history<Material>(*slice);
  put(material.tangent(embed(F, Pack(1.0)), history, slice->step.dt), material.hourglass_modulus(history), out);
}

template <int D, class Material>
TangentPoint<D> point_of(const Material& material, [[maybe_unused]] bool plane_stress) {
  if constexpr (HasHistory<Material>) {
    if (plane_stress) throw std::logic_error("a material with history in plane stress");
    return {&material, tangent_with_history<D, Material>};
  } else {
    if constexpr (D == 2 && !std::is_same_v<Material, Rigid>)
      if (plane_stress) return {&material, plane_stress_tangent<Material>};
    return {&material, elastic_tangent<D, Material>};
  }
}

}  // namespace

template <int D>
TangentPoint<D> tangent_point(const AnyMaterial& any, bool plane_stress) {
  return std::visit([&](const auto& material) { return point_of<D>(material, plane_stress); }, any);
}

template TangentPoint<2> tangent_point<2>(const AnyMaterial&, bool);
template TangentPoint<3> tangent_point<3>(const AnyMaterial&, bool);

}  // namespace sinew
