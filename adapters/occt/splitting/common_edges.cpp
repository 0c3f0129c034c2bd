// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/common_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/curve_queries.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "core/bounds/box_tree.h"
#include "core/forms/curve_spans.h"
#include "core/plane/limits.h"

namespace blossom::occt {
namespace {

// Of the angle between faces: below it they hardly cross. Double precision tells normals apart to
// 1e-16, and the root of that where they come from differences.
constexpr double kLeastSine = 1e-8;

constexpr int kEvenPoints = 8;  // of a curve that may keep to edges

std::vector<TopoDS_Edge> edges_of(const TopoDS_Face& face) {
  TopTools_IndexedMapOfShape found;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (it.Current().Orientation() != TopAbs_INTERNAL &&
        !BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
      found.Add(it.Current().Oriented(TopAbs_FORWARD));
  std::vector<TopoDS_Edge> edges;
  for (int i = 1; i <= found.Extent(); ++i) edges.push_back(TopoDS::Edge(found(i)));
  return edges;
}

// Whether the vertices at the ends are the same ones, in either order.
bool have_same_ends(const EdgeSplits& splits, const TopoDS_Edge& a, const TopoDS_Edge& b) {
  const TopoDS_Vertex from = TopExp::FirstVertex(b), to = TopExp::LastVertex(b);
  const auto is_end = [&](const TopoDS_Vertex& vertex) {
    return splits.are_one(vertex, from) || splits.are_one(vertex, to);
  };
  return is_end(TopExp::FirstVertex(a)) && is_end(TopExp::LastVertex(a));
}

bool has_overlap(const FaceIntersection& pair) {
  return std::any_of(pair.found.places.begin(), pair.found.places.end(),
                     [](const Place& place) { return place.kind == PlaceKind::Overlap; });
}

// Edges with boxes of all that is within reach of them.
struct BoxedEdge {
  TopoDS_Edge edge;
  Box box;
  double reach = 0;
};

template <class Reach>
std::vector<BoxedEdge> boxed(const std::vector<TopoDS_Edge>& edges, const Reach& reach_of) {
  std::vector<BoxedEdge> all;
  for (const TopoDS_Edge& edge : edges) {
    const RangedCurve of = curve_of(edge);
    const double reach = reach_of(edge);
    const CurveSpans spans = bezier_spans(of.curve, of.range, reach);
    Box box;
    for (const auto& span : spans.spans)
      for (const Vec4& p : span.curve.points) {
        const Vec3 x = projected(p);
        box = joined(box, {x, x});
      }
    all.push_back({edge, widened(box, spans.error + kSampledMargin * reach), reach});
  }
  return all;
}

Box spline_box(const Spline& curve) {
  Box box;
  for (const Vec3& p : curve.points) box = joined(box, {p, p});
  return box;
}

bool is_near(const Vec3& point, const std::vector<BoxedEdge>& edges) {
  return std::any_of(edges.begin(), edges.end(), [&](const BoxedEdge& each) {
    return meet(each.box, {point, point}) &&
           foot_on(curve_of(each.edge), pnt(point)).distance <= each.reach;
  });
}

// Two faces that cross, each of which may be off by the tolerance.
struct CrossedFaces {
  Handle(Geom_Surface) a, b;
  double tolerance = 0;

  /// How far the curve may be from its place at a point: by the tolerances over the sine of the
  /// angle between the faces there, which may be as small as 0 at an end alone.
  double reach_at(const SurfacePoint& of) const {
    const SurfaceJet on_a = frame_at(a, of.uv_a), on_b = frame_at(b, of.uv_b);
    const Vec3 normal_a = cross(on_a.du, on_a.dv), normal_b = cross(on_b.du, on_b.dv);
    const double size = norm(normal_a) * norm(normal_b);
    const double sine = size > 0 ? norm(cross(normal_a, normal_b)) / size : 1;
    return 2 * tolerance / std::max(sine, kLeastSine);
  }
};

// Whether a curve is near one of the edges all along: at its samples, of which a straight one has
// hardly more than its ends, and at points between them.
bool keeps_to(const IntersectionCurve& curve, const std::vector<BoxedEdge>& edges,
              const CrossedFaces& crossed) {
  const auto is_along = [&](const SurfacePoint& x) {
    if (is_near(x.point, edges)) return true;
    if (curve.tangential) return false;
    const double reach = crossed.reach_at(x);
    return std::ranges::any_of(edges, [&](const BoxedEdge& each) {
      return reach > each.reach && foot_on(curve_of(each.edge), pnt(x.point)).distance <= reach;
    });
  };
  for (int i = 1; i < kEvenPoints && !edges.empty(); ++i) {
    const double t = at(curve.curve.domain(), static_cast<double>(i) / kEvenPoints);
    if (!is_along(
            {point_at(curve.curve, t), point_at(curve.chart_a, t), point_at(curve.chart_b, t)}))
      return false;
  }
  return !edges.empty() && std::ranges::all_of(curve.samples, is_along);
}

// A few points between the ends tell which curves may run along edges.
bool may_keep_to(const IntersectionCurve& curve, const std::vector<BoxedEdge>& edges) {
  const std::size_t last = curve.samples.size() - 1;
  return is_near(curve.samples[last / 2].point, edges) ||
         is_near(curve.samples[last / 4].point, edges) ||
         is_near(curve.samples[3 * last / 4].point, edges);
}

// Whether some point of an edge, not its ends alone, is as near as that to what `height` measures.
template <class Height>
bool comes_near(const TopoDS_Edge& edge, double reach, const Height& height) {
  const RangedCurve of = curve_of(edge);
  return std::ranges::any_of(std::array{0.5, 0.25, 0.75}, [&](double part) {
    return std::abs(height(of.curve->Value(at(of.range, part)))) <= reach;
  });
}

// Whether an edge in which the surface of its face ends may lie on another one. The two surfaces
// may miss each other there by rounding, and leave no curve. On other surfaces than planes only
// seams are tried, since it takes time and most edges lie on none.
template <class Reach>
bool may_lie_on(const std::vector<TopoDS_Edge>& edges, const TopoDS_Face& of,
                const TopoDS_Face& other, double tolerance, const Reach& reach) {
  const Handle(Geom_Plane) plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(other));
  if (!plane.IsNull())
    return std::ranges::any_of(edges, [&](const TopoDS_Edge& edge) {
      return comes_near(edge, reach(edge),
                        [&](const gp_Pnt& p) { return plane->Pln().Distance(p); });
    });
  std::optional<SurfaceProjector> feet;
  return std::ranges::any_of(edges, [&](const TopoDS_Edge& edge) {
    if (!BRep_Tool::IsClosed(edge, of)) return false;
    if (!feet) feet.emplace(other, tolerance);
    return comes_near(edge, reach(edge), [&](const gp_Pnt& p) {
      return feet->height({p.X(), p.Y(), p.Z()});
    });
  });
}

}  // namespace

CommonEdges::CommonEdges(const std::vector<TopoDS_Face>& a, const std::vector<TopoDS_Face>& b,
                         const IntersectionOptions& options, EdgesLie lying)
    : a_(a),
      b_(b),
      options_(options),
      reach_(kLiesReach * options.tolerances.point),
      lying_(lying),
      in_a_(a.size()),
      in_b_(b.size()) {
  options_.part_a = options_.part_b = {};
  options_.known.clear();
}

void CommonEdges::add(const FaceIntersection& pair) {
  const auto face_a = static_cast<std::size_t>(pair.face_a);
  const auto face_b = static_cast<std::size_t>(pair.face_b);
  const std::vector<TopoDS_Edge> of_a = edges_of(a_[face_a]), of_b = edges_of(b_[face_b]);
  const auto& curves = pair.found.curves;
  const auto any_along = [&](const std::vector<TopoDS_Edge>& edges, const TopoDS_Face& of,
                             const TopoDS_Face& other) {
    const auto most = [this](const TopoDS_Edge& edge) { return most_reach(edge); };
    if (curves.empty()) return may_lie_on(edges, of, other, options_.tolerances.point, most);
    const std::vector<BoxedEdge> near = boxed(edges, most);
    return std::any_of(curves.begin(), curves.end(),
                       [&](const IntersectionCurve& curve) { return may_keep_to(curve, near); }) ||
           may_lie_on(edges, of, other, options_.tolerances.point, most);
  };
  const bool overlap = has_overlap(pair);
  if (overlap || any_along(of_b, b_[face_b], a_[face_a])) lay(of_b, Of::B, face_a);
  if (overlap || any_along(of_a, a_[face_a], b_[face_b])) lay(of_a, Of::A, face_b);
}

void CommonEdges::add_loose() {
  const auto loose_of = [this](const std::vector<TopoDS_Face>& faces) {
    TopTools_IndexedMapOfShape found;
    for (const TopoDS_Face& face : faces)
      for (const TopoDS_Edge& edge : edges_of(face))
        if (most_reach(edge) > reach_) found.Add(edge);
    std::vector<TopoDS_Edge> edges;
    for (int i = 1; i <= found.Extent(); ++i) edges.push_back(TopoDS::Edge(found(i)));
    return edges;
  };
  const std::vector<TopoDS_Edge> of_a = loose_of(a_), of_b = loose_of(b_);
  for (std::size_t i = 0; i < a_.size() && !of_b.empty(); ++i) lay(of_b, Of::B, i);
  for (std::size_t i = 0; i < b_.size() && !of_a.empty(); ++i) lay(of_a, Of::A, i);
}

double CommonEdges::most_reach(const TopoDS_Edge& edge) const {
  return lying_ == EdgesLie::WithinTolerance ? reach_
                                             : std::max(reach_, BRep_Tool::Tolerance(edge));
}

void CommonEdges::ask_limit() const {
  if (limit_.is_reached())
    throw LimitFailure("looking for common edges: the time limit is reached");
}

// Open CASCADE minimizes over the shape for that, which takes milliseconds.
Bnd_Box CommonEdges::box_of(const TopoDS_Shape& shape, double margin) {
  if (!boxes_.IsBound(shape)) {
    ask_limit();
    Bnd_Box least;
    BRepBndLib::AddOptimal(shape, least, Standard_False, Standard_False);
    boxes_.Bind(shape, least);
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
  const auto as_a_whole = [&](double reach) {
    const std::vector<Interval> runs = beside.runs(reach, reach);
    return runs.size() == 1 && runs.front().from <= of.range.from && runs.front().to >= of.range.to;
  };
  const double own = most_reach(edge);
  if (own > reach_ && !as_a_whole(reach_) && as_a_whole(own)) {
    loosest_ = std::max(loosest_, own);
    loose_.Add(edge);
    return true;
  }
  return std::ranges::any_of(beside.runs(reach_, reach_),
                             [&](const Interval& run) { return !passes(of, run, feet, reach_); });
}

// Which of the edges lie in a face of the other shape, and where they meet its edges.
void CommonEdges::lay(const std::vector<TopoDS_Edge>& edges, Of of, std::size_t face) {
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
    if (!lies_on(edge, *feet)) continue;
    lying.push_back(edge);
    for (TopExp_Explorer it(in, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge own = TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
      if (BRep_Tool::Degenerated(own)) continue;
      of == Of::A ? meet(edge, own) : meet(own, edge);
    }
  }
}

void CommonEdges::meet(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  if (!looked_.emplace(edges_.Add(a), edges_.Add(b)).second) return;
  if (box_of(a, reach(a)).IsOut(box_of(b, reach(b)))) return;
  IntersectionOptions options = options_;
  options.tolerances.point =
      std::max(std::max(reach(a), reach(b)) / kLiesReach, stated_together(a, b));
  const CurveIntersection found = intersect(a, b, options);
  for (const CurvePoint& point : found.points)
    meetings_.push_back(moved_to_end({a, b, point.a, point.b}, options.tolerances.point));
  for (const CurveOverlap& run : found.overlaps) {
    along_.push_back({a, b, run.a, run.b});
    meetings_.push_back({a, b, run.a.from, run.b.from});
    meetings_.push_back({a, b, run.a.to, run.b.to});
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
  for (const BoxedEdge& each : boxed(edges_of(whose == Of::A ? a : b), plain)) {
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
  const std::size_t blurred = blurs_.size();
  blur(edge, face, points);
  if (touches_.size() == known && blurs_.size() == blurred) return;
  for (const TopoDS_Edge& border : edges_of(face))  // where it may touch as well
    whose == Of::A ? meet(edge, border) : meet(border, edge);
}

// A touch, and roots between which the edge does not leave the surface, are one place: it touches
// it there, and crosses it twice by what the two are off.
void CommonEdges::blur(const TopoDS_Edge& edge, const TopoDS_Face& face,
                       const std::vector<CurveSurfacePoint>& points) {
  const RangedCurve of = curve_of(edge);
  const double within = options_.tolerances.point + BRep_Tool::Tolerance(edge);
  std::optional<SurfaceProjector> feet;
  const auto add = [&](const Interval& between) {
    if (!is_short(of, between, options_.tolerances.point)) return;
    if (!feet) feet.emplace(face, options_.tolerances.point);
    if (keeps_on(of, between, *feet, within))
      blurs_.push_back({edge, widened_by(of, between, kSampledMargin * within)});
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].tangential) add(points[i].box_t);
    if (i + 1 < points.size()) add({points[i].t, points[i + 1].t});
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
  take(edges_of(b_[face_b]), in_a_[face_a]);
  take(edges_of(a_[face_a]), in_b_[face_b]);
  const auto near = boxed(edges, [this](const TopoDS_Edge& edge) { return this->reach(edge); });
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
    if (keeps_to(pair.found.curves[i], near, crossed) || is_contact_along(pair.found.curves[i]))
      along.push_back(i);
  return along;
}

// What is known to be a vertex comes first, so that it stands for all that is in one place with it.
void CommonEdges::split(EdgeSplits& splits) const {
  for (const EdgeBlur& of : blurs_) splits.blur(of.edge, of.at);
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
  const auto increasing = [](const Interval& of) {
    return Interval{std::min(of.from, of.to), std::max(of.from, of.to)};
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
