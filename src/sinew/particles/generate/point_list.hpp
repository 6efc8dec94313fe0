#pragma once

#include <sinew/core/params.hpp>
#include <sinew/particles/generate/options.hpp>
#include <sinew/particles/generate/point_set.hpp>
#include <string_view>

namespace sinew {

/// Particles from a CSV file whose first line names its columns: x, y, z (3D only) and volume, in any order.
struct PointList {
  static constexpr std::string_view name = "points";
  static constexpr std::string_view summary = "Particles listed in a CSV file";
  std::string file;

  static void describe(auto&& field, auto& m) {
    field("file", m.file, "1", "CSV file, relative to the case file, with the columns x, y, z (3D) and volume.", any_number);
  }
  PointSet generate(const GenerateOptions& options) const;
};

}  // namespace sinew
