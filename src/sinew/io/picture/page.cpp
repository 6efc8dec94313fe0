#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sinew/io/picture/page.hpp>

namespace sinew {

namespace {

using namespace page_style;

constexpr double title_height = 48, subtitle_height = 34, heading_gap = 20;
constexpr double below_height = bar_gap + bar_width + 12 + tick_size + 14 + text_size;
constexpr double corner_size = 150;

/// The room for the content if the bar stands beside it or lies under it.
struct Room {
  double width, height;
  double scale(const PageRequest& request) const { return std::min(width / request.data_width, height / request.data_height); }
};

std::string with_commas(std::size_t count) {
  std::string text = std::to_string(count);
  for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3) text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

std::string default_subtitle(const Snapshot& snapshot) {
  const DisplayUnit unit = display_unit(snapshot.time_unit, std::abs(snapshot.time));
  return fmt::format("t = {} {},  {} particles", drawn_number(snapshot.time * unit.factor), unit.name,
                     with_commas(snapshot.position.size()));
}

/// The style with a size that lets the text end before `width`.
TextStyle fitted(Canvas& canvas, const std::string& text, TextStyle style, double width) {
  const double needed = canvas.text_width(text, style);
  if (needed > width) style.size *= width / needed;
  return style;
}

void draw_bar_colors(Canvas& canvas, const Layout& layout, const PictureScalar& scalar) {
  const Box& bar = layout.bar;
  const int steps = static_cast<int>(layout.bar_below ? bar.width : bar.height);
  for (int i = 0; i < steps; ++i) {
    const Rgb color = map_color(scalar.map, (i + 0.5) / steps);
    if (layout.bar_below)
      canvas.fill(Box{bar.x + i, bar.y, bar.width - i, bar.height}, color);
    else
      canvas.fill(Box{bar.x, bar.y, bar.width, bar.height - i}, color);
  }
  canvas.outline(bar, ink, 1.2 * layout.unit);
}

/// A pointed end for values beyond the range of the colors.
void draw_bar_end(Canvas& canvas, const Layout& layout, const PictureScalar& scalar, bool upper) {
  const Box& bar = layout.bar;
  const double reach = 0.8 * bar_width * layout.unit;
  const Rgb color = map_color(scalar.map, upper ? 1.0 : 0.0);
  if (layout.bar_below) {
    const double edge = upper ? bar.right() + 1 : bar.x - 1, tip = edge + (upper ? reach : -reach);
    canvas.fill({{edge, bar.y}, {tip, bar.y + 0.5 * bar.height}, {edge, bar.bottom()}}, color);
  } else {
    const double edge = upper ? bar.y - 1 : bar.bottom() + 1, tip = edge + (upper ? -reach : reach);
    canvas.fill({{bar.x, edge}, {bar.x + 0.5 * bar.width, tip}, {bar.right(), edge}}, color);
  }
}

void draw_bar_ticks(Canvas& canvas, const Layout& layout, const PictureScalar& scalar) {
  const Box& bar = layout.bar;
  const double unit = layout.unit;
  const Ticks ticks = color_bar_ticks(scalar);
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double fraction = (ticks.at[i] - scalar.low) / (scalar.high - scalar.low);
    TextStyle style{.size = tick_size * unit, .color = ink};
    if (layout.bar_below) {
      const double x = bar.x + fraction * bar.width;
      style.align = 0.5;
      canvas.line(x, bar.bottom(), x, bar.bottom() + tick_length * unit, ink, 1.2 * unit);
      canvas.text(x, bar.bottom() + (12 + 0.85 * tick_size) * unit, ticks.text[i], style);
    } else {
      const double y = bar.bottom() - fraction * bar.height;
      canvas.line(bar.right(), y, bar.right() + tick_length * unit, y, ink, 1.2 * unit);
      canvas.text(bar.right() + 13 * unit, y + 0.36 * tick_size * unit, ticks.text[i], style);
    }
  }
}

}  // namespace

double page_unit(int width, int height) { return std::min(width / 1600.0, height / 1000.0); }

Layout lay_out(const PageRequest& request) {
  Layout layout;
  const double u = layout.unit = page_unit(request.width, request.height);
  const double head = ((request.has_title ? title_height : 0.0) + subtitle_height + heading_gap) * u;
  const double beside = (bar_gap + bar_width + 13 + 22 + text_size) * u + request.bar_text_width;
  const double full_width = request.width - 2 * margin * u,
               full_height = request.height - 2 * margin * u - head - request.bottom * u;
  const Room right{full_width - request.left * u - beside, full_height};
  const Room below{full_width - request.left_if_bar_below * u, full_height - below_height * u};
  layout.bar_below = below.scale(request) > 1.05 * right.scale(request);

  const Room& room = layout.bar_below ? below : right;
  const double scale = room.scale(request), left = (layout.bar_below ? request.left_if_bar_below : request.left) * u;
  const double width =
      std::clamp(request.data_width * scale, std::min(room.width, request.least_aspect * room.height), room.width);
  const double height =
      std::clamp(request.data_height * scale, std::min(room.height, request.least_flatness * room.width), room.height);
  const double group_width = left + width + (layout.bar_below ? 0.0 : beside);
  const double group_height = head + height + request.bottom * u + (layout.bar_below ? below_height * u : 0.0);
  const double x = std::round(0.5 * (request.width - group_width)), y = std::round(0.5 * (request.height - group_height));
  layout.content = {std::round(x + left), std::round(y + head), std::floor(width), std::floor(height)};
  layout.heading_x = x + (request.left == request.left_if_bar_below ? left : 0.0);
  layout.heading_y = y;
  const Box& content = layout.content;
  if (layout.bar_below)
    layout.bar = {content.x + 0.2 * width, content.bottom() + (request.bottom + bar_gap) * u, 0.6 * width, bar_width * u};
  else
    layout.bar = {content.right() + bar_gap * u, content.y, bar_width * u, content.height};
  const double corner_y = layout.bar_below ? y + group_height : content.bottom();
  layout.corner = {x, corner_y - corner_size * u, corner_size * u, corner_size * u};
  return layout;
}

Ticks color_bar_ticks(const PictureScalar& scalar) { return nice_ticks(scalar.low, scalar.high, most_color_ticks); }

double widest(Canvas& canvas, const Ticks& ticks, const TextStyle& style) {
  double width = 0.0;
  for (const std::string& text : ticks.text) width = std::max(width, canvas.text_width(text, style));
  return width;
}

void draw_heading(Canvas& canvas, const Layout& layout, const PictureOptions& options, const Snapshot& snapshot) {
  const double u = layout.unit, x = layout.heading_x, room = options.width - margin * u - x;
  double y = layout.heading_y;
  if (!options.title.empty()) {
    const std::string title = plain_words(options.title);
    y += title_height * u;
    canvas.text(x, y - 14 * u, title, fitted(canvas, title, {.size = title_size * u, .color = ink, .bold = true}, room));
  }
  y += subtitle_height * u;
  const std::string subtitle = options.subtitle.empty() ? default_subtitle(snapshot) : options.subtitle;
  canvas.text(x, y - 8 * u, subtitle, fitted(canvas, subtitle, {.size = text_size * u, .color = faint_ink}, room));
}

void draw_color_bar(Canvas& canvas, const Layout& layout, const PictureScalar& scalar) {
  const Box& bar = layout.bar;
  const double u = layout.unit;
  if (scalar.below) draw_bar_end(canvas, layout, scalar, false);
  if (scalar.above) draw_bar_end(canvas, layout, scalar, true);
  draw_bar_colors(canvas, layout, scalar);
  draw_bar_ticks(canvas, layout, scalar);
  TextStyle style{.size = text_size * u, .color = ink, .align = 0.5};
  if (layout.bar_below) {
    style = fitted(canvas, scalar.label, style, layout.content.width);
    canvas.text(bar.x + 0.5 * bar.width, bar.bottom() + (12 + tick_size + 12 + 0.8 * text_size) * u, scalar.label, style);
  } else {
    const double texts = widest(canvas, color_bar_ticks(scalar), {.size = tick_size * u});
    style = fitted(canvas, scalar.label, style, layout.content.height + 60 * u);
    style.vertical = true;
    canvas.text(bar.right() + texts + (13 + 20 + 0.8 * text_size) * u, bar.y + 0.5 * bar.height, scalar.label, style);
  }
}

}  // namespace sinew
