// SPDX-License-Identifier: LGPL-2.1-or-later
// An edge of a face as a border that strips start from.

#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/blending/border_rows.h"

namespace blossom::occt {

struct StripBorder {
  Border rows;
  bool exact = false;
  double error = 0;  ///< how far fitted rows are from the edge, model units; sampled, 0 if exact
};

/// The face beside an edge, with three derivatives across it: from the control points where the
/// edge is an iso-parameter line, or the face a plane and the edge a line, conic or spline; else by
/// polynomials in pieces, within kFitPoint and kFitSlope.
///
/// edge     as the face has it
/// throws   BadModel if the edge has no curve in the face, has a corner, or is not followed
///          by kMaxFitSpans polynomials
StripBorder strip_border(const TopoDS_Edge& edge, const TopoDS_Face& face);

/// How near fits come, as parts of half the edge's chord: points, so that second derivatives along
/// the edge are off by about 1e-6 of its curvature; and derivatives across, of that length. Points
/// never come nearer than roundings, 64 units in the last place of a coordinate.
inline constexpr double kFitPoint = 1e-11;
inline constexpr double kFitSlope = 1e-8;

/// Most pieces of a fit.
inline constexpr int kMaxFitSpans = 128;

}  // namespace blossom::occt
