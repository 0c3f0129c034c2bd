// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/hole_loop.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/base/errors.h"

namespace blossom::occt {
namespace {

std::string name_of(int number) { return "edge " + std::to_string(number); }

struct EdgeUse {
  TopoDS_Face face;
  TopoDS_Edge edge;
};

/// Every use of an edge by a face; a seam is used twice by one.
std::vector<EdgeUse> uses_of(const TopoDS_Shape& model, const TopoDS_Edge& edge) {
  std::vector<EdgeUse> uses;
  for (TopExp_Explorer face(model, TopAbs_FACE); face.More(); face.Next())
    for (TopExp_Explorer it(face.Current(), TopAbs_EDGE); it.More(); it.Next())
      if (it.Current().IsSame(edge))
        uses.push_back({TopoDS::Face(face.Current()), TopoDS::Edge(it.Current())});
  return uses;
}

/// An end of an edge: that of its curve's start, or of its end.
struct EdgeEnd {
  std::size_t edge = 0;
  bool last = false;
  TopoDS_Vertex vertex;
  gp_Pnt point;
  double tolerance = 0;
};

std::array<EdgeEnd, 2> ends_of(const HoleEdge& edge, std::size_t place) {
  std::array<EdgeEnd, 2> ends;
  const TopoDS_Edge along = TopoDS::Edge(edge.edge.Oriented(TopAbs_FORWARD));
  for (const bool last : {false, true}) {
    const TopoDS_Vertex vertex = last ? TopExp::LastVertex(along) : TopExp::FirstVertex(along);
    if (vertex.IsNull()) throw BadModel(name_of(edge.number) + " has an end without a vertex");
    ends[last] = {place, last, vertex, BRep_Tool::Pnt(vertex), BRep_Tool::Tolerance(vertex)};
  }
  return ends;
}

bool meet(const EdgeEnd& a, const EdgeEnd& b) {
  return a.vertex.IsSame(b.vertex) ||
         a.point.Distance(b.point) <= std::max(Precision::Confusion(), a.tolerance + b.tolerance);
}

std::string at_point(const gp_Pnt& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", p.X(), p.Y(), p.Z());
  return text;
}

HoleEdge picked(const TopoDS_Shape& model, const TopoDS_Edge& edge, int number) {
  if (BRep_Tool::Degenerated(edge)) throw BadModel(name_of(number) + " has no length");
  const std::vector<EdgeUse> uses = uses_of(model, edge);
  if (uses.size() > 1)
    throw BadModel(name_of(number) + " bounds no hole: faces use it " +
                   std::to_string(uses.size()) + " times");
  if (uses.empty()) return {number, edge, {}, false};
  return {number, uses.front().edge, uses.front().face, false};
}

/// Walks from edge to edge; every edge is walked once, even where the way does not close.
class LoopFinder {
 public:
  LoopFinder(const TopoDS_Shape& model, const std::vector<int>& edges) {
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(model, TopAbs_EDGE, all);
    std::set<int> known;
    for (const int number : edges) {
      if (number < 1 || number > all.Extent())
        throw BadModel("there is no " + name_of(number) + ", the model has " +
                       std::to_string(all.Extent()));
      if (!known.insert(number).second) throw BadModel(name_of(number) + " is named twice");
      edges_.push_back(picked(model, TopoDS::Edge(all(number)), number));
      ends_.push_back(ends_of(edges_.back(), ends_.size()));
    }
    used_.assign(edges_.size(), false);
  }

  bool has_more() const { return std::find(used_.begin(), used_.end(), false) != used_.end(); }

  /// The loop of the first edge that is left.
  HoleLoop next() {
    const auto start =
        static_cast<std::size_t>(std::find(used_.begin(), used_.end(), false) - used_.begin());
    HoleLoop loop{edges_[start]};
    used_[start] = true;
    EdgeEnd end = ends_[start][1];
    while (!meet(end, ends_[start][0])) {
      const EdgeEnd next = next_end(end, loop.back().number);
      loop.push_back(edges_[next.edge]);
      loop.back().backwards = next.last;
      used_[next.edge] = true;
      end = ends_[next.edge][next.last ? 0 : 1];
    }
    return loop;
  }

 private:
  /// The one end that goes on from `from`, among edges that are not used yet.
  EdgeEnd next_end(const EdgeEnd& from, int number) const {
    std::vector<EdgeEnd> found;
    for (std::size_t i = 0; i < ends_.size(); ++i)
      for (const EdgeEnd& end : ends_[i])
        if (!used_[i] && meet(end, from)) found.push_back(end);
    if (found.size() == 1) return found.front();
    throw BadModel("the way round the hole " + std::string(found.empty() ? "ends" : "forks") +
                   " after " + name_of(number) + ", at " + at_point(from.point));
  }

  std::vector<HoleEdge> edges_;
  std::vector<std::array<EdgeEnd, 2>> ends_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<HoleLoop> hole_loops(const TopoDS_Shape& model, const std::vector<int>& edges) {
  LoopFinder finder(model, edges);
  std::vector<HoleLoop> loops;
  while (finder.has_more()) loops.push_back(finder.next());
  return loops;
}

OpenLoops open_loops(const TopoDS_Shape& model) {
  LoopFinder finder(model, open_edges(model));
  OpenLoops result;
  while (finder.has_more()) try {
      result.loops.push_back(finder.next());
    } catch (const BadModel& error) {
      result.left_out.push_back(error.what());
    }
  return result;
}

std::vector<int> open_edges(const TopoDS_Shape& model) {
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(model, TopAbs_EDGE, all);
  std::vector<int> uses(static_cast<std::size_t>(all.Extent()) + 1);
  for (TopExp_Explorer face(model, TopAbs_FACE); face.More(); face.Next())
    for (TopExp_Explorer it(face.Current(), TopAbs_EDGE); it.More(); it.Next())
      ++uses[static_cast<std::size_t>(all.FindIndex(it.Current()))];
  std::vector<int> open;
  for (int number = 1; number <= all.Extent(); ++number)
    if (uses[static_cast<std::size_t>(number)] == 1 &&
        !BRep_Tool::Degenerated(TopoDS::Edge(all(number))))
      open.push_back(number);
  return open;
}

}  // namespace blossom::occt
