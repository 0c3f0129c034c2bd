// SPDX-License-Identifier: LGPL-2.1-or-later
// Which section curves bound what a plane and a solid have in common. For the plane section only.

#pragma once

#include <vector>

#include "adapters/occt/faces/face_list.h"
#include "adapters/occt/plane_section.h"

namespace blossom::occt {

/// Fills `bounding` of the curves. What plane and solid have in common includes faces in the plane,
/// so that beside an edge in the plane a side belongs to it if a face in the plane lies there, or
/// the solid's inside. The edge bounds if one side does. A curve inside a face along which the face
/// is tangent to the plane and stays on one side bounds nothing. Each is decided at the middle of
/// the curve, by its faces' positions a thousandth of its length beside it. Edges of one
/// face bound.
///
/// near      for each face, whether it may have a point in the plane
/// in_plane  likewise, whether it lies in it as a whole
void find_bounding_curves(const FaceList& faces, const std::vector<char>& near,
                          const std::vector<char>& in_plane, const Vec3& normal,
                          PlaneSection& section);

}  // namespace blossom::occt
