#include <fmt/format.h>
#include <sinew/cli/case_run.hpp>
#include <sinew/cli/facts_text.hpp>
#include <sinew/cli/number_format.hpp>
#include <sinew/cli/version.hpp>
#include <sys/resource.h>

namespace sinew {

long peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024L;
}

Summary CaseRun::summarize(const FinishedRun& finished) {
  const ModelFacts& facts = simulation.facts();
  Summary s;
  s.status = status;
  s.message = message;
  s.version = program_version();
  s.commit = program_commit();
  s.case_name = c.general.name;
  s.particles = facts.particles;
  s.neighbors = facts.neighbors_mean;
  s.steps = simulation.steps();
  s.end_time = simulation.time();
  s.wall_seconds = wall_seconds();
  s.stepping_seconds = stepping_seconds;
  if (stepping_seconds > 0.0) s.particle_steps_per_second = static_cast<double>(s.particles) * s.steps / stepping_seconds;
  s.ranks = control.comm.size();
  s.threads = control.threads;
  s.peak_memory_bytes = control.comm.sum(peak_memory_bytes());
  s.state_hash = simulation.state_hash();
  const Energies e = simulation.energies();
  s.energy = {{"kinetic", e.kinetic},
              {"strain", e.strain},
              {"hourglass", e.hourglass},
              {"contact", e.contact},
              {"total", e.total()},
              {"dissipated", e.dissipated},
              {"plastic_work", e.plastic_work},
              {"external_work", e.external_work},
              {"initial", e.initial},
              {"balance_error", e.balance_error()},
              {"drift", relative_balance_error(e)}};
  const Momenta m = simulation.momenta();
  for (int i = 0; i < 3; ++i) {
    s.momentum[std::string("linear_") + "xyz"[i]] = m.linear[i];
    s.momentum[std::string("angular_") + "xyz"[i]] = m.angular[i];
  }
  s.momentum["linear_scale"] = m.linear_scale;
  s.momentum["linear_change"] = norm(m.linear - recorder.initial_momenta().linear);
  s.momentum["angular_change"] = norm(m.angular - recorder.initial_momenta().angular);
  for (const auto& [name, probe] : finished.probes)
    s.probes[name] = {probe.samples.value.empty() ? 0.0 : probe.samples.value.back(), probe.min, probe.max, probe.unit};
  if (c.study.vary.empty()) s.expect = check_expects(c.expects, finished, control.tier);
  s.exchange = {{"copies_share", facts.ranks.copies_share},
                {"bytes_per_step", facts.ranks.bytes},
                {"messages_per_rank", facts.ranks.messages_most}};
  s.equations = simulation.equation_counts();
  s.pass_timings = simulation.pass_seconds();
  s.warnings = facts.warnings;
  return s;
}

void CaseRun::say_end(const Summary& s) {
  const std::string time = quantity_text(s.end_time, c.general.units.name_of("s"));
  reporter.say(balance_text(c, simulation.energies(), simulation.momenta(), recorder.initial_momenta()));
  for (const auto& [name, probe] : s.probes)
    reporter.say(
        fmt::format("probe {}: {}, from {:.6g} to {:.6g}", name, quantity_text(probe.final, probe.unit), probe.min, probe.max));
  if (!s.expect.empty()) reporter.say("expected values");
  for (const ExpectSummary& row : s.expect) reporter.say(row_text(row));
  reporter.say(fmt::format("{}: t = {}, {} steps in {}, {:.3g} million particle-steps/s, results in {}", status, time,
                           count_text(s.steps), duration_text(s.wall_seconds), 1e-6 * s.particle_steps_per_second,
                           folder.path()));
  if (!s.equations.empty())
    reporter.say(fmt::format("{} Newton iterations, {} linear ones, {} steps cut back", s.equations.at("newton_iterations"),
                             s.equations.at("linear_iterations"), s.equations.at("cut_backs")));
  if (status == "no balance")
    reporter.warn(message + "\nThe last balance is in " + folder.path() +
                  "; sinew resume goes on from there, with --set solver...");
  if (status == "interrupted") reporter.warn("interrupted at t = " + time + ". To go on: sinew resume " + folder.path());
  if (status == "failed") reporter.warn("the run failed at t = " + time + ": " + message);
  if (status == "unstable")
    reporter.warn(message + "\nEverything until then is in " + folder.path() + "; look at the last frame there.");
}

}  // namespace sinew
