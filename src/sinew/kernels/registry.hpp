#pragma once
/// The kernels, one line each.

#include <sinew/core/registry.hpp>
#include <sinew/kernels/cubic_spline.hpp>
#include <sinew/kernels/quintic_spline.hpp>
#include <sinew/kernels/spiky.hpp>
#include <sinew/kernels/wendland_c2.hpp>

namespace sinew {

using Kernels = TypeList<Spiky, CubicSpline, QuinticSpline, WendlandC2>;
using AnyKernel = Kernels::Variant;

}  // namespace sinew
