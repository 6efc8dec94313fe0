#include "geometry_testing.hpp"

namespace sinew::testing {
namespace {

const std::string nodes = "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n5, 2, 0\n";                             // 6 lines
const std::string plate = nodes + "*ELEMENT, TYPE=CPS4\n10, 1, 2, 3, 4\n*ELEMENT, TYPE=CPS3\n20, 2, 5, 3\n";  // 10 lines

PointSet read(const std::string& text, int dimension = 2) {
  const TemporaryFile file("a.inp", text);
  return MeshFile{file.name(), 1.0}.generate(file.options(dimension));
}

std::string error(const std::string& text, int dimension = 2) { return TemporaryFile("a.inp", text).error<MeshFile>(dimension); }

TEST(Abaqus, EveryTypeOfThePlane) {
  for (const char* type : {"CPS3", "cpe3", "S3"}) {
    const PointSet mesh = read(nodes + "*Element, type=" + type + "\n1, 1,2,3\n");
    EXPECT_DOUBLE_EQ(total_volume(mesh), 0.5) << type;
  }
  for (const char* type : {"CPS4", "CPE4", "CPS4R", "CPE4R", "S4", "s4r"}) {
    const PointSet mesh = read(nodes + "*ELEMENT, TYPE = " + type + "\n1, 1,2,3,4\n");
    EXPECT_DOUBLE_EQ(total_volume(mesh), 1.0) << type;
  }
}

TEST(Abaqus, SolidsMayGoOnInTheNextLine) {
  const std::string cube = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1.0D+00\n6,1,0,1\n7,1,1,1\n8,0,1,1\n";
  for (const char* type : {"C3D8", "C3D8R"}) {
    const PointSet mesh = read(cube + "*ELEMENT, TYPE=" + type + "\n1, 1,2,3,4,\n5,6,7,8\n", 3);
    ASSERT_EQ(mesh.size(), 1u);
    EXPECT_NEAR(mesh.volume[0], 1.0, 1e-15);
    EXPECT_NEAR(norm(mesh.position[0] - Point{{0.5, 0.5, 0.5}}), 0.0, 1e-15);
  }
  EXPECT_NEAR(total_volume(read(cube + "*ELEMENT, TYPE=C3D4\n1, 1,2,3,6\n", 3)), 1.0 / 6.0, 1e-15);
}

TEST(Abaqus, ElementSets) {
  const PointSet mesh =
      read(plate +
           "** a comment\n*ELSET, ELSET=Left\n10,\n*ELSET, ELSET=\"the right\"\n 20\n*elset, elset=both, generate\n10, 20, 10\n"
           "*ELSET,\nELSET=all\nleft, the right, 20\n*ELSET, ELSET=LEFT\n20, 10\n");
  EXPECT_EQ(mesh.sets.size(), 4u);
  EXPECT_EQ(mesh.sets.at("Left"), (std::vector<int>{0, 1}));
  EXPECT_EQ(mesh.sets.at("the right"), (std::vector<int>{1}));
  EXPECT_EQ(mesh.sets.at("both"), (std::vector<int>{0, 1}));
  EXPECT_EQ(mesh.sets.at("all"), (std::vector<int>{0, 1}));
}

TEST(Abaqus, GenerateWithoutAStep) {
  const PointSet mesh = read(nodes + "*ELEMENT, TYPE=S3, ELSET=a\n1,1,2,3\n2,2,5,3\n3,1,3,4\n*ELSET, ELSET=b, GENERATE\n2,3\n");
  EXPECT_EQ(mesh.sets.at("a").size(), 3u);
  EXPECT_EQ(mesh.sets.at("b"), (std::vector<int>{1, 2}));
}

TEST(Abaqus, OnePartInOneInstanceAndOtherKeywords) {
  const PointSet mesh =
      read("*HEADING\n a plate, 2 elements\n*PART, NAME=p\n" + plate +
           "*NSET, NSET=foot\n1, 2\n*ELEMENT, TYPE=T2D2, ELSET=edge\n30, 1,\n 2\n*ELSET, ELSET=mixed\n10, 30\n"
           "*SOLID SECTION, ELSET=mixed, MATERIAL=m\n1.,\n*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i, PART=p\n"
           "0., 0., 0.\n*END INSTANCE\n*NODE\n1, 5, 5\n*ELSET, ELSET=one, INSTANCE=i\n20\n*END ASSEMBLY\n*STEP\n*ELEMENT "
           "OUTPUT\nS\n*NODE OUTPUT\nU\n*END STEP\n");
  EXPECT_EQ(mesh.size(), 2u);
  EXPECT_EQ(mesh.sets.size(), 2u);
  EXPECT_EQ(mesh.sets.at("mixed"), (std::vector<int>{0}));
  EXPECT_EQ(mesh.sets.at("one"), (std::vector<int>{1}));
}

TEST(Abaqus, ErrorsOfFilesAndParts) {
  EXPECT_EQ(error("*INCLUDE, INPUT=other.inp\n"), "a.inp:1:1: other files are not read (*include); put the mesh into one file.");
  EXPECT_EQ(error("*NODE, INPUT=other.inp\n"), "a.inp:1:1: other files are not read (*node); put the mesh into one file.");
  EXPECT_EQ(error("*PART, NAME=a\n*END PART\n*Part, NAME=b\n"),
            "a.inp:3:1: the file has more than one *PART; a mesh must be one part.");
  EXPECT_EQ(error("*INSTANCE\n*END INSTANCE\n*INSTANCE\n"),
            "a.inp:3:1: the file has more than one *INSTANCE; a mesh must be one part.");
  EXPECT_EQ(error("*INSTANCE\n0., 1., 0.\n"),
            "a.inp:2:1: a shifted or rotated *INSTANCE is not supported; put the part where it belongs.");
}

TEST(Abaqus, ErrorsOfNodes) {
  EXPECT_EQ(error("*NODE\n1, 0\n"), "a.inp:2:1: a node needs its number and at least two coordinates.");
  EXPECT_EQ(error("*NODE\n1, 0, o\n"), "a.inp:2:7: \"o\" is not a finite number; expected a coordinate.");
  EXPECT_EQ(error("*NODE\n1, 0, 0\n1, 0, 1\n"), "a.inp:3:1: node 1 is defined twice.");
}

TEST(Abaqus, ErrorsOfElements) {
  const auto message = [](const std::string& type, const std::string& rows, int dimension = 2) {
    return error(nodes + "*ELEMENT, TYPE=" + type + "\n" + rows + "\n", dimension);
  };
  EXPECT_EQ(message("CPS4", "1, 1,2,3"), "a.inp:8:1: this element has 3 nodes; the type CPS4 needs 4.");
  EXPECT_EQ(message("CPS3", "1, 1,2,3,4"), "a.inp:8:1: this element has 4 nodes; the type CPS3 needs 3.");
  EXPECT_EQ(message("CPS4", "1, 1,2,"), "a.inp:8:1: the file ends in the middle of element 1.");
  EXPECT_EQ(message("CPS4", "1, 1,2,\n*STEP"), "a.inp:9:1: element 1 has too few nodes for the type CPS4.");
  EXPECT_EQ(message("CPS3", "1, 1,2,8"), "a.inp:8:1: element 1 uses node 8, which is not defined.");
  EXPECT_EQ(message("CPS3", "1, 1,2,3\n1, 1,3,4"), "a.inp:9:1: element 1 is defined twice.");
  EXPECT_EQ(message("CPS3", "1, 1,2,5"), "a.inp:8:1: element 1 is degenerate: it has no area.");
  EXPECT_EQ(message("CPS3", "1, 1,2,x"), "a.inp:8:8: \"x\" is not an integer; expected the number of an element or a node.");
  EXPECT_EQ(
      message("CPS8R", "1, 1"),
      "a.inp:7:1: the element type CPS8R is not supported; use triangles (CPS3, CPE3, S3) and quadrilaterals (CPS4, CPE4, S4) of "
      "first order.");
  EXPECT_EQ(message("C3D10", "1, 1", 3),
            "a.inp:7:1: the element type C3D10 is not supported; use tetrahedra (C3D4) and hexahedra (C3D8) of first order.");
  EXPECT_EQ(message("C3D4", "1, 1"), "a.inp:7:1: the mesh has elements of 3D (C3D4), and this case is 2D.");
  EXPECT_EQ(message("CPX4", "1, 1").substr(0, 69), "a.inp:7:1: unknown element type \"cpx4\". Did you mean \"cpe4\"? Known el");
  EXPECT_EQ(error(nodes + "*ELEMENT, ELSET=a\n"), "a.inp:7:1: *ELEMENT needs a TYPE.");
}

TEST(Abaqus, ErrorsOfElementSets) {
  EXPECT_EQ(error(plate + "*ELEMENT, TYPE=T2D2\n30, 1,\n2\n*ELSET, ELSET=a\n30, 2\n"),
            "a.inp:15:1: the set \"a\" has element 2, which is not defined.");
  EXPECT_EQ(error(plate + "*ELSET\n"), "a.inp:11:1: *ELSET needs a name: *ELSET, ELSET=name.");
  EXPECT_EQ(error(plate + "*ELSET, ELSET=a\n10, 11\n"), "a.inp:12:1: the set \"a\" has element 11, which is not defined.");
  EXPECT_EQ(error(plate + "*ELSET, ELSET=a\n10, b\n"), "a.inp:12:5: the element set \"b\" is not defined.");
  EXPECT_EQ(error(plate + "*ELSET, ELSET=a, GENERATE\n10\n"),
            "a.inp:12:1: GENERATE needs the first and the last element, and a step.");
  EXPECT_EQ(error(plate + "*ELSET, ELSET=a, GENERATE\n10, 20, 0\n"),
            "a.inp:12:9: the step of GENERATE is 0; it must be greater than 0.");
  EXPECT_EQ(error(plate + "*ELSET, ELSET=a, GENERATE\n10, 20\n"),
            "a.inp:12:1: the set \"a\" has element 11, which is not defined.");
}

}  // namespace
}  // namespace sinew::testing
