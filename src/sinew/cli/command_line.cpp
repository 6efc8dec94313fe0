#include <sinew/cli/command_line.hpp>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <map>
#include <sinew/cli/launch.hpp>
#include <sinew/cli/options.hpp>
#include <sinew/cli/version.hpp>
#include <sinew/core/error.hpp>
#include <sinew/implicit/newton.hpp>
#include <sinew/parallel/comm.hpp>

namespace sinew {

namespace {

/// The options of all verbs, filled by the parser.
struct Arguments {
  RunOptions run;
  ResumeOptions resume;
  CheckOptions check;
  VerifyOptions verify;
  std::string list_kind;
  DescribeOptions describe;
  NewOptions new_case;
};

constexpr int most_ranks = 1 << 20;

using Actions = std::map<CLI::App*, std::function<int()>>;

void add_overrides(CLI::App& verb, std::vector<std::string>& overrides) {
  verb.add_option("--set", overrides, "Replace a value of the case; may be repeated")
      ->type_name("KEY.PATH=VALUE")
      ->allow_extra_args(false);
}

void add_threads(CLI::App& verb, ComputeOptions& options) {
  verb.add_option("-t,--threads", options.threads, "Number of threads (of each rank); default all cores")->type_name("N");
}

void add_compute(CLI::App& verb, ComputeOptions& options) {
  add_threads(verb, options);
  verb.add_option("-n,--ranks", options.ranks, "Number of processes (ranks of MPI); default one")
      ->type_name("N")
      ->check(CLI::Range(1, most_ranks));
}

void add_tier(CLI::App& verb, Tier& tier, const std::string& what) {
  const auto read = [&tier](const std::string& name) {
    static const std::vector<std::string> names{"quick", "full"};
    if (name != "quick" && name != "full") throw CLI::ValidationError("--tier", unknown_name_message("tier", name, names));
    tier = name == "full" ? Tier::full : Tier::quick;
  };
  verb.add_option_function<std::string>("--tier", read, what)->type_name("quick|full");
}

void add_run(CLI::App& app, RunOptions& options, Actions& actions) {
  CLI::App& verb = *app.add_subcommand("run", "Run a case");
  verb.add_option("case", options.case_path, "The case file")->required()->type_name("CASE.toml");
  verb.add_option("-o,--output", options.folder, "The run folder; default runs/NAME")->type_name("DIR");
  add_overrides(verb, options.overrides);
  add_compute(verb, options);
  verb.add_flag("--force", options.force, "Replace the run in the folder");
  verb.add_option("--picture", options.picture, "Also write a picture of the last state")->type_name("FILE.png");
  verb.add_flag("--quiet", options.quiet, "Print errors only");
  add_tier(verb, options.tier, "quick: leave out expected values of the full tier, and runs of a study that only they need");
  actions[&verb] = [&] { return run_verb(options); };
}

void add_resume(CLI::App& app, ResumeOptions& options, Actions& actions) {
  CLI::App& verb = *app.add_subcommand("resume", "Go on from the last checkpoint of a run");
  verb.add_option("folder", options.folder, "The run folder")->required()->type_name("DIR");
  add_overrides(verb, options.overrides);
  add_compute(verb, options);
  verb.add_flag("--quiet", options.quiet, "Print errors only");
  actions[&verb] = [&] { return resume_verb(options); };
}

void add_check(CLI::App& app, CheckOptions& options, Actions& actions) {
  CLI::App& verb = *app.add_subcommand("check", "Say what a run would do, without running it");
  verb.add_option("case", options.case_path, "The case file")->required()->type_name("CASE.toml");
  add_overrides(verb, options.overrides);
  add_threads(verb, options);
  verb.add_option("-n,--ranks", options.plan, "Also plan runs on these numbers of ranks, for example 8,64,512")
      ->type_name("N,...")
      ->delimiter(',')
      ->check(CLI::Range(1, most_ranks));
  actions[&verb] = [&] { return check_verb(options); };
}

void add_verify(CLI::App& app, VerifyOptions& options, Actions& actions) {
  CLI::App& verb = *app.add_subcommand("verify", "Run cases with expected values; print published against computed");
  verb.add_option("paths", options.paths, "Case files, or folders to search for them")->required()->type_name("PATH");
  add_tier(verb, options.tier, "quick (default), or full: also what takes long");
  verb.add_option("--json", options.json, "Also write the rows to this file")->type_name("FILE");
  verb.add_option("-j,--jobs", options.jobs, "How many cases run at a time")->type_name("N");
  verb.add_option("-o,--output", options.folder, "Where the run folders go; default runs/verify")->type_name("DIR");
  verb.add_option("-t,--threads", options.threads, "Threads of each case; default all cores, shared by the jobs")->type_name("N");
  actions[&verb] = [&] { return verify_verb(options); };
}

void add_reference(CLI::App& app, Arguments& arguments, Actions& actions) {
  CLI::App& list = *app.add_subcommand("list", "What exists: materials, kernels, ...");
  list.add_option("kind", arguments.list_kind, "Only this kind")->type_name("KIND");
  actions[&list] = [&] { return list_verb(arguments.list_kind); };

  CLI::App& describe = *app.add_subcommand("describe", "Every parameter of a model or a section of the case file");
  describe.add_option("name", arguments.describe.name, "For example neo_hookean, solver, materials")->type_name("NAME");
  describe.add_flag("--all", arguments.describe.all, "Everything");
  describe.add_flag("--markdown", arguments.describe.markdown, "As a page");
  describe.add_option("-o,--output", arguments.describe.folder, "With --all: write the pages of the reference")->type_name("DIR");
  actions[&describe] = [&] { return describe_verb(arguments.describe); };

  CLI::App& new_case = *app.add_subcommand("new", "Write a commented starter case");
  new_case.add_option("template", arguments.new_case.name, "beam (default), pull or block3d")->type_name("TEMPLATE");
  new_case.add_option("-o,--output", arguments.new_case.file, "The file; default TEMPLATE.toml")->type_name("FILE");
  actions[&new_case] = [&] { return new_verb(arguments.new_case); };
}

/// All long and short names of the options.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::string message_of(const CLI::App& verb, const CLI::ParseError& error) {
  for (const std::string& extra : verb.remaining()) {
    if (extra.starts_with("-")) return verb.get_name() + ": " + unknown_name_message("option", extra, option_names(verb));
    return verb.get_name() + ": does not expect \"" + extra + "\". `sinew " + verb.get_name() + " --help` shows what it takes.";
  }
  std::string what = error.what();
  if (!what.ends_with('.')) what += '.';
  return verb.get_name() + ": " + what + " `sinew " + verb.get_name() + " --help` shows what it takes.";
}

/// CaseError for a first argument that is neither a verb nor a known option.
void check_first(const CLI::App& app, int count, const char* const* arguments) {
  if (count < 2) throw CaseError(app.help());
  const std::string first = arguments[1];
  std::vector<std::string> known;
  const bool is_option = first.starts_with("-");
  if (is_option)
    known = option_names(app);
  else
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) known.push_back(verb->get_name());
  if (std::find(known.begin(), known.end(), first) == known.end())
    throw CaseError(unknown_name_message(is_option ? "option" : "command", first, known));
}

struct Parsed {
  std::function<int()> action;
  bool help = false;  ///< or version
};

/// What the words mean: fills the values and returns what is to be done. Throws CaseError.
Parsed parse(CLI::App& app, Arguments& values, int count, const char* const* arguments) {
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  Actions actions;
  add_run(app, values.run, actions);
  add_resume(app, values.resume, actions);
  add_check(app, values.check, actions);
  add_verify(app, values.verify, actions);
  add_reference(app, values, actions);
  check_first(app, count, arguments);
  try {
    app.parse(count, arguments);
  } catch (const CLI::Success& success) {
    return {[&app, success] { return app.exit(success); }, true};
  } catch (const CLI::ParseError& error) {
    for (const CLI::App* verb : app.get_subcommands()) throw CaseError(message_of(*verb, error));
    throw CaseError(error.what());
  }
  return {actions.at(app.get_subcommands().front())};
}

int parse_and_run(int count, const char* const* arguments) {
  const Comm comm = Comm::world();
  CLI::App app{"Solids in large deformation with smoothed particle hydrodynamics", "sinew"};
  Arguments values;
  Parsed parsed;
  comm.together([&] { parsed = parse(app, values, count, arguments); });
  const bool shared = !parsed.help && (app.got_subcommand("run") || app.got_subcommand("resume"));
  const int ranks = app.got_subcommand("resume") ? values.resume.ranks : values.run.ranks;
  if (shared && ranks > 1 && !Comm::launched()) return launch_ranks(ranks, without_ranks({arguments + 1, arguments + count}));
  int code = done;
  if (shared)
    code = parsed.action();
  else
    comm.on_root([&] { code = parsed.action(); });
  return code;
}

/// Says what went wrong, once. What only one rank knows ends the others too.
int fail(ExitCode code, const std::exception& error, const std::string& message) {
  const Comm comm = Comm::world();
  const bool alone_with_it = !comm.alone() && dynamic_cast<const CommonError*>(&error) == nullptr;
  if (comm.root() || alone_with_it) std::fputs((message + '\n').c_str(), stderr);
  if (alone_with_it) Comm::abort(code);
  return code;
}

int run_guarded(int count, const char* const* arguments) {
  try {
    return parse_and_run(count, arguments);
  } catch (const CaseError& error) {
    return fail(wrong_input, error, error.what());
  } catch (const SimulationError& error) {
    return fail(simulation_failed, error, error.what());
  } catch (const std::exception& error) {
    return fail(internal_error, error, std::string("internal error: ") + error.what() + "\nPlease report it, with the case.");
  }
}

}  // namespace

int command_line(int count, const char* const* arguments) {
  const int code = run_guarded(count, arguments);
  Newton::finalize();
  Comm::finalize();
  return code;
}

}  // namespace sinew
