// SPDX-License-Identifier: LGPL-2.1-or-later
// The ball or the cylinder that a surface follows at a point.

#pragma once

#include <optional>

#include "core/forms/evaluation.h"
#include "core/math/vec.h"

namespace blossom {

/// A point, or the line through it along a direction of unit length.
struct Centre {
  Vec3 point;
  Vec3 axis{};  ///< zero: the point alone
};

/// The centre of the ball if the surface bends alike in all directions, the axis of the cylinder if
/// it bends in one only; nothing if it does neither, is flat, or the jet is not regular.
/// normal   unit, across the surface
std::optional<Centre> centre_of_curvature(const PatchJet& jet, const Vec3& normal);

}  // namespace blossom
