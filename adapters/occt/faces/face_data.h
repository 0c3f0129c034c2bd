// SPDX-License-Identifier: LGPL-2.1-or-later
// A face of Open CASCADE made ready to be intersected, and edges of what is found.

#pragma once

#include <TopoDS_Face.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/intersection.h"
#include "core/results/result.h"
#include "core/topology/clipping/clipped_result.h"
#include "core/topology/face_data.h"

namespace blossom::occt {

/// throws   BadModel if the face cannot be converted
FaceData face_data(const TopoDS_Face& face, double tolerance, Extent extent = Extent::Trims,
                   ArcCuts cuts = ArcCuts::Even);

/// A found curve as edges have it: in space, in the parameters of both faces, and with a tolerance.
EdgeCurves edge_curves(const IntersectionCurve& curve);

}  // namespace blossom::occt
