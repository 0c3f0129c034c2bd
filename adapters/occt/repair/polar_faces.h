// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces from pole to pole with something cut out, for files whose readers take what was cut out.

#pragma once

#include <map>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// The two halves of a face that goes round a closed surface from pole to pole, and has other edges
/// beside its seam and its poles: cut along a meridian that none of these touch, and along the
/// seam. All edges but the seam's poles stay those of the face.
///
/// STEP has neither poles nor seams of whole surfaces, so there such a face has no border but that
/// of the hole, and Open CASCADE, FreeCAD with it, reads it as the piece that is missing.
///
/// returns   nothing for any other face, or if there is no free meridian
std::vector<TopoDS_Face> polar_halves(const TopoDS_Face& face);

/// The halves of all such faces of a shape, by the number of the face.
std::map<int, std::vector<TopoDS_Face>> polar_faces(const TopoDS_Shape& shape);

}  // namespace blossom::occt
