// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of planes between straight edges, proven to be valid without BRepCheck.

#pragma once

#include <TopoDS_Face.hxx>

namespace blossom::occt {

/// Whether a face is a plane without scale between edges that are lines, and these, their vertices,
/// the plane and stored curves in its parameters hold each other within their tolerances: what is
/// straight is farthest off at its ends. That says nothing of loops.
bool is_held_polygon(const TopoDS_Face& face);

/// Whether a face is proven to have none of the faults that `BRepCheck_Analyzer` looks for: by
/// `is_held_polygon`, and `loops_are_simple` (sound_faces.h).
///
/// returns   false of everything else and in doubt: that says nothing of the face
bool is_sound_polygon(const TopoDS_Face& face);

}  // namespace blossom::occt
