#pragma once
/// Lines, areas, text and images on a page of pixels. Places in pixels from the upper left; the only user of cairo.

#include <cstdint>
#include <memory>
#include <sinew/io/picture/color_map.hpp>
#include <string>
#include <utility>
#include <vector>

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace sinew {

struct Box {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

/// Rows from above; 0xAARRGGBB with the colors multiplied by the opacity.
struct Pixels {
  Pixels(int width_, int height_)
      : width(width_),
        height(height_),
        argb(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {}
  int width, height;
  std::vector<std::uint32_t> argb;
};

/// Averages squares of factor x factor pixels into one.
Pixels reduce(const Pixels& fine, int factor);

struct TextStyle {
  double size = 20.0;
  Rgb color{};
  bool bold = false;
  double align = 0.0;     ///< 0: starts at the given place, 0.5: is centered there, 1: ends there
  bool vertical = false;  ///< reads upwards
};

class Canvas {
 public:
  Canvas(int width, int height, const Rgb& top, const Rgb& bottom);  ///< background: from the top color to the bottom color

  void text(double x, double baseline, const std::string& content, const TextStyle& style);
  double text_width(const std::string& content, const TextStyle& style);
  void fill(const std::vector<std::pair<double, double>>& polygon, const Rgb& color);
  void fill(const Box& box, const Rgb& color);
  void outline(const Box& box, const Rgb& color, double width);
  void line(double x0, double y0, double x1, double y1, const Rgb& color, double width);
  void image(const Pixels& pixels, int x, int y);
  /// The page as a PNG file.
  std::string png();

 private:
  struct Destroy {
    void operator()(cairo_t* object) const;
    void operator()(cairo_surface_t* object) const;
  };
  std::unique_ptr<cairo_surface_t, Destroy> surface;
  std::unique_ptr<cairo_t, Destroy> context;
};

}  // namespace sinew
