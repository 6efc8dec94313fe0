#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sinew/cli/number_format.hpp>
#include <sinew/cli/verify_cases.hpp>

namespace sinew {

namespace {

constexpr std::size_t columns = 7;
using Cells = std::array<std::string, columns>;

std::size_t shown_width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::vector<Cells> cells_of(const VerifyCase& c, const VerifyResult& result) {
  std::vector<Cells> lines;
  for (const ExpectSummary& row : result.rows)
    lines.push_back({c.name, row.quantity, fmt::format("{:.6g}", row.published), fmt::format("{:.6g}", row.value),
                     difference_text(row), allowed_text(row), row.pass ? "ok" : "MISSED"});
  return lines;
}

std::string line_text(const Cells& cells, const std::array<std::size_t, columns>& widths) {
  std::string line;
  for (std::size_t k = 0; k < columns; ++k) {
    line += (k ? " | " : "") + cells[k];
    if (k + 1 < columns) line += std::string(widths[k] - shown_width(cells[k]), ' ');
  }
  return line + '\n';
}

nlohmann::ordered_json json_of(const VerifyCase& c, const ExpectSummary& row) {
  nlohmann::ordered_json json{{"case", c.name}, {"file", c.path}, {"quantity", row.quantity}, {"published", row.published}};
  json["computed"] = std::isfinite(row.value) ? nlohmann::ordered_json(row.value) : nlohmann::ordered_json(nullptr);
  if (row.tolerance) json["tolerance"] = *row.tolerance;
  if (row.absolute) json["absolute"] = *row.absolute;
  json["pass"] = row.pass;
  json["why"] = row.why;
  json["source"] = row.source;
  json["note"] = row.note;
  return json;
}

}  // namespace

std::string verify_table(const std::vector<VerifyCase>& cases, const std::vector<VerifyResult>& results) {
  const Cells titles{"case", "quantity", "published", "computed", "difference", "tolerance", "ok"};
  std::array<std::size_t, columns> widths{};
  for (std::size_t k = 0; k < columns; ++k) widths[k] = titles[k].size();
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (const Cells& cells : cells_of(cases[i], results[i]))
      for (std::size_t k = 0; k < columns; ++k) widths[k] = std::max(widths[k], shown_width(cells[k]));
  std::string text = line_text(titles, widths);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].skipped) continue;
    text += fmt::format("{} ({}, {})\n", cases[i].name, cases[i].path, duration_text(results[i].seconds));
    for (const Cells& cells : cells_of(cases[i], results[i])) text += line_text(cells, widths);
    if (!results[i].problem.empty()) text += "FAILED: " + results[i].problem + "\n";
  }
  return text;
}

std::string verify_json(const std::vector<VerifyCase>& cases, const std::vector<VerifyResult>& results) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const ExpectSummary& row : results[i].rows) rows.push_back(json_of(cases[i], row));
    if (!results[i].problem.empty())
      rows.push_back({{"case", cases[i].name}, {"file", cases[i].path}, {"problem", results[i].problem}, {"pass", false}});
  }
  const VerifyCounts counts = count_rows(cases, results);
  const nlohmann::ordered_json json{
      {"passed", counts.passed}, {"failed", counts.failed}, {"skipped", counts.skipped}, {"rows", rows}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace sinew
