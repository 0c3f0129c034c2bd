// SPDX-License-Identifier: LGPL-2.1-or-later
// Where two edges meet, told by the vertex that they meet in.

#pragma once

#include <TopoDS_Edge.hxx>

namespace blossom::occt {

/// A common point of two edges.
struct EdgesMeeting {
  TopoDS_Edge a, b;
  double at_a = 0, at_b = 0;
};

/// Where edges that cross at a small angle meet: at an end of one of them, if it keeps within reach
/// of the other one from the crossing to that end. By what they are off, edges that touch in an end
/// may cross beside it.
///
/// within   model units
EdgesMeeting moved_to_end(EdgesMeeting met, double within);

}  // namespace blossom::occt
