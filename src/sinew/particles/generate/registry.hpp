#pragma once
/// The geometries, one line each.

#include <sinew/core/registry.hpp>
#include <sinew/particles/generate/annulus.hpp>
#include <sinew/particles/generate/box.hpp>
#include <sinew/particles/generate/cylinder.hpp>
#include <sinew/particles/generate/mean_spacing.hpp>
#include <sinew/particles/generate/mesh_file.hpp>
#include <sinew/particles/generate/point_list.hpp>
#include <sinew/particles/generate/polygon.hpp>
#include <sinew/particles/generate/sphere.hpp>

namespace sinew {

using Geometries = TypeList<Box, Cylinder, Sphere, Annulus, Polygon, MeshFile, PointList>;
using AnyGeometry = Geometries::Variant;

}  // namespace sinew
