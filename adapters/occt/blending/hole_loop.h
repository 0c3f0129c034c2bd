// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges of a model, in any order and direction, as loops round holes.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// An edge as the way round a hole has it.
struct HoleEdge {
  int number = 0;          ///< in the model, 1-based in the order of TopExp::MapShapes
  TopoDS_Edge edge;        ///< as its face has it, if it has one
  TopoDS_Face face;        ///< the neighbour; null if no face uses the edge
  bool backwards = false;  ///< the way runs against the edge's own curve
};
using HoleLoop = std::vector<HoleEdge>;

/// The edges of these numbers as loops, each one starting with the edge that comes first.
///
/// within   how far ends that meet may be apart, beside what their vertices say; model units
/// throws   BadModel if there is no such edge, or a number comes twice; an edge is degenerated, or
///          lies between two faces already; a way round ends, or forks, at an edge
std::vector<HoleLoop> hole_loops(const TopoDS_Shape& model, const std::vector<int>& edges,
                                 double within = 0);

/// The numbers of all edges that one face uses once, but for degenerated ones.
std::vector<int> open_edges(const TopoDS_Shape& model);

/// What of them bounds holes and sheets.
struct OpenBorders {
  std::vector<int> edges;
  double within = 0;  ///< how far loose faces may be apart where they meet, model units
};

/// Without the edges along which loose faces meet, which are nowhere farther apart than
/// `border_gaps` takes for one.
///
/// sew_gap   the widest gap that is one, see there; with 0 no faces meet so
OpenBorders open_borders(const TopoDS_Shape& model, std::optional<double> sew_gap = {});

/// What open edges make up.
struct OpenLoops {
  std::vector<HoleLoop> holes;
  std::vector<HoleLoop> sheets;       ///< outer borders, which enclose the faces beside them
  std::vector<std::string> left_out;  ///< why the way round ends or forks, once for each such way
};

/// All loops of open edges. A way that forks among edges which no way before it has walked is left
/// out, with the edges that it has walked.
OpenLoops open_loops(const TopoDS_Shape& model, const OpenBorders& borders);

}  // namespace blossom::occt
