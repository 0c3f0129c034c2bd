// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/lower_degrees.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/math/index.h"

namespace blossom {
namespace {

constexpr double kExact = 1e-13;  // of curves that are of a lower degree, relative to the largest

int straight_degree(const BezierSurface& surface) {
  int most = 0;
  for (const RationalBezierPatch& patch : surface.patches.values())
    most = std::max(most, patch.points.rows() + patch.points.columns() - 2);
  return most;
}

// Whether a side has a rectangle, which keeps its degrees and so the side as it is.
std::vector<bool> sides_of_patches(const WatertightPieces& pieces) {
  std::vector<bool> found(pieces.sides.size(), false);
  for (const WatertightPiece& piece : pieces.pieces)
    if (std::holds_alternative<BezierPatch>(piece.form))
      for (const int side : piece.sides) found[index(side)] = true;
  return found;
}

void lower_side(WatertightSide& side, int lowest, double tolerance) {
  for (int degree = lowest; degree < side.curve.degree(); ++degree) {
    auto lower = reduced(side.curve, degree);
    if (lower.error > tolerance) continue;
    side.curve = std::move(lower.form);
    return;
  }
}

double size_of(const BezierCurve& curve) {
  double size = 0;
  for (const Vec3& p : curve.points) size = std::max(size, max_norm(p));
  return size;
}

}  // namespace

void DegreeLowering::lower(WatertightPieces& pieces, const std::vector<BezierSurface>& surfaces,
                           int highest, double tolerance) {
  const std::vector<bool> of_patch = sides_of_patches(pieces);
  for (const WatertightPiece& piece : pieces.pieces) {
    const int straight = straight_degree(surfaces[index(piece.face)]);
    for (const int number : piece.sides) {
      WatertightSide& side = pieces.sides[index(number)];
      if (side.edge >= 0) continue;
      if (of_patch[index(number)])
        lower_side(side, straight, kExact * size_of(side.curve));
      else
        lower_side(side, 1, tolerance);
    }
  }
  for (WatertightPiece& piece : pieces.pieces)
    lower_triangle(piece, pieces.sides, highest, tolerance);
}

void DegreeLowering::lower_triangle(WatertightPiece& piece,
                                    const std::vector<WatertightSide>& sides, int highest,
                                    double tolerance) {
  auto* triangle = std::get_if<BezierTriangle>(&piece.form);
  if (!triangle) return;
  int degree = 1;
  for (const int side : piece.sides) degree = std::max(degree, sides[index(side)].curve.degree());
  auto lower = lowered_(*triangle, degree, std::max(highest, degree), tolerance);
  *triangle = std::move(lower.form);
  piece.moved = lower.error;
}

}  // namespace blossom
