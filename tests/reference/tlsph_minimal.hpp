#pragma once
/// The method once more, slowly and without options: total-Lagrangian SPH in one file, every particle against every other, doubles,
/// nothing stored that can be computed. The oracle for every fast sweep. Written from the formulas, not from the fast code.
///
///     F_i = I + sum_j V_j (u_j - u_i) (x) g_ij,   g_ij = M_i^-1 |W'_i(r)|/r X_ij,   M_i = sum_j V_j |W'_i(r)|/r X_ij (x) X_ij
///     f_i = sum_j V_i V_j (P_i g_ij - P_j g_ji) + hourglass force, one of
///     central, half:  - sum_j (alpha/4) V_i V_j / r^2 (W_i E_i delta^i + W_j E_j delta^j) n_ij,   delta^i = (F_i X_ij).n_ij - |x_ij|
///     conservative:   sum_j (alpha/32) V_i V_j (E_i a_ij/m_i (x_ij - F_i X_ij) + E_j a_ji/m_j (x_ij - F_j X_ij)),   m = tr M, a = |W'|/r
///
/// Each particle has its own support radius R_i: g_ij and W_i vanish for r >= R_i. Ganzenmueller (2015), eq. 17, 24, 32.

#include <functional>
#include <sinew/core/vec.hpp>
#include <vector>

namespace sinew::reference {

template <int D>
struct Particle {
  Vec<double, D> X, u;
  double volume, radius, youngs_modulus;
};

template <int D>
struct Method {
  std::function<double(double r, double R)> W, slope;                           ///< kernel and its derivative
  std::function<Mat<double, D>(int particle, const Mat<double, D>& F)> stress;  ///< first Piola-Kirchhoff
  double alpha = 50.0;                                                          ///< of the hourglass force
  bool corrected = true, conservative = true;

  double weight(const Particle<D>& a, double r) const { return r < a.radius ? -slope(r, a.radius) / r : 0.0; }

  Mat<double, D> moment(const std::vector<Particle<D>>& p, std::size_t i) const {
    Mat<double, D> M;
    for (std::size_t j = 0; j < p.size(); ++j) {
      if (j == i) continue;
      const Vec<double, D> X = p[j].X - p[i].X;
      M += (p[j].volume * weight(p[i], norm(X))) * outer(X, X);
    }
    return M;
  }

  Mat<double, D> correction(const std::vector<Particle<D>>& p, std::size_t i) const {
    return corrected ? inverse(moment(p, i)) : Mat<double, D>::identity();
  }

  std::vector<Mat<double, D>> deformation_gradients(const std::vector<Particle<D>>& p) const {
    std::vector<Mat<double, D>> F(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Mat<double, D> L = correction(p, i);
      F[i] = Mat<double, D>::identity();
      for (std::size_t j = 0; j < p.size(); ++j) {
        if (j == i) continue;
        const Vec<double, D> X = p[j].X - p[i].X;
        F[i] += outer(p[j].volume * (p[j].u - p[i].u), L * (weight(p[i], norm(X)) * X));
      }
    }
    return F;
  }

  std::vector<Vec<double, D>> forces(const std::vector<Particle<D>>& p) const {
    const std::vector<Mat<double, D>> F = deformation_gradients(p);
    std::vector<Vec<double, D>> f(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Mat<double, D> L_i = correction(p, i), P_i = stress(static_cast<int>(i), F[i]);
      for (std::size_t j = 0; j < p.size(); ++j) {
        if (j == i) continue;
        const Vec<double, D> X = p[j].X - p[i].X, x = X + p[j].u - p[i].u;
        const double r = norm(X), length = norm(x), volumes = p[i].volume * p[j].volume;
        const Vec<double, D> g_ij = L_i * (weight(p[i], r) * X), n = (1.0 / length) * x;
        const Vec<double, D> g_ji = correction(p, j) * (weight(p[j], r) * (-X));
        f[i] += volumes * (P_i * g_ij - stress(static_cast<int>(j), F[j]) * g_ji);
        if (conservative) {
          const double w_i = weight(p[i], r) > 0.0 ? weight(p[i], r) / trace(moment(p, i)) : 0.0;
          const double w_j = weight(p[j], r) > 0.0 ? weight(p[j], r) / trace(moment(p, j)) : 0.0;
          f[i] += (alpha / 32.0 * volumes) *
                  (p[i].youngs_modulus * w_i * (x - F[i] * X) + p[j].youngs_modulus * w_j * (x - F[j] * X));
          continue;
        }
        const double W_i = r < p[i].radius ? W(r, p[i].radius) : 0.0, W_j = r < p[j].radius ? W(r, p[j].radius) : 0.0;
        const double delta_i = dot(F[i] * X, n) - length, delta_j = dot(F[j] * X, n) - length;
        f[i] -=
            (0.25 * alpha * volumes / (r * r) * (W_i * p[i].youngs_modulus * delta_i + W_j * p[j].youngs_modulus * delta_j)) * n;
      }
    }
    return f;
  }
};

}  // namespace sinew::reference
