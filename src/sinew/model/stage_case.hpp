#pragma once
/// [[stage]]: phases of a run, each a case of its own that differs from the file in some sections.

#include <optional>
#include <sinew/core/node.hpp>
#include <sinew/core/params.hpp>
#include <sinew/model/field_options.hpp>
#include <string>
#include <vector>

namespace sinew {

struct StageCase {
  std::string name;
  double duration = 0.0;
  std::optional<double> residual;
  bool settle = false;
  double end = 0.0;  ///< at the latest [time]
  Node root;         ///< the case file while the stage lasts
  Place place;

  static void describe(auto&& field, auto& m) {
    constexpr Range part{0.0, 1.0, true, false, "greater than 0 and at most 1"};
    field("name", m.name, no_unit, "Name of the stage, for messages.");
    field("duration", m.duration, "s", "How long it lasts, at most.", positive);
    field("residual", m.residual, no_unit,
          "The stage ends earlier, once the forces that are not in balance, sum of mass times acceleration, are less than this "
          "part of "
          "the weight.",
          part, optional);
    field("settle", m.settle, no_unit,
          "At the end all particles go back to where they were in the beginning, at rest and without strain; stresses stay. For "
          "materials that are written in rates.",
          optional);
  }

  /// Sections of the case file that a stage may have for itself.
  static const std::vector<std::string>& own_sections();
};

}  // namespace sinew
