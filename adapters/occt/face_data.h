// SPDX-License-Identifier: LGPL-2.1-or-later
// A face made ready to be intersected, and what its trims leave of an answer.

#pragma once

#include <TopoDS_Face.hxx>

#include "adapters/occt/face_trims.h"
#include "adapters/occt/intersection.h"
#include "core/bounds/box_tree.h"
#include "core/forms/surface.h"
#include "core/intersection/options.h"
#include "core/intersection/result.h"

namespace blossom::occt {

struct FaceData {
  BezierSurface surface;
  FaceTrims trims;
  Box box;  ///< of the surface, its error and the tolerance included
};

/// throws   BadModel if the face cannot be converted
FaceData face_data(const TopoDS_Face& face, double tolerance);

/// Which part of the face's surface counts; empty for a naturally bounded one. Keeps a reference.
PartTest part_test(const FaceTrims& trims);

/// Leaves of an intersection what lies inside the trims of both. What they leave of a common region
/// is not known: it stays among the places only.
/// b   null if everything of the second surface counts
void clip(SurfaceIntersection& found, const FaceTrims& a, const FaceTrims* b);

EdgeCurves edge_curves(const IntersectionCurve& curve);

/// Sums of counts, the least of angles, all reasons.
void add(Certificate& sum, const Certificate& one);

}  // namespace blossom::occt
