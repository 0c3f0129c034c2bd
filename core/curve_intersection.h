// SPDX-License-Identifier: LGPL-2.1-or-later
// All common points of two curves, with a certificate.

#pragma once

#include "core/forms/curve_spans.h"
#include "core/results/curve_result.h"
#include "core/results/options.h"

namespace blossom {

/// The intersection of two curves. Curves in the plane have z = 0 in all control points.
///
///   (1) in the plane: a `complete` result holds every common point, each proven to be there
///   (2) in space: a `complete` result holds every place in which the curves are within tolerance
///       of each other; there they are within rounding
///   (3) contacts, where that is not proven, are listed with the interval of their gap
///
/// An end of one curve that lies within tolerance of the other is a point. A budget counts pairs
/// of pieces.
///
/// a, b      curves, model units
/// throws    InvalidInput if a curve is not well formed or the tolerance is not positive
///
/// Source: `core/curves/README.md`, "Two curves".
CurveIntersection intersect(const CurveSpans& a, const CurveSpans& b,
                            const IntersectionOptions& options = {});

/// The points in which a curve meets itself, a < b in each. The common point of ends of a closed
/// curve is none. Cusps are listed as places: there a curve turns back within tolerance.
///
/// throws    as above
CurveIntersection self_intersections(const CurveSpans& curve,
                                     const IntersectionOptions& options = {});

}  // namespace blossom
