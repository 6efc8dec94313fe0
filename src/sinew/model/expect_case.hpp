#pragma once
/// The sections of a case that say what should come out, and over which values it is repeated.

#include <optional>
#include <sinew/core/error.hpp>
#include <sinew/core/params.hpp>
#include <sinew/model/field_options.hpp>
#include <string>
#include <utility>
#include <vector>

namespace sinew {

/// [[expect]]
struct ExpectCase {
  std::string quantity;  ///< probe.NAME.REDUCTION
  double value = 0.0;
  std::optional<double> tolerance;  ///< relative
  std::optional<double> absolute;
  std::optional<double> exact;                       ///< .rate: the value towards which the sequence converges
  std::vector<std::pair<std::string, double>> with;  ///< only the runs of the study with these values
  std::string why, source, note;
  std::string tier = "quick";
  std::string probe;      ///< of the quantity: NAME
  std::string reduction;  ///< of the quantity: final | min | max | at | period | frequency | range | drift | rate
  double time = 0.0;      ///< of at(time)
  Place place;

  static void describe(auto&& field, auto& m) {
    field("quantity", m.quantity, no_unit, "probe.NAME.final, or min, max, at(t), range, drift, period, frequency, rate.");
    field("value", m.value, any_unit, "The published value.", any_number);
    field("tolerance", m.tolerance, no_unit, "Allowed relative difference; this or `absolute`.", positive, optional);
    field("absolute", m.absolute, any_unit, "Allowed absolute difference; this or `tolerance`.", positive, optional);
    field("exact", m.exact, any_unit, "For rate: the value towards which the sequence converges.", optional);
    field("with", m.with, no_unit, "Only the runs of the study with these values.", optional);
    field("why", m.why, no_unit, "Why this tolerance.", optional);
    field("source", m.source, no_unit, "Figure, table or equation.", optional);
    field("note", m.note, no_unit, "Anything else worth knowing.", optional);
    field("tier", m.tier, no_unit, "When it is checked: always, or in the full tier only.", optional, OneOf{{"quick", "full"}});
  }
};

/// [study]
struct StudyCase {
  std::vector<std::pair<std::string, std::vector<double>>> vary;  ///< key path -> values; all combinations are run

  static void describe(auto&& field, auto& m) {
    field("vary", m.vary, any_unit, "Key paths and their values; all combinations are run.");
  }
};

}  // namespace sinew
