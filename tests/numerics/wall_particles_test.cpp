/// Walls made of particles on the current configuration.

#include <gtest/gtest.h>

#include <cmath>

#include "clouds.hpp"
#include "run_case.hpp"
#include <sinew/formulations/wall_particles.hpp>

namespace sinew {
namespace {

using namespace sinew::testing;

/// Disturbed soil for y > 0 on three rows of wall, all of one density.
struct Floor {
  static constexpr double radius = 3.0, density = 2.0;
  std::vector<int> numbers;
  VectorField<2> position;
  VectorField<5> motion, stress;
  AlignedArray<double> mass;
  WallTable<2> table;
  AnyKernel kernel = WendlandC2{};
  MovingNeighbors<2> neighbors;
  WallParticles<2> walls;

  explicit Floor(bool slips) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> move(-0.2, 0.2);
    std::vector<Vec<double, 2>> places;
    for (int j = -3; j < 6; ++j)
      for (int i = 0; i < 12; ++i) places.push_back({{i + (j < 0 ? 0.0 : move(random)), j + 0.5 + (j < 0 ? 0.0 : move(random))}});
    const auto count = static_cast<int>(places.size());
    position = VectorField<2>(count);
    motion = stress = VectorField<5>(count);
    mass = AlignedArray<double>(count);
    table.surfaces = {{slips, {{0.0, 1.0}}}};
    table.gravity = {{0.0, -10.0}};
    for (int p = 0; p < count; ++p) {
      numbers.push_back(p);
      table.of_number.push_back(places[p][1] < 0.0 ? 0 : WallTable<2>::none);
      position.set(p, places[p]);
      for (int c = 0; c < 2; ++c) motion.at(c, p) = places[p][c];
      motion.at(4, p) = 1.0 / density;
      mass[p] = density;
    }
    walls = WallParticles<2>(table);
    neighbors.build(position, numbers, count, radius, MovingGrid<2>(radius, {{-1.0, -3.0}}, {{13.0, 6.0}}, count));
    walls.find_pairs(neighbors, numbers);
  }
  MovingPoints<2> points() const { return {kernel, radius, numbers, motion, mass}; }
  bool is_wall(int p) const { return table.is_wall(numbers[p]); }
  /// One that sees soil.
  bool meets_soil(int p) const { return is_wall(p) && position.at(1, p) > -2.0; }
  void set_stress(int p, double xx, double yy, double xy) {
    const double square = 1.0 / (density * density);
    const double values[] = {xx * square, xy * square, xy * square, yy * square};
    for (int c = 0; c < 4; ++c) stress.at(c, p) = values[c];
  }
};

/// In equilibrium under the weight, sigma_yy = rho g (y - 6): walls go on with it, exactly.
TEST(WallParticles, HaveTheStressOfTheSoilAboveThem) {
  for (const bool slips : {false, true}) {
    Floor floor(slips);
    const auto expected = [](double y) { return Floor::density * 10.0 * (y - 6.0); };
    for (int p = 0; p < static_cast<int>(floor.numbers.size()); ++p)
      floor.is_wall(p) ? floor.set_stress(p, 77.0, 77.0, 77.0)
                       : floor.set_stress(p, -30.0, expected(floor.position.at(1, p)), 4.0);
    floor.walls.extrapolate(floor.points(), floor.stress);
    const double square = Floor::density * Floor::density;
    for (int p = 0; p < static_cast<int>(floor.numbers.size()); ++p)
      if (floor.meets_soil(p)) {
        EXPECT_NEAR(floor.stress.at(0, p) * square, -30.0, 1e-11);
        EXPECT_NEAR(floor.stress.at(3, p) * square, expected(floor.position.at(1, p)), 1e-11);
        EXPECT_NEAR(floor.stress.at(1, p) * square, slips ? 0.0 : 4.0, 1e-12);
        EXPECT_NEAR(floor.stress.at(2, p) * square, slips ? 0.0 : 4.0, 1e-12);
      }
  }
}

/// The part of the list that belongs to a smooth wall: all pairs of soil and wall, from both sides.
TEST(WallParticles, SmoothOnesHaveAListOfTheirOwn) {
  const Floor floor(true), rough(false);
  EXPECT_TRUE(rough.walls.slipping().empty());
  ASSERT_EQ(floor.walls.slipping().size(), 1U);
  const MovingNeighbors<2>& part = floor.walls.slipping()[0].pairs;
  long expected = 0, found = 0;
  for (int p = 0; p < static_cast<int>(floor.numbers.size()); ++p)
    for (int j = 0; j < static_cast<int>(floor.numbers.size()); ++j)
      expected += floor.is_wall(p) != floor.is_wall(j) && norm(floor.position[j] - floor.position[p]) < Floor::radius;
  for (int s = 0; s < part.slices(); ++s)
    for (int k = 0; k < lanes; ++k)
      for (int n = 0; n < part.slice(s).length; ++n) {
        const int offset = part.slice(s).places[lanes * n + k];
        if (part.slice(s).own[k] == part.nobody()) {
          EXPECT_EQ(offset, part.nobody());
        } else if (offset != part.nobody()) {
          EXPECT_NE(floor.is_wall(part.point_at(part.slice(s).own[k] / lanes)), floor.is_wall(part.point_at(offset / lanes)));
          ++found;
        }
      }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(part.pairs(), expected);
}

/// A slab of soil on a slope of 20 degrees: axes along it.
std::string slab(const std::string& wall, const std::string& more = "") {
  return "[case]\ndimension = 2\n[[body]]\nname = \"soil\"\nmaterial = { model = \"hypoelastic\", youngs_modulus = 1e6, "
         "poissons_ratio = 0.3, density = 2000.0 }\ngeometry = { shape = \"box\", low = [0, -0.3], high = [3, 0.5], spacing = "
         "0.1 }\n"
         "[formulation]\nmodel = \"updated_lagrangian\"\nstabilization = [{ model = \"artificial_viscosity\" }]\n[body_force]\n"
         "acceleration = [3.42, -9.40]\n[[boundary]]\nregion = { where = \"Y < 0\" }\n" +
         wall +
         "\n[solver]\nend_time = 0.2\n[[probe]]\nname = \"speed\"\nquantity = \"velocity\"\ncomponent = \"x\"\nreduce = "
         "\"mean\"\nregion = { "
         "where = \"Y > 0 && X > 0.5 && X < 2.5\" }\n" +
         more;
}

TEST(WallParticles, RoughOnesHoldAndSmoothOnesLetGo) {
  const std::string pushed =
      "[[probe]]\nname = \"push\"\nquantity = \"reaction_force\"\ncomponent = \"x\"\nregion = { where = \"Y < 0\" }\n";
  const auto smooth = simulation_of(slab("wall = \"free_slip\"\nnormal = [0, 1]", pushed)),
             rough = simulation_of(slab("wall = \"no_slip\"", pushed));
  run_until(*smooth, 0.2);
  run_until(*rough, 0.2);
  EXPECT_NEAR(smooth->momenta().linear[0], 3 * 0.5 * 2000.0 * 3.42 * 0.2, 1e-9 * 3000.0);
  EXPECT_NEAR(smooth->probe_values()[0], 3.42 * 0.2, 0.02 * 3.42 * 0.2);
  EXPECT_NEAR(smooth->probe_values()[1], -3 * 0.3 * 2000.0 * 3.42, 1e-9 * 3000.0);  // what holds the wall itself
  EXPECT_LT(std::abs(rough->probe_values()[0]), 0.2 * 3.42 * 0.2);
}

TEST(WallParticles, MayMove) {
  const auto simulation =
      simulation_of(slab("wall = \"no_slip\"",
                         "[[boundary]]\nregion = { where = \"Y < 0\" }\nvelocity = [1, 0]\n[[probe]]\nname = "
                         "\"lowest\"\nquantity = \"displacement\"\ncomponent = \"x\"\nreduce = \"min\"\nregion = { "
                         "where = \"Y < 0\" }\n"));
  run_until(*simulation, 0.2);
  EXPECT_NEAR(simulation->probe_values()[1], 0.2, 1e-12);
  EXPECT_GT(simulation->probe_values()[0], 0.5);
}

TEST(WallParticles, RestartHasTheSameBits) {
  const std::string text = slab("wall = \"free_slip\"\nnormal = [0, 1]");
  const auto whole = simulation_of(text), resumed = simulation_of(text);
  run_steps(*whole, 30);
  resumed->restore(whole->save());
  for (Simulation* each : {whole.get(), resumed.get()}) run_steps(*each, 30);
  EXPECT_EQ(resumed->state_hash(), whole->state_hash());
}

}  // namespace
}  // namespace sinew
