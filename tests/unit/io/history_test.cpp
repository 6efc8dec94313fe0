#include <cmath>
#include <gtest/gtest.h>
#include <sinew/core/error.hpp>
#include <sinew/io/history.hpp>
#include <unit/io/temporary_folder.hpp>

namespace sinew {
namespace {

const std::vector<HistoryColumn> columns{{"time", "s"}, {"step", "1"}, {"tip, z", "m"}};

TEST(HistoryFile, HeaderAndShortestDigits) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "history.csv";
  {
    HistoryFile history(path, columns);
    history.add_row(std::vector{0.0, 0.0, 0.1});
    history.add_row(std::vector{0.1 + 0.2, 12.0, -1.0 / 3.0});
    history.add_row(std::vector{1e-9, 1e6, std::nan("")});
  }
  EXPECT_EQ(test::content(path),
            "time [s],step,\"tip, z [m]\"\n0,0,0.1\n0.30000000000000004,12,-0.3333333333333333\n1e-09,1000000,nan\n");
}

TEST(HistoryFile, ResumeDropsLaterAndTornRows) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "history.csv";
  { HistoryFile history(path, columns); }
  test::put(path, test::content(path) + "0,0,1\n0.1,1,2\n0.2,2,3\n0.3,3,4\n0.1");
  {
    HistoryFile history = HistoryFile::resume(path, columns, 0.2);
    history.add_row(std::vector{0.25, 3.0, 9.0});
    history.flush();
  }
  EXPECT_EQ(test::content(path), "time [s],step,\"tip, z [m]\"\n0,0,1\n0.1,1,2\n0.2,2,3\n0.25,3,9\n");
}

TEST(HistoryFile, ResumeWithOtherColumnsIsRefused) {
  const test::TemporaryFolder folder;
  { HistoryFile history(folder / "h.csv", columns); }
  const std::string message = test::message_of<CaseError>([&] {
    HistoryFile::resume(folder / "h.csv", {{"time", "s"}, {"other", "1"}}, 1.0);
  });
  EXPECT_NE(message.find("other columns"), std::string::npos);
  EXPECT_THROW(HistoryFile::resume(folder / "none.csv", columns, 1.0), CaseError);
}

TEST(HistoryFile, Errors) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(HistoryFile("/nonexistent/h.csv", columns), SimulationError);
  HistoryFile history(folder / "h.csv", columns);
  EXPECT_THROW(history.add_row(std::vector{1.0}), std::invalid_argument);
  const test::SmallFilesOnly limit(30);
  EXPECT_NE(test::message_of<SimulationError>([&] {
              history.add_row(std::vector{0.1, 1.0, 2.0});
              history.flush();
            }).find("File too large"),
            std::string::npos);
}

}  // namespace
}  // namespace sinew
