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

// Places of an edge at which it is compared with another one, both ends apart. Two curves of degree
// three that are as near at five places and their ends are so everywhere.
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
    for (std::size_t i = 0; i < borders_.size(); ++i)
      while (split_one(borders_[i]) || close_one(borders_[i])) {
      }
    return std::move(replaced_);
  }

 private:
  double reach(const TopoDS_Edge& a, const TopoDS_Edge& b) const {
    return std::max({tolerance_, BRep_Tool::Tolerance(a), BRep_Tool::Tolerance(b)});
  }
  bool runs_along(const Run& a, const Interval& part, const Run& b, double reach) const;
  bool is_sliver(const TopoDS_Edge& a, const TopoDS_Edge& b) const;
  bool close_one(FaceBorder& border);
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

// Whether an edge may be one of two along each other: it has a length, and its face is on one side
// of it.
bool is_side(const FaceBorder& border, std::size_t of) {
  const TopoDS_Edge& edge = border.edges[of];
  return !BRep_Tool::Degenerated(edge) &&
         std::ranges::count_if(border.edges,
                               [&](const TopoDS_Edge& each) { return each.IsSame(edge); }) == 1;
}

bool Slivers::close_one(FaceBorder& border) {
  for (std::size_t i = 0; i < border.edges.size(); ++i)
    for (std::size_t k = i + 1; k < border.edges.size(); ++k) {
      TopoDS_Edge kept = border.edges[i], lost = border.edges[k];
      if (!is_side(border, i) || !is_side(border, k) || !is_sliver(kept, lost)) continue;
      if (body_.number(lost) > 0) std::swap(kept, lost);
      border.edges.erase(border.edges.begin() + static_cast<std::ptrdiff_t>(k));
      border.edges.erase(border.edges.begin() + static_cast<std::ptrdiff_t>(i));
      replace(forward(lost), forward(kept), kept.Orientation() == lost.Orientation());
      return true;
    }
  return false;
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
  std::vector<Bnd_Box> boxes;
  for (const TopoDS_Edge& edge : border.edges) {
    boxes.push_back(BRep_Tool::Degenerated(edge) ? Bnd_Box() : bounds_of(edge));
    boxes.back().Enlarge(tolerance_);
  }
  for (std::size_t i = 0; i < border.edges.size(); ++i)
    for (std::size_t k = 0; k < border.edges.size(); ++k) {
      if (i == k || boxes[i].IsOut(boxes[k]) || !is_side(border, i) || !is_side(border, k))
        continue;
      const TopoDS_Edge edge = forward(border.edges[i]), beside = forward(border.edges[k]);
      for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(beside), TopExp::LastVertex(beside)})
        if (const auto t = split_at(edge, beside, vertex)) {
          split(edge, *t, vertex);
          return true;
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
