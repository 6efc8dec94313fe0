#include <sinew/cli/launch.hpp>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sinew/cli/options.hpp>
#include <sinew/core/error.hpp>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace sinew {

namespace {

volatile pid_t launcher = 0;
volatile std::sig_atomic_t interruptions = 0;

/// The first request goes to the ranks, the second one ends them.
extern "C" void pass_on(int) {
  const int before = interruptions;
  interruptions = before + 1;
  if (launcher > 0) kill(launcher, before == 0 ? SIGUSR1 : SIGTERM);
}

std::vector<std::string> command(int ranks, const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"mpiexec", "--quiet", "-n", std::to_string(ranks), "--bind-to", "none", "--oversubscribe"};
  all.push_back(std::filesystem::read_symlink("/proc/self/exe").string());
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}

[[noreturn]] void become(const std::vector<std::string>& words) {
  setpgid(0, 0);  // so that Ctrl-C on the terminal comes to us alone, who pass it on
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (!std::freopen("/dev/null", "r", stdin)) std::_Exit(127);
  if (geteuid() == 0) {  // a container: Open MPI asks to be told twice
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 0);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 0);
  }
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  execvp("mpiexec", pointers.data());
  std::_Exit(127);
}

}  // namespace

std::vector<std::string> without_ranks(const std::vector<std::string>& arguments) {
  std::vector<std::string> kept;
  for (auto next = arguments.begin(); next != arguments.end(); ++next) {
    if (*next == "-n" || *next == "--ranks") {
      if (++next == arguments.end()) break;
    } else if (!next->starts_with("--ranks=") && !(next->starts_with("-n") && next->size() > 2)) {
      kept.push_back(*next);
    }
  }
  return kept;
}

int launch_ranks(int ranks, const std::vector<std::string>& arguments) {
  const std::vector<std::string> words = command(ranks, arguments);
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal, pass_on);
  launcher = fork();
  if (launcher < 0) throw std::runtime_error("cannot start a process");
  if (launcher == 0) become(words);
  int status = 0;
  while (waitpid(launcher, &status, 0) < 0 && errno == EINTR) {
  }
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (code == 127)
    throw CaseError(
        "-n " + std::to_string(ranks) +
        ": mpiexec could not start the program. Install Open MPI (openmpi-bin), or leave out -n and use threads (-t).");
  if (const int signal = code - 128; signal > 0 && code != interrupted && interruptions < 2)
    std::fprintf(
        stderr,
        "one of the %d ranks was ended by signal %d (%s), and the run with it. sinew resume goes on from its last checkpoint, if "
        "there is one ([output] checkpoint_every).\n",
        ranks, signal, strsignal(signal));
  return code;
}

}  // namespace sinew
