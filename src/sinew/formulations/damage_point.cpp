#include <sinew/formulations/damage_point.hpp>

namespace sinew {

namespace {

SINEW_INLINE Mat3<Pack> whole(const Mat<Pack, 3>& a, const Pack&) { return a; }
SINEW_INLINE PlaneMatrix<Pack> whole(const Mat<Pack, 2>& a, const Pack& out_of_plane) { return {a, out_of_plane}; }
SINEW_INLINE void put(const Mat3<Pack>& P, PointResponse<3>& out) { out.P = P; }
SINEW_INLINE void put(const PlaneMatrix<Pack>& P, PointResponse<2>& out) {
  out.P = P.in_plane;
  out.thickness_stress = P.out_of_plane;
}

/// The numbers of damage in the history of a slice.
template <int D>
class DamageHistory {
 public:
  DamageHistory(const SliceHistory<D>& slice, int first)
      : slice_(slice),
        values_(slice.block.values + static_cast<std::ptrdiff_t>(first) * slice.block.count) {}
  Pack load(int number) const { return slice_.slots.load(at(number), slice_.block.first); }
  void store(int number, const Pack& value) const { slice_.slots.store(value, at(number), slice_.block.first); }

 private:
  double* at(int number) const { return values_ + static_cast<std::ptrdiff_t>(number) * slice_.block.count; }
  const SliceHistory<D>& slice_;
  double* values_;
};

/// What damage has dissipated, and the plastic work that was not done.
struct DissipatedPart {
  Pack work, not_flowed;
};

/// Takes its share of the stress and of the energy away.
template <int D, class M>
SINEW_INLINE void weaken(const M& F, const M& P, const Pack& before, const Pack& now, DissipatedPart& part,
                         PointResponse<D>& out) {
  out.damage.now = now;
  out.damage.intact = 1.0 - before;
  out.damage.left = select(before < Pack(1.0), (1.0 - now) / max(1.0 - before, Pack(1e-300)), Pack(1.0));
  if (any(now > Pack(0.0))) {
    const DamagedStress<M> stress = damaged(F, P, now);
    put(stress.P, out);
    part.work += stress.pulling * out.energy * (now - before);
    part.not_flowed += stress.pulling * now * out.plastic.work_increment;
    out.energy = out.energy * (1.0 - stress.pulling * now);
  }
  out.damage.work = part.work;
  out.plastic.work -= part.not_flowed;
}

template <int D, class Model>
void damage_slice(const void* pointer, const Mat<Pack, D>& plane, const SliceHistory<D>& slice, const DamageStep& step,
                  PointResponse<D>& out) {
  const Model& model = *static_cast<const Model*>(pointer);
  const auto F = whole(plane, out.thickness_stretch), P = whole(out.P, out.thickness_stress);
  using M = std::remove_cvref_t<decltype(F)>;
  const DamageHistory<D> history(slice, step.first_number);
  const Pack root = history.load(0), before = root * root * root;
  Pack now = before;
  DissipatedPart part{history.load(1), history.load(2)};
  if (slice.step.keep()) {
    Pack remembered(0.0);
    if constexpr (Model::numbers > 0) remembered = history.load(damage_numbers);
    const DamagePoint<M> point{F, P, out.plastic.strain, out.plastic.increment, out.plastic.temperature, slice.step.dt};
    const auto active = model.begins(point, &remembered) | (root > Pack(0.0));
    const Pack radius = slice.slots.load(slice.radius);
    const Pack grown = model.growth.grow(root, active, Pack(step.sound_speed * slice.step.dt) / max(radius, Pack(1e-300)));
    now = grown * grown * grown;
    history.store(0, grown);
    if constexpr (Model::numbers > 0) history.store(damage_numbers, remembered);
  }
  weaken(F, P, before, now, part, out);
  if (slice.step.keep()) history.store(1, part.work), history.store(2, part.not_flowed);
}

}  // namespace

int numbers_of(const AnyDamage& damage) {
  return damage_numbers + std::visit([]<class Model>(const Model&) { return Model::numbers; }, damage);
}

template <int D>
typename MaterialPoint<D>::DamageFunction damage_function(const AnyDamage& damage) {
  return std::visit([]<class Model>(const Model&) -> typename MaterialPoint<D>::DamageFunction { return damage_slice<D, Model>; },
                    damage);
}

template typename MaterialPoint<2>::DamageFunction damage_function<2>(const AnyDamage&);
template typename MaterialPoint<3>::DamageFunction damage_function<3>(const AnyDamage&);

}  // namespace sinew
