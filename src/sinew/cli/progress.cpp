#include <sinew/cli/progress.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <sinew/cli/number_format.hpp>

namespace sinew {

namespace {

constexpr std::chrono::milliseconds bar_interval{200};
constexpr std::chrono::seconds line_interval{30};
constexpr int bar_width = 20;

int tenth(double fraction) { return static_cast<int>(fraction * 10.0); }

std::string bar(double fraction) {
  const int filled = std::clamp(static_cast<int>(fraction * bar_width), 0, bar_width);
  return "[" + std::string(filled, '#') + std::string(bar_width - filled, '.') + "] ";
}

}  // namespace

Progress::Progress(Reporter& reporter_, long particles_, std::string time_unit_, const ProgressState& start_)
    : reporter(reporter_),
      particles(static_cast<double>(particles_)),
      time_unit(std::move(time_unit_)),
      start(start_),
      last_tenth(tenth(start_.fraction)) {}

std::string Progress::text(const ProgressState& state, double seconds) const {
  const double rate = seconds > 0.0 ? static_cast<double>(state.steps - start.steps) / seconds : 0.0;
  const double gained = state.fraction - start.fraction;
  const double left = gained > 0.0 ? seconds * (1.0 - state.fraction) / gained : 0.0;
  return fmt::format("{:3.0f} %  t = {:.4g} {}  {:.4g} steps/s  {:.3g} M particle-steps/s  energy drift {:.1e}  {} left",
                     100.0 * state.fraction, state.time, time_unit, rate, 1e-6 * rate * particles, state.energy_drift,
                     duration_text(left));
}

void Progress::update(const ProgressState& state) {
  const Clock::time_point now = Clock::now();
  const bool line_due = tenth(state.fraction) > last_tenth || now - last_line >= line_interval;
  const bool bar_due = reporter.has_bar() && now - last_bar >= bar_interval;
  if (!line_due && !bar_due) return;
  const std::string label = reporter.label().empty() ? "" : reporter.label() + "  ";
  const std::string line = text(state, std::chrono::duration<double>(now - begin).count());
  if (line_due) {
    reporter.note(label + line);
    last_tenth = tenth(state.fraction);
    last_line = now;
  }
  if (bar_due) {
    reporter.show_bar(label + bar(state.fraction) + line);
    last_bar = now;
  }
}

}  // namespace sinew
