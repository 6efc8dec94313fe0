#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sinew/model/expression.hpp>

namespace sinew {
namespace {

double value_of(const std::string& text, const Constants& constants = {}) {
  return Expression(text, constants, Place{}, false)(0.0);
}

TEST(Expression, Arithmetic) {
  EXPECT_EQ(value_of("1 + 2*3"), 7.0);
  EXPECT_EQ(value_of("2^3^2"), 512.0);
  EXPECT_EQ(value_of("-2^2"), -4.0);
  EXPECT_EQ(value_of("1.5e-3*2"), 0.003);
  EXPECT_EQ(value_of("1/n", {{"n", 8.0}}), 0.125);
}

TEST(Expression, Functions) {
  EXPECT_DOUBLE_EQ(value_of("sin(pi/6)"), 0.5);
  EXPECT_DOUBLE_EQ(value_of("atan2(1, 1)"), std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(value_of("log(e)"), 1.0);
  EXPECT_DOUBLE_EQ(value_of("ln(e^2)"), 2.0);
  EXPECT_DOUBLE_EQ(value_of("log10(1000)"), 3.0);
  EXPECT_EQ(value_of("pow(2, 10)"), 1024.0);
  EXPECT_EQ(value_of("min(3, 1, 2) + max(4, 5)"), 6.0);
  EXPECT_EQ(value_of("floor(-1.5) + ceil(-1.5)"), -3.0);
  EXPECT_EQ(value_of("round(2.5) + sign(-3)"), 2.0);
  EXPECT_EQ(value_of("sqrt(16) + abs(-1)"), 5.0);
  EXPECT_DOUBLE_EQ(value_of("cosh(1)^2 - sinh(1)^2"), 1.0);
  EXPECT_DOUBLE_EQ(value_of("asin(1) + acos(1) + tanh(0) + exp(0) + cos(0) + tan(0) + atan(0)"), std::numbers::pi / 2 + 2.0);
}

TEST(Expression, Conditions) {
  EXPECT_EQ(value_of("if(2 > 1, 10, 20)"), 10.0);
  EXPECT_EQ(value_of("2 < 1 ? 10 : 20"), 20.0);
  EXPECT_EQ(value_of("(1 <= 1) && (2 != 3) || 0"), 1.0);
  EXPECT_EQ(value_of("1 == 1"), 1.0);
}

TEST(Expression, FieldsOfPlaceAndTime) {
  const Expression field("X + 10*Y + 100*Z + 1000*x + 1e4*y + 1e5*z + 1e6*t", {}, Place{}, true);
  EXPECT_EQ(field({{1, 2, 3}}, {{4, 5, 6}}, 7.0), 7654321.0);
  EXPECT_TRUE(field.depends_on_place());
  EXPECT_TRUE(field.depends_on_current_place());
  EXPECT_TRUE(field.depends_on_time());
}

TEST(Expression, SaysWhatItDependsOn) {
  const Expression reference("Z < 0.5", {}, Place{}, true);
  EXPECT_TRUE(reference.depends_on_place());
  EXPECT_FALSE(reference.depends_on_current_place());
  EXPECT_FALSE(reference.depends_on_time());
  const Expression ramp("min(t, 1)", {}, Place{}, true);
  EXPECT_FALSE(ramp.depends_on_place());
  EXPECT_TRUE(ramp.depends_on_time());
  EXPECT_EQ(ramp(0.25), 0.25);
  const Expression constant("2*n", {{"n", 3.0}}, Place{}, true);
  EXPECT_TRUE(constant.is_constant());
  EXPECT_EQ(constant(9.0), 6.0);
  EXPECT_EQ(Expression(0.1).text(), "0.1");
}

TEST(Expression, CopiesAreIndependent) {
  const Expression original("x*t", {}, Place{}, true);
  Expression copy = original;
  EXPECT_EQ(copy({}, {{2, 0, 0}}, 3.0), 6.0);
  EXPECT_EQ(original({}, {{5, 0, 0}}, 7.0), 35.0);
  Expression assigned;
  assigned = copy;
  copy = Expression(1.0);
  EXPECT_EQ(assigned({}, {{2, 0, 0}}, 3.0), 6.0);
  EXPECT_TRUE(assigned.depends_on_time());
}

TEST(Expression, OverOtherVariables) {
  const Expression sum = Expression::over({"tip", "root", "t"}, "tip - root + n*t", {{"n", 2.0}}, Place{});
  const double values[] = {5.0, 3.0, 10.0};
  EXPECT_EQ(sum.at(values), 22.0);
  EXPECT_THROW(Expression::over({"tip"}, "X", {}, Place{}), CaseError);
}

TEST(Expression, NamesAreFoundInOrder) {
  EXPECT_EQ(names_in_expression("2e3*b + sin(a)/c_1"), (std::vector<std::string>{"b", "a", "c_1"}));
  EXPECT_TRUE(is_reserved_name("pi") && is_reserved_name("X") && is_reserved_name("if"));
  EXPECT_FALSE(is_reserved_name("omega"));
}

}  // namespace
}  // namespace sinew
