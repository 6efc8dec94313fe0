#include <sinew/model/fragments.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace sinew {

namespace {

constexpr double failed = std::numeric_limits<double>::infinity();

/// Each particle is labeled with the smallest number (in the user's order) of its piece; failed ones with `failed`.
template <int D>
class Labels {
 public:
  Labels(const Particles<D>& particles, const Formulation<D>& solid, const RecordedState& state)
      : particles_(particles),
        copies_(solid.halo().displacements),
        label_(static_cast<std::size_t>(particles.slots) + particles.copies),
        up_(static_cast<std::size_t>(particles.slots) + particles.copies) {
    for (const BlockRange& block : particles.blocks)
      for (int slot = block.begin; slot < block.end; ++slot) {
        const bool gone = !state.inelastic.empty() && state.inelastic.at(3, slot) >= 1.0;
        label_.at(0, slot) = gone ? failed : particles.user_index[slot];
      }
    exchange();
    std::iota(up_.begin(), up_.end(), 0);
    for (const Block& block : solid.pairs().blocks.all)
      solid.pairs().for_each_pair(block, [this](int i, int j) {
        if (label_.at(0, i) != failed && label_.at(0, j) != failed) unite(i, j);
      });
  }

  /// Until nothing changes on any rank. Pieces of a rank are one already; copies bring what others know of them.
  void spread(const Comm& comm) {
    bool changed = true;
    while (comm.any(changed)) {
      changed = false;
      for (int slot = 0; slot < static_cast<int>(up_.size()); ++slot) {
        double& of_piece = label_.at(0, root(slot));
        if (label_.at(0, slot) < of_piece) of_piece = label_.at(0, slot), changed = true;
      }
      for (int slot = 0; slot < static_cast<int>(up_.size()); ++slot) label_.at(0, slot) = label_.at(0, root(slot));
      exchange();
    }
  }

  double of(int slot) const { return label_.at(0, slot); }

 private:
  void exchange() {
    copies_.start(label_);
    copies_.finish();
  }
  int root(int slot) {
    while (up_[slot] != slot) slot = up_[slot] = up_[up_[slot]];
    return slot;
  }
  /// The root of a piece is its first slot.
  void unite(int i, int j) {
    const int a = root(i), b = root(j);
    up_[std::max(a, b)] = std::min(a, b);
  }

  const Particles<D>& particles_;
  Exchange copies_;
  VectorField<D> label_;  ///< component 0
  std::vector<int> up_;   ///< of each slot: another one of its piece, the root itself
};

/// {label, number of the block, mass} of what each piece has in each block.
template <int D>
std::vector<double> masses_by_block(const Particles<D>& particles, const Labels<D>& labels) {
  std::vector<double> rows;
  for (const BlockRange& block : particles.blocks) {
    std::vector<int> slots(block.end - block.begin);
    std::iota(slots.begin(), slots.end(), block.begin);
    std::sort(slots.begin(), slots.end(),
              [&](int a, int b) { return labels.of(a) != labels.of(b) ? labels.of(a) < labels.of(b) : a < b; });
    for (std::size_t k = 0; k < slots.size(); ++k) {
      if (k == 0 || labels.of(slots[k]) != labels.of(slots[k - 1]))
        rows.insert(rows.end(), {labels.of(slots[k]), static_cast<double>(block.number), 0.0});
      rows.back() += particles.mass[slots[k]];
    }
  }
  return rows;
}

}  // namespace

template <int D>
Fragments find_fragments(const Comm& comm, const Particles<D>& particles, const Formulation<D>& solid,
                         const RecordedState& state) {
  Labels<D> labels(particles, solid, state);
  labels.spread(comm);
  const std::vector<double> rows = comm.gather_all(masses_by_block(particles, labels));
  std::vector<std::array<double, 3>> parts;
  for (std::size_t k = 0; k < rows.size(); k += 3) parts.push_back({rows[k], rows[k + 1], rows[k + 2]});
  std::sort(parts.begin(), parts.end());  // by piece, then by block: sums have one order
  Fragments fragments;
  for (std::size_t k = 0; k < parts.size();) {
    double mass = 0.0;
    const double label = parts[k][0];
    for (; k < parts.size() && parts[k][0] == label; ++k) mass += parts[k][2];
    if (label == failed) {
      fragments.debris = mass;
    } else {
      ++fragments.count;
      fragments.largest = std::max(fragments.largest, mass);
    }
  }
  return fragments;
}

template Fragments find_fragments<2>(const Comm&, const Particles<2>&, const Formulation<2>&, const RecordedState&);
template Fragments find_fragments<3>(const Comm&, const Particles<3>&, const Formulation<3>&, const RecordedState&);

}  // namespace sinew
