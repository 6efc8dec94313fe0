#include <sinew/particles/generate/options.hpp>

#include <cmath>
#include <filesystem>

namespace sinew {

std::string GenerateOptions::path_of(const std::string& name) const {
  const std::filesystem::path path(name);
  return path.is_absolute() || folder.empty() ? name : (std::filesystem::path(folder) / path).string();
}

Point GenerateOptions::point(const std::vector<double>& coordinates, const std::string& key) const {
  if (coordinates.size() != static_cast<std::size_t>(dimension))
    fail("\"" + key + "\" has " + std::to_string(coordinates.size()) + " coordinates; in " + std::to_string(dimension) +
         "D it needs " + std::to_string(dimension) + ".");
  Point p;
  for (int d = 0; d < dimension; ++d) {
    if (!std::isfinite(coordinates[d])) fail("\"" + key + "\" has a coordinate that is not a finite number.");
    p[d] = coordinates[d];
  }
  return p;
}

void GenerateOptions::need_dimension(int wanted, const std::string& shape, const std::string& advice) const {
  if (dimension != wanted)
    fail("the shape \"" + shape + "\" exists in " + std::to_string(wanted) + "D only, and this case is " +
         std::to_string(dimension) + "D. " + advice);
}

void GenerateOptions::fail(const std::string& message) const { throw CaseError(place, message); }

}  // namespace sinew
