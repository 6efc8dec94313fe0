#include <algorithm>
#include <cmath>
#include <limits>
#include <sinew/io/picture/page.hpp>
#include <sinew/io/picture/plane_view.hpp>

namespace sinew {

namespace {

using namespace page_style;

constexpr int fineness = 3;  ///< samples per pixel and direction
constexpr double axis_left = 132, axis_bottom = 84;
constexpr double edge_share = 0.16;     ///< how much darker the rim of a large particle is
constexpr double edge_from_pixels = 9;  ///< particles of that size and larger get a rim
constexpr double least_half = 0.3;      ///< pixels: thinner particles are drawn that thick, so that none is lost
constexpr double seam = 0.3;            ///< pixels by which each side of a particle is moved outwards
constexpr double free_share = 0.04;     ///< free rim around the particles, of their larger extent

/// A particle's area: the parallelogram center + a e1 + b e2, a and b in [-1, 1].
struct Cell {
  double x, y, e1x, e1y, e2x, e2y;
};

struct Extent {
  double low_x = 0.0, low_y = 0.0, high_x = 1.0, high_y = 1.0;
  double width() const { return high_x - low_x; }
  double height() const { return high_y - low_y; }
};

/// Rows of F if the snapshot has the deformation gradient.
const FieldData* deformation_gradient(const Snapshot& snapshot) {
  for (const FieldData& field : snapshot.fields)
    if (field.name == "deformation_gradient" && field.components == 9) return &field;
  return nullptr;
}

/// The square of each particle, carried along by F where it is known. Particles without a finite place are left out (size 0).
std::vector<Cell> make_cells(const Snapshot& snapshot) {
  const FieldData* gradient = deformation_gradient(snapshot);
  std::vector<Cell> cells(snapshot.position.size(), Cell{});
  for (std::size_t p = 0; p < cells.size(); ++p) {
    const Point& x = snapshot.position[p];
    if (!std::isfinite(x[0]) || !std::isfinite(x[1])) continue;
    const double half = 0.5 * snapshot.size[p];
    cells[p] = {x[0], x[1], half, 0.0, 0.0, half};
    if (!gradient) continue;
    const double* f = gradient->values.data() + 9 * p;
    if (std::isfinite(f[0] + f[1] + f[3] + f[4])) cells[p] = {x[0], x[1], half * f[0], half * f[3], half * f[1], half * f[4]};
  }
  return cells;
}

Extent extent_of(const std::vector<Cell>& cells) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Extent e{infinity, infinity, -infinity, -infinity};
  for (const Cell& c : cells) {
    const double rx = std::abs(c.e1x) + std::abs(c.e2x), ry = std::abs(c.e1y) + std::abs(c.e2y);
    if (rx + ry == 0.0) continue;
    e = {std::min(e.low_x, c.x - rx), std::min(e.low_y, c.y - ry), std::max(e.high_x, c.x + rx), std::max(e.high_y, c.y + ry)};
  }
  if (!(e.high_x > e.low_x && e.high_y > e.low_y)) return {};
  const double rim = free_share * std::max(e.width(), e.height());
  return {e.low_x - rim, e.low_y - rim, e.high_x + rim, e.high_y + rim};
}

/// The part of the plane that a frame of that shape shows: the extent, widened about its middle.
Extent fill_frame(const Extent& e, const Box& frame) {
  const double scale = std::min(frame.width / e.width(), frame.height / e.height());
  const double x = 0.5 * (e.low_x + e.high_x), y = 0.5 * (e.low_y + e.high_y);
  const double half_width = 0.5 * frame.width / scale, half_height = 0.5 * frame.height / scale;
  return {x - half_width, y - half_height, x + half_width, y + half_height};
}

/// From the plane to fine pixels, y downwards.
Cell to_pixels(const Cell& c, const Extent& window, double scale) {
  return {
      (c.x - window.low_x) * scale, (window.high_y - c.y) * scale, c.e1x * scale, -c.e1y * scale, c.e2x * scale, -c.e2y * scale};
}

/// Neighboring cells overlap a little, so that no background shines through the seam.
void overlap(Cell& c) {
  const double grow1 = 1.0 + seam * fineness / std::hypot(c.e1x, c.e1y), grow2 = 1.0 + seam * fineness / std::hypot(c.e2x, c.e2y);
  c = {c.x, c.y, grow1 * c.e1x, grow1 * c.e1y, grow2 * c.e2x, grow2 * c.e2y};
}

/// A cell that is so thin that samples could miss it gets the least thickness.
void thicken(Cell& c) {
  const double least = least_half * fineness, length1 = std::hypot(c.e1x, c.e1y), length2 = std::hypot(c.e2x, c.e2y);
  const double longest = std::max(length1, length2), half_thickness = std::abs(c.e1x * c.e2y - c.e1y * c.e2x) / longest;
  if (half_thickness >= least) return;
  if (longest < least || half_thickness < 1e-6 * longest) {
    c = {c.x, c.y, least, 0.0, 0.0, least};
  } else if (length1 < length2) {
    c.e1x *= least / half_thickness, c.e1y *= least / half_thickness;
  } else {
    c.e2x *= least / half_thickness, c.e2y *= least / half_thickness;
  }
}

void draw_cell(Pixels& fine, const Cell& c, std::uint32_t inside, std::uint32_t rim) {
  const double determinant = c.e1x * c.e2y - c.e1y * c.e2x;
  const double rx = std::abs(c.e1x) + std::abs(c.e2x), ry = std::abs(c.e1y) + std::abs(c.e2y);
  const double rim1 = 1.0 - 0.7 * fineness / std::hypot(c.e1x, c.e1y), rim2 = 1.0 - 0.7 * fineness / std::hypot(c.e2x, c.e2y);
  const int x0 = std::max(0, static_cast<int>(c.x - rx)), x1 = std::min(fine.width - 1, static_cast<int>(c.x + rx));
  const int y0 = std::max(0, static_cast<int>(c.y - ry)), y1 = std::min(fine.height - 1, static_cast<int>(c.y + ry));
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const double dx = x + 0.5 - c.x, dy = y + 0.5 - c.y;
      const double a = std::abs(dx * c.e2y - dy * c.e2x) / std::abs(determinant);
      const double b = std::abs(c.e1x * dy - c.e1y * dx) / std::abs(determinant);
      if (a <= 1.0 && b <= 1.0) fine.argb[static_cast<std::size_t>(y) * fine.width + x] = a > rim1 || b > rim2 ? rim : inside;
    }
}

Pixels draw_cells(const std::vector<Cell>& cells, const PictureScalar& scalar, const Extent& window, const Box& frame) {
  Pixels fine(static_cast<int>(frame.width) * fineness, static_cast<int>(frame.height) * fineness);
  const double scale = frame.width * fineness / window.width();
  for (std::size_t p = 0; p < cells.size(); ++p) {
    Cell cell = to_pixels(cells[p], window, scale);
    if (cell.e1x == 0.0 && cell.e1y == 0.0) continue;
    thicken(cell);
    overlap(cell);
    const Rgb color = scalar.color(scalar.values[p]);
    const double shortest = 2.0 / fineness * std::min(std::hypot(cell.e1x, cell.e1y), std::hypot(cell.e2x, cell.e2y));
    const double weight = shortest >= edge_from_pixels ? edge_share : 0.0;
    draw_cell(fine, cell, pack_color(color), pack_color(mix(color, {}, weight)));
  }
  return reduce(fine, fineness);
}

struct Axis {
  Ticks ticks;    ///< in the displayed unit
  double factor;  ///< displayed per stored
  std::string label;
};

Axis make_axis(const char* name, double low, double high, const DisplayUnit& unit, int most) {
  return {nice_ticks(low * unit.factor, high * unit.factor, most), unit.factor,
          std::string(name) + (unit.name.empty() ? "" : " [" + unit.name + "]")};
}

void draw_x_axis(Canvas& canvas, const Layout& layout, const Extent& window, const Axis& axis) {
  const Box& frame = layout.content;
  const double u = layout.unit;
  for (std::size_t i = 0; i < axis.ticks.at.size(); ++i) {
    const double x = frame.x + (axis.ticks.at[i] / axis.factor - window.low_x) / window.width() * frame.width;
    canvas.line(x, frame.bottom(), x, frame.bottom() + tick_length * u, ink, 1.2 * u);
    canvas.text(x, frame.bottom() + (13 + 0.8 * tick_size) * u, axis.ticks.text[i],
                {.size = tick_size * u, .color = ink, .align = 0.5});
  }
  canvas.text(frame.x + 0.5 * frame.width, frame.bottom() + (axis_bottom - 8) * u, axis.label,
              {.size = text_size * u, .color = ink, .align = 0.5});
}

void draw_y_axis(Canvas& canvas, const Layout& layout, const Extent& window, const Axis& axis) {
  const Box& frame = layout.content;
  const double u = layout.unit;
  for (std::size_t i = 0; i < axis.ticks.at.size(); ++i) {
    const double y = frame.bottom() - (axis.ticks.at[i] / axis.factor - window.low_y) / window.height() * frame.height;
    canvas.line(frame.x - tick_length * u, y, frame.x, y, ink, 1.2 * u);
    canvas.text(frame.x - 13 * u, y + 0.36 * tick_size * u, axis.ticks.text[i],
                {.size = tick_size * u, .color = ink, .align = 1.0});
  }
  const double texts = widest(canvas, axis.ticks, {.size = tick_size * u});
  canvas.text(frame.x - texts - 32 * u, frame.y + 0.5 * frame.height, axis.label,
              {.size = text_size * u, .color = ink, .align = 0.5, .vertical = true});
}

void draw_axes(Canvas& canvas, const Layout& layout, const Extent& window, const std::string& length_unit) {
  const Box& frame = layout.content;
  const double size = std::max(window.width(), window.height());
  const DisplayUnit unit = display_unit(length_unit, size);
  const double tick_room = 95 * layout.unit;
  const int most_x = std::clamp(static_cast<int>(frame.width / (1.25 * tick_room)), 2, 9);
  const int most_y = std::clamp(static_cast<int>(frame.height / (0.85 * tick_room)), 2, 9);
  draw_x_axis(canvas, layout, window, make_axis("x", window.low_x, window.high_x, unit, most_x));
  draw_y_axis(canvas, layout, window, make_axis("y", window.low_y, window.high_y, unit, most_y));
}

PageRequest page_request(Canvas& canvas, const PictureScalar& scalar, const PictureOptions& options, const Extent& extent) {
  PageRequest request{
      .width = options.width, .height = options.height, .data_width = extent.width(), .data_height = extent.height()};
  request.left = request.left_if_bar_below = axis_left;
  request.bottom = axis_bottom;
  request.has_title = !options.title.empty();
  request.bar_text_width =
      widest(canvas, color_bar_ticks(scalar), {.size = tick_size * page_unit(options.width, options.height)});
  return request;
}

}  // namespace

Canvas draw_plane(const Snapshot& snapshot, const PictureScalar& scalar, const PictureOptions& options) {
  Canvas canvas(options.width, options.height, background, background);
  const std::vector<Cell> cells = make_cells(snapshot);
  const Extent extent = extent_of(cells);
  const Layout layout = lay_out(page_request(canvas, scalar, options, extent));
  const Extent window = fill_frame(extent, layout.content);
  const Box& frame = layout.content;
  canvas.fill(frame, mix(background, panel, 0.35));
  canvas.image(draw_cells(cells, scalar, window, frame), static_cast<int>(frame.x), static_cast<int>(frame.y));
  canvas.outline(frame, ink, 1.5 * layout.unit);
  draw_axes(canvas, layout, window, snapshot.length_unit);
  draw_color_bar(canvas, layout, scalar);
  draw_heading(canvas, layout, options, snapshot);
  return canvas;
}

}  // namespace sinew
