#pragma once
/// The sections of a case that say what should come out, and over which values it is repeated.

#include <optional>
#include <sinew/core/error.hpp>
#include <sinew/core/params.hpp>
#include <sinew/model/field_options.hpp>
#include <sinew/model/field_reader.hpp>
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
/// [study] safety: which of the runs of a strength reduction fail
struct SafetyCase {
  std::string probe;
  double last = 0.25, share = 0.125;

  static void describe(auto&& field, auto& m) {
    constexpr Range part{0.0, 1.0, true, true, "between 0 and 1"};
    field("probe", m.probe, no_unit, "Name of the probe that follows the largest displacement.");
    field("last", m.last, no_unit, "Which last part of the run, or of its last stage, is looked at.", part, optional);
    field("share", m.share, no_unit,
          "A run whose probe grows in that part by more than this share of all of its growth in the run or stage fails; 0.125 is "
          "half of what steady motion has.",
          part, optional);
  }
};
template <>
struct TypeName<SafetyCase> {
  static constexpr const char* text = "table { probe, last, share }";
};
inline Node read_value(SafetyCase& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  if (!node.is(Node::Kind::table)) spec.wrong_kind(node, "a table such as { probe = \"largest\" }");
  return read_described(value, node, spec.label(), reading);
}

struct StudyCase {
  std::vector<std::pair<std::string, std::vector<double>>> vary;  ///< key path -> values; all combinations are run
  std::optional<SafetyCase> safety;

  static void describe(auto&& field, auto& m) {
    field("vary", m.vary, any_unit, "Key paths and their values; all combinations are run.");
    field("safety", m.safety, no_unit,
          "The one key that is varied reduces the strength; the study finds the factor of safety, the least value with which the "
          "run fails.",
          optional);
  }
};

}  // namespace sinew
