#pragma once
/// A picture of one state as a PNG file, drawn without a display.

#include <optional>
#include <sinew/particles/snapshot.hpp>
#include <string>

namespace sinew {

struct PictureOptions {
  std::string field{};                  ///< name of a field of the snapshot
  std::string component{};              ///< x y z, xx yy zz xy yz xz (also yx zy zx), magnitude; "" is the value or the magnitude
  int width = 1600, height = 1000;      ///< pixels
  std::string title{};                  ///< e.g. the name of the case
  std::string subtitle{};               ///< "" becomes the time and the number of particles
  std::optional<double> low{}, high{};  ///< range of the colors in the field's unit; default: from the data
};

/// Two dimensions: particles as squares of their size (deformed by the field `deformation_gradient` if the snapshot has it) in a
/// frame with axes. Three dimensions: shaded balls of the particles' volumes, seen along azimuth 35 deg, elevation 20 deg, z up.
/// Throws CaseError for an unknown field or component and for a size outside 200 to 16 000 pixels, SimulationError if the file
/// cannot be written.
void write_picture(const std::string& path, const Snapshot& snapshot, const PictureOptions& options);

}  // namespace sinew
