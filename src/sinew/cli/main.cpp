#include <sinew/cli/command_line.hpp>
#include <sinew/cli/threads.hpp>

int main(int count, char** arguments) {
  sinew::let_idle_threads_sleep(arguments);
  return sinew::command_line(count, arguments);
}
