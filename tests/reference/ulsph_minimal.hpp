#pragma once
/// SPH on the current configuration in plain lines: one evaluation of the forces, all pairs, one particle after the other. The oracle for the sweeps.

#include <sinew/formulations/updated_lagrangian.hpp>
#include <vector>

namespace sinew::testing {

template <int D>
struct PlainParticle {
  Vec<double, D> x, v, force, held;
  double mass, density;  ///< density in the reference configuration
  Mat<double, D> F, L, B, sigma, T, R;
  double J = 1.0, mean = 0.0, modulus = 0.0;
};

template <int D>
class PlainUpdatedLagrangian {
 public:
  UpdatedLagrangianOptions options;
  std::vector<PlainParticle<D>> particles;

  /// Velocity gradients in the middle of a step that ends now, F and stress at its end, forces.
  void evaluate(double dt) {
    std::vector<double> specific_volume;
    for (const auto& p : particles) specific_volume.push_back(p.J / p.density);
    std::vector<Vec<double, D>> pull(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) find_gradient(i, dt, specific_volume, pull[i]);
    for (auto& p : particles) respond(p, dt);
    for (std::size_t i = 0; i < particles.size(); ++i) add_forces(i, dt, specific_volume, pull[i]);
  }

 private:
  double slope_over_r(double r) const {
    return std::visit([&](const auto& k) { return -k.template slope<D>(r, options.radius) / r; }, options.kernel);
  }
  double value(double r) const {
    return std::visit([&](const auto& k) { return k.template value<D>(r, options.radius); }, options.kernel);
  }

  void find_gradient(std::size_t i, double dt, const std::vector<double>& volume, Vec<double, D>& pull) {
    PlainParticle<D>& a = particles[i];
    Mat<double, D> L, M;
    for (std::size_t j = 0; j < particles.size(); ++j) {
      const PlainParticle<D>& b = particles[j];
      const Vec<double, D> v = b.v - a.v, x = b.x - a.x - (0.5 * dt) * v;
      const double r = norm(x);
      if (i == j || r >= options.radius) continue;
      const Vec<double, D> gradient = (b.mass * volume[i] * slope_over_r(r)) * x;
      L += outer(v, gradient);
      M += outer(x, gradient);
      pull += (volume[i] * b.mass * volume[j] * slope_over_r(r) * dot(v, x) / (r * r)) * x;
    }
    a.B = options.corrected && determinant(M) > 0.02 * std::pow(trace(M) / D, D) ? inverse(M) : Mat<double, D>::identity();
    a.L = L * a.B;
  }

  void respond(PlainParticle<D>& p, double dt) {
    const Mat<double, D> I = Mat<double, D>::identity();
    p.F = inverse(I - (0.5 * dt) * p.L) * (I + (0.5 * dt) * p.L) * p.F;
    const Mat3<double> F = embed(p.F, 1.0);
    p.J = determinant(F);
    std::visit(
        [&](const auto& material) {
          if constexpr (requires { material.respond(F); }) {
            const Mat3<double> sigma = (1.0 / p.J) * (material.respond(F).P * transpose(F));
            p.sigma = in_plane<D>(sigma);
            p.mean = trace(sigma) / 3.0;
            p.modulus = material.elastic.mu();
          }
        },
        options.materials[0]);
    const double volume = p.J / p.density;
    const Mat<double, D> stress = options.pressure_only() ? p.mean * I : p.sigma;
    p.T = (volume * volume) * (stress * transpose(p.B));
    if (options.pressure) p.R = (-options.pressure->gamma * max(p.mean, 0.0) * volume * volume) * I;
    if (options.stress) p.R = options.stress->repulsion(p.sigma, p.mean, volume);
  }

  void add_forces(std::size_t i, double dt, const std::vector<double>& volume, const Vec<double, D>& printed_pull) {
    PlainParticle<D>& a = particles[i];
    const double h = options.radius / std::visit([](const auto& k) { return k.customary_h; }, options.kernel);
    const double exponent = options.pressure ? value(0.0) / value(options.spacing)
                            : options.stress ? options.stress->exponent
                                             : 1.0;
    Vec<double, D> pull;
    a.force = {};
    for (std::size_t j = 0; j < particles.size(); ++j) {
      const PlainParticle<D>& b = particles[j];
      const Vec<double, D> x = b.x - a.x, v = b.v - a.v;
      const double r = norm(x);
      if (i == j || r >= options.radius) continue;
      Mat<double, D> S = a.T + b.T;
      if (options.repels()) S += std::pow(value(r) / value(options.spacing), exponent) * (a.R + b.R);
      Vec<double, D> share = S * x;
      if (options.viscosity) {
        const double mu = min(h * dot(v, x) / (r * r + 0.01 * h * h), 0.0);
        const double c = std::sqrt(youngs_modulus_of(options.materials[0]) / a.density);
        const double pi = mu * (options.viscosity->beta * mu - options.viscosity->alpha * c) * 0.5 * (volume[i] + volume[j]);
        share -= pi * x;
      }
      a.force += (a.mass * b.mass * slope_over_r(r)) * share;
      const Vec<double, D> e = v - 0.5 * ((a.L + b.L) * (x - (0.5 * dt) * v));
      pull +=
          (0.5 * (a.modulus + b.modulus) * a.mass * volume[i] * b.mass * volume[j] * slope_over_r(r) * dot(e, x) / (r * r)) * x;
    }
    if (!options.shear) return;
    const Mat<double, D> I = Mat<double, D>::identity(), spin = 0.5 * (a.L - transpose(a.L));
    if (options.pressure_only())
      a.held += (dt * options.shear->coefficient(D) * a.modulus * a.mass) * printed_pull;
    else
      a.held = inverse(I - (0.5 * dt) * spin) * (I + (0.5 * dt) * spin) * a.held + (dt * options.shear->coefficient(D)) * pull;
    a.force += a.held;
  }
};

}  // namespace sinew::testing
