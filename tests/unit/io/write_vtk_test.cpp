#include <gtest/gtest.h>
#include <sinew/core/error.hpp>
#include <sinew/io/vtk_array.hpp>
#include <sinew/io/write_vtk.hpp>
#include <unit/io/temporary_folder.hpp>

namespace sinew {
namespace {

using test::content;
using test::message_of;

std::string base64_of(std::string_view text) { return base64(std::as_bytes(std::span(text))); }

TEST(Base64, VectorsOfRfc4648) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64_of("\xff\xfe"), "//4=");
}

TEST(VtkArray, HeaderTellsBlocksAndSizes) {
  const std::vector<double> values(40'000, 1.5);  // 320 000 bytes: one full block of 262 144 and 57 856 bytes
  const std::string text = encode_vtk_array(std::as_bytes(std::span(values)));
  const std::vector<std::uint32_t> head{2, 262'144, 57'856};
  EXPECT_EQ(text.substr(0, 16), base64(std::as_bytes(std::span(head))));
}

TEST(Xml, EscapesAndBack) {
  EXPECT_EQ(xml_escape("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
  EXPECT_EQ(xml_unescape(xml_escape("a<b & &lt; \"c\">")), "a<b & &lt; \"c\">");
}

TEST(PvdSeries, IsWholeAfterEveryFrame) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "particles.pvd";
  PvdSeries series(path);
  series.add(0.0, "particles/frame_000000.vtu");
  const std::string one = content(path);
  EXPECT_NE(one.find("timestep=\"0\" group=\"\" part=\"0\" file=\"particles/frame_000000.vtu\""), one.npos);
  EXPECT_TRUE(one.ends_with("</VTKFile>\n"));
  series.add(0.1, "particles/frame_000001.vtu");
  EXPECT_TRUE(content(path).ends_with("</VTKFile>\n"));
  EXPECT_NE(content(path).find("timestep=\"0.1\""), one.npos);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(PvdSeries, ResumeKeepsFramesUpToATime) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "particles.pvd";
  PvdSeries series(path);
  for (int i = 0; i < 5; ++i) series.add(0.1 * i, "f" + std::to_string(i) + " & co.vtu");
  PvdSeries resumed = PvdSeries::resume(path, 0.1 * 2);
  EXPECT_EQ(resumed.size(), 3u);
  EXPECT_EQ(content(path).find("f3"), std::string::npos);
  resumed.add(0.25, "f2 & co.vtu");  // the same file again: replaced
  EXPECT_EQ(resumed.size(), 3u);
  EXPECT_NE(content(path).find("timestep=\"0.25\" group=\"\" part=\"0\" file=\"f2 &amp; co.vtu\""), std::string::npos);
}

TEST(PvdSeries, ResumeOfSomethingElseIsRefused) {
  const test::TemporaryFolder folder;
  test::put(folder / "a.pvd", "hello");
  EXPECT_THROW(PvdSeries::resume(folder / "a.pvd", 1.0), CaseError);
  EXPECT_NE(message_of<CaseError>([&] { PvdSeries::resume(folder / "none.pvd", 1.0); }).find("No such file"), std::string::npos);
}

Snapshot two_particles() {
  Snapshot snapshot;
  snapshot.position = {{{0, 0, 0}}, {{1, 0, 0}}};
  snapshot.size = {1, 1};
  snapshot.body = {0, 0};
  return snapshot;
}

TEST(WriteVtu, UnwritablePlaceNamesPathAndReason) {
  const std::string path = "/nonexistent_folder/frame.vtu";
  const std::string message = message_of<SimulationError>([&] { write_vtu(path, two_particles()); });
  EXPECT_EQ(message, "cannot write " + path + ": No such file or directory");
}

TEST(WriteVtu, FullDiskIsAnErrorAndKeepsTheOldFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "frame.vtu";
  test::put(path, "old");
  const test::SmallFilesOnly limit(100);
  EXPECT_EQ(message_of<SimulationError>([&] { write_vtu(path, two_particles()); }), "cannot write " + path + ": File too large");
  EXPECT_EQ(content(path), "old");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(WriteVtu, WrongSizesAreOurBug) {
  Snapshot snapshot = two_particles();
  snapshot.fields = {{"pressure", "Pa", 1, {1.0}}};
  EXPECT_THROW(write_vtu("/nonexistent_folder/frame.vtu", snapshot), std::invalid_argument);
}

}  // namespace
}  // namespace sinew
