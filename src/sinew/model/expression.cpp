#include <sinew/model/expression.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <muParser.h>
#include <numbers>
#include <sinew/core/number_text.hpp>

namespace sinew {
namespace {

double floor_of(double a) { return std::floor(a); }
double ceil_of(double a) { return std::ceil(a); }
double round_of(double a) { return std::round(a); }
double sign_of(double a) { return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : 0.0); }
double power_of(double a, double b) { return std::pow(a, b); }
double choose(double condition, double a, double b) { return condition != 0.0 ? a : b; }

const std::vector<std::string>& functions() {
  static const std::vector<std::string> names{"sin",  "cos",  "tan",   "asin", "acos",  "atan",  "atan2", "sinh",
                                              "cosh", "tanh", "exp",   "log",  "ln",    "log10", "sqrt",  "abs",
                                              "min",  "max",  "floor", "ceil", "round", "sign",  "pow",   "if"};
  return names;
}

const Constants& fixed_constants() {
  static const Constants constants{{"pi", std::numbers::pi}, {"e", std::numbers::e}};
  return constants;
}

mu::Parser make_parser() {
  mu::Parser parser;
  parser.ClearConst();
  parser.DefineFun("floor", floor_of);
  parser.DefineFun("ceil", ceil_of);
  parser.DefineFun("round", round_of);
  parser.DefineFun("sign", sign_of);
  parser.DefineFun("pow", power_of);
  parser.DefineFun("if", choose);
  for (const auto& [name, value] : fixed_constants()) parser.DefineConst(name, value);
  return parser;
}

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool continues_name(char c) { return starts_name(c) || std::isdigit(static_cast<unsigned char>(c)) || c == '.'; }
bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct UsedName {
  std::string name;
  bool called = false;  ///< followed by an opening bracket
};

std::vector<UsedName> scan(const std::string& text) {
  std::vector<UsedName> used;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (std::isdigit(static_cast<unsigned char>(text[i])) || text[i] == '.') {  // a number; its exponent is no name
      char* end = nullptr;
      std::strtod(text.c_str() + i, &end);
      i = std::max(static_cast<std::size_t>(end - text.c_str()), i + 1) - 1;
    } else if (starts_name(text[i])) {
      std::size_t n = i;
      while (n < text.size() && continues_name(text[n])) ++n;
      std::size_t next = n;
      while (next < text.size() && text[next] == ' ') ++next;
      used.push_back({text.substr(i, n - i), next < text.size() && text[next] == '('});
      i = n - 1;
    }
  }
  return used;
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

/// Reports the first name that means nothing here; muParser's own message would name no alternatives.
void check_names(const std::string& text, const std::vector<std::string>& variables, const Constants& constants,
                 const Place& place) {
  std::vector<std::string> known = variables;
  for (const auto& [name, value] : constants) known.push_back(name);
  for (const auto& [name, value] : fixed_constants()) known.push_back(name);
  for (const auto& [name, called] : scan(text)) {
    if (called && contains(functions(), name)) continue;
    if (!called && contains(known, name)) continue;
    const std::string in = "in the expression " + quoted(text) + ": ";
    if (called) throw CaseError(place, in + unknown_name_message("function", name, functions()));
    if (contains(field_variables(), name))
      throw CaseError(place, in + quoted(name) + " (a place or the time) cannot be used here, where one number is expected");
    if (contains(functions(), name)) throw CaseError(place, in + quoted(name) + " is a function and needs (...) after it");
    throw CaseError(place, in + unknown_name_message("name", name, known));
  }
}

/// "Z = 0" would assign; whoever writes it means "Z == 0".
void check_no_assignment(const std::string& text, const Place& place) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    const bool doubled = i + 1 < text.size() && text[i + 1] == '=';
    const bool second = i > 0 && std::string("<>!=").find(text[i - 1]) != std::string::npos;
    if (!doubled && !second)
      throw CaseError(place, "in the expression " + quoted(text) + ": to compare, write \"==\" instead of \"=\"");
  }
}

/// muParser's complaint about the grammar, in one clear sentence.
std::string grammar_message(const mu::ParserError& error) {
  const std::string at = " at character " + std::to_string(error.GetPos() + 1);
  const std::string token = error.GetToken().empty() ? "" : " (near " + quoted(error.GetToken()) + ")";
  switch (error.GetCode()) {
    case mu::ecUNEXPECTED_EOF: return "it ends too early, something is missing after the last character";
    case mu::ecMISSING_PARENS: return "a closing bracket \")\" is missing";
    case mu::ecUNEXPECTED_PARENS: return "unexpected bracket" + at;
    case mu::ecUNEXPECTED_OPERATOR: return "unexpected operator" + at + token;
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_VAR:
    case mu::ecUNEXPECTED_FUN:
      return "an operator is missing before" + token.substr(token.empty() ? 0 : 6, token.size() - 7) + at;
    case mu::ecTOO_MANY_PARAMS: return "too many arguments for the function" + token;
    case mu::ecTOO_FEW_PARAMS: return "too few arguments for the function" + token;
    case mu::ecEMPTY_EXPRESSION: return "it is empty";
    default: return "cannot be understood" + at + token;
  }
}

}  // namespace

struct Expression::Compiled {
  mu::Parser parser = make_parser();
  std::vector<std::string> variables;
  std::vector<double> values;

  Compiled() = default;
  Compiled(const Compiled& other) : parser(other.parser), variables(other.variables), values(other.values) { bind(); }
  Compiled& operator=(const Compiled&) = delete;

  void bind() {
    values.resize(variables.size());
    parser.ClearVar();
    for (std::size_t i = 0; i < variables.size(); ++i) parser.DefineVar(variables[i], &values[i]);
  }
};

Expression::Expression(double constant) : constant_(constant), text_(number_text(constant)) {}

Expression::Expression(const std::string& text, const Constants& constants, const Place& place, bool fields) : text_(text) {
  compile(fields ? field_variables() : std::vector<std::string>{}, constants, place);
  for (const auto& [name, called] : scan(compiled_ ? text_ : "")) {
    depends_on_time_ |= name == "t";
    depends_on_current_place_ |= name == "x" || name == "y" || name == "z";
    depends_on_place_ |= name == "X" || name == "Y" || name == "Z" || depends_on_current_place_;
  }
}

Expression Expression::over(const std::vector<std::string>& variables, const std::string& text, const Constants& constants,
                            const Place& place) {
  Expression expression;
  expression.text_ = text;
  expression.compile(variables, constants, place);
  return expression;
}

void Expression::compile(const std::vector<std::string>& variables, const Constants& constants, const Place& place) {
  check_names(text_, variables, constants, place);
  check_no_assignment(text_, place);
  auto compiled = std::make_unique<Compiled>();
  compiled->variables = variables;
  try {
    for (const auto& [name, value] : constants)
      if (!contains(variables, name)) compiled->parser.DefineConst(name, value);
    compiled->bind();
    compiled->parser.SetExpr(text_);
    const double value = compiled->parser.Eval();
    const std::vector<std::string> used = names_in_expression(text_);
    if (std::any_of(used.begin(), used.end(), [&](const std::string& name) { return contains(variables, name); }))
      compiled_ = std::move(compiled);
    else
      constant_ = value;
  } catch (const mu::ParserError& error) {
    throw CaseError(place, "in the expression " + quoted(text_) + ": " + grammar_message(error));
  }
  if (!compiled_ && !std::isfinite(constant_))
    throw CaseError(place, "the expression " + quoted(text_) + " gives " + number_text(constant_) + ", not a finite number");
}

Expression::Expression(const Expression& other)
    : compiled_(other.compiled_ ? std::make_unique<Compiled>(*other.compiled_) : nullptr),
      constant_(other.constant_),
      depends_on_place_(other.depends_on_place_),
      depends_on_current_place_(other.depends_on_current_place_),
      depends_on_time_(other.depends_on_time_),
      text_(other.text_) {}
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(const Expression& other) { return *this = Expression(other); }
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

double Expression::operator()(const Point& X, const Point& x, double t) const {
  if (!compiled_) return constant_;
  const double values[7] = {X[0], X[1], X[2], x[0], x[1], x[2], t};
  return at(values);
}

double Expression::at(std::span<const double> values) const {
  if (!compiled_) return constant_;
  std::copy(values.begin(), values.end(), compiled_->values.begin());
  return compiled_->parser.Eval();
}

const std::vector<std::string>& field_variables() {
  static const std::vector<std::string> names{"X", "Y", "Z", "x", "y", "z", "t"};
  return names;
}

bool is_identifier(const std::string& name) {
  const auto word = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  return !name.empty() && starts_name(name[0]) && std::all_of(name.begin(), name.end(), word);
}

bool is_reserved_name(const std::string& name) {
  return contains(field_variables(), name) || contains(functions(), name) || fixed_constants().contains(name);
}

std::vector<std::string> names_in_expression(const std::string& text) {
  std::vector<std::string> names;
  for (const auto& [name, called] : scan(text))
    if (!called) names.push_back(name);
  return names;
}

}  // namespace sinew
