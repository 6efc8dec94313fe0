#pragma once
/// What a run says: to the terminal and, with time stamps, to run.log.

#include <optional>
#include <sinew/io/run_log.hpp>
#include <string>

namespace sinew {

class Reporter {
 public:
  /// `label` goes before each line of progress, such as "run 2 of 4".
  Reporter(const std::string& log_path, bool quiet, std::string label = "");
  /// Says nothing: for all ranks but the first.
  Reporter() = default;
  ~Reporter();
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;

  void say(const std::string& text);   ///< terminal and log
  void note(const std::string& text);  ///< log, and the terminal if it shows no bar
  void warn(const std::string& text);  ///< standard error and log, also if quiet
  /// One line that the next one overwrites; nothing without a terminal.
  void show_bar(const std::string& text);
  void clear_bar();

  bool has_bar() const { return on_terminal; }
  const std::string& label() const { return label_; }

 private:
  std::optional<RunLog> log;
  bool quiet = true, on_terminal = false, bar_visible = false;
  std::string label_;
};

}  // namespace sinew
