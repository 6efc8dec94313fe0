#include "geometry_testing.hpp"

namespace sinew::testing {
namespace {

PointSet read(const std::string& text, int dimension) {
  const TemporaryFile file("cloud.csv", text);
  return PointList{file.name()}.generate(file.options(dimension));
}

std::string error(const std::string& text, int dimension = 2) {
  return TemporaryFile("cloud.csv", text).error<PointList>(dimension);
}

TEST(PointList, TheHeaderDecidesTheOrder) {
  const PointSet points = read("# a cloud\n volume , y,x\n\n0.5, 2,1\r\n0.25,4,+3e0\n", 2);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(norm(points.position[0] - Point{{1, 2, 0}}), 0.0);
  EXPECT_EQ(norm(points.position[1] - Point{{3, 4, 0}}), 0.0);
  EXPECT_EQ(points.volume, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(points.spacing, 0.0);
}

TEST(PointList, ThreeDimensionsAndAByteOrderMark) {
  const PointSet points = read("\xEF\xBB\xBFx,y,z,volume\n1,2,3,0.1", 3);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(norm(points.position[0] - Point{{1, 2, 3}}), 0.0);
}

TEST(PointList, ErrorsInTheHeader) {
  EXPECT_EQ(error("x,y,volum\n"),
            "cloud.csv:1:5: unknown column \"volum\". Did you mean \"volume\"? Known columns: x, y, z, volume.");
  EXPECT_EQ(error("x,y\n1,2\n"),
            "cloud.csv:1:1: the column \"volume\" is missing; the first line must name the columns x, y, volume.");
  EXPECT_EQ(error("x,y,volume\n", 3),
            "cloud.csv:1:1: the column \"z\" is missing; the first line must name the columns x, y, z, volume.");
  EXPECT_EQ(error("x,y,z,volume\n"), "cloud.csv:1:5: a 2D case has no column \"z\".");
  EXPECT_EQ(error("x,y,x,volume\n"), "cloud.csv:1:5: the column \"x\" is there twice.");
  EXPECT_EQ(error(""), "cloud.csv: the file is empty; its first line must name the columns.");
  EXPECT_EQ(error("x,y,volume\n"), "cloud.csv: the file has a header and no points.");
}

TEST(PointList, ErrorsInARow) {
  EXPECT_EQ(error("x,y,volume\n1,2,1\n1,2\n"), "cloud.csv:3:1: this line has 2 fields; the header has 3.");
  EXPECT_EQ(error("x,y,volume\n1, 2m,1\n"), "cloud.csv:2:4: \"2m\" is not a finite number; expected a coordinate.");
  EXPECT_EQ(error("x,y,volume\n1,,1\n"), "cloud.csv:2:3: \"\" is not a finite number; expected a coordinate.");
  EXPECT_EQ(error("x,y,volume\n1,nan,1\n"), "cloud.csv:2:3: \"nan\" is not a finite number; expected a coordinate.");
  EXPECT_EQ(error("x,y,volume\n1,2,0\n"), "cloud.csv:2:5: the volume is 0; it must be greater than 0.");
  EXPECT_EQ(error("x,y,volume\n1,2,1e999\n"), "cloud.csv:2:5: \"1e999\" is not a finite number; expected a volume.");
}

TEST(PointList, MissingFile) {
  EXPECT_EQ(error_of(PointList{"none.csv"}, GenerateOptions{2, "somewhere", Place{"case.toml", 4, 2}}),
            "case.toml:4:2: cannot read the file \"somewhere/none.csv\".");
  EXPECT_EQ(error_of(PointList{""}, plane), "\"file\" is empty; it must name a file.");
}

}  // namespace
}  // namespace sinew::testing
