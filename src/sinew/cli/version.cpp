#include <sinew/cli/version.hpp>

#include <fmt/format.h>
#include <sinew/cli/build_info.hpp>
#include <sinew/core/pack.hpp>
#include <sinew/implicit/newton.hpp>
#include <sinew/parallel/comm.hpp>

namespace sinew {

std::string program_version() { return build_info::version; }

std::string program_commit() { return build_info::commit; }

std::string vector_registers() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__AVX__)
  return "AVX";
#elif defined(__ARM_NEON)
  return "NEON";
#else
  return "128 bit";
#endif
}

std::string version_text() {
  return fmt::format(
      "sinew {}\n"
      "commit     {}\n"
      "compiler   {}, {}\n"
      "OpenMP     {}\n"
      "MPI        {}\n"
      "PETSc      {}\n"
      "HDF5       {}\n"
      "vector ISA {}, {} particles at a time",
      build_info::version, build_info::commit, build_info::compiler, build_info::build_type, _OPENMP, Comm::library(),
      Newton::version(), build_info::hdf5, vector_registers(), lanes);
}

}  // namespace sinew
