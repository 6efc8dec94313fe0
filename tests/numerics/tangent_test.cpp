/// The derivative of the forces: against differences of forces, as a product and as matrices.

#include <gtest/gtest.h>

#include <cmath>

#include "clouds.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

template <int D>
void shake(VectorField<D>& field, const Particles<D>& particles) {
  for (int slot : particles.slot_of)
    for (int c = 0; c < D; ++c) field.at(c, slot) = std::sin(3.1 * slot + 1.7 * c + 0.3 * particles.position.at(0, slot));
}

/// A solid in a deformed state, with what its forces change by along some direction.
template <int D>
struct Linearized {
  static constexpr PointStep step{0.01, HistoryUse::respond};
  Cloud<D> cloud;
  TotalLagrangian<D> solid;
  VectorField<D> start, direction, change;

  Linearized(Cloud<D> of, const TotalLagrangianOptions& o, double bump)
      : cloud(std::move(of)),
        solid(cloud.particles, cloud.radius, o),
        direction(cloud.particles.slots),
        change(cloud.particles.slots) {
    Mat<double, D> A = Mat<double, D>::identity();
    A[0][1] = 0.05, A[0][0] = 1.04;
    displace<D>(cloud.particles, A, bump);
    start = cloud.particles.displacement;
    shake<D>(direction, cloud.particles);
    solid.keep_linearization(cloud.particles);
    forces_at(0.0);
    std::swap(cloud.particles.displacement, direction);
    solid.tangent_forces(cloud.particles, change, step);
    std::swap(cloud.particles.displacement, direction);
  }
  VectorField<D> forces_at(double distance) {
    for (int slot : cloud.particles.slot_of)
      for (int c = 0; c < D; ++c) cloud.particles.displacement.at(c, slot) = start.at(c, slot) + distance * direction.at(c, slot);
    VectorField<D> forces(cloud.particles.slots);
    solid.internal_forces(cloud.particles, forces, step, [](int, int) {});
    return forces;
  }
  double largest_change() const {
    double most = 0.0;
    for (int slot : cloud.particles.slot_of)
      for (int c = 0; c < D; ++c) most = std::max(most, std::abs(change.at(c, slot)));
    return most;
  }
  /// Largest difference to a central difference, over the largest change.
  double error_of_product(double h) {
    const VectorField<D> ahead = forces_at(h), behind = forces_at(-h);
    double worst = 0.0;
    for (int slot : cloud.particles.slot_of)
      for (int c = 0; c < D; ++c)
        worst = std::max(worst, std::abs((ahead.at(c, slot) - behind.at(c, slot)) / (2.0 * h) - change.at(c, slot)));
    return worst / largest_change();
  }
  /// The same of the matrices; and how far they are from symmetric, over their largest entry.
  double error_of_matrices(double& asymmetry) {
    VectorField<D> sum(cloud.particles.slots);
    asymmetry = 0.0;
    double most = 0.0;
    forces_at(0.0);
    solid.for_each_stiffness(cloud.particles, TotalLagrangian<D>::Reach::all, step,
                             [&](std::span<const int> slots, std::span<const double> K) {
                               const std::size_t size = D * slots.size();
                               for (std::size_t r = 0; r < size; ++r)
                                 for (std::size_t c = 0; c < size; ++c) {
                                   sum.at(r % D, slots[r / D]) += K[r * size + c] * direction.at(c % D, slots[c / D]);
                                   most = std::max(most, std::abs(K[r * size + c]));
                                   asymmetry = std::max(asymmetry, std::abs(K[r * size + c] - K[c * size + r]));
                                 }
                             });
    asymmetry /= most;
    double worst = 0.0;
    for (int slot : cloud.particles.slot_of)
      for (int c = 0; c < D; ++c) worst = std::max(worst, std::abs(sum.at(c, slot) + change.at(c, slot)));
    return worst / largest_change();
  }
};

template <int D>
Cloud<D> uneven_cloud() {
  return make_cloud<D>(D == 3 ? 4 : 7, 0.3, 2.3, true, 1, 5);
}
template <int D>
Cloud<D> lattice_cloud() {
  return make_cloud<D>(D == 3 ? 6 : 12, 0.0, 2.41, false, 1, 5);
}

template <int D>
void check_all(const TotalLagrangianOptions& o, double bump, bool symmetric) {
  const BlockSize small(100);
  for (const bool uneven : {true, false}) {
    Linearized<D> state(uneven ? uneven_cloud<D>() : lattice_cloud<D>(), o, bump);
    EXPECT_LT(state.error_of_product(1e-6), 2e-8) << D << "D, uneven " << uneven;
    double asymmetry = 0.0;
    EXPECT_LT(state.error_of_matrices(asymmetry), 1e-12) << D << "D, uneven " << uneven;
    EXPECT_LT(symmetric ? asymmetry : 0.0, 1e-13);
  }
}

TEST(Tangent, IsTheDerivativeOfTheForcesForEveryMaterial) {
  DeformableMaterials::for_each([]<class M>() {
    SCOPED_TRACE(std::string(M::name));
    const bool in_rates = requires { M::in_rates; };
    check_all<2>(options<2>(material_with<M>(1.3, 2.0, 0.3)), 0.1, !in_rates);
    check_all<3>(options<3>(material_with<M>(1.3, 2.0, 0.3)), 0.1, !in_rates);
  });
}

TEST(Tangent, InPlaneStress) {
  ElasticMaterials::for_each([]<class M>() {
    SCOPED_TRACE(std::string(M::name));
    TotalLagrangianOptions o = options<2>(material_with<M>(1.3, 2.0, 0.3));
    o.plane_stress = true;
    o.thickness = 0.2;
    check_all<2>(o, 0.1, true);
  });
}

TEST(Tangent, WithEveryCorrectionAndWithoutHourglassStiffness) {
  const auto rubber = material_with<NeoHookean>(1.3, 2.0, 0.4);
  Corrections::for_each([&]<class C>() {
    SCOPED_TRACE(std::string(C::name));
    check_all<2>(options<2>(rubber, 1, QuinticSpline{}, C{}), 0.1, false);
    TotalLagrangianOptions none = options<3>(rubber, 1, CubicSpline{}, C{});
    none.hourglass.reset();
    check_all<3>(none, 0.1, true);
  });
}

TEST(Tangent, OfMetalThatHasFlowedBefore) {
  const auto metal = material_with<J2<VoceHardening>>(1.3, 2.0, 0.3);
  const BlockSize small(100);
  Cloud<2> cloud = uneven_cloud<2>();
  Linearized<2> state(std::move(cloud), options<2>(metal), 0.1);
  VectorField<2> forces(state.cloud.particles.slots);
  const ForceSummary flowed =
      state.solid.internal_forces(state.cloud.particles, forces, {0.01, HistoryUse::advance}, [](int, int) {});
  EXPECT_GT(flowed.plastic_work, 0.0);
  state.change.clear();
  for (int slot : state.cloud.particles.slot_of)
    for (int c = 0; c < 2; ++c) state.start.at(c, slot) *= 1.2;
  state.forces_at(0.0);
  std::swap(state.cloud.particles.displacement, state.direction);
  state.solid.tangent_forces(state.cloud.particles, state.change, state.step);
  std::swap(state.cloud.particles.displacement, state.direction);
  EXPECT_LT(state.error_of_product(1e-6), 2e-8);
  double asymmetry = 0.0;
  EXPECT_LT(state.error_of_matrices(asymmetry), 1e-12);
}

/// With the nearest neighbors alone: few, and still exact for linear displacements, which leave no force inside and no hourglass energy.
template <int D>
void check_nearest() {
  Cloud<D> cloud = lattice_cloud<D>();
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, options<D>(material_with<LinearElastic>(1.3, 2.0, 0.3)));
  solid.keep_linearization(cloud.particles);
  VectorField<D> forces(cloud.particles.slots);
  solid.internal_forces(cloud.particles, forces, {}, [](int, int) {});
  Mat<double, D> A = Mat<double, D>::identity();
  A[0][0] = 2.0, A[D - 1][0] = 0.5;
  displace<D>(cloud.particles, A, 0.0);
  double energy = 0.0, most = 0.0;
  solid.for_each_stiffness(cloud.particles, TotalLagrangian<D>::Reach::nearest, {},
                           [&](std::span<const int> slots, std::span<const double> K) {
                             const std::size_t size = D * slots.size();
                             most = std::max(most, static_cast<double>(slots.size()));
                             for (std::size_t r = 0; r < size; ++r)
                               for (std::size_t c = 0; c < size; ++c)
                                 energy += 0.5 * K[r * size + c] * cloud.particles.displacement.at(r % D, slots[r / D]) *
                                           cloud.particles.displacement.at(c % D, slots[c / D]);
                           });
  const ForceSummary exact = solid.internal_forces(cloud.particles, forces, {}, [](int, int) {});
  EXPECT_EQ(most, 2.0 * D + 1.0);
  EXPECT_NEAR(energy, exact.strain_energy, 1e-11 * exact.strain_energy);
}

TEST(Tangent, OfTheNearestNeighborsHasTheEnergyOfLinearDisplacements) {
  check_nearest<2>();
  check_nearest<3>();
}

}  // namespace
}  // namespace sinew
