#pragma once
/// The deformation gradient of Wiragunarsa et al. (2024) once more, slowly: every particle against every other, nothing stored that can be computed. Written from the
/// formulas, not from the fast code. One support radius R for all. With x_ij = x_j - x_i and the like,
///
///     F_i   = sum_j V_j x_ij (x) g_ij                                                       eq. 33
///     F_ij  = Fm + (x_ij - Fm X_ij) (x) X_ij / |X_ij|^2,   Fm = (F_i + F_j) / 2              eq. 39
///     F~_i  = sum_j V_j W1_ij F_ij + V_i W1_ii F_i                                           eq. 37
///     f_i   = 1/2 sum_j V_i V_j (P_i + P_j) (g_ij - g_ji)                                    eq. 22, symmetric
///     f_i   = sum_j V_i V_j (P_i g_ij - P_j g_ji)                                            adjoint
///     f_i   = sum_j V_i V_j (Q_i g_ij - Q_j g_ji + S_ij X_ij / |X_ij|^2),  S_ij = W1_ij P_i + W1_ji P_j,   variational
///             Q_i = V_i W1_ii P_i + 1/2 sum_j V_j S_ij (I - N_ij (x) N_ij)

#include <array>

#include "tlsph_minimal.hpp"

namespace sinew::reference {

template <int D>
struct BondMethod {
  std::function<double(double r, double R)> W, slope;
  std::function<Mat<double, D>(const Mat<double, D>& F)> stress;
  std::vector<Particle<D>> particles;
  bool linear = true;  ///< kernel and gradient of first order; else Shepard kernel and corrected gradient
  bool bonds = true, variational = false, symmetric = false;

  using V = Vec<double, D>;
  using M = Mat<double, D>;

  // Kernel of first order, W1_ij = W_ij (1, y).c with y = X_j - X_i and A c = (1, 0, ..), A = sum V W (1, y) (x) (1, y); and its gradient with respect to X_i from
  // dA c + A dc = 0.
  using Long = std::array<double, D + 1>;
  using System = std::array<Long, D + 1>;
  static Long with_one(const V& y) {
    Long p{1.0};
    for (int c = 0; c < D; ++c) p[c + 1] = y[c];
    return p;
  }
  static double product(const Long& a, const Long& b) {
    double sum = 0.0;
    for (int c = 0; c <= D; ++c) sum += a[c] * b[c];
    return sum;
  }
  /// Gauss elimination; the matrix is positive definite.
  static Long solve(System A, Long b) {
    for (int k = 0; k <= D; ++k)
      for (int i = 0; i <= D; ++i) {
        if (i == k) continue;
        const double factor = A[i][k] / A[k][k];
        for (int j = 0; j <= D; ++j) A[i][j] -= factor * A[k][j];
        b[i] -= factor * b[k];
      }
    for (int k = 0; k <= D; ++k) b[k] /= A[k][k];
    return b;
  }
  static void add(System& A, double weight, const Long& a, const Long& b) {
    for (int i = 0; i <= D; ++i)
      for (int j = 0; j <= D; ++j) A[i][j] += weight * a[i] * b[j];
  }
  double weight(std::size_t i, std::size_t j) const { return W(norm(particles[j].X - particles[i].X), particles[i].radius); }
  /// Of W_ij with respect to X_i.
  V slopes(std::size_t i, std::size_t j) const {
    const V y = particles[j].X - particles[i].X;
    const double r = norm(y);
    return i == j || r >= particles[i].radius ? V{} : (-slope(r, particles[i].radius) / r) * y;
  }

  double kernel(std::size_t i, std::size_t j) const {
    System A{};
    double sum = 0.0;
    for (std::size_t k = 0; k < particles.size(); ++k) {
      const Long p = with_one(particles[k].X - particles[i].X);
      add(A, particles[k].volume * weight(i, k), p, p);
      sum += particles[k].volume * weight(i, k);
    }
    if (!linear) return weight(i, j) / sum;
    return weight(i, j) * product(with_one(particles[j].X - particles[i].X), solve(A, Long{1.0}));
  }

  V gradient(std::size_t i, std::size_t j) const { return linear ? linear_gradient(i, j) : corrected_gradient(i, j); }
  V linear_gradient(std::size_t i, std::size_t j) const {
    V g;
    for (int d = 0; d < D; ++d) {
      System A{}, dA{};
      Long dp{};
      dp[d + 1] = -1.0;
      for (std::size_t k = 0; k < particles.size(); ++k) {
        const Long p = with_one(particles[k].X - particles[i].X);
        const double volume = particles[k].volume;
        add(A, volume * weight(i, k), p, p);
        add(dA, volume * slopes(i, k)[d], p, p);
        add(dA, volume * weight(i, k), dp, p);
        add(dA, volume * weight(i, k), p, dp);
      }
      const Long c = solve(A, Long{1.0}), p = with_one(particles[j].X - particles[i].X);
      Long right{};
      for (int k = 0; k <= D; ++k) right[k] = -product(dA[k], c);
      g[d] = slopes(i, j)[d] * product(p, c) + weight(i, j) * (product(dp, c) + product(p, solve(A, right)));
    }
    return g;
  }
  V corrected_gradient(std::size_t i, std::size_t j) const {
    M moment;
    for (std::size_t k = 0; k < particles.size(); ++k)
      moment += particles[k].volume * outer(particles[k].X - particles[i].X, slopes(i, k));
    return inverse(moment) * slopes(i, j);
  }

  std::vector<V> forces() const {
    const std::size_t n = particles.size();
    const auto& p = particles;
    std::vector<std::vector<V>> g(n, std::vector<V>(n));
    std::vector<std::vector<double>> W1(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) g[i][j] = gradient(i, j), W1[i][j] = kernel(i, j);
    std::vector<M> F(n, M::identity()), P(n), Q(n);
    const auto X = [&](std::size_t i, std::size_t j) { return p[j].X - p[i].X; };
    const auto x = [&](std::size_t i, std::size_t j) { return X(i, j) + p[j].u - p[i].u; };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) F[i] += p[j].volume * outer(p[j].u - p[i].u, g[i][j]);
    for (std::size_t i = 0; i < n; ++i) {
      M average = p[i].volume * W1[i][i] * F[i];
      for (std::size_t j = 0; j < n; ++j) {
        if (j == i) continue;
        const M mean = 0.5 * (F[i] + F[j]);
        const M bond = mean + (1.0 / dot(X(i, j), X(i, j))) * outer(x(i, j) - mean * X(i, j), X(i, j));
        average += p[j].volume * W1[i][j] * bond;
      }
      P[i] = stress(bonds ? average : F[i]);
    }
    std::vector<V> f(n);
    const auto S = [&](std::size_t i, std::size_t j) { return W1[i][j] * P[i] + W1[j][i] * P[j]; };
    for (std::size_t i = 0; i < n; ++i) {
      Q[i] = p[i].volume * W1[i][i] * P[i];
      for (std::size_t j = 0; j < n; ++j)
        if (j != i) {
          const V N = (1.0 / norm(X(i, j))) * X(i, j);
          Q[i] += 0.5 * p[j].volume * (S(i, j) * (M::identity() - outer(N, N)));
        }
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        if (j == i) continue;
        const double volumes = p[i].volume * p[j].volume;
        if (variational)
          f[i] += volumes * (Q[i] * g[i][j] - Q[j] * g[j][i] + (1.0 / dot(X(i, j), X(i, j))) * (S(i, j) * X(i, j)));
        else if (symmetric)
          f[i] += 0.5 * volumes * ((P[i] + P[j]) * (g[i][j] - g[j][i]));
        else
          f[i] += volumes * (P[i] * g[i][j] - P[j] * g[j][i]);
      }
    return f;
  }
};

}  // namespace sinew::reference
