// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces without trims: their regions as Bezier patches and triangles.

#pragma once

#include <TopoDS_Face.hxx>

#include "core/regions/triangulated_region.h"
#include "core/topology/trimmed_chart.h"

namespace blossom::occt {

struct UntrimmedFace {
  BezierSurface surface;  ///< of the face, in model space, over the box of its trims
  TriangulatedRegion region;
};

/// The pieces of a face; their parameters turn as those of its surface do, so they are to be
/// reversed where the face is.
///
/// lowering   keeps its matrices for the next face
/// throws     BadModel if the face cannot be converted; InvalidInput as triangulated_region
UntrimmedFace untrimmed(const TopoDS_Face& face, const RegionOptions& options,
                        TriangleLowering& lowering);
UntrimmedFace untrimmed(const TopoDS_Face& face, const RegionOptions& options = {});

}  // namespace blossom::occt
