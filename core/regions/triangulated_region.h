// SPDX-License-Identifier: LGPL-2.1-or-later
// A trimmed surface without trims: Bezier patches and triangles that cover what the trims leave.
//
// Away from the trims each patch is cut into cells, which are Bezier patches again. Between them
// and the trims are triangles, straight in the parameters but for the sides that are trims; over
// those the surface is a triangular Bezier patch of degree q (n + m), q the degree of the trim in
// the parameters. Neighbours share whole sides: no side ends in the middle of another.

#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "core/forms/patch.h"
#include "core/forms/surface.h"
#include "core/forms/triangle.h"
#include "core/regions/curved_triangles.h"
#include "core/regions/triangle_lowering.h"

namespace blossom {

/// A rectangle in the parameters of its patch.
struct RegionCell {
  Interval u;
  Interval v;
  std::array<int, 4> vertices;  ///< from (u.from, v.from) counter-clockwise
};

struct RegionPiece {
  int patch_u = 0;
  int patch_v = 0;
  std::variant<RegionCell, CurvedTriangle> shape;
  bool exact = true;       ///< its border is the trim itself, where it is trimmed
  double error = 0;        ///< bound on the distance of its border from the trim; model units
  double off_surface = 0;  ///< bound on how far it leaves the surface, as its degree was lowered
};

struct TriangulatedRegion {
  std::vector<RegionPiece> pieces;
  std::vector<RegionArc> arcs;
  std::vector<Vec2> vertices;              ///< grid coordinates, see trimmed_chart.h
  std::vector<std::vector<double>> stops;  ///< of each border: where arcs end, increasing
  /// Bound on how far pieces at common borders reach beyond the lines of their patch; model units.
  double beyond_lines = 0;
  /// Why there are no pieces: the borders cross or touch each other. Empty if all is well.
  std::string obstacle;
};

/// Covers the region on the left of the borders.
///
///   (1) the pieces lie on the surface, or within the tolerance of it where they are lowered, and
///       their parameters cover the region once
///   (2) each inner side belongs to two pieces whole, with the same vertices
///   (3) each arc is a side of one triangle, or the border of one cell
///
/// throws   InvalidInput if the surface is not well formed, a corner is not there, or degrees leave
///          no triangle within options.highest_degree
/// accuracy (1) as turning_form says, for borders that meet only at their corners; the error of
/// each
///          piece is a bound
///
/// Source: Vlachkova 2025, Theorem 3, for straight triangles; DeRose 1988 for curved ones; Farouki,
/// Han, Hass, Sederberg 2004 for trimmed surfaces as triangular patches.
TriangulatedRegion triangulated_region(const BezierSurface& surface, const TrimmedChart& chart,
                                       const RegionOptions& options = {});

/// The same with the matrices of other regions.
TriangulatedRegion triangulated_region(const BezierSurface& surface, const TrimmedChart& chart,
                                       const RegionOptions& options, TriangleLowering& lowering);

/// The surface over a piece: homogeneous; weights are 1, exactly, if neither surface nor arcs are
/// rational.
using RegionForm = std::variant<RationalBezierPatch, RationalBezierTriangle>;
RegionForm bezier_form(const BezierSurface& surface, const RegionPiece& piece);

}  // namespace blossom
