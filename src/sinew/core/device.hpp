#pragma once
/// Marks of point-wise functions: always inlined on the host; a device compiler adds its own.

#if defined(__CUDACC__)
#define SINEW_INLINE __host__ __device__ __forceinline__
#elif defined(__GNUC__)
#define SINEW_INLINE inline __attribute__((always_inline))
#else
#define SINEW_INLINE inline
#endif
