#include <gtest/gtest.h>

#include <random>
#include <sinew/corrections/registry.hpp>
#include <sinew/kernels/wendland_c2.hpp>
#include <vector>

namespace sinew {
namespace {

/// A disturbed lattice with particle 0 in its middle, or at a corner: half the spacing of jitter, volumes 10 % up and down.
template <int D>
struct Cloud {
  std::vector<Vec<double, D>> X;
  std::vector<double> V;
  double R = 2.3;

  explicit Cloud(bool corner) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> jitter(-0.25, 0.25), growth(0.9, 1.1);
    const int low = corner ? 0 : -3, side = 3 - low + 1;
    int count = 1;
    for (int i = 0; i < D; ++i) count *= side;
    X.push_back({});
    V.push_back(1.05);
    for (int k = 0; k < count; ++k) {
      Vec<double, D> place;
      int rest = k;
      bool origin = true;
      for (int i = 0; i < D; ++i, rest /= side) {
        place[i] = low + rest % side;
        origin = origin && place[i] == 0.0;
        place[i] += jitter(random);
      }
      if (origin) continue;
      X.push_back(place);
      V.push_back(growth(random));
    }
  }

  double W(const Vec<double, D>& x, std::size_t j) const { return WendlandC2::value<D>(norm(X[j] - x), R); }
  double a(std::size_t j) const { return -WendlandC2::slope<D>(norm(X[j]), R) / norm(X[j]); }

  Moments<D> moments() const {
    Moments<D> m;
    for (std::size_t j = 0; j < X.size(); ++j) m.shepard_sum += V[j] * W({}, j);
    for (std::size_t j = 1; j < X.size(); ++j) {
      m.gradient_sum += (V[j] * a(j)) * X[j];
      m.first += (V[j] * a(j)) * outer(X[j], X[j]);
      m.kernel_first += (V[j] * W({}, j)) * X[j];
      m.kernel_second += (V[j] * W({}, j)) * outer(X[j], X[j]);
      for (int g = 0; g < D; ++g) m.second[g] += (V[j] * a(j) * X[j][g]) * outer(X[j], X[j]);
    }
    return m;
  }
  /// sum V_j f(X_j) (x) g_0j over the neighbors, without the particle itself.
  template <class F>
  auto sum_over_neighbors(const GradientMap<D>& map, F f) const {
    decltype(f(std::size_t{}, Vec<double, D>{})) sum{};
    for (std::size_t j = 1; j < X.size(); ++j) sum += V[j] * f(j, map.apply(a(j), W({}, j), X[j]));
    return sum;
  }
};

template <int D>
double distance_to_identity(const Mat<double, D>& A) {
  const Mat<double, D> difference = A - Mat<double, D>::identity();
  return std::sqrt(double_dot(difference, difference));
}

template <class F>
void for_plane_and_space(F f) {
  for (const bool corner : {false, true}) {
    f.template operator()<2>(corner);
    f.template operator()<3>(corner);
  }
}

TEST(Corrections, NoneLeavesTheKernelGradient) {
  const GradientMap<3> map = NoCorrection{}.map(Cloud<3>(true).moments());
  const Vec<double, 3> X{{1, -2, 3}}, g = map.apply(2.0, 5.0, X);
  EXPECT_TRUE(map.valid);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(g[i], 2.0 * X[i]);
}

/// Of every correction that says so: gradient, mixed, linear.
template <class Correction>
void check_linear_fields() {
  for_plane_and_space([]<int D>(bool corner) {
    const Cloud<D> cloud(corner);
    const auto product = [&](std::size_t j, const Vec<double, D>& g) { return outer(cloud.X[j], g); };
    const GradientMap<D> map = Correction{}.map(cloud.moments());
    ASSERT_TRUE(map.valid);
    EXPECT_LT(distance_to_identity(cloud.sum_over_neighbors(map, product)), 1e-12) << Correction::name;
    EXPECT_GT(distance_to_identity(cloud.sum_over_neighbors(NoCorrection{}.map(cloud.moments()), product)), 1e-2);
  });
}
TEST(Corrections, AreExactForLinearFields) {
  check_linear_fields<GradientCorrection>();
  check_linear_fields<MixedCorrection>();
  check_linear_fields<LinearCorrection>();
}

/// sum V W1 = 1 for all, sum V W1 X = 0 for the linear one.
TEST(Corrections, KernelsAreAPartitionOfUnity) {
  Corrections::for_each([]<class Correction>() {
    for_plane_and_space([]<int D>(bool corner) {
      const Cloud<D> cloud(corner);
      const GradientMap<D> map = Correction{}.map(cloud.moments());
      double sum = 0.0;
      Vec<double, D> moment;
      for (std::size_t j = 0; j < cloud.X.size(); ++j) {
        sum += cloud.V[j] * map.kernel(cloud.W({}, j), cloud.X[j]);
        moment += (cloud.V[j] * map.kernel(cloud.W({}, j), cloud.X[j])) * cloud.X[j];
      }
      EXPECT_NEAR(sum, 1.0, 1e-13) << Correction::name;
      if (Correction::name == LinearCorrection::name) {
        EXPECT_LT(norm(moment), 1e-13);
      } else if (corner) {
        EXPECT_GT(norm(moment), 1e-3);
      }
    });
  });
}

/// The corrected kernel at a place x in the cloud, with sums made there anew.
template <int D>
double linear_kernel(const Cloud<D>& cloud, const Vec<double, D>& x, std::size_t j) {
  Moments<D> m;
  for (std::size_t k = 0; k < cloud.X.size(); ++k) {
    const double VW = cloud.V[k] * cloud.W(x, k);
    m.shepard_sum += VW;
    m.kernel_first += VW * (cloud.X[k] - x);
    m.kernel_second += VW * outer(cloud.X[k] - x, cloud.X[k] - x);
  }
  return LinearCorrection{}.map(m).kernel(cloud.W(x, j), cloud.X[j] - x);
}

/// Also of the particle itself: its own gradient is not zero near surfaces.
TEST(Corrections, LinearIsTheGradientOfItsKernel) {
  for_plane_and_space([]<int D>(bool corner) {
    const Cloud<D> cloud(corner);
    const GradientMap<D> map = LinearCorrection{}.map(cloud.moments());
    ASSERT_TRUE(map.valid);
    const double step = 1e-5;
    for (std::size_t j = 0; j < cloud.X.size(); j += 5)
      for (int i = 0; i < D; ++i) {
        Vec<double, D> shift;
        shift[i] = step;
        const double expected = (linear_kernel<D>(cloud, shift, j) - linear_kernel<D>(cloud, -shift, j)) / (2.0 * step);
        EXPECT_NEAR(map.apply(j == 0 ? 0.0 : cloud.a(j), cloud.W({}, j), cloud.X[j])[i], expected, 1e-8);
      }
  });
}

TEST(Corrections, ShepardIsTheGradientOfTheNormalizedKernel) {
  for_plane_and_space([]<int D>(bool corner) {
    const Cloud<D> cloud(corner);
    const GradientMap<D> map = ShepardCorrection{}.map(cloud.moments());
    ASSERT_TRUE(map.valid);
    const auto normalized = [&](const Vec<double, D>& x, std::size_t j) {
      double sum = 0.0;
      for (std::size_t k = 0; k < cloud.X.size(); ++k) sum += cloud.V[k] * cloud.W(x, k);
      return cloud.W(x, j) / sum;
    };
    const double step = 1e-5;
    for (std::size_t j = 1; j < cloud.X.size(); j += 5)
      for (int i = 0; i < D; ++i) {
        Vec<double, D> shift;
        shift[i] = step;
        const double expected = (normalized(shift, j) - normalized(-shift, j)) / (2.0 * step);
        EXPECT_NEAR(map.apply(cloud.a(j), cloud.W({}, j), cloud.X[j])[i], expected, 1e-9);
      }
  });
}

template <class Correction>
void check_sum_of_weights() {
  for_plane_and_space([]<int D>(bool corner) {
    const Cloud<D> cloud(corner);
    const GradientMap<D> map = Correction{}.map(cloud.moments());
    Vec<double, D> sum = cloud.V[0] * map.apply(0.0, cloud.W({}, 0), {});
    sum += cloud.sum_over_neighbors(map, [](std::size_t, const Vec<double, D>& g) { return g; });
    EXPECT_LT(norm(sum), 1e-13) << Correction::name;
  });
}
TEST(Corrections, WeightsSumToZeroWithTheParticleItself) {
  check_sum_of_weights<ShepardCorrection>();
  check_sum_of_weights<MixedCorrection>();
  check_sum_of_weights<LinearCorrection>();
}

TEST(Corrections, RadialMeansTheInverseOfTheMoment) {
  Corrections::for_each([]<class Correction>() {
    const Moments<3> moments = Cloud<3>(true).moments();
    const GradientMap<3> map = Correction{}.map(moments);
    const Mat<double, 3> rest = map.L * moments.first - Mat<double, 3>::identity();
    EXPECT_EQ(Correction::radial, map.scale == 1.0 && norm(map.shift) == 0.0 && double_dot(rest, rest) < 1e-20)
        << Correction::name;
    EXPECT_FALSE(Correction::summary.empty() || Correction::source.empty());
  });
  EXPECT_EQ(Corrections::names(), (std::vector<std::string>{"none", "shepard", "gradient", "mixed", "linear"}));
}

/// Neighbors in one line (in space: in one plane) except for a distance `off` of one of them.
template <int D>
GradientMap<D> nearly_flat(double off) {
  Moments<D> m;
  for (int k = 0; k < 6; ++k) {
    Vec<double, D> X{{k - 2.6}};
    if constexpr (D == 3) X[1] = (k * k) % 4 - 1.3;
    if (k == 3) X[D - 1] = off;
    m.first += outer(X, X);
  }
  return GradientCorrection{}.map(m);
}

TEST(Corrections, GradientSaysWhereItIsSingular) {
  EXPECT_FALSE(nearly_flat<2>(0.0).valid);
  EXPECT_FALSE(nearly_flat<3>(0.0).valid);
  EXPECT_FALSE(nearly_flat<2>(1e-4).valid);
  EXPECT_FALSE(nearly_flat<3>(1e-4).valid);
  EXPECT_TRUE(nearly_flat<2>(0.1).valid);
  EXPECT_TRUE(nearly_flat<3>(0.1).valid);
  EXPECT_FALSE(GradientCorrection{}.map(Moments<2>{}).valid);
  EXPECT_FALSE(ShepardCorrection{}.map(Moments<2>{}).valid);
  EXPECT_FALSE(MixedCorrection{}.map(Moments<2>{}).valid);
  EXPECT_FALSE(LinearCorrection{}.map(Moments<2>{}).valid);
  EXPECT_EQ(distance_to_identity(nearly_flat<3>(0.0).L), 0.0);
}

TEST(Corrections, SingularityDoesNotDependOnUnits) {
  Moments<3> m = Cloud<3>(true).moments();
  for (const double unit : {1e-12, 1.0, 1e12}) {
    Moments<3> scaled = m;
    scaled.first = unit * m.first;
    EXPECT_TRUE(GradientCorrection{}.map(scaled).valid);
  }
}

}  // namespace
}  // namespace sinew
