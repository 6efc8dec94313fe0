#pragma once
/// The folder of one run and the names of the files in it.

#include <string>

namespace sinew {

class RunFolder {
 public:
  /// Makes the folder (and those above it). One that is not empty is refused, unless `force` is set and it holds a run: then the
  /// files of that run are removed, and only those; anything else in it stays. Throws CaseError, saying what to do.
  static RunFolder create(const std::string& path, bool force);
  /// One that another rank has made or opened.
  static RunFolder at(const std::string& path) { return RunFolder(path); }
  /// The folder of an earlier run. Throws CaseError if there is none.
  static RunFolder open(const std::string& path);

  const std::string& path() const { return folder; }
  std::string resolved_case() const { return file("case.resolved.toml"); }
  std::string log() const { return file("run.log"); }
  std::string summary() const { return file("summary.json"); }
  std::string history() const { return file("history.csv"); }
  std::string series() const { return file("particles.pvd"); }
  std::string checkpoint() const { return file("checkpoint.h5"); }
  /// Any other file, such as a picture.
  std::string file(const std::string& name) const { return folder + "/" + name; }
  /// "particles/frame_000012.vtu", as seen from the folder.
  static std::string frame_name(long index);
  std::string frame(long index) const { return file(frame_name(index)); }

 private:
  explicit RunFolder(std::string path_) : folder(std::move(path_)) {}
  std::string folder;
};

}  // namespace sinew
