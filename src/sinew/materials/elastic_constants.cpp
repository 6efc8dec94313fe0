#include <array>
#include <sinew/materials/elastic_constants.hpp>
#include <sstream>

namespace sinew {
namespace {

struct Lame {
  double lambda, mu;
};

/// Two of the constants, in this order, and Lame's constants that follow from their values.
struct Relation {
  double ElasticConstants::*first;
  double ElasticConstants::*second;
  Lame (*lame)(double, double);
};

using Constants = ElasticConstants;

constexpr std::array relations{
    Relation{&Constants::youngs_modulus, &Constants::poissons_ratio,
             [](double E, double nu) {
               return Lame{E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))};
             }},
    Relation{&Constants::youngs_modulus, &Constants::bulk_modulus,
             [](double E, double K) {
               return Lame{3 * K * (3 * K - E) / (9 * K - E), 3 * K * E / (9 * K - E)};
             }},
    Relation{&Constants::youngs_modulus, &Constants::shear_modulus,
             [](double E, double G) {
               return Lame{G * (E - 2 * G) / (3 * G - E), G};
             }},
    Relation{&Constants::youngs_modulus, &Constants::lame_lambda,
             [](double E, double L) {
               return Lame{L, (E - 3 * L + std::sqrt(E * E + 9 * L * L + 2 * E * L)) / 4};
             }},
    Relation{&Constants::poissons_ratio, &Constants::bulk_modulus,
             [](double nu, double K) {
               return Lame{3 * K * nu / (1 + nu), 3 * K * (1 - 2 * nu) / (2 * (1 + nu))};
             }},
    Relation{&Constants::poissons_ratio, &Constants::shear_modulus,
             [](double nu, double G) {
               return Lame{2 * G * nu / (1 - 2 * nu), G};
             }},
    Relation{&Constants::poissons_ratio, &Constants::lame_lambda,
             [](double nu, double L) {
               return Lame{L, L * (1 - 2 * nu) / (2 * nu)};
             }},
    Relation{&Constants::bulk_modulus, &Constants::shear_modulus,
             [](double K, double G) {
               return Lame{K - 2 * G / 3, G};
             }},
    Relation{&Constants::bulk_modulus, &Constants::lame_lambda,
             [](double K, double L) {
               return Lame{L, 1.5 * (K - L)};
             }},
    Relation{&Constants::shear_modulus, &Constants::lame_lambda,
             [](double G, double L) {
               return Lame{L, G};
             }},
};

bool given(double value) { return !std::isnan(value); }

/// The names of the constants that were given, in the order of `describe`.
std::string names_given(const ElasticConstants& constants) {
  std::string names;
  ElasticConstants::describe(
      [&](const char* name, double value, auto&&...) {
        if (given(value)) names += (names.empty() ? "" : ", ") + std::string(name);
      },
      constants);
  return names.empty() ? "none" : names;
}

void fill(double& constant, double value) {
  if (!given(constant)) constant = value;
}

}  // namespace

std::optional<std::string> ElasticConstants::complete() {
  const std::array values{youngs_modulus, poissons_ratio, bulk_modulus, shear_modulus, lame_lambda};
  int count = 0;
  for (const double value : values) count += given(value) ? 1 : 0;
  if (count != 2)
    return "give exactly two of youngs_modulus, poissons_ratio, bulk_modulus, shear_modulus, lame_lambda; given: " +
           names_given(*this);

  Lame lame{};
  for (const Relation& r : relations)
    if (given(this->*r.first) && given(this->*r.second)) lame = r.lame(this->*r.first, this->*r.second);
  const double K = lame.lambda + 2.0 / 3.0 * lame.mu;
  const double nu = lame.lambda / (2.0 * (lame.lambda + lame.mu));
  if (!(K > 0.0 && lame.mu > 0.0 && nu < 0.5) || !std::isfinite(K)) {
    std::ostringstream text;
    text << names_given(*this) << " do not belong to a stable solid: they give bulk modulus " << K << ", shear modulus "
         << lame.mu << ", Poisson's ratio " << nu << "; both moduli must be greater than 0 and the ratio below 0.5";
    return text.str();
  }
  fill(lame_lambda, lame.lambda);
  fill(shear_modulus, lame.mu);
  fill(bulk_modulus, K);
  fill(poissons_ratio, nu);
  fill(youngs_modulus, lame.mu * (3.0 * lame.lambda + 2.0 * lame.mu) / (lame.lambda + lame.mu));
  return std::nullopt;
}

}  // namespace sinew
