#include "geometry_testing.hpp"

#include <cmath>
#include <numbers>

namespace sinew::testing {
namespace {

using std::numbers::pi;

TEST(Box, CellsFillItExactly) {
  const PointSet points = Box{{-0.5, -0.5, 0.0}, {0.5, 0.5, 6.0}, lattice(1.0 / 6.0)}.generate(space);
  EXPECT_EQ(points.size(), 6u * 6u * 36u);
  EXPECT_NEAR(total_volume(points), 6.0, 1e-12);
  EXPECT_TRUE(points.warnings.empty());
  EXPECT_DOUBLE_EQ(points.spacing, 1.0 / 6.0);
  EXPECT_NEAR(points.position[0][0], -0.5 + 1.0 / 12.0, 1e-15);
  EXPECT_NEAR(points.position[0][1], -0.5 + 1.0 / 12.0, 1e-15);
  EXPECT_NEAR(points.position[0][2], 1.0 / 12.0, 1e-15);
  EXPECT_NEAR(points.position.back()[2], 6.0 - 1.0 / 12.0, 1e-14);
}

TEST(Box, InThePlaneHasAreas) {
  const PointSet points = Box{{1, 2}, {3, 2.5}, lattice(0.25)}.generate(plane);
  EXPECT_EQ(points.size(), 16u);
  for (const double area : points.volume) EXPECT_DOUBLE_EQ(area, 0.0625);
  for (const Point& p : points.position) EXPECT_EQ(p[2], 0.0);
}

TEST(Box, AdjustsTheCellsAndSaysSo) {
  const PointSet points = Box{{0, 0}, {1, 0.9}, lattice(0.3)}.generate(plane);
  EXPECT_EQ(points.size(), 9u);
  EXPECT_NEAR(total_volume(points), 0.9, 1e-14);
  ASSERT_EQ(points.warnings.size(), 1u);
  EXPECT_EQ(points.warnings[0],
            "The spacing 0.3 does not divide the side of the box along x (1): 3 cells of 0.333333 are used there.");
  const PointSet thin = Box{{0, 0}, {0.3, 0.1}, lattice(0.3)}.generate(plane);
  ASSERT_EQ(thin.warnings.size(), 1u);
  EXPECT_EQ(thin.warnings[0], "The spacing 0.3 does not divide the side of the box along y (0.1): 1 cell of 0.1 is used there.");
  EXPECT_TRUE((Box{{0, 0}, {1, 1}, lattice(0.1 * (1 + 1e-7))}.generate(plane).warnings.empty()));
}

TEST(Box, TriangularAndFccHaveEqualVolumesThatSumToTheBox) {
  const PointSet triangular = Box{{0, 0}, {2, 1}, lattice(0.1, "triangular")}.generate(plane);
  EXPECT_NEAR(total_volume(triangular), 2.0, 1e-12);
  EXPECT_EQ(triangular.size(), 240u);  // 12 rows (1 / 0.0866 = 11.5) of 20
  const PointSet fcc = Box{{0, 0, 0}, {1, 1, 1}, lattice(0.1 * std::sqrt(2.0), "fcc")}.generate(space);
  EXPECT_EQ(fcc.size(), 500u);  // 5 x 5 x 5 cells of 4
  for (const double v : fcc.volume) EXPECT_NEAR(v, 0.002, 1e-15);
  for (const Point& p : fcc.position)
    for (int d = 0; d < 3; ++d) EXPECT_TRUE(p[d] > 0.0 && p[d] < 1.0);
  EXPECT_TRUE(fcc.warnings.empty());
}

TEST(Box, OnFaces) {
  const PointSet points = Box{{0, 0, 0}, {1, 1, 2}, lattice(0.5), true}.generate(space);
  EXPECT_EQ(points.size(), 3u * 3u * 5u);
  EXPECT_NEAR(total_volume(points), 2.0, 1e-14);
  EXPECT_NEAR(norm(points.position.front()), 0.0, 1e-15);
  EXPECT_NEAR(norm(points.position.back() - Point{{1, 1, 2}}), 0.0, 1e-14);
  EXPECT_DOUBLE_EQ(points.volume.front(), 0.125 / 8.0);
  EXPECT_DOUBLE_EQ(points.volume[1], 0.125 / 4.0);
  EXPECT_DOUBLE_EQ(points.volume[4], 0.125 / 2.0);
  EXPECT_DOUBLE_EQ(points.volume[13], 0.125);
  LatticeParams moved = lattice(0.1);
  moved.jitter = 0.3;
  const PointSet jittered = Box{{0, 0}, {1, 1}, moved, true}.generate(plane);
  EXPECT_NEAR(total_volume(jittered), 1.0, 1e-12);
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(jittered.position[i][1], 0.0, 1e-15) << "stays on its face";
  EXPECT_NE(jittered.position[1][0], 0.1);
  EXPECT_EQ(error_of(Box{{0, 0}, {1, 1}, lattice(0.1, "triangular"), true}, plane),
            "\"on_faces\" is for square and cubic lattices, not for \"triangular\".");
}

TEST(Box, ErrorsNameTheKey) {
  EXPECT_EQ(error_of(Box{{0, 0}, {1, 1, 1}, lattice(0.1)}, space), "\"low\" has 2 coordinates; in 3D it needs 3.");
  EXPECT_EQ(error_of(Box{{0, 0}, {1, 1, 1}, lattice(0.1)}, plane), "\"high\" has 3 coordinates; in 2D it needs 2.");
  EXPECT_EQ(error_of(Box{{0, 2}, {1, 1}, lattice(0.1)}, plane),
            "\"low\" of the box must be below \"high\" along y: 2 is not below 1.");
  EXPECT_EQ(error_of(Box{{0, NAN}, {1, 1}, lattice(0.1)}, plane), "\"low\" has a coordinate that is not a finite number.");
}

TEST(Box, ErrorsBeginWithThePlace) {
  const GenerateOptions options{2, "", Place{"case.toml", 10, 3}};
  EXPECT_EQ(error_of(Box{{0, 0}, {0, 1}, lattice(0.1)}, options),
            "case.toml:10:3: \"low\" of the box must be below \"high\" along x: 0 is not below 0.");
}

TEST(Sphere, BallAndDiskHaveTheirExactVolumeAboutTheirCenter) {
  for (const char* name : {"cubic", "fcc"}) {
    const PointSet ball = Sphere{{1, 2, 3}, 0.5, 0.0, lattice(0.07, name)}.generate(space);
    EXPECT_NEAR(total_volume(ball), 4.0 / 3.0 * pi * 0.125, 1e-12);
    EXPECT_NEAR(norm(center_of_mass(ball) - Point{{1, 2, 3}}), 0.0, 1e-12) << name;
    for (const Point& p : ball.position) EXPECT_LT(norm(p - Point{{1, 2, 3}}), 0.5);
    EXPECT_TRUE(ball.warnings.empty()) << name;
  }
  for (const char* name : {"square", "triangular"}) {
    const PointSet disk = Sphere{{1, 2}, 0.5, 0.2, lattice(0.02, name)}.generate(plane);
    EXPECT_NEAR(total_volume(disk), pi * (0.25 - 0.04), 1e-12);
    EXPECT_NEAR(norm(center_of_mass(disk) - Point{{1, 2, 0}}), 0.0, 1e-12) << name;
    for (const Point& p : disk.position) EXPECT_GT(norm(p - Point{{1, 2, 0}}), 0.2);
    EXPECT_TRUE(disk.warnings.empty()) << name;
  }
}

/// Points of the square lattice at (i + 1/2, j + 1/2) within radius 2: 12, whose cells have 12 of 4 pi.
TEST(Sphere, CountsInAKnownDisk) {
  const PointSet disk = Sphere{{0, 0}, 2.0, 0.0, lattice(1.0)}.generate(plane);
  EXPECT_EQ(disk.size(), 12u);
  EXPECT_NEAR(disk.volume[0], 4.0 * pi / 12.0, 1e-14);
  // 1, 6, 6 and 6 points of the triangular lattice at 0, 1, sqrt(3) and 2, where the last are on the circle
  EXPECT_EQ((Sphere{{0, 0}, 2.0, 0.0, lattice(1.0, "triangular")}.generate(plane).size()), 13u);
  EXPECT_EQ((Sphere{{0, 0}, 2.01, 0.0, lattice(1.0, "triangular")}.generate(plane).size()), 19u);
  // 1 and 12 points of fcc at 0 and 1
  EXPECT_EQ((Sphere{{0, 0, 0}, 1.1, 0.0, lattice(1.0, "fcc")}.generate(space).size()), 13u);
}

TEST(Sphere, CoarseOnesWarn) {
  const PointSet disk = Sphere{{0, 0}, 0.5, 0.0, lattice(1.0)}.generate(plane);
  EXPECT_EQ(disk.size(), 1u);
  ASSERT_EQ(disk.warnings.size(), 1u);
  EXPECT_EQ(
      disk.warnings[0],
      "The 1 lattice cells of the \"sphere\" have 127.324 % of its exact volume; their volumes were multiplied by 0.785398. "
      "A smaller spacing follows the shape better.");
}

TEST(Sphere, Errors) {
  EXPECT_EQ(error_of(Sphere{{0, 0}, 1.0, 1.0, lattice(0.1)}, plane), "\"inner_radius\" is 1; it must be below \"radius\", 1.");
  EXPECT_EQ(error_of(Sphere{{0, 0}, 1.0, 0.99, lattice(1.5)}, plane),
            "no particle of the \"sphere\" is inside it: the spacing is too large for its size.");
}

TEST(Annulus, ExactAreaBetweenTheCircles) {
  const PointSet ring = Annulus{{0.5, 0}, 0.3, 0.4, lattice(0.01)}.generate(plane);
  EXPECT_NEAR(total_volume(ring), pi * (0.16 - 0.09), 1e-12);
  for (const Point& p : ring.position) {
    const double r = norm(p - Point{{0.5, 0, 0}});
    EXPECT_TRUE(r > 0.3 && r < 0.4);
  }
  EXPECT_EQ(
      error_of(Annulus{{0, 0, 0}, 1, 2, lattice(0.1)}, space),
      "the shape \"annulus\" exists in 2D only, and this case is 3D. Use \"cylinder\" with an \"inner_radius\" for a tube.");
  EXPECT_EQ(error_of(Annulus{{0, 0}, 2, 1, lattice(0.1)}, plane), "\"inner_radius\" is 2; it must be below \"outer_radius\", 1.");
}

TEST(Cylinder, AlongAnAxis) {
  const PointSet tube = Cylinder{{0, 0, 1}, {0, 0, 3}, 0.5, 0.2, lattice(0.05)}.generate(space);
  EXPECT_NEAR(total_volume(tube), pi * (0.25 - 0.04) * 2.0, 1e-12);
  EXPECT_NEAR(norm(center_of_mass(tube) - Point{{0, 0, 2}}), 0.0, 1e-12);
  double lowest = 9.0;
  for (const Point& p : tube.position) {
    const double r = std::hypot(p[0], p[1]);
    EXPECT_TRUE(r > 0.2 && r < 0.5);
    lowest = std::min(lowest, p[2]);
  }
  EXPECT_NEAR(lowest, 1.025, 1e-12);
  EXPECT_TRUE(tube.warnings.empty());
}

TEST(Cylinder, AlongAnyDirection) {
  const Point start{{0.1, 0.2, 0.3}}, end{{1.1, 1.2, 0.8}};
  const PointSet rod = Cylinder{{0.1, 0.2, 0.3}, {1.1, 1.2, 0.8}, 0.3, 0.0, lattice(0.04)}.generate(space);
  EXPECT_NEAR(total_volume(rod), pi * 0.09 * 1.5, 1e-12);
  EXPECT_NEAR(norm(center_of_mass(rod) - 0.5 * (start + end)), 0.0, 0.01);
  EXPECT_NEAR(rod.volume[0], 0.04 * 0.04 * 0.04, 0.05 * 0.04 * 0.04 * 0.04);
  const PointSet back = Cylinder{{1.1, 1.2, 0.8}, {0.1, 0.2, 0.3}, 0.3, 0.0, lattice(0.04)}.generate(space);
  EXPECT_EQ(back.size(), rod.size());
}

TEST(Cylinder, Errors) {
  EXPECT_EQ(error_of(Cylinder{{0, 0}, {0, 1}, 1, 0, lattice(0.1)}, plane),
            "the shape \"cylinder\" exists in 3D only, and this case is 2D. Use \"sphere\" for a disk, \"annulus\" for a ring or "
            "\"box\" "
            "for a cut along the axis.");
  EXPECT_EQ(error_of(Cylinder{{0, 0, 1}, {0, 0, 1}, 1, 0, lattice(0.1)}, space),
            "\"from\" and \"to\" of the cylinder are the same point; they are the centers of its ends.");
  EXPECT_EQ(error_of(Cylinder{{0, 0, 1}, {0, 0, 2}, 1, 2, lattice(0.1)}, space),
            "\"inner_radius\" is 2; it must be below \"radius\", 1.");
}

TEST(Polygon, LShapeFilledByItsCells) {
  const PointSet shape = Polygon{{0, 0, 2, 0, 2, 1, 1, 1, 1, 3, 0, 3}, lattice(0.1)}.generate(plane);
  EXPECT_EQ(shape.size(), 400u);
  EXPECT_NEAR(total_volume(shape), 4.0, 1e-12);
  EXPECT_NEAR(shape.volume[0], 0.01, 1e-15);
  for (const Point& p : shape.position) EXPECT_TRUE(p[0] < 1.0 || p[1] < 1.0);
}

/// Cell centers on the long side of a triangle are on its edge: outside, whatever the rounding.
TEST(Polygon, PointsOnAnEdgeAreOutside) {
  for (const double shift : {0.0, 0.1, 1.0 / 3.0}) {
    const PointSet shape = Polygon{{shift, 0, shift + 1, 0, shift, 1}, lattice(0.1)}.generate(plane);
    EXPECT_EQ(shape.size(), 45u) << shift;
    EXPECT_NEAR(total_volume(shape), 0.5, 1e-12);
  }
  EXPECT_EQ((Polygon{{0, 0, 0, 1, 1, 0}, lattice(0.1)}.generate(plane).size()), 45u) << "clockwise";
  EXPECT_EQ((Polygon{{1, 1, 0, 1, 1, 0}, lattice(0.1)}.generate(plane).size()), 45u) << "the other side of the edge";
}

TEST(Polygon, Errors) {
  const auto message = [](std::vector<double> points) { return error_of(Polygon{std::move(points), lattice(0.1)}, plane); };
  EXPECT_EQ(message({0, 0, 1}), "\"points\" has 3 numbers; it needs an x and a y for every vertex.");
  EXPECT_EQ(message({0, 0, 1, 1}), "\"points\" has 2 vertices; a polygon needs at least 3.");
  EXPECT_EQ(message({0, 0, 1, 1, 1, 0, 0, 1}), "the polygon crosses itself: its edges 1-2 and 3-4 meet.");
  EXPECT_EQ(message({0, 0, 2, 0, 2, 1, 1, 0, 0, 1}), "the polygon crosses itself: its edges 1-2 and 3-4 meet.");
  EXPECT_EQ(message({0, 0, 1, 0, 1, 1, 0, 0}), "vertices 4 and 1 of the polygon are the same point; it closes by itself.");
  EXPECT_EQ(message({0, 0, 2, 0, 1, 0}), "the polygon turns back on itself at vertex 2.");
  EXPECT_EQ(message({0, 0, 1, 0, INFINITY, 1}), "\"points\" has a coordinate that is not a finite number.");
  EXPECT_EQ(error_of(Polygon{{0, 0, 1, 0, 0, 1}, lattice(0.1)}, space),
            "the shape \"polygon\" exists in 2D only, and this case is 3D. Use \"box\", \"cylinder\", \"sphere\" or \"mesh\".");
  EXPECT_EQ(error_of(Polygon{{0, 0, 1, 0, 0, 1}, lattice(9.0)}, plane),
            "no particle of the \"polygon\" is inside it: the spacing is too large for its size.");
}

}  // namespace
}  // namespace sinew::testing
