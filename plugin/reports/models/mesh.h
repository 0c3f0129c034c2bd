// SPDX-License-Identifier: LGPL-2.1-or-later
// A shape that was turned into triangles, in words and as JSON (schema blossom.mesh/1).

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "adapters/occt/tessellation.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// Edges, by number, that keep a mesh from being closed.
struct BorderEdges {
  std::vector<int> open;     ///< of one face
  std::vector<int> crowded;  ///< of more than two
};

BorderEdges border_edges(const TopoDS_Shape& shape);

struct MeshAnswer {
  FacetOptions options;
  std::size_t points = 0, triangles = 0;
  double distance = 0;  ///< proven, rounding to single precision included
  double rounding = 0;
  std::vector<std::string> lost;  ///< what the file has no place for
  double moved = 0;               ///< how far edges are off their faces, at most
  int folded = 0;
  std::vector<int> finer{};  ///< faces that keep less than the deviation
  BorderEdges edges;
  std::vector<std::pair<int, std::string>> refused;  ///< faces and why
  std::optional<std::size_t> crossings;              ///< pairs of triangles; none: not looked for
  std::vector<std::array<int, 2>> crossing_faces;    ///< pairs, each once
  std::size_t between_parts = 0;                     ///< of `crossings`, those of two parts
  std::vector<std::array<int, 2>> faces_of_one{};    ///< of `crossing_faces`, those of one part
  double seconds = 0;
};

/// What is said of facets; points, triangles and what the file does to them are left open.
MeshAnswer answer_of(const occt::ShapeTessellation& made, const TopoDS_Shape& shape,
                     const std::vector<int>& faces, const FacetOptions& options);

Json mesh_report(const std::string& file, const std::string& output, const MeshAnswer& answer);

/// Lines on what is not as it should be; none if all is well.
std::string mesh_notes(const MeshAnswer& answer);

}  // namespace blossom::reports
