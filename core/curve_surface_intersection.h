// SPDX-License-Identifier: LGPL-2.1-or-later
// All common points of a curve and a surface, with a certificate.

#pragma once

#include "core/forms/curve_spans.h"
#include "core/forms/surface.h"
#include "core/results/curve_surface_result.h"
#include "core/results/options.h"

namespace blossom {

/// The intersection of a curve and a surface.
///
///   (1) a `complete` result holds every common point, each proven to be there
///   (2) contacts, where that is not proven, are listed with the interval of their gap: touches,
///       ends of the curve or borders of the surface within tolerance, runs in the surface
///
/// throws    InvalidInput if the curve or the surface is not well formed or the tolerance is not
///           positive
///
/// Source: `core/curves/README.md`, "A curve and a surface".
CurveSurfaceIntersection intersect(const CurveSpans& curve, const BezierSurface& surface,
                                   const IntersectionOptions& options = {});

}  // namespace blossom
