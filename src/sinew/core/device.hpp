#pragma once
/// Marks of point-wise functions. SINEW_INLINE: always inlined. SINEW_POINTWISE: large ones, left to the compiler. Where the compiler
/// also writes code for a device (CUDA), both may be called there.

#if defined(__CUDACC__)
#define SINEW_POINTWISE __host__ __device__
#define SINEW_INLINE SINEW_POINTWISE __forceinline__
#else
#define SINEW_POINTWISE
#define SINEW_INLINE inline __attribute__((always_inline))
#endif
