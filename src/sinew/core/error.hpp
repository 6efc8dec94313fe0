#pragma once
/// Errors that a user can act on. `CaseError`: the input is wrong (exit code 2). `SimulationError`: the run failed (exit
/// code 3). Anything else that is thrown is our own bug (exit code 4).

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// Where in which file something was written. line 0: not in a file (an override, a default).
struct Place {
  std::string file;
  int line = 0, column = 0;
  /// "case.toml:10:1", or the bare name where there is no line.
  std::string text() const;
};

class CaseError : public std::runtime_error {
 public:
  CaseError(const Place& place, const std::string& message);
  explicit CaseError(const std::string& message);
};

class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Equations have no solution that could be found; the state is the last one that solves them.
class NoBalance : public SimulationError {
 public:
  using SimulationError::SimulationError;
};

/// The known name nearest to `wrong` (edit distance with transpositions, at most a third of its length),
/// otherwise the first that contains it or is contained in it; empty if none is near.
std::string nearest_name(std::string_view wrong, std::span<const std::string> known);

/// "unknown WHAT "WRONG". Did you mean "NEAR"? Known WHATs: a, b, c."
std::string unknown_name_message(std::string_view what, std::string_view wrong, std::span<const std::string> known);

}  // namespace sinew
