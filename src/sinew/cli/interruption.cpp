#include <sinew/cli/interruption.hpp>

#include <csignal>
#include <cstdlib>
#include <sinew/cli/options.hpp>

namespace sinew {

namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void on_signal(int) {
  if (requested) std::_Exit(interrupted);
  requested = 1;
}

}  // namespace

void listen_for_interruption() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGUSR1, on_signal);
}

bool interruption_requested() { return requested != 0; }

}  // namespace sinew
