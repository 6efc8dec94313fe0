#pragma once
/// Ctrl-C and the polite request to end.

namespace sinew {

/// From now on the first SIGINT, SIGTERM or SIGUSR1 (which launchers of MPI pass on, and batch systems send before the time is up) only sets a mark; a second
/// one ends the program at once with exit code 130.
void listen_for_interruption();

/// Whether there was one.
bool interruption_requested();

}  // namespace sinew
