#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sinew/io/picture/balls.hpp>

namespace sinew {

namespace {

constexpr Point light{{-0.25, -0.60, 0.76}};  // from the upper left, towards the eye
constexpr double ambient = 0.62, diffuse = 0.53, gloss = 0.10;
constexpr double surface_weight = 0.72;  // of the body's normal against that of the ball
constexpr double obscurance = 0.42;      // how dark a deep crevice gets
constexpr double near_pixels = 1.5, far_pixels = 9.0;

void splat(DepthImage& image, const Ball& ball, int index) {
  const float r = ball.radius;
  const int x0 = std::max(0, static_cast<int>(ball.x - r)), x1 = std::min(image.width - 1, static_cast<int>(ball.x + r));
  const int y0 = std::max(0, static_cast<int>(ball.y - r)), y1 = std::min(image.height - 1, static_cast<int>(ball.y + r));
  for (int y = y0; y <= y1; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
    const float dy = static_cast<float>(y) + 0.5f - ball.y;
    for (int x = x0; x <= x1; ++x) {
      const float dx = static_cast<float>(x) + 0.5f - ball.x, height2 = r * r - dx * dx - dy * dy;
      const std::size_t at = row + static_cast<std::size_t>(x);
      if (height2 <= 0.0f || ball.z + r <= image.depth[at]) continue;
      const float z = ball.z + std::sqrt(height2);
      if (z <= image.depth[at]) continue;
      image.depth[at] = z;
      image.ball[at] = index;
    }
  }
}

/// Eight samples around a place, `distance` away.
struct Ring {
  explicit Ring(double distance_) : distance(distance_) {
    for (int k = 0; k < 8; ++k) {
      const double angle = 0.25 * std::numbers::pi * k;
      offset[k][0] = static_cast<int>(std::lround(distance * std::cos(angle)));
      offset[k][1] = static_cast<int>(std::lround(distance * std::sin(angle)));
    }
  }
  double distance;
  int offset[8][2];
};

/// 0 in the open to 1 in a deep crevice: the mean over a ring of how steeply the surroundings rise towards the eye.
double crevice(const DepthImage& image, int x, int y, const Ring& ring) {
  const float here =
      image.depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)];
  double sum = 0.0;
  for (const auto& [dx, dy] : ring.offset) {
    const int i = x + dx, j = y + dy;
    if (i < 0 || j < 0 || i >= image.width || j >= image.height) continue;
    const double rise =
        image.depth[static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(i)] - here;
    if (rise > 0.0) sum += rise / std::sqrt(rise * rise + ring.distance * ring.distance);
  }
  return sum / 8.0;
}

double brightness(const Point& normal) {
  const double facing = dot(normal, light), mirrored = 2.0 * facing * normal[2] - light[2];
  const double wrapped = std::max(0.0, 0.25 + 0.75 * facing);
  const double m2 = mirrored * mirrored, m4 = m2 * m2, m16 = m4 * m4 * m4 * m4;
  return ambient + diffuse * wrapped + (mirrored > 0.0 ? gloss * m16 : 0.0);
}

Point shading_normal(const Ball& ball, const Point& surface, double x, double y, double z) {
  const Point own{{(x - ball.x) / ball.radius, (y - ball.y) / ball.radius, (z - ball.z) / ball.radius}};
  const double weight = surface_weight * norm(surface);
  const Point sum = (1.0 - weight) * own + surface_weight * surface;
  const double length = norm(sum);
  return length > 0.0 ? (1.0 / length) * sum : own;
}

}  // namespace

DepthImage::DepthImage(int width_, int height_, const std::vector<Ball>& balls)
    : width(width_),
      height(height_),
      depth(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), -std::numeric_limits<float>::infinity()),
      ball(depth.size(), nothing) {
  for (std::size_t b = 0; b < balls.size(); ++b) splat(*this, balls[b], static_cast<int>(b));
}

std::vector<int> DepthImage::visible() const {
  std::vector<int> seen(ball);
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  if (!seen.empty() && seen.front() == nothing) seen.erase(seen.begin());
  return seen;
}

Pixels shade(const DepthImage& image, const std::vector<Ball>& balls, const BallLook& look) {
  Pixels pixels(image.width, image.height);
  const Ring near(near_pixels * look.fineness), far(far_pixels * look.fineness);
#pragma omp parallel for schedule(dynamic, 16)
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
      if (image.ball[at] == DepthImage::nothing) continue;
      const auto b = static_cast<std::size_t>(image.ball[at]);
      const Point normal = shading_normal(balls[b], (*look.normal)[b], x + 0.5, y + 0.5, image.depth[at]);
      const double dark = 0.5 * (crevice(image, x, y, near) + crevice(image, x, y, far));
      const double light_here = brightness(normal) * (1.0 - obscurance * std::sqrt(dark));
      const Rgb& color = (*look.color)[b];
      pixels.argb[at] = pack_color({color.red * light_here, color.green * light_here, color.blue * light_here});
    }
  return pixels;
}

}  // namespace sinew
