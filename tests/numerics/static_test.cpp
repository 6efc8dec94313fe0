/// Balance of forces by Newton's method.

#include <gtest/gtest.h>

#include <cmath>

#include "clouds.hpp"
#include "run_case.hpp"
#include <sinew/implicit/implicit_solver.hpp>

namespace sinew {
namespace {

using namespace sinew::testing;

/// A block whose lowest row is held and whose highest row is moved by `pull`, in one step.
template <int D>
struct Pulled {
  Cloud<D> cloud;
  TotalLagrangian<D> solid;
  Loads<D> loads;
  PrescribedMotion<D> motion;
  ImplicitSolver<D> solver;

  Pulled(Cloud<D> of, const TotalLagrangianOptions& o, double pull, const NewtonOptions& options)
      : cloud(std::move(of)),
        solid(cloud.particles, cloud.radius, o),
        motion(conditions(cloud.particles, pull), cloud.particles),
        solver(Comm(), cloud.particles, solid, loads, motion, {options, {}, 0.0, 2.0}) {}

  NewtonResult step(double time, double dt) {
    motion.remember(cloud.particles);
    return solver.solve(time, dt);
  }

  static std::vector<MotionCondition> conditions(const Particles<D>& particles, double pull) {
    double low = 1e300, high = -1e300;
    for (int slot : particles.slot_of) {
      low = std::min(low, particles.position.at(1, slot));
      high = std::max(high, particles.position.at(1, slot));
    }
    std::vector<MotionCondition> all;
    for (int c = 0; c < D; ++c)
      for (const bool top : {false, true}) {
        const double value = top ? (c == 1 ? pull : 0.3 * pull) : 0.0;
        MotionCondition m{MotionCondition::Kind::displacement, c, {}, {}};
        m.function = {[value](const Point&, const Point&, double t) { return value * t; }, false, "pull"};
        for (int slot : particles.slot_of)
          if (std::abs(particles.position.at(1, slot) - (top ? high : low)) < 0.4) m.slots.push_back(slot);
        std::sort(m.slots.begin(), m.slots.end());
        all.push_back(std::move(m));
      }
    return all;
  }
};

/// The error of an iterate is the square of the one before it: residuals r of a quadratic method have r_n+1 <= C r_n^2 near the end.
void expect_quadratic(const NewtonResult& result, const std::string& name) {
  ASSERT_TRUE(result.converged) << name << ": " << result.reason;
  const std::vector<double>& r = result.residuals;
  ASSERT_GE(r.size(), 3U) << name << " takes too few iterations to tell";
  bool seen = false;
  for (std::size_t n = 1; n < r.size(); ++n)
    if (r[n - 1] < 1e-1 && r[n - 1] > 1e-6) {
      EXPECT_LT(r[n], std::max(300.0 * r[n - 1] * r[n - 1], 1e-12)) << name << ", iteration " << n;
      seen = true;
    } else if (r[n - 1] >= 1e-1 && r[n] < 1e-9) {
      seen = true;  // all at once
    }
  EXPECT_TRUE(seen) << name << ": " << ::testing::PrintToString(r);
}

TEST(Static, NewtonConvergesQuadraticallyForEveryMaterial) {
  DeformableMaterials::for_each([]<class M>() {
    if constexpr (!std::is_same_v<M, LinearElastic>) {
      NewtonOptions o;
      o.tolerance = 1e-11;
      if constexpr (requires { M::in_rates; }) o.symmetric = false;
      Pulled<2> body(make_cloud<2>(6, 0.2, 2.41, true, 1, 3), options<2>(material_with<M>(1.3, 2.0, 0.3)), 0.8, o);
      expect_quadratic(body.step(0.0, 1.0), std::string(M::name));
    }
  });
}

TEST(Static, ALinearBodyNeedsNoIteration) {
  Pulled<3> body(make_cloud<3>(4, 0.2, 2.41, true, 1, 3), options<3>(material_with<LinearElastic>(1.3, 2.0, 0.3)), 0.1, {});
  const NewtonResult result = body.step(0.0, 1.0);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.residuals.size(), 1U);
  EXPECT_LT(result.residuals[0], 1e-10);
}

/// The same displacements by direct and by iterative solvers.
TEST(Static, AllLinearSolversAgree) {
  const auto rubber = material_with<NeoHookean>(1.3, 2.0, 0.4);
  std::vector<VectorField<3>> found;
  for (const int kind : {0, 1, 2}) {
    NewtonOptions o;
    o.tolerance = 1e-10;
    o.linear = kind == 0 ? LinearSolver::direct : LinearSolver::iterative;
    o.matrix_free = kind == 2;
    Pulled<3> body(make_cloud<3>(6, 0.2, 2.41, false, 1, 3), options<3>(rubber), 1.0, o);
    const NewtonResult result = body.step(0.0, 1.0);
    EXPECT_TRUE(result.converged) << kind << ": " << result.reason;
    found.push_back(body.cloud.particles.displacement);
    for (int slot : body.cloud.particles.slot_of)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found.back().at(c, slot), found.front().at(c, slot), 1e-8) << kind;
  }
}

const char* const bar =
    "[case]\ndimension = 2\n[[body]]\nname = \"bar\"\nmaterial = { model = \"linear_elastic\", density = 1, youngs_modulus = "
    "100, poissons_ratio = 0.3 }\n"
    "geometry = { shape = \"box\", low = [0, 0], high = [4, 1], spacing = 0.25, on_faces = true }\n"
    "[region]\nleft = { where = \"X < 0.01\" }\nfoot = { nearest = [0, 0] }\nright = { where = \"X > 3.99\" }\n"
    "[[boundary]]\nregion = \"left\"\ndisplacement = [0, \"free\"]\n"
    "[[boundary]]\nregion = \"foot\"\ndisplacement = [\"free\", 0]\n"
    "[[boundary]]\nregion = \"right\"\ntraction = [2, 0]\narea = 1\n";

std::string bar_with(const std::string& more) { return bar + more; }

/// Plane strain: u_x = sigma (1 - nu^2) / E L. What a face carries in SPH is not quite what quadrature says, so that the error falls with the spacing.
TEST(Static, ABarUnderTractionTendsToTheLengthOfTheory) {
  const double exact = 2.0 * (1.0 - 0.09) / 100.0 * 4.0;
  double error = 0.03 * exact;
  for (const char* spacing : {"0.25 ", "0.125", "0.05 "}) {
    std::string text = bar_with(
        "[solver]\nmode = \"static\"\n[[probe]]\nname = \"tip\"\nquantity = \"displacement\"\ncomponent = \"x\"\n"
        "region = \"right\"\n");
    text.replace(text.find("spacing = 0.25"), 14, "spacing = " + std::string(spacing));
    const auto simulation = simulation_of(text);
    run_until(*simulation, 1.0);
    EXPECT_EQ(simulation->steps(), 10);
    EXPECT_LT(std::abs(simulation->probe_values()[0] - exact), error) << spacing;
    error = 0.7 * std::abs(simulation->probe_values()[0] - exact);
    const Energies e = simulation->energies();
    EXPECT_EQ(e.kinetic, 0.0);
    EXPECT_NEAR(e.external_work, e.total(), 1e-7 * e.total());
    EXPECT_NEAR(e.external_work, simulation->probe_values()[0], 0.02 * e.external_work);
  }
}

/// Loads that do not depend on t grow with it; with ramp = false, or with t in them, they are what they say.
TEST(Static, LoadsGrowInProportionToTimeUnlessTheyDependOnIt) {
  const std::string probe = "[[probe]]\nname = \"tip\"\nquantity = \"displacement\"\ncomponent = \"x\"\nregion = \"right\"\n";
  const auto at_half = [&](const std::string& text) {
    const auto simulation = simulation_of(text);
    run_until(*simulation, 0.5);
    return simulation->probe_values()[0];
  };
  std::string quadratic = bar_with("[solver]\nmode = \"static\"\n" + probe);
  quadratic.replace(quadratic.find("[2, 0]"), 6, "[\"2*t^2\", 0]");
  const double ramped = at_half(bar_with("[solver]\nmode = \"static\"\n" + probe));
  EXPECT_NEAR(at_half(bar_with("[solver]\nmode = \"static\"\nramp = false\n" + probe)), 2.0 * ramped, 1e-9 * ramped);
  EXPECT_NEAR(at_half(quadratic), 0.5 * ramped, 1e-9 * ramped);
}

/// A load that nothing can bear: an error that says so, and the last balance is kept.
TEST(Static, KeepsTheLastBalanceWhereThereIsNoMore) {
  std::string text = bar_with("[solver]\nmode = \"static\"\n");
  text.replace(text.find("linear_elastic"), 14, "j2_plastic");
  text.replace(text.find("poissons_ratio = 0.3"), 20, "poissons_ratio = 0.3, yield_stress = 1");
  text.replace(text.find("region = \"left\"\ndisplacement = [0, \"free\"]"), 42, "region = \"left\"\ndisplacement = [0, 0]     ");
  const auto simulation = simulation_of(text);
  std::string message;
  try {
    run_until(*simulation, 1.0);
  } catch (const SimulationError& error) {
    message = error.what();
  }
  EXPECT_NE(message.find("no balance found between"), std::string::npos) << message;
  EXPECT_GT(simulation->time(), 0.4);
  EXPECT_LT(simulation->time(), 0.7);
  EXPECT_TRUE(std::isfinite(simulation->energies().total()));
}

TEST(Static, SaysWhichBodyIsNotHeld) {
  std::string text = bar_with("[solver]\nmode = \"static\"\n");
  text.replace(text.find("displacement = [0, \"free\"]"), 26, "force = [0, 0]            ");
  text.replace(text.find("displacement = [\"free\", 0]"), 26, "displacement = [0, 0]     ");
  std::string message;
  try {
    simulation_of(text);
  } catch (const CaseError& error) {
    message = error.what();
  }
  EXPECT_EQ(
      message,
      "body \"bar\" is not held: 2 of the components of its displacements are given, and it takes at least 3 to keep it from "
      "moving and turning. Give a [[boundary]] with displacement.");
}

/// The cantilever of an explicit run with damping comes to rest where the static one is.
TEST(Static, IsWhereADampedMotionComesToRest) {
  const auto beam = [](const std::string& solver) {
    const auto simulation = simulation_of(
        "[case]\ndimension = 2\n[[body]]\nname = \"beam\"\nmaterial = { model = \"neo_hookean\", density = 1, youngs_modulus = "
        "100, poissons_ratio = 0.3 }\n"
        "geometry = { shape = \"box\", low = [0, 0], high = [4, 1], spacing = 0.25 }\n"
        "[region]\nleft = { where = \"X < 0.25\" }\nright = { where = \"X > 3.75\" }\n"
        "[[boundary]]\nregion = \"left\"\ndisplacement = [0, 0]\n"
        "[[boundary]]\nregion = \"right\"\nforce = [0, -0.4]\n"
        "[[probe]]\nname = \"tip\"\nquantity = \"displacement\"\ncomponent = \"y\"\nregion = \"right\"\n" +
        solver);
    run_until(*simulation, simulation->end_time());
    return simulation->probe_values()[0];
  };
  const double still = beam("[solver]\nmode = \"static\"\n");
  EXPECT_LT(still, -0.5);
  EXPECT_NEAR(beam("[solver]\nend_time = 60\ndamping = 0.7\n"), still, 1e-6 * std::abs(still));
}

}  // namespace
}  // namespace sinew
