#pragma once
/// This program once more, for one case.

#include <string>
#include <vector>

namespace sinew {

/// Starts this program with the arguments; what it prints goes to the file. Returns its process id. Throws std::runtime_error.
int start_child(const std::vector<std::string>& arguments, const std::string& output_file);

struct ChildEnd {
  int process;
  int exit_code;  ///< 128 + signal if a signal ended it
};
/// Waits until one of the children has ended.
ChildEnd wait_for_child();

/// Sends the signal of a polite end to a child.
void stop_child(int process);

}  // namespace sinew
