// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces proven to be valid without the slow part of BRepCheck.

#pragma once

#include <TopoDS_Face.hxx>

namespace blossom::occt {

/// Whether the wires of a face are proven not to meet themselves nor each other, and to have the
/// face within one of them and outside of all others: `nesting_of` (core/topology/simple_loops.h),
/// with a margin for what BRepCheck takes for one.
///
/// returns   false in doubt, as of faces with vertices and edges that are in no loop, and of what
///           is no geometry; throws nothing
bool loops_are_simple(const TopoDS_Face& face);

/// Whether a wire of a face is proven to be a hole that does not lie in the face: what a blend or a
/// cut leaves where there is no room for it. BRepCheck takes seconds to find that for long splines.
///
/// returns   false in doubt; throws nothing
bool has_hole_astray(const TopoDS_Face& face);

/// Whether a face is proven to have none of the faults that `BRepCheck_Analyzer` looks for. What
/// that says of vertices, edges (with their polygons on triangulations) and the order of wires is
/// asked of its own parts. Whether wires
/// meet is not: it samples both curves of each two edges, which takes most of its time. That is
/// left to `loops_are_simple`, for edges that are lines, conics and splines in the face's
/// parameters.
///
/// returns   false in doubt: that says nothing of the face; throws nothing
bool is_sound_face(const TopoDS_Face& face);

}  // namespace blossom::occt
