// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces that hang together over the edges they share.

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// Places of faces, increasing.
using FaceGroup = std::vector<std::size_t>;

/// Groups of faces, of which those with a common edge are in one group unless the edge divides
/// them; in the order of their first faces.
///
/// divides   is given the edges as they are oriented in their faces
std::vector<FaceGroup> groups_over_edges(
    const std::vector<TopoDS_Shape>& faces,
    const std::function<bool(const TopoDS_Shape& edge)>& divides);

}  // namespace blossom::occt
