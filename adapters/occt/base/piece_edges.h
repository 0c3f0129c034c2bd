// SPDX-License-Identifier: LGPL-2.1-or-later
// Which edges of a piece of a face are its border.

#pragma once

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

namespace blossom::occt {

/// False of an edge within the piece, and of one that is a point.
inline bool bounds_piece(const TopoDS_Shape& edge) {
  return edge.Orientation() != TopAbs_INTERNAL && !BRep_Tool::Degenerated(TopoDS::Edge(edge));
}

}  // namespace blossom::occt
