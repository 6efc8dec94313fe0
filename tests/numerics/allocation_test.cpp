/// A step allocates nothing.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "run_case.hpp"

namespace {
std::atomic<long> allocations{0};
}  // namespace

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"  // both are replaced, which GCC 12 does not see without optimization
#endif
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace sinew {
namespace {

using namespace sinew::testing;

TEST(Allocation, AStepAllocatesNothing) {
  for (const std::string integrator : {"velocity_verlet", "rk3"}) {
    const auto simulation = simulation_of(free_block(
        3, "integrator = \"" + integrator +
               "\"\ndamping = 2.0\n[region]\nleft = { where = \"X < 0.2\" }\n[[boundary]]\nregion = \"left\"\nvelocity = [0, "
               "\"x*t\", 0]\n"
               "[body_force]\nacceleration = [0, 0, -9.81]\n"));
    run_steps(*simulation, 3);
    const long before = allocations;
    run_steps(*simulation, 20);
    EXPECT_EQ(allocations - before, 0) << integrator;
  }
}

TEST(Allocation, NorDoesOneOfTheExtendedMethods) {
  for (const std::string form : {"rate", "bond", "bond_variational"}) {
    const auto simulation =
        simulation_of(free_block(3, "integrator = \"rk3\"\n[formulation]\ncorrection = \"linear\"\ndeformation_gradient = \"" +
                                        form + "\"\nstabilization = [{ model = \"jst\", eta2 = 0.01 }]\n"));
    run_steps(*simulation, 3);
    const long before = allocations;
    run_steps(*simulation, 20);
    EXPECT_EQ(allocations - before, 0) << form;
  }
}

/// On the current configuration, while lists are made anew.
TEST(Allocation, NorDoesOneThatFindsNeighbors) {
  const auto simulation = simulation_of(
      free_block(3,
                 "cfl = 0.9\n[formulation]\nmodel = \"updated_lagrangian\"\nstabilization = [{ model = \"non_nested_shear\" }, { "
                 "model = \"artificial_viscosity\" }, { model = \"artificial_stress\" }]\n[[boundary]]\nregion = \"block\"\n"
                 "velocity = [40, 0, 0]\n"));
  run_steps(*simulation, 12);
  const long before = allocations;
  run_steps(*simulation, 20);
  EXPECT_EQ(allocations - before, 0);
}

/// Bodies at rest that touch, on a wall, of metal with damage, with viscosity: no list is made anew, and nothing else allocates.
TEST(Allocation, NorDoesOneWithContact) {
  const auto simulation = simulation_of(
      "[case]\ndimension = 2\n[material.m]\nmodel = \"j2_plastic\"\nyoungs_modulus = 1000.0\npoissons_ratio = 0.3\ndensity = "
      "1.0\nyield_stress = 5.0\n"
      "damage = { model = \"plastic_strain\", limit = 0.1 }\n"
      "[[body]]\nname = \"a\"\nmaterial = \"m\"\ngeometry = { shape = \"box\", low = [0, 0], high = [1, 1], spacing = 0.1 }\n"
      "[[body]]\nname = \"b\"\nmaterial = \"m\"\ngeometry = { shape = \"box\", low = [0, 0.995], high = [1, 2], spacing = 0.1 }\n"
      "[[contact]]\nfriction = 0.1\n[[wall]]\nname = \"ground\"\ngeometry = { shape = \"plane\", point = [0, 0], normal = [0, 1] "
      "}\n"
      "[formulation]\nstabilization = [{ model = \"hourglass_stiffness\" }, { model = \"artificial_viscosity\" }]\n"
      "[body_force]\nacceleration = [0, -9.81]\n[solver]\nend_time = 1\n");
  run_steps(*simulation, 3);
  const long before = allocations;
  run_steps(*simulation, 20);
  EXPECT_EQ(allocations - before, 0);
}

}  // namespace
}  // namespace sinew
