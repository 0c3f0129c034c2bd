// SPDX-License-Identifier: LGPL-2.1-or-later
// An intersection seen from the other surface.
//
// The search is not the same for both orders: it is cells of a that are looked at over charts of b,
// and at a border of b's patches branches are cut. What one order leaves open the other one may
// settle, with a proof as good.

#pragma once

#include "core/forms/surface.h"
#include "core/results/result.h"

namespace blossom {

/// The intersection of a and b, made from that of b and a.
///
/// found     that of b and a
SurfaceIntersection exchanged(SurfaceIntersection found, const BezierSurface& a,
                              const BezierSurface& b);

/// True if the answer is open for other reasons than a limit, so that the other order may do
/// better; or if all it leaves undecided are touches in which the surfaces are apart: those may be
/// loops less deep than the tolerance, or nothing; or if there are a closed branch and a cusp,
/// which may be a turn of it too narrow for one order.
///
/// tolerance   model units
bool should_retry_swapped(const SurfaceIntersection& found, const BezierSurface& a,
                          const BezierSurface& b, double tolerance);

/// True if the second answer, of the exchanged surfaces, is better.
bool is_gain(const SurfaceIntersection& found, const SurfaceIntersection& other);

}  // namespace blossom
