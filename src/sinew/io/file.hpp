#pragma once
/// Files that are either complete or not there: they grow under "NAME.part" and take their name when they are whole.

#include <cstdio>
#include <string>
#include <string_view>

namespace sinew {

/// "cannot write PATH: TEXT OF ERRNO".
std::string write_error_text(const std::string& path, int error_number);

/// A file under construction. All errors are SimulationError with the path and the system's reason (disk full, no permission).
class PartFile {
 public:
  explicit PartFile(const std::string& path);
  ~PartFile();  ///< without commit: removes what was begun, the old file stays
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  void write(std::string_view text);
  void synchronize();  ///< waits until what was written is on the disk itself, safe from a power cut
  void commit();       ///< the file appears, in place of an older one

 private:
  std::string path;
  std::FILE* file = nullptr;
};

/// The whole content in one go, as PartFile does it.
void write_atomically(const std::string& path, std::string_view content);

/// The whole content of a file. Throws CaseError "cannot read PATH: reason".
std::string read_text(const std::string& path);

}  // namespace sinew
