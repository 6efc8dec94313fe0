#pragma once
/// Takes the net moment out of internal forces that do not conserve angular momentum: of all changes of the forces with sum f = 0 and sum r x f = 0 afterwards, the one that
/// is smallest in sum |change|^2 / m, which is a rigid angular acceleration about the center of mass,
///
///     f_i -= m_i (I^-1 T) x r_i,   T = sum r_i x f_i,   I = sum m_i (|r_i|^2 1 - r_i (x) r_i),   r_i = x_i - sum m x / sum m
///
/// body by body. The projection that Wiragunarsa et al. (2024), sec. 6, name as future work; as Lee et al. (2016) do it.

#include <sinew/parallel/comm.hpp>
#include <sinew/particles/particles.hpp>

namespace sinew {

template <int D>
class AngularProjection {
 public:
  /// Moments of what is in `forces` already: it stays. Collective.
  void begin(const Comm& comm, const Particles<D>& particles, const VectorField<D>& forces);
  /// Takes the moment of all that has come in since out of them. Collective.
  void project(const Comm& comm, const Particles<D>& particles, VectorField<D>& forces);

 private:
  /// Of a body.
  struct Motion {
    double mass = 0.0;
    Point place{};            ///< sum m x
    Point moment{};           ///< sum x cross f
    Point force{};            ///< sum f
    Mat<double, 3> second{};  ///< sum m x (x) x
  };
  static std::vector<Motion> motions(const Comm& comm, const Particles<D>& particles, const VectorField<D>& forces);
  static Point angular_acceleration(const Motion& before, const Motion& after, const Point& center);

  std::vector<Motion> before_;
};

extern template class AngularProjection<2>;
extern template class AngularProjection<3>;

}  // namespace sinew
