// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves that end in a contact of two other faces.

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/intersection.h"
#include "adapters/occt/splitting/edges/edge_splits.h"

namespace blossom::occt {

/// In which vertices of the borders of its two faces a cut ends.
struct CutEnds {
  std::array<std::size_t, 2> faces{};                    ///< of the first and the second solid
  std::array<std::vector<TopoDS_Vertex>, 2> vertices{};  ///< of each of them
};

/// Whether two faces touch in a point, or in what counts as one.
bool has_contact(const FaceIntersection& pair);

/// Where two faces F and G only touch, in what is within tolerance of both, a curve of F with a
/// neighbour of G may end on the edge that this shares with G, and one of a neighbour of F with G
/// on an edge of F, or two of one neighbour on one edge: they would go on in a curve of F and G
/// that is too short, or too near an edge, to be one. Then the contact is a point in which they all
/// end: such vertices, in which no curve of F and G itself ends, become one, and so do vertices of
/// F and G between them.
///
/// found       the contacts of all pairs of faces
/// faces       of both solids
/// tolerance   of points; model units
void unite_in_contacts(const ShapeIntersection& found,
                       const std::array<const std::vector<TopoDS_Face>*, 2>& faces,
                       const std::vector<CutEnds>& ends, double tolerance, EdgeSplits& splits);

}  // namespace blossom::occt
