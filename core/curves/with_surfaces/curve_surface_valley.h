// SPDX-License-Identifier: LGPL-2.1-or-later
// A piece of a curve that runs nearly along a cell of a surface, as one function of one variable.
//
// With n the normal of the surface in the middle of the cell, the two equations n x (C(t) - S(x)) =
// 0 give each t its foot x(t) = (u, v), and
//
//   h(t) = n . (C(t) - S(x(t)))
//
// is the gap along n. Where it is proven strictly convex (or concave) it has at most two zeros and
// one least value; its signs at three places tell all: two common points, one, a touch, or none.
// That decides touches at the scale of the curvature, long before the cells are as small as the
// tolerance.

#pragma once

#include <array>
#include <optional>

#include "core/cells/cell_tree.h"
#include "core/cells/curve_cells.h"

namespace blossom {

/// A place on the curve and one on the surface.
struct FoundCurveSurfacePoint {
  SpanPoint t;
  int patch = 0;
  Vec2 uv;  ///< local, in [0, 1]
  /// The only common point near it, to rounding; else only within tolerance.
  bool exact = false;
  Vec3 reach;  ///< how far rounding may move it in t, u, v
};

/// A least gap within tolerance.
struct CurveSurfaceTouch {
  SpanPoint t;
  int patch = 0;
  Vec2 uv;                 ///< local, in [0, 1]
  double gap_low = 0;      ///< proven: the curve comes no closer to the surface here, model units
  Interval run;            ///< of the span along which the gap stays within tolerance, about
  double half_length = 0;  ///< of the run, model units
  bool at_end = false;     ///< of the piece: the gap may go on falling beyond it
};

struct CurveSurfaceValleyPoints {
  std::array<FoundCurveSurfacePoint, 2> points;
  int count = 0;
  std::optional<CurveSurfaceTouch> touch;
};

/// What a valley is measured by.
struct CurveSurfaceValleyOptions {
  double tolerance;  ///< least values up to this count as touches, model units
  double longest;    ///< longer contacts are left to others, model units
  double rounding;   ///< bound on the error of the distance of two points, model units
};

/// The common points and the touch of a piece of a curve and a cell.
///
/// patch     index of the tree's patch, for the answer
/// returns   nothing if the pair is not decided: the gap is not proven convex, the contact would be
///           too long, or an end of the curve or the border of the patch is within tolerance of it
std::optional<CurveSurfaceValleyPoints> pierce_valley(const CurveTree& curve,
                                                      const CurveCell& piece, int patch,
                                                      const CellTree& tree, const Cell& cell,
                                                      const CurveSurfaceValleyOptions& options);

}  // namespace blossom
