#include <sinew/neighbors/blocks.hpp>

#include <algorithm>

namespace sinew {

int Blocks::most_places() const {
  int most = 0;
  for (const Block& block : all) most = std::max(most, block.places);
  return most;
}

std::size_t Blocks::bytes() const {
  return all.size() * sizeof(Block) + runs.size() * sizeof(Run) + (slot_at.size() + place_of_slice.size()) * sizeof(int) +
         2 * out.size() * sizeof(Spill);
}

}  // namespace sinew
