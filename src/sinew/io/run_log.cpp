#include <cerrno>
#include <ctime>
#include <sinew/core/error.hpp>
#include <sinew/io/file.hpp>
#include <sinew/io/run_log.hpp>

namespace sinew {

namespace {

std::string time_stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S%z", &local)};
}

}  // namespace

RunLog::RunLog(const std::string& path, Terminal terminal_) : file(std::fopen(path.c_str(), "ab")), terminal(terminal_) {
  if (!file) throw SimulationError(write_error_text(path, errno));
}

void RunLog::write(std::string_view text) {
  if (text.ends_with('\n')) text.remove_suffix(1);
  const std::string stamp = time_stamp();
  std::string stamped, bare(text);
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    stamped += stamp + " " + std::string(text.substr(begin, end - begin)) + '\n';
    begin = end + 1;
  }
  std::fputs(stamped.c_str(), file.get());
  std::fflush(file.get());
  if (terminal == Terminal::echo) {
    std::puts(bare.c_str());
    std::fflush(stdout);
  }
}

}  // namespace sinew
