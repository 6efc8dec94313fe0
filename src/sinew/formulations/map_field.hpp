#pragma once
/// The GradientMaps of all particles, copies of those of other ranks included: for weights that need both ends of a pair. In parts that travel as matrices do.

#include <array>
#include <sinew/corrections/correction.hpp>
#include <sinew/formulations/gradient_form.hpp>

namespace sinew {

template <int D>
class MapField {
 public:
  MapField() = default;
  explicit MapField(std::size_t places) { parts.fill(MatrixField<D>(places)); }

  bool empty() const { return parts[0].empty(); }
  void set(int slot, GradientMap<D> map) {
    int next = 0;
    for_each_number(map, [&](double& number) { at(next++, slot) = number; });
  }
  GradientMap<D> get(int slot) {
    GradientMap<D> map;
    int next = 0;
    for_each_number(map, [&](double& number) { number = at(next++, slot); });
    return map;
  }

 private:
  static constexpr int numbers = 2 * D * D + 2 * D + 2, width = D * D;
  double& at(int number, int slot) { return parts[number / width].at(number % width, slot); }
  template <class Use>
  static void for_each_number(GradientMap<D>& map, Use&& use) {
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) use(map.L[i][j]), use(map.bend[i][j]);
    for (int i = 0; i < D; ++i) use(map.shift[i]), use(map.tilt[i]);
    use(map.scale);
    use(map.kernel_scale);
  }

 public:
  std::array<MatrixField<D>, (numbers + width - 1) / width> parts;
};

}  // namespace sinew
