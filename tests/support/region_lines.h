// SPDX-License-Identifier: LGPL-2.1-or-later
// Straight borders of regions.

#pragma once

#include "core/tessellation/shape_facets.h"

namespace blossom::testing {

/// The line from a to b, over parameters from 0 to 1, between two corners by number; walked on from
/// b to a if reversed.
inline RegionBorder line(const Vec2& a, const Vec2& b, int from, int to, bool reversed = false) {
  RegionBorder border;
  border.curve = planar_line(a, b, {0, 1});
  border.reversed = reversed;
  border.from = from;
  border.to = to;
  return border;
}

}  // namespace blossom::testing
