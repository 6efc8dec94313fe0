#pragma once
/// What every geometry is told besides its own parameters, and the checks that they share.

#include <sinew/core/error.hpp>
#include <sinew/core/vec.hpp>
#include <string>
#include <vector>

namespace sinew {

struct GenerateOptions {
  int dimension = 3;         ///< 2 or 3
  std::string folder;        ///< file names of the case are relative to it; empty: to the working directory
  Place place = {};          ///< where the geometry was written; begins the error messages
  double most_points = 1e9;  ///< more than these do not fit into the memory of the machine

  /// `name`, made relative to `folder` unless it is absolute.
  std::string path_of(const std::string& name) const;
  /// The coordinates as a point (z = 0 in two dimensions). CaseError unless there are as many as dimensions, all finite.
  Point point(const std::vector<double>& coordinates, const std::string& key) const;
  /// CaseError unless the case has `wanted` dimensions; `advice` says what to use instead.
  void need_dimension(int wanted, const std::string& shape, const std::string& advice) const;
  /// CaseError at `place`.
  [[noreturn]] void fail(const std::string& message) const;
};

}  // namespace sinew
