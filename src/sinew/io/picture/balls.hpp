#pragma once
/// Shaded balls on a depth buffer: draws any number of particles, the nearest of each sample wins.

#include <cstdint>
#include <sinew/core/vec.hpp>
#include <sinew/io/picture/canvas.hpp>
#include <vector>

namespace sinew {

/// As seen: x to the right, y downwards, z towards the eye; all in samples of the image.
struct Ball {
  float x, y, z, radius;
};

/// Which ball each sample sees, and how near it is.
class DepthImage {
 public:
  DepthImage(int width, int height, const std::vector<Ball>& balls);

  static constexpr int nothing = -1;
  int width, height;
  std::vector<float> depth;  ///< z of the nearest surface; minus infinity where there is none
  std::vector<int> ball;     ///< index of its ball, or `nothing`

  /// The balls that can be seen, each once, rising.
  std::vector<int> visible() const;
};

/// What the balls look like.
struct BallLook {
  const std::vector<Rgb>* color;  ///< one a ball
  const std::vector<Point>*
      normal;             ///< outward direction of the body's surface at a ball as seen (x right, y down, z to the eye),
                          ///< zero if unknown
  double fineness = 1.0;  ///< samples per pixel and direction
};

/// Light from the upper left; crevices and silhouettes are darkened by how far their surroundings stand out.
Pixels shade(const DepthImage& image, const std::vector<Ball>& balls, const BallLook& look);

}  // namespace sinew
