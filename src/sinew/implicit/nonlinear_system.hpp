#pragma once
/// What a solver knows about equations R(u) = 0: values and derivatives. Spread over ranks; `nodes` of this rank have D unknowns each. Every call but the sizes is collective.

#include <sinew/core/function_ref.hpp>
#include <sinew/parallel/comm.hpp>
#include <span>
#include <vector>

namespace sinew {

class NonlinearSystem {
 public:
  NonlinearSystem() = default;
  NonlinearSystem(const NonlinearSystem&) = delete;
  NonlinearSystem& operator=(const NonlinearSystem&) = delete;
  virtual ~NonlinearSystem() = default;

  virtual int dimension() const = 0;                    ///< unknowns of a node
  virtual int nodes() const = 0;                        ///< of this rank
  virtual std::vector<double> coordinates() const = 0;  ///< of its nodes, `dimension` numbers each [length]

  /// R at u. false: u is not a state (material turned inside out).
  virtual bool residual(std::span<const double> u, std::span<double> r) = 0;
  /// What |R| is to be compared with, as of the last residual.
  virtual double scale() const = 0;
  /// out = dR/du v, at the u of the last residual.
  virtual void product(std::span<const double> v, std::span<double> out) = 0;

  /// The same derivative as matrices of groups of nodes, numbered through all ranks, which add up to it; row-major.
  using Use = FunctionRef<void(std::span<const int> nodes, std::span<const double> matrix)>;
  /// `exact` false: one that is like it and has few entries a row.
  virtual void for_each_matrix(bool exact, Use use) = 0;
  /// The groups alone.
  virtual void for_each_group(bool exact, FunctionRef<void(std::span<const int> nodes)> use) const = 0;
  /// Unknowns of this rank whose values are given, by their numbers among its own. Their rows and columns have nothing but this on the diagonal.
  virtual const std::vector<int>& given() const = 0;
  virtual double given_diagonal() const = 0;
};

}  // namespace sinew
