// SPDX-License-Identifier: LGPL-2.1-or-later
// Points in which the outlines of two faces meet.
//
// Where the surfaces of two faces coincide, no curve of theirs leads to a point that the faces
// alone have in common, as the corners of two squares in one plane.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "core/intersection/result.h"

namespace blossom::occt {

/// The isolated points within tolerance of an edge of either face, each once.
///
/// tolerance   model units
/// throws      BadModel if an edge has no curve in space or on its face
std::vector<SurfacePoint> edge_contacts(const TopoDS_Face& a, const TopoDS_Face& b,
                                        double tolerance);

}  // namespace blossom::occt
