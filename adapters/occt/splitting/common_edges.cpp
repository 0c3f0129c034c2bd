// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/common_edges.h"

#include <algorithm>
#include <optional>

#include <BRep_Builder.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Line.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/curve_queries.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "adapters/occt/splitting/edges_in_reach.h"
#include "adapters/occt/splitting/limits.h"
#include "core/base/sampled_margin.h"
#include "core/bounds/box_tree.h"
#include "core/math/interval.h"
#include "core/results/result_places.h"

namespace blossom::occt {
namespace {

// Whether the vertices at the ends are the same ones, in either order.
bool have_same_ends(const EdgeSplits& splits, const TopoDS_Edge& a, const TopoDS_Edge& b) {
  const TopoDS_Vertex from = TopExp::FirstVertex(b), to = TopExp::LastVertex(b);
  const auto is_end = [&](const TopoDS_Vertex& vertex) {
    return splits.are_one(vertex, from) || splits.are_one(vertex, to);
  };
  return is_end(TopExp::FirstVertex(a)) && is_end(TopExp::LastVertex(a));
}

bool is_line(const RangedCurve& of) { return !Handle(Geom_Line)::DownCast(of.curve).IsNull(); }

}  // namespace

CommonEdges::CommonEdges(const std::vector<TopoDS_Face>& a, const std::vector<TopoDS_Face>& b,
                         const IntersectionOptions& options, EdgesLie lying)
    : a_(a),
      b_(b),
      options_(options),
      reach_((lying == EdgesLie::Nearby ? kLooseReach : kLiesReach) * options.tolerances.point),
      lying_(lying),
      in_a_(a.size()),
      in_b_(b.size()) {
  options_.part_a = options_.part_b = {};
  options_.known.clear();
}

void CommonEdges::know_equal(const ShapeIntersection& found) {
  const auto add_equal = [this](const TopoDS_Edge& of, const TopoDS_Edge& equal) {
    if (!equals_.IsBound(of)) equals_.Bind(of, TopTools_MapOfShape());
    equals_.ChangeFind(of).Add(equal);
  };
  for (const FaceIntersection& pair : found.pairs) {
    if (pair.equal_edges.empty()) continue;
    copied_.Add(a_[static_cast<std::size_t>(pair.face_a)]);
    copied_.Add(b_[static_cast<std::size_t>(pair.face_b)]);
    for (const auto& [a, b] : pair.equal_edges) {
      add_equal(a, b);
      add_equal(b, a);
    }
  }
}

void CommonEdges::add(const FaceIntersection& pair) {
  const auto face_a = static_cast<std::size_t>(pair.face_a);
  const auto face_b = static_cast<std::size_t>(pair.face_b);
  const std::vector<TopoDS_Edge> of_a = bounding_edges(a_[face_a]),
                                 of_b = bounding_edges(b_[face_b]);
  const auto& curves = pair.found.curves;
  for (const Place& place : pair.found.places)
    if (place.kind == PlaceKind::Node)
      for (const auto* edges : {&of_a, &of_b}) add_uncertain_in(place, *edges);
  const auto any_along = [&](const std::vector<TopoDS_Edge>& edges, const TopoDS_Face& of,
                             const TopoDS_Face& other) {
    const auto most = [this](const TopoDS_Edge& edge) { return most_reach(edge); };
    if (curves.empty()) return may_lie_on(edges, of, other, options_.tolerances.point, most);
    const std::vector<EdgeInReach> near = edges_in_reach(edges, most);
    return std::any_of(curves.begin(), curves.end(),
                       [&](const IntersectionCurve& curve) { return may_follow(curve, near); }) ||
           may_lie_on(edges, of, other, options_.tolerances.point, most);
  };
  const bool overlap = has_overlap(pair.found);
  if (overlap || any_along(of_b, b_[face_b], a_[face_a])) add_coincident(of_b, Of::B, face_a);
  if (overlap || any_along(of_a, a_[face_a], b_[face_b])) add_coincident(of_a, Of::A, face_b);
}

void CommonEdges::add_uncertain_in(const Place& node, const std::vector<TopoDS_Edge>& edges) {
  for (const TopoDS_Edge& edge : edges)
    if (const auto at = stretch_in_node(curve_of(edge), node, options_.tolerances.point))
      uncertain_.push_back({edge, *at});
}

void CommonEdges::add_loose() {
  const auto loose_of = [this](const std::vector<TopoDS_Face>& faces) {
    TopTools_IndexedMapOfShape found;
    for (const TopoDS_Face& face : faces)
      for (const TopoDS_Edge& edge : bounding_edges(face))
        if (most_reach(edge) > reach_) found.Add(edge);
    std::vector<TopoDS_Edge> edges;
    for (int i = 1; i <= found.Extent(); ++i) edges.push_back(TopoDS::Edge(found(i)));
    return edges;
  };
  const std::vector<TopoDS_Edge> of_a = loose_of(a_), of_b = loose_of(b_);
  for (std::size_t i = 0; i < a_.size() && !of_b.empty(); ++i) add_coincident(of_b, Of::B, i);
  for (std::size_t i = 0; i < b_.size() && !of_a.empty(); ++i) add_coincident(of_a, Of::A, i);
}

double CommonEdges::most_reach(const TopoDS_Edge& edge) const {
  return lying_ == EdgesLie::WhereFacesMeet ? reach_ : std::max(reach_, BRep_Tool::Tolerance(edge));
}

void CommonEdges::ask_limit() const {
  if (limit_.is_reached())
    throw LimitFailure("looking for common edges: the time limit is reached");
}

// Open CASCADE minimizes over the shape for that, which takes milliseconds.
Bnd_Box CommonEdges::box_of(const TopoDS_Shape& shape, double margin) {
  if (!boxes_.IsBound(shape)) {
    ask_limit();
    boxes_.Bind(shape, bounds_of(shape, BoxKind::Least));
  }
  Bnd_Box box = boxes_.Find(shape);
  box.Enlarge(margin);
  return box;
}

double CommonEdges::reach(const TopoDS_Edge& edge) const {
  return loose_.Contains(edge) ? most_reach(edge) : reach_;
}

// In part within the tolerance, or as a whole within its own: where it leaves what is so near is
// known no better than that.
bool CommonEdges::lies_on(const TopoDS_Edge& edge, const SurfaceProjector& feet) {
  const RangedCurve of = curve_of(edge);
  const CurveBeside beside(of.curve, of.range, feet);
  const double own = most_reach(edge);
  if (own > reach_ && beside.is_one_run(own, own) && !beside.is_one_run(reach_, reach_)) {
    loosest_ = std::max(loosest_, own);
    loose_.Add(edge);
    return true;
  }
  return std::ranges::any_of(beside.runs(reach_, reach_),
                             [&](const Interval& run) { return !passes(of, run, feet, reach_); });
}

// A face with a copy in the edge's own solid, and without an equal of the edge, is as that copy is
// to the edge: where they touch, both solids touch themselves there, and are left as they are.
bool CommonEdges::is_in(const TopoDS_Edge& edge, const TopoDS_Face& face,
                        const SurfaceProjector& feet) {
  const TopTools_MapOfShape* const equals = equals_.Seek(edge);
  if (equals == nullptr) return lies_on(edge, feet);
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (equals->Contains(it.Current())) return true;
  return !copied_.Contains(face) && lies_on(edge, feet);
}

// Which of the edges lie in a face of the other shape, and where they meet its edges.
void CommonEdges::add_coincident(const std::vector<TopoDS_Edge>& edges, Of of, std::size_t face) {
  const TopoDS_Face& in = of == Of::A ? b_[face] : a_[face];
  std::vector<TopoDS_Edge>& lying = of == Of::A ? in_b_[face] : in_a_[face];
  std::optional<SurfaceProjector> feet;
  for (const TopoDS_Edge& edge : edges) {
    const auto is_same = [&](const TopoDS_Edge& known) { return known.IsSame(edge); };
    const Bnd_Box box = box_of(in, most_reach(edge));
    if (box.IsOut(box_of(edge, reach_)) || std::any_of(lying.begin(), lying.end(), is_same))
      continue;
    if (!feet) feet.emplace(in, options_.tolerances.point);
    ask_limit();
    if (!is_in(edge, in, *feet)) continue;
    for (const TopoDS_Edge& other : lying) meet_own(edge, other);
    lying.push_back(edge);
    for (TopExp_Explorer it(in, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge own = TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
      if (BRep_Tool::Degenerated(own)) continue;
      of == Of::A ? meet(edge, own) : meet(own, edge);
    }
  }
}

double CommonEdges::meeting_tolerance(const TopoDS_Edge& a, const TopoDS_Edge& b) const {
  return std::max(std::max(reach(a), reach(b)) / kLiesReach, stated_together(a, b));
}

CurveIntersection CommonEdges::common_of(const TopoDS_Edge& a, const TopoDS_Edge& b,
                                         double tolerance) const {
  IntersectionOptions options = limit_.remaining();
  options.threads = options_.threads;
  options.tolerances.point = tolerance;
  return intersect(a, b, options);
}

void CommonEdges::meet(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  if (!looked_.emplace(edges_.Add(a), edges_.Add(b)).second) return;
  if (box_of(a, reach(a)).IsOut(box_of(b, reach(b)))) return;
  const double tolerance = meeting_tolerance(a, b);
  const CurveIntersection found = common_of(a, b, tolerance);
  for (const CurvePoint& point : found.points)
    meetings_.push_back(moved_to_end({a, b, point.a, point.b}, tolerance));
  for (const CurveOverlap& run : found.overlaps) {
    along_.push_back({a, b, run.a, run.b});
    meetings_.push_back({a, b, run.a.from, run.b.from});
    meetings_.push_back({a, b, run.a.to, run.b.to});
  }
}

// Edges of one shape that lie in a face of the other one meet in vertices that they share, or where
// their shape touches itself. What they keep to from a shared vertex on is that vertex.
void CommonEdges::meet_own(const TopoDS_Edge& edge, const TopoDS_Edge& other) {
  if (box_of(edge, reach(edge)).IsOut(box_of(other, reach(other)))) return;
  if (!looked_.emplace(edges_.Add(edge), edges_.Add(other)).second) return;
  const RangedCurve of = curve_of(edge), beside = curve_of(other);
  std::vector<double> shared;
  for (const double end : {of.range.from, of.range.to})
    if (const TopoDS_Vertex vertex =
            end == of.range.from ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge);
        vertex.IsSame(TopExp::FirstVertex(other)) || vertex.IsSame(TopExp::LastVertex(other)))
      shared.push_back(end);
  if (!shared.empty() && is_line(of) && is_line(beside)) return;
  const double tolerance = meeting_tolerance(edge, other);
  for (const CurvePoint& point : common_of(edge, other, tolerance).points) {
    const bool is_shared = std::ranges::any_of(shared, [&](double end) {
      return foot_on(beside, of.curve->Value(0.5 * (end + point.a))).distance <= tolerance;
    });
    if (!is_shared) meetings_.push_back(moved_to_end({edge, other, point.a, point.b}, tolerance));
  }
}

void CommonEdges::add_touches(const FaceIntersection& pair) {
  touch(pair, Of::A);
  touch(pair, Of::B);
}

void CommonEdges::touch(const FaceIntersection& pair, Of whose) {
  if (pair.found.curves.empty()) return;
  const TopoDS_Face& a = a_[static_cast<std::size_t>(pair.face_a)];
  const TopoDS_Face& b = b_[static_cast<std::size_t>(pair.face_b)];
  const int face = whose == Of::A ? pair.face_b + 1 : -pair.face_a - 1;
  const auto plain = [this](const TopoDS_Edge&) { return reach_; };
  for (const EdgeInReach& each : edges_in_reach(bounding_edges(whose == Of::A ? a : b), plain)) {
    const bool reached =
        std::ranges::any_of(pair.found.curves, [&](const IntersectionCurve& curve) {
          return blossom::meet(each.box, spline_box(curve.curve));
        });
    if (reached && touched_.emplace(edges_.Add(each.edge), face).second)
      touch(each.edge, whose == Of::A ? b : a, whose);
  }
}

void CommonEdges::touch(const TopoDS_Edge& edge, const TopoDS_Face& face, Of whose) {
  if (limit_.is_reached()) return;
  const std::size_t known = touches_.size();
  const RangedCurve curve = curve_of(edge);
  // What lies in the surface touches it everywhere, and is known without a search.
  if (lies_throughout(curve, SurfaceProjector(face, options_.tolerances.point), reach_)) return;
  IntersectionOptions left = limit_.remaining();
  left.threads = options_.threads;
  const std::vector<CurveSurfacePoint> points = intersect(edge, face, left).points;
  for (const CurveSurfacePoint& point : points)
    if (point.tangential && is_short(curve, point.box_t, options_.tolerances.point))
      touches_.push_back({edge, point.t});
  const std::size_t uncertain = uncertain_.size();
  add_uncertain(edge, face, points);
  if (touches_.size() == known && uncertain_.size() == uncertain) return;
  for (const TopoDS_Edge& border : bounding_edges(face))  // where it may touch as well
    whose == Of::A ? meet(edge, border) : meet(border, edge);
}

void CommonEdges::add_uncertain(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                const std::vector<CurveSurfacePoint>& points) {
  const double tolerance = options_.tolerances.point;
  const double within = tolerance + BRep_Tool::Tolerance(edge);
  const RangedCurve of = curve_of(edge);
  for (const Interval& place : one_places(of, face, points, tolerance, within)) {
    uncertain_.push_back({edge, widened_by(of, place, kSampledMargin * within)});
    for (const TopoDS_Edge& border : bounding_edges(face)) {
      const RangedCurve along = curve_of(border);
      const std::optional<Interval> beside = stretch_beside(along, of, place, within);
      if (beside && is_short(along, *beside, tolerance))
        uncertain_.push_back({border, widened_by(along, *beside, kSampledMargin * within)});
    }
  }
}

std::vector<std::size_t> CommonEdges::curves_along(const FaceIntersection& pair) const {
  const auto face_a = static_cast<std::size_t>(pair.face_a);
  const auto face_b = static_cast<std::size_t>(pair.face_b);
  std::vector<TopoDS_Edge> edges;
  const auto take = [&](const std::vector<TopoDS_Edge>& own,
                        const std::vector<TopoDS_Edge>& lying) {
    for (const TopoDS_Edge& edge : own)
      if (std::any_of(lying.begin(), lying.end(),
                      [&](const TopoDS_Edge& other) { return other.IsSame(edge); }))
        edges.push_back(edge);
  };
  take(bounding_edges(b_[face_b]), in_a_[face_a]);
  take(bounding_edges(a_[face_a]), in_b_[face_b]);
  // The surface itself may be as far from its own edge as that states.
  const auto near =
      edges_in_reach(edges, [this](const TopoDS_Edge& edge) { return most_reach(edge); });
  const CrossedFaces crossed{BRep_Tool::Surface(a_[face_a]), BRep_Tool::Surface(b_[face_b]),
                             options_.tolerances.point};
  std::vector<std::size_t> along;
  std::optional<SurfaceProjector> on_a, on_b;
  const auto is_contact_along = [&](const IntersectionCurve& curve) {
    if (!curve.tangential || edges.empty()) return false;
    if (!on_a) on_a.emplace(a_[face_a], options_.tolerances.point);
    if (!on_b) on_b.emplace(b_[face_b], options_.tolerances.point);
    return stands_for_contact(edges, curve, *on_a, *on_b, options_.tolerances.point);
  };
  for (std::size_t i = 0; i < pair.found.curves.size(); ++i)
    if (follows(pair.found.curves[i], near, crossed) || is_contact_along(pair.found.curves[i]))
      along.push_back(i);
  return along;
}

std::vector<Interval> CommonEdges::runs_along(const TopoDS_Edge& edge,
                                              const TopoDS_Face& face) const {
  TopTools_IndexedMapOfShape own;
  TopExp::MapShapes(face, TopAbs_EDGE, own);
  std::vector<Interval> runs;
  for (const EdgesAlong& of : along_) {
    if (of.a.IsSame(edge) && own.Contains(of.b)) runs.push_back(of.at_a);
    if (of.b.IsSame(edge) && own.Contains(of.a)) runs.push_back(increasing(of.at_b));
  }
  return runs;
}

// What is known to be a vertex comes first, so that it stands for all that is in one place with it.
void CommonEdges::split(EdgeSplits& splits) const {
  for (const UncertainStretch& of : uncertain_) splits.add_uncertain(of.edge, of.at);
  const auto is_end = [this](const TopoDS_Edge& edge, double t) {
    const RangedCurve of = curve_of(edge);
    const gp_Pnt point = of.curve->Value(t);
    return point.Distance(of.curve->Value(of.range.from)) <= reach_ ||
           point.Distance(of.curve->Value(of.range.to)) <= reach_;
  };
  for (const bool ends : {true, false})
    for (const EdgesMeeting& of : meetings_) {
      if (ends != (is_end(of.a, of.at_a) || is_end(of.b, of.at_b))) continue;
      const int a = splits.add(of.a, of.at_a, {}), b = splits.add(of.b, of.at_b, {});
      splits.unite(splits.vertex(of.a, a), splits.vertex(of.b, b));
    }
  for (const EdgeTouch& of : touches_) splits.add(of.edge, of.at, {});
}

void CommonEdges::match(EdgeSplits& splits) const {
  const auto carry = [&](const TopoDS_Edge& from, const TopoDS_Edge& to, const Interval& range) {
    const RangedCurve of = curve_of(from), other = curve_of(to);
    const int count = splits.count(from);
    for (int i = 0; i < count; ++i) {
      const double t = splits.parameter(from, i);
      if (t < range.from || t > range.to) continue;
      const EdgeFoot foot = foot_on(other, of.curve->Value(t));
      const int split = splits.add(to, foot.parameter, {});
      splits.unite(splits.vertex(from, i), splits.vertex(to, split));
    }
    return splits.count(to);
  };
  for (const EdgesAlong& of : along_) {
    carry(of.a, of.b, of.at_a);
    carry(of.b, of.a, increasing(of.at_b));
  }
}

TopoDS_Edge CommonEdges::image(const TopoDS_Edge& first, const TopoDS_Edge& second,
                               bool reversed) const {
  const RangedCurve of = curve_of(first), other = curve_of(second);
  const EdgeFoot middle = foot_on(other, of.curve->Value(at(of.range, 0.5)));
  const double tolerance =
      std::max(reach_, BRep_Tool::Tolerance(first) + BRep_Tool::Tolerance(second));
  const BRep_Builder builder;
  TopoDS_Edge made;
  builder.MakeEdge(made);
  double widest = BRep_Tool::Tolerance(first);
  for (const Handle(BRep_CurveRepresentation) & on :
       Handle(BRep_TEdge)::DownCast(second.TShape())->Curves()) {
    if (!on->IsCurveOnSurface()) continue;
    const TopLoc_Location location = second.Location() * on->Location();
    TopoDS_Face face;
    builder.MakeFace(face, on->Surface(), location, tolerance);
    const SurfaceProjector feet(face, options_.tolerances.point);
    const auto chart_of = [&](const Handle(Geom2d_Curve) & given) {
      const gp_Pnt2d near = given->Value(middle.parameter);
      const ChartImage found =
          image_of(of.curve, of.range, feet, Vec2{near.X(), near.Y()}, tolerance);
      widest = std::max(widest, kSampledMargin * found.deviation);
      return found.chart;
    };
    const Handle(Geom2d_Curve) chart = chart_of(on->PCurve());
    if (!on->IsCurveOnClosedSurface()) {
      builder.UpdateEdge(made, chart, on->Surface(), location, widest);
      continue;
    }
    const Handle(Geom2d_Curve) other_side = chart_of(on->PCurve2());
    builder.UpdateEdge(made, reversed ? other_side : chart, reversed ? chart : other_side,
                       on->Surface(), location, widest);
  }
  builder.UpdateEdge(made, widest);
  return made;
}

std::string CommonEdges::join(EdgeSplits& splits, EdgeUnion& joined) const {
  for (const auto& [a, b] : splits.united()) joined.join(a, b);
  for (const EdgesAlong& of : along_) {
    const RangedCurve on_b = curve_of(of.b);
    for (const EdgePiece& piece : splits.pieces(of.a)) {
      const double middle = at(piece.range, 0.5);
      if (middle < of.at_a.from || middle > of.at_a.to) continue;
      const EdgeFoot foot = foot_on(on_b, curve_of(of.a).curve->Value(middle));
      const auto& others = splits.pieces(of.b);
      const auto other = std::find_if(others.begin(), others.end(), [&](const EdgePiece& each) {
        return each.range.from < foot.parameter && foot.parameter < each.range.to;
      });
      if (other == others.end() || !have_same_ends(splits, piece.edge, other->edge))
        return "edges that run along each other are not divided alike";
      const bool reversed = of.at_b.to < of.at_b.from;
      if (!joined.join(piece.edge, other->edge, image(piece.edge, other->edge, reversed), reversed))
        return "more than two edges run along each other";
    }
  }
  return {};
}

}  // namespace blossom::occt
