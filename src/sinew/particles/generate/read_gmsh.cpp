#include <algorithm>
#include <cstdlib>
#include <sinew/particles/generate/mesh.hpp>
#include <unordered_map>
#include <utility>

namespace sinew {

namespace {

/// Element types of Gmsh, by number (reference manual, "MSH file format").
struct GmshType {
  int dimension, nodes;
  bool supported;
  const char* name;
};

const GmshType* gmsh_type(long long number) {
  static const std::map<long long, GmshType> types{{1, {1, 2, false, "line"}},
                                                   {2, {2, 3, true, "triangle"}},
                                                   {3, {2, 4, true, "quadrilateral"}},
                                                   {4, {3, 4, true, "tetrahedron"}},
                                                   {5, {3, 8, true, "hexahedron"}},
                                                   {6, {3, 6, false, "prism"}},
                                                   {7, {3, 5, false, "pyramid"}},
                                                   {8, {1, 3, false, "line of order 2"}},
                                                   {9, {2, 6, false, "triangle of order 2"}},
                                                   {10, {2, 9, false, "quadrilateral of order 2"}},
                                                   {11, {3, 10, false, "tetrahedron of order 2"}},
                                                   {12, {3, 27, false, "hexahedron of order 2"}},
                                                   {13, {3, 18, false, "prism of order 2"}},
                                                   {14, {3, 14, false, "pyramid of order 2"}},
                                                   {15, {0, 1, false, "point"}},
                                                   {16, {2, 8, false, "quadrilateral of order 2"}},
                                                   {17, {3, 20, false, "hexahedron of order 2"}},
                                                   {18, {3, 15, false, "prism of order 2"}},
                                                   {19, {3, 13, false, "pyramid of order 2"}}};
  const auto found = types.find(number);
  return found == types.end() ? nullptr : &found->second;
}

class GmshReader {
 public:
  GmshReader(TextFile& source, int wanted_dimension) : file(source), dimension(wanted_dimension), builder(source) {}
  Mesh read();

 private:
  void read_section(const std::string& section);
  void read_format();
  void read_names();
  void read_entities();
  void read_nodes_2();
  void read_nodes_4();
  void read_elements_2();
  void read_elements_4();

  const std::vector<std::string_view>& row(std::size_t least);
  long long count(std::size_t word) { return file.integer(words->at(word), "a count or a tag"); }
  void end_section(const std::string& section);
  void skip_section(const std::string& section);
  const GmshType& type_of(long long number, std::string_view word) const;
  std::string group_name(int group) const;
  void add_element_once(const GmshType& type, const std::vector<long long>& numbers, int group);
  void warn_about_empty_groups();

  TextFile& file;
  int dimension;
  MeshBuilder builder;
  const std::vector<std::string_view>* words = nullptr;  // of the current line
  std::string version;
  std::map<std::pair<int, int>, std::string> names;        // of physical groups, by dimension and number
  std::unordered_map<long long, std::vector<int>> groups;  // physical groups of each entity of the dimension of the case
  std::map<std::array<long long, 9>, int>
      element_with;  // by type and corners: format 2.2 repeats an element for each of its groups
};

Mesh GmshReader::read() {
  while (file.next()) {
    if (file.line().empty()) continue;
    if (file.line().front() != '$') file.fail("expected the beginning of a section, such as $Nodes; is this a Gmsh file?");
    const std::string section(file.line().substr(1));
    if (version.empty() && section != "MeshFormat") file.fail("a Gmsh file begins with $MeshFormat.");
    read_section(section);
  }
  if (version.empty()) throw CaseError(Place{file.path()}, "the file is empty; a Gmsh file begins with $MeshFormat.");
  warn_about_empty_groups();
  return builder.finish();
}

void GmshReader::read_section(const std::string& section) {
  const bool old = version == "2.2";
  if (section == "MeshFormat")
    read_format();
  else if (section == "PhysicalNames")
    read_names();
  else if (section == "Entities")
    read_entities();
  else if (section == "PartitionedEntities")
    file.fail("a mesh cut into partitions is not supported; save it without partitions.");
  else if (section == "Nodes")
    old ? read_nodes_2() : read_nodes_4();
  else if (section == "Elements")
    old ? read_elements_2() : read_elements_4();
  else
    return skip_section(section);
  end_section(section);
}

/// The words of the next line that is not blank. CaseError if there are fewer than `least`.
const std::vector<std::string_view>& GmshReader::row(std::size_t least) {
  do {
    if (!file.next()) file.fail("the file ends in the middle of a section.");
  } while (file.line().empty());
  words = &file.words();
  if (words->size() < least)
    file.fail("this line has " + std::to_string(words->size()) + " entries; at least " + std::to_string(least) + " are needed.");
  return *words;
}

void GmshReader::end_section(const std::string& section) {
  row(1);
  if (file.line() != "$End" + section) file.fail("expected $End" + section + ".");
}

void GmshReader::skip_section(const std::string& section) {
  const std::string end = "$End" + section;
  do row(1);
  while (file.line() != end);
}

void GmshReader::read_format() {
  row(3);
  version = (*words)[0];
  if ((*words)[1] != "0")
    file.fail((*words)[1],
              "this is a binary Gmsh file; save it as text: \"gmsh -0 mesh.msh -format msh41 -o text.msh\", or with "
              "\"Mesh.Binary = 0;\" in the .geo file.");
  if (version == "2" || version == "2.1") version = "2.2";
  if (version != "2.2" && version != "4.1")
    file.fail((*words)[0], "the Gmsh format " + version +
                               " is not supported; save the mesh in format 4.1 or 2.2: \"gmsh -0 mesh.msh "
                               "-format msh41 -o new.msh\".");
}

void GmshReader::read_names() {
  row(1);
  for (long long n = count(0); n > 0; --n) {
    row(3);
    const int group_dimension = static_cast<int>(count(0)), group = static_cast<int>(count(1));
    const std::string_view line = file.line();
    const std::size_t first = line.find('"'), last = line.rfind('"');
    if (first == last) file.fail("the name of a physical group must be in quotation marks.");
    names[{group_dimension, group}] = line.substr(first + 1, last - first - 1);
  }
}

void GmshReader::read_entities() {
  row(4);
  const std::array<long long, 4> counts{count(0), count(1), count(2), count(3)};
  for (int d = 0; d < 4; ++d)
    for (long long n = 0; n < counts[d]; ++n) {
      const std::size_t at = d == 0 ? 4 : 7;  // behind the tag and the coordinates of the point or of the bounding box
      row(at + 1);
      const long long group_count = count(at);
      if (group_count < 0 || words->size() < at + 1 + static_cast<std::size_t>(group_count))
        file.fail("this entity has too few entries.");
      if (d != dimension) continue;
      for (long long g = 1; g <= group_count; ++g) groups[count(0)].push_back(static_cast<int>(std::abs(count(at + g))));
    }
}

void GmshReader::read_nodes_2() {
  row(1);
  for (long long n = count(0); n > 0; --n) {
    row(4);
    const long long tag = file.integer((*words)[0], "the number of a node");
    Point p;
    for (int d = 0; d < 3; ++d) p[d] = file.number((*words)[1 + d], "a coordinate");
    builder.add_node(tag, p);
  }
}

void GmshReader::read_nodes_4() {
  row(4);
  for (long long block = count(0); block > 0; --block) {
    row(4);
    std::vector<long long> tags;
    for (long long n = count(3); n > 0; --n) {
      row(1);
      tags.push_back(file.integer((*words)[0], "the number of a node"));
    }
    for (const long long tag : tags) {
      row(3);
      Point p;
      for (int d = 0; d < 3; ++d) p[d] = file.number((*words)[d], "a coordinate");
      builder.add_node(tag, p);
    }
  }
}

/// CaseError if elements of that type cannot be used; those of lower dimension than the case are fine, and ignored.
const GmshType& GmshReader::type_of(long long number, std::string_view word) const {
  const GmshType* const type = gmsh_type(number);
  if (!type)
    file.fail(word, "the element type " + std::to_string(number) +
                        " of Gmsh is not supported; save a mesh of first order (\"gmsh -order 1\").");
  if (type->dimension > dimension)
    file.fail(word, "the mesh has elements of 3D (a " + std::string(type->name) + "), and this case is 2D.");
  if (type->dimension == dimension && !type->supported)
    file.fail(word, "the mesh has a " + std::string(type->name) + ", which is not supported; use " +
                        (dimension == 2 ? "triangles and quadrilaterals" : "tetrahedra and hexahedra") + " of first order.");
  return *type;
}

void GmshReader::read_elements_2() {
  row(1);
  std::vector<long long> numbers;
  for (long long n = count(0); n > 0; --n) {
    row(3);
    const GmshType& type = type_of(count(1), (*words)[1]);
    if (type.dimension < dimension) continue;
    const long long entries = static_cast<long long>(words->size()), tags = count(2);
    if (tags != entries - 3 - type.nodes)
      file.fail("this " + std::string(type.name) + " has " + std::to_string(entries - 3) +
                " entries behind the number of its tags; " + std::to_string(tags) + " tags and " + std::to_string(type.nodes) +
                " nodes are needed.");
    numbers.assign(1, file.integer((*words)[0], "the number of an element"));
    for (int c = 0; c < type.nodes; ++c) numbers.push_back(file.integer((*words)[3 + tags + c], "the number of a node"));
    add_element_once(type, numbers, tags > 0 ? static_cast<int>(std::abs(count(3))) : 0);
  }
}

void GmshReader::add_element_once(const GmshType& type, const std::vector<long long>& numbers, int group) {
  std::array<long long, 9> key{};
  key[0] = type.nodes;
  std::copy(numbers.begin() + 1, numbers.end(), key.begin() + 1);
  const auto [found, is_new] = element_with.emplace(key, 0);
  if (is_new) found->second = builder.add_element(first_order(type.dimension, type.nodes), numbers);
  if (group != 0) builder.add_to_set(group_name(group), found->second);
}

void GmshReader::read_elements_4() {
  row(4);
  std::vector<long long> numbers;
  for (long long block = count(0); block > 0; --block) {
    row(4);
    const GmshType& type = type_of(count(2), (*words)[2]);
    const auto entity_groups = groups.find(count(1));
    for (long long n = count(3); n > 0; --n) {
      row(1);
      if (type.dimension < dimension) continue;
      if (words->size() != 1 + static_cast<std::size_t>(type.nodes))
        file.fail("this " + std::string(type.name) + " has " + std::to_string(words->size()) + " entries; " +
                  std::to_string(1 + type.nodes) + " are needed.");
      numbers.clear();
      for (const std::string_view word : *words) numbers.push_back(file.integer(word, "the number of an element or a node"));
      const int element = builder.add_element(first_order(type.dimension, type.nodes), numbers);
      if (entity_groups == groups.end()) continue;
      for (const int group : entity_groups->second) builder.add_to_set(group_name(group), element);
    }
  }
}

std::string GmshReader::group_name(int group) const {
  const auto found = names.find({dimension, group});
  return found == names.end() ? "physical_" + std::to_string(group) : found->second;
}

void GmshReader::warn_about_empty_groups() {
  for (const auto& [key, name] : names)
    if (!builder.mesh.sets.count(name))
      builder.mesh.warnings.push_back("The physical group \"" + name +
                                      "\" of the mesh is no set of particles: it has no elements of " +
                                      std::to_string(dimension) + "D.");
}

}  // namespace

Mesh read_gmsh(TextFile& file, int dimension) { return GmshReader(file, dimension).read(); }

}  // namespace sinew
