#pragma once
/// The state of a run in one HDF5 file, exact to the last bit, to go on from later, with any number of ranks.

#include <map>
#include <sinew/parallel/comm.hpp>
#include <sinew/particles/snapshot.hpp>
#include <string>
#include <vector>

namespace sinew {

struct Checkpoint {
  double time = 0.0;
  long step = 0;
  std::string case_text;                              ///< the resolved case, as written to case.resolved.toml
  std::map<std::string, double> numbers;              ///< e.g. the last time step
  std::map<std::string, std::vector<double>> arrays;  ///< any length, also none; the same on all ranks
  std::map<std::string, std::string> texts;

  struct Field {
    int width = 1;
    std::vector<double> rows;  ///< range.count times `width`
  };
  UserRange range;                      ///< of the user's order of particles, that this rank has
  std::map<std::string, Field> fields;  ///< one a particle field
};

/// Writes beside `path`, puts it safely on disk, then takes its place: a crash never destroys the last checkpoint. Each rank writes the rows of its
/// particles. Throws SimulationError with path and reason. Collective.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint, const Comm& comm = Comm());

/// Each rank reads the rows of its range, whatever the ranges of those who wrote. Throws CaseError if the file is missing, damaged (checksums
/// tell), or of another format version. Collective.
Checkpoint read_checkpoint(const std::string& path, const Comm& comm = Comm());

}  // namespace sinew
