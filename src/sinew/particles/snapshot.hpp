#pragma once
/// The state of all particles at one time, in the user's order, as files and pictures want it.

#include <cstddef>
#include <optional>
#include <sinew/core/vec.hpp>
#include <string>
#include <vector>

namespace sinew {

/// One field over all particles. `components` is 1 (scalar), 3 (vector), 6 (symmetric tensor: XX YY ZZ XY YZ XZ) or 9 (tensor, row-major).
struct FieldData {
  std::string name;
  std::string unit;  ///< in the case's own system, e.g. "Pa" or "GPa"; "1" for pure numbers
  int components = 1;
  std::vector<double> values;  ///< particle after particle: values[p * components + c]
};

/// A piece of the user's order of particles.
struct UserRange {
  std::size_t first = 0;  ///< number of its first particle
  std::size_t count = 0;  ///< particles in it
  std::size_t total = 0;  ///< particles of the case
  bool leads = true;      ///< of the rank that writes what belongs to no particle

  /// A snapshot of a range holds one particle more, unless it ends with the last one: files pack bytes by three.
  std::size_t rows() const { return count + (first + count < total ? 1 : 0); }
};

struct Snapshot {
  double time = 0.0;
  long step = 0;
  int dimension = 3;
  std::optional<UserRange> range;  ///< which particles it holds; none: all of them
  std::vector<Point> position;     ///< current coordinates
  std::vector<double> size;        ///< edge length of the volume that each particle stands for, for drawing
  std::vector<int> body;           ///< index into body_names
  std::vector<std::string> body_names;
  std::vector<FieldData> fields;
  std::string length_unit = "m", time_unit = "s";
};

}  // namespace sinew
