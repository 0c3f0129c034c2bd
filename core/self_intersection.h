// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a surface meets itself, with a certificate.

#pragma once

#include "core/forms/surface.h"
#include "core/results/options.h"
#include "core/results/result.h"

namespace blossom {

/// The intersection of a surface with itself: all p != q with S(p) = S(q).
///
/// Every curve and point is there once, not mirrored; `a` and `b` in the result are two places of
/// the same surface. Borders glued together are one: those that the surface says are closed, those
/// whose nets agree within 1e-12 of its size, and borders that are one point (poles).
///
/// An empty result with Status::Complete is a proof that the surface does not meet itself: each
/// cell of it, and each two cells that touch, by the directions of their derivatives
/// (`core/cells/direction_cones.h`), all others by a separating box or plane.
///
/// surface   model units
/// returns   as `intersect`. A loop along which the two sides change places is cut where they do:
///           it is not `closed`, but both its ends are CurveEnd::Closed. Singular points (pinch
///           points, cusps) are places of kind Cusp where the proof fails only for cells as small
///           as the tolerance, else Open with Status::Stopped
/// throws    InvalidInput if the surface is not well formed
///
/// Source: `core/surfaces/README.md`, "A surface with itself".
SurfaceIntersection self_intersect(const BezierSurface& surface,
                                   const IntersectionOptions& options = {});

}  // namespace blossom
