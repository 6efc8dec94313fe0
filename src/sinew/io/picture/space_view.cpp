#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <sinew/io/picture/balls.hpp>
#include <sinew/io/picture/page.hpp>
#include <sinew/io/picture/space_view.hpp>
#include <sinew/io/picture/surface_normals.hpp>

namespace sinew {

namespace {

using namespace page_style;

constexpr double degree = std::numbers::pi / 180, azimuth = 35 * degree, elevation = 20 * degree;
constexpr int fineness = 2;              // samples per pixel and direction
constexpr double equal_volume = 0.6204;  // radius of a ball of unit volume: (3 / (4 pi))^(1/3)
constexpr double smallest_radius = 0.8;  // pixels
constexpr double triad_room = 175, arrow_length = 62, scale_bar_room = 130;

/// Parallel view: rows of the rotation from space to the screen, x to the right, y downwards, z towards the eye.
constexpr std::size_t right = 0, down = 1, forward = 2;
using View = std::array<Point, 3>;

View make_view() {
  const double ca = std::cos(azimuth), sa = std::sin(azimuth), ce = std::cos(elevation), se = std::sin(elevation);
  return {Point{{ca, sa, 0.0}}, Point{{se * sa, -se * ca, -ce}}, Point{{ce * sa, -ce * ca, se}}};
}

Point seen(const View& view, const Point& x) { return {{dot(view[right], x), dot(view[down], x), dot(view[forward], x)}}; }

struct Scene {
  std::vector<Point> position;  ///< of the particles with a finite place
  std::vector<double> radius;
  std::vector<Rgb> color;
  double low_x = 0.0, low_y = 0.0, high_x = 1.0, high_y = 1.0;  ///< on the screen, in lengths
};

Scene make_scene(const Snapshot& snapshot, const PictureScalar& scalar, const View& view) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Scene scene{
      .position = {}, .radius = {}, .color = {}, .low_x = infinity, .low_y = infinity, .high_x = -infinity, .high_y = -infinity};
  for (std::size_t p = 0; p < snapshot.position.size(); ++p) {
    const Point& x = snapshot.position[p];
    if (!std::isfinite(x[0] + x[1] + x[2])) continue;
    const Point s = seen(view, x);
    const double radius = equal_volume * snapshot.size[p];
    scene.position.push_back(x);
    scene.radius.push_back(radius);
    scene.color.push_back(scalar.color(scalar.values[p]));
    scene.low_x = std::min(scene.low_x, s[0] - radius);
    scene.low_y = std::min(scene.low_y, s[1] - radius);
    scene.high_x = std::max(scene.high_x, s[0] + radius);
    scene.high_y = std::max(scene.high_y, s[1] + radius);
  }
  if (!(scene.high_x > scene.low_x && scene.high_y > scene.low_y))
    scene.low_x = scene.low_y = 0.0, scene.high_x = scene.high_y = 1.0;
  return scene;
}

double pixels_per_length(const Scene& scene, const Box& box) {
  return std::min(box.width / (scene.high_x - scene.low_x), box.height / (scene.high_y - scene.low_y));
}

std::vector<Ball> make_balls(const Scene& scene, const View& view, const Box& box) {
  const double scale = fineness * pixels_per_length(scene, box);
  const double middle_x = 0.5 * (scene.low_x + scene.high_x), middle_y = 0.5 * (scene.low_y + scene.high_y);
  std::vector<Ball> balls;
  balls.reserve(scene.position.size());
  for (std::size_t p = 0; p < scene.position.size(); ++p) {
    const Point s = seen(view, scene.position[p]);
    balls.push_back({static_cast<float>((s[0] - middle_x) * scale + 0.5 * fineness * box.width),
                     static_cast<float>((s[1] - middle_y) * scale + 0.5 * fineness * box.height),
                     static_cast<float>(s[2] * scale),
                     static_cast<float>(std::max(smallest_radius * fineness, scene.radius[p] * scale))});
  }
  return balls;
}

std::vector<Point> screen_normals(const Scene& scene, const View& view, const std::vector<int>& visible) {
  double spacing = 0.0;
  for (const int p : visible) spacing = std::max(spacing, scene.radius[static_cast<std::size_t>(p)] / equal_volume);
  std::vector<Point> normals(scene.position.size(), Point{});
  if (!(spacing > 0.0)) return normals;
  const std::vector<Point> found = surface_normals(scene.position, visible, spacing);
  for (std::size_t i = 0; i < visible.size(); ++i) normals[static_cast<std::size_t>(visible[i])] = seen(view, found[i]);
  return normals;
}

void draw_particles(Canvas& canvas, const Scene& scene, const View& view, const Box& box) {
  const std::vector<Ball> balls = make_balls(scene, view, box);
  const DepthImage image(fineness * static_cast<int>(box.width), fineness * static_cast<int>(box.height), balls);
  const std::vector<Point> normals = screen_normals(scene, view, image.visible());
  const Pixels fine = shade(image, balls, {.color = &scene.color, .normal = &normals, .fineness = fineness});
  canvas.image(reduce(fine, fineness), static_cast<int>(box.x), static_cast<int>(box.y));
}

/// From (x, y) by (dx, dy), in pixels; y points down.
struct Arrow {
  double x, y, dx, dy;
};

void draw_arrow(Canvas& canvas, const Arrow& arrow, const Rgb& color, double unit) {
  const auto [x, y, dx, dy] = arrow;
  const double length = std::hypot(dx, dy), head = 13 * unit, half = 5.5 * unit;
  if (length < head) return;
  const double ex = dx / length, ey = dy / length, bx = x + dx - head * ex, by = y + dy - head * ey;
  canvas.line(x, y, bx + ex, by + ey, color, 3.2 * unit);
  canvas.fill({{x + dx, y + dy}, {bx - half * ey, by + half * ex}, {bx + half * ey, by - half * ex}}, color);
}

void draw_triad(Canvas& canvas, const Layout& layout, const View& view) {
  constexpr std::array<const char*, 3> names{"x", "y", "z"};
  constexpr std::array<Rgb, 3> colors{Rgb{0.75, 0.22, 0.20}, Rgb{0.18, 0.52, 0.27}, Rgb{0.16, 0.36, 0.70}};
  const double u = layout.unit, x = layout.corner.x + 26 * u, y = layout.corner.bottom() - 74 * u;
  for (const std::size_t axis : {std::size_t{1}, std::size_t{0}, std::size_t{2}}) {  // y points away from the eye: first
    const double dx = view[right][static_cast<int>(axis)] * arrow_length * u,
                 dy = view[down][static_cast<int>(axis)] * arrow_length * u;
    draw_arrow(canvas, {x, y, dx, dy}, colors[axis], u);
    const double length = std::max(1.0, std::hypot(dx, dy)), beyond = 1.0 + 15 * u / length;
    canvas.text(x + beyond * dx, y + beyond * dy + 7 * u, names[axis],
                {.size = tick_size * u, .color = colors[axis], .align = 0.5});
  }
}

/// A round length; it holds anywhere and in any direction across the picture because the view is parallel.
void draw_scale_bar(Canvas& canvas, const Layout& layout, double scale, const std::string& length_unit) {
  const double u = layout.unit, length = round_down_nicely(scale_bar_room * u / scale);
  const DisplayUnit unit = display_unit(length_unit, length);
  const double x = layout.corner.x, y = layout.corner.bottom() - 3 * u, width = length * scale;
  canvas.line(x, y, x + width, y, ink, 2.4 * u);
  for (const double end : {x, x + width}) canvas.line(end, y - 6 * u, end, y + 1.2 * u, ink, 2.4 * u);
  canvas.text(x, y - 12 * u, drawn_number(length * unit.factor) + " " + unit.name, {.size = tick_size * u, .color = ink});
}

PageRequest page_request(Canvas& canvas, const PictureScalar& scalar, const PictureOptions& options, const Scene& scene) {
  PageRequest request{.width = options.width,
                      .height = options.height,
                      .data_width = scene.high_x - scene.low_x,
                      .data_height = scene.high_y - scene.low_y};
  request.left = triad_room;
  request.least_aspect = 0.35;
  request.has_title = !options.title.empty();
  request.bar_text_width =
      widest(canvas, color_bar_ticks(scalar), {.size = tick_size * page_unit(options.width, options.height)});
  return request;
}

}  // namespace

Canvas draw_space(const Snapshot& snapshot, const PictureScalar& scalar, const PictureOptions& options) {
  Canvas canvas(options.width, options.height, background, panel);
  const View view = make_view();
  const Scene scene = make_scene(snapshot, scalar, view);
  const Layout layout = lay_out(page_request(canvas, scalar, options, scene));
  draw_particles(canvas, scene, view, layout.content);
  draw_triad(canvas, layout, view);
  draw_scale_bar(canvas, layout, pixels_per_length(scene, layout.content), snapshot.length_unit);
  draw_color_bar(canvas, layout, scalar);
  draw_heading(canvas, layout, options, snapshot);
  return canvas;
}

}  // namespace sinew
