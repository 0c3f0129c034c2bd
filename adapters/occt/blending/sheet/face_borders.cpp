// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/face_borders.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/edges/edge_splits.h"

namespace blossom::occt {
namespace {

// Places of an edge at which it is compared with another one, both ends apart. That is a choice and
// no proof: edges of many spans may be as near at all of them and yet part between two.
constexpr int kCompared = 5;

TopoDS_Edge forward(const TopoDS_Edge& edge) { return TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)); }

// The curve of an edge, forward.
struct Run {
  Interval range;
  Handle(Geom_Curve) curve;

  explicit Run(const TopoDS_Edge& edge) : curve(BRep_Tool::Curve(edge, range.from, range.to)) {}
  Vec3 point(double t) const { return vec(curve->Value(t).XYZ()); }
  double foot(const Vec3& of) const { return nearest_on(curve, range, of); }
  double off(const Vec3& of) const { return distance(point(foot(of)), of); }
};

class Slivers {
 public:
  Slivers(std::vector<FaceBorder>& borders, const BodyEdges& body, double tolerance)
      : borders_(borders), body_(body), tolerance_(tolerance) {}

  std::vector<ReplacedEdge> closed() {
    for (FaceBorder& border : borders_) {
      while (split_one(border)) {
      }
      close_pairs(border);
    }
    return std::move(replaced_);
  }

 private:
  double reach(const TopoDS_Edge& a, const TopoDS_Edge& b) const {
    return std::max({tolerance_, BRep_Tool::Tolerance(a), BRep_Tool::Tolerance(b)});
  }
  bool runs_along(const Run& a, const Interval& part, const Run& b, double reach) const;
  bool is_sliver(const TopoDS_Edge& a, const TopoDS_Edge& b) const;
  void close_pairs(FaceBorder& border);
  std::optional<double> split_at(const TopoDS_Edge& edge, const TopoDS_Edge& beside,
                                 const TopoDS_Vertex& vertex) const;
  bool split_one(FaceBorder& border);
  void split(const TopoDS_Edge& edge, double t, const TopoDS_Vertex& vertex);
  void replace(const TopoDS_Edge& lost, const TopoDS_Edge& kept, bool reversed);

  std::vector<FaceBorder>& borders_;
  const BodyEdges& body_;
  double tolerance_;
  std::vector<ReplacedEdge> replaced_;
};

bool Slivers::runs_along(const Run& a, const Interval& part, const Run& b, double reach) const {
  for (int i = 1; i <= kCompared; ++i)
    if (b.off(a.point(at(part, static_cast<double>(i) / (kCompared + 1)))) > reach) return false;
  return true;
}

// Whether two edges of a border run back along each other from end to end.
bool Slivers::is_sliver(const TopoDS_Edge& a, const TopoDS_Edge& b) const {
  if (!TopExp::FirstVertex(a, Standard_True).IsSame(TopExp::LastVertex(b, Standard_True)) ||
      !TopExp::LastVertex(a, Standard_True).IsSame(TopExp::FirstVertex(b, Standard_True)))
    return false;
  const Run run_a(a), run_b(b);
  const double t = at(run_a.range, 0.5);
  const double way = run_a.curve->DN(t, 1).Dot(run_b.curve->DN(run_b.foot(run_a.point(t)), 1));
  return (way < 0) == (a.Orientation() == b.Orientation()) &&
         runs_along(run_a, run_a.range, run_b, reach(a, b));
}

// Places of the edges that may be one of two along each other: they have a length, and the face is
// on one side of them.
std::vector<std::size_t> sides_of(const FaceBorder& border) {
  TopTools_IndexedMapOfShape numbers;
  std::vector<int> uses(border.edges.size() + 1);
  for (const TopoDS_Edge& edge : border.edges) ++uses[static_cast<std::size_t>(numbers.Add(edge))];
  std::vector<std::size_t> sides;
  for (std::size_t i = 0; i < border.edges.size(); ++i) {
    const TopoDS_Edge& edge = border.edges[i];
    if (!BRep_Tool::Degenerated(edge) &&
        uses[static_cast<std::size_t>(numbers.FindIndex(edge))] == 1)
      sides.push_back(i);
  }
  return sides;
}

// Edges are compared with those alone that begin where they end: a face may have thousands.
void Slivers::close_pairs(FaceBorder& border) {
  const std::vector<std::size_t> sides = sides_of(border);
  TopTools_IndexedMapOfShape starts;
  std::vector<std::vector<std::size_t>> begins(sides.size() + 1);  // edges by start; none at 0
  for (const std::size_t each : sides) {
    const int start = starts.Add(TopExp::FirstVertex(border.edges[each], Standard_True));
    begins[static_cast<std::size_t>(start)].push_back(each);
  }
  std::vector<bool> is_closed(border.edges.size());
  std::vector<std::pair<TopoDS_Edge, TopoDS_Edge>> pairs;
  for (const std::size_t i : sides) {
    if (is_closed[i]) continue;
    const int end = starts.FindIndex(TopExp::LastVertex(border.edges[i], Standard_True));
    for (const std::size_t k : begins[static_cast<std::size_t>(end)]) {
      if (k <= i || is_closed[k] || !is_sliver(border.edges[i], border.edges[k])) continue;
      is_closed[i] = is_closed[k] = true;
      pairs.emplace_back(border.edges[i], border.edges[k]);
      break;
    }
  }
  std::vector<TopoDS_Edge> left;
  for (std::size_t i = 0; i < border.edges.size(); ++i)
    if (!is_closed[i]) left.push_back(border.edges[i]);
  border.edges = std::move(left);
  for (auto& [kept, lost] : pairs) {
    if (body_.number(lost) > 0) std::swap(kept, lost);
    replace(forward(lost), forward(kept), kept.Orientation() == lost.Orientation());
  }
}

// Where a vertex of the one edge divides the other, if they run along each other on one side of it.
std::optional<double> Slivers::split_at(const TopoDS_Edge& edge, const TopoDS_Edge& beside,
                                        const TopoDS_Vertex& vertex) const {
  const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
  if (vertex.IsSame(first) || vertex.IsSame(last)) return std::nullopt;
  const double near = std::max(reach(edge, beside), BRep_Tool::Tolerance(vertex));
  const Run own(edge), other(beside);
  const Vec3 place = point_of(vertex);
  const double t = own.foot(place);
  if (distance(own.point(t), place) > near || distance(point_of(first), place) <= near ||
      distance(point_of(last), place) <= near)
    return std::nullopt;
  // Both pieces have a length: else the edge would be divided there again and again.
  for (const double end : {own.range.from, own.range.to})
    if (distance(own.point(t), own.point(end)) <= near) return std::nullopt;
  // What is common to both ends at the nearest of their ends on either side.
  for (const TopoDS_Vertex& end : {first, last}) {
    const double back = other.foot(point_of(end)), from = other.foot(place);
    const bool reaches = distance(other.point(back), point_of(end)) <= near;
    if (reaches && runs_along(other, {std::min(from, back), std::max(from, back)}, own, near))
      return t;
  }
  return runs_along(other, other.range, own, near) ? std::optional(t) : std::nullopt;
}

bool Slivers::split_one(FaceBorder& border) {
  const std::vector<std::size_t> sides = sides_of(border);
  std::vector<Bnd_Box> boxes;  // by place among the sides
  for (const std::size_t each : sides) {
    boxes.push_back(bounds_of(border.edges[each]));
    boxes.back().Enlarge(tolerance_);
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (i == k || boxes[i].IsOut(boxes[k])) continue;
      const TopoDS_Edge edge = forward(border.edges[sides[i]]);
      const TopoDS_Edge beside = forward(border.edges[sides[k]]);
      for (const TopoDS_Vertex& vertex :
           {TopExp::FirstVertex(beside), TopExp::LastVertex(beside)}) {
        Bnd_Box near = bounds_of(vertex);
        near.Enlarge(BRep_Tool::Tolerance(beside));
        if (boxes[i].IsOut(near)) continue;
        if (const auto t = split_at(edge, beside, vertex)) {
          split(edge, *t, vertex);
          return true;
        }
      }
    }
  return false;
}

void Slivers::split(const TopoDS_Edge& edge, double t, const TopoDS_Vertex& vertex) {
  const Run run(edge);
  cover(vertex, run.point(t), BRep_Tool::Tolerance(edge));
  const TopoDS_Edge before = piece_of(edge, {run.range.from, t}, TopExp::FirstVertex(edge), vertex);
  const TopoDS_Edge after = piece_of(edge, {t, run.range.to}, vertex, TopExp::LastVertex(edge));
  for (FaceBorder& border : borders_)
    for (std::size_t i = border.edges.size(); i-- > 0;) {
      if (!border.edges[i].IsSame(edge)) continue;
      const TopAbs_Orientation as = border.edges[i].Orientation();
      border.edges[i] = TopoDS::Edge(before.Oriented(as));
      border.edges.push_back(TopoDS::Edge(after.Oriented(as)));
    }
  replaced_.push_back({edge, {before, after}});
}

// Puts an edge in the place of another one that runs along it.
void Slivers::replace(const TopoDS_Edge& lost, const TopoDS_Edge& kept, bool reversed) {
  for (FaceBorder& border : borders_)
    for (TopoDS_Edge& edge : border.edges) {
      if (!edge.IsSame(lost)) continue;
      if (!keeps_chart_curve(kept, border.of)) {
        const Run run(kept);
        Interval own;
        const Handle(Geom2d_Curve) chart = chart_curve_of(edge, border.of, own);
        const gp_Pnt2d near = chart->Value(at(own, 0.5));
        const SurfaceProjector feet(border.of, Precision::Confusion());
        add_chart(
            kept,
            image_of(run.curve, run.range, feet, Vec2{near.X(), near.Y()}, kSamePlace * tolerance_)
                .chart,
            border.of);
      }
      const bool as_it_runs = (edge.Orientation() == TopAbs_FORWARD) != reversed;
      edge = TopoDS::Edge(kept.Oriented(as_it_runs ? TopAbs_FORWARD : TopAbs_REVERSED));
    }
  replaced_.push_back({lost, {kept}});
}

}  // namespace

std::vector<ReplacedEdge> close_slivers(std::vector<FaceBorder>& borders, const BodyEdges& body,
                                        double tolerance) {
  return Slivers(borders, body, tolerance).closed();
}

}  // namespace blossom::occt
