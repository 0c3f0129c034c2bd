// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of faces and edges as one B-spline each, instead of their Bezier pieces.

#pragma once

#include <array>
#include <optional>

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/interval.h"
#include "plugin/nets/net.h"
#include "plugin/reports/text/json.h"

namespace blossom::nets {

/// The surface of a face over a rectangle of its parameters as one B-spline surface, trims left
/// out. Pole i of a direction of degree p is the blossom of a span at the knots i + 1 to i + p,
/// whichever span between the knots i and i + p + 1 is taken.
///
/// A B-spline surface keeps its knots within the rectangle with their multiplicities; where a
/// surface is no B-spline, spans meet in knots of full multiplicity, and parameters that are angles
/// run as the rational form has them between knots.
///
/// rectangle   in u and v, from larger to smaller numbers reverses; none: the box of the trims
/// throws      occt::BadModel, naming the source, if it leaves the box of the trims, is empty, or
///             the face cannot be converted
///
/// Source: Ramshaw 1989, the blossoms of B-splines.
Handle(Geom_BSplineSurface) whole_surface(const TopoDS_Face& face, const NetSource& source,
                                          const std::optional<std::array<Interval, 2>>& rectangle);

/// Likewise the curve of an edge over an interval; null if it has no curve in space.
Handle(Geom_BSplineCurve) whole_curve(const TopoDS_Edge& edge, const NetSource& source,
                                      const std::optional<Interval>& interval);

/// Degrees, knots with multiplicities, poles and weights, for reports.
reports::Json spline_json(const Geom_BSplineSurface& surface);
reports::Json spline_json(const Geom_BSplineCurve& curve);

}  // namespace blossom::nets
