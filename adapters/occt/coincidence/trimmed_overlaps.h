// SPDX-License-Identifier: LGPL-2.1-or-later
// What the trims of two faces leave of the regions that their surfaces have in common.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/faces/face_trims.h"
#include "core/base/work_limit.h"
#include "core/forms/surface_match.h"
#include "core/results/result.h"

namespace blossom::occt {

struct TrimmedOverlaps {
  std::vector<Overlap> regions;
  bool complete = true;  ///< false: the trims could not be laid over each other
  const char* stopped =
      nullptr;  ///< why nothing was clipped: the limit; null if it was not reached
};

/// The common regions of two faces.
///
/// The first face is split along the edges of the second one, and along the border of what the
/// surfaces have in common where it runs inside of both faces; the pieces inside of the second face
/// are the regions. Pieces that a seam separates stay apart.
///
/// whole       common regions of the surfaces, as `blossom::intersect` finds them
/// tolerance   model units; what is ten times as near to the other surface lies on it
/// limit       asked while the trims are followed over the other face
/// returns     boundaries with 128 samples an edge, 4 on straight ones
TrimmedOverlaps trimmed_overlaps(const TopoDS_Face& a, const TopoDS_Face& b,
                                 const std::vector<Overlap>& whole, double tolerance,
                                 const WorkLimit& limit);

/// The common region of a face and one that is equal to it: the whole face.
///
/// to_b      from the parameters of the face to those of the other one
/// gap       bound on the distance of the two, model units
/// returns   a boundary with seams, if there are some; none if it has seams and poles only
Overlap whole_overlap(const TopoDS_Face& face, const FaceTrims& trims, const ChartMap& to_b,
                      double gap);

}  // namespace blossom::occt
