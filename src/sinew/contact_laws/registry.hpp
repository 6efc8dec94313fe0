#pragma once
/// The laws of contact and the shapes of walls, one line each.

#include <sinew/contact_laws/hertz.hpp>
#include <sinew/contact_laws/wall_shapes.hpp>
#include <sinew/core/registry.hpp>

namespace sinew {

using ContactLaws = TypeList<HertzContact>;
using AnyContactLaw = ContactLaws::Variant;

using WallShapes = TypeList<PlaneWall, BoxWall, CylinderWall, SphereWall>;
using AnyWallShape = WallShapes::Variant;

}  // namespace sinew
