// SPDX-License-Identifier: LGPL-2.1-or-later
// Common points of two faces, found without anything of Blossom: boxes round a fine grid of points
// of each surface, and Newton's method where they meet. Open CASCADE evaluates and classifies.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

namespace blossom::bench {

struct OraclePoint {
  gp_Pnt point;
  double sine = 0;  ///< of the angle between the surfaces
};

/// Points strictly inside both faces at which the surfaces agree within 1e-9 of `size`. It finds
/// most pieces of an intersection that are longer than a cell of a 64 x 64 grid, and proves
/// nothing. size   of the smaller surface, model units
std::vector<OraclePoint> common_points(const TopoDS_Face& a, const TopoDS_Face& b, double size);

/// Diagonal of the box of a grid of points of the surface over the face's parameters.
double size_of(const TopoDS_Face& face);

}  // namespace blossom::bench
