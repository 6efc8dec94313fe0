#include <gtest/gtest.h>
#include <sinew/cli/frame_writer.hpp>
#include <sinew/core/error.hpp>
#include <unit/io/temporary_folder.hpp>

namespace sinew {
namespace {

using test::content;
using test::message_of;

Snapshot at_time(double time) {
  Snapshot snapshot;
  snapshot.time = time;
  snapshot.position.resize(1000);
  snapshot.size.resize(1000, 1.0);
  snapshot.body.resize(1000);
  return snapshot;
}

class FrameWriterTest : public testing::Test {
 protected:
  test::TemporaryFolder place;
  RunFolder folder = RunFolder::create(place / "run", false);
};

TEST_F(FrameWriterTest, DrainedFramesAreOnDiskInOrder) {
  FrameWriter writer(folder, PvdSeries(folder.series()));
  for (int i = 0; i < 20; ++i) writer.write(at_time(0.5 * i));
  writer.drain();
  const std::string series = content(folder.series());
  std::size_t last = 0;
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(content(folder.frame(i)).ends_with("</VTKFile>\n")) << i;
    const std::size_t found = series.find(RunFolder::frame_name(i));
    EXPECT_LT(last, found);
    EXPECT_NE(found, series.npos);
    last = found;
  }
}

TEST_F(FrameWriterTest, SpentFramesComeBackWithTheirMemory) {
  FrameWriter writer(folder, PvdSeries(folder.series()));
  EXPECT_TRUE(writer.spent().position.empty());
  Snapshot first = at_time(0.0);
  const Point* const memory = first.position.data();
  writer.write(std::move(first));
  writer.drain();
  EXPECT_EQ(writer.spent().position.data(), memory);
  EXPECT_TRUE(writer.spent().position.empty());
}

TEST_F(FrameWriterTest, TheEndWaitsForAllFrames) {
  {
    FrameWriter writer(folder, PvdSeries(folder.series()));
    for (int i = 0; i < 3; ++i) writer.write(at_time(i));
  }
  EXPECT_NE(content(folder.series()).find(RunFolder::frame_name(2)), std::string::npos);
}

TEST_F(FrameWriterTest, AnErrorIsThrownOnceAndTheNextFrameTakesThePlace) {
  FrameWriter writer(folder, PvdSeries(folder.series()));
  {
    const test::SmallFilesOnly limit(100);
    writer.write(at_time(0.0));
    EXPECT_EQ(message_of<SimulationError>([&] { writer.drain(); }), "cannot write " + folder.frame(0) + ": File too large");
  }
  writer.drain();
  EXPECT_FALSE(std::filesystem::exists(folder.series()));
  writer.write(at_time(1.0));
  writer.drain();
  EXPECT_NE(content(folder.series()).find("timestep=\"1\""), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder.frame(0)));
}

TEST_F(FrameWriterTest, AnErrorReachesTheNextHandOvers) {
  FrameWriter writer(folder, PvdSeries(folder.series()));
  const test::SmallFilesOnly limit(100);
  const auto hand_over = [&] {
    for (int i = 0; i < 3; ++i) writer.write(at_time(i));
  };
  EXPECT_NE(message_of<SimulationError>(hand_over).find("File too large"), std::string::npos);
}

}  // namespace
}  // namespace sinew
