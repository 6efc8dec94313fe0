#pragma once
/// run.log: what the terminal showed, with time stamps.

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace sinew {

class RunLog {
 public:
  enum class Terminal { silent, echo };
  /// Appends to the file at `path`. Throws SimulationError with path and reason if it cannot be opened.
  explicit RunLog(const std::string& path, Terminal terminal = Terminal::silent);

  /// "2031-05-01T12:00:00+0200 TEXT" to the file at once, each line of the text with its stamp; the bare text to standard output
  /// if it echoes. Never throws: a disk that fills up is told by the files that matter.
  void write(std::string_view text);

 private:
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  std::unique_ptr<std::FILE, Close> file;
  Terminal terminal;
};

}  // namespace sinew
