#pragma once
/// The one sweep over the pairs of a chunk. The loops are in neighbors/for_each.hpp; what stands here is what happens at a point.

#include <cmath>
#include <sinew/formulations/sweep_dispatch.hpp>
#include <sinew/neighbors/for_each.hpp>

namespace sinew {

/// Weighted gradient of the kernel from a stored scalar: V_j a_ij X_ij; the correction L is applied once a particle.
template <int D>
struct RadialGradient {
  const double* weight;
  const double* correction;

  SINEW_INLINE Vec<Pack, D> operator()(const PairPack<D>& pair) const { return Pack::load(weight + lanes * pair.entry) * pair.X; }
  SINEW_INLINE Mat<Pack, D> matrix(int slice) const {
    const double* first = correction + std::size_t(lanes) * symmetric_size<D> * slice;
    Mat<Pack, D> L;
    for (int i = 0, c = 0; i < D; ++i)
      for (int j = i; j < D; ++j, ++c) L[i][j] = L[j][i] = Pack::load(first + lanes * c);
    return L;
  }
};

/// Weighted gradient from stored vectors V_j g_ij, complete as they are.
template <int D>
struct StoredGradient {
  const double* vector;

  SINEW_INLINE Vec<Pack, D> operator()(const PairPack<D>& pair) const {
    Vec<Pack, D> g;
    for (int c = 0; c < D; ++c) g[c] = Pack::load(vector + lanes * (D * pair.entry + c));
    return g;
  }
  SINEW_INLINE Mat<Pack, D> matrix(int) const { return Mat<Pack, D>::identity(); }
};

/// No hourglass force.
struct NoHourglass {};
/// The two forms of HourglassStiffness.
struct ConservativeHourglass {
  template <int D>
  static SINEW_INLINE auto share(const Mat<Pack, D>& F, const PairPack<D>& pair, const Pack& weight) {
    return HourglassStiffness::conservative_share(F, pair.X, pair.X + pair.u, weight);
  }
};
struct CentralHourglass {
  template <int D>
  static SINEW_INLINE auto share(const Mat<Pack, D>& F, const PairPack<D>& pair, const Pack& weight) {
    return HourglassStiffness::central_share(F, pair.X, pair.X + pair.u, weight);
  }
};

/// F of eight particles.
template <int D, class Gradient>
SINEW_INLINE Mat<Pack, D> deformation_gradient(const PairList& list, const double* places, int slice, const PlacePack<D>& own,
                                               const Gradient& gradient, const Mat<Pack, D>& L) {
  Mat<Pack, D> sum;
  for_each_pair<D>(list, places, slice, own, [&](const PairPack<D>& pair) { sum += outer(pair.u, gradient(pair)); });
  return Mat<Pack, D>::identity() + sum * L;
}

/// The law that holds once F33 is known: the material itself, or what a plane-stress wrapper holds.
template <class Material>
SINEW_INLINE const auto& bulk_law(const Material& material) {
  if constexpr (requires { typename Material::Bulk; })
    return static_cast<const typename Material::Bulk&>(material);
  else
    return material;
}

/// F in three dimensions: F33 is 1 in plane strain and follows from the material in plane stress.
template <int D, class Material>
SINEW_INLINE Mat3<Pack> in_three_dimensions(const Material& material, const Mat<Pack, D>& F) {
  Mat3<Pack> F3 = embed(F, Pack(1.0));
  if constexpr (requires { material.thickness_stretch(F3); }) F3[2][2] = material.thickness_stretch(F3);
  return F3;
}

/// Keeps what `record` asks for, lane after lane.
inline void keep(RecordedState& state, int slice, const Mat3<Pack>& F, const Response<Pack, NoState>& response,
                 const Pack& error2) {
  for (int k = 0; k < lanes; ++k) {
    const std::size_t slot = std::size_t(lanes) * slice + k;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        state.deformation_gradient[9 * slot + 3 * i + j] = F[i][j][k];
        state.stress[9 * slot + 3 * i + j] = response.P[i][j][k];
      }
    state.energy_density[slot] = response.energy[k];
    state.hourglass_error[slot] = std::sqrt(error2[k]);
  }
}

template <int D, class Hourglass, bool recording, class Gradient, class Material>
ForceSummary sweep_chunk(const SweepTask<D>& task, const Gradient& gradient, const Material& material) {
  const PairList& list = task.list;
  const double* places = task.particles.place.data();
  Pack energy(0.0), hourglass_energy(0.0), jacobian(infinity), rate2(0.0);
  for (int slice = task.chunk.first_slice; slice < task.chunk.end_slice; ++slice) {
    const PlacePack<D> own = load_slice<D>(places, slice);
    const Mat<Pack, D> L = gradient.matrix(slice);
    const Mat<Pack, D> F = deformation_gradient<D>(list, places, slice, own, gradient, L);

    const Mat3<Pack> F3 = in_three_dimensions<D>(material, F);
    const auto response = bulk_law(material).respond(F3);
    const Pack volume = Pack::load(task.particles.volume.data() + lanes * slice) * task.scalars.thickness;
    energy += volume * response.energy;
    jacobian = min(jacobian, determinant(F3));
    rate2 =
        max(rate2, bulk_law(material).acoustic_stiffness(F3) * Pack::load(task.weights.inverse_length2.data() + lanes * slice));

    // the share of i of each pair force is linear in its stress and in its deformation gradient
    const Mat<Pack, D> Q = (volume * in_plane<D>(response.P)) * L;
    const Pack stiffness = volume * task.scalars.hourglass;
    exchange_pairs<D>(list, places, slice, own, task.force_rows, [&](const PairPack<D>& pair) {
      Vec<Pack, D> t = Q * gradient(pair);
      if constexpr (!std::is_same_v<Hourglass, NoHourglass>) {
        const auto share = Hourglass::share(F, pair, stiffness * Pack::load(task.weights.stiffness.data() + lanes * pair.entry));
        hourglass_energy += share.energy;
        t += share.force;
      }
      return t;
    });

    if constexpr (recording) {
      Pack error2(0.0);
      for_each_pair<D>(list, places, slice, own, [&](const PairPack<D>& pair) {
        const Vec<Pack, D> error = F * pair.X - (pair.X + pair.u);
        error2 = max(error2, dot(error, error) / (dot(pair.X, pair.X) + 1e-200));
      });
      keep(*task.record, slice, F3, response, error2);
    }
  }
  return {sum(energy), sum(hourglass_energy), smallest(jacobian), largest(rate2) / task.scalars.density};
}

/// Chooses the sweep for what a case combines. One choice a chunk, outside of all loops.
template <int D, class Material>
ForceSummary sweep_chunk_of(const SweepTask<D>& task, const Material& material) {
  auto with = [&]<class Hourglass>(const auto& gradient) {
    if (task.record) return sweep_chunk<D, Hourglass, true>(task, gradient, material);
    return sweep_chunk<D, Hourglass, false>(task, gradient, material);
  };
  auto choose = [&](const auto& gradient) {
    if (task.scalars.hourglass == 0.0) return with.template operator()<NoHourglass>(gradient);
    if (task.scalars.conservative) return with.template operator()<ConservativeHourglass>(gradient);
    return with.template operator()<CentralHourglass>(gradient);
  };
  if (task.weights.radial) return choose(RadialGradient<D>{task.weights.gradient.data(), task.weights.correction.data()});
  return choose(StoredGradient<D>{task.weights.gradient.data()});
}

}  // namespace sinew
