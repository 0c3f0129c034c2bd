// SPDX-License-Identifier: LGPL-2.1-or-later
// What draws of pairs from the cubic family share: coordinates in any place and direction, any
// base, and how far the curves found lie from the truth.

#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/surface_intersection.h"
#include "tests/support/cubic_family.h"
#include "tests/support/random.h"

namespace blossom::testing {

/// Coordinates round a random place, in a random direction.
struct Frame {
  double angle, x0, y0, c, s;
  Cubic x, y;

  explicit Frame(Random& random)
      : angle(uniform(random, 0, 2 * std::numbers::pi)),
        x0(uniform(random, 0.25, 0.75)),
        y0(uniform(random, 0.25, 0.75)),
        c(std::cos(angle)),
        s(std::sin(angle)),
        x(linear(-c * x0 - s * y0, c, s)),
        y(linear(s * x0 - c * y0, -s, c)) {}

  /// The point of the unit square with these coordinates.
  Vec2 point(double along, double across) const {
    return {x0 + c * along - s * across, y0 + s * along + c * across};
  }
};

inline Cubic random_base(Random& random) {
  Cubic base;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; i + j < 4; ++j) base.coefficient[i][j] = uniform(random, -0.3, 0.3);
  return base;
}

/// Largest |h| at the samples: how far the curves lie from where they should.
///
/// swapped   h belongs to the parameters of b
inline double largest_offset(const Cubic& h, bool swapped, const SurfaceIntersection& found) {
  double largest = 0;
  for (const IntersectionCurve& curve : found.curves)
    for (const SurfacePoint& sample : curve.samples) {
      const Vec2 uv = swapped ? sample.uv_b : sample.uv_a;
      largest = std::max(largest, std::abs(h(uv[0], uv[1])));
    }
  return largest;
}

}  // namespace blossom::testing
