#pragma once
/// Files that are either complete or not there: they grow under "NAME.part" and take their name when they are whole.

#include <cstddef>
#include <string>
#include <string_view>

namespace sinew {

/// "cannot write PATH: TEXT OF ERRNO".
std::string write_error_text(const std::string& path, int error_number);

/// A file under construction. All errors are SimulationError with the path and the system's reason (disk full, no permission).
class PartFile {
 public:
  enum class Writers { one, several };
  /// `several`: other ranks write other places of it at the same time; what is there stays.
  explicit PartFile(const std::string& path, Writers writers = Writers::one);
  ~PartFile();  ///< without commit or leave: removes what was begun, the old file stays
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  void seek(std::size_t place) { place_ = place; }  ///< where the next write goes [bytes from the beginning]
  void write(std::string_view text);
  void reserve(std::size_t bytes);  ///< fails if there is no room for so many, where the file system can tell
  void cut(std::size_t bytes);      ///< leaves so many
  void synchronize();               ///< waits until what was written is on the disk itself, safe from a power cut
  void commit();                    ///< the file appears, in place of an older one
  void leave();                     ///< closes it, for somebody else to let it appear
  static void appear(const std::string& path);
  static std::string part_name(const std::string& path) { return path + ".part"; }

 private:
  [[noreturn]] void fail() const;

  std::string path_;
  int file_ = -1;
  std::size_t place_ = 0;
};

/// The whole content in one go, as PartFile does it.
void write_atomically(const std::string& path, std::string_view content);

/// The whole content of a file. Throws CaseError "cannot read PATH: reason".
std::string read_text(const std::string& path);

}  // namespace sinew
