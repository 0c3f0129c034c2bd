// SPDX-License-Identifier: LGPL-2.1-or-later
// A model of trimmed faces as triangles within a proven distance.
//
// Along an edge all faces have the corners of the edge's one polyline, so facets meet without gaps
// wherever faces share edges, whatever the distance of edges and surfaces.

#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "core/math/vec.h"
#include "core/tessellation/face_facets.h"
#include "core/tessellation/facet_options.h"
#include "core/tessellation/shape_model.h"

namespace blossom {

/// The facets of a face, in numbers of the whole mesh.
struct MeshedFace {
  std::vector<int> vertices;  ///< of each corner
  std::vector<Vec2> uv;       ///< of each corner, the surface's own parameters
  std::vector<Vec3> normals;  ///< of each corner, unit, along S_u x S_v; zero where that vanishes
  /// Numbers of corners, counter-clockwise round S_u x S_v.
  std::vector<std::array<int, 3>> triangles;
  double distance = 0;  ///< proven between facets and face, both ways; model units
  double moved = 0;     ///< how far edges are off the face where corners are on them, at most
  int folded = 0;       ///< facets turned from the surface's normal by more than a right angle
  std::string obstacle = {};  ///< why there are no facets; empty if all is well
};

struct ShapeFacets {
  std::vector<Vec3> points;  ///< the model's vertices first
  std::vector<MeshedFace> faces;
  /// The largest distance of faces and of edges: each point of a facet is that near to its face,
  /// each point of a face that near to its facets. Faces with obstacles are not counted. The proof
  /// takes facets of a face to cover it once, which `folded` ones may not.
  double distance = 0;
  bool stopped = false;  ///< `ask` ended it: there is nothing then
};

/// The facets of all faces.
///
/// ask      asked now and then whether to go on; by one thread at a time
/// throws   InvalidInput if the deviation is not positive and finite, another option is negative
///          or so small that an edge would have more than a million sides, or a number in the
///          model names nothing
/// cost     about linear in the number of facets; faces are shared by the processor's cores, and
///          the result does not depend on their number
ShapeFacets shape_facets(const ShapeModel& model, const FacetOptions& options,
                         const std::function<bool()>& ask = {});

}  // namespace blossom
