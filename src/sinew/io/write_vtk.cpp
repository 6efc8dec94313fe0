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
#include <utility>

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

void check_sizes(const Snapshot& snapshot, const UserRange& range) {
  const std::size_t count = snapshot.position.size();
  if (range.total > std::numeric_limits<std::int32_t>::max())
    throw std::invalid_argument("snapshot: more particles than Int32 can number");
  if (count != range.rows()) throw std::invalid_argument("snapshot: positions of its range are needed");
  if (snapshot.body.size() != count) throw std::invalid_argument("snapshot: as many bodies as positions are needed");
  for (const FieldData& field : snapshot.fields)
    if (field.values.size() != count * static_cast<std::size_t>(field.components))
      throw std::invalid_argument("snapshot: field " + field.name + " has a wrong number of values");
}

/// Writes a file, or the part of it that belongs to the particles of a range: places follow from numbers of particles, so several can do it at once.
class VtuWriter {
 public:
  VtuWriter(PartFile& file, const Snapshot& snapshot, const UserRange& range, VtkReal real)
      : file_(file),
        snapshot_(snapshot),
        range_(range),
        real_(real) {}

  void write() {
    if (snapshot_
            .range) {  // with its whole length from the beginning, no writer takes what is behind its part for the end of the file
      measuring_ = true;
      content();
      file_.cut(std::exchange(place_, 0));
      measuring_ = false;
    }
    content();
  }

 private:
  void content() {
    text(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "  <UnstructuredGrid>\n");
    text(
        fmt::format("    <FieldData>\n"
                    "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n"
                    "    </FieldData>\n",
                    snapshot_.time));
    text(fmt::format("    <Piece NumberOfPoints=\"{0}\" NumberOfCells=\"{0}\">\n", range_.total));
    point_data();
    points();
    cells();
    text("    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n");
  }

  void text(std::string_view content) {
    file_.seek(place_);
    if (range_.leads && !measuring_) file_.write(content);
    place_ += content.size();
  }

  /// Numbers that put(stream) brings as bytes: those of the rows of the range.
  template <class T, class Put>
  void array(std::string_view name, int components, const Put& put) {
    // meshio makes a column of one-component arrays that say so, and a plain array of those that do not.
    const std::string size = components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "";
    text(fmt::format("        <DataArray type=\"{}\" Name=\"{}\"{} format=\"binary\">\n", vtk_type<T>, xml_escape(name), size));
    const std::size_t row = components * sizeof(T), bytes = range_.total * row;
    if (!measuring_) {
      VtkArrayStream stream(file_, bytes, place_, {range_.first * row, (range_.first + range_.count) * row, range_.leads});
      put(stream);
      stream.end();
    }
    place_ += VtkArrayStream::length(bytes);
    text("\n        </DataArray>\n");
  }

  /// An array of value(number of a particle).
  template <class T, class Value>
  void values(std::string_view name, const Value& value) {
    const std::size_t most = std::min(range_.count + 2, range_.total - range_.first);
    array<T>(name, 1, [&](VtkArrayStream& stream) {
      put_values<T>(stream, most, [&](std::size_t i) { return value(range_.first + i); });
    });
  }

  void reals(std::string_view name, std::span<const double> numbers, int components) {
    if (real_ == VtkReal::float64)
      array<double>(name, components, [&](VtkArrayStream& stream) { stream.put(std::as_bytes(numbers)); });
    else
      array<float>(name, components, [&](VtkArrayStream& stream) {
        put_values<float>(stream, numbers.size(), [&](std::size_t i) { return numbers[i]; });
      });
  }

  void point_data() {
    text("      <PointData>\n");
    for (const FieldData& field : snapshot_.fields) reals(field.name, field.values, field.components);
    array<std::int32_t>("body", 1, [&](VtkArrayStream& stream) {
      put_values<std::int32_t>(stream, snapshot_.body.size(), [&](std::size_t i) { return snapshot_.body[i]; });
    });
    values<std::int32_t>("particle_id", [](std::size_t i) { return i; });
    text("      </PointData>\n");
  }

  void points() {
    static_assert(sizeof(Point) == 3 * sizeof(double));
    const std::vector<Point>& position = snapshot_.position;
    const double* const first = position.empty() ? nullptr : position.front().c;
    text("      <Points>\n");
    reals("Points", {first, 3 * position.size()}, 3);
    text("      </Points>\n");
  }

  void cells() {
    text("      <Cells>\n");
    values<std::int32_t>("connectivity", [](std::size_t i) { return i; });
    values<std::int32_t>("offsets", [](std::size_t i) { return i + 1; });
    values<std::uint8_t>("types", [](std::size_t) { return vtk_vertex; });
    text("      </Cells>\n");
  }

  PartFile& file_;
  const Snapshot& snapshot_;
  const UserRange& range_;
  VtkReal real_;
  std::size_t place_ = 0;  ///< the same for all writers
  bool measuring_ = false;
};

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
  const UserRange all{0, snapshot.position.size(), snapshot.position.size(), true};
  const UserRange range = snapshot.range.value_or(all);
  check_sizes(snapshot, range);
  PartFile file(path, snapshot.range ? PartFile::Writers::several : PartFile::Writers::one);
  VtuWriter(file, snapshot, range, real).write();
  if (snapshot.range)
    file.leave();
  else
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
