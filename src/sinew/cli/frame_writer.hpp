#pragma once
/// Particle files written while the run goes on.

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <sinew/io/run_folder.hpp>
#include <sinew/io/write_vtk.hpp>
#include <sinew/parallel/comm.hpp>
#include <thread>
#include <vector>

namespace sinew {

/// Encodes and writes frames, in the order in which they come, on a thread of its own; each is listed in the series as soon as its file is
/// complete. One frame is being written and one may wait: who brings a third waits. What goes wrong on the thread (SimulationError with
/// path and reason) is thrown once, at the next `write` or `drain`; the frames behind it are dropped.
///
/// Where ranks share a case each writes the part of its particles. When all have, which they know at the next `write` or `drain` (both collective), the
/// first one lets the file appear.
class FrameWriter {
 public:
  FrameWriter(const RunFolder& folder, PvdSeries series, VtkReal real = VtkReal::float64, const Comm& comm = Comm());
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
  void list_complete();
  template <class Action>
  void together(Action&& action);
  void throw_error();

  const RunFolder& folder;
  const VtkReal real;
  PvdSeries series;  ///< of the thread; of the main thread where ranks share a case
  const Comm comm;
  long next;            ///< number of the next frame that the thread writes
  long listed;          ///< frames in the series
  bool broken = false;  ///< a rank could not write its part: no frame will be whole any more
  std::mutex mutex;     ///< of what follows
  std::condition_variable changed;
  std::optional<Snapshot> waiting;
  std::vector<Snapshot> written;
  std::vector<double> times;  ///< of frames that are written here and not yet listed
  bool busy = false, ending = false;
  std::exception_ptr error;
  std::thread thread;  ///< last: begins when the rest is there
};

}  // namespace sinew
