#include "geometry_testing.hpp"

namespace sinew::testing {
namespace {

const std::string format_22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string format_41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string nodes_22 = "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n$EndNodes\n";
const std::string nodes_41 = "$Nodes\n1 5 1 5\n2 1 0 5\n1\n2\n3\n4\n5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n$EndNodes\n";

std::string elements(const std::string& rows, int count = 1) {
  return "$Elements\n" + std::to_string(count) + "\n" + rows + "\n$EndElements\n";
}

PointSet read(const std::string& text, int dimension = 2) {
  const TemporaryFile file("a.msh", text);
  return MeshFile{file.name(), 1.0}.generate(file.options(dimension));
}

std::string error(const std::string& text, int dimension = 2) { return TemporaryFile("a.msh", text).error<MeshFile>(dimension); }

TEST(Gmsh, GroupsOfFormat22) {
  const std::string names = "$PhysicalNames\n2\n1 1 \"edge\"\n2 7 \"a plate\"\n$EndPhysicalNames\n";
  const PointSet mesh = read(format_22 + names + nodes_22 + "$Comments\nanything 1 2 3\n$EndComments\n" +
                             elements("1 15 2 0 1 1\n2 1 2 1 1 1 2\n3 3 2 7 1 1 2 3 4\n4 2 2 8 1 2 5 3\n5 2 2 7 1 2 5 3", 5));
  ASSERT_EQ(mesh.size(), 2u) << "an element in two groups is written twice, and is one particle";
  EXPECT_DOUBLE_EQ(total_volume(mesh), 1.5);
  EXPECT_EQ(mesh.sets.size(), 2u);
  EXPECT_EQ(mesh.sets.at("a plate"), (std::vector<int>{0, 1}));
  EXPECT_EQ(mesh.sets.at("physical_8"), (std::vector<int>{1}));
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_EQ(mesh.warnings[0], "The physical group \"edge\" of the mesh is no set of particles: it has no elements of 2D.");
}

TEST(Gmsh, GroupsOfFormat41) {
  const std::string names = "$PhysicalNames\n1\n2 7 \"plate\"\n$EndPhysicalNames\n";
  const std::string entities =
      "$Entities\n1 1 2 0\n1 0 0 0 0\n1 0 0 0 1 0 0 1 7 0\n4 0 0 0 1 1 0 2 7 8 0\n5 0 0 0 1 1 0 0 0\n$EndEntities\n";
  const std::string blocks = "$Elements\n3 3 1 3\n1 1 1 1\n1 1 2\n2 4 3 1\n2 1 2 3 4\n2 5 2 1\n3 2 5 3\n$EndElements\n";
  const PointSet mesh = read(format_41 + names + entities + nodes_41 + blocks);
  ASSERT_EQ(mesh.size(), 2u);
  EXPECT_DOUBLE_EQ(mesh.volume[0], 1.0);
  EXPECT_DOUBLE_EQ(mesh.volume[1], 0.5);
  EXPECT_EQ(mesh.sets.size(), 2u);
  EXPECT_EQ(mesh.sets.at("plate"), (std::vector<int>{0}));
  EXPECT_EQ(mesh.sets.at("physical_8"), (std::vector<int>{0}));
}

TEST(Gmsh, ClockwiseElementsCountLikeOthers) {
  const PointSet mesh = read(format_22 + nodes_22 + elements("1 3 2 0 1 4 3 2 1"));
  EXPECT_DOUBLE_EQ(mesh.volume.at(0), 1.0);
  EXPECT_NEAR(norm(mesh.position[0] - Point{{0.5, 0.5, 0}}), 0.0, 1e-15);
}

TEST(Gmsh, APlaneAtAnyHeightIsAtZero) {
  const PointSet mesh = read(format_22 + "$Nodes\n3\n1 0 0 7\n2 1 0 7\n3 0 1 7\n$EndNodes\n" + elements("1 2 0 1 2 3"));
  EXPECT_EQ(mesh.position.at(0)[2], 0.0);
  EXPECT_EQ(error(format_22 + "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0.5\n$EndNodes\n" + elements("1 2 0 1 2 3")),
            "a.msh:12:1: element 1 is not in the x-y plane of a 2D case: its corners have z = 0 and z = 0.5.");
}

TEST(Gmsh, ErrorsOfTheFormat) {
  EXPECT_EQ(error(""), "a.msh: the file is empty; a Gmsh file begins with $MeshFormat.");
  EXPECT_EQ(error("solid\n"), "a.msh:1:1: expected the beginning of a section, such as $Nodes; is this a Gmsh file?");
  EXPECT_EQ(error("$Nodes\n"), "a.msh:1:1: a Gmsh file begins with $MeshFormat.");
  EXPECT_EQ(error("$MeshFormat\n4.1 1 8\n"),
            "a.msh:2:5: this is a binary Gmsh file; save it as text: \"gmsh -0 mesh.msh -format msh41 -o text.msh\", or with "
            "\"Mesh.Binary = 0;\" in the .geo file.");
  EXPECT_EQ(
      error("$MeshFormat\n4 0 8\n"),
      "a.msh:2:1: the Gmsh format 4 is not supported; save the mesh in format 4.1 or 2.2: \"gmsh -0 mesh.msh -format msh41 -o "
      "new.msh\".");
  EXPECT_EQ(error("$MeshFormat\n4.1 0 8\n$End\n"), "a.msh:3:1: expected $EndMeshFormat.");
  EXPECT_EQ(error("$MeshFormat\n4.1 0\n"), "a.msh:2:1: this line has 2 entries; at least 3 are needed.");
  EXPECT_EQ(error(format_41 + "$PartitionedEntities\n"),
            "a.msh:4:1: a mesh cut into partitions is not supported; save it without partitions.");
  EXPECT_EQ(error(format_22 + "$Other\n"), "a.msh:4:1: the file ends in the middle of a section.");
}

TEST(Gmsh, ErrorsOfNodes) {
  EXPECT_EQ(error(format_22 + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n"), "a.msh:7:1: node 1 is defined twice.");
  EXPECT_EQ(error(format_22 + "$Nodes\n1\n1 0  zero 0\n"), "a.msh:6:6: \"zero\" is not a finite number; expected a coordinate.");
  EXPECT_EQ(error(format_22 + "$Nodes\n1\n1.5 0 0 0\n"), "a.msh:6:1: \"1.5\" is not an integer; expected the number of a node.");
  EXPECT_EQ(error(format_22 + "$Nodes\n3\n1 0 0 0\n"), "a.msh:6:1: the file ends in the middle of a section.");
  EXPECT_EQ(error(format_22 + "$Nodes\n1\n1 0 0 0\n2 0 0 0\n"), "a.msh:7:1: expected $EndNodes.");
  EXPECT_EQ(error(format_41 + "$Nodes\n1 1 1 1\n2 1 0 99999999999\n1\n"), "a.msh:7:1: the file ends in the middle of a section.");
}

TEST(Gmsh, ErrorsOfElements) {
  const std::string head = format_22 + nodes_22;  // 11 lines; with $Elements and the count, the first element is in line 14
  EXPECT_EQ(error(head + elements("1 3 2 0 1 1 2 3 9")), "a.msh:14:1: element 1 uses node 9, which is not defined.");
  EXPECT_EQ(error(head + elements("1 3 2 0 1 1 2 3")),
            "a.msh:14:1: this quadrilateral has 5 entries behind the number of its tags; 2 tags and 4 nodes are needed.");
  EXPECT_EQ(error(head + elements("1 2 0 1 2 3\n1 2 0 2 5 3", 2)), "a.msh:15:1: element 1 is defined twice.");
  EXPECT_EQ(error(head + elements("1 2 0 1 2 5")), "a.msh:14:1: element 1 is degenerate: it has no area.");
  EXPECT_EQ(error(head + elements("1 2 0 1 1 1")), "a.msh:14:1: element 1 is degenerate: it has no area.");
  EXPECT_EQ(error(head + elements("1 3 0 1 2 4 3")), "a.msh:14:1: element 1 is degenerate: two of its sides cross.");
  EXPECT_EQ(
      error(head + elements("1 9 0 1 2 3 4 5 1")),
      "a.msh:14:3: the mesh has a triangle of order 2, which is not supported; use triangles and quadrilaterals of first order.");
  EXPECT_EQ(error(head + elements("1 36 0 1 2")),
            "a.msh:14:3: the element type 36 of Gmsh is not supported; save a mesh of first order (\"gmsh -order 1\").");
  EXPECT_EQ(error(head + elements("1 4 0 1 2 3 4")),
            "a.msh:14:3: the mesh has elements of 3D (a tetrahedron), and this case is 2D.");
  EXPECT_EQ(error(head + elements("1 6 0 1 2 3 4 5 5"), 3),
            "a.msh:14:3: the mesh has a prism, which is not supported; use tetrahedra and hexahedra of first order.");
  EXPECT_EQ(error(head + elements("1 4 0 1 2 3 4"), 3), "a.msh:14:1: element 1 is degenerate: it has no volume.");
}

TEST(Gmsh, ErrorsOfElementsInFormat41) {
  const std::string head = format_41 + nodes_41;  // 17 lines
  EXPECT_EQ(error(head + "$Elements\n1 1 1 1\n2 1 3 1\n1 1 2 3\n"),
            "a.msh:21:1: this quadrilateral has 4 entries; 5 are needed.");
  EXPECT_EQ(
      error(head + "$Elements\n1 1 1 1\n2 1 16 1\n"),
      "a.msh:20:5: the mesh has a quadrilateral of order 2, which is not supported; use triangles and quadrilaterals of first "
      "order.");
  EXPECT_EQ(error(format_41 + "$Entities\n0 0 1 0\n4 0 0 0 1 1 0 2 7\n"), "a.msh:6:1: this entity has too few entries.");
  EXPECT_EQ(error(format_41 + "$PhysicalNames\n1\n2 7 plate\n"),
            "a.msh:6:1: the name of a physical group must be in quotation marks.");
}

}  // namespace
}  // namespace sinew::testing
