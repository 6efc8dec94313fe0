#include <gtest/gtest.h>
#include <regex>
#include <sinew/core/error.hpp>
#include <sinew/io/run_folder.hpp>
#include <sinew/io/run_log.hpp>
#include <unit/io/temporary_folder.hpp>

namespace sinew {
namespace {

namespace fs = std::filesystem;
using test::message_of;
using test::put;

TEST(RunFolder, NamesOfFiles) {
  const test::TemporaryFolder folder;
  const RunFolder run = RunFolder::create(folder / "a/b", false);
  EXPECT_TRUE(fs::is_directory(folder / "a/b/particles"));
  EXPECT_EQ(run.resolved_case(), folder / "a/b/case.resolved.toml");
  EXPECT_EQ(run.log(), folder / "a/b/run.log");
  EXPECT_EQ(run.summary(), folder / "a/b/summary.json");
  EXPECT_EQ(run.history(), folder / "a/b/history.csv");
  EXPECT_EQ(run.series(), folder / "a/b/particles.pvd");
  EXPECT_EQ(run.checkpoint(), folder / "a/b/checkpoint.h5");
  EXPECT_EQ(RunFolder::frame_name(12), "particles/frame_000012.vtu");
  EXPECT_EQ(run.frame(0), folder / "a/b/particles/frame_000000.vtu");
}

TEST(RunFolder, AnOldRunIsReplacedOnlyByForceAndForeignFilesStay) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "run";
  const RunFolder run = RunFolder::create(path, false);
  for (const std::string& file : {run.resolved_case(), run.summary(), run.checkpoint(), run.frame(0), run.frame(7)})
    put(file, "x");
  put(path + "/thesis.txt", "mine");
  put(path + "/particles/notes.txt", "mine");
  EXPECT_EQ(message_of<CaseError>([&] { RunFolder::create(path, false); }),
            "the folder " + path + " is not empty. Choose another with -o, or pass --force to overwrite the run in it.");
  EXPECT_TRUE(fs::exists(run.frame(7)));
  RunFolder::create(path, true);
  EXPECT_FALSE(fs::exists(run.summary()) || fs::exists(run.resolved_case()) || fs::exists(run.checkpoint()) ||
               fs::exists(run.frame(7)));
  EXPECT_TRUE(fs::exists(path + "/thesis.txt") && fs::exists(path + "/particles/notes.txt"));
}

TEST(RunFolder, ForceNeverTouchesOtherFolders) {
  const test::TemporaryFolder folder;
  put(folder / "history.csv", "mine");
  EXPECT_NE(message_of<CaseError>([&] { RunFolder::create(folder.path(), true); }).find("does not hold a run"),
            std::string::npos);
  EXPECT_EQ(test::content(folder / "history.csv"), "mine");
}

TEST(RunFolder, EmptyFolderIsTaken) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(RunFolder::create(folder.path(), false).path(), folder.path());
}

TEST(RunFolder, UnusablePlaces) {
  const test::TemporaryFolder folder;
  put(folder / "file", "x");
  EXPECT_NE(message_of<CaseError>([&] { RunFolder::create(folder / "file", true); }).find("is a file"), std::string::npos);
  EXPECT_NE(message_of<CaseError>([&] { RunFolder::create(folder / "file/run", false); }).find("Not a directory"),
            std::string::npos);
  EXPECT_THROW(RunFolder::create("", false), CaseError);
  EXPECT_THROW(RunFolder::create("/proc/run", false), CaseError);
}

TEST(RunFolder, OpensOnlyRuns) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(RunFolder::open(folder / "none"), CaseError);
  EXPECT_THROW(RunFolder::open(folder.path()), CaseError);
  put(folder / "case.resolved.toml", "");
  EXPECT_EQ(RunFolder::open(folder.path()).path(), folder.path());
}

TEST(RunLog, StampsEveryLineAndAppends) {
  const test::TemporaryFolder folder;
  RunLog(folder / "run.log").write("first\n  second\n");
  RunLog(folder / "run.log").write("third");
  const std::string stamp = R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d[+-]\d{4} )";
  EXPECT_TRUE(std::regex_match(test::content(folder / "run.log"),
                               std::regex(stamp + "first\n" + stamp + "  second\n" + stamp + "third\n")));
  EXPECT_THROW(RunLog("/nonexistent/run.log"), SimulationError);
}

TEST(RunLog, EchoesWithoutStamp) {
  const test::TemporaryFolder folder;
  testing::internal::CaptureStdout();
  RunLog(folder / "run.log", RunLog::Terminal::echo).write("a\nb");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "a\nb\n");
}

}  // namespace
}  // namespace sinew
