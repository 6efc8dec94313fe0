#pragma once

#include <sinew/particles/generate/options.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// A text file read line by line; every error names its line and column.
class TextFile {
 public:
  /// Reads the whole file. CaseError at `options.place` if it cannot be read.
  TextFile(const std::string& name, const GenerateOptions& options);
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;

  bool next();                                       ///< goes to the next line; false at the end
  std::string_view line() const { return current; }  ///< without its end and the blanks around it
  int line_number() const { return number_of_line; }
  const std::string& path() const { return path_name; }

  /// The current line cut at blanks, or at `separator` with the blanks around each part removed. Valid until the next cut.
  const std::vector<std::string_view>& words();
  const std::vector<std::string_view>& fields(char separator);

  /// `part` of the current line as a finite number ("1.5", "+2e-3", "1.0D+02") or an integer. CaseError naming `what` it should
  /// be.
  double number(std::string_view part, const char* what) const;
  long long integer(std::string_view part, const char* what) const;

  /// CaseError at `part` of the current line, or at its beginning.
  [[noreturn]] void fail(std::string_view part, const std::string& message) const;
  [[noreturn]] void fail(const std::string& message) const { fail(current, message); }

 private:
  std::string path_name, text;
  std::size_t next_begin = 0;
  std::string_view current;
  std::string_view whole_line;
  int number_of_line = 0;
  std::vector<std::string_view> parts;
};

/// `text` without the blanks at its ends.
std::string_view trimmed(std::string_view text);
std::string lower_case(std::string_view text);

}  // namespace sinew
