#pragma once
/// Particle files for ParaView 5.11 and newer, VTK's and meshio's Python readers: one .vtu a frame and a .pvd that lists
/// them with their times.

#include <sinew/particles/snapshot.hpp>
#include <string>
#include <vector>

namespace sinew {

/// The numbers in the file that are double in the program. float32 rounds to 7 digits and halves the file.
enum class VtkReal { float64, float32 };

/// Writes one frame as a VTK unstructured grid: one vertex a particle at its current coordinates; every field as point data
/// (symmetric tensors XX YY ZZ XY YZ XZ, tensors row-major), `body` and `particle_id` (Int32; the place in the snapshot) and
/// `TimeValue` as field data. Binary inline, not compressed: that took as long as twenty to thirty steps and saved a fifth.
/// Of a snapshot of a range it writes the part of these particles, and leaves it to PartFile::appear, once all parts are written, to let the file appear.
/// Throws SimulationError with path and reason.
void write_vtu(const std::string& path, const Snapshot& snapshot, VtkReal real = VtkReal::float64);

/// The time series beside the frames. The file on disk is complete after every call.
class PvdSeries {
 public:
  /// A new series; nothing is on disk before the first frame.
  explicit PvdSeries(const std::string& path);
  /// Goes on with the series at `path` after its frames with a time of at most `keep_until`. Throws CaseError if it is not
  /// there or not ours.
  static PvdSeries resume(const std::string& path, double keep_until);

  /// `relative_file`: as seen from the folder of the .pvd. A frame of the same file is replaced.
  void add(double time, const std::string& relative_file);
  std::size_t size() const { return frames.size(); }
  void rewrite() const;  ///< the file as it is now: after a resume, without the later frames

 private:
  struct Frame {
    double time;
    std::string file;
  };
  std::string path;
  std::vector<Frame> frames;
};

}  // namespace sinew
