#pragma once
/// Particle files written while the run goes on.

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <sinew/io/run_folder.hpp>
#include <sinew/io/write_vtk.hpp>
#include <thread>
#include <vector>

namespace sinew {

/// Encodes and writes frames, in the order in which they come, on a thread of its own; each is listed in the series as soon as its file is
/// complete. One frame is being written and one may wait: who brings a third waits. What goes wrong on the thread (SimulationError with
/// path and reason) is thrown once, at the next `write` or `drain`; the frames behind it are dropped.
class FrameWriter {
 public:
  FrameWriter(const RunFolder& folder, PvdSeries series, VtkReal real = VtkReal::float64);
  ~FrameWriter();  ///< waits for all frames; an error that nobody asked for is lost
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// One that is written already, to be filled anew: a run of many frames allocates memory for the first three. Empty if there is none.
  Snapshot spent();
  void write(Snapshot snapshot);
  void drain();  ///< returns when all frames are in their files and in the series

 private:
  void work();
  void write_now(const Snapshot& snapshot);
  void throw_error();

  const RunFolder& folder;
  const VtkReal real;
  PvdSeries series;  ///< of the thread
  std::mutex mutex;  ///< of what follows
  std::condition_variable changed;
  std::optional<Snapshot> waiting;
  std::vector<Snapshot> written;
  bool busy = false, ending = false;
  std::exception_ptr error;
  std::thread thread;  ///< last: begins when the rest is there
};

}  // namespace sinew
