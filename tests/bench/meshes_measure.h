// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of models, ours and Open CASCADE's, measured by samples.

#pragma once

#include <array>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "adapters/cgal/gpl/mesh_check.h"
#include "core/math/vec.h"
#include "core/tessellation/facet_options.h"

namespace blossom::bench {

struct FacetMesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;  ///< turned as the shape's faces
  std::vector<int> face;                      ///< of each triangle, from 0 on
  std::vector<std::array<Vec2, 3>> uv;        ///< of its corners
  double proven = 0;                          ///< 0 if nothing is
  double seconds = 0;                         ///< of processor time
  int folded = 0, refused = 0;                ///< facets; faces
  std::vector<double> of_face;                ///< proven, of each face; empty if nothing is
};

FacetMesh our_mesh(const TopoDS_Shape& shape, const FacetOptions& options);

/// By BRepMesh_IncrementalMesh; the shape's own triangles are taken away before and after.
FacetMesh occt_mesh(const TopoDS_Shape& shape, double deflection, double angle);

/// The largest distance of samples, of the facets from their faces and of faces from their facets;
/// about so many of either. Of the faces these are the corners of a finer mesh: places of the
/// surface over a facet's parameters may be beyond a border.
double measured_distance(const TopoDS_Shape& shape, const FacetMesh& mesh, int samples);

}  // namespace blossom::bench
