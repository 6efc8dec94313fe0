#include <filesystem>
#include <sinew/cli/case_input.hpp>
#include <sinew/cli/case_run.hpp>
#include <sinew/cli/interruption.hpp>
#include <sinew/cli/number_format.hpp>
#include <sinew/cli/run.hpp>
#include <sinew/cli/threads.hpp>

namespace sinew {

namespace {

RunFolder open_folder(const std::string& path) {
  RunFolder folder = RunFolder::open(path);
  std::error_code ignored;
  if (std::filesystem::exists(folder.file("study.csv"), ignored))
    throw CaseError(path + " holds a study. Resume one of its runs, for example sinew resume " + path +
                    "/001_..., or run the case again.");
  return folder;
}

/// CaseError if the checkpoint cannot belong to the case as it is now.
void check_checkpoint(const Case& c, const Checkpoint& checkpoint) {
  for (const ProbeCase& probe : c.probes)
    if (!checkpoint.numbers.contains("history.min." + probe.name))
      throw CaseError("the checkpoint knows no probe \"" + probe.name +
                      "\". Resume with the same probes, or run again in a new folder.");
  if (!checkpoint.numbers.contains("history.stride")) throw CaseError("the checkpoint was not written by sinew run.");
}

}  // namespace

int resume_verb(const ResumeOptions& options) {
  listen_for_interruption();
  const Comm comm = Comm::world();
  const int threads = use_threads(options, comm);
  const RunFolder folder = RunFolder::at(options.folder);
  Case c;
  comm.together([&] {
    open_folder(options.folder);
    const CaseInput input = read_case_input(folder.resolved_case(), options.overrides);
    c = make_case(input.root, input.folder);
  });
  const Checkpoint checkpoint = read_checkpoint(folder.checkpoint(), comm);
  comm.together([&] { check_checkpoint(c, checkpoint); });
  const std::unique_ptr<Simulation> simulation = Simulation::build(c, comm);
  const auto reporter = make_reporter(comm, folder, options.quiet);
  CaseRun run(c, *simulation, folder, *reporter, {"", Tier::full, threads, comm});
  run.resume(checkpoint);
  const std::string time = quantity_text(simulation->time(), c.general.units.name_of("s"));
  if (run.at_end()) {
    reporter->say("the run has reached its end at t = " + time + "; --set solver.end_time=... lets it go further.");
    return done;
  }
  reporter->say("resuming at t = " + time + ", step " + count_text(simulation->steps()));
  return exit_code(run.to_the_end().summary.status);
}

}  // namespace sinew
