// SPDX-License-Identifier: LGPL-2.1-or-later
// Lines between the spans into which arcs of a surface are cut for the search: they are our own
// choice, and what looks special along them need not be.

#pragma once

#include "core/forms/surface.h"
#include "core/results/result.h"

namespace blossom::occt {

/// Whether what is not proven of a result may come from where arcs of the surfaces are cut: a place
/// whose parameters are not known may. The seam of a whole turn is no such line: it stays where it
/// is, however the arcs are cut.
bool may_be_of_arc_lines(const SurfaceIntersection& found, const BezierSurface& a,
                         const BezierSurface& b, double tolerance);

}  // namespace blossom::occt
