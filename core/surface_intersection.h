// SPDX-License-Identifier: LGPL-2.1-or-later
// All intersections of two surfaces, with a certificate.

#pragma once

#include "core/forms/surface.h"
#include "core/results/options.h"
#include "core/results/result.h"

namespace blossom {

/// The intersection of two surfaces.
///
/// An empty result with Status::Complete is a proof of emptiness: every pair of cells was
/// excluded by a separating box or plane, rounding included.
///
/// a, b      surfaces, model units
/// returns   curves from border to border or closed, isolated contacts, and places that
///           stayed undecided; nothing is dropped silently
/// throws    InvalidInput if a surface is not well formed
///
/// Source: `core/surfaces/README.md`.
SurfaceIntersection intersect(const BezierSurface& a, const BezierSurface& b,
                              const IntersectionOptions& options = {});

}  // namespace blossom
