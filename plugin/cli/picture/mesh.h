// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles of faces for pictures, with the surface's own normals.

#pragma once

#include <array>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/vec.h"

namespace blossom::cli {

struct PictureMesh {
  std::vector<Vec3> points;   ///< model units
  std::vector<Vec3> normals;  ///< one per point, unit; zero where the surface has none
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::vector<Vec3>> outlines;  ///< a polyline for each edge of the face
};

/// Triangulates a copy of the face; the face itself keeps what triangles it had.
/// deflection   distance of the triangles to the surface, model units, > 0
/// coarseness   of the angle between neighbouring triangles; 1 looks smooth
/// throws       occt::Failure if the face cannot be triangulated
PictureMesh picture_mesh(const TopoDS_Face& face, double deflection, double coarseness = 1);

/// Points of an edge, two if it is straight; none if it has no curve in space.
std::vector<Vec3> edge_points(const TopoDS_Edge& edge);

/// Diagonal of the box of the faces, model units.
double size_of(const std::vector<TopoDS_Face>& faces);

}  // namespace blossom::cli
