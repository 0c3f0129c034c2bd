// SPDX-License-Identifier: LGPL-2.1-or-later
// The common run of two faces' edges as a curve on both faces.

#pragma once

#include <TopoDS_Face.hxx>

#include "adapters/occt/faces/pairs/edge_contacts.h"
#include "core/results/result.h"

namespace blossom::occt {

/// The parameter of the second edge next to a point of the first one, within the run.
double parameter_beside(const OutlineRun& run, double t);

/// The first edge along the run, with its images on both faces: cubic pieces with its values and
/// first derivatives, as many as they need to be within a tenth of the tolerance, at most 1024. A
/// line or a circle is told as such. Faces touch along it; its deviations are those of samples.
IntersectionCurve run_curve(const OutlineRun& run, const TopoDS_Face& a, const TopoDS_Face& b,
                            double tolerance);

}  // namespace blossom::occt
