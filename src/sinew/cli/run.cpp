#include <filesystem>
#include <sinew/cli/case_input.hpp>
#include <sinew/cli/case_run.hpp>
#include <sinew/cli/facts_text.hpp>
#include <sinew/cli/interruption.hpp>
#include <sinew/cli/run.hpp>
#include <sinew/cli/threads.hpp>

namespace sinew {

namespace {

namespace fs = std::filesystem;

/// A folder that cannot be used is better known before the case is built; nothing is made yet.
void check_folder(const std::string& path, bool force) {
  std::error_code ignored;
  const bool taken = fs::exists(path, ignored) && (!fs::is_directory(path, ignored) || !fs::is_empty(path, ignored));
  if (taken && !force) RunFolder::create(path, false);
}

/// The picture is written last: what is wrong with its name is better known first. Its folder may be the run folder, which is yet to be made.
void check_picture(const std::string& file, const std::string& run_folder) {
  if (file.empty()) return;
  if (!file.ends_with(".png")) throw CaseError("--picture: the name of the file must end with .png, found \"" + file + "\"");
  const fs::path parent = fs::absolute(file).lexically_normal().parent_path();
  std::error_code ignored;
  if (!fs::is_directory(parent, ignored) && parent != fs::absolute(run_folder + "/").lexically_normal().parent_path())
    throw CaseError("--picture: there is no folder " + parent.string());
}

}  // namespace

RunResult run_case(const Case& c, const RunPlan& plan) {
  const Comm& comm = plan.control.comm;
  comm.on_root([&] { check_folder(plan.folder, plan.force); });
  const std::unique_ptr<Simulation> simulation = Simulation::build(c, comm);
  comm.on_root([&] { RunFolder::create(plan.folder, plan.force); });
  const RunFolder folder = RunFolder::at(plan.folder);
  const auto reporter = make_reporter(comm, folder, plan.quiet, plan.label);
  reporter->say(facts_text(c, simulation->facts()));
  CaseRun run(c, *simulation, folder, *reporter, plan.control);
  run.begin();
  return run.to_the_end();
}

std::unique_ptr<Reporter> make_reporter(const Comm& comm, const RunFolder& folder, bool quiet, const std::string& label) {
  auto reporter = std::make_unique<Reporter>();
  comm.on_root([&] { reporter = std::make_unique<Reporter>(folder.log(), quiet, label); });
  return reporter;
}

int run_verb(const RunOptions& options) {
  listen_for_interruption();
  const Comm comm = Comm::world();
  const int threads = use_threads(options, comm);
  CaseInput input;
  Case c;
  comm.together([&] {
    input = read_case_input(options.case_path, options.overrides);
    c = make_case(input.root, input.folder);
  });
  RunPlan plan{options.folder.empty() ? "runs/" + c.general.name : options.folder, options.force, options.quiet, "", {}};
  comm.on_root([&] { check_picture(options.picture, plan.folder); });
  plan.control = {options.picture, options.tier, threads, comm};
  if (!c.study.vary.empty()) return run_study(input, c, plan);
  return exit_code(run_case(c, plan).summary.status);
}

}  // namespace sinew
