#pragma once
/// From the arguments of the program to its exit code.

namespace sinew {

/// Runs the verb that is asked for. Errors go to standard error; see ExitCode.
int command_line(int count, const char* const* arguments);

}  // namespace sinew
