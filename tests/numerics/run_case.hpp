#pragma once
/// Cases as texts, for tests of whole runs.

#include <sinew/io/read_toml.hpp>
#include <sinew/model/simulation.hpp>

namespace sinew::testing {

inline std::unique_ptr<Simulation> simulation_of(const std::string& text) {
  return Simulation::build(make_case(read_toml_text(text, "case.toml"), "."));
}

inline void run_steps(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step(1e300);
}
inline void run_until(Simulation& simulation, double time) {
  while (simulation.time() < time) simulation.step(time - simulation.time());
}

/// A free 2D or 3D block of rubber, disturbed particles, initial velocities, no conditions.
inline std::string free_block(int dimension, const std::string& more = "") {
  const bool space = dimension == 3;
  return std::string("[case]\ndimension = ") + (space ? "3" : "2") +
         "\n[[body]]\nname = \"block\"\nmaterial = \"rubber\"\n"
         "geometry = { shape = \"box\", low = " +
         (space ? "[0, 0, 0], high = [1, 0.6, 0.6]" : "[0, 0], high = [2, 1.1]") +
         ", spacing = 0.1, jitter = 0.2 }\n"
         "[material.rubber]\nmodel = \"neo_hookean\"\nyoungs_modulus = 1000.0\npoissons_ratio = 0.4\ndensity = 1.0\n"
         "[[initial]]\nregion = \"block\"\nvelocity = " +
         (space ? "[\"3*sin(2*y)\", \"-2*x\", \"x*y\"]" : "[\"3*sin(2*y)\", \"-2*x\"]") + "\n[solver]\nend_time = 1.0\n" + more;
}

}  // namespace sinew::testing
