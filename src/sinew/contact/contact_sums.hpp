#pragma once
/// What contact gives to the balance of energy and to the time step.

#include <algorithm>

namespace sinew {

/// Over the particles of a block.
struct ContactSums {
  double energy = 0.0;      ///< elastic, of the current state [energy]
  double dissipated = 0.0;  ///< by damping and friction so far [energy]
  double work = 0.0;        ///< done by moving walls so far [energy]
  double rate2 = 0.0;       ///< largest contact_rate2 [1/time^2]
  double approach = 0.0;    ///< largest speed of approach over radius, of those that touch or nearly do [1/time]

  double depth = 0.0;  ///< deepest overlap over the distance at which two particles touch, 2 r against a wall [1]

  void begin_step() { energy = rate2 = approach = depth = 0.0; }
};

}  // namespace sinew
