#pragma once
/// Where things stand on a picture, and the parts that plane and spatial pictures share: heading and color bar.

#include <sinew/io/picture/canvas.hpp>
#include <sinew/io/picture/scalar.hpp>
#include <sinew/io/picture/ticks.hpp>
#include <string>

namespace sinew {

/// Sizes in units of the page (`Layout::unit` pixels), made for 1600 x 1000.
namespace page_style {
inline constexpr double margin = 44, title_size = 36, text_size = 25, tick_size = 23, bar_width = 26, bar_gap = 34,
                        tick_length = 7;
inline constexpr Rgb background{1.0, 1.0, 1.0}, panel{0.925, 0.937, 0.953}, ink{0.13, 0.15, 0.18}, faint_ink{0.38, 0.41, 0.45},
    grid{0.90, 0.91, 0.93};
}  // namespace page_style

/// What a picture needs beside its content.
struct PageRequest {
  int width = 0, height = 0;
  double data_width = 1.0, data_height = 1.0;                ///< of the content, in any unit: only their ratio matters
  double left = 0.0, left_if_bar_below = 0.0, bottom = 0.0;  ///< units kept free for axes or the triad
  double least_aspect = 0.5, least_flatness = 0.22;  ///< a content box is at least that wide per height, that high per width
  bool has_title = false;
  double bar_text_width = 60.0;  ///< of the longest label of the color bar, in pixels
};

struct Layout {
  double unit = 1.0;       ///< pixels per unit
  Box content;             ///< for the particles
  Box bar;                 ///< color bar
  bool bar_below = false;  ///< lies under the content instead of standing beside it
  Box corner;              ///< free place at the lower left of spatial pictures
  double heading_x = 0.0, heading_y = 0.0;
};

/// Makes the content as large as the page allows, with the color bar at the side that costs less, all of it centered.
Layout lay_out(const PageRequest& request);

double page_unit(int width, int height);
Ticks color_bar_ticks(const PictureScalar& scalar);
double widest(Canvas& canvas, const Ticks& ticks, const TextStyle& style);
/// Title and subtitle, left-aligned with the content; a long one is set smaller.
void draw_heading(Canvas& canvas, const Layout& layout, const PictureOptions& options, const Snapshot& snapshot);
void draw_color_bar(Canvas& canvas, const Layout& layout, const PictureScalar& scalar);

}  // namespace sinew
