#include "geometry_testing.hpp"

#include <cmath>
#include <sinew/particles/generate/mesh.hpp>

namespace sinew::testing {
namespace {

PointSet read(const std::string& name, const char* folder, int dimension, double scale = 1.0) {
  return MeshFile{name, scale}.generate({dimension, folder});
}

void expect_same(const PointSet& a, const PointSet& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a.volume[i], b.volume[i], 1e-12);
    EXPECT_NEAR(norm(a.position[i] - b.position[i]), 0.0, 1e-12);
  }
  EXPECT_EQ(a.sets, b.sets);
}

TEST(MeshFile, SquareOf444Quadrilaterals) {
  const PointSet square = read("square_444.msh", MESHES, 2);
  EXPECT_EQ(square.size(), 444u);
  EXPECT_NEAR(total_volume(square), 1.0, 1e-12);
  EXPECT_NEAR(norm(center_of_mass(square) - Point{{0.5, 0.5, 0.0}}), 0.0, 1e-12);
  EXPECT_EQ(square.sets.at("square").size(), 444u);
  EXPECT_EQ(square.spacing, 0.0);
  const auto [least, most] = std::minmax_element(square.volume.begin(), square.volume.end());
  EXPECT_GT(*most / *least, 5.0) << "irregular";
  expect_same(square, read("square_444_41.msh", MESHES, 2));
  expect_same(square, read("square_444.inp", MESHES, 2));
}

/// Two blocks of volumes 1.2 and 1.8, sheared by (0.3, 0.2) over the height 1.5; centers of mass by integration.
TEST(MeshFile, TetrahedraAndHexahedraInAllFormats) {
  for (const std::string kind : {"tetrahedra", "hexahedra"}) {
    const PointSet blocks = read(kind + "_22.msh", TEST_DATA, 3);
    EXPECT_NEAR(total_volume(blocks), 3.0, 1e-12);
    EXPECT_NEAR(norm(center_of_mass(blocks) - Point{{1.15, 0.6, 0.75}}), 0.0, 1e-12);
    double left = 0.0, right = 0.0;
    for (const int i : blocks.sets.at("left")) left += blocks.volume[i];
    for (const int i : blocks.sets.at("right")) right += blocks.volume[i];
    EXPECT_NEAR(left, 1.2, 1e-12);
    EXPECT_NEAR(right, 1.8, 1e-12);
    ASSERT_EQ(blocks.warnings.size(), 1u);
    EXPECT_EQ(blocks.warnings[0], "The physical group \"foot\" of the mesh is no set of particles: it has no elements of 3D.");
    expect_same(blocks, read(kind + "_41.msh", TEST_DATA, 3));
    expect_same(blocks, read(kind + ".inp", TEST_DATA, 3));
  }
}

TEST(MeshFile, ScaleFactor) {
  const PointSet meters = read("hexahedra.inp", TEST_DATA, 3), millimeters = read("hexahedra.inp", TEST_DATA, 3, 1000.0);
  EXPECT_NEAR(total_volume(millimeters), 3e9, 1e-3);
  EXPECT_NEAR(norm(millimeters.position[5] - 1000.0 * meters.position[5]), 0.0, 1e-9);
  const PointSet square = read("square_444.inp", MESHES, 2, 0.5);
  EXPECT_NEAR(total_volume(square), 0.25, 1e-12);
  EXPECT_EQ(error_of(MeshFile{"square_444.inp", 0.0}, {2, MESHES}), "\"scale\" is 0; it must be greater than 0.");
}

TEST(MeshFile, NoElementsOfTheDimension) {
  const std::string message = error_of(MeshFile{"square_444.msh", 1.0}, {3, MESHES});
  EXPECT_TRUE(message.ends_with("square_444.msh: the mesh has no tetrahedra or hexahedra, which a 3D case needs.")) << message;
  EXPECT_EQ(TemporaryFile("a.inp", "*NODE\n1,0,0\n").error<MeshFile>(2),
            "a.inp: the mesh has no triangles or quadrilaterals, which a 2D case needs.");
}

TEST(MeshFile, UnknownExtensionAndMissingFile) {
  EXPECT_EQ(TemporaryFile("a.vtk", "").error<MeshFile>(2), "the mesh file \"a.vtk\" must end in .msh (Gmsh) or .inp (Abaqus).");
  EXPECT_EQ(error_of(MeshFile{"none.msh", 1.0}, plane), "cannot read the file \"none.msh\".");
  EXPECT_EQ(error_of(MeshFile{"/", 1.0}, plane), "cannot read the file \"/\".");
}

/// The measure of one element whose corners are given.
ElementMeasure measure_of(int dimension, const std::vector<Point>& corners) {
  Mesh mesh;
  mesh.nodes = corners;
  MeshElement element{first_order(dimension, static_cast<int>(corners.size())), {}, 1, 1};
  for (std::size_t c = 0; c < corners.size(); ++c) element.corner[c] = static_cast<int>(c);
  return measure(mesh, element);
}

TEST(Measure, Triangle) {
  const ElementMeasure m = measure_of(2, {{{1, 1, 0}}, {{4, 1, 0}}, {{1, 3, 0}}});
  EXPECT_DOUBLE_EQ(m.volume, 3.0);
  EXPECT_NEAR(norm(m.center - Point{{2, 5.0 / 3.0, 0}}), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(measure_of(2, {{{1, 1, 0}}, {{1, 3, 0}}, {{4, 1, 0}}}).volume, -3.0);
}

/// A trapezoid with parallel sides 3 and 1 and height 2: area 4, center at height h (a + 2 b) / (3 (a + b)).
TEST(Measure, QuadrilateralIsNotTheMeanOfItsCorners) {
  const ElementMeasure m = measure_of(2, {{{-1.5, 0, 0}}, {{1.5, 0, 0}}, {{0.5, 2, 0}}, {{-0.5, 2, 0}}});
  EXPECT_DOUBLE_EQ(m.volume, 4.0);
  EXPECT_NEAR(norm(m.center - Point{{0, 2.0 * 5.0 / 12.0, 0}}), 0.0, 1e-15);
}

/// The triangle (0, 0), (1, 0), (0.5, 1) without the triangle (0, 0), (1, 0), (0.5, 0.4).
TEST(Measure, QuadrilateralWithAReflexCorner) {
  const std::vector<Point> dart{{{0, 0, 0}}, {{0.5, 0.4, 0}}, {{1, 0, 0}}, {{0.5, 1, 0}}};
  for (int turn = 0; turn < 4; ++turn) {
    const ElementMeasure m = measure_of(2, {dart[turn % 4], dart[(turn + 1) % 4], dart[(turn + 2) % 4], dart[(turn + 3) % 4]});
    EXPECT_NEAR(m.volume, 0.3, 1e-15);  // 1/2 * 1 * (1 - 0.4)
    EXPECT_NEAR(m.center[0], 0.5, 1e-15);
    EXPECT_NEAR(m.center[1], (0.5 / 3.0 - 0.2 * 0.4 / 3.0) / 0.3, 1e-15);
  }
}

TEST(Measure, Tetrahedron) {
  const ElementMeasure m = measure_of(3, {{{0, 0, 0}}, {{2, 0, 0}}, {{0, 3, 0}}, {{0, 0, 4}}});
  EXPECT_DOUBLE_EQ(m.volume, 4.0);
  EXPECT_NEAR(norm(m.center - Point{{0.5, 0.75, 1}}), 0.0, 1e-15);
}

/// A frustum with square ends of side 2 and 1 and height 3: volume h/3 (4 + 2 + 1) = 7; center h/4 (4 + 2*2*1 + 3*1)/(4 + 2 + 1).
TEST(Measure, HexahedronAsAFrustum) {
  const ElementMeasure m = measure_of(3, {{{-1, -1, 0}},
                                          {{1, -1, 0}},
                                          {{1, 1, 0}},
                                          {{-1, 1, 0}},
                                          {{-0.5, -0.5, 3}},
                                          {{0.5, -0.5, 3}},
                                          {{0.5, 0.5, 3}},
                                          {{-0.5, 0.5, 3}}});
  EXPECT_NEAR(m.volume, 7.0, 1e-14);
  EXPECT_NEAR(norm(m.center - Point{{0, 0, 3.0 / 4.0 * 11.0 / 7.0}}), 0.0, 1e-14);
}

/// A unit cube whose top has one corner lifted by 1: a bilinear top z = 1 + x y, so the volume is 5/4.
TEST(Measure, HexahedronWithAWarpedFace) {
  const ElementMeasure m =
      measure_of(3, {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 0, 1}}, {{1, 1, 2}}, {{0, 1, 1}}});
  EXPECT_NEAR(m.volume, 1.25, 1e-14);
  EXPECT_NEAR(m.center[0], m.center[1], 1e-14);
}

}  // namespace
}  // namespace sinew::testing
