#include <sinew/formulations/moving_sweep_work.hpp>

namespace sinew {

template <>
void sweep_velocity_gradients<2>(const GradientSweep<2>& sweep) {
  sweep_gradients(sweep);
}
template <>
void sweep_moving_forces<2>(const ForceSweep<2>& sweep) {
  sweep_forces(sweep);
}

}  // namespace sinew
