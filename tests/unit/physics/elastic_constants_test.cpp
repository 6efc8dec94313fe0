#include <gtest/gtest.h>

#include <array>
#include <sinew/materials/elastic_constants.hpp>

namespace sinew {
namespace {

constexpr std::array members{&ElasticConstants::youngs_modulus, &ElasticConstants::poissons_ratio,
                             &ElasticConstants::bulk_modulus, &ElasticConstants::shear_modulus, &ElasticConstants::lame_lambda};

ElasticConstants of_youngs_modulus(double E, double nu) {
  ElasticConstants c;
  c.youngs_modulus = E;
  c.poissons_ratio = nu;
  EXPECT_EQ(c.complete(), std::nullopt);
  return c;
}

TEST(ElasticConstants, ClosedForms) {
  const ElasticConstants c = of_youngs_modulus(30e9, 0.3);
  EXPECT_NEAR(c.lambda(), 30e9 * 0.3 / (1.3 * 0.4), 1.0);
  EXPECT_NEAR(c.mu(), 30e9 / 2.6, 1.0);
  EXPECT_NEAR(c.bulk_modulus, 25e9, 1.0);
}

TEST(ElasticConstants, AnyTwoGiveTheOtherThree) {
  for (const double nu : {-0.6, -0.1, 0.2, 0.3, 0.4999}) {
    const ElasticConstants whole = of_youngs_modulus(17e6, nu);
    for (std::size_t a = 0; a < members.size(); ++a)
      for (std::size_t b = a + 1; b < members.size(); ++b) {
        ElasticConstants c;
        c.*members[a] = whole.*members[a];
        c.*members[b] = whole.*members[b];
        ASSERT_EQ(c.complete(), std::nullopt) << a << b << " at " << nu;
        for (const auto member : members)
          EXPECT_NEAR(c.*member, whole.*member, 1e-11 * std::abs(whole.*member)) << a << b << " at " << nu;
        EXPECT_EQ(c.*members[a], whole.*members[a]);
        EXPECT_EQ(c.*members[b], whole.*members[b]);
      }
  }
}

TEST(ElasticConstants, NotExactlyTwoIsAnError) {
  ElasticConstants none, one, three;
  one.shear_modulus = 1.0;
  three.youngs_modulus = three.poissons_ratio = three.bulk_modulus = 0.4;
  const std::string all = "give exactly two of youngs_modulus, poissons_ratio, bulk_modulus, shear_modulus, lame_lambda; given: ";
  EXPECT_EQ(none.complete(), all + "none");
  EXPECT_EQ(one.complete(), all + "shear_modulus");
  EXPECT_EQ(three.complete(), all + "youngs_modulus, poissons_ratio, bulk_modulus");
}

TEST(ElasticConstants, UnstableSolidsAreErrors) {
  ElasticConstants stiff;
  stiff.youngs_modulus = 10.0;
  stiff.bulk_modulus = 1.0;
  EXPECT_NE(stiff.complete(), std::nullopt);
  ElasticConstants negative;
  negative.lame_lambda = -1.0;
  negative.shear_modulus = 1.0;
  EXPECT_EQ(
      negative.complete(),
      "shear_modulus, lame_lambda do not belong to a stable solid: they give bulk modulus -0.333333, shear modulus 1, Poisson's "
      "ratio -inf; both moduli must be greater than 0 and the ratio below 0.5");
  ElasticConstants incompressible;
  incompressible.youngs_modulus = 1.0;
  incompressible.poissons_ratio = 0.5;
  EXPECT_NE(incompressible.complete(), std::nullopt);
  ElasticConstants undetermined;
  undetermined.poissons_ratio = undetermined.lame_lambda = 0.0;
  EXPECT_NE(undetermined.complete(), std::nullopt);
  ElasticConstants nearly;
  nearly.lame_lambda = 1e17;
  nearly.shear_modulus = 1.0;
  EXPECT_NE(nearly.complete(), std::nullopt);
}

TEST(ElasticConstants, ZeroPoissonsRatioIsAllowed) {
  const ElasticConstants c = of_youngs_modulus(2.0, 0.0);
  EXPECT_EQ(c.lambda(), 0.0);
  EXPECT_EQ(c.mu(), 1.0);
}

}  // namespace
}  // namespace sinew
