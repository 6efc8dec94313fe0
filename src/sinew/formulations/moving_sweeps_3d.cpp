#include <sinew/formulations/moving_sweep_work.hpp>

namespace sinew {

template <>
void sweep_velocity_gradients<3>(const GradientSweep<3>& sweep) {
  sweep_gradients(sweep);
}
template <>
void sweep_moving_forces<3>(const ForceSweep<3>& sweep) {
  sweep_forces(sweep);
}

}  // namespace sinew
