// SPDX-License-Identifier: LGPL-2.1-or-later
// Signs that decide how points of a plane lie to each other, exactly.
//
// Values in double with a bound on their error decide nearly always; where they do not, rationals
// do. Coordinates are taken as the exact values of the doubles.

#pragma once

#include "core/math/vec.h"

namespace blossom {

/// The sign of (b - a) x (c - a): 1 if a, b, c go round counter-clockwise, 0 if they lie on a line.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// 1 if d lies inside of the circle through a, b, c, which go round counter-clockwise, -1 outside,
/// 0 on it.
int in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

}  // namespace blossom
