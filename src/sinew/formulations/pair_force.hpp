#pragma once
/// The share of i of the force in a pair i -> j, at a point: i receives t_ij, j the opposite. It is linear in the stress and in the deformation
/// gradient of i, so that the whole force of the pair is t_ij - t_ji, and i needs no more than itself.
///
///     t_ij = Q_i (w_ij X_ij) + hourglass share,     Q_i = V_i P_i L_i
///
/// Each form sums the energy of its hourglass shares on the way. `of_pairs`: it asks for u_ij or X_ij.

#include <sinew/formulations/pair_weight.hpp>
#include <sinew/stabilization/artificial_viscosity.hpp>
#include <sinew/stabilization/hourglass_stiffness.hpp>

namespace sinew {

/// What a particle brings to its pairs.
template <int D>
struct PointState {
  Mat<Pack, D> Q;  ///< V P L: force per weighted X [force]
  Mat<Pack, D> F;  ///< deformation gradient
  Mat<Pack, D> S;  ///< sum_j w_ij u_ij (x) X_ij, so that F = I + S L
  Pack stiffness;  ///< hourglass coefficient times E_i V_i, times what normalizes the weights
};

/// A pair and its mirror image.
template <int D>
struct MirroredShares {
  Vec<Pack, D> forward, backward;
};

/// Stress and conservative hourglass stiffness k = stiffness w_ij in one: with e_ij = u_ij - G X_ij, G = F - I,
///
///     t_ij = w (Q X + stiffness e) = w (B X + stiffness u),     B = Q - stiffness G
///     energy = 1/2 sum k |e|^2 = 1/2 (sum k |u|^2 - stiffness G : S)
///
/// since G = S L and L is the inverse of sum w X (x) X. Also the form without hourglass stiffness: it is zero then.
template <int D>
struct ConservativeShares {
  static constexpr bool hourglass_weights = false, of_pairs = true;
  Mat<Pack, D> B;
  Pack stiffness, energy;

  explicit SINEW_INLINE ConservativeShares(const PointState<D>& i) : stiffness(i.stiffness) {
    const Mat<Pack, D> G = i.F - Mat<Pack, D>::identity();
    B = i.Q - stiffness * G;
    energy = -stiffness * double_dot(G, i.S);
  }
  template <class Weight>
  SINEW_INLINE Vec<Pack, D> operator()(const Weight& w, const Vec<Pack, D>& u, const Vec<Pack, D>& X) {
    return B * w.force(X) + pull(w, u);
  }
  template <class Weight>
  SINEW_INLINE MirroredShares<D> mirrored(const Weight& w, const Vec<Pack, D>& u_forward, const Vec<Pack, D>& u_backward,
                                          const Vec<Pack, D>& X) {
    const Vec<Pack, D> odd = B * w.force(X);
    return {pull(w, u_forward) + odd, pull(w, u_backward) - odd};
  }
  SINEW_INLINE Pack hourglass_energy() const { return 0.5 * energy; }

 private:
  template <class Weight>
  SINEW_INLINE Vec<Pack, D> pull(const Weight& w, const Vec<Pack, D>& u) {
    const Vec<Pack, D> force = (w.gradient * stiffness) * u;
    energy += dot(force, u);
    return force;
  }
};

/// The two forms of hourglass force on weights of their own.
struct ConservativeForm {
  template <class... Arguments>
  static SINEW_INLINE auto share(const Arguments&... arguments) {
    return HourglassStiffness::conservative_share(arguments...);
  }
};
struct CentralForm {
  template <class... Arguments>
  static SINEW_INLINE auto share(const Arguments&... arguments) {
    return HourglassStiffness::central_share(arguments...);
  }
};

/// Stress and hourglass stiffness added up, for any weights.
template <int D, class Form>
struct SeparateShares {
  static constexpr bool hourglass_weights = true, of_pairs = true;
  Mat<Pack, D> Q, F;
  Pack stiffness, energy{0.0};

  explicit SINEW_INLINE SeparateShares(const PointState<D>& i) : Q(i.Q), F(i.F), stiffness(i.stiffness) {}
  template <class Weight>
  SINEW_INLINE Vec<Pack, D> operator()(const Weight& w, const Vec<Pack, D>& u, const Vec<Pack, D>& X) {
    const auto share = Form::share(F, X, X + u, stiffness * w.hourglass_weight());
    energy += share.energy;
    return Q * w.force(X) + share.force;
  }
  template <class Weight>
  SINEW_INLINE MirroredShares<D> mirrored(const Weight& w, const Vec<Pack, D>& u_forward, const Vec<Pack, D>& u_backward,
                                          const Vec<Pack, D>& X) {
    return {(*this)(w, u_forward, X), (*this)(w.reversed(), u_backward, -X)};
  }
  SINEW_INLINE Pack hourglass_energy() const { return energy; }
};

/// Stress alone, for weights that are vectors.
template <int D>
struct StressShares {
  static constexpr bool hourglass_weights = false, of_pairs = false;
  Mat<Pack, D> Q;

  explicit SINEW_INLINE StressShares(const PointState<D>& i) : Q(i.Q) {}
  template <class Weight>
  SINEW_INLINE Vec<Pack, D> operator()(const Weight& w, const Vec<Pack, D>&, const Vec<Pack, D>& X) const {
    return Q * w.force(X);
  }
  SINEW_INLINE Pack hourglass_energy() const { return Pack(0.0); }
};

/// Artificial viscosity: t_ij = strength(mu_ij) H_i (w_ij X_ij), H = -1/2 V rho_0 J^2 F^-T L; i's half of the force,
/// left out where it would give energy instead of taking it: where F, far from what the pair does, turns x_ij by more than a right angle.
template <int D>
struct ViscousShares {
  Mat<Pack, D> H;
  Pack h;
  const ArtificialViscosity& law;
  double sound_speed;
  Pack power{0.0}, resistance{0.0};  ///< resistance: sum over the pairs of force by velocity [mass/time]

  template <class Weight>
  SINEW_INLINE Vec<Pack, D> operator()(const Weight& w, const Vec<Pack, D>& u, const Vec<Pack, D>& v, const Vec<Pack, D>& X) {
    const Pack mu = ArtificialViscosity::approach(X + u, v, h);
    const Vec<Pack, D> pull = H * w.vector(X);
    const Vec<Pack, D> whole = law.strength(mu, sound_speed) * pull;
    const Pack taken = dot(whole, v);
    const Vec<Pack, D> t = select(taken > Pack(0.0), Pack(1.0), Pack(0.0)) * whole;
    power += max(taken, Pack(0.0));
    resistance += select(w.present(), law.resistance(X + u, mu, h, sound_speed) * sqrt(dot(pull, pull)), Pack(0.0));
    return t;
  }
};

/// What the linear part of the velocities around i, with the gradient G_i, leaves unexplained: exchanged for all pairs,
///
///     t_ij = V_i w_ij (v_ij - G_i X_ij) / 2
///
/// are a Laplacian of which linear fields are taken off, V_i w_ij (v_ij - (G_i + G_j) X_ij / 2). For ListedPairs::exchange_moving. JstDissipation
template <int D>
struct UnexplainedVelocities {
  Mat<Pack, D> G;
  Pack half;        ///< of V_i w_ij, over the weight
  Pack power{0.0};  ///< taken

  template <class Weight>
  SINEW_INLINE Vec<Pack, D> operator()(const Weight& w, const Vec<Pack, D>&, const Vec<Pack, D>& v, const Vec<Pack, D>& X) {
    const Vec<Pack, D> t = (half * w.dissipation()) * (v - G * X);
    power += dot(t, v);
    return t;
  }
};

}  // namespace sinew
