#pragma once
/// A number, or a formula in X Y Z x y z t, compiled once.

#include <map>
#include <memory>
#include <sinew/core/error.hpp>
#include <sinew/core/vec.hpp>
#include <span>
#include <string>
#include <vector>

namespace sinew {

using Constants = std::map<std::string, double>;

class Expression {
 public:
  Expression() : Expression(0.0) {}
  explicit Expression(double constant);
  /// Compiles `text` with the given named constants (the parameters; pi and e are always known). `fields`: whether X Y Z x y z t
  /// may be used. Throws CaseError with the place, the text and what is wrong (unknown name: with the nearest known one).
  Expression(const std::string& text, const Constants& constants, const Place& place, bool fields);
  /// The same over variables of any names, for `at`; a history formula over probes, for example.
  static Expression over(const std::vector<std::string>& variables, const std::string& text, const Constants& constants,
                         const Place& place);
  Expression(const Expression&);
  Expression(Expression&&) noexcept;
  Expression& operator=(const Expression&);
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  /// Value at reference place X, current place x and time t. Not thread safe for one and the same object.
  double operator()(const Point& X, const Point& x, double t) const;
  double operator()(double t) const { return (*this)({}, {}, t); }
  /// Value for the variables given to `over`, in that order.
  double at(std::span<const double> values) const;

  bool depends_on_place() const { return depends_on_place_; }  ///< on any of X Y Z x y z
  bool depends_on_current_place() const { return depends_on_current_place_; }
  bool depends_on_time() const { return depends_on_time_; }
  bool is_constant() const { return compiled_ == nullptr; }
  const std::string& text() const { return text_; }

 private:
  struct Compiled;  // hides muParser
  void compile(const std::vector<std::string>& variables, const Constants& constants, const Place& place);

  std::unique_ptr<Compiled> compiled_;
  double constant_ = 0.0;
  bool depends_on_place_ = false, depends_on_current_place_ = false, depends_on_time_ = false;
  std::string text_;
};

/// X Y Z x y z t.
const std::vector<std::string>& field_variables();
/// Letters, digits and _, not beginning with a digit.
bool is_identifier(const std::string& name);
/// Names that mean something in every expression (functions, pi, e, X ... t) and so cannot be used for parameters.
bool is_reserved_name(const std::string& name);
/// The names (not followed by a bracket) that `text` uses, in the order of the text.
std::vector<std::string> names_in_expression(const std::string& text);

}  // namespace sinew
