#pragma once
/// Between a material, known only as one of many, and the sweep, which is compiled once for all of them: the response of eight particles at
/// once behind one call a slice.

#include <sinew/damage/registry.hpp>
#include <sinew/formulations/slice_slots.hpp>
#include <sinew/materials/registry.hpp>

namespace sinew {

/// What a particle with history tells about itself besides its stress.
struct PlasticState {
  Pack strain{0.0};          ///< equivalent plastic strain
  Pack work{0.0};            ///< plastic work per reference volume, dissipated [pressure]
  Pack temperature{0.0};     ///< [K]; 0 where the material knows none
  Pack increment{0.0};       ///< of the strain in this step
  Pack work_increment{0.0};  ///< of the work [pressure]
};

/// What damage has done to a particle.
struct DamageState {
  Pack now{0.0};     ///< D
  Pack work{0.0};    ///< dissipated by damage per reference volume [pressure]
  Pack intact{1.0};  ///< 1 - D before this step
  Pack left{1.0};    ///< part of that which is left after it
};

template <int D>
struct PointResponse {
  Mat<Pack, D> P;               ///< first Piola-Kirchhoff stress in the plane (2D) or in space [pressure]
  Pack energy;                  ///< strain energy per reference volume [pressure]
  Pack jacobian;                ///< det F, in three dimensions
  Pack acoustic_stiffness;      ///< bound of density times the squared wave speed in the reference frame [pressure]
  Pack hourglass_modulus;       ///< of the hourglass stiffness in this step [pressure]
  Pack hourglass_left{1.0};     ///< part of it that is left for the next step
  Pack thickness_stretch{1.0};  ///< F33
  Pack thickness_stress{0.0};   ///< P33 in 2D [pressure]
  PlasticState plastic{};
  DamageState damage{};
};

/// The histories of a block: number n of the particle in `slot` is values[n * count + slot - first].
struct HistorySlots {
  double* values = nullptr;
  int count = 0, first = 0;
};

/// What a sweep does with histories: they belong to the state already; or to an earlier one, from which materials go on to the state, and the new ones are kept or not. Or they belong
/// to the state, and what materials that are written in rates know of its shape is forgotten; see SliceHistory::shapeless.
enum class HistoryUse { recall, respond, advance, forget };

/// How far time has gone since the histories, and what to do with them.
struct PointStep {
  double dt = 0.0;
  HistoryUse use = HistoryUse::recall;
  bool keep() const { return use == HistoryUse::advance || use == HistoryUse::forget; }
  bool respond() const { return use == HistoryUse::respond || use == HistoryUse::advance; }
};

/// Of eight particles whose reference configuration has been renewed: F = since * earlier.
template <int D>
struct LaterFrame {
  Mat<Pack, D> since, earlier;
};

template <int D>
struct SliceHistory {
  HistorySlots block;
  SliceSlots<D> slots;
  PointStep step;
  const double* radius;  ///< by slot: support radius [length]
  /// If given, a material that is written in rates puts here F with the same volume and no shape, from which it will go on.
  Mat<Pack, D>* shapeless = nullptr;
  const LaterFrame<D>* later = nullptr;  ///< if given, the acoustic stiffness is that of this frame, per volume of the first one
};

/// Where damage finds its numbers in a history, and the speed of sound of the material.
struct DamageStep {
  int first_number = 0;
  double sound_speed = 0.0;
};

/// Fills `response` for the deformation gradient F.
template <int D>
struct MaterialPoint {
  using Function = void (*)(const void* material, const Mat<Pack, D>& F, const SliceHistory<D>* history, PointResponse<D>& out);
  using DamageFunction = void (*)(const void* damage, const Mat<Pack, D>& F, const SliceHistory<D>& history,
                                  const DamageStep& step, PointResponse<D>& out);
  const void* material;
  Function function;
  int numbers;                   ///< of a particle's history
  int first_shape = 0;           ///< numbers [first_shape, those of damage) are a plastic shape, zero where there is none
  const void* damage = nullptr;  ///< nullptr: none
  DamageFunction damage_function = nullptr;
  DamageStep damage_step{};

  /// `history`: may be nullptr where there are no numbers and no later frame.
  void operator()(const Mat<Pack, D>& F, const SliceHistory<D>* history, PointResponse<D>& response) const {
    function(material, F, history, response);
    if (damage) damage_function(damage, F, *history, damage_step, response);
  }
};

/// Material and damage (nullptr: none) stay with the caller. `plane_stress`: only in 2D, and only without history.
template <int D>
MaterialPoint<D> material_point(const AnyMaterial& material, const AnyDamage* damage, bool plane_stress);

}  // namespace sinew
