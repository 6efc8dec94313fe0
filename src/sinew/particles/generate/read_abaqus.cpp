#include <optional>
#include <set>
#include <sinew/particles/generate/mesh.hpp>

namespace sinew {

namespace {

/// What an element type of Abaqus is. dimension 0: has no area or volume (truss, beam, mass), ignored; corners 0: not supported.
struct AbaqusType {
  int dimension = 0, corners = 0;
};

const std::map<std::string, AbaqusType> supported_types{
    {"cps3", {2, 3}},  {"cpe3", {2, 3}}, {"s3", {2, 3}},  {"s3r", {2, 3}},  {"cps4", {2, 4}}, {"cpe4", {2, 4}}, {"cps4r", {2, 4}},
    {"cpe4r", {2, 4}}, {"s4", {2, 4}},   {"s4r", {2, 4}}, {"c3d4", {3, 4}}, {"c3d8", {3, 8}}, {"c3d8r", {3, 8}}};

/// Nothing if the type is unknown.
std::optional<AbaqusType> abaqus_type(const std::string& name) {
  const auto found = supported_types.find(name);
  if (found != supported_types.end()) return found->second;
  for (const char* prefix : {"t2d", "t3d", "b2", "b3", "r2d", "mass"})
    if (name.starts_with(prefix)) return AbaqusType{};
  if (name.starts_with("c3d")) return AbaqusType{3, 0};
  for (const char* prefix : {"cps", "cpe", "s6", "s8"})
    if (name.starts_with(prefix)) return AbaqusType{2, 0};
  return std::nullopt;
}

class AbaqusReader {
 public:
  AbaqusReader(TextFile& source, int wanted_dimension) : file(source), dimension(wanted_dimension), builder(source) {}
  Mesh read();

 private:
  using Action = void (AbaqusReader::*)();

  void begin_keyword();
  void structure(const std::string& keyword);
  void begin_elements();
  void begin_element_set();
  void node_line();
  void element_line();
  void element_set_line();
  void generate_line();
  void ignored_line() {}
  void instance_line();
  void add_to_set(long long element);

  std::string parameter(const std::string& key) const;
  std::string set_name(const std::string& written);
  AbaqusType checked_type(const std::string& name) const;

  TextFile& file;
  int dimension;
  MeshBuilder builder;
  Action data_line = &AbaqusReader::ignored_line;   // what the lines below the current keyword are
  std::map<std::string, std::string> parameters;    // of the current keyword, lower-case keys
  std::map<std::string, std::string> written_name;  // of each set, by its lower-case name
  std::set<long long> ignored_elements;             // of another dimension
  std::string current_set, type_name;
  AbaqusType type;
  std::vector<long long> numbers;  // of an element whose definition may go on
  int parts = 0, instances = 0;
  bool in_assembly = false, in_instance = false;
};

Mesh AbaqusReader::read() {
  while (file.next()) {
    if (file.line().empty() || file.line().starts_with("**")) continue;
    if (file.line().front() == '*')
      begin_keyword();
    else
      (this->*data_line)();
  }
  if (!numbers.empty()) file.fail("the file ends in the middle of element " + std::to_string(numbers[0]) + ".");
  return builder.finish();
}

/// A keyword and its parameters, which go on in the next line after a comma: *ELEMENT, TYPE=CPS4, ELSET=plate
void AbaqusReader::begin_keyword() {
  if (!numbers.empty()) file.fail("element " + std::to_string(numbers[0]) + " has too few nodes for the type " + type_name + ".");
  parameters.clear();
  std::string keyword;
  for (bool more = true; more;) {
    const std::vector<std::string_view>& fields = file.fields(',');
    for (const std::string_view field : fields) {
      const std::size_t equals = field.find('=');
      const std::string key = lower_case(trimmed(field.substr(0, equals)));
      if (keyword.empty())
        keyword = key;
      else if (!key.empty())
        parameters[key] = equals == std::string_view::npos ? "" : std::string(trimmed(field.substr(equals + 1)));
    }
    more = fields.back().empty() && file.next();
  }
  data_line = &AbaqusReader::ignored_line;
  const bool loose = in_assembly && !in_instance;  // reference points and the like, numbered apart from the mesh
  if (keyword == "*include" || !parameter("input").empty())
    file.fail("other files are not read (" + keyword + "); put the mesh into one file.");
  if (keyword == "*node" && !loose) data_line = &AbaqusReader::node_line;
  if (keyword == "*element" && !loose) begin_elements();
  if (keyword == "*elset") begin_element_set();
  structure(keyword);
}

/// Parts, instances and assemblies: one of each at most.
void AbaqusReader::structure(const std::string& keyword) {
  if (keyword == "*part" && ++parts > 1) file.fail("the file has more than one *PART; a mesh must be one part.");
  if (keyword == "*instance") {
    if (++instances > 1) file.fail("the file has more than one *INSTANCE; a mesh must be one part.");
    in_instance = true;
    data_line = &AbaqusReader::instance_line;
  }
  if (keyword == "*end instance") in_instance = false;
  if (keyword == "*assembly") in_assembly = true;
  if (keyword == "*end assembly") in_assembly = false;
}

std::string AbaqusReader::parameter(const std::string& key) const {
  const auto found = parameters.find(key);
  return found == parameters.end() ? "" : found->second;
}

/// The name of a set without quotation marks, spelt as where it came first: Abaqus ignores the case.
std::string AbaqusReader::set_name(const std::string& written) {
  std::string name = written;
  std::erase(name, '"');
  return written_name.emplace(lower_case(name), name).first->second;
}

AbaqusType AbaqusReader::checked_type(const std::string& name) const {
  const std::optional<AbaqusType> found = abaqus_type(lower_case(name));
  std::vector<std::string> known;
  for (const auto& entry : supported_types) known.push_back(entry.first);
  if (name.empty()) file.fail("*ELEMENT needs a TYPE.");
  if (!found) file.fail(unknown_name_message("element type", lower_case(name), known));
  if (found->dimension > dimension) file.fail("the mesh has elements of 3D (" + name + "), and this case is 2D.");
  if (found->dimension == dimension && found->corners == 0)
    file.fail("the element type " + name + " is not supported; use " +
              (dimension == 2 ? "triangles (CPS3, CPE3, S3) and quadrilaterals (CPS4, CPE4, S4)"
                              : "tetrahedra (C3D4) and hexahedra (C3D8)") +
              " of first order.");
  return *found;
}

void AbaqusReader::begin_elements() {
  type_name = parameter("type");
  type = checked_type(type_name);
  current_set = parameters.count("elset") ? set_name(parameter("elset")) : "";
  data_line = &AbaqusReader::element_line;
}

void AbaqusReader::begin_element_set() {
  if (parameter("elset").empty()) file.fail("*ELSET needs a name: *ELSET, ELSET=name.");
  current_set = set_name(parameter("elset"));
  data_line = parameters.count("generate") ? &AbaqusReader::generate_line : &AbaqusReader::element_set_line;
}

void AbaqusReader::node_line() {
  const std::vector<std::string_view>& fields = file.fields(',');
  if (fields.size() < 3) file.fail("a node needs its number and at least two coordinates.");
  Point p;
  for (std::size_t d = 0; d < 3 && d + 1 < fields.size(); ++d)
    if (!fields[d + 1].empty()) p[static_cast<int>(d)] = file.number(fields[d + 1], "a coordinate");
  builder.add_node(file.integer(fields[0], "the number of a node"), p);
}

/// An element, which goes on in the next line after a comma.
void AbaqusReader::element_line() {
  for (const std::string_view field : file.fields(','))
    if (!field.empty()) numbers.push_back(file.integer(field, "the number of an element or a node"));
  const bool goes_on = file.line().ends_with(',');
  if (type.dimension < dimension) {
    if (goes_on) return;
    ignored_elements.insert(numbers.at(0));
    return numbers.clear();
  }
  const std::size_t wanted = 1 + static_cast<std::size_t>(type.corners);
  if (numbers.size() > wanted || (numbers.size() < wanted && !goes_on))
    file.fail("this element has " + std::to_string(numbers.size() - 1) + " nodes; the type " + type_name + " needs " +
              std::to_string(type.corners) + ".");
  if (numbers.size() < wanted) return;
  const int element = builder.add_element(first_order(type.dimension, type.corners), numbers);
  if (!current_set.empty()) builder.add_to_set(current_set, element);
  numbers.clear();
}

void AbaqusReader::add_to_set(long long number) {
  const int element = builder.element_index(number);
  if (element >= 0) return builder.add_to_set(current_set, element);
  if (!ignored_elements.count(number))
    file.fail("the set \"" + current_set + "\" has element " + std::to_string(number) + ", which is not defined.");
}

/// Numbers of elements, or names of sets.
void AbaqusReader::element_set_line() {
  for (const std::string_view field : file.fields(',')) {
    if (field.empty()) continue;
    const char first = field.front();
    if ((first >= '0' && first <= '9') || first == '-' || first == '+') {
      add_to_set(file.integer(field, "the number of an element"));
      continue;
    }
    std::string other = lower_case(field);
    std::erase(other, '"');
    const auto found = written_name.find(other);
    if (found == written_name.end() || found->second == current_set)
      file.fail(field, "the element set \"" + std::string(field) + "\" is not defined.");
    const std::vector<int> members = builder.mesh.sets[found->second];
    for (const int element : members) builder.add_to_set(current_set, element);
  }
}

/// first, last, step
void AbaqusReader::generate_line() {
  const std::vector<std::string_view>& fields = file.fields(',');
  if (fields.size() < 2) file.fail("GENERATE needs the first and the last element, and a step.");
  const long long first = file.integer(fields[0], "the first element"), last = file.integer(fields[1], "the last element");
  const long long step = fields.size() > 2 && !fields[2].empty() ? file.integer(fields[2], "a step") : 1;
  if (step <= 0) file.fail(fields[2], "the step of GENERATE is " + std::to_string(step) + "; it must be greater than 0.");
  for (long long number = first; number <= last; number += step) add_to_set(number);
}

void AbaqusReader::instance_line() {
  for (const std::string_view field : file.fields(','))
    if (!field.empty() && file.number(field, "a shift") != 0.0)
      file.fail("a shifted or rotated *INSTANCE is not supported; put the part where it belongs.");
}

}  // namespace

Mesh read_abaqus(TextFile& file, int dimension) { return AbaqusReader(file, dimension).read(); }

}  // namespace sinew
