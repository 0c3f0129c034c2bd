// SPDX-License-Identifier: LGPL-2.1-or-later
// What the sources of curve_clip.h share.

#pragma once

#include "core/topology/clipping/curve_clip.h"

namespace blossom {

/// Joins meetings, and runs, of a curve with wires that are one touch each, or one end of the
/// curve. found   meetings by increasing parameter
void join_touches(const FaceTrims& trims, const PlanarCurve& curve, double tolerance,
                  ClippedCurve& found);

}  // namespace blossom
