#pragma once
/// A case of two bodies that touch.

#include "run_case.hpp"

namespace sinew::testing {

/// Two disks (balls) of rubber that meet off center; `contact`: keys of [[contact]].
inline std::string two_balls(int dimension, const std::string& contact = "", const std::string& more = "") {
  const std::string z = dimension == 3 ? ", 0" : "", shape = "shape = \"sphere\", radius = 0.5, spacing = 0.1, ";
  return "[case]\ndimension = " + std::to_string(dimension) +
         "\n[material.rubber]\nmodel = \"neo_hookean\"\nyoungs_modulus = 1000.0\npoissons_ratio = 0.4\ndensity = 1.0\n"
         "[[body]]\nname = \"a\"\nmaterial = \"rubber\"\ngeometry = { " +
         shape + "center = [-0.56, 0.1" + z +
         "] }\n"
         "[[body]]\nname = \"b\"\nmaterial = \"rubber\"\ngeometry = { " +
         shape + "center = [0.56, 0" + z +
         "] }\n"
         "[[initial]]\nregion = \"a\"\nvelocity = [1, 0" +
         z + "]\n[[initial]]\nregion = \"b\"\nvelocity = [-0.75, 0" + z +
         "]\n"
         "[[contact]]\n" +
         contact + "[solver]\nend_time = 1.0\n" + more;
}

}  // namespace sinew::testing
