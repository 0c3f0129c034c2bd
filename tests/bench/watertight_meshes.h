// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of watertight shapes as CGAL sees them: of samples, refined where facets cross, and of
// Open CASCADE's mesher.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/cgal/gpl/mesh_check.h"
#include "adapters/occt/watertight.h"

namespace blossom::bench {

struct OcctMesh {
  bool meshed = false;    ///< each face has got triangles
  double deflection = 0;  ///< of the diagonal
  cgal::MeshCheck check;
};

/// Plain values, so that they can be passed between processes.
struct WatertightMeshes {
  cgal::MeshCheck even;     ///< as many samples along each side
  cgal::MeshCheck refined;  ///< twice as many round crossings, again and again
  int finest = 0;           ///< parts of a side
  /// Of the crossings that stay: between faces that share no vertex and meet at that very place, by
  /// `intersect`; between faces with a common edge or vertex, or of a face with itself; others.
  int of_model = 0, at_edges = 0, others = 0;
  /// By BRepMesh_IncrementalMesh, at a deflection of 1e-3 of the diagonal, and at the finest that
  /// was tried as long as the mesh was no manifold or facets crossed.
  OcctMesh first, last;
  OcctMesh given;  ///< of the faces that the shape was made of, at the first deflection
};

/// given   the faces that the shape was made of, in their order
/// parts   of a side at first
WatertightMeshes watertight_meshes(const occt::WatertightShape& made,
                                   const std::vector<TopoDS_Face>& given, int parts);

}  // namespace blossom::bench
