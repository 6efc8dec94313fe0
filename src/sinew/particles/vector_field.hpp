#pragma once
/// One vector a particle, component by component: all x, then all y, then all z. Eight particles in a row are one vector register, and what
/// lies at a fixed distance in the computing order is a plain (unaligned) load away. The distance between components is an odd number of
/// cache lines, so that the components of a particle never compete for the same place in a cache.

#include <algorithm>
#include <sinew/core/vec.hpp>
#include <sinew/particles/aligned_array.hpp>

namespace sinew {

template <int D>
class VectorField {
 public:
  VectorField() = default;
  explicit VectorField(std::size_t slots) : stride_(stride_of(slots)), data_(slots ? D * stride_ : 0) {}

  /// How far apart the components of a field of so many slots lie [doubles].
  static constexpr std::size_t stride_of(std::size_t slots) { return ((slots / per_line + 1) | 1) * per_line; }

  double* component(int c) { return data_.data() + c * stride_; }
  const double* component(int c) const { return data_.data() + c * stride_; }
  double& at(int c, int slot) { return component(c)[slot]; }
  double at(int c, int slot) const { return component(c)[slot]; }

  Vec<double, D> operator[](int slot) const {
    Vec<double, D> v;
    for (int c = 0; c < D; ++c) v[c] = at(c, slot);
    return v;
  }
  void set(int slot, const Vec<double, D>& v) {
    for (int c = 0; c < D; ++c) at(c, slot) = v[c];
  }

  bool empty() const { return data_.size() == 0; }
  void clear() { std::fill(data_.begin(), data_.end(), 0.0); }
  std::size_t bytes() const { return data_.bytes(); }

 private:
  static constexpr std::size_t per_line = 8;  ///< doubles in a cache line; slots come in multiples of it
  std::size_t stride_ = per_line;
  AlignedArray<double> data_;
};

}  // namespace sinew
