#pragma once
/// Small bodies for property tests: lattices and disturbed clouds with uneven volumes and, if wanted, uneven radii.

#include <random>
#include <sinew/formulations/total_lagrangian.hpp>

namespace sinew::testing {

template <int D>
struct Cloud {
  std::vector<PointSet> bodies;
  Particles<D> particles;
  std::vector<double> radius;  ///< per slot
};

template <int D>
PointSet cloud_points(int n, double jitter, double shift, std::mt19937_64& random) {
  std::uniform_real_distribution<double> move(-jitter, jitter), grow(0.9, 1.1);
  PointSet points;
  points.spacing = 1.0;
  for (int k = 0; k < (D == 3 ? n : 1); ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n + 2; ++i) {
        Point p{{i + shift, j + 0.0, D == 3 ? k + 0.0 : 0.0}};
        for (int c = 0; c < D; ++c) p[c] += move(random);
        points.position.push_back(p);
        points.volume.push_back(jitter > 0.0 ? grow(random) : 1.0);
      }
  return points;
}

/// `bodies` separate bodies in a row. `uneven`: radii between 0.9 and 1.25 times `support`.
template <int D>
Cloud<D> make_cloud(int n, double jitter, double support, bool uneven, int bodies, unsigned seed) {
  std::mt19937_64 random(seed);
  Cloud<D> cloud;
  for (int b = 0; b < bodies; ++b) cloud.bodies.push_back(cloud_points<D>(n, jitter, 100.0 * b, random));
  std::vector<BodyPoints> parts;
  for (const PointSet& points : cloud.bodies) parts.push_back({"body", &points, 1.3, 1.0});
  cloud.particles = make_particles<D>(parts, 1.0);
  std::uniform_real_distribution<double> factor(0.9, 1.25);
  cloud.radius.assign(cloud.particles.slots, support);
  if (uneven)
    for (double& r : cloud.radius) r *= factor(random);
  return cloud;
}

/// Blocks of at most so many particles while it lives.
class BlockSize {
 public:
  explicit BlockSize(int most) : kept_(largest_block) { largest_block = most; }
  ~BlockSize() { largest_block = kept_; }
  BlockSize(const BlockSize&) = delete;
  BlockSize& operator=(const BlockSize&) = delete;

 private:
  int kept_;
};

/// u = (A - I) X + bump * smooth function of place.
template <int D>
void displace(Particles<D>& particles, const Mat<double, D>& A, double bump) {
  for (int slot = 0; slot < particles.slots; ++slot) {
    const Vec<double, D> X = particles.position[slot];
    Vec<double, D> u = A * X - X;
    for (int i = 0; i < D; ++i) u[i] += bump * std::sin(0.7 * X[(i + 1) % D] + 0.4 * X[i] + i);
    particles.displacement.set(slot, u);
  }
}

template <class Material>
Material material_with(double density, double youngs_modulus, double poissons_ratio) {
  Material m;
  m.density = density;
  m.elastic.youngs_modulus = youngs_modulus;
  m.elastic.poissons_ratio = poissons_ratio;
  m.elastic.complete();
  if constexpr (requires { m.hardening; }) m.hardening.yield_stress = 0.05 * youngs_modulus;
  if constexpr (requires { m.law.friction_angle; }) m.law.friction_angle = 30.0, m.law.cohesion = 0.05 * youngs_modulus;
  if constexpr (requires { m.law.grain_diameter; }) m.law = {0.4, 0.7, 0.3, 1e-3, 2.0 * density};
  return m;
}

/// Of a virgin particle.
template <class Material>
Response<Mat3<double>> virgin_response(const Material& m, const Mat3<double>& F) {
  if constexpr (HasHistory<Material>) {
    typename Material::template History<Mat3<double>> history;
    return m.respond(F, history, 0.0);
  } else {
    return m.respond(F);
  }
}

template <int D>
TotalLagrangianOptions options(AnyMaterial material, int bodies = 1, AnyKernel kernel = Spiky{},
                               AnyCorrection correction = GradientCorrection{}) {
  return {kernel, correction, HourglassStiffness{}, std::vector<AnyMaterial>(bodies, material), false, 1.0};
}

}  // namespace sinew::testing
