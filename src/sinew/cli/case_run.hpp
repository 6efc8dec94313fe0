#pragma once
/// One run: steps until the end and everything that is written on the way.

#include <chrono>
#include <optional>
#include <sinew/cli/expect.hpp>
#include <sinew/cli/frame_writer.hpp>
#include <sinew/cli/options.hpp>
#include <sinew/cli/recorder.hpp>
#include <sinew/cli/reporter.hpp>
#include <sinew/io/checkpoint.hpp>
#include <sinew/io/run_folder.hpp>
#include <sinew/model/simulation.hpp>
#include <string>

namespace sinew {

/// Most memory that this process has had so far.
long peak_memory_bytes();

struct RunControl {
  std::string picture;  ///< a file outside the run folder; empty: none
  Tier tier = Tier::full;
  int threads = 1;
  Comm comm;
};

struct RunResult {
  Summary summary;
  FinishedRun finished;
};

/// Exit code for the status of a summary.
ExitCode exit_code(const std::string& status);

/// Output never changes the states: steps are not shortened for it, only the last one is, to end at end_time. All ranks run it together; the first one
/// writes.
class CaseRun {
 public:
  CaseRun(const Case& c, Simulation& simulation, const RunFolder& folder, Reporter& reporter, const RunControl& control);

  void begin();                               ///< writes the resolved case, the first frame and the first row
  void resume(const Checkpoint& checkpoint);  ///< takes over the state, goes on with history and frames
  /// Steps until the end, an interruption or a failure of the simulation; writes the rest and summary.json. Only errors that are
  /// not of the simulation are thrown.
  RunResult to_the_end();
  bool at_end() const;

 private:
  using Clock = std::chrono::steady_clock;

  void march();
  bool step();
  void say_stage();
  bool record_follows(double now, double next) const;
  void write_due(double time_before);
  void write_frame();  ///< hands the state to the writer of frames
  void write_state();  ///< checkpoint.h5, when all frames before it are written
  void write_pictures();
  void write_rest();
  template <class Action>
  void attempt(Action&& action);
  double fraction() const;
  double wall_seconds() const;
  Summary summarize(const FinishedRun& finished);
  void say_end(const Summary& summary);

  const Case& c;
  Simulation& simulation;
  const RunFolder& folder;
  Reporter& reporter;
  RunControl control;
  Recorder recorder;
  std::string case_text;
  bool frames_need_record;
  std::optional<FrameWriter> frames;
  double stage_begin = 0.0;  ///< of the present stage
  long last_frame_step = -1;
  std::string status = "completed", message;
  double earlier_seconds = 0.0, stepping_seconds = 0.0;  ///< earlier: of the run that is resumed
  Clock::time_point begin_time = Clock::now();
};

}  // namespace sinew
