#pragma once
/// A reference configuration that is renewed: once a pair has become much longer than it was, all particles take their current places as their reference ones.
///
///     max_ij | |x_ij| / |X_ij| - 1 | >= k:   X <- x, V <- J V                Islam & Peng (2019), sec. 4.2 and eq. 39-41
///
/// Displacements, velocities and masses stay, so momentum and kinetic energy do. The deformation until then, "earlier", is kept: materials go on to see all of it, F = since * earlier,
/// and histories stay as they are. The stress turns to the new frame, P earlier^T per first volume. Materials that are written in rates need no more of it than the volume, see RateForm::forget_shape.

#include <sinew/formulations/gradient_form.hpp>
#include <sinew/formulations/slice_slots.hpp>
#include <sinew/parallel/share.hpp>

namespace sinew {

template <int D>
class LaterReference {
 public:
  /// `whole`: the first configuration of all particles of all ranks, `owner`: the rank of each of its blocks, `particles`: those of this rank.
  LaterReference(Arrangement<D> whole, std::vector<int> owner, const Particles<D>& particles, double threshold, double thickness);

  bool renewed() const { return updates_ > 0.0; }
  long updates() const { return static_cast<long>(updates_); }

  /// Whether a pair has reached the threshold. It looks at all pairs only if any may have done so since it last looked. Collective.
  bool is_due(const Comm& comm, const Particles<D>& here, const BlockPairs<D>& pairs);

  /// The particles as seen from the present reference configuration: the same ones if there has been no update.
  Particles<D>& follow(Particles<D>& particles, bool with_velocities);

  /// To be filled before adopt(): F - I at the update, by slot.
  MatrixField<D>& earlier() { return earlier_; }
  Mat<Pack, D> earlier(const SliceSlots<D>& slots) const { return Mat<Pack, D>::identity() + slots.load_matrix(earlier_); }
  const double* first_volume() const { return first_volume_.data(); }

  /// Makes where the particles are their reference configuration. `radius`: of the supports, by slot. Collective.
  SharedPairs<D> adopt(const Comm& comm, const Particles<D>& particles, const std::vector<double>& radius);
  /// The same for places and deformations that have been restored.
  SharedPairs<D> adopt_again(const Comm& comm, const Particles<D>& particles, const std::vector<double>& radius);

  // for restarts
  double& number_of_updates() { return updates_; }
  VectorField<D>& shift() { return shift_; }

  std::size_t bytes() const;

 private:
  void place_own(const Particles<D>& particles);
  void place_others(const Comm& comm);
  double longest(const Particles<D>& here, const BlockPairs<D>& pairs);

  Arrangement<D> whole_;
  std::vector<int> owner_;
  double threshold_, thickness_;
  double updates_ = 0.0;
  VectorField<D> shift_;    ///< displacements at the last update
  MatrixField<D> earlier_;  ///< F - I there
  AlignedArray<double> first_volume_;
  Particles<D> here_;  ///< of the present configuration, with displacements since it

  // when it looks at pairs
  VectorField<D> looked_at_;  ///< displacements, in the present configuration
  double room_ = -1.0;        ///< how far particles may move from there before a pair can reach the threshold [length]
  std::vector<double> scratch_;
};

extern template class LaterReference<2>;
extern template class LaterReference<3>;

}  // namespace sinew
