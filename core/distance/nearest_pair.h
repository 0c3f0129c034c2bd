// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of cells and how near they may be; pairs of points that are near.

#pragma once

#include <array>

#include "core/cells/cell_tree.h"
#include "core/forms/evaluation.h"

namespace blossom {

/// A cell with the number of its control points.
struct HullCell {
  const Cell* cell = nullptr;
  int points = 0;
};

/// A bound below the distance of any two points of the cells: of the boxes, and along directions:
/// the given one, and that from one middle to the other. Model units, roundings included.
double distance_bound(const HullCell& a, const HullCell& b, const Vec3& direction);

/// False if no line from one cell to the other is normal to both in the directions asked for,
/// that is, if r = A - B has r . S_u or r . S_v of one sign.
/// across_a, across_b   u and v: whether the line must be across this derivative
bool may_be_normal(const Cell& a, const std::array<bool, 2>& across_a, const Cell& b,
                   const std::array<bool, 2>& across_b);

/// A patch of which the first `dimension` parameters count; 0 is a point, 1 a curve.
struct PatchOf {
  const RationalBezierPatch* patch = nullptr;
  int dimension = 2;
  Interval u{0, 1}, v{0, 1};  ///< the piece of it that counts
};

/// Half the square of the distance, with derivatives by the parameters of both patches.
struct SquaredGap {
  PatchJet a, b;
  double value = 0;
  std::array<double, 4> slope{};  ///< by u, v of a, then of b
  std::array<std::array<double, 4>, 4> curvature{};
};
SquaredGap squared_gap(const PatchOf& a, const PatchOf& b, const std::array<double, 4>& at);

struct NearPair {
  Vec2 a, b;  ///< parameters of the patches
  Vec3 point_a, point_b;
};

/// A pair where the distance is locally least within the pieces, as far as Newton's method with
/// damping gets from a start in them. Never farther than the start.
NearPair near_pair(const PatchOf& a, const PatchOf& b, const Vec2& start_a, const Vec2& start_b);

}  // namespace blossom
