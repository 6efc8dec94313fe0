#include <unit/physics/plastic_support.hpp>

namespace sinew {
namespace {

using namespace testing_support;

template <class Material>
class J2Contract : public ::testing::Test {
 protected:
  using History = PlasticHistory<Mat3<double>>;
  Material material = plastic<Material>();
  std::mt19937_64 random{41};
  static constexpr double dt = 0.01;
  Mat3<double> here;  ///< where the last history has come to

  History some_history() { return random_history(material, random, here); }
  /// The flow stress in the rate of the step from `old` to `now`; its temperature is that of `old`.
  double flow_stress(const History& old, const History& now) const {
    PlasticPoint<double> at{now.strain, (now.strain - old.strain) / dt, 1.0};
    if constexpr (requires { material.hardening.strength_left(1.0); })
      at.strength_left = material.hardening.strength_left(material.temperature(old));
    return material.hardening.flow_stress(at).value;
  }
};
TYPED_TEST_SUITE(J2Contract, PlasticTypes, MaterialNames);

TYPED_TEST(J2Contract, VirginReferenceIsFreeOfStressAndEnergy) {
  PlasticHistory<Mat3<double>> history;
  const auto r = respond(this->material, Mat3<double>::identity(), history, 0.0);
  EXPECT_LT(distance(r.P, Mat3<double>{}), 1e-15);
  EXPECT_EQ(r.energy, 0.0);
  EXPECT_EQ(history.strain, 0.0);
}

TYPED_TEST(J2Contract, ObeysHookesLawAtSmallStrain) {
  PlasticHistory<Mat3<double>> history;
  const LinearElastic hooke = with_lame<LinearElastic>(2.0 - 1.6 / 3.0, 0.8);
  const Mat3<double> I = Mat3<double>::identity(), F = I + 1e-6 * Mat3<double>{{{1, 2, -1}, {0.5, -2, 1}, {0, 1, 3}}};
  EXPECT_LT(distance(respond(this->material, F, history, 0.0).P, hooke.respond(F).P), 1e-10);
  EXPECT_LT(distance(tangent(this->material, I, history, 0.0), hooke.tangent(I)), 1e-14);
}

TYPED_TEST(J2Contract, StressIsOnTheYieldSurfaceAfterFlow) {
  int flowed = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto old = this->some_history();
    const Mat3<double> F = random_gradient(this->random, 0.02) * this->here;
    auto now = old;
    const Mat3<double> P = respond(this->material, F, now, this->dt).P;
    const double q = von_mises_of(kirchhoff(P, F)), yield = this->flow_stress(old, now);
    if (now.strain > old.strain) {
      ++flowed;
      EXPECT_NEAR(q, yield, 1e-12 * yield);
      EXPECT_NEAR(now.work - old.work, yield * (now.strain - old.strain), 1e-14 * yield);
    } else {
      EXPECT_LE(q, yield * (1.0 + 1e-12));
    }
  }
  EXPECT_GT(flowed, 200);
}

TYPED_TEST(J2Contract, FlowKeepsTheVolume) {
  for (int trial = 0; trial < 100; ++trial) {
    const auto history = this->some_history();
    EXPECT_GT(history.strain, 0.0);
    EXPECT_NEAR(determinant(Mat3<double>::identity() + history.metric), 1.0, 1e-12);
    const Mat3<double> P = this->material.recall(this->here, history).P;
    EXPECT_NEAR(trace(kirchhoff(P, this->here)) / 3.0, 2.0 * std::log(determinant(this->here)), 1e-12);
  }
}

/// The whole path turned by Q: stresses turn, histories stay.
TYPED_TEST(J2Contract, TurnsWithTheBody) {
  for (int trial = 0; trial < 100; ++trial) {
    auto history = this->some_history(), turned = history;
    const Mat3<double> F = random_gradient(this->random, 0.02) * this->here, Q = random_rotation(this->random);
    const Mat3<double> P = respond(this->material, F, history, this->dt).P;
    EXPECT_LT(distance(respond(this->material, Q * F, turned, this->dt).P, Q * P), 1e-13);
    EXPECT_NEAR(turned.strain, history.strain, 1e-13);
    EXPECT_LT(distance(turned.metric, history.metric), 1e-12);
  }
}

TYPED_TEST(J2Contract, RecallGivesTheStressOfTheNewHistory) {
  for (int trial = 0; trial < 100; ++trial) {
    auto history = this->some_history();
    const Mat3<double> F = random_gradient(this->random, 0.02) * this->here;
    const auto r = respond(this->material, F, history, this->dt), again = this->material.recall(F, history);
    EXPECT_LT(distance(r.P, again.P), 1e-14);
    EXPECT_NEAR(r.energy, again.energy, 1e-15);
  }
}

TYPED_TEST(J2Contract, ElasticStressIsTheDerivativeOfTheEnergy) {
  const double step = 1e-6;
  for (int trial = 0; trial < 50; ++trial) {
    const auto history = this->some_history();
    const Mat3<double> F = random_gradient(this->random, 0.3) * this->here, P = this->material.recall(F, history).P;
    for (int k = 0; k < 9; ++k) {
      Mat3<double> more = F, less = F;
      more[k / 3][k % 3] += step, less[k / 3][k % 3] -= step;
      const double slope =
          (this->material.recall(more, history).energy - this->material.recall(less, history).energy) / (2 * step);
      EXPECT_NEAR(slope, P[k / 3][k % 3], 2e-9);
    }
  }
}

TYPED_TEST(J2Contract, TangentIsTheDerivativeOfTheStressOfAStep) {
  const double step = 1e-7;
  for (int trial = 0; trial < 60; ++trial) {
    const auto old = trial < 3 ? PlasticHistory<Mat3<double>>{} : this->some_history();
    const bool elastic = trial % 3 == 0;
    const Mat3<double> F =
        random_gradient(this->random, elastic ? 1e-4 : 0.03) * (trial < 3 ? Mat3<double>::identity() : this->here);
    const Tangent<double> A = tangent(this->material, F, old, this->dt);
    for (int column = 0; column < 9; ++column) {
      Mat3<double> more = F, less = F;
      more[column / 3][column % 3] += step, less[column / 3][column % 3] -= step;
      auto after_more = old, after_less = old;
      const Mat3<double> slope = (0.5 / step) * (respond(this->material, more, after_more, this->dt).P -
                                                 respond(this->material, less, after_less, this->dt).P);
      for (int row = 0; row < 9; ++row) EXPECT_NEAR(A[row][column], slope[row / 3][row % 3], 2e-6) << "trial " << trial;
    }
    EXPECT_LT(distance(A, transpose(A)), 1e-11) << "flow by the associated rule is symmetric";
  }
}

TYPED_TEST(J2Contract, PackGivesTheValuesOfItsLanes) {
  std::array<PlasticHistory<Mat3<double>>, lanes> single;
  std::array<Mat3<double>, lanes> F;
  PlasticHistory<Mat3<Pack>> packed;
  Mat3<Pack> packed_F;
  for (int k = 0; k < lanes; ++k) {
    if (k > 0) single[k] = this->some_history();  // lane 0 is virgin and stays elastic
    F[k] = k > 0 ? random_gradient(this->random, 0.03) * this->here : Mat3<double>::identity();
    packed.strain.set(k, single[k].strain), packed.work.set(k, single[k].work);
    for (int c = 0; c < 9; ++c) {
      packed.metric[c / 3][c % 3].set(k, single[k].metric[c / 3][c % 3]);
      packed_F[c / 3][c % 3].set(k, F[k][c / 3][c % 3]);
    }
  }
  const auto r = respond(this->material, packed_F, packed, this->dt);
  const Pack stiffness = acoustic_stiffness(this->material, packed_F, r.P), modulus = this->material.hourglass_modulus(packed);
  for (int k = 0; k < lanes; ++k) {
    const auto one = respond(this->material, F[k], single[k], this->dt);
    EXPECT_NEAR(r.energy[k], one.energy, 1e-14);
    EXPECT_NEAR(packed.strain[k], single[k].strain, 1e-13);
    EXPECT_NEAR(packed.work[k], single[k].work, 1e-14);
    EXPECT_NEAR(stiffness[k], acoustic_stiffness(this->material, F[k], one.P), 1e-12 * stiffness[k]);
    EXPECT_NEAR(modulus[k], k == 0 ? this->material.elastic.youngs_modulus : 0.01, 1e-15);
    for (int c = 0; c < 9; ++c) EXPECT_NEAR(r.P[c / 3][c % 3][k], one.P[c / 3][c % 3], 1e-13);
  }
}

TYPED_TEST(J2Contract, PlaneStrainIsTheWholeMatrixInThePlane) {
  for (int trial = 0; trial < 50; ++trial) {
    PlasticHistory<Mat3<double>> whole;
    PlasticHistory<PlaneMatrix<double>> plane;
    PlaneMatrix<double> F = PlaneMatrix<double>::identity();
    for (int step = 0; step < 6; ++step) {
      F.in_plane = random_matrix<2>(this->random, 0.03, 0.5) * F.in_plane;
      const auto in_plane = respond(this->material, F, plane, this->dt);
      const auto in_space_too = respond(this->material, in_space(F), whole, this->dt);
      EXPECT_LT(distance(in_space(in_plane.P), in_space_too.P), 1e-13);
      EXPECT_NEAR(plane.strain, whole.strain, 1e-13);
    }
    EXPECT_LT(distance(in_space(plane.metric), whole.metric), 1e-12);
  }
}

/// Against the elastic tangent at the same state, which is stiffer than that of flow; also at elastic strains that no metal bears.
TYPED_TEST(J2Contract, AcousticStiffnessBoundsTheAcousticTensor) {
  double loosest = 0.0;
  auto strong = this->material;
  strong.hardening.yield_stress = 1e6;
  for (int trial = 0; trial < 200; ++trial) {
    const auto history = this->some_history();
    const Mat3<double> F = random_gradient(this->random, trial % 2 == 0 ? 0.01 : 0.4) * this->here;
    const Tangent<double> A = strong.tangent(F, history, 0.0);
    const double bound = acoustic_stiffness(strong, F, strong.recall(F, history).P);
    double sampled = 0.0;
    for (int k = 0; k < 300; ++k) {
      const Vec3<double> N = random_direction(this->random);
      Mat3<double> Q;
      for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 9; ++column) Q[row / 3][column / 3] += A[row][column] * N[row % 3] * N[column % 3];
      const Vec3<double> values = spectrum(0.5 * (Q + transpose(Q))).values;
      sampled = std::max({sampled, values[0], values[1], values[2]});
    }
    EXPECT_GE(bound, sampled * (1.0 - 1e-12));
    if (trial % 2 == 0) loosest = std::max(loosest, bound / sampled);
  }
  EXPECT_LT(loosest, 1.5) << "at elastic strains of a few percent";
  PlasticHistory<Mat3<double>> virgin;
  EXPECT_NEAR(acoustic_stiffness(this->material, Mat3<double>::identity(), Mat3<double>{}), 2.0 + 4.0 / 3.0 * 0.8, 1e-12);
}

TYPED_TEST(J2Contract, SaysWhatItIs) {
  EXPECT_FALSE(TypeParam::name.empty() || TypeParam::summary.empty() || TypeParam::source.empty());
}

}  // namespace
}  // namespace sinew
