#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <sinew/core/error.hpp>
#include <sinew/io/file.hpp>
#include <sinew/io/vtk_array.hpp>
#include <sinew/io/write_vtk.hpp>
#include <stdexcept>

namespace sinew {

namespace {

constexpr std::uint8_t vtk_vertex = 1;

template <class T>
constexpr std::string_view vtk_type = "";
template <>
constexpr std::string_view vtk_type<double> = "Float64";
template <>
constexpr std::string_view vtk_type<float> = "Float32";
template <>
constexpr std::string_view vtk_type<std::int32_t> = "Int32";
template <>
constexpr std::string_view vtk_type<std::uint8_t> = "UInt8";

/// `count` numbers in the file, which put(stream) brings as bytes.
template <class T, class Put>
void write_array(PartFile& file, std::string_view name, std::size_t count, int components, const Put& put) {
  // meshio makes a column of one-component arrays that say so, and a plain array of those that do not.
  const std::string size = components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "";
  file.write(
      fmt::format("        <DataArray type=\"{}\" Name=\"{}\"{} format=\"binary\">\n", vtk_type<T>, xml_escape(name), size));
  VtkArrayStream stream(file, count * sizeof(T));
  put(stream);
  stream.end();
  file.write("\n        </DataArray>\n");
}

/// An array of value(0), value(1), ...
template <class T, class Value>
void write_values(PartFile& file, std::string_view name, std::size_t count, const Value& value) {
  write_array<T>(file, name, count, 1, [&](VtkArrayStream& stream) { put_values<T>(stream, count, value); });
}

void write_reals(PartFile& file, std::string_view name, std::span<const double> values, int components, VtkReal real) {
  if (real == VtkReal::float64)
    write_array<double>(file, name, values.size(), components,
                        [&](VtkArrayStream& stream) { stream.put(std::as_bytes(values)); });
  else
    write_array<float>(file, name, values.size(), components, [&](VtkArrayStream& stream) {
      put_values<float>(stream, values.size(), [&](std::size_t i) { return values[i]; });
    });
}

void check_sizes(const Snapshot& snapshot) {
  const std::size_t count = snapshot.position.size();
  if (count > std::numeric_limits<std::int32_t>::max())
    throw std::invalid_argument("snapshot: more particles than Int32 can number");
  if (snapshot.body.size() != count) throw std::invalid_argument("snapshot: as many bodies as positions are needed");
  for (const FieldData& field : snapshot.fields)
    if (field.values.size() != count * static_cast<std::size_t>(field.components))
      throw std::invalid_argument("snapshot: field " + field.name + " has a wrong number of values");
}

void write_point_data(PartFile& file, const Snapshot& snapshot, VtkReal real) {
  const std::size_t count = snapshot.position.size();
  file.write("      <PointData>\n");
  for (const FieldData& field : snapshot.fields) write_reals(file, field.name, field.values, field.components, real);
  write_values<std::int32_t>(file, "body", count, [&](std::size_t i) { return snapshot.body[i]; });
  write_values<std::int32_t>(file, "particle_id", count, [](std::size_t i) { return i; });
  file.write("      </PointData>\n");
}

void write_points(PartFile& file, const std::vector<Point>& position, VtkReal real) {
  static_assert(sizeof(Point) == 3 * sizeof(double));
  const double* const first = position.empty() ? nullptr : position.front().c;
  file.write("      <Points>\n");
  write_reals(file, "Points", {first, 3 * position.size()}, 3, real);
  file.write("      </Points>\n");
}

void write_cells(PartFile& file, std::size_t count) {
  file.write("      <Cells>\n");
  write_values<std::int32_t>(file, "connectivity", count, [](std::size_t i) { return i; });
  write_values<std::int32_t>(file, "offsets", count, [](std::size_t i) { return i + 1; });
  write_values<std::uint8_t>(file, "types", count, [](std::size_t) { return vtk_vertex; });
  file.write("      </Cells>\n");
}

/// The text between `before` and the next quotation mark.
std::optional<std::string_view> attribute(std::string_view line, std::string_view before) {
  const std::size_t begin = line.find(before);
  if (begin == line.npos) return std::nullopt;
  line.remove_prefix(begin + before.size());
  const std::size_t end = line.find('"');
  if (end == line.npos) return std::nullopt;
  return line.substr(0, end);
}

}  // namespace

void write_vtu(const std::string& path, const Snapshot& snapshot, VtkReal real) {
  check_sizes(snapshot);
  const std::size_t count = snapshot.position.size();
  PartFile file(path);
  file.write(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <UnstructuredGrid>\n");
  file.write(
      fmt::format("    <FieldData>\n"
                  "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n"
                  "    </FieldData>\n",
                  snapshot.time));
  file.write(fmt::format("    <Piece NumberOfPoints=\"{0}\" NumberOfCells=\"{0}\">\n", count));
  write_point_data(file, snapshot, real);
  write_points(file, snapshot.position, real);
  write_cells(file, count);
  file.write("    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n");
  file.commit();
}

PvdSeries::PvdSeries(const std::string& path_) : path(path_) {}

PvdSeries PvdSeries::resume(const std::string& path, double keep_until) {
  const std::string content = read_text(path);
  std::string_view text = content;
  if (text.find("<VTKFile type=\"Collection\"") == text.npos)
    throw CaseError(path + " is not a series of particle files (no <VTKFile type=\"Collection\"> in it).");
  PvdSeries series(path);
  for (std::size_t at = text.find("<DataSet "); at != text.npos; at = text.find("<DataSet ", at + 1)) {
    const std::string_view element = text.substr(at, text.find("/>", at) - at);
    const auto time_text = attribute(element, "timestep=\""), file = attribute(element, "file=\"");
    double time = 0.0;
    if (!time_text || !file || std::from_chars(time_text->data(), time_text->data() + time_text->size(), time).ec != std::errc{})
      throw CaseError(path + ": a frame without a time or a file: " + std::string(element));
    if (time <= keep_until) series.frames.push_back({time, xml_unescape(*file)});
  }
  series.rewrite();
  return series;
}

void PvdSeries::add(double time, const std::string& relative_file) {
  std::erase_if(frames, [&](const Frame& frame) { return frame.file == relative_file; });
  frames.push_back({time, relative_file});
  rewrite();
}

void PvdSeries::rewrite() const {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const Frame& frame : frames)
    text += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", frame.time, xml_escape(frame.file));
  write_atomically(path, text + "  </Collection>\n</VTKFile>\n");
}

}  // namespace sinew
