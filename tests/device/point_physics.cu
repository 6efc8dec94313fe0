// All point-wise physics, called from the device for every registered type: a new type is covered with no change here.
// tools/check_device.py compiles this file; nothing runs it.

#include <sinew/corrections/registry.hpp>
#include <sinew/kernels/registry.hpp>
#include <sinew/materials/plane_stress.hpp>
#include <sinew/materials/registry.hpp>
#include <sinew/stabilization/registry.hpp>

namespace sinew {
namespace {

template <class... Values>
__device__ void keep(double* out, const Values&... value) {
  double sum = 0.0;
  ((sum += value), ...);
  out[threadIdx.x] = sum;
}

template <class Kernel, int D>
__global__ void kernel_values(double* out, double r, double R) {
  keep(out, Kernel::template value<D>(r, R), Kernel::template slope<D>(r, R));
}

template <class Correction, int D>
__global__ void correction_map(double* out, Correction correction, Moments<D> moments, Vec<double, D> X) {
  const GradientMap<D> map = correction.template map<D>(moments);
  keep(out, dot(map.apply(1.0, 1.0, X), X), map.valid ? 1.0 : 0.0);
}

template <class Material, class M>
__global__ void material_response(double* out, Material material, M F) {
  if constexpr (HasHistory<Material>) {
    typename Material::template History<M> history;
    const auto response = material.respond(F, history, 0.0);
    keep(out, trace(response.P), response.energy, acoustic_stiffness(material, F, response.P), history.strain, history.work,
         trace(material.recall(F, history).P), material.hourglass_modulus(history), material.temperature(history));
  } else {
    const auto response = material.respond(F);
    keep(out, trace(response.P), response.energy, acoustic_stiffness(material, F));
  }
}

template <class Material>
__global__ void material_tangent(double* out, Material material, Mat3<double> F) {
  if constexpr (HasHistory<Material>)
    keep(out, trace(material.tangent(F, typename Material::template History<Mat3<double>>{}, 0.0)));
  else
    keep(out, trace(material.tangent(F)));
}

template <class Stabilization, int D>
__global__ void hourglass_shares(double* out, Mat<double, D> F, Vec<double, D> X, Vec<double, D> x) {
  if constexpr (requires { Stabilization::pairwise_linear; }) {
    const auto conservative = Stabilization::conservative_share(F, X, x, 1.0);
    const auto central = Stabilization::central_share(F, X, x, 1.0);
    keep(out, dot(conservative.force, x), conservative.energy, dot(central.force, x), central.energy);
  } else if constexpr (requires(Stabilization s) { s.repulsion(F, 1.0, 1.0); }) {
    keep(out, trace(Stabilization{}.repulsion(F, 1.0, 1.0)));
  } else if constexpr (requires { Stabilization::pull(x, X, 1.0, 1.0); }) {
    keep(out, dot(Stabilization::pull(x, X, 1.0, 1.0), x));
  } else if constexpr (requires(Stabilization s) { s.alpha(1.0, 1.0); }) {
    // computed as another one
  } else {
    const Stabilization s;
    const double mu = Stabilization::approach(x, X, 1.0);
    keep(out, mu, s.strength(mu, 1.0), s.resistance(x, mu, 1.0, 1.0));
  }
}

template <class Coefficients>
__global__ void damping_rate(double* out, Coefficients coefficients, double most) {
  keep(out, coefficients.rate(most));
}

/// Every function of core/vec.hpp.
template <int D>
__global__ void small_matrices(double* out, Mat<double, D> A, Vec<double, D> a) {
  Mat<double, D> B = inverse(A) * transpose(A) + outer(a, A * a) - 2.0 * Mat<double, D>::identity();
  B += cofactor(A);
  B -= A;
  Vec<double, D> b = -a + 2.0 * a - A * a;
  b += a;
  b -= 0.5 * a;
  const Mat3<double> C = embed(in_plane<D>(embed(A, 1.0)), 1.0);
  keep(out, trace(B), determinant(B), double_dot(A, B), norm(b), dot(a, b), trace(C),
       norm(cross(C * Vec3<double>{}, Vec3<double>{})));
}

/// Every function of core/plane_matrix.hpp.
__global__ void plane_matrices(double* out, PlaneMatrix<double> A) {
  PlaneMatrix<double> B = inverse(A) * transpose(A) + A - 2.0 * PlaneMatrix<double>::identity();
  B += cofactor(A);
  B -= A;
  keep(out, trace(B), determinant(B), double_dot(A, B), trace(in_space(B)), trace(in_plane<2>(B)));
}

template <class Material>
void launch_material(double* out, const Material& material) {
  const Mat3<double> F = Mat3<double>::identity();
  material_response<<<1, 1>>>(out, material, F);
  material_response<<<1, 1>>>(out, material, PlaneMatrix<double>::identity());
  material_tangent<<<1, 1>>>(out, material, F);
}

template <int D>
void launch_in_dimensions(double* out) {
  const Vec<double, D> a{};
  const Mat<double, D> A = Mat<double, D>::identity();
  small_matrices<D><<<1, 1>>>(out, A, a);
  Kernels::for_each([&]<class Kernel>() { kernel_values<Kernel, D><<<1, 1>>>(out, 0.5, 1.0); });
  Corrections::for_each([&]<class Correction>() { correction_map<Correction, D><<<1, 1>>>(out, Correction{}, Moments<D>{}, a); });
  Stabilizations::for_each([&]<class Stabilization>() {
    if constexpr (requires { typename Stabilization::Coefficients; })
      damping_rate<<<1, 1>>>(out, Stabilization{}.coefficients(1.0, 1.0), 1.0);
    else
      hourglass_shares<Stabilization, D><<<1, 1>>>(out, A, a, a);
  });
}

}  // namespace

void launch_all(double* out) {
  launch_in_dimensions<2>(out);
  launch_in_dimensions<3>(out);
  plane_matrices<<<1, 1>>>(out, PlaneMatrix<double>::identity());
  Materials::for_each([&]<class Material>() {
    launch_material(out, Material{});
    if constexpr (!HasHistory<Material>) launch_material(out, PlaneStress<Material>{});
  });
}

}  // namespace sinew
