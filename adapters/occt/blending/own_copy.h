// SPDX-License-Identifier: LGPL-2.1-or-later
// A shape's vertices, edges and faces once more, on the same curves and surfaces.

#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// Whose tolerances and curves in faces may be changed without changing the shape's. Subshapes keep
/// their order, so their numbers, orientations and locations; meshes are left out.
TopoDS_Shape own_copy(const TopoDS_Shape& shape);

/// Puts planes, which go on past their borders, in the place of splines that are flat: lofts and
/// walls with draft are made of them. The edges of a copy keep their curves on the splines.
void flatten(const TopoDS_Shape& copy);

/// Gives a face of such a copy the surface of the face that it is a copy of.
void unflatten(const TopoDS_Face& copy, const TopoDS_Face& of);

}  // namespace blossom::occt
