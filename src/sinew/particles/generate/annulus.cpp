#include <sinew/particles/generate/annulus.hpp>

#include <sinew/particles/generate/ball_shell.hpp>
#include <sinew/particles/generate/rounded_text.hpp>

namespace sinew {

PointSet Annulus::generate(const GenerateOptions& options) const {
  options.need_dimension(2, std::string(name), "Use \"cylinder\" with an \"inner_radius\" for a tube.");
  if (!(inner_radius < outer_radius))
    options.fail("\"inner_radius\" is " + rounded_text(inner_radius) + "; it must be below \"outer_radius\", " +
                 rounded_text(outer_radius) + ".");
  return ball_shell({options.point(center, "center"), inner_radius, outer_radius}, arrangement, std::string(name), options);
}

}  // namespace sinew
