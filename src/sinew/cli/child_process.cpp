#include <sinew/cli/child_process.hpp>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sinew/cli/interruption.hpp>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace sinew {

int start_child(const std::vector<std::string>& arguments, const std::string& output_file) {
  std::vector<char*> pointers{const_cast<char*>("sinew")};
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  const pid_t process = fork();
  if (process < 0) throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
  if (process > 0) return process;
  if (std::freopen(output_file.c_str(), "w", stdout)) dup2(STDOUT_FILENO, STDERR_FILENO);
  execv("/proc/self/exe", pointers.data());
  std::_Exit(127);
}

ChildEnd wait_for_child() {
  int status = 0;
  const pid_t process = waitpid(-1, &status, 0);
  if (process < 0 && errno != EINTR) throw std::runtime_error(std::string("cannot wait for a process: ") + std::strerror(errno));
  if (process < 0) return {-1, 0};
  return {process, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
}

void stop_child(int process) { kill(process, SIGTERM); }

}  // namespace sinew
