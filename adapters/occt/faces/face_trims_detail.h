// SPDX-License-Identifier: LGPL-2.1-or-later
// What the parts of face_trims.h share.

#pragma once

#include "adapters/occt/faces/face_trims.h"

namespace blossom::occt {

/// A distance that counts as on the border, where no other is given. Model units, about.
inline constexpr double kOnBorder = 1e-7;

/// Relative to the box: parameters of natural borders are exact up to rounding.
inline constexpr double kNaturalError = 1e-9;

/// An edge may be as far from its wire as its tolerance says.
enum class Wires { AsTheyAre, WithTolerances };

/// The first coedge that may come within a margin of a rectangle, null if there is none. Wires are
/// halved that often to find out.
const Coedge* coedge_near(const FaceTrims& trims, const PlanarBox& box, double margin, int halvings,
                          Wires wires = Wires::WithTolerances);

/// The first coedge within kOnBorder of a point in chart coordinates, null if there is none.
const Coedge* coedge_at(const FaceTrims& trims, const Vec2& point,
                        Wires wires = Wires::WithTolerances);

/// Joins meetings, and runs, of a curve with wires that are one touch each, or one end of the
/// curve. found   meetings by increasing parameter
void join_touches(const FaceTrims& trims, const PlanarCurve& curve, double tolerance,
                  ClippedCurve& found);

}  // namespace blossom::occt
