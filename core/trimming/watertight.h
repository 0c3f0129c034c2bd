// SPDX-License-Identifier: LGPL-2.1-or-later
// Trimmed faces that meet along edges as patches and triangles that meet without gaps.
//
// Along an edge two trimmed surfaces agree only within a tolerance. Here each piece of an edge
// becomes one polynomial Bezier curve, and the triangles on both sides get its control points, bit
// for bit, in the place of their own. So the surfaces leave their place a little, by no more than
// the largest way of a control point, and only in the triangles at edges; all else stays on the
// surfaces.

#pragma once

#include <array>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "core/forms/curve.h"
#include "core/forms/patch.h"
#include "core/forms/surface.h"
#include "core/forms/triangle.h"
#include "core/trimming/trimmed_chart.h"

namespace blossom {

/// An edge as all faces that have it for a border see it.
struct CommonEdge {
  std::function<Vec3(double)> point;  ///< in space, at a parameter; not called if it is a point
  Interval domain;
  int from = 0;  ///< vertices at the ends of the domain
  int to = 0;
  bool is_point = false;  ///< as at the pole of a sphere
  /// About how far the surfaces are from it. Triangles much narrower than that would fold over when
  /// they are moved, so arcs of its borders need be no nearer to the trims. Model units.
  double apart = 0;
};

/// How the parameters of a border go with those of its edge. Both functions grow or both fall, they
/// undo each other but for rounding, and take ends of domains to ends.
struct BorderParameters {
  std::function<double(double)> to_edge;  ///< from the border's; empty: they are the same
  std::function<double(double)> from_edge;
};

struct CommonFace {
  BezierSurface surface;
  TrimmedChart chart;
  std::vector<int> edges;                         ///< of each border
  std::vector<BorderParameters> parameters = {};  ///< of each border, or none: all are their edges'
};

struct CommonModel {
  std::vector<Vec3> vertices;
  std::vector<CommonEdge> edges;
  std::vector<CommonFace> faces;
};

struct WatertightOptions {
  /// How far triangles may leave their surfaces, where edges and surfaces allow it; model units.
  double tolerance = 1e-6;
  int highest_degree = kMaxDegree;  ///< of triangles
  /// Asked before each face whether to go on; may throw instead. None: it goes on to its end.
  std::function<bool()> ask = {};
};

/// A side of pieces: of two where nothing is free.
struct WatertightSide {
  /// Of the model; -1 inside of a face. Beyond the model's are poles beside which borders meet, of
  /// which no edge is one (pole_ends.h).
  int edge = -1;
  int from = 0;  ///< vertices
  int to = 0;
  BezierCurve curve;  ///< from `from` to `to`; no points if the side is a point
};

struct WatertightPiece {
  int face = 0;
  std::variant<BezierPatch, BezierTriangle> form;
  /// A patch: at (0, 0), (1, 0), (1, 1), (0, 1); a triangle: a, b, c.
  std::vector<int> vertices;
  std::vector<int> sides;   ///< side k begins at vertex k; walked to vertex k + 1
  std::vector<bool> along;  ///< whether side k's curve runs that way, too
  double moved = 0;  ///< bound on the distance to the surface at equal parameters, model units
};

struct WatertightPieces {
  std::vector<Vec3> vertices;  ///< the model's first
  std::vector<WatertightSide> sides;
  std::vector<WatertightPiece> pieces;  ///< of the same orientation as their surfaces
  /// The largest of all `moved`, and of the errors of the surfaces as polynomials: a bound on how
  /// far the pieces lie from the given surfaces. Model units.
  double deviation = 0;
  /// Numbers of triangles that are not proven to fold over nowhere, increasing: narrow ones that
  /// the sides' moves reach across. Folds narrower than a thousandth of the tolerance do not count.
  std::vector<int> turned;
  std::string obstacle;  ///< why there are no pieces; empty if all is well
  /// Where `ask` ended the work: the faces whose pieces were not made then, or not yet divided as
  /// those of their neighbours are.
  std::vector<int> open;
};

/// The faces as pieces with common sides.
///
///   (1) along an edge the control points of the pieces' sides are those of the side, elevated to
///   one
///       degree and equal bit for bit
///   (2) inside of a face sides of equal degree are equal bit for bit, others to rounding
///   (3) no side ends in the middle of another
///   (4) triangles fold over nowhere but in those of `turned`: where the move of a side reaches
///       across a triangle, that moves with it, and so do its sides inside of the face
///
/// Rational surfaces become polynomial first, within a tenth of the tolerance
/// (polynomial_surface.h).
///
/// throws    InvalidInput if a number in the model names nothing, or as triangulated_region
/// Source: Farouki, Han, Hass, Sederberg 2004, but with curved triangles: perturbing their sides
/// stays within the error of the edge.
WatertightPieces watertight_pieces(const CommonModel& model, const WatertightOptions& options = {});

}  // namespace blossom
