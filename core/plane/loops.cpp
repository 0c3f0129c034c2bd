// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/loops.h"

#include <cstddef>

#include "core/math/functions/quadrature.h"

namespace blossom {
namespace {

// A curve is a straight line to the ray after this many halvings: 2^-40 of its size.
constexpr int kDeepest = 40;

int halved_crossings(const PlanarBezier& curve, const Vec2& point, int depth) {
  const PlanarBox box = box_of(curve.points);
  if (box.high[1] <= point[1] || box.low[1] > point[1] || box.high[0] < point[0]) return 0;
  const Vec2 from = projected(curve.points.front());
  const Vec2 to = projected(curve.points.back());
  if (box.low[0] > point[0]) return (to[1] > point[1] ? 1 : 0) - (from[1] > point[1] ? 1 : 0);
  if (depth >= kDeepest) return ray_crossings(from, to, point);
  return halved_crossings(bezier_piece(curve, {0, 0.5}), point, depth + 1) +
         halved_crossings(bezier_piece(curve, {0.5, 1}), point, depth + 1);
}

}  // namespace

Vec2 start_of(const PlanarPath& path) { return projected(path.front().points.front()); }
Vec2 end_of(const PlanarPath& path) { return projected(path.back().points.back()); }
Vec2 middle_of(const PlanarPath& path) {
  return jet_at(path[path.size() / 2], path.size() % 2 == 0 ? 0.0 : 0.5).point;
}

int ray_crossings(const PlanarPath& path, const Vec2& point) {
  int sum = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    sum += halved_crossings(path[i], point, 0);
    if (i > 0)
      sum += ray_crossings(projected(path[i - 1].points.back()), projected(path[i].points.front()),
                           point);
  }
  return sum;
}

int ray_crossings(const Vec2& from, const Vec2& to, const Vec2& point) {
  const bool starts_above = from[1] > point[1];
  const bool ends_above = to[1] > point[1];
  if (starts_above == ends_above) return 0;
  const double side = cross(to - from, point - from);
  if (ends_above) return side > 0 ? 1 : 0;
  return side < 0 ? -1 : 0;
}

double area_along(const PlanarPath& path, const Vec2& origin) {
  double sum = 0;
  for (const PlanarBezier& curve : path) {
    if (curve.degree() == 1) {  // a triangle
      const Vec2 from = jet_at(curve, 0).point, to = jet_at(curve, 1).point;
      sum += 0.5 * cross(from - origin, to - from);
      continue;
    }
    auto rate = [&](double t) {
      const PlanarJet jet = jet_at(curve, t);
      return 0.5 * cross(jet.point - origin, jet.first);
    };
    sum += quadrature::cell(rate, 0, 1).value;
  }
  return sum;
}

}  // namespace blossom
