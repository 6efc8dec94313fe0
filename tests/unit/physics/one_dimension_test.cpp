/// The study of gradients in one dimension of Wiragunarsa et al. (2024), section 4.1: the average over bonds against the usual gradient, with the kernel of first order.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <sinew/kernels/cubic_spline.hpp>
#include <vector>

namespace sinew {
namespace {

using std::numbers::pi;

/// n points in the middle of n equal cells of [0, 1], smoothing length h; all sums over all points.
struct Chain {
  int n;
  double ratio;  ///< h over the spacing
  double dx = 1.0 / n, R = 2.0 * ratio / n;

  double X(int i) const { return (i + 0.5) * dx; }
  double W(int i, int j) const { return CubicSpline::value<1>(std::abs(X(j) - X(i)), R); }
  double slope(int i, int j) const {  // with respect to X_i
    const double y = X(j) - X(i);
    return y == 0.0 ? 0.0 : -CubicSpline::slope<1>(std::abs(y), R) * (y > 0.0 ? 1.0 : -1.0);
  }
  struct Moments {
    double m0 = 0.0, m1 = 0.0, m2 = 0.0;  ///< sum V W y^k, y = X_j - X_i
    double d0 = 0.0, d1 = 0.0, d2 = 0.0;  ///< their derivatives with respect to X_i
  };
  Moments moments(int i) const {
    Moments m;
    for (int j = 0; j < n; ++j) {
      const double y = X(j) - X(i), w = dx * W(i, j), d = dx * slope(i, j);
      m.m0 += w, m.m1 += w * y, m.m2 += w * y * y;
      m.d0 += d, m.d1 += d * y - w, m.d2 += d * y * y - 2.0 * w * y;
    }
    return m;
  }
  /// Kernel of first order: W (a + b y) with sum V W1 = 1, sum V W1 y = 0; and its derivative.
  double W1(const Moments& m, int i, int j) const {
    const double det = m.m0 * m.m2 - m.m1 * m.m1;
    return W(i, j) * (m.m2 - m.m1 * (X(j) - X(i))) / det;
  }
  double g1(const Moments& m, int i, int j) const {
    const double y = X(j) - X(i), det = m.m0 * m.m2 - m.m1 * m.m1, top = m.m2 - m.m1 * y;
    const double d_det = m.d0 * m.m2 + m.m0 * m.d2 - 2.0 * m.m1 * m.d1, d_top = m.d2 - m.d1 * y + m.m1;
    return slope(i, j) * top / det + W(i, j) * (d_top / det - top * d_det / (det * det));
  }
  std::vector<double> direct(const std::function<double(double)>& x) const {
    std::vector<double> F(n, 0.0);
    for (int i = 0; i < n; ++i) {
      const Moments m = moments(i);
      for (int j = 0; j < n; ++j) F[i] += dx * (x(X(j)) - x(X(i))) * g1(m, i, j);
    }
    return F;
  }
  /// In one dimension the gradient of a bond is x_ij / X_ij, whatever its ends do.
  std::vector<double> bonds(const std::function<double(double)>& x, bool self = true) const {
    std::vector<double> F = direct(x);
    for (int i = 0; i < n; ++i) {
      const Moments m = moments(i);
      F[i] *= self ? dx * W1(m, i, i) : 0.0;
      for (int j = 0; j < n; ++j)
        if (j != i) F[i] += dx * W1(m, i, j) * (x(X(j)) - x(X(i))) / (X(j) - X(i));
    }
    return F;
  }
  double rms(const std::vector<double>& F, const std::function<double(double)>& exact) const {
    double sum = 0.0;
    for (int i = 0; i < n; ++i) sum += (F[i] - exact(X(i))) * (F[i] - exact(X(i)));
    return std::sqrt(sum / n);
  }
};

/// Linear deformations are exact, at surfaces as well; without the bond of a particle with itself all are too small by V W (figure 4).
TEST(OneDimension, LinearDeformation) {
  const Chain chain{20, 1.2};
  const auto x = [](double X) { return 1.3 * X - 0.2; };
  for (int i = 0; i < chain.n; ++i) {
    EXPECT_NEAR(chain.direct(x)[i], 1.3, 1e-12);
    EXPECT_NEAR(chain.bonds(x)[i], 1.3, 1e-12);
    EXPECT_NEAR(chain.bonds(x, false)[i], 1.3 * (1.0 - chain.dx * chain.W1(chain.moments(i), i, i)), 1e-12);
  }
}

/// Figures 5 and 6: quadratic, cubic, sine. The average has the smaller error, and both are of second order for the sine.
TEST(OneDimension, ErrorsOfCurvedDeformations) {
  const struct {
    std::function<double(double)> x, F;
  } fields[] = {{[](double X) { return X + 0.1 * X * X; }, [](double X) { return 1.0 + 0.2 * X; }},
                {[](double X) { return X + 0.1 * X * X * X; }, [](double X) { return 1.0 + 0.3 * X * X; }},
                {[](double X) { return X + 0.02 * std::sin(2.0 * pi * X); },
                 [](double X) { return 1.0 + 0.04 * pi * std::cos(2.0 * pi * X); }}};
  for (const auto& field : fields)
    for (const double ratio : {1.2, 1.5, 2.0}) {
      double last[2] = {0.0, 0.0};
      for (const int n : {20, 40, 80}) {
        const Chain chain{n, ratio};
        const double direct = chain.rms(chain.direct(field.x), field.F), bonds = chain.rms(chain.bonds(field.x), field.F);
        EXPECT_LT(bonds, direct) << n << " points, h = " << ratio << " dx";
        if (last[0] > 0.0) {
          EXPECT_GT(std::log2(last[0] / direct), 1.4);
          EXPECT_GT(std::log2(last[1] / bonds), 1.4);
        }
        last[0] = direct, last[1] = bonds;
      }
    }
}

/// What is seen of a wave of k radians a spacing, inside: the table of docs/theory/bonds.md.
TEST(OneDimension, GainOfWaves) {
  const struct {
    double ratio, direct[4], bonds[4];
  } table[] = {{1.2, {.909, .678, .405, .170}, {.919, .708, .442, .194}},
               {1.5, {.864, .548, .240, .065}, {.892, .630, .344, .131}},
               {2.0, {.765, .324, .060, .002}, {.840, .506, .234, .084}}};
  for (const auto& row : table)
    for (int k = 0; k < 4; ++k) {
      const Chain chain{41, row.ratio};
      const double wave = 0.2 * pi * (k + 1) * chain.n;
      const auto x = [wave](double X) { return std::sin(wave * (X - 0.5)) / wave; };
      EXPECT_NEAR(chain.direct(x)[20], row.direct[k], 1.1e-3);
      EXPECT_NEAR(chain.bonds(x)[20], row.bonds[k], 1.1e-3);
    }
}

}  // namespace
}  // namespace sinew
