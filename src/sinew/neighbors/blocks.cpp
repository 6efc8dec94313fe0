#include <sinew/neighbors/blocks.hpp>

#include <algorithm>

namespace sinew {

void Blocks::connect() {
  const auto index_of = [this](int number) {
    const auto at =
        std::lower_bound(all.begin(), all.end(), number, [](const Block& block, int wanted) { return block.number < wanted; });
    return at != all.end() && at->number == number ? static_cast<int>(at - all.begin()) : nobody;
  };
  in = received;
  told.clear();
  for (const Spill& spill : out) {
    told.push_back(index_of(spill.to));
    if (told.back() != nobody) in.push_back(spill);
  }
  std::sort(in.begin(), in.end(), [](const Spill& a, const Spill& b) { return a.to != b.to ? a.to < b.to : a.from < b.from; });
  first_in.assign(all.size() + 1, 0);
  for (const Spill& spill : in) ++first_in[index_of(spill.to) + 1];
  for (std::size_t b = 0; b < all.size(); ++b) first_in[b + 1] += first_in[b];
  awaiting.clear();
  for (const Spill& spill : received) awaiting.push_back(index_of(spill.to));
  std::sort(awaiting.begin(), awaiting.end());
  awaiting.erase(std::unique(awaiting.begin(), awaiting.end()), awaiting.end());
}

int Blocks::most_places() const {
  int most = 0;
  for (const Block& block : all) most = std::max(most, block.places);
  return most;
}

std::size_t Blocks::bytes() const {
  return all.size() * sizeof(Block) + runs.size() * sizeof(Run) + (slot_at.size() + place_of_slice.size()) * sizeof(int) +
         (out.size() + in.size()) * sizeof(Spill);
}

}  // namespace sinew
