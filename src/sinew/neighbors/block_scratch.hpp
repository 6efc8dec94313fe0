#pragma once
/// What a thread has at hand of the block it works on, place by place: what comes in before the loops over pairs, and the forces that go out
/// after them. Slices with a pair list use rows, slices with a lattice pattern fields.

#include <algorithm>
#include <sinew/neighbors/block_pairs.hpp>
#include <sinew/particles/rows.hpp>

namespace sinew {

/// What a scratch needs room for besides displacements and forces. For listed pairs only but for velocities.
struct ScratchNeeds {
  bool velocities = false, matrices = false, vectors = false;
};

template <int D>
class BlockScratch {
 public:
  static constexpr int numbers_kept = 2 * D + 2;  ///< packs of a listed pair that its first visit may keep

  /// Room for every block.
  explicit BlockScratch(const BlockPairs<D>& pairs, const ScratchNeeds& needs = {})
      : pairs_(pairs),
        margin_(whole_slices(pairs.lattice.farthest) + lanes) {
    const auto places = static_cast<std::size_t>(pairs.blocks.most_places());
    if (needs.velocities && pairs.lattice.slices() > 0) velocity_ = VectorField<D>(places + 2 * margin_);
    if (needs.velocities && pairs.entries() > 0) velocity_rows_ = AlignedArray<double>(places * vector_width<D>);
    if (needs.matrices) matrix_rows_ = AlignedArray<double>(places * D * vector_width<D>);
    if (needs.vectors) vector_rows_ = AlignedArray<double>(places * vector_width<D>);
    if (pairs.lattice.slices() > 0) displacement_ = forces_ = VectorField<D>(places + 2 * margin_);
    if (pairs.entries() == 0) return;
    place_rows_ = AlignedArray<double>(places * place_width<D>);
    force_rows_ = AlignedArray<double>(places * vector_width<D>);
    volume_ = radius_ = AlignedArray<double>(places);
    std::size_t longest = 0;
    for (int s = 0; s < pairs.blocks.slices(); ++s) longest = std::max(longest, pairs.first_entry[s + 1] - pairs.first_entry[s]);
    kept_ = AlignedArray<double>(longest * numbers_kept * lanes);
  }

  const double* displacement(int component) const { return displacement_.component(component) + margin_; }
  const double* velocity(int component) const { return velocity_.empty() ? nullptr : velocity_.component(component) + margin_; }
  const double* velocity_rows() const { return velocity_rows_.data(); }
  MatrixRows<D> matrices() const { return {matrix_rows_.data()}; }
  VectorRows<D> vectors() const { return {vector_rows_.data()}; }
  double* forces(int component) { return forces_.component(component) + margin_; }
  const double* place_rows() const { return place_rows_.data(); }
  double* force_rows() { return force_rows_.data(); }
  const double* volume() const { return volume_.data(); }
  const double* radius() const { return radius_.data(); }
  double* kept() { return kept_.data(); }

  void bring_in(const Block& block, const Particles<D>& particles) {
    for_each_run(block.first_own, block.end_runs, [&](const Run& run) {
      if (block.has_lattice)
        for (int c = 0; c < D; ++c)
          std::copy_n(particles.displacement.component(c) + run.slot, run.length,
                      displacement_.component(c) + margin_ + run.place);
      if (block.has_list) fill_rows(run, particles);
    });
  }
  /// For forces that depend on them.
  void bring_in_velocities(const Block& block, const Particles<D>& particles) {
    for_each_run(block.first_own, block.end_runs, [&](const Run& run) {
      for (int c = 0; c < D; ++c) {
        const double* from = particles.velocity.component(c) + run.slot;
        if (block.has_lattice) std::copy_n(from, run.length, velocity_.component(c) + margin_ + run.place);
        double* row = velocity_rows_.data() + std::size_t(vector_width<D>) * run.place + c;
        for (int k = 0; block.has_list && k < run.length; ++k) row[vector_width<D> * k] = from[k];
      }
    });
  }
  /// Matrices of own particles and ghosts.
  void bring_in_matrices(const Block& block, const VectorField<D * D>& field) {
    for_each_run(block.first_own, block.end_runs, [&](const Run& run) {
      constexpr std::size_t width = D * vector_width<D>;
      for (int n = 0; n < D * D; ++n) {
        const double* from = field.component(n) + run.slot;
        double* row = matrix_rows_.data() + width * run.place + vector_width<D> * (n / D) + n % D;
        for (int k = 0; k < run.length; ++k) row[width * k] = from[k];
      }
    });
  }
  /// Vectors of own particles and ghosts.
  void bring_in_vectors(const Block& block, const VectorField<D>& field) {
    for (int c = 0; c < D; ++c) bring_in_component(block, c, [from = field.component(c)](int slot) { return from[slot]; });
  }
  /// One component of vectors, value(slot), of own particles and ghosts.
  template <class Value>
  void bring_in_component(const Block& block, int component, const Value& value) {
    for_each_run(block.first_own, block.end_runs, [&](const Run& run) {
      double* row = vector_rows_.data() + std::size_t(vector_width<D>) * run.place + component;
      for (int k = 0; k < run.length; ++k) row[vector_width<D> * k] = value(run.slot + k);
    });
  }
  /// Volumes and radii, for weights that are computed from them.
  void bring_in_sizes(const Block& block, const Particles<D>& particles, const double* radius) {
    for_each_run(block.first_own, block.end_runs, [&](const Run& run) {
      std::copy_n(particles.volume.data() + run.slot, run.length, volume_.data() + run.place);
      std::copy_n(radius + run.slot, run.length, radius_.data() + run.place);
    });
  }

  /// Adds the forces on own particles to `forces`, writes those on ghosts to `spilled`, and clears them here.
  void hand_out(const Block& block, VectorField<D>& forces, VectorField<D>& spilled) {
    for_each_run(block.first_own, block.first_ghost, [&](const Run& run) {
      for (int c = 0; c < D; ++c) take(block, c, run, forces.component(c) + run.slot);
    });
    for_each_run(block.first_ghost, block.end_runs, [&](const Run& run) {
      for (int c = 0; c < D; ++c) {
        double* to = spilled.component(c) + run.spill;
        std::fill_n(to, run.length, 0.0);
        take(block, c, run, to);
      }
    });
  }

  /// Clears the forces.
  void discard(const Block& block) {
    if (block.has_list) std::fill_n(force_rows_.data(), std::size_t(vector_width<D>) * block.places, 0.0);
    for (int c = 0; block.has_lattice && c < D; ++c) std::fill_n(forces(c), block.places, 0.0);
  }

  std::size_t bytes() const {
    return displacement_.bytes() + velocity_.bytes() + velocity_rows_.bytes() + forces_.bytes() + place_rows_.bytes() +
           matrix_rows_.bytes() + vector_rows_.bytes() + force_rows_.bytes() + volume_.bytes() + radius_.bytes() + kept_.bytes();
  }

 private:
  template <class Use>
  void for_each_run(int begin, int end, Use&& use) const {
    for (int r = begin; r < end; ++r) use(pairs_.blocks.runs[r]);
  }

  void fill_rows(const Run& run, const Particles<D>& particles) {
    double* row = place_rows_.data() + std::size_t(place_width<D>) * run.place;
    for (int slot = run.slot; slot < run.slot + run.length; ++slot, row += place_width<D>)
      for (int c = 0; c < D; ++c) {
        row[c] = particles.displacement.component(c)[slot];
        row[vector_width<D> + c] = particles.position.component(c)[slot];
      }
  }

  void take(const Block& block, int component, const Run& run, double* __restrict to) {
    if (block.has_list) {
      double* __restrict row = force_rows_.data() + std::size_t(vector_width<D>) * run.place + component;
      for (int k = 0; k < run.length; ++k) {
        to[k] += row[vector_width<D> * k];
        row[vector_width<D> * k] = 0.0;
      }
    }
    if (block.has_lattice) {
      double* __restrict from = forces(component) + run.place;
      for (int k = 0; k < run.length; ++k) {
        to[k] += from[k];
        from[k] = 0.0;
      }
    }
  }

  const BlockPairs<D>& pairs_;
  int margin_;  ///< places that own particles of a lattice do not need, but the lanes beside them read
  VectorField<D> displacement_, velocity_, forces_;
  AlignedArray<double> place_rows_, velocity_rows_, matrix_rows_, vector_rows_, force_rows_, volume_, radius_, kept_;
};

/// Adds to the forces on the particles of one block what others have spilled into it, in their order.
template <int D>
void add_spilled(const Blocks& blocks, int index, const VectorField<D>& spilled, VectorField<D>& forces) {
  for (int s = blocks.first_in[index]; s < blocks.first_in[index + 1]; ++s)
    for (int r = blocks.in[s].first_run; r < blocks.in[s].end_run; ++r) {
      const Run& run = blocks.runs[r];
      for (int c = 0; c < D; ++c) {
        const double* __restrict from = spilled.component(c) + run.spill;
        double* __restrict to = forces.component(c) + run.slot;
        for (int k = 0; k < run.length; ++k) to[k] += from[k];
      }
    }
}

}  // namespace sinew
