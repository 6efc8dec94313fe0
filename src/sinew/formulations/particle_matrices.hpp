#pragma once
/// What a method knows of all particles besides their displacements.

#include <sinew/formulations/gradient_form.hpp>
#include <sinew/neighbors/threads.hpp>

namespace sinew {

/// Empty where nobody needs it.
template <int D>
struct ParticleMatrices {
  int slots = 0;
  MatrixField<D> gradient;    ///< F - I of the displacements, of copies as well (bonds); or integrated in time (rate)
  MatrixField<D> rate;        ///< of the latter [1/time]
  MatrixField<D> remembered;  ///< of the latter, at the beginning of a step of several stages
  MatrixField<D> stress;      ///< V P, of copies as well (bond_variational) [energy]
  VectorField<D> laplacian;   ///< of the velocities, of copies as well (JST) [1/(length time)]

  void remember() {
    if (remembered.empty()) return;
    for_each_piece(slots, [&](int first, int end) {
      for (int c = 0; c < D * D; ++c)
        std::copy(gradient.component(c) + first, gradient.component(c) + end, remembered.component(c) + first);
    });
  }
  /// A stage of the time integration: begin G_0 + rest (G + dt rate), G_0 what is remembered.
  void advance(double begin, double rest, double dt) {
    if (remembered.empty()) return;
    for_each_piece(slots, [&](int first, int end) {
      for (int c = 0; c < D * D; ++c) {
        const double* __restrict before = remembered.component(c);
        const double* __restrict change = this->rate.component(c);
        double* __restrict now = gradient.component(c);
        for (int slot = first; slot < end; ++slot) now[slot] = begin * before[slot] + rest * (now[slot] + dt * change[slot]);
      }
    });
  }
  std::size_t bytes() const { return gradient.bytes() + rate.bytes() + remembered.bytes() + stress.bytes() + laplacian.bytes(); }
};

}  // namespace sinew
