#pragma once
/// Materials with numbers, conversions between scalar types, and the registry as a list of test types.

#include <gtest/gtest.h>

#include <array>
#include <sinew/core/dual.hpp>
#include <sinew/materials/registry.hpp>
#include <string>

namespace sinew::testing_support {

/// A material with the given Lame constants.
template <class Material>
Material with_lame(double lambda, double mu) {
  Material m;
  m.density = 1.0;
  m.elastic.lame_lambda = lambda;
  m.elastic.shear_modulus = mu;
  EXPECT_EQ(m.elastic.complete(), std::nullopt);
  return m;
}

/// The matrix in another scalar type: constants in every lane, slopes zero.
template <class T>
Mat3<T> as(const Mat3<double>& a) {
  Mat3<T> b;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) b[i][j] = T(a[i][j]);
  return b;
}

/// dP/dF by dual numbers, one column for each component of F.
template <class Material>
Mat<double, 9> dual_tangent(const Material& m, const Mat3<double>& F) {
  Mat<double, 9> A;
  for (int column = 0; column < 9; ++column) {
    Mat3<Dual<double>> seeded = as<Dual<double>>(F);
    seeded[column / 3][column % 3].slope = 1.0;
    const auto P = m.respond(seeded).P;
    for (int row = 0; row < 9; ++row) A[row][column] = P[row / 3][row % 3].slope;
  }
  return A;
}

template <class List>
struct AsTestTypes;
template <class... Ts>
struct AsTestTypes<TypeList<Ts...>> {
  using Type = ::testing::Types<Ts...>;
};
using MaterialTypes = AsTestTypes<ElasticMaterials>::Type;

struct MaterialNames {
  template <class Material>
  static std::string GetName(int) {
    return std::string(Material::name);
  }
};

}  // namespace sinew::testing_support
