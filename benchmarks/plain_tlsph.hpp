#pragma once
/// The baseline of every benchmark: total-Lagrangian SPH as a careful programmer writes it first. Array of structs, one particle after
/// the other, kernel recomputed from the reference positions, two gather passes (stress, then force). St. Venant-Kirchhoff, spiky
/// kernel, corrected gradient, hourglass stiffness. Also an oracle for the sweeps of the product.

#include <cmath>
#include <numbers>
#include <sinew/core/vec.hpp>
#include <vector>

namespace sinew::plain {

template <int D>
struct Particle {
  Vec<double, D> X, x, v, f;
  Mat<double, D> F, P, L;
  double volume, mass;
  double hourglass_scale;  ///< 1 / sum_k V_k a_ik r_ik^2
};

struct Constants {
  double lambda, mu, youngs_modulus, radius;
  double hourglass;   ///< coefficient of one particle's share: alpha / 4, or alpha / 32 for the conservative form
  bool conservative;  ///< which form of hourglass force
};

template <int D>
class Solver {
 public:
  std::vector<Particle<D>> particles;
  std::vector<std::size_t> first;  ///< particle -> first neighbor
  std::vector<int> neighbors;
  Constants c;

  void compute_corrections() {
    for (std::size_t i = 0; i < particles.size(); ++i) {
      Mat<double, D> M;
      for (std::size_t k = first[i]; k < first[i + 1]; ++k) {
        const Particle<D>& b = particles[neighbors[k]];
        const Vec<double, D> X = b.X - particles[i].X;
        const double r = norm(X);
        M += (-b.volume * slope(r) / r) * outer(X, X);
      }
      particles[i].L = inverse(M);
      particles[i].hourglass_scale = 1.0 / trace(M);
    }
  }

  void compute_forces() {
    for (std::size_t i = 0; i < particles.size(); ++i) compute_stress(i);
    for (std::size_t i = 0; i < particles.size(); ++i) compute_force(i);
  }

  void step(double dt) {
    for (Particle<D>& a : particles) {
      a.v += (0.5 * dt / a.mass) * a.f;
      a.x += dt * a.v;
    }
    compute_forces();
    for (Particle<D>& a : particles) a.v += (0.5 * dt / a.mass) * a.f;
  }

 private:
  double value(double r) const {
    const double q = c.radius - r, R = c.radius;
    return D == 3 ? 15.0 / (std::numbers::pi * R * R * R * R * R * R) * q * q * q
                  : 10.0 / (std::numbers::pi * R * R * R * R * R) * q * q * q;
  }
  double slope(double r) const {
    const double q = c.radius - r, R = c.radius;
    return D == 3 ? -45.0 / (std::numbers::pi * R * R * R * R * R * R) * q * q
                  : -30.0 / (std::numbers::pi * R * R * R * R * R) * q * q;
  }

  void compute_stress(std::size_t i) {
    Particle<D>& a = particles[i];
    Mat<double, D> sum;
    for (std::size_t k = first[i]; k < first[i + 1]; ++k) {
      const Particle<D>& b = particles[neighbors[k]];
      const Vec<double, D> X = b.X - a.X;
      const double r = norm(X);
      sum += outer((-b.volume * slope(r) / r) * (b.x - a.x), X);
    }
    a.F = sum * a.L;
    const Mat<double, D> E = 0.5 * (transpose(a.F) * a.F - Mat<double, D>::identity());
    const Mat<double, D> S = (c.lambda * trace(E)) * Mat<double, D>::identity() + (2.0 * c.mu) * E;
    a.P = a.F * S;
  }

  void compute_force(std::size_t i) {
    if (c.conservative)
      sum_force<true>(i);
    else
      sum_force<false>(i);
  }

  template <bool conservative>
  void sum_force(std::size_t i) {
    Particle<D>& a = particles[i];
    Vec<double, D> force;
    for (std::size_t k = first[i]; k < first[i + 1]; ++k) {
      const Particle<D>& b = particles[neighbors[k]];
      const Vec<double, D> X = b.X - a.X, x = b.x - a.x;
      const double r = norm(X);
      const double weight = -a.volume * b.volume * slope(r) / r;
      force += weight * (a.P * (a.L * X) + b.P * (b.L * X));
      if (conservative) {
        const double stiffness = c.hourglass * c.youngs_modulus * weight;
        force += stiffness * (a.hourglass_scale * (x - a.F * X) + b.hourglass_scale * (x - b.F * X));
        continue;
      }
      const double length = norm(x);
      const double delta = dot(a.F * X, x) / length - length + dot(b.F * X, x) / length - length;
      force -= (c.hourglass * c.youngs_modulus * a.volume * b.volume * value(r) / (r * r) * delta / length) * x;
    }
    a.f = force;
  }
};

}  // namespace sinew::plain
