// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/piece_sides.h"

#include <algorithm>
#include <variant>

#include "core/blossom/triangle_composition.h"
#include "core/math/index.h"

namespace blossom {
namespace {

constexpr double kRounding = 1e-15;  // of control points, relative to the largest

}  // namespace

BezierTriangle flat_if_it_is(const BezierTriangle& triangle) {
  double size = 0;
  for (const Vec3& p : triangle.points) size = std::max(size, max_norm(p));
  const int n = triangle.degree;
  for (int nu = 0; nu <= n; ++nu)
    for (int mu = 0; nu + mu <= n; ++mu) {
      const Vec3 flat =
          (1.0 / n) * (nu * triangle(n, 0) + mu * triangle(0, n) + (n - nu - mu) * triangle(0, 0));
      if (distance(flat, triangle(nu, mu)) > kRounding * size) return triangle;
    }
  return {1, {triangle(0, 0), triangle(0, n), triangle(n, 0)}};
}

BezierCurve side_curve(const WatertightPiece& piece, int k) {
  if (const auto* triangle = std::get_if<BezierTriangle>(&piece.form))
    return side_of(*triangle, k, (k + 1) % 3);
  const Grid<Vec3>& net = std::get<BezierPatch>(piece.form).points;
  const int n = net.rows() - 1, m = net.columns() - 1;
  BezierCurve curve;
  for (int i = 0; i <= (k % 2 == 0 ? n : m); ++i)
    curve.points.push_back(k == 0   ? net(i, 0)
                           : k == 1 ? net(n, i)
                           : k == 2 ? net(n - i, m)
                                    : net(0, m - i));
  return curve;
}

void set_side_curve(WatertightPiece& piece, int k, const BezierCurve& curve) {
  if (auto* triangle = std::get_if<BezierTriangle>(&piece.form))
    return set_side(*triangle, k, (k + 1) % 3, curve);
  Grid<Vec3>& net = std::get<BezierPatch>(piece.form).points;
  const int n = net.rows() - 1, m = net.columns() - 1;
  for (int i = 0; i <= curve.degree(); ++i)
    (k == 0   ? net(i, 0)
     : k == 1 ? net(n, i)
     : k == 2 ? net(n - i, m)
              : net(0, m - i)) = curve.points[index(i)];
}

}  // namespace blossom
