#pragma once
/// PETSc itself: started once, errors as exceptions. Only for the sources of this folder that use it.

#include <petscsnes.h>

#include <stdexcept>
#include <string>

namespace sinew::petsc {

/// Starts PETSc (and MPI, for a process that was started alone) with the first call. Everything that it needs from outside is in PETSC_OPTIONS.
void start();
/// Ends it, if it was started.
void end();

/// Throws what PETSc has to say.
inline void check(PetscErrorCode code) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw std::runtime_error("PETSc: " + std::string(text ? text : "error " + std::to_string(static_cast<int>(code))));
}

/// An object of PETSc that is destroyed with its owner.
template <class Object, PetscErrorCode (*destroy)(Object*)>
class Owned {
 public:
  Owned() = default;
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() {
    PetscBool ended = PETSC_FALSE;
    PetscFinalized(&ended);
    if (object_ && !ended) destroy(&object_);
  }
  Object* address() { return &object_; }
  operator Object() const { return object_; }  // NOLINT(google-explicit-constructor): handed to PETSc everywhere

 private:
  Object object_ = nullptr;
};
using OwnedVec = Owned<Vec, VecDestroy>;
using OwnedMat = Owned<Mat, MatDestroy>;
using OwnedSnes = Owned<SNES, SNESDestroy>;
using OwnedNullSpace = Owned<MatNullSpace, MatNullSpaceDestroy>;

}  // namespace sinew::petsc
