// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/wires/edge_divider.h"

#include <algorithm>
#include <array>
#include <sstream>

#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/curve_queries.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/queries/solid_rays.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "adapters/occt/wires/exact_meeting.h"
#include "core/base/tolerances.h"
#include "core/curves/curve_closing.h"

namespace blossom::occt {
namespace {

// Parts of a piece in which its side is asked for: on a face it is if all of them are; of a solid
// one that tells is enough, since it changes sides at no other place than its ends.
constexpr std::array<double, 4> kAskedAt{0.5, 0.37, 0.71, 0.19};

// Tolerances: how far beyond a face's surface a run in it may end, which is looked for within one
// tolerance of it, down to pieces of one, and rounding.
constexpr double kRunEnd = 3;

// How far one may be off from the other and still meet it, model units.
double reach_of(double tolerance, double a, double b) { return std::max({tolerance, a, b}); }

template <class Shape>
struct Boxed {
  Shape shape;
  Bnd_Box box;
};

template <class Shape>
Boxed<Shape> boxed(const Shape& shape) {
  return {shape, bounds_of(shape)};
}

Bnd_Box enlarged(Bnd_Box box, double reach) {
  box.Enlarge(reach);
  return box;
}

std::vector<TopoDS_Face> faces_in(const TopoDS_Solid& solid) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  return faces;
}

// Where an edge may change sides. What is a run in a surface ends for sure where it meets an edge
// of the face; else its end says only where the run is no longer known, and the edge may go on in
// it.
struct EdgeStop {
  double parameter = 0;
  double reach = 0;  // by which it was found
  bool sure = true;
  TopoDS_Shape on{};  // what is met there, if that is known

  // Of what several stops are on, the shape of least dimension.
  void add(const TopoDS_Shape& other) {
    if (!other.IsNull() && (on.IsNull() || other.ShapeType() > on.ShapeType())) on = other;
  }
};

// Stops that an edge does not leave between them, by more than one of them was found by, are one:
// the ends of the edge, or a sure one.
std::vector<EdgeStop> distinct_stops(std::vector<EdgeStop> stops, const RangedCurve& of) {
  const auto is_place = [&](const EdgeStop& a, const EdgeStop& b) {
    const double s = a.parameter, t = b.parameter, reach = std::max(a.reach, b.reach);
    const Vec3 point = vec(of.curve->Value(s));
    return distance(point, vec(of.curve->Value(t))) <= reach &&
           distance(point, vec(of.curve->Value(0.5 * (s + t)))) <= reach;
  };
  std::ranges::sort(stops, {}, &EdgeStop::parameter);
  EdgeStop last{of.range.to};
  std::vector<EdgeStop> kept{{of.range.from}};
  for (const EdgeStop& stop : stops) {
    if (stop.parameter >= of.range.to || is_place(stop, last)) {
      last.add(stop.on);
    } else if (stop.parameter <= of.range.from || is_place(kept.back(), stop)) {
      const TopoDS_Shape on = kept.back().on;
      if (!kept.back().sure) kept.back() = stop;
      kept.back().add(stop.on);
      kept.back().add(on);
    } else {
      kept.push_back(stop);
    }
  }
  kept.push_back(last);
  return kept;
}

// A stop that is not sure divides nothing where the edge does not change sides.
void add_piece(const WirePiece& piece, bool sure, std::vector<WirePiece>& pieces) {
  if (!sure && !pieces.empty() && pieces.back().side == piece.side)
    pieces.back().range.to = piece.range.to;
  else
    pieces.push_back(piece);
}

}  // namespace

// What tells the place of a point in a face.
struct ObstacleChart {
  FaceTrims trims;
  SurfaceProjector feet;
};

// What edges meet. The rays of a solid and the charts of faces are made when they are asked for.
struct EdgeObstacles {
  std::vector<Boxed<TopoDS_Face>> faces;
  std::vector<std::unique_ptr<ObstacleChart>> charts;
  std::vector<Boxed<TopoDS_Edge>> edges;
  std::vector<TopoDS_Vertex> vertices;
  std::vector<Boxed<TopoDS_Solid>> solids;
  std::vector<std::unique_ptr<SolidRays>> rays;
};

// Where an edge meets the shape, by its parameters.
struct EdgeMeetings {
  struct Run {
    std::size_t face = 0;
    double reach = 0;
  };
  explicit EdgeMeetings(const TopoDS_Edge& edge)
      : of(curve_of(edge)), box(bounds_of(edge)), tolerance(BRep_Tool::Tolerance(edge)) {}

  RangedCurve of;
  Bnd_Box box;       // of the edge
  double tolerance;  // which it states
  std::vector<EdgeStop> stops;
  std::vector<Run> in_surfaces;
  struct Along {
    Interval range;
    TopoDS_Edge edge;
  };
  std::vector<Along> along_edges;
  Status status = Status::Complete;
  std::vector<std::string> reasons;
  bool open = false;

  // decided   whether what was found in contacts is no matter of the tolerance
  template <class Found>
  void add_state(const Found& found, bool decided) {
    bool contacts_alone = found.status == Status::Tolerance;
    for (const std::string& reason : found.certificate.reasons) {
      const bool contact = reason == kContactsWithinTolerance || reason == kPointsOnWires;
      if (!contact || !decided) add_reason(reason);
      contacts_alone = contacts_alone && contact;
    }
    if (!decided || !contacts_alone) status = weaker(status, found.status);
    open = open || found.status == Status::Stopped ||
           std::ranges::count(found.places, PlaceKind::Open, &CurvePlace::kind) > 0;
  }
  void add_reason(const std::string& reason) {
    if (std::ranges::find(reasons, reason) == reasons.end()) reasons.push_back(reason);
  }
  void add_contacts() {
    status = weaker(status, Status::Tolerance);
    add_reason(kContactsWithinTolerance);
  }
  void add_run(const Interval& run, double reach, bool sure, const TopoDS_Shape& on) {
    stops.push_back({run.from, reach, sure, on});
    stops.push_back({run.to, reach, sure, on});
  }
  // Where more counts as common than was asked for.
  void tell_reach(double asked) {
    double largest = 0;
    for (const EdgeStop& stop : stops)
      if (stop.sure) largest = std::max(largest, stop.reach);
    for (const Run& run : in_surfaces) largest = std::max(largest, run.reach);
    if (largest <= asked) return;
    status = weaker(status, Status::Tolerance);
    std::ostringstream reason;
    reason << "what is within " << largest << " mm of an edge counts as on it: the shapes state it";
    reasons.push_back(reason.str());
  }
  // The work ends here.
  void stop() {
    status = Status::Stopped;
    open = true;
  }
};

EdgeDivider::EdgeDivider(const TopoDS_Shape& shape, const std::vector<TopoDS_Solid>& solids,
                         const IntersectionOptions& options)
    : shape_(std::make_unique<EdgeObstacles>()),
      tolerance_(options.tolerances.point),
      limit_(options) {
  TopTools_IndexedMapOfShape faces, edges, vertices;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  for (int i = 1; i <= faces.Extent(); ++i) shape_->faces.push_back(boxed(TopoDS::Face(faces(i))));
  for (int i = 1; i <= edges.Extent(); ++i)
    if (!BRep_Tool::Degenerated(TopoDS::Edge(edges(i))))
      shape_->edges.push_back(boxed(TopoDS::Edge(edges(i))));
  for (int i = 1; i <= vertices.Extent(); ++i)
    shape_->vertices.push_back(TopoDS::Vertex(vertices(i)));
  for (const TopoDS_Solid& solid : solids) shape_->solids.push_back(boxed(solid));
  shape_->charts.resize(shape_->faces.size());
  shape_->rays.resize(shape_->solids.size());
}

EdgeDivider::~EdgeDivider() = default;

// `one_within` of what two boxes hold.
double EdgeDivider::within(const Bnd_Box& a, const Bnd_Box& b) const {
  double largest = 0;
  for (const Bnd_Box& box : {a, b})
    for (const gp_Pnt& corner : {box.CornerMin(), box.CornerMax()})
      largest = std::max(largest, max_norm(vec(corner)));
  return one_within({tolerance_}, largest);
}

void EdgeDivider::meet_faces(const TopoDS_Edge& edge, EdgeMeetings& met) {
  for (std::size_t i = 0; i < shape_->faces.size() && !met.open; ++i) {
    const auto& [face, box] = shape_->faces[i];
    const double reach = reach_of(tolerance_, met.tolerance, BRep_Tool::Tolerance(face));
    if (box.IsOut(enlarged(met.box, reach))) continue;
    if (limit_.is_reached()) return met.stop();
    // What lies in the surface as a whole ends in it where it meets the face's edges.
    const ExactMeeting exact(edge, within(met.box, box), reach);
    if (CurveBeside(met.of.curve, met.of.range, chart_of(i).feet).is_one_run(reach, reach)) {
      if (!exact.lies_in(face, chart_of(i).feet, met.of.range)) met.add_contacts();
      met.in_surfaces.push_back({i, reach});
      continue;
    }
    IntersectionOptions options = limit_.remaining_alone();
    options.tolerances.point = reach;
    const CurveSurfaceIntersection found = intersect(edge, face, options);
    met.add_state(found, exact.decides(found, face, chart_of(i).feet));
    for (const CurveSurfacePoint& point : found.points)
      met.stops.push_back({point.t, reach, true, face});
    bool lies = false;  // a touch is one place
    for (const CurveSurfaceOverlap& run : found.overlaps) {
      const bool touch = passes(met.of, run.t, chart_of(i).feet, reach);
      const double middle = at(run.t, 0.5);
      if (touch)
        met.stops.push_back(
            {middle, reach, true,
             lies_on(i, vec(met.of.curve->Value(middle)), reach) ? face : TopoDS_Face()});
      else
        met.add_run(run.t, kRunEnd * reach, false, {});
      lies = lies || !touch;
    }
    if (lies) met.in_surfaces.push_back({i, reach});
  }
}

void EdgeDivider::meet_edges(const TopoDS_Edge& edge, EdgeMeetings& met) {
  for (const auto& [other, box] : shape_->edges) {
    if (met.open) return;
    const double reach = reach_of(tolerance_, met.tolerance, BRep_Tool::Tolerance(other));
    if (box.IsOut(enlarged(met.box, reach))) continue;
    if (other.IsSame(edge)) {
      met.along_edges.push_back({met.of.range, other});
      continue;
    }
    if (limit_.is_reached()) return met.stop();
    IntersectionOptions options = limit_.remaining_alone();
    options.tolerances.point = reach;
    const CurveIntersection found = intersect(edge, other, options);
    met.add_state(found, ExactMeeting(edge, within(met.box, box), reach).decides(found, other));
    for (const CurvePoint& point : found.points) met.stops.push_back({point.a, reach, true, other});
    for (const CurveOverlap& run : found.overlaps) {
      met.add_run(run.a, reach, true, other);
      met.along_edges.push_back({run.a, other});
    }
  }
}

void EdgeDivider::meet_vertices(EdgeMeetings& met) const {
  for (const TopoDS_Vertex& vertex : shape_->vertices) {
    const double reach = reach_of(tolerance_, met.tolerance, BRep_Tool::Tolerance(vertex));
    const gp_Pnt point = BRep_Tool::Pnt(vertex);
    if (enlarged(met.box, reach).IsOut(point)) continue;
    const EdgeFoot foot = foot_on(met.of, point);
    if (foot.distance <= reach) met.stops.push_back({foot.parameter, reach, true, vertex});
  }
}

const ObstacleChart& EdgeDivider::chart_of(std::size_t face) {
  std::unique_ptr<ObstacleChart>& chart = shape_->charts[face];
  const TopoDS_Face& of = shape_->faces[face].shape;
  if (!chart)
    chart = std::make_unique<ObstacleChart>(
        ObstacleChart{face_trims(of), SurfaceProjector(of, tolerance_)});
  return *chart;
}

bool EdgeDivider::lies_on(std::size_t face, const Vec3& point, double reach) {
  const auto& [trims, feet] = chart_of(face);
  const Vec2 uv = feet.foot(point, {});
  if (feet.gap(point, uv) > reach) return false;
  return border_at(trims, uv).has_value() || is_inside_by_periods(trims, uv);
}

std::optional<WireSide> EdgeDivider::side_in_solids(const Vec3& point) {
  bool told = true;
  for (std::size_t i = 0; i < shape_->solids.size(); ++i) {
    const auto& [solid, box] = shape_->solids[i];
    if (box.IsOut(pnt(point))) continue;
    if (!shape_->rays[i])
      shape_->rays[i] = std::make_unique<SolidRays>(faces_in(solid), tolerance_);
    const std::optional<bool> inside = shape_->rays[i]->is_inside(point);
    if (inside == true) return WireSide::Inside;
    told = told && inside.has_value();
  }
  return told ? std::optional(WireSide::Outside) : std::nullopt;
}

// The edge or face that a piece lies on; null if there is none.
TopoDS_Shape EdgeDivider::below(const EdgeMeetings& met, const Interval& piece) {
  const double middle = at(piece, 0.5);
  for (const EdgeMeetings::Along& along : met.along_edges)
    if (along.range.from <= middle && middle <= along.range.to) return along.edge;
  for (const EdgeMeetings::Run& run : met.in_surfaces)
    if (std::ranges::all_of(kAskedAt, [&](double part) {
          return lies_on(run.face, vec(met.of.curve->Value(at(piece, part))), run.reach);
        }))
      return shape_->faces[run.face].shape;
  return {};
}

std::optional<WireSide> EdgeDivider::side_of(const EdgeMeetings& met, const Interval& piece) {
  if (!below(met, piece).IsNull()) return WireSide::On;
  for (const double part : kAskedAt)
    if (const auto side = side_in_solids(vec(met.of.curve->Value(at(piece, part))))) return side;
  return {};
}

EdgeMeetings EdgeDivider::meetings_of(const TopoDS_Edge& edge) {
  EdgeMeetings met(edge);
  if (limit_.is_reached()) met.stop();
  meet_faces(edge, met);
  meet_edges(edge, met);
  if (!met.open) meet_vertices(met);
  met.tell_reach(tolerance_);
  return met;
}

DividedEdge EdgeDivider::divide(const TopoDS_Edge& edge) {
  const EdgeMeetings met = meetings_of(edge);
  DividedEdge divided{met.status, {}, {}, met.reasons};
  if (met.open) {
    divided.obstacle = "it is not known where an edge meets the other shape";
    return divided;
  }
  const std::vector<EdgeStop> stops = distinct_stops(met.stops, met.of);
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const Interval range{stops[i].parameter, stops[i + 1].parameter};
    const std::optional<WireSide> side = side_of(met, range);
    if (!side) divided.obstacle = "no ray tells on which side of a solid a piece of an edge lies";
    add_piece({range, side.value_or(WireSide::Outside)}, stops[i].sure, divided.pieces);
  }
  return divided;
}

MetEdge EdgeDivider::meet(const TopoDS_Edge& edge) {
  const EdgeMeetings met = meetings_of(edge);
  MetEdge made{met.status, {}, {}, met.reasons};
  const std::vector<EdgeStop> stops = distinct_stops(met.stops, met.of);
  bool lies = false;  // whether the piece before a stop does
  for (std::size_t i = 0; i < stops.size(); ++i) {
    TopoDS_Shape on;
    if (i + 1 < stops.size()) on = below(met, {stops[i].parameter, stops[i + 1].parameter});
    const bool parts = lies || !on.IsNull();
    if (!parts && !stops[i].on.IsNull()) made.points.push_back({stops[i].parameter, stops[i].on});
    if (!on.IsNull()) {
      if (lies && made.stretches.back().on.IsSame(on))
        made.stretches.back().range.to = stops[i + 1].parameter;
      else
        made.stretches.push_back({{stops[i].parameter, stops[i + 1].parameter}, on});
    }
    lies = !on.IsNull();
  }
  return made;
}

std::optional<WireSide> EdgeDivider::side_of(const TopoDS_Vertex& vertex) {
  const gp_Pnt point = BRep_Tool::Pnt(vertex);
  const double own = BRep_Tool::Tolerance(vertex);
  const Bnd_Box own_box = bounds_of(vertex);
  for (const TopoDS_Vertex& other : shape_->vertices)
    if (BRep_Tool::Pnt(other).Distance(point) <=
        reach_of(tolerance_, own, BRep_Tool::Tolerance(other)))
      return WireSide::On;
  for (const auto& [edge, box] : shape_->edges) {
    const double reach = reach_of(tolerance_, own, BRep_Tool::Tolerance(edge));
    if (!box.IsOut(enlarged(own_box, reach)) && foot_on(curve_of(edge), point).distance <= reach)
      return WireSide::On;
  }
  for (std::size_t i = 0; i < shape_->faces.size(); ++i) {
    const auto& [face, box] = shape_->faces[i];
    const double reach = reach_of(tolerance_, own, BRep_Tool::Tolerance(face));
    if (!box.IsOut(enlarged(own_box, reach)) && lies_on(i, vec(point), reach)) return WireSide::On;
  }
  return side_in_solids(vec(point));
}

}  // namespace blossom::occt
