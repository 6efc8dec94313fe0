#include <sinew/particles/generate/point_list.hpp>

#include <algorithm>
#include <array>
#include <sinew/particles/generate/text_file.hpp>

namespace sinew {

namespace {

/// Goes to the next line that is neither blank nor a comment.
bool next_row(TextFile& file) {
  while (file.next())
    if (!file.line().empty() && file.line().front() != '#') return true;
  return false;
}

/// For each column of the file its place in x, y, z, volume.
std::vector<int> read_header(TextFile& file, int dimension) {
  std::vector<std::string> known{"x", "y", "z", "volume"};
  std::vector<int> columns;
  for (const std::string_view field : file.fields(',')) {
    const auto found = std::find(known.begin(), known.end(), field);
    if (found == known.end()) file.fail(field, unknown_name_message("column", field, known));
    const int which = static_cast<int>(found - known.begin());
    if (which == 2 && dimension == 2) file.fail(field, "a 2D case has no column \"z\".");
    if (std::count(columns.begin(), columns.end(), which)) file.fail(field, "the column \"" + *found + "\" is there twice.");
    columns.push_back(which);
  }
  for (int which = 0; which < 4; ++which)
    if (!std::count(columns.begin(), columns.end(), which) && !(which == 2 && dimension == 2))
      file.fail("the column \"" + known[which] + "\" is missing; the first line must name the columns " +
                (dimension == 2 ? "x, y, volume." : "x, y, z, volume."));
  return columns;
}

}  // namespace

PointSet PointList::generate(const GenerateOptions& options) const {
  TextFile source(file, options);
  if (!next_row(source)) throw CaseError(Place{source.path()}, "the file is empty; its first line must name the columns.");
  const std::vector<int> columns = read_header(source, options.dimension);
  PointSet points;
  while (next_row(source)) {
    const std::vector<std::string_view>& fields = source.fields(',');
    if (fields.size() != columns.size())
      source.fail("this line has " + std::to_string(fields.size()) + " fields; the header has " + std::to_string(columns.size()) +
                  ".");
    std::array<double, 4> value{};
    for (std::size_t i = 0; i < fields.size(); ++i) {
      value[columns[i]] = source.number(fields[i], columns[i] == 3 ? "a volume" : "a coordinate");
      if (columns[i] == 3 && !(value[3] > 0.0))
        source.fail(fields[i], "the volume is " + std::string(fields[i]) + "; it must be greater than 0.");
    }
    points.position.push_back({{value[0], value[1], value[2]}});
    points.volume.push_back(value[3]);
  }
  if (points.size() == 0) throw CaseError(Place{source.path()}, "the file has a header and no points.");
  return points;
}

}  // namespace sinew
