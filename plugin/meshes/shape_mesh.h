// SPDX-License-Identifier: LGPL-2.1-or-later
// Models as triangles, with what is said of them.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "adapters/occt/tessellation.h"
#include "core/tessellation/facet_options.h"
#include "plugin/meshes/mesh_files.h"
#include "plugin/meshes/part_crossings.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/models/mesh.h"

namespace blossom::meshes {

struct ShapeMesh {
  occt::ShapeTessellation made;
  FileMesh mesh;                 ///< a group for each face that has triangles
  std::vector<int> face_of{};    ///< of each triangle: its face's place in the shape, from 0
  reports::MeshAnswer answer{};  ///< what writing does to it is left open
};

/// What the chosen faces of an input are called in groups: "Face3", or with the part's instance as
/// inputs of the command line have it, "machine:1/Shaft/Face3": its third face.
/// With its colour, where the model has one.
std::vector<MeshGroup> face_groups(const reports::Input& input);

/// The faces that are meshed, and how.
struct MeshedFaces {
  const std::vector<int>& numbers;       ///< in the model, for the report
  const std::vector<MeshGroup>& groups;  ///< one for each
  const std::vector<int>& parts;         ///< of all faces of the model, see parts_of_faces
  const FacetOptions& options;           ///< a deviation of 0 is a thousandth of the size
};

/// Where triangles of a part cross, or are folded, the faces are meshed finer, see mended_facets;
/// not beyond two million triangles, and without CGAL not at all.
///
/// ask       see shape_facets; when it ends the work, `made.facets.stopped` is all that is said
/// stop      asked now and then; may throw to end the work
/// throws    BadModel, with the name, if no face can be meshed
ShapeMesh mesh_of(const std::string& name, const TopoDS_Shape& shape, const MeshedFaces& faces,
                  const std::function<bool()>& ask, const std::function<void()>& stop);

}  // namespace blossom::meshes
