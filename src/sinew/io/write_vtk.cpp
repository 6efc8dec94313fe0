#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fmt/format.h>
#include <numeric>
#include <optional>
#include <sinew/core/error.hpp>
#include <sinew/io/file.hpp>
#include <sinew/io/vtk_array.hpp>
#include <sinew/io/write_vtk.hpp>
#include <stdexcept>
#include <type_traits>

namespace sinew {

namespace {

constexpr std::uint8_t vtk_vertex = 1;

template <class T>
constexpr std::string_view vtk_type = "";
template <>
constexpr std::string_view vtk_type<double> = "Float64";
template <>
constexpr std::string_view vtk_type<std::int32_t> = "Int32";
template <>
constexpr std::string_view vtk_type<std::int64_t> = "Int64";
template <>
constexpr std::string_view vtk_type<std::uint8_t> = "UInt8";

template <class T>
void write_array(PartFile& file, std::string_view name, const std::vector<T>& values, int components = 1) {
  // meshio makes a column of one-component arrays that say so, and a plain array of those that do not.
  const std::string size = components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "";
  file.write(
      fmt::format("        <DataArray type=\"{}\" Name=\"{}\"{} format=\"binary\">\n", vtk_type<T>, xml_escape(name), size));
  constexpr ArrayContent content = std::is_floating_point_v<T> ? ArrayContent::computed : ArrayContent::regular;
  file.write(encode_vtk_array(std::as_bytes(std::span(values)), content));
  file.write("\n        </DataArray>\n");
}

void check_sizes(const Snapshot& snapshot) {
  const std::size_t count = snapshot.position.size();
  if (snapshot.body.size() != count) throw std::invalid_argument("snapshot: as many bodies as positions are needed");
  for (const FieldData& field : snapshot.fields)
    if (field.values.size() != count * static_cast<std::size_t>(field.components))
      throw std::invalid_argument("snapshot: field " + field.name + " has a wrong number of values");
}

void write_point_data(PartFile& file, const Snapshot& snapshot) {
  std::vector<std::int64_t> id(snapshot.position.size());
  std::iota(id.begin(), id.end(), std::int64_t{0});
  file.write("      <PointData>\n");
  for (const FieldData& field : snapshot.fields) write_array(file, field.name, field.values, field.components);
  write_array(file, "body", std::vector<std::int32_t>(snapshot.body.begin(), snapshot.body.end()));
  write_array(file, "particle_id", id);
  file.write("      </PointData>\n");
}

void write_points(PartFile& file, const Snapshot& snapshot) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * snapshot.position.size());
  for (const Point& x : snapshot.position) coordinates.insert(coordinates.end(), x.c, x.c + 3);
  file.write("      <Points>\n");
  write_array(file, "Points", coordinates, 3);
  file.write("      </Points>\n");
}

void write_cells(PartFile& file, std::size_t count) {
  std::vector<std::int64_t> index(count);
  std::iota(index.begin(), index.end(), std::int64_t{0});
  file.write("      <Cells>\n");
  write_array(file, "connectivity", index);
  std::iota(index.begin(), index.end(), std::int64_t{1});
  write_array(file, "offsets", index);
  write_array(file, "types", std::vector<std::uint8_t>(count, vtk_vertex));
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

void write_vtu(const std::string& path, const Snapshot& snapshot) {
  check_sizes(snapshot);
  const std::size_t count = snapshot.position.size();
  PartFile file(path);
  file.write(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\" "
      "compressor=\"vtkZLibDataCompressor\">\n"
      "  <UnstructuredGrid>\n");
  file.write(
      fmt::format("    <FieldData>\n"
                  "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n"
                  "    </FieldData>\n",
                  snapshot.time));
  file.write(fmt::format("    <Piece NumberOfPoints=\"{0}\" NumberOfCells=\"{0}\">\n", count));
  write_point_data(file, snapshot);
  write_points(file, snapshot);
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
