/// Numbers, units, expressions and parameters that are wrong.

#include "errors/wrong_case.hpp"

namespace sinew {

static const std::vector<WrongCase> wrong_numbers{
    {"NegativeDensity", "density = 1100.0", "density = -1100.0",
     "case.toml:13:11: material \"rubber\": density must be greater than 0, found -1100"},
    {"NegativeDensityFromExpression", "density = 1100.0", "density = \"n-10\"",
     "case.toml:13:11: material \"rubber\": density must be greater than 0, found -4 from \"n-10\""},
    {"PoissonsRatioOneHalf", "0.45", "0.5",
     "case.toml:15:18: material \"rubber\": poissons_ratio must be greater than -1 and below 0.5, found 0.5"},
    {"NumberIsTable", "density = 1100.0", "density = { value = 1 }",
     "case.toml:13:11: material \"rubber\": density: expected a number, found a table"},
    {"NumberIsBoolean", "cfl = 0.3", "cfl = true", "case.toml:29:7: [solver]: cfl: expected a number, found true or false"},
    {"NumberIsWord", "cfl = 0.3", "cfl = \"fast\"",
     "case.toml:29:7: [solver]: cfl: expected a number; in the expression \"fast\": unknown name \"fast\". Known names: "
     "end_time, n, omega, e, pi."},
    {"NumberIsInfinite", "density = 1100.0", "density = inf",
     "case.toml:13:11: material \"rubber\": density must be a finite number, found inf"},
    {"NumberIsNotANumber", "density = 1100.0", "density = nan",
     "case.toml:13:11: material \"rubber\": density must be a finite number, found nan"},
    {"DivisionByZero", "\"1/n\"", "\"1/(n-6)\"",
     "case.toml:9:74: body \"column\": geometry: spacing: expected a number; the expression \"1/(n-6)\" gives inf, not a finite "
     "number"},
    {"WholeNumber", "spacing = \"1/n\"", "spacing = 0.1, seed = 2.5",
     "case.toml:9:86: body \"column\": geometry: seed must be a whole number, found 2.5"},
    {"UnknownUnit", "17 MPa", "17 MPs",
     "case.toml:14:18: material \"rubber\": youngs_modulus = \"17 MPs\": unknown unit \"MPs\". Known units: m, kg, g, t, s, min, "
     "h, N, Pa, bar, psi, J, W, Hz, in, ft, lb, rad, deg, %, with the prefixes n, u, m, c, k, M, G, and products such as kg/m^3"},
    {"UnitInFormula", "17 MPa", "17 MPa * (n < 3)",
     "case.toml:14:18: material \"rubber\": youngs_modulus = \"17 MPa * (n < 3)\": a formula takes no units. Write plain numbers "
     "in "
     "the units of the case"},
    {"UnitOfWrongDimension", "17 MPa", "17 mm",
     "case.toml:14:18: material \"rubber\": youngs_modulus = \"17 mm\": the unit mm does not fit, expected Pa or a unit of the "
     "same kind"},
    {"UnitWhereNoneBelongs", "0.45", "\"0.45 m\"",
     "case.toml:15:18: material \"rubber\": poissons_ratio = \"0.45 m\": expected a number without a unit"},
    {"MultiplicationSignMissing", "\"1/n\"", "\"2 n\"",
     "case.toml:9:74: body \"column\": geometry: spacing = \"2 n\": an operator is missing after 2; to multiply, write \"2*n\""},
    {"UnknownVariable", "x*omega", "x*omga",
     "case.toml:24:25: initial 1: velocity[1]: expected a number or an expression; in the expression \"x*omga\": unknown name "
     "\"omga\". Did you mean \"omega\"? Known names: X, Y, Z, x, y, z, t, n, omega, e, pi."},
    {"UnknownFunction", "x*omega", "sine(x)",
     "case.toml:24:25: initial 1: velocity[1]: expected a number or an expression; in the expression \"sine(x)\": unknown "
     "function \"sine\". Did you mean \"sin\"? Known functions: sin, cos, tan, asin, acos, atan, atan2, sinh, cosh, tanh, exp, "
     "log, ln, log10, sqrt, abs, min, max, floor, ceil, round, sign, pow, if."},
    {"FunctionWithoutBrackets", "x*omega", "sin*x",
     "case.toml:24:25: initial 1: velocity[1]: expected a number or an expression; in the expression \"sin*x\": \"sin\" is a "
     "function and needs (...) after it"},
    {"PlaceWhereNoneIsKnown", "\"1/n\"", "\"x/n\"",
     "case.toml:9:74: body \"column\": geometry: spacing: expected a number; in the expression \"x/n\": \"x\" (a place or the "
     "time) cannot be used here, where one number is expected"},
    {"BracketMissing", "\"1/n\"", "\"1/(n+1\"",
     "case.toml:9:74: body \"column\": geometry: spacing: expected a number; in the expression \"1/(n+1\": a closing bracket "
     "\")\" is missing"},
    {"ExpressionEndsEarly", "\"1/n\"", "\"1/\"",
     "case.toml:9:74: body \"column\": geometry: spacing: expected a number; in the expression \"1/\": it ends too early, "
     "something is missing after the last character"},
    {"OperatorTwice", "\"1/n\"", "\"1*/n\"",
     "case.toml:9:74: body \"column\": geometry: spacing: expected a number; in the expression \"1*/n\": unexpected operator at "
     "character 3 (near \"/\")"},
    {"OperatorMissing", "\"1/n\"", "\"(1) n\"",
     "case.toml:9:74: body \"column\": geometry: spacing: expected a number; in the expression \"(1) n\": an operator is missing "
     "before \"n\" at character 5"},
    {"TooFewArguments", "\"1/n\"", "\"pow(n)\"",
     "case.toml:9:74: body \"column\": geometry: spacing: expected a number; in the expression \"pow(n)\": too few arguments for "
     "the function (near \"pow\")"},
    {"TooManyArguments", "\"1/n\"", "\"sin(n, 2)\"",
     "case.toml:9:74: body \"column\": geometry: spacing: expected a number; in the expression \"sin(n, 2)\": too many arguments "
     "for the function (near \"sin\")"},
    {"ExpressionEmpty", "\"1/n\"", "\"\"",
     "case.toml:9:74: body \"column\": geometry: spacing: expected a number; in the expression \"\": it is empty"},
    {"EqualSign", "Z < 1/n", "Z = 0",
     "case.toml:21:35: region \"foot\": where: expected a number or an expression; in the expression \"Z = 0\": to compare, "
     "write \"==\" instead of \"=\""},
    {"ParameterCycle", "omega = 105.0", "omega = \"a\"\na = \"2*b\"\nb = \"omega+1\"",
     "case.toml:6:9: [parameters]: \"omega\" depends on itself: omega -> a -> b -> omega"},
    {"ParameterOfItself", "omega = 105.0", "omega = \"omega+1\"",
     "case.toml:6:9: [parameters]: \"omega\" depends on itself: omega -> omega"},
    {"ParameterReserved", "omega = 105.0", "omega = 105.0\npi = 3",
     "case.toml:7:1: [parameters]: the name \"pi\" already means something in expressions; choose another"},
    {"ParameterBadName", "omega = 105.0", "omega = 105.0\n\"a-b\" = 3",
     "case.toml:7:1: [parameters]: the name \"a-b\" cannot be used in expressions; use letters, digits and _, and begin with a "
     "letter"},
    {"ParameterIsArray", "omega = 105.0", "omega = [1]", "case.toml:6:9: [parameters]: omega: expected a number, found an array"},
    {"ParameterUnknownName", "omega = 105.0", "omega = \"m*2\"",
     "case.toml:6:9: [parameters]: omega: expected a number; in the expression \"m*2\": unknown name \"m\". Did you mean \"n\"? "
     "Known names: n, e, pi."},
};
SINEW_WRONG_CASES(WrongNumbers, wrong_numbers);

TEST(WrongNumbers, ExpectedUnitIsThatOfTheSystem) {
  std::string text = good_case;
  text.replace(text.find("17 MPa"), 6, "17 mm");
  text.replace(text.find("[parameters]"), 0, "units = { length = \"mm\", mass = \"kg\", time = \"ms\" }\n");
  EXPECT_EQ(error_of(text),
            "case.toml:15:18: material \"rubber\": youngs_modulus = \"17 mm\": the unit mm does not fit, expected GPa or a unit "
            "of the same kind");
}

}  // namespace sinew
