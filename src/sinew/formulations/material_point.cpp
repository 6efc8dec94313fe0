#include <sinew/formulations/material_point.hpp>
#include <sinew/materials/plane_stress.hpp>

namespace sinew {

namespace {

// All is known before anything is stored, since to the compiler `out` might be where F and the constants of the material are.

template <class Material>
void respond_in_space(const void* pointer, const Mat<Pack, 3>& F, PointResponse<3>& out) {
  const Material& material = *static_cast<const Material*>(pointer);
  const auto r = material.respond(F);
  out = {r.P, r.energy, determinant(F), material.acoustic_stiffness(F)};
}

template <class Material>
SINEW_INLINE void respond_at_thickness(const Material& material, const PlaneMatrix<Pack>& F, PointResponse<2>& out) {
  const auto r = material.respond(F);
  out = {r.P.in_plane, r.energy, determinant(F), material.acoustic_stiffness(F), F.out_of_plane, r.P.out_of_plane};
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
