#pragma once
/// Ctrl-C and the polite request to end.

namespace sinew {

/// From now on the first SIGINT or SIGTERM only sets a mark; a second one ends the program at once with exit code 130.
void listen_for_interruption();

/// Whether there was one.
bool interruption_requested();

}  // namespace sinew
