// SPDX-License-Identifier: LGPL-2.1-or-later
// The ball or the cylinder that a surface follows at a point, and the circle of a tube.

#pragma once

#include <optional>

#include "core/forms/evaluation.h"
#include "core/forms/patch.h"
#include "core/math/vec.h"

namespace blossom {

/// A point, the line through it along a direction of unit length, or a circle about that line.
struct Centre {
  Vec3 point;
  Vec3 axis{};        ///< zero: the point alone
  double radius = 0;  ///< of the circle, model units; 0: the line
};

/// The centre of the ball if the surface bends alike in all directions, the axis of the cylinder if
/// it bends in one only; nothing if it does neither, is flat, or the jet is not regular.
/// normal   unit, across the surface
std::optional<Centre> centre_of_curvature(const PatchJet& jet, const Vec3& normal);

/// The circle that a patch follows at a distance, as pieces of a torus do. Nothing unless centres
/// of a principal curvature that is the same at three points lie, with that at the given one, on
/// one circle, all to some digits: it says where to look, and proves nothing.
/// at       where the patch is regular, its own parameters
std::optional<Centre> centre_circle(const RationalBezierPatch& patch, const Vec2& at);

}  // namespace blossom
