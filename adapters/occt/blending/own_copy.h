// SPDX-License-Identifier: LGPL-2.1-or-later
// A shape's vertices, edges and faces once more, on the same curves and surfaces.

#pragma once

#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// Whose tolerances and curves in faces may be changed without changing the shape's. Subshapes keep
/// their order, so their numbers, orientations and locations; meshes are left out.
TopoDS_Shape own_copy(const TopoDS_Shape& shape);

}  // namespace blossom::occt
