// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/flat_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "core/blossom/triangle_composition.h"
#include "core/forms/algebra/degree.h"
#include "core/watertight/piece_sides.h"

namespace blossom {
namespace {

constexpr int kMaxTurning = 2 * kMaxDegree / 3;  // degree that turning_form takes

const WatertightSide& side_of_piece(const WatertightPieces& pieces, const WatertightPiece& piece,
                                    std::size_t k) {
  return pieces.sides[static_cast<std::size_t>(piece.sides[k])];
}

// Through three points: the first one, the farthest from it, and the farthest from their line.
std::optional<PiecePlane> plane_through(const BezierTriangle& triangle) {
  PiecePlane plane{triangle.points.front(), {}, {}, 0};
  Vec3 way, normal;
  for (const Vec3& p : triangle.points)
    if (norm(p - plane.origin) > norm(way)) way = p - plane.origin;
  for (const Vec3& p : triangle.points)
    if (const Vec3 made = cross(way, p - plane.origin); norm(made) > norm(normal)) normal = made;
  if (!(norm(normal) > 0)) return {};
  plane.x = (1 / norm(way)) * way;
  plane.y = cross((1 / norm(normal)) * normal, plane.x);
  return plane;
}

// How far a side's curve is from the piece's own one; endless if it has a higher degree.
double gap_of_side(const WatertightPieces& pieces, const WatertightPiece& piece, std::size_t k) {
  const WatertightSide& side = side_of_piece(pieces, piece, k);
  if (side.curve.points.empty()) return 0;
  const BezierCurve own = side_curve(piece, static_cast<int>(k));
  if (side.curve.degree() > own.degree()) return HUGE_VAL;
  BezierCurve curve = elevated(side.curve, own.degree());
  if (!piece.along[k]) std::ranges::reverse(curve.points);
  double gap = 0;
  for (std::size_t i = 0; i < own.points.size(); ++i)
    gap = std::max(gap, distance(own.points[i], curve.points[i]));
  return gap;
}

// Counter-clockwise if need be by turning y round; whether it turns one way everywhere.
bool turns_one_way(PiecePlane& plane, const BezierTriangle& triangle) {
  BezierTriangle map{triangle.degree, {}};
  for (const Vec3& p : triangle.points) {
    const Vec2 at = plane.at(p);
    map.points.push_back({at[0], at[1], 1});
  }
  const BezierTriangleOf<double> turning = turning_form(map);
  if (std::ranges::all_of(turning.points, [](double x) { return x > 0; })) return true;
  plane.y = -plane.y;
  return std::ranges::all_of(turning.points, [](double x) { return x < 0; });
}

}  // namespace

double height_of(const BezierTriangle& triangle) {
  const int n = triangle.degree;
  const Vec3 a = triangle(n, 0), b = triangle(0, n), c = triangle(0, 0);
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  return longest > 0 ? norm(cross(b - a, c - a)) / longest : 0;
}

std::optional<PiecePlane> plane_of(const WatertightPieces& pieces, const WatertightPiece& piece,
                                   double within, double height) {
  const auto* triangle = std::get_if<BezierTriangle>(&piece.form);
  if (!triangle || triangle->degree < 1 || triangle->degree > kMaxTurning) return {};
  if (height_of(*triangle) < height) return {};
  std::optional<PiecePlane> plane = plane_through(*triangle);
  if (!plane) return {};
  const Vec3 normal = cross(plane->x, plane->y);
  for (const Vec3& p : triangle->points)
    plane->error = std::max(plane->error, std::abs(dot(p - plane->origin, normal)));
  double gap = 0;
  for (std::size_t k = 0; k < piece.sides.size(); ++k)
    gap = std::max(gap, gap_of_side(pieces, piece, k));
  plane->error += gap;
  if (plane->error > within || !turns_one_way(*plane, *triangle)) return {};
  return plane;
}

}  // namespace blossom
