// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/adjacency/path_reach.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"

namespace blossom {
namespace {

constexpr double kCosineSlack = 1e-12;  // of cosines, for roundings

// Least cosines over the corners: vectors at no larger angle than that make a convex cone.
struct Cosines {
  double whole = 1;
  double seen = 1;  // along `mean`
};

Cosines least_cosines(const Vec3& m, const Vec3& mean, std::span<const VectorBounds> across) {
  Cosines least;
  for (const VectorBounds& bounds : across)
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 x = bounds.middle;
      for (int k = 0; k < 3; ++k)
        x[k] += (corner >> k) % 2 == 0 ? bounds.radius[k] : -bounds.radius[k];
      const double length = norm(x), seen = norm(x - mean * dot(mean, x)), height = dot(m, x);
      least.whole = std::min(least.whole, length > 0 ? height / length : -1);
      least.seen = std::min(least.seen, seen > 0 ? height / seen : -1);
    }
  return {least.whole - kCosineSlack, least.seen - kCosineSlack};
}

}  // namespace

double path_reach(std::span<const VectorBounds> across, std::span<const Vec3> along) {
  Vec3 mean;
  for (const Vec3& x : along) mean = mean + unit(x);
  mean = unit(mean);
  Vec3 m;
  for (const VectorBounds& bounds : across) {
    const Vec3 x = unit(bounds.middle);
    m = m + unit(x - mean * dot(mean, x));
  }
  m = unit(m);
  if (!(norm(m) > 0.5)) return kInfinity;
  const Cosines c = least_cosines(m, mean, across);
  // Multiples of unit vectors that are this near their mean add up to no less than this part.
  double largest = 0, kept = 1;
  for (const Vec3& x : along) {
    largest = std::max(largest, std::abs(dot(m, unit(x))) + kCosineSlack);
    kept = std::min(kept, dot(mean, unit(x)) - kCosineSlack);
  }
  if (!(kept > 0 && c.whole > 0)) return kInfinity;
  const double s = largest / kept, t = std::sqrt(std::max(0.0, 1 - kept * kept)) / kept;
  const double room = c.seen - s / c.whole;
  return room > 0 ? (1 + s) / room * (1 + t / c.whole) : kInfinity;
}

}  // namespace blossom
