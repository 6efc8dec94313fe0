#include <sinew/core/error.hpp>
#include <sinew/io/file.hpp>
#include <sinew/io/picture.hpp>
#include <sinew/io/picture/plane_view.hpp>
#include <sinew/io/picture/space_view.hpp>

namespace sinew {

namespace {

constexpr int least_pixels = 200, most_pixels = 16'000;

void check_size(const char* what, int pixels) {
  if (pixels < least_pixels || pixels > most_pixels)
    throw CaseError(std::string("picture: ") + what + " is " + std::to_string(pixels) + " pixels; allowed are " +
                    std::to_string(least_pixels) + " to " + std::to_string(most_pixels) + ".");
}

}  // namespace

void write_picture(const std::string& path, const Snapshot& snapshot, const PictureOptions& options) {
  check_size("width", options.width);
  check_size("height", options.height);
  const PictureScalar scalar = select_scalar(snapshot, options);
  Canvas canvas = snapshot.dimension == 2 ? draw_plane(snapshot, scalar, options) : draw_space(snapshot, scalar, options);
  write_atomically(path, canvas.png());
}

}  // namespace sinew
