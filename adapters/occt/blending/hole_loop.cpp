// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/hole_loop.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <utility>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/repair/border_gaps.h"

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

bool meet(const EdgeEnd& a, const EdgeEnd& b, double within) {
  const double apart = std::max({Precision::Confusion(), a.tolerance + b.tolerance, within});
  return a.vertex.IsSame(b.vertex) || a.point.Distance(b.point) <= apart;
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
  LoopFinder(const TopoDS_Shape& model, const std::vector<int>& edges, double within)
      : within_(within) {
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
    while (!meet(end, ends_[start][0], within_)) {
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
        if (!used_[i] && meet(end, from, within_)) found.push_back(end);
    if (found.size() == 1) return found.front();
    throw BadModel("the way round the hole " + std::string(found.empty() ? "ends" : "forks") +
                   " after " + name_of(number) + ", at " + at_point(from.point));
  }

  std::vector<HoleEdge> edges_;
  std::vector<std::array<EdgeEnd, 2>> ends_;
  std::vector<bool> used_;
  double within_;
};

constexpr double kEnclosed =
    0.5;  // cosine, 60 degrees: of faces on one side of their border (a choice)

constexpr int kChords = 16;  // of an edge, to see which way it turns

/// An edge as it is walked: the normal of its neighbour in its middle, turned so that the neighbour
/// lies to the left, seen from its tip.
struct WalkedEdge {
  Vec3 normal;
  Vec3 swept;  ///< the area between the edge and the origin, as a vector; twice
  double length = 0;
};

std::optional<WalkedEdge> walked(const HoleEdge& of) {
  if (of.face.IsNull()) return {};
  const BRepAdaptor_Curve2d chart(of.edge, of.face);
  const double t = 0.5 * (chart.FirstParameter() + chart.LastParameter());
  const BRepAdaptor_Curve curve(of.edge);
  const gp_Pnt2d uv = chart.Value(t);
  gp_Pnt point;
  gp_Vec u, v;
  BRepAdaptor_Surface(of.face, false).D1(uv.X(), uv.Y(), point, u, v);
  const Vec3 normal = vec(u.Crossed(v));
  if (!(norm(normal) > 0)) return {};
  // A face lies to the left of its borders, seen from the tip of its surface's normal.
  const bool reversed = of.edge.Orientation() == TopAbs_REVERSED;
  const bool left = (reversed == of.backwards) == (of.face.Orientation() != TopAbs_REVERSED);
  WalkedEdge edge{unit(normal) * (left ? 1 : -1), {}, GCPnts_AbscissaPoint::Length(curve)};
  const double range = curve.LastParameter() - curve.FirstParameter();
  for (int i = 0; i < kChords; ++i)
    edge.swept =
        edge.swept + cross(vec(curve.Value(curve.FirstParameter() + range * i / kChords)),
                           vec(curve.Value(curve.FirstParameter() + range * (i + 1) / kChords)));
  if (of.backwards) edge.swept = -edge.swept;
  return edge;
}

/// Whether the way round goes round the faces beside it, not round a hole: seen from the side from
/// which it runs counter-clockwise, they lie to the left. Where they stand upright on it, as the
/// walls of an open box do, there is a hole.
bool encloses_faces(const HoleLoop& loop) {
  std::vector<WalkedEdge> edges;
  for (const HoleEdge& edge : loop)
    if (const auto found = walked(edge)) edges.push_back(*found);
  Vec3 round{}, faced{};
  double length = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const WalkedEdge& edge = edges[i];
    round = round + edge.swept;
    faced = faced + edge.normal * edge.length;
    length += edge.length;
  }
  return norm(round) > 0 && dot(faced, unit(round)) > kEnclosed * length;
}

}  // namespace

std::vector<HoleLoop> hole_loops(const TopoDS_Shape& model, const std::vector<int>& edges,
                                 double within) {
  LoopFinder finder(model, edges, within);
  std::vector<HoleLoop> loops;
  while (finder.has_more()) loops.push_back(finder.next());
  return loops;
}

OpenBorders open_borders(const TopoDS_Shape& model, std::optional<double> sew_gap) {
  OpenBorders borders{open_edges(model)};
  if (sew_gap == 0) return borders;
  const BorderGaps gaps = border_gaps(faces_of(model), sew_gap, {});
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(model, TopAbs_EDGE, all);
  for (const LooseBorder& border : gaps.borders) {
    if (!border.gap) continue;
    std::erase(borders.edges, all.FindIndex(border.edge));
    borders.within = std::max(borders.within, joined_within(*border.gap));
  }
  return borders;
}

OpenLoops open_loops(const TopoDS_Shape& model, const OpenBorders& borders) {
  LoopFinder finder(model, borders.edges, borders.within);
  OpenLoops result;
  while (finder.has_more()) try {
      HoleLoop loop = finder.next();
      (encloses_faces(loop) ? result.sheets : result.holes).push_back(std::move(loop));
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
