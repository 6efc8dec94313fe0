#include <cerrno>
#include <charconv>
#include <fmt/format.h>
#include <sinew/core/error.hpp>
#include <sinew/io/file.hpp>
#include <sinew/io/history.hpp>
#include <stdexcept>

namespace sinew {

namespace {

constexpr std::chrono::seconds flush_interval{1};

std::string title(const HistoryColumn& column) {
  std::string text = column.name;
  if (!column.unit.empty() && column.unit != "1") text += " [" + column.unit + "]";
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string header_line(const std::vector<HistoryColumn>& columns) {
  std::string line;
  for (const HistoryColumn& column : columns) line += (line.empty() ? "" : ",") + title(column);
  return line + '\n';
}

/// The whole lines of `rows` whose first number is at most `time`.
std::string rows_until(std::string_view rows, double time) {
  std::string kept;
  for (std::size_t end = rows.find('\n'); end != rows.npos; end = rows.find('\n')) {
    const std::string_view row = rows.substr(0, end + 1);
    double row_time = 0.0;
    if (std::from_chars(row.data(), row.data() + row.size(), row_time).ec == std::errc{} && row_time <= time) kept += row;
    rows.remove_prefix(end + 1);
  }
  return kept;
}

}  // namespace

HistoryFile::HistoryFile(const std::string& path_, std::size_t columns)
    : path(path_),
      column_count(columns),
      file(std::fopen(path_.c_str(), "ab")) {
  if (!file) throw SimulationError(write_error_text(path, errno));
}

HistoryFile::HistoryFile(const std::string& path_, const std::vector<HistoryColumn>& columns)
    : HistoryFile((write_atomically(path_, header_line(columns)), path_), columns.size()) {}

HistoryFile HistoryFile::resume(const std::string& path, const std::vector<HistoryColumn>& columns, double time) {
  const std::string text = read_text(path), header = header_line(columns);
  if (!text.starts_with(header))
    throw CaseError(path + " has other columns than this run: it begins \"" + text.substr(0, text.find('\n')) + "\", not \"" +
                    header.substr(0, header.size() - 1) + "\". Resume with the same probes, or run again in a new folder.");
  write_atomically(path, header + rows_until(std::string_view(text).substr(header.size()), time));
  return HistoryFile(path, columns.size());
}

void HistoryFile::add_row(std::span<const double> values) {
  if (values.size() != column_count) throw std::invalid_argument("history: a row needs as many values as there are columns");
  const std::string row = fmt::format("{}\n", fmt::join(values, ","));
  if (std::fwrite(row.data(), 1, row.size(), file.get()) != row.size()) throw SimulationError(write_error_text(path, errno));
  if (Clock::now() - last_flush >= flush_interval) flush();
}

void HistoryFile::flush() {
  if (std::fflush(file.get()) != 0) throw SimulationError(write_error_text(path, errno));
  last_flush = Clock::now();
}

}  // namespace sinew
