#pragma once
/// Time series as a table: history.csv.

#include <chrono>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace sinew {

struct HistoryColumn {
  std::string name, unit;  ///< written "name [unit]"; the bare name for pure numbers (unit "" or "1")
};

/// One row per sample, the first column is the time. Numbers have as few digits as give the same double back. What was added
/// is on disk at most a second (of further rows) later, and at the end. Throws SimulationError with path and reason.
class HistoryFile {
 public:
  HistoryFile(const std::string& path, const std::vector<HistoryColumn>& columns);
  /// Goes on after the rows with a time of at most `time`; a last row that was cut off is dropped. Throws CaseError if the file
  /// is not there or has other columns.
  static HistoryFile resume(const std::string& path, const std::vector<HistoryColumn>& columns, double time);

  void add_row(std::span<const double> values);
  void flush();

 private:
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  using Clock = std::chrono::steady_clock;

  HistoryFile(const std::string& path, std::size_t columns);

  std::string path;
  std::size_t column_count;
  std::unique_ptr<std::FILE, Close> file;
  Clock::time_point last_flush = Clock::now();
};

}  // namespace sinew
