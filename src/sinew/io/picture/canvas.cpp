#include <cairo.h>
#include <numbers>
#include <sinew/io/picture/canvas.hpp>
#include <stdexcept>

namespace sinew {

namespace {

void choose_font(cairo_t* context, const TextStyle& style) {
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size);
}

void choose_color(cairo_t* context, const Rgb& color) { cairo_set_source_rgb(context, color.red, color.green, color.blue); }

cairo_status_t append(void* text, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(std::string("picture: ") + cairo_status_to_string(status));
}

}  // namespace

void Canvas::Destroy::operator()(cairo_t* object) const { cairo_destroy(object); }
void Canvas::Destroy::operator()(cairo_surface_t* object) const { cairo_surface_destroy(object); }

Pixels reduce(const Pixels& fine, int factor) {
  Pixels coarse(fine.width / factor, fine.height / factor);
  const std::uint32_t samples = static_cast<std::uint32_t>(factor * factor);
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) {
      std::uint32_t sum[4]{};
      for (int j = 0; j < factor; ++j)
        for (int i = 0; i < factor; ++i) {
          const std::uint32_t pixel = fine.argb[static_cast<std::size_t>(y * factor + j) * fine.width + x * factor + i];
          for (int c = 0; c < 4; ++c) sum[c] += pixel >> 8 * c & 255;
        }
      std::uint32_t pixel = 0;
      for (int c = 0; c < 4; ++c) pixel |= (sum[c] + samples / 2) / samples << 8 * c;
      coarse.argb[static_cast<std::size_t>(y) * coarse.width + x] = pixel;
    }
  return coarse;
}

Canvas::Canvas(int width, int height, const Rgb& top, const Rgb& bottom)
    : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      context(cairo_create(surface.get())) {
  check(cairo_surface_status(surface.get()));
  cairo_pattern_t* gradient = cairo_pattern_create_linear(0, 0, 0, height);
  cairo_pattern_add_color_stop_rgb(gradient, 0, top.red, top.green, top.blue);
  cairo_pattern_add_color_stop_rgb(gradient, 1, bottom.red, bottom.green, bottom.blue);
  cairo_set_source(context.get(), gradient);
  cairo_paint(context.get());
  cairo_pattern_destroy(gradient);
}

void Canvas::text(double x, double baseline, const std::string& content, const TextStyle& style) {
  cairo_save(context.get());
  choose_font(context.get(), style);
  choose_color(context.get(), style.color);
  cairo_translate(context.get(), x, baseline);
  if (style.vertical) cairo_rotate(context.get(), -std::numbers::pi / 2);
  cairo_text_extents_t extents;
  cairo_text_extents(context.get(), content.c_str(), &extents);
  cairo_move_to(context.get(), -style.align * extents.x_advance, 0);
  cairo_show_text(context.get(), content.c_str());
  cairo_restore(context.get());
}

double Canvas::text_width(const std::string& content, const TextStyle& style) {
  choose_font(context.get(), style);
  cairo_text_extents_t extents;
  cairo_text_extents(context.get(), content.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::fill(const std::vector<std::pair<double, double>>& polygon, const Rgb& color) {
  choose_color(context.get(), color);
  cairo_new_path(context.get());
  for (const auto& [x, y] : polygon) cairo_line_to(context.get(), x, y);
  cairo_close_path(context.get());
  cairo_fill(context.get());
}

void Canvas::fill(const Box& box, const Rgb& color) {
  choose_color(context.get(), color);
  cairo_new_path(context.get());
  cairo_rectangle(context.get(), box.x, box.y, box.width, box.height);
  cairo_fill(context.get());
}

void Canvas::outline(const Box& box, const Rgb& color, double width) {
  choose_color(context.get(), color);
  cairo_set_line_width(context.get(), width);
  cairo_new_path(context.get());
  cairo_rectangle(context.get(), box.x, box.y, box.width, box.height);
  cairo_stroke(context.get());
}

void Canvas::line(double x0, double y0, double x1, double y1, const Rgb& color, double width) {
  choose_color(context.get(), color);
  cairo_set_line_width(context.get(), width);
  cairo_new_path(context.get());
  cairo_move_to(context.get(), x0, y0);
  cairo_line_to(context.get(), x1, y1);
  cairo_stroke(context.get());
}

void Canvas::image(const Pixels& pixels, int x, int y) {
  // cairo only reads from it here, but wants a pointer that it could write to.
  auto* data = reinterpret_cast<unsigned char*>(const_cast<std::uint32_t*>(pixels.argb.data()));
  const std::unique_ptr<cairo_surface_t, Destroy> picture(
      cairo_image_surface_create_for_data(data, CAIRO_FORMAT_ARGB32, pixels.width, pixels.height, 4 * pixels.width));
  check(cairo_surface_status(picture.get()));
  cairo_set_source_surface(context.get(), picture.get(), x, y);
  cairo_paint(context.get());
  choose_color(context.get(), {});
}

std::string Canvas::png() {
  std::string text;
  cairo_surface_flush(surface.get());
  check(cairo_surface_write_to_png_stream(surface.get(), append, &text));
  return text;
}

}  // namespace sinew
