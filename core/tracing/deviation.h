// SPDX-License-Identifier: LGPL-2.1-or-later
// Proven bounds on the distances between a curve in space and its images on two surfaces.
//
// Each span is cut where a chart curve passes into another patch. On the pieces the distances are
// Bezier forms (`core/tracing/image_gap.h`); the form with the largest bound is halved until the
// bound is hardly more than a distance that occurs.

#pragma once

#include "core/forms/surface.h"
#include "core/results/result.h"

namespace blossom {

/// Bounds on the deviations over the whole curve. Rounding is included, that of the evaluation of
/// spline and surface by others is not. If the curve has a conic, that takes the place of the 3D
/// spline: on short pieces as its Hermite polynomial of degree 5, which leaves it by no more than
/// max |C^(6)| w^6 / 46080 over a width w.
///
/// curve     its three splines have degree 5 and the same knots; of other members only the conic is
///           read
/// a, b      surfaces in whose parameters the chart curves are
/// returns   model units. `proven` is false when a piece of the curve could not be bounded, because
///           a chart curve strays far from its surface; such pieces are then sampled
/// accuracy  at most 1.25 times the largest distance, plus 1e-10 and rounding
/// throws    InvalidInput if degrees or knots of the three splines differ, or the degree is not 5
///
/// Source: `core/tracing/README.md`, "The bound"; Davis 1963, theorem 3.5.1.
Deviation proven_deviation(const IntersectionCurve& curve, const BezierSurface& a,
                           const BezierSurface& b);

}  // namespace blossom
