#pragma once
/// What a geometry makes: points with volumes, before there are neighbors, materials or an order.

#include <map>
#include <sinew/core/vec.hpp>
#include <string>
#include <vector>

namespace sinew {

struct PointSet {
  std::vector<Point> position;                   ///< reference coordinates [length]; z = 0 in two dimensions
  std::vector<double> volume;                    ///< [length^dimension]: an area in two dimensions
  std::map<std::string, std::vector<int>> sets;  ///< named groups of points (physical groups, element sets)
  double spacing = 0.0;                          ///< nominal particle spacing [length]; 0: irregular, see mean_spacing
  std::vector<std::string> warnings;             ///< one sentence each

  std::size_t size() const { return position.size(); }
};

}  // namespace sinew
