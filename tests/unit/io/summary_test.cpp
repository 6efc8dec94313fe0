#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <sinew/core/error.hpp>
#include <sinew/io/summary.hpp>
#include <unit/io/temporary_folder.hpp>

namespace sinew {
namespace {

Summary example() {
  Summary s;
  s.status = "unstable";
  s.message = "particle 3";
  s.case_name = "strip";
  s.particles = 900;
  s.neighbors = 19.5;
  s.end_time = 0.1 + 0.2;
  s.peak_memory_bytes = 5'000'000'000;
  s.state_hash = "00ffab12";
  s.energy = {{"kinetic", 1.0 / 3.0}, {"strain", -0.0}};
  s.momentum = {{"linear_drift", 1e-17}};
  s.probes = {{"tip", {1.0, -2.0, std::numeric_limits<double>::infinity(), "m"}}};
  s.expect = {{"probe.tip.min", -0.101, -0.1, 0.05, std::nullopt, true, "read off", "Fig. 22", ""},
              {"probe.tip.max", 1.0, 0.0, std::nullopt, 1e-3, false, "", "", "note"}};
  s.pass_timings = {{"forces", 2.5}};
  s.warnings = {"\"quoted\"\n and ä"};
  return s;
}

TEST(Summary, ComesBack) {
  const test::TemporaryFolder folder;
  const Summary a = example();
  write_summary(folder / "summary.json", a);
  const Summary b = read_summary(folder / "summary.json");
  EXPECT_EQ(b.status, "unstable");
  EXPECT_EQ(b.end_time, a.end_time);
  EXPECT_EQ(b.peak_memory_bytes, a.peak_memory_bytes);
  EXPECT_EQ(b.energy, a.energy);
  EXPECT_EQ(b.momentum, a.momentum);
  EXPECT_EQ(b.warnings, a.warnings);
  EXPECT_EQ(b.probes.at("tip").min, -2.0);
  EXPECT_TRUE(std::isnan(b.probes.at("tip").max));  // JSON knows no infinity
  ASSERT_EQ(b.expect.size(), 2u);
  EXPECT_EQ(b.expect[0].tolerance, 0.05);
  EXPECT_FALSE(b.expect[0].absolute.has_value());
  EXPECT_EQ(b.expect[1].absolute, 1e-3);
  EXPECT_TRUE(b.expect[0].pass && !b.expect[1].pass);
  Summary again = b;
  EXPECT_EQ(json_text(again), json_text(a));
}

TEST(Summary, FixedNamesInOrder) {
  const std::string text = json_text(example());
  std::size_t at = 0;
  for (const char* key :
       {"status", "version", "commit", "case", "particles", "neighbors", "steps", "end_time", "wall_seconds", "stepping_seconds",
        "particle_steps_per_second", "ranks", "threads", "peak_memory_bytes", "state_hash", "energy", "probes", "expect"}) {
    const std::size_t found = text.find("\n  \"" + std::string(key) + "\": ", at);
    ASSERT_NE(found, text.npos) << key;
    at = found;
  }
}

TEST(Summary, Errors) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(read_summary(folder / "none.json"), CaseError);
  for (const char* text : {"{", "[1]", "{}", "{\"status\": 5}", "{\"status\": \"completed\", \"steps\": \"x\"}"}) {
    test::put(folder / "s.json", text);
    EXPECT_NE(test::message_of<CaseError>([&] { read_summary(folder / "s.json"); }).find("is not a summary"), std::string::npos)
        << text;
  }
  EXPECT_THROW(write_summary("/nonexistent/s.json", {}), SimulationError);
}

}  // namespace
}  // namespace sinew
