#pragma once
/// The state of a run in one HDF5 file, exact to the last bit, to go on from later.

#include <map>
#include <string>
#include <vector>

namespace sinew {

struct Checkpoint {
  double time = 0.0;
  long step = 0;
  std::string case_text;                              ///< the resolved case, as written to case.resolved.toml
  std::map<std::string, double> numbers;              ///< e.g. the last time step
  std::map<std::string, std::vector<double>> arrays;  ///< one a particle field; any length, also none
  std::map<std::string, std::string> texts;
};

/// Writes beside `path`, puts it safely on disk, then takes its place: a crash never destroys the last checkpoint.
/// Throws SimulationError with path and reason.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// Throws CaseError if the file is missing, damaged (a checksum tells), or of another format version.
Checkpoint read_checkpoint(const std::string& path);

}  // namespace sinew
