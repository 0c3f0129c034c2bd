// SPDX-License-Identifier: LGPL-2.1-or-later
// Vertices that only two triangles have.

#pragma once

#include "core/trimming/watertight.h"

namespace blossom {

/// Divides triangles until no vertex on an edge is the tip of just two, one on each side of the
/// edge. Such two have two sides in common: samples of these beside the tip would be corners of one
/// facet of each, and both facets the same. One of the two and the triangle behind it are halved;
/// where both have a rectangle or an edge behind them, the tip stays.
///
/// pieces   before their sides are moved; triangles above kMaxDegree are left as they are
void divide_closed_tips(WatertightPieces& pieces);

}  // namespace blossom
