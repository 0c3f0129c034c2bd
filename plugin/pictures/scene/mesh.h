// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces as triangles for pictures, with the surfaces' own normals.

#pragma once

#include <array>
#include <string>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::pictures {

struct PictureMesh {
  std::vector<Vec3> points;   ///< model units
  std::vector<Vec3> normals;  ///< one per point, unit, outwards; zero where the surface has none
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise as seen from outside
  /// Short lines along the face's edges, from point to point; seams are no border to the eye.
  std::vector<std::array<int, 2>> border;
  std::string obstacle = {};  ///< why there are no triangles; empty if all is well
};

/// A mesh for each face; faces that share an edge share its points. A face that cannot be meshed
/// has a border and no triangles.
///
/// deviation   distance of triangles and faces, model units, > 0
/// angle       largest turn of the normal along one side of a triangle, about; radians
std::vector<PictureMesh> picture_meshes(const std::vector<TopoDS_Face>& faces, double deviation,
                                        double angle);

/// Points of an edge, two if it is straight; none if it has no curve in space.
std::vector<Vec3> edge_points(const TopoDS_Edge& edge);

/// Likewise of a part of one that has such a curve.
std::vector<Vec3> edge_points(const TopoDS_Edge& edge, const Interval& part);

/// Diagonal of the box of the faces, model units.
double size_of(const std::vector<TopoDS_Face>& faces);

}  // namespace blossom::pictures
