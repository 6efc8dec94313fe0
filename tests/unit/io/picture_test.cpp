#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <sinew/core/error.hpp>
#include <sinew/io/picture.hpp>
#include <sinew/io/picture/balls.hpp>
#include <sinew/io/picture/page.hpp>
#include <sinew/io/picture/plane_view.hpp>
#include <sinew/io/picture/scalar.hpp>
#include <sinew/io/picture/surface_normals.hpp>
#include <sinew/io/picture/ticks.hpp>
#include <unit/io/temporary_folder.hpp>

namespace sinew {
namespace {

Snapshot block(int dimension, int n) {
  Snapshot s;
  s.dimension = dimension;
  s.fields = {{"pressure", "Pa", 1, {}},
              {"displacement", "m", 3, {}},
              {"cauchy_stress", "GPa", 6, {}},
              {"von_mises_stress", "Pa", 1, {}}};
  for (int k = 0; k < (dimension == 3 ? n : 1); ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        s.position.push_back({{i * 0.1, j * 0.1, k * 0.1}});
        s.size.push_back(0.1);
        s.body.push_back(0);
        s.fields[0].values.push_back(2e6 * (i - 1));
        for (const double u : {3.0 * i, 4.0 * i, 0.0}) s.fields[1].values.push_back(u);
        for (int c = 0; c < 6; ++c) s.fields[2].values.push_back(c);
        s.fields[3].values.push_back(1e9 + i);
      }
  return s;
}

std::uint32_t big_endian(const std::string& text, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(text[at + i]);
  return value;
}

void expect_png(const std::string& png, std::uint32_t width, std::uint32_t height) {
  ASSERT_GT(png.size(), 33u);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(12, 4), "IHDR");
  EXPECT_EQ(big_endian(png, 16), width);
  EXPECT_EQ(big_endian(png, 20), height);
  EXPECT_EQ(png.substr(png.size() - 8, 4), "IEND");
}

TEST(Picture, PlaneAndSpaceAreValidPngOfTheRightSize) {
  const test::TemporaryFolder folder;
  for (const int dimension : {2, 3}) {
    PictureOptions options{.field = "pressure", .width = 640, .height = 400, .title = "a_case"};
    write_picture(folder / "a.png", block(dimension, 5), options);
    const std::string png = test::content(folder / "a.png");
    expect_png(png, 640, 400);
    options.field = "displacement";
    write_picture(folder / "b.png", block(dimension, 5), options);
    EXPECT_NE(png, test::content(folder / "b.png"));
    EXPECT_GT(png.size(), 4000u);  // a page of one color takes less than a tenth of that
  }
}

TEST(Picture, OddStatesDoNotBreakIt) {
  const test::TemporaryFolder folder;
  for (const int dimension : {2, 3}) {
    Snapshot s = block(dimension, 3);
    s.position[0][0] = std::nan("");
    s.position[1][1] = INFINITY;
    s.fields[0].values[2] = std::nan("");
    const PictureOptions options{.field = "pressure", .width = 300, .height = 900};
    EXPECT_NO_THROW(write_picture(folder / "a.png", s, options));
    for (Point& x : s.position) x = {{0.0, 0.0, 0.0}};
    for (double& size : s.size) size = 0.0;
    EXPECT_NO_THROW(write_picture(folder / "a.png", s, options));
    Snapshot none;
    none.dimension = dimension;
    none.fields = {{"pressure", "Pa", 1, {}}};
    EXPECT_NO_THROW(write_picture(folder / "a.png", none, options));
  }
}

TEST(Picture, ErrorsNameWhatIsKnown) {
  const auto message = [](const PictureOptions& options) {
    return test::message_of<CaseError>([&] { write_picture("/nonexistent/a.png", block(3, 2), options); });
  };
  EXPECT_EQ(message({.field = "presure"}),
            "picture: unknown field \"presure\". Did you mean \"pressure\"? Known fields: pressure, displacement, cauchy_stress, "
            "von_mises_stress.");
  EXPECT_NE(message({.field = "displacement", .component = "xy"}).find("Known components: x, y, z, magnitude"),
            std::string::npos);
  EXPECT_NE(message({.field = "pressure", .component = "x"}).find("is a scalar"), std::string::npos);
  EXPECT_NE(message({.field = "pressure", .width = 5}).find("width is 5 pixels"), std::string::npos);
  EXPECT_THROW(write_picture("/nonexistent/a.png", block(2, 2), {.field = "pressure"}), SimulationError);
}

TEST(Scalar, ComponentsUnitsAndRanges) {
  const Snapshot s = block(2, 4);
  const PictureScalar length = select_scalar(s, {.field = "displacement"});
  EXPECT_DOUBLE_EQ(length.values[1], 5.0);
  EXPECT_EQ(length.label, "displacement magnitude [m]");
  EXPECT_EQ(length.map, ColorMap::sequential);
  EXPECT_DOUBLE_EQ(length.low, 0.0);
  const PictureScalar yx = select_scalar(s, {.field = "cauchy_stress", .component = "yx"});
  EXPECT_DOUBLE_EQ(yx.values[0], 3.0);
  EXPECT_EQ(yx.label, "Cauchy stress xy [GPa]");
  EXPECT_EQ(yx.map, ColorMap::diverging);
  const PictureScalar pressure = select_scalar(s, {.field = "pressure"});
  EXPECT_EQ(pressure.label, "pressure [MPa]");
  EXPECT_DOUBLE_EQ(pressure.high, -pressure.low);
  EXPECT_DOUBLE_EQ(pressure.values[0], -2.0);
  const PictureScalar mises = select_scalar(s, {.field = "von_mises_stress"});
  EXPECT_EQ(mises.label, "von Mises stress [GPa]");
  EXPECT_LT(mises.low, mises.high);
  const PictureScalar clipped = select_scalar(s, {.field = "pressure", .low = -1e6, .high = 1e6});
  EXPECT_DOUBLE_EQ(clipped.low, -1.0);
  EXPECT_TRUE(clipped.below && clipped.above);
  EXPECT_FALSE(pressure.below || pressure.above);
}

TEST(Ticks, RoundNumbersInside) {
  const Ticks a = nice_ticks(0.0, 1.0, 6);
  EXPECT_EQ(a.text, (std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  const Ticks b = nice_ticks(-0.3, 0.3, 4);
  EXPECT_EQ(b.text, (std::vector<std::string>{"\u22120.2", "0.0", "0.2"}));
  EXPECT_EQ(nice_ticks(0.0, 1.0, 5).text, (std::vector<std::string>{"0.00", "0.25", "0.50", "0.75", "1.00"}));
  EXPECT_TRUE(nice_ticks(1.0, 1.0, 5).at.empty());
  for (const double low : {-1e-9, 3.0, 12345.0, -7e12})
    for (const double size : {1e-6, 0.7, 3.3, 99.0, 1e5})
      for (const int most : {2, 5, 9}) {
        const Ticks t = nice_ticks(low, low + size, most);
        EXPECT_LE(t.at.size(), static_cast<std::size_t>(most));
        const double slack = 1e-6 * size + 1e-15 * std::abs(low);
        for (const double x : t.at) EXPECT_TRUE(x >= low - slack && x <= low + size + slack);
      }
}

TEST(Ticks, UnitsThatPeopleRead) {
  EXPECT_EQ(display_unit("Pa", 2e7).name, "MPa");
  EXPECT_DOUBLE_EQ(display_unit("Pa", 2e7).factor, 1e-6);
  EXPECT_EQ(display_unit("GPa", 0.02).name, "MPa");
  EXPECT_EQ(display_unit("m", 0.02).name, "mm");
  EXPECT_EQ(display_unit("s", 5000.0).name, "s");
  EXPECT_EQ(display_unit("kg/m^3", 1100.0).name, "kg/m³");
  EXPECT_EQ(display_unit("1", 0.5).name, "");
  EXPECT_EQ(display_unit("m/s", 5e-6).name, "10⁻⁶ m/s");
  EXPECT_DOUBLE_EQ(round_down_nicely(0.34), 0.2);
  EXPECT_DOUBLE_EQ(round_down_nicely(72.0), 50.0);
}

TEST(ColorMap, EndsMiddleAndMissing) {
  EXPECT_EQ(pack_color(map_color(ColorMap::sequential, 0.0)), 0xff440154u);
  EXPECT_EQ(pack_color(map_color(ColorMap::sequential, 7.0)), 0xfffde725u);
  const Rgb middle = map_color(ColorMap::diverging, 0.5), gray = map_color(ColorMap::diverging, std::nan(""));
  EXPECT_GT(middle.red, 0.9);
  EXPECT_GT(middle.blue, 0.9);
  EXPECT_EQ(gray.red, gray.blue);
  EXPECT_GT(map_color(ColorMap::diverging, 0.0).blue, map_color(ColorMap::diverging, 0.0).red);
}

TEST(Layout, BarGoesWhereItCostsLessAndAllFits) {
  for (const double aspect : {0.1, 0.5, 1.0, 2.0, 8.0}) {
    const PageRequest request{
        .width = 1600, .height = 1000, .data_width = aspect, .left = 130, .left_if_bar_below = 130, .bottom = 80};
    const Layout layout = lay_out(request);
    EXPECT_EQ(layout.bar_below, aspect > 1.9) << aspect;
    for (const Box& box : {layout.content, layout.bar}) {
      EXPECT_GE(box.x, 0.0);
      EXPECT_GE(box.y, 0.0);
      EXPECT_LE(box.right(), 1600.0);
      EXPECT_LE(box.bottom(), 1000.0);
    }
    EXPECT_GT(std::max(layout.content.width / 1600, layout.content.height / 1000), 0.7) << aspect;
  }
}

TEST(Balls, NearestIsSeenAndNoneIsClipped) {
  const std::vector<Ball> balls{{10, 10, 5, 3}, {10, 10, 0, 6}, {30, 10, 0, 4}};
  const DepthImage image(40, 20, balls);
  EXPECT_EQ(image.ball[10 * 40 + 10], 0);
  EXPECT_EQ(image.ball[10 * 40 + 15], 1);
  EXPECT_EQ(image.ball[10 * 40 + 30], 2);
  EXPECT_EQ(image.ball[0], DepthImage::nothing);
  EXPECT_EQ(image.visible(), (std::vector<int>{0, 1, 2}));
  EXPECT_NEAR(image.depth[10 * 40 + 10], 8.0, 0.2);
}

TEST(SurfaceNormals, OutwardOnFacesNoneInside) {
  const int n = 9;
  std::vector<Point> x;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) x.push_back({{1.0 * i, 1.0 * j, 1.0 * k}});
  const std::vector<int> which{n * n * 4 + n * 4 + 4, n * n * 8 + n * 4 + 4, n * n * 4 + n * 4};
  const std::vector<Point> normals = surface_normals(x, which, 1.0);
  EXPECT_NEAR(norm(normals[0]), 0.0, 1e-12);
  EXPECT_NEAR(normals[1][2], 1.0, 0.2);  // a lattice has fewer particles off the face than a full half ball
  EXPECT_NEAR(normals[1][0], 0.0, 1e-12);
  EXPECT_NEAR(normals[2][0], -1.0, 0.2);
}

}  // namespace
}  // namespace sinew
