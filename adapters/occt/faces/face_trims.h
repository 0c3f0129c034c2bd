// SPDX-License-Identifier: LGPL-2.1-or-later
// The trims of a face as core has them, and which edges and vertices they are.

#pragma once

#include <optional>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "core/topology/clipping/curve_clip.h"
#include "core/topology/face_trims.h"

namespace blossom::occt {

/// The trims of a face, turned forward: it lies on the left of its loops.
///
/// throws   BadModel if the face has no wire, a wire is open, or an edge has no pcurve on it
FaceTrims face_trims(const TopoDS_Face& face);

/// The edges and vertices of a face in the order in which its trims count them, from 0.
struct TrimShapes {
  TopTools_IndexedMapOfShape edges, vertices;

  /// As the forward face uses it: reversed means walked from last to first.
  TopoDS_Edge edge(const Coedge& coedge) const;

  /// A vertex or an edge; null for no place.
  TopoDS_Shape at(const std::optional<TrimPlace>& place) const;
};

TrimShapes trim_shapes(const TopoDS_Face& face);

}  // namespace blossom::occt
