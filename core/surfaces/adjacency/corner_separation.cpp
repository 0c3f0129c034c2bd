// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/adjacency/corner_separation.h"

#include <algorithm>

#include "core/base/unbounded.h"

namespace blossom {
namespace {

constexpr double kAtCorner = 1e-3;  // of the reach: what is so near is at the point

// A cell's control points as seen from a point.
struct SeenFrom {
  SeenFrom(const Vec3& corner, const Cell& seen, int points, double near) : cell(seen) {
    for (int i = 0; i < points; ++i) {
      const Vec3 x = point(corner, i, points);
      const double distance = norm(x);
      if (distance <= near) {
        at_corner = std::max(at_corner, distance);
      } else {
        way = way + x * (1 / distance);
        farthest = std::max(farthest, distance);
      }
    }
  }

  Vec3 point(const Vec3& corner, int i, int points) const {
    return Vec3{cell.hull[i], cell.hull[points + i], cell.hull[2 * points + i]} - corner;
  }

  // The least height of what is not at the corner.
  double least_height(const Vec3& corner, const Vec3& normal, int points, double near) const {
    double least = kUnbounded;
    for (int i = 0; i < points; ++i) {
      const Vec3 x = point(corner, i, points);
      if (norm(x) > near) least = std::min(least, dot(normal, x));
    }
    return least - 2 * cell.margin;
  }

  const Cell& cell;
  double at_corner = 0;
  double farthest = 0;
  Vec3 way;  // to the points that are not at the corner
};

bool comes_to(const Vec3& corner, const Cell& cell) {
  for (int k = 0; k < 3; ++k)
    if (corner[k] < cell.low[k] || corner[k] > cell.high[k]) return false;
  return true;
}

}  // namespace

bool separated_at(const Vec3& corner, const Cell& a, const Cell& b, int points_a, int points_b,
                  double reach) {
  if (!comes_to(corner, a) || !comes_to(corner, b)) return false;
  const double near = std::max(kAtCorner * reach, a.margin + b.margin);
  const SeenFrom of_a(corner, a, points_a, near), of_b(corner, b, points_b, near);
  if (of_a.farthest == 0 || of_b.farthest == 0) return false;
  const Vec3 normal = unit(unit(of_a.way) - unit(of_b.way));
  const double above = of_a.least_height(corner, normal, points_a, near);
  const double below = of_b.least_height(corner, -normal, points_b, near);
  if (!(above > 0 && below > 0)) return false;
  const double off = std::max(of_a.at_corner, of_b.at_corner) + a.margin + b.margin;
  return off + 2 * off * std::min(of_a.farthest / above, of_b.farthest / below) <= reach;
}

}  // namespace blossom
