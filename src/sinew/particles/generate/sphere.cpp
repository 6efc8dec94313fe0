#include <sinew/particles/generate/sphere.hpp>

#include <sinew/particles/generate/ball_shell.hpp>
#include <sinew/particles/generate/rounded_text.hpp>

namespace sinew {

PointSet Sphere::generate(const GenerateOptions& options) const {
  if (!(inner_radius < radius))
    options.fail("\"inner_radius\" is " + rounded_text(inner_radius) + "; it must be below \"radius\", " + rounded_text(radius) +
                 ".");
  return ball_shell({options.point(center, "center"), inner_radius, radius}, arrangement, std::string(name), options);
}

}  // namespace sinew
