#include <sinew/cli/reporter.hpp>

#include <cstdio>
#include <sinew/parallel/comm.hpp>
#include <unistd.h>

namespace sinew {

namespace {

void print_line(std::FILE* stream, const std::string& text) {
  std::fputs((text + '\n').c_str(), stream);
  std::fflush(stream);
}

}  // namespace

Reporter::Reporter(const std::string& log_path, bool quiet_, std::string label)
    : log(std::in_place, log_path),
      quiet(quiet_),
      on_terminal(!quiet_ && isatty(STDOUT_FILENO) == 1 && !Comm::launched()),  // mpiexec puts a terminal of its own between
      label_(std::move(label)) {}

Reporter::~Reporter() { clear_bar(); }

void Reporter::say(const std::string& text) {
  clear_bar();
  if (log) log->write(text);
  if (!quiet) print_line(stdout, text);
}

void Reporter::note(const std::string& text) {
  if (log) log->write(text);
  if (!quiet && !on_terminal) print_line(stdout, text);
}

void Reporter::warn(const std::string& text) {
  clear_bar();
  if (!log) return;
  log->write(text);
  print_line(stderr, text);
}

void Reporter::show_bar(const std::string& text) {
  if (!on_terminal) return;
  std::fputs(("\r" + text + "\033[K").c_str(), stdout);
  std::fflush(stdout);
  bar_visible = true;
}

void Reporter::clear_bar() {
  if (!bar_visible) return;
  std::fputs("\r\033[K", stdout);
  std::fflush(stdout);
  bar_visible = false;
}

}  // namespace sinew
