// SPDX-License-Identifier: LGPL-2.1-or-later

#pragma once

#include <algorithm>

#include "core/math/vec.h"

namespace blossom {

/// The distance of `p` from the segment from `a` to `b`, which may be a point; in any dimension.
template <class Point>
double segment_gap(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const double square = dot(d, d);
  const double t = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  return norm(p - (a + t * d));
}

}  // namespace blossom
