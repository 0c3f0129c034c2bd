// SPDX-License-Identifier: LGPL-2.1-or-later
// The point of a segment, which may be a point, nearest to another one; in any dimension.

#pragma once

#include <algorithm>

#include "core/math/vec.h"

namespace blossom {

/// At which part of the way from `a` to `b` it lies, in [0, 1].
template <class Point>
double nearest_part(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const double square = dot(d, d);
  return square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
}

/// The way to `p` from there.
template <class Point>
Point way_from_segment(const Point& p, const Point& a, const Point& b) {
  return p - (a + nearest_part(p, a, b) * (b - a));
}

/// Its distance.
template <class Point>
double segment_gap(const Point& p, const Point& a, const Point& b) {
  return norm(way_from_segment(p, a, b));
}

}  // namespace blossom
