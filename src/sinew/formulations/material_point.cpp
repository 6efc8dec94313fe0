#include <sinew/formulations/material_point.hpp>
#include <sinew/materials/plane_stress.hpp>

namespace sinew {

namespace {

/// Fills what both dimensions have, and returns all of P.
template <int D, class Material, class M>
SINEW_INLINE M respond(const Material& material, const M& F, PointResponse<D>& out) {
  const auto response = material.respond(F);
  out.P = in_plane<D>(response.P);
  out.energy = response.energy;
  out.jacobian = determinant(F);
  out.acoustic_stiffness = material.acoustic_stiffness(F);
  return response.P;
}

template <class Material>
void respond_in_space(const void* pointer, const Mat<Pack, 3>& F, PointResponse<3>& out) {
  respond(*static_cast<const Material*>(pointer), F, out);
}

template <class Material>
SINEW_INLINE void respond_at_thickness(const Material& material, const PlaneMatrix<Pack>& F, PointResponse<2>& out) {
  out.thickness_stress = respond(material, F, out).out_of_plane;
  out.thickness_stretch = F.out_of_plane;
}

template <class Material>
void respond_in_plane_strain(const void* pointer, const Mat<Pack, 2>& F, PointResponse<2>& out) {
  respond_at_thickness(*static_cast<const Material*>(pointer), {F, Pack(1.0)}, out);
}

template <class Material>
void respond_in_plane_stress(const void* pointer, const Mat<Pack, 2>& F, PointResponse<2>& out) {
  const Material& material = *static_cast<const Material*>(pointer);
  const Pack stretch = PlaneStress<Material>{material}.thickness_stretch(PlaneMatrix<Pack>{F, Pack(1.0)});
  respond_at_thickness(material, {F, stretch}, out);
}

}  // namespace

template <>
MaterialPoint<2> material_point<2>(const AnyMaterial& any, bool plane_stress) {
  return std::visit(
      [&]<class Material>(const Material& material) -> MaterialPoint<2> {
        return {&material, plane_stress ? respond_in_plane_stress<Material> : respond_in_plane_strain<Material>};
      },
      any);
}

template <>
MaterialPoint<3> material_point<3>(const AnyMaterial& any, bool) {
  return std::visit(
      []<class Material>(const Material& material) -> MaterialPoint<3> {
        return {&material, respond_in_space<Material>};
      },
      any);
}

}  // namespace sinew
