// SPDX-License-Identifier: LGPL-2.1-or-later
// What is left of a closed surface beside faces on it.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

namespace blossom::occt {

/// The face on a closed surface (a sphere, a torus, one from pole to pole) that has the borders of
/// other faces for holes: all of the surface but them. It shares their edges, and has a copy of
/// their surface.
///
/// pieces    on one surface, apart from each other, without seams and poles
/// returns   forward; null if the surface is not closed, if a border goes round it, or if every
///           seam would touch one
TopoDS_Face rest_of_surface(const std::vector<TopoDS_Face>& pieces);

}  // namespace blossom::occt
