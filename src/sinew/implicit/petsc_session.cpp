#include <sinew/implicit/petsc_session.hpp>

namespace sinew::petsc {

void start() {
  PetscBool started = PETSC_FALSE;
  PetscInitialized(&started);
  if (started) return;
  PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");  // Ctrl-C means a checkpoint
  check(PetscInitializeNoArguments());
  check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));  // errors are ours to tell
}

void end() {
  PetscBool started = PETSC_FALSE, ended = PETSC_FALSE;
  PetscInitialized(&started);
  PetscFinalized(&ended);
  if (started && !ended) PetscFinalize();
}

}  // namespace sinew::petsc
