// SPDX-License-Identifier: LGPL-2.1-or-later
// How far the border of a shape may be off its edges.

#pragma once

#include <algorithm>

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

namespace blossom::occt {

/// The largest tolerance that an edge of the shape states; 0 without edges.
inline double largest_edge_tolerance(const TopoDS_Shape& shape) {
  double largest = 0;
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
  return largest;
}

}  // namespace blossom::occt
