/// Every fast sweep against the slow reference: lattices, disturbed clouds, uneven radii, several bodies, all kernels, 2D and 3D.

#include <gtest/gtest.h>

#include "clouds.hpp"
#include "reference/tlsph_minimal.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

template <int D, class Kernel>
reference::Method<D> reference_method(const AnyMaterial& material, bool corrected, bool plane_stress = false) {
  reference::Method<D> method;
  method.W = [](double r, double R) { return Kernel::template value<D>(r, R); };
  method.slope = [](double r, double R) { return Kernel::template slope<D>(r, R); };
  method.corrected = corrected;
  method.stress = [material, plane_stress](int, const Mat<double, D>& F) {
    return std::visit(
        [&](const auto& m) {
          Mat3<double> F3 = embed(F, 1.0);
          double low = 0.2, high = 5.0;  // plane stress: bisection on P33
          for (int k = 0; plane_stress && k < 200; ++k) {
            F3[2][2] = 0.5 * (low + high);
            (virgin_response(m, F3).P[2][2] > 0.0 ? high : low) = F3[2][2];
          }
          return in_plane<D>(virgin_response(m, F3).P);
        },
        material);
  };
  return method;
}

/// Largest difference between fast and slow forces over the largest force.
template <int D, class Kernel>
double difference(Cloud<D> cloud, const TotalLagrangianOptions& options) {
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, options);
  VectorField<D> forces(cloud.particles.slots);
  solid.internal_forces(cloud.particles, forces);
  double worst = 0.0, largest = 0.0;
  for (std::size_t b = 0; b < cloud.particles.bodies.size(); ++b) {
    const BodyRange& body = cloud.particles.bodies[b];
    const AnyMaterial& material = options.materials[b];
    const double modulus = std::visit([](const auto& m) { return m.elastic.youngs_modulus; }, material);
    std::vector<reference::Particle<D>> slow;
    for (int slot = body.begin; slot < body.begin + body.count; ++slot) {
      slow.push_back({cloud.particles.position[slot], cloud.particles.displacement[slot], cloud.particles.volume[slot],
                      cloud.radius[slot], modulus});
    }
    reference::Method<D> method = reference_method<D, Kernel>(
        material, std::holds_alternative<GradientCorrection>(options.correction), options.plane_stress);
    if (!options.hourglass) method.alpha = 0.0;
    method.conservative = !options.hourglass || options.hourglass->conservative();
    const auto expected = method.forces(slow);
    for (int i = 0; i < body.count; ++i) {
      worst = std::max(worst, norm(forces[body.begin + i] - expected[i]));
      largest = std::max(largest, norm(expected[i]));
    }
  }
  return worst / largest;
}

constexpr double tolerance = 1e-11;
const auto rubber = material_with<NeoHookean>(1.3, 2.0, 0.4);
const auto steel = material_with<StVenantKirchhoff>(1.3, 2.0, 0.3);
const Mat<double, 2> shear2{{{1.1, 0.2}, {-0.1, 0.95}}};
const Mat<double, 3> shear3{{{1.1, 0.2, 0.0}, {-0.1, 0.9, 0.05}, {0.03, 0.0, 1.05}}};

template <int D>
Mat<double, D> shear() {
  if constexpr (D == 2)
    return shear2;
  else
    return shear3;
}

template <int D, class Kernel>
void compare_all_materials(double jitter, bool uneven) {
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 4 : 8, jitter, 2.41, uneven, 1, 5);
  displace<D>(cloud.particles, shear<D>(), 0.05);
  DeformableMaterials::for_each([&]<class M>() {
    TotalLagrangianOptions o = options<D>(material_with<M>(1.3, 2.0, 0.4), 1, Kernel{});
    for (const char* form : {"conservative", "half"}) {
      o.hourglass->normalization.value = form;
      const double d = difference<D, Kernel>(cloud, o);
      EXPECT_LT(d, tolerance) << M::name << " with " << Kernel::name << " in " << D << "D, jitter " << jitter << ", " << form;
    }
  });
}

TEST(Oracle, AllMaterialsAndKernelsOnLattices) {
  Kernels::for_each([]<class K>() { compare_all_materials<2, K>(0.0, false); });
  compare_all_materials<3, Spiky>(0.0, false);
}

TEST(Oracle, DisturbedCloudsWithUnevenVolumesAndRadii) {
  compare_all_materials<2, WendlandC2>(0.3, true);
  compare_all_materials<2, QuinticSpline>(0.3, false);
  compare_all_materials<3, CubicSpline>(0.25, true);
}

TEST(Oracle, WithoutCorrectionAndWithoutHourglass) {
  Cloud<3> cloud = make_cloud<3>(4, 0.2, 2.2, true, 1, 6);
  displace<3>(cloud.particles, shear3, 0.05);
  TotalLagrangianOptions o = options<3>(rubber, 1, Spiky{}, NoCorrection{});
  EXPECT_LT((difference<3, Spiky>(cloud, o)), tolerance);
  o.hourglass.reset();
  EXPECT_LT((difference<3, Spiky>(cloud, o)), tolerance);
}

TEST(Oracle, SeveralBodiesOfDifferentMaterials) {
  Cloud<2> cloud = make_cloud<2>(7, 0.2, 2.41, false, 3, 7);
  displace<2>(cloud.particles, shear2, 0.05);
  TotalLagrangianOptions o = options<2>(rubber, 3);
  o.materials[1] = steel;
  EXPECT_LT((difference<2, Spiky>(cloud, o)), tolerance);
}

TEST(Oracle, PlaneStress) {
  Cloud<2> cloud = make_cloud<2>(7, 0.2, 2.41, false, 1, 8);
  displace<2>(cloud.particles, shear2, 0.05);
  TotalLagrangianOptions o = options<2>(rubber);
  o.plane_stress = true;
  EXPECT_LT((difference<2, Spiky>(cloud, o)), tolerance);
}

/// What is spilled from block to block is all there.
TEST(Oracle, InBlocks) {
  const BlockSize small(30);
  compare_all_materials<2, WendlandC2>(0.3, true);
  compare_all_materials<3, Spiky>(0.0, false);
  compare_all_materials<3, CubicSpline>(0.25, true);
}

/// A particle that nobody is near feels nothing and does not disturb the others (without a gradient correction).
TEST(Oracle, IsolatedParticle) {
  Cloud<2> cloud = make_cloud<2>(6, 0.0, 2.41, false, 1, 9);
  cloud.bodies[0].position.push_back({{-50.0, 3.0, 0.0}});
  cloud.bodies[0].volume.push_back(1.0);
  cloud.particles = make_particles<2>({{"body", &cloud.bodies[0], 1.3, 1.0}}, 1.0);
  cloud.radius.assign(cloud.particles.slots, 2.41);
  displace<2>(cloud.particles, shear2, 0.05);
  const TotalLagrangianOptions o = options<2>(rubber, 1, Spiky{}, NoCorrection{});
  EXPECT_LT((difference<2, Spiky>(cloud, o)), tolerance);
}

}  // namespace
}  // namespace sinew
