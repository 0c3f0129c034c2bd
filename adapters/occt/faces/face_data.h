// SPDX-License-Identifier: LGPL-2.1-or-later
// A face made ready to be intersected, and what its trims leave of an answer.

#pragma once

#include <optional>
#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/intersection.h"
#include "core/bounds/box_tree.h"
#include "core/forms/elementary.h"
#include "core/forms/surface.h"
#include "core/results/options.h"
#include "core/results/result.h"

namespace blossom::occt {

struct FaceData {
  BezierSurface surface;
  FaceTrims trims;
  Box box;                                 ///< of the surface, its error and the tolerance included
  std::optional<Elementary> elementary{};  ///< what the surface is part of, if it is that
};

/// Holds all of a surface; `margin` wider on every side.
Box box_of(const BezierSurface& surface, double margin);

/// throws   BadModel if the face cannot be converted
FaceData face_data(const TopoDS_Face& face, double tolerance, Extent extent = Extent::Trims,
                   ArcCuts cuts = ArcCuts::Even);

/// Which part of the face's surface counts; empty for a naturally bounded one. Keeps a reference.
PartTest part_test(const FaceTrims& trims);

/// A contact of the trims, and how far what meets in it is apart there, model units.
struct Touch {
  SurfacePoint at;
  double gap = 0;
};

/// Leaves of an intersection what lies inside the trims of both. Common regions of the surfaces
/// stay among the places only, unless both faces are naturally bounded; see `trimmed_overlaps.h`.
/// b         null if everything of the second surface counts
/// returns   where curves only touch the trims, or have parts too short for an edge in them; but
///           for ends of curves and contacts of the result
std::vector<Touch> clip(SurfaceIntersection& found, const FaceTrims& a, const FaceTrims* b,
                        double tolerance = 0);

/// Adds touches to the contacts of a result. Those within `within` are identified; what is farther
/// apart is known within tolerance only, and so is the result.
void add_touches(const std::vector<Touch>& touches, double tolerance, double within,
                 SurfaceIntersection& found);

/// Whether what runs along trims lies inside of them is known within tolerance only, and so is the
/// result, unless it keeps within `within` of them, by samples: then it is identified with them.
void weaken_along_trims(const FaceTrims& a, const FaceTrims& b, double within,
                        SurfaceIntersection& found);

EdgeCurves edge_curves(const IntersectionCurve& curve);

/// Sums of counts, the least of angles, all reasons.
void add(Certificate& sum, const Certificate& one);

}  // namespace blossom::occt
