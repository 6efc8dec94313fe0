#pragma once
/// Wall time, and wall time by name of pass.

#include <chrono>
#include <map>
#include <string>

namespace sinew {

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// Adds up the wall time between marks: the time since the last mark belongs to the pass that is named.
class PassTimer {
 public:
  explicit PassTimer(std::initializer_list<const char*> passes) {
    for (const char* pass : passes) seconds_[pass] = 0.0;
  }
  void begin() { last_ = Clock::now(); }
  void mark(const char* pass) {
    const Clock::time_point now = Clock::now();
    seconds_.find(pass)->second += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  const std::map<std::string, double, std::less<>>& seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  std::map<std::string, double, std::less<>> seconds_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace sinew
