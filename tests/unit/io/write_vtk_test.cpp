#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <numeric>
#include <sinew/core/error.hpp>
#include <sinew/io/vtk_array.hpp>
#include <sinew/io/write_vtk.hpp>
#include <sinew/parallel/user_order.hpp>
#include <unit/io/temporary_folder.hpp>

namespace sinew {
namespace {

using test::content;
using test::message_of;

std::string base64_of(std::string_view text) { return base64(std::as_bytes(std::span(text))); }

/// What base64 of RFC 4648 stands for.
std::string decoded(std::string_view text) {
  const std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<unsigned>(alphabet.find(c));
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8));
  }
  return bytes;
}

/// The numbers of a <DataArray>, behind their count of bytes.
template <class T>
std::vector<T> array_in(const std::string& file, const std::string& type, const std::string& name) {
  const std::string begin = "<DataArray type=\"" + type + "\" Name=\"" + name + "\"";
  const std::size_t element = file.find(begin);
  if (element == file.npos) return {};
  const std::size_t text = file.find('\n', element) + 1;
  const std::string bytes = decoded(std::string_view(file).substr(text, file.find('\n', text) - text));
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  EXPECT_EQ(size, bytes.size() - sizeof size) << name;
  std::vector<T> values(size / sizeof(T));
  std::memcpy(values.data(), bytes.data() + sizeof size, size);
  return values;
}

TEST(Base64, VectorsOfRfc4648) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64_of("\xff\xfe"), "//4=");
}

TEST(Base64, EveryLengthAndEveryByteComesBack) {
  std::string bytes;
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(decoded(base64_of(bytes)), bytes) << i;
    bytes += static_cast<char>(37 * i + 11);
  }
}

TEST(VtkArrayStream, PiecesOfAnySizeAreOneTextWithTheNumberOfBytes) {
  const test::TemporaryFolder folder;
  std::vector<std::uint64_t> whole(30'000);  // five blocks
  for (std::size_t i = 0; i < whole.size(); ++i) whole[i] = i * 0x9e3779b97f4a7c15ULL;
  whole[0] = (whole.size() - 1) * sizeof whole[0];
  PartFile file(folder / "array");
  VtkArrayStream stream(file, whole[0]);
  std::span<const std::byte> left = std::as_bytes(std::span(whole).subspan(1));
  for (std::size_t size = 1; !left.empty(); size = size * 3 + 1) {
    stream.put(left.first(std::min(size, left.size())));
    left = left.subspan(std::min(size, left.size()));
  }
  stream.end();
  file.commit();
  EXPECT_EQ(content(folder / "array"), base64(std::as_bytes(std::span(whole))));
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
  resumed.rewrite();
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

/// Numbers with all their digits, more of them than a block has.
Snapshot many_particles() {
  Snapshot snapshot;
  snapshot.fields = {{"pressure", "Pa", 1, {}}, {"velocity", "m/s", 3, {}}};
  for (int i = 0; i < 20'000; ++i) {
    const double x = std::exp(0.001 * i - 10.0) / 3.0;
    snapshot.position.push_back({{x, -x, 2 * x}});
    snapshot.size.push_back(1.0);
    snapshot.body.push_back(i % 3);
    snapshot.fields[0].values.push_back(1e6 / x);
    for (int c = 0; c < 3; ++c) snapshot.fields[1].values.push_back(x * c - 0.1);
  }
  return snapshot;
}

std::vector<double> coordinates(const Snapshot& snapshot) {
  std::vector<double> list;
  for (const Point& x : snapshot.position) list.insert(list.end(), x.c, x.c + 3);
  return list;
}

TEST(WriteVtu, DoubleKeepsEveryBit) {
  const test::TemporaryFolder folder;
  const Snapshot snapshot = many_particles();
  write_vtu(folder / "frame.vtu", snapshot);
  const std::string file = content(folder / "frame.vtu");
  EXPECT_EQ(file.find("compressor"), file.npos);
  EXPECT_EQ(array_in<double>(file, "Float64", "pressure"), snapshot.fields[0].values);
  EXPECT_EQ(array_in<double>(file, "Float64", "velocity"), snapshot.fields[1].values);
  EXPECT_EQ(array_in<double>(file, "Float64", "Points"), coordinates(snapshot));
  EXPECT_EQ(array_in<std::int32_t>(file, "Int32", "body"), snapshot.body);
  std::vector<std::int32_t> number(snapshot.body.size());
  std::iota(number.begin(), number.end(), 0);
  EXPECT_EQ(array_in<std::int32_t>(file, "Int32", "particle_id"), number);
  EXPECT_EQ(array_in<std::int32_t>(file, "Int32", "connectivity"), number);
  std::iota(number.begin(), number.end(), 1);
  EXPECT_EQ(array_in<std::int32_t>(file, "Int32", "offsets"), number);
}

/// The particles of a range, and one more where the files want it.
Snapshot part_of(const Snapshot& whole, const UserRange& range) {
  Snapshot part;
  part.range = range;
  const auto cut = [&](const auto& values, auto& into, std::size_t width) {
    into.assign(values.begin() + width * range.first, values.begin() + width * (range.first + range.rows()));
  };
  cut(whole.position, part.position, 1);
  cut(whole.body, part.body, 1);
  part.fields = whole.fields;
  for (std::size_t f = 0; f < whole.fields.size(); ++f)
    cut(whole.fields[f].values, part.fields[f].values, whole.fields[f].components);
  return part;
}

/// Several writers, in any order, of ranges also without particles.
TEST(WriteVtu, PartsMakeTheWholeFile) {
  const test::TemporaryFolder folder;
  for (const std::size_t count : {0, 1, 2, 5, 1000, 20'000})
    for (const VtkReal real : {VtkReal::float64, VtkReal::float32}) {
      Snapshot whole = part_of(many_particles(), {0, count, count, true});
      whole.range.reset();
      write_vtu(folder / "whole.vtu", whole, real);
      for (const int writers : {1, 2, 3, 4, 7}) {
        test::put(folder / "parts.vtu.part", std::string(3'000'000, 'x'));  // of a run that was killed
        for (int w = writers - 1; w >= 0; --w)
          write_vtu(folder / "parts.vtu", part_of(whole, user_range(count, w, writers)), real);
        EXPECT_FALSE(std::filesystem::exists(folder / "parts.vtu"));
        PartFile::appear(folder / "parts.vtu");
        EXPECT_TRUE(content(folder / "parts.vtu") == content(folder / "whole.vtu")) << count << " particles, " << writers;
        std::filesystem::remove(folder / "parts.vtu");
      }
    }
}

TEST(WriteVtu, SingleIsTheNearestFloat) {
  const test::TemporaryFolder folder;
  const Snapshot snapshot = many_particles();
  write_vtu(folder / "frame.vtu", snapshot, VtkReal::float32);
  const std::string file = content(folder / "frame.vtu");
  const auto expect_close = [](const std::vector<float>& read, const std::vector<double>& written) {
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) ASSERT_LE(std::abs(read[i] - written[i]), 0x1p-24 * std::abs(written[i])) << i;
  };
  expect_close(array_in<float>(file, "Float32", "pressure"), snapshot.fields[0].values);
  expect_close(array_in<float>(file, "Float32", "velocity"), snapshot.fields[1].values);
  expect_close(array_in<float>(file, "Float32", "Points"), coordinates(snapshot));
  EXPECT_EQ(array_in<std::int32_t>(file, "Int32", "body"), snapshot.body);
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
