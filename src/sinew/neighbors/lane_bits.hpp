#pragma once
/// Lanes of a Pack as bits of a number, and the functions that a search needs for one double and for eight.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <sinew/core/pack.hpp>

namespace sinew::lane_bits {

template <class T>
inline constexpr int width = sizeof(T) / sizeof(double);

SINEW_INLINE void store(double value, double* to) { *to = value; }
SINEW_INLINE void store(const Pack& values, double* aligned) { values.store(aligned); }
SINEW_INLINE double smallest(double a) { return a; }
SINEW_INLINE double largest(double a) { return a; }
using sinew::largest;
using sinew::smallest;
using sinew::sqrt;
using std::sqrt;

/// Registers of truth values: one of eight lanes, or two of four.
template <class Register>
SINEW_INLINE unsigned bits_of_register(const Register& mask) {
  using FourBytes = signed char __attribute__((vector_size(4)));
  using EightBytes = signed char __attribute__((vector_size(8)));
  if constexpr (requires { mask.hi; }) {
    return bits_of_register(mask.lo) | bits_of_register(mask.hi) << 4;
  } else if constexpr (width<Register> == 4) {
    const auto bytes = std::bit_cast<std::uint32_t>(__builtin_convertvector(mask, FourBytes));
    return ((bytes & 0x08040201U) * 0x01010101U) >> 24;
  } else {
    const auto bytes = std::bit_cast<std::uint64_t>(__builtin_convertvector(mask, EightBytes));
    return static_cast<unsigned>(((bytes & 0x8040201008040201U) * 0x0101010101010101U) >> 56);
  }
}

/// Bit k tells whether lane k is true.
SINEW_INLINE unsigned bits_of(PackMask mask) { return bits_of_register(mask.v); }
SINEW_INLINE unsigned bits_of(bool mask) { return mask ? 1U : 0U; }

/// For every byte the numbers of its bits that are set, ascending.
struct SetBits {
  std::array<std::array<int, lanes>, 256> of{};
  constexpr SetBits() {
    for (int byte = 0; byte < 256; ++byte)
      for (int bit = 0, n = 0; bit < lanes; ++bit)
        if ((byte >> bit & 1) != 0) of[byte][n++] = bit;
  }
};
inline constexpr SetBits set_bits;

}  // namespace sinew::lane_bits
