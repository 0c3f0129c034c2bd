// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces without trims: their regions as Bezier patches and triangles.

#pragma once

#include <TopoDS_Face.hxx>

#include "adapters/occt/faces/face_trims.h"
#include "core/regions/triangulated_region.h"

namespace blossom::occt {

/// The wires of a face as the core takes them, in the surface's own parameters. The borders are the
/// coedges, loop by loop.
TrimmedChart trimmed_chart(const FaceTrims& trims);

struct UntrimmedFace {
  BezierSurface surface;  ///< of the face, in model space, over the box of its trims
  TriangulatedRegion region;
};

/// The pieces of a face; their parameters turn as those of its surface do, so they are to be
/// reversed where the face is. throws   BadModel if the face cannot be converted; InvalidInput as
/// triangulated_region
///
/// lowering   keeps its matrices for the next face
UntrimmedFace untrimmed(const TopoDS_Face& face, const RegionOptions& options,
                        TriangleLowering& lowering);
UntrimmedFace untrimmed(const TopoDS_Face& face, const RegionOptions& options = {});

}  // namespace blossom::occt
