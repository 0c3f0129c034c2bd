// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets: edges of solids rounded by a rolling ball.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/blending/fillet_refusal.h"
#include "core/intersection/options.h"

namespace blossom::occt {

struct FilletOptions {
  double radius = 1;     ///< model units
  bool partial = false;  ///< make those that can be made, instead of all or none
  IntersectionOptions intersection{};
};

/// A face of a result and where it comes from. Numbers are those of the shape.
struct FilletFace {
  TopoDS_Face face;
  int from = 0;  ///< of the face that it is or is left of; 0: a blend
  int edge = 0;  ///< of a blend: of the edge in whose place it is; 0: of a corner
};

struct FilletedSolid {
  TopoDS_Solid solid;
  std::vector<FilletFace> faces;
  double volume = 0;  ///< cubic model units, by our own integration
};

struct FilletResult {
  /// All solids of the shape, those without fillets as they were; none if anything is refused and
  /// not `partial`, or nothing could be made.
  std::vector<FilletedSolid> solids;
  std::vector<int> edges;  ///< that have fillets: those asked for and those that they go on in
  std::vector<FilletRefusal> refused;
  double volume_before = 0;
};

/// Rounds edges of solids.
///
/// A fillet goes on along edges that continue an edge smoothly. Nothing is given out that is not
/// closed, valid by BRepCheck, and changed in volume the way its edges say: less material at convex
/// ones, more at concave ones.
///
/// shape    solids, faces turned outwards
/// edges    numbers as in `edge_facts`
/// throws   InvalidInput if there is no edge of such a number, none is given, or the radius is not
///          positive and finite; BadModel if a face cannot be used
FilletResult fillet(const TopoDS_Shape& shape, const std::vector<int>& edges,
                    const FilletOptions& options = {});

}  // namespace blossom::occt
