/// Whole runs: conservation, order in time, boundary conditions, loads, and ways to fail.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

std::string without_control(int dimension, const std::string& more = "") {
  return free_block(dimension, more) + "[formulation]\nstabilization = []\n";
}

TEST(Simulation, MomentumStaysToRounding) {
  for (int dimension : {2, 3}) {
    const auto simulation = simulation_of(free_block(dimension));
    const Momenta before = simulation->momenta();
    run_steps(*simulation, 200);
    const Momenta after = simulation->momenta();
    EXPECT_LT(norm(after.linear - before.linear), 1e-12 * before.linear_scale);
    EXPECT_LT(norm(after.angular - before.angular), 1e-11 * before.linear_scale);
  }
}

/// Largest error of the energy balance in a run with that step and stabilization, relative to the initial energy.
double energy_error(double dt, const std::string& stabilization) {
  const auto simulation = simulation_of(free_block(2, "time_step = " + std::to_string(dt) + "\n") +
                                        "[formulation]\nstabilization = " + stabilization + "\n");
  double worst = 0.0;
  while (simulation->time() < 0.02) {
    simulation->step(1e300);
    worst = std::max(worst, std::abs(simulation->energies().balance_error()));
  }
  return worst / simulation->energies().initial;
}

/// Without hourglass stiffness, and with the default one, which has a potential, the energy error is that of the leapfrog alone: it falls with
/// the square of the step. The published central force has no potential: there it stays.
TEST(Simulation, EnergyErrorFallsWithTheSquareOfTheStep) {
  const auto order = [](const std::string& stabilization) {
    return std::log2(energy_error(4e-4, stabilization) / energy_error(2e-4, stabilization));
  };
  EXPECT_LT(energy_error(4e-4, "[]"), 2e-3);
  EXPECT_NEAR(order("[]"), 2.0, 0.3);
  EXPECT_NEAR(order("[{ model = \"hourglass_stiffness\" }]"), 2.0, 0.3);
  EXPECT_LT(order("[{ model = \"hourglass_stiffness\", normalization = \"half\" }]"), 1.5);
}

/// A plate twice as thick moves the same; its forces and energies are twice as large.
TEST(Simulation, ThicknessScalesForcesAndEnergies) {
  std::string thick = free_block(2);
  thick.replace(thick.find("dimension = 2"), 13, "dimension = 2\nthickness = 2.0");
  const auto one = simulation_of(free_block(2)), two = simulation_of(thick);
  run_steps(*one, 50);
  run_steps(*two, 50);
  EXPECT_NEAR(two->energies().strain, 2.0 * one->energies().strain, 1e-12 * two->energies().strain);
  EXPECT_NEAR(two->facts().bodies[0].mass, 2.0 * one->facts().bodies[0].mass, 1e-12);
  EXPECT_LT(norm(two->snapshot({}).position[7] - one->snapshot({}).position[7]), 1e-12);
}

/// Writing many frames: memory that is there already serves again, and the values are those of a new snapshot.
TEST(Simulation, ASnapshotIsFilledAgainInPlace) {
  for (int dimension : {2, 3}) {
    const auto simulation = simulation_of(free_block(dimension));
    const std::vector<std::string> names{"velocity", "cauchy_stress", "deformation_gradient", "pressure"};
    Snapshot reused = simulation->snapshot(names);
    const double* const memory = reused.fields[1].values.data();
    run_steps(*simulation, 7);
    simulation->fill_snapshot(names, reused);
    const Snapshot fresh = simulation->snapshot(names);
    EXPECT_EQ(reused.fields[1].values.data(), memory);
    EXPECT_EQ(reused.step, 7);
    EXPECT_EQ(reused.size, fresh.size);
    EXPECT_EQ(reused.body, fresh.body);
    for (std::size_t f = 0; f < names.size(); ++f) EXPECT_EQ(reused.fields[f].values, fresh.fields[f].values) << names[f];
    for (std::size_t i = 0; i < fresh.position.size(); ++i) EXPECT_EQ(norm(reused.position[i] - fresh.position[i]), 0.0);
  }
}

/// Fields by their definition from F and P, particle by particle; six components of symmetric tensors in the order of the files.
TEST(Simulation, FieldsFollowFromGradientAndStress) {
  const auto simulation = simulation_of(free_block(2));  // 220 particles: the last ones do not fill a vector
  run_steps(*simulation, 20);
  const Snapshot s = simulation->snapshot({"deformation_gradient", "first_piola_kirchhoff_stress", "cauchy_stress", "pressure",
                                           "von_mises_stress", "green_lagrange_strain", "jacobian"});
  ASSERT_EQ(s.position.size(), 220u);
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    Mat3<double> F, P;
    for (int k = 0; k < 9; ++k) F[k / 3][k % 3] = s.fields[0].values[9 * i + k], P[k / 3][k % 3] = s.fields[1].values[9 * i + k];
    const double J = determinant(F);
    const Mat3<double> sigma = (1.0 / J) * (P * transpose(F)), C = transpose(F) * F;
    const double small = 1e-12 * std::sqrt(double_dot(sigma, sigma)) + 1e-300;
    const int row[6] = {0, 1, 2, 0, 1, 0}, column[6] = {0, 1, 2, 1, 2, 2};
    for (int k = 0; k < 6; ++k) {
      EXPECT_NEAR(s.fields[2].values[6 * i + k], sigma[row[k]][column[k]], small);
      EXPECT_NEAR(s.fields[5].values[6 * i + k], 0.5 * (C[row[k]][column[k]] - (row[k] == column[k])), 1e-14);
    }
    const double mean = trace(sigma) / 3.0;
    EXPECT_NEAR(s.fields[3].values[i], -mean, small);
    EXPECT_NEAR(s.fields[4].values[i], std::sqrt(1.5 * (double_dot(sigma, sigma) - 3.0 * mean * mean)), 1e5 * small);
    EXPECT_NEAR(s.fields[6].values[i], J, 1e-13);
  }
}

TEST(Simulation, TimeIntegrationIsOfSecondOrder) {
  const auto tip = [](double dt) {
    const auto simulation = simulation_of(without_control(2, "time_step = " + std::to_string(dt) + "\n"));
    run_until(*simulation, 0.016);
    return simulation->snapshot({}).position.back();
  };
  const Point exact = tip(2.5e-5);
  const double coarse = norm(tip(4e-4) - exact), fine = norm(tip(2e-4) - exact);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.15);
}

TEST(Simulation, FreeFallIsExact) {
  const auto simulation = simulation_of(free_block(2, "[body_force]\nacceleration = [0, -9.81]\n"));
  const Momenta before = simulation->momenta();
  double mass = 0.0;
  for (const auto& body : simulation->facts().bodies) mass += body.mass;
  run_until(*simulation, 0.05);
  EXPECT_NEAR(simulation->momenta().linear[1] - before.linear[1], -9.81 * mass * 0.05, 1e-10);
  EXPECT_LT(std::abs(simulation->energies().balance_error()), 2e-2 * simulation->energies().initial);
}

/// A body force that varies in time gives the momentum of its integral (trapezoidal rule in time, second order).
TEST(Simulation, BodyForceOfPlaceAndTime) {
  const auto simulation = simulation_of(free_block(2, "[body_force]\nacceleration = [\"if(X > 0, 100*t, 0)\", 0]\n"));
  const Momenta before = simulation->momenta();
  run_until(*simulation, 0.05);
  EXPECT_NEAR(simulation->momenta().linear[0] - before.linear[0], 2.2 * 50.0 * 0.05 * 0.05, 1e-3 * 0.275);
}

std::string clamped_strip(const std::string& conditions) {
  return "[case]\ndimension = 2\n[parameters]\nE = 1000.0\n[[body]]\nname = \"strip\"\nmaterial = \"steel\"\n"
         "geometry = { shape = \"box\", low = [0, 0], high = [4, 1], spacing = 0.125 }\n"
         "[material.steel]\nmodel = \"linear_elastic\"\nyoungs_modulus = \"E\"\npoissons_ratio = 0.0\ndensity = 1.0\n"
         "[region]\nleft = { where = \"X < 0.125\" }\nright = { where = \"X > 3.875\" }\n"
         "[[boundary]]\nregion = \"left\"\nvelocity = [0, 0]\n" +
         conditions +
         "[solver]\nend_time = 2.0\ndamping = 20.0\n"
         "[[probe]]\nname = \"u\"\nquantity = \"displacement\"\nregion = \"right\"\ncomponent = \"x\"\n"
         "[[probe]]\nname = \"R\"\nquantity = \"reaction_force\"\nregion = \"left\"\ncomponent = \"x\"\n"
         "[[probe]]\nname = \"w\"\nquantity = \"energy.external_work\"\n";
}

/// Pulled by a traction the strip comes to rest at u = sigma L / E, and its foot carries sigma times the section.
void check_pull(const std::string& condition) {
  const auto simulation = simulation_of(clamped_strip(condition));
  run_until(*simulation, 2.0);
  const std::vector<double> p = simulation->probe_values();
  EXPECT_NEAR(p[0], 10.0 / 1000.0 * 3.75, 0.03 * 0.0375);  // from the middle of the first cells to that of the last
  EXPECT_NEAR(p[1], -10.0, 0.02);
}

TEST(Simulation, TractionForceAndPressureAgree) {
  check_pull("[[boundary]]\nregion = \"right\"\ntraction = [10.0, 0]\n");
  check_pull("[[boundary]]\nregion = \"right\"\nforce = [10.0, 0]\n");
  check_pull("[[boundary]]\nregion = \"right\"\npressure = -10.0\nnormal = [1, 0]\n");
  check_pull("[[boundary]]\nregion = \"right\"\ntraction = [5.0, 0]\narea = 2.0\n");
}

TEST(Simulation, PrescribedDisplacementAndVelocityAgree) {
  const auto by_displacement =
      simulation_of(clamped_strip("[[boundary]]\nregion = \"right\"\ndisplacement = [\"0.02*min(t, 1)\", \"free\"]\n"));
  const auto by_velocity =
      simulation_of(clamped_strip("[[boundary]]\nregion = \"right\"\nvelocity = [\"if(t < 1, 0.02, 0)\", \"free\"]\n"));
  for (const auto& simulation : {by_displacement.get(), by_velocity.get()}) {
    run_until(*simulation, 2.0);
    const std::vector<double> p = simulation->probe_values();
    EXPECT_NEAR(p[0], 0.02, 1e-5);
    EXPECT_NEAR(p[1], -1000.0 * 0.02 / 3.75, 0.03 * 5.3);
    EXPECT_NEAR(p[2] - simulation->energies().dissipated, 0.5 * 0.02 * -p[1], 0.01 * 0.0533);
  }
}

TEST(Simulation, LaterConditionsHoldAndAWarningSaysSo) {
  const auto simulation = simulation_of(clamped_strip("[[boundary]]\nregion = \"left\"\nvelocity = [1.0, \"free\"]\n"));
  simulation->step(1e300);
  ASSERT_FALSE(simulation->facts().warnings.empty());
  EXPECT_NE(simulation->facts().warnings.front().find("the last one in the file holds"), std::string::npos);
  EXPECT_EQ(simulation->snapshot({"velocity"}).fields[0].values[0], 1.0);
}

TEST(Simulation, ABlowUpSaysWhenWhereAndWhy) {
  const auto simulation = simulation_of(without_control(2, "time_step = 0.05\n"));
  try {
    run_steps(*simulation, 200);
    FAIL() << "no error";
  } catch (const SimulationError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("unstable at time"), std::string::npos);
    EXPECT_NE(text.find("particle"), std::string::npos);
    EXPECT_NE(text.find("of body \"block\""), std::string::npos);
    EXPECT_NE(text.find("try"), std::string::npos);
  }
}

std::string message_of(const std::string& text) {
  try {
    simulation_of(text);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Simulation, NumbersThatAreNoneAreRefused) {
  const std::string left = "[region]\nleft = { where = \"X < 0.2\" }\n[[boundary]]\nregion = \"left\"\n";
  EXPECT_NE(
      message_of(free_block(2) + left + "velocity = [\"log(-1-X)\", 0]\n").find("\"log(-1-X)\" is not a finite number at X ="),
      std::string::npos);
  EXPECT_NE(message_of(free_block(2) + left + "force = [\"1/t\", 0]\n").find("is not a finite number"), std::string::npos);
  EXPECT_NE(message_of(free_block(2) + "[body_force]\nacceleration = [\"sqrt(-1 - t)\", 0]\n").find("is not a finite number"),
            std::string::npos);
  EXPECT_NE(message_of(free_block(2) + "[[initial]]\nregion = \"block\"\ndisplacement = [\"-2*X\", 0]\n").find("inside out"),
            std::string::npos);
  EXPECT_NE(message_of(free_block(2) + "[region]\nlate = { where = \"t < 1\" }\n").find("may use X, Y and Z only"),
            std::string::npos);
  const auto later = simulation_of(free_block(2) + left + "velocity = [\"if(t > 0.01, log(-1), 0)\", 0]\n");
  EXPECT_THROW(run_until(*later, 0.02), SimulationError);
}

/// A formula over probes that divides by zero gives a number that is none, and the run goes on.
TEST(Simulation, ProbeFormulas) {
  const auto simulation = simulation_of(free_block(2,
                                                   "[[probe]]\nname = \"v\"\nquantity = \"velocity\"\ncomponent = \"x\"\n"
                                                   "[[probe]]\nname = \"twice\"\nexpression = \"2*v + t\"\n"
                                                   "[[probe]]\nname = \"none\"\nexpression = \"1/(v - v)\"\n"));
  run_steps(*simulation, 3);
  const std::vector<double> p = simulation->probe_values();
  EXPECT_NEAR(p[1], 2.0 * p[0] + simulation->time(), 1e-15);
  EXPECT_FALSE(std::isfinite(p[2]));
}

TEST(Simulation, PointsAtOnePlaceAreNamed) {
  const std::string file = ::testing::TempDir() + "sinew_twice.csv";
  std::ofstream(file) << "x,y,volume\n0,0,1\n1,0,1\n0,1,1\n1,1,1\n1,0,1\n";
  const std::string text =
      "[case]\ndimension = 2\n[[body]]\nname = \"dots\"\nmaterial = { model = \"neo_hookean\", density = 1.0, "
      "youngs_modulus = 1.0, poissons_ratio = 0.3 }\ngeometry = { shape = \"points\", file = \"" +
      file + "\" }\n[solver]\nend_time = 1.0\n";
  EXPECT_NE(message_of(text).find("body \"dots\": points 1 and 4 (counted from 0) are at the same place, (1, 0, 0)"),
            std::string::npos)
      << message_of(text);
}

TEST(Simulation, WrongModelsAreRefused) {
  const std::string second =
      "[[body]]\nname = \"other\"\nmaterial = \"rubber\"\ngeometry = { shape = \"box\", low = [1.9, 0], high = [3, 1], spacing = "
      "0.1 }\n";
  EXPECT_NE(message_of(free_block(2) + second).find("body \"other\" overlaps body \"block\" at"), std::string::npos);
  EXPECT_NE(message_of(free_block(2) + "[region]\nfar = { where = \"X > 7\" }\n")
                .find("region \"far\" selects no particle. Particles have X from"),
            std::string::npos);
  std::string huge = free_block(3);
  huge.replace(huge.find("spacing = 0.1"), 13, "spacing = 1e-5");
  EXPECT_NE(message_of(huge).find("the memory of this machine is enough for about"), std::string::npos);
}

}  // namespace
}  // namespace sinew
