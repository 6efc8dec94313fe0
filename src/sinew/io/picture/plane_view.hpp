#pragma once
/// Pictures of plane states.

#include <sinew/io/picture.hpp>
#include <sinew/io/picture/canvas.hpp>
#include <sinew/io/picture/scalar.hpp>

namespace sinew {

/// The finished page.
Canvas draw_plane(const Snapshot& snapshot, const PictureScalar& scalar, const PictureOptions& options);

}  // namespace sinew
