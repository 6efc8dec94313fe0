#pragma once
/// Failed particles that separate from their bodies. A separated particle has no pairs any more, so F = I and no stress; it keeps its mass, the work that it has
/// dissipated, and what it is to contacts. The corrections of those that have lost a neighbor are made anew, so their gradients stay exact for linear fields.

#include <sinew/formulations/total_lagrangian.hpp>

namespace sinew {

/// What separation reads and changes.
template <int D>
struct SeparationParts {
  const Comm& comm;
  const TotalLagrangianOptions& options;
  const WeightOptions& weight_options;
  const Particles<D>& particles;
  BlockPairs<D>& pairs;
  PairWeights<D>& weights;
  HistoryStore& history;
  Cracks<D>& cracks;
};

template <int D>
class Separation {
 public:
  using Failed = std::vector<FailedParticle<D>>;
  explicit Separation(const SeparationParts<D>& parts) : s_(parts) {}

  /// Cuts off the particles that have failed in the last evaluation of the forces, as the summaries of the blocks say, and those that keep too few neighbors by
  /// that. Returns which blocks have changed; empty if there were none. Collective.
  std::vector<char> cut_off_failed(const std::vector<ForceSummary>& summaries);
  /// Cuts off particles with these numbers and contact radii, {number, radius} each, whose histories say already that they have failed. Collective.
  void cut_off_again(const std::vector<double>& number_and_radius);

 private:
  Failed find(const std::vector<ForceSummary>& summaries) const;
  Failed gather(const Failed& here) const;
  Failed cut_off(const Failed& failed, std::vector<char>& changed) const;
  void fail(int slot, Failed& failed) const;
  FailedParticle<D> particle(int slot, double radius) const;
  double room(int slot) const;
  /// Numbers n of the history of a particle are first[n * count].
  struct History {
    double* first;
    std::ptrdiff_t count;
    int first_shape, damage;  ///< numbers: where the plastic shape begins, and where it ends: the cube root of the damage
  };
  History history_of(int slot) const;

  SeparationParts<D> s_;
};

extern template class Separation<2>;
extern template class Separation<3>;

}  // namespace sinew
