// SPDX-License-Identifier: LGPL-2.1-or-later
// A model of trimmed faces with common edges, and the patches and triangles that are made of it.

#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "core/forms/curve.h"
#include "core/forms/patch.h"
#include "core/forms/surface.h"
#include "core/forms/triangle.h"
#include "core/regions/trimmed_chart.h"

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

}  // namespace blossom
