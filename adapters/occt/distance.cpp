// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/distance.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/edge_tolerance.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/placed_shapes.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/convert/kept_forms.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/intersection.h"
#include "core/base/errors.h"
#include "core/topology/border_curves.h"
#include "core/topology/chart_region.h"

namespace blossom::occt {
namespace {

// A crossing is looked for where faces are within this many tolerances of a point.
constexpr double kNearCrossing = 4;

// The trims of a face, made when a question comes near it; and when there are many, a grid of what
// is inside.
class MeasuredFace {
 public:
  const FaceTrims& trims(const std::function<TopoDS_Face()>& face) {
    std::call_once(once_, [&] { trims_ = std::make_unique<FaceTrims>(face_trims(face())); });
    return *trims_;
  }

  TrimSide side(const std::function<TopoDS_Face()>& face, const Vec2& low, const Vec2& high) {
    trims(face);
    if (asked_.fetch_add(1) < kFewQuestions)
      switch (part_side(*trims_, {low[0], high[0]}, {low[1], high[1]})) {
        case PartSide::Inside: return TrimSide::Inside;
        case PartSide::Outside: return TrimSide::Outside;
        case PartSide::Mixed: return TrimSide::Mixed;
      }
    std::call_once(region_once_, [&] { region_ = std::make_unique<ChartRegion>(*trims_); });
    PlanarBox box;
    for (int k = 0; k < 2; ++k) {
      box.low[k] = low[k] * trims_->scale[k];
      box.high[k] = high[k] * trims_->scale[k];
    }
    switch (region_->place(*trims_, box)) {
      case ChartRegion::Place::Inside: return TrimSide::Inside;
      case ChartRegion::Place::Outside: return TrimSide::Outside;
      case ChartRegion::Place::Near: break;
    }
    return TrimSide::Mixed;
  }

 private:
  static constexpr int kFewQuestions = 16;  // the grid costs about as much

  std::once_flag once_, region_once_;
  std::unique_ptr<FaceTrims> trims_;
  std::unique_ptr<ChartRegion> region_;
  std::atomic<int> asked_ = 0;
};

// Points in whose box a face's edges are, where it is placed; none if they are not known.
std::vector<Vec3> points_of_edges(const TopoDS_Face& face, const gp_Trsf& place) {
  std::vector<Vec3> hull;
  for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next()) {
    const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(it.Current()));
    hull.push_back({p.X(), p.Y(), p.Z()});
  }
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge)) continue;  // a vertex
    std::vector<Vec3> own;
    if (!add_hull(edge, own)) return {};
    own = placed_hull(std::move(own), edge.Location().Transformation()).points;
    hull.insert(hull.end(), own.begin(), own.end());
  }
  if (!has_end(hull)) return {};
  const HullBound placed = placed_hull(std::move(hull), place);
  Box box;
  for (const Vec3& p : placed.points) box = joined(box, {p, p});
  const Vec3 margin{placed.margin, placed.margin, placed.margin};
  return {box.low - margin, box.high + margin};
}

// Which spans of an edge its curves are.
struct EdgeSpan {
  Interval place;
  ParameterLaw law = ParameterLaw::Linear;
};

// An edge; its spans are there once it is converted.
struct MeasuredEdge {
  int number = 0;  // among all edges
  std::vector<EdgeSpan> spans{};
};

}  // namespace

// Parts of the set are the faces, then the edges.
struct MeasuredShape::Impl {
  Impl(const TopoDS_Shape& shape, KeptForms* forms)
      : whole(shape),
        shapes(shape),
        faces(shapes.faces().size()),
        converted(shapes.faces().size()) {
    OperandParts parts = with_hulls(forms);
    parts.make = [this](int part) { return make(part); };
    parts.trims = [this](int face, const Vec2& low, const Vec2& high) {
      return guarded("following the trims of a face", [&] { return side(face, low, high); });
    };
    parts.borders = [this](int part) { return border_of(part); };
    prepared.emplace(std::move(parts));
  }

  Impl(const TopoDS_Shape& place, std::shared_ptr<Impl> prototype)
      : whole(place),
        shapes(place),
        faces(shapes.faces().size()),
        converted(shapes.faces().size()),
        original(std::move(prototype)),
        move(place.Location().Transformation() *
             original->whole.Location().Transformation().Inverted()),
        error(original->error) {
    OperandParts parts = with_hulls(nullptr);
    converted.clear();  // what was made for hulls is the original's to keep
    parts.make = [this](int part) { return moved(original->prepared->part(part)); };
    parts.trims = original->prepared->set().trims;
    prepared.emplace(std::move(parts));
  }

  OperandParts with_hulls(KeptForms* forms) {
    OperandParts parts;
    for (const PlacedShape& vertex : shapes.vertices()) {
      gp_XYZ p = BRep_Tool::Pnt(TopoDS::Vertex(vertex.shape)).XYZ();
      shapes.place_of(vertex).Transforms(p);
      parts.points.push_back({p.X(), p.Y(), p.Z()});
    }
    for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
      parts.hulls.push_back(face_hull(i, forms));
      const PlacedShape& face = shapes.faces()[static_cast<std::size_t>(i)];
      parts.hulls.back().border_gap = largest_edge_tolerance(face.shape);
      parts.hulls.back().border_points =
          points_of_edges(TopoDS::Face(face.shape), shapes.place_of(face));
    }
    for (int i = 0; i < static_cast<int>(shapes.edges().size()); ++i)
      // A degenerated one is a point: its vertex is there.
      if (!BRep_Tool::Degenerated(TopoDS::Edge(shapes.edges()[static_cast<std::size_t>(i)].shape)))
        edges.push_back({i});
    for (const MeasuredEdge& edge : edges) parts.hulls.push_back(edge_hull(edge));
    if (parts.points.empty() && parts.hulls.empty())
      throw BadModel("there is nothing in the shape to measure");
    return parts;
  }

  // A copy of the original's at this place.
  DistanceOperand moved(DistanceOperand set) const {
    for (Vec3& p : set.points) p = moved(p);
    for (RationalBezierCurve& curve : set.curves)
      for (Vec4& p : curve.points) p = moved(p);
    for (BezierSurface& surface : set.surfaces)
      for (RationalBezierPatch& patch : surface.patches.values())
        for (Vec4& p : patch.points.values()) p = moved(p);
    return set;
  }
  Vec3 moved(const Vec3& p) const {
    gp_XYZ xyz(p[0], p[1], p[2]);
    move.Transforms(xyz);
    return {xyz.X(), xyz.Y(), xyz.Z()};
  }
  Vec4 moved(const Vec4& p) const {
    const Vec3 at = moved(projected(p));
    return {at[0] * p[3], at[1] * p[3], at[2] * p[3], p[3]};
  }

  TopoDS_Face face(int i) const {
    return TopoDS::Face(shapes.placed(shapes.faces()[static_cast<std::size_t>(i)]));
  }
  TopoDS_Edge edge(const MeasuredEdge& of) const {
    return TopoDS::Edge(shapes.placed(shapes.edges()[static_cast<std::size_t>(of.number)]));
  }
  bool is_face(int part) const { return part < static_cast<int>(faces.size()); }
  MeasuredEdge& edge_of_part(int part) {
    return edges[static_cast<std::size_t>(part) - faces.size()];
  }

  // Of control points where they do. Other forms are converted at once, so that the error of what
  // is only approximated does not depend on the questions.
  HullBound face_hull(int i, KeptForms* forms) {
    const PlacedShape& part = shapes.faces()[static_cast<std::size_t>(i)];
    std::vector<Vec3> hull;
    if (add_hull(TopoDS::Face(part.shape), hull) && has_end(hull))
      return placed_hull(std::move(hull), shapes.place_of(part));
    BezierSurface& surface = converted[static_cast<std::size_t>(i)].emplace(
        forms != nullptr ? forms->take(face(i)) : bezier_surface(face(i), kFineForm));
    error = std::max(error, surface.error);
    hull.clear();
    for (const RationalBezierPatch& patch : surface.patches.values())
      for (const Vec4& p : patch.points.values()) hull.push_back(projected(p));
    return {std::move(hull), surface.error};
  }

  HullBound edge_hull(const MeasuredEdge& of) {
    const PlacedShape& part = shapes.edges()[static_cast<std::size_t>(of.number)];
    std::vector<Vec3> hull;
    if (add_hull(TopoDS::Edge(part.shape), hull) && has_end(hull))
      return placed_hull(std::move(hull), shapes.place_of(part));
    const CurveSpans found = bezier_spans(edge(of), kFineForm);
    error = std::max(error, found.error);
    hull.clear();
    for (const CurveSpan& span : found.spans)
      for (const Vec4& p : span.curve.points) hull.push_back(projected(p));
    return {std::move(hull), found.error};
  }

  // What was converted for its box is handed over; should that fail, it is converted again.
  DistanceOperand make(int part) {
    return guarded("converting a part to measure", [&] {
      DistanceOperand set;
      if (is_face(part)) {
        auto& known = converted[static_cast<std::size_t>(part)];
        set.surfaces.push_back(known ? std::move(*known) : bezier_surface(face(part), kFineForm));
        known.reset();
        return set;
      }
      MeasuredEdge& of = edge_of_part(part);
      std::vector<EdgeSpan> spans;
      for (CurveSpan& span : bezier_spans(edge(of), kFineForm).spans) {
        // Between spans the curve may have a kink, so ends of spans count as points.
        if (!spans.empty()) set.points.push_back(projected(span.curve.points.front()));
        set.curves.push_back(std::move(span.curve));
        spans.push_back({span.place, span.law});
      }
      of.spans = std::move(spans);
      return set;
    });
  }

  // The border of a face as its trims have it, which its edges may be far from.
  std::optional<BorderCurves> border_of(int part) {
    if (!is_face(part)) return std::nullopt;
    return guarded("following the border of a face", [&]() -> std::optional<BorderCurves> {
      const FaceTrims& trims =
          faces[static_cast<std::size_t>(part)].trims([&] { return face(part); });
      auto curves = border_curves(trims, prepared->part(part).surfaces.front());
      if (!curves) return std::nullopt;
      // Chart coordinates are lengths but for a factor of less than two.
      return BorderCurves{std::move(*curves), 2 * trims.largest_gap};
    });
  }

  TrimSide side(int i, const Vec2& low, const Vec2& high) {
    return faces[static_cast<std::size_t>(i)].side([&] { return face(i); }, low, high);
  }

  ShapePoint named(const DistanceEnd& end) {
    const auto index = static_cast<std::size_t>(end.index);
    if (end.part < 0 && index >= shapes.vertices().size()) return {{}, {}, end.point};  // not known
    if (end.part < 0) return {shapes.placed(shapes.vertices()[index]), {}, end.point};
    if (is_face(end.part)) return {face(end.part), end.uv, end.point};
    const MeasuredEdge& of = original ? original->edge_of_part(end.part) : edge_of_part(end.part);
    if (end.kind == DistanceEnd::Kind::Point)  // where a span ends and the next one begins
      return {edge(of), {of.spans[index].place.to, 0}, end.point};
    const EdgeSpan& span = of.spans[index];
    return {edge(of), {parameter_at(span.law, span.place, end.uv[0]), 0}, end.point};
  }

  TopoDS_Shape whole;
  PlacedShapes shapes;
  std::deque<MeasuredFace> faces;
  std::vector<std::optional<BezierSurface>> converted;  // faces whose form had to be made for a box
  std::vector<MeasuredEdge> edges;
  std::optional<PreparedSet> prepared;
  std::shared_ptr<Impl> original;  // of one that is somewhere else; null
  gp_Trsf move;                    // from there
  double error = 0;
};

MeasuredShape::MeasuredShape(const TopoDS_Shape& shape, KeptForms* forms)
    : impl_(guarded("preparing a shape to measure", [&] {
        if (shape.IsNull()) throw BadModel("there is no shape to measure");
        return std::make_shared<Impl>(shape, forms);
      })) {}
MeasuredShape::MeasuredShape(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
MeasuredShape MeasuredShape::moved_to(const TopoDS_Shape& place) const {
  const std::shared_ptr<Impl> original = impl_->original ? impl_->original : impl_;
  if (!original->whole.IsPartner(place))
    throw InvalidInput("moved_to: the place is not one of the measured shape");
  return MeasuredShape(guarded("preparing a shape to measure",
                               [&] { return std::make_shared<Impl>(place, original); }));
}
MeasuredShape::~MeasuredShape() = default;
MeasuredShape::MeasuredShape(MeasuredShape&&) noexcept = default;
MeasuredShape& MeasuredShape::operator=(MeasuredShape&&) noexcept = default;

const PreparedSet& MeasuredShape::set() const { return *impl_->prepared; }
double MeasuredShape::error() const { return impl_->error; }
int MeasuredShape::parts() const {
  return static_cast<int>(impl_->faces.size() + impl_->edges.size());
}

std::vector<TopoDS_Face> MeasuredShape::faces() const {
  std::vector<TopoDS_Face> all;
  for (int i = 0; i < static_cast<int>(impl_->faces.size()); ++i) all.push_back(impl_->face(i));
  return all;
}

ShapePoint MeasuredShape::named(const DistanceEnd& end) const { return impl_->named(end); }

namespace {

// Approximated forms are within `error` of what they stand for.
ShapeDistance of_result(const DistanceResult& found, double error) {
  ShapeDistance result;
  result.lower = std::max(0.0, found.lower - error);
  result.upper = found.upper + error;
  result.status = error > 0 ? weaker(found.status, Status::Tolerance) : found.status;
  result.pairs = found.pairs;
  return result;
}

// The places of the faces that a face, edge or vertex belongs to.
std::vector<int> faces_with(const TopoDS_Shape& part, const std::vector<TopoDS_Face>& all) {
  std::vector<int> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(all[i], parts);
    if (parts.Contains(part)) found.push_back(static_cast<int>(i));
  }
  return found;
}

// Whether the intersection of two faces is proven to hold a curve along which they cross.
bool has_proven_curve(const TopoDS_Face& a, const TopoDS_Face& b,
                      const IntersectionOptions& options) {
  for (const FaceIntersection& pair : intersect({a}, {b}, options).pairs)
    for (const IntersectionCurve& curve : pair.found.curves)
      if (pair.found.status == Status::Complete && !curve.tangential) return true;
  return false;
}

enum class Crossing { NotProven, InACurve, ThroughBoth };

// How faces that are within tolerance of each other in a point are proven to cross: near it, else
// anywhere.
Crossing crossing_of(const MeasuredShape& a, const MeasuredShape& b, const ShapeDistance& found,
                     double tolerance, const IntersectionOptions& options, Crossings wanted) {
  const std::vector<TopoDS_Face> faces_a = a.faces(), faces_b = b.faces();
  const std::vector<int> of_a = faces_with(found.a.on, faces_a);
  const std::vector<int> of_b = faces_with(found.b.on, faces_b);
  const auto any_pair = [&](const auto& test) {
    return std::ranges::any_of(
        of_a, [&](int i) { return std::ranges::any_of(of_b, [&](int j) { return test(i, j); }); });
  };
  const auto proven = [&](double room) {
    return any_pair([&](int i, int j) {
      return proven_to_cross(a.set(), i, b.set(), j, found.a.point, kNearCrossing * tolerance,
                             room);
    });
  };
  if (proven(tolerance)) return Crossing::ThroughBoth;
  if (wanted == Crossings::ThroughBoth) return Crossing::NotProven;
  if (proven(0)) return Crossing::InACurve;
  const SharedLimit limit(options);
  const bool in_a_curve = any_pair([&](int i, int j) {
    return !limit.is_reached() &&
           has_proven_curve(faces_a[static_cast<std::size_t>(i)],
                            faces_b[static_cast<std::size_t>(j)], limit.remaining());
  });
  return in_a_curve ? Crossing::InACurve : Crossing::NotProven;
}

IntersectionOptions limits_of(const DistanceOptions& options) {
  IntersectionOptions result;
  result.time_limit = options.time_limit;
  result.cancelled = options.cancelled;
  return result;
}

}  // namespace

ShapeDistance least_distance(const MeasuredShape& a, const MeasuredShape& b,
                             const DistanceOptions& options) {
  const DistanceResult found = blossom::least_distance(a.set(), b.set(), options);
  ShapeDistance result = of_result(found, a.error() + b.error());
  result.a = a.named(found.a);
  result.b = b.named(found.b);
  return result;
}

ShapeDistance nearest_point(const MeasuredShape& shape, const Vec3& point,
                            const DistanceOptions& options) {
  const DistanceResult found =
      blossom::least_distance(PreparedSet(measured(point)), shape.set(), options);
  ShapeDistance result = of_result(found, shape.error());
  result.a = {TopoDS_Shape(), {}, point};
  result.b = shape.named(found.b);
  return result;
}

std::vector<ShapeFoot> foot_points(const MeasuredShape& shape, const Vec3& point, double tolerance,
                                   const WorkLimit* limit) {
  std::vector<ShapeFoot> feet;
  for (int part = 0; part < shape.parts(); ++part) {
    DistanceOperand set = shape.set().part(part);
    const TrimFilter& trims = shape.set().set().trims;
    set.trims = [&](int, const Vec2& low, const Vec2& high) { return trims(part, low, high); };
    for (FootPoint& foot : blossom::foot_points(set, point, tolerance, limit)) {
      foot.at.part = part;
      if (shape.error() > 0) foot.status = weaker(foot.status, Status::Tolerance);
      const ShapePoint place = shape.named(foot.at);
      // Two spans of an edge find the foot where they meet.
      const bool known = std::any_of(feet.begin(), feet.end(), [&](const ShapeFoot& other) {
        return other.at.on.IsSame(place.on) &&
               distance(other.at.point, place.point) <= 2 * tolerance;
      });
      if (!known) feet.push_back({place, foot});
    }
  }
  std::stable_sort(feet.begin(), feet.end(), [](const ShapeFoot& a, const ShapeFoot& b) {
    return a.foot.distance < b.foot.distance;
  });
  return feet;
}

ShapeMeeting meeting(const MeasuredShape& a, const MeasuredShape& b, double tolerance,
                     const DistanceOptions& options) {
  if (!(tolerance > 0)) throw InvalidInput("meeting: the tolerance must be positive");
  const IntersectionOptions of_job = limits_of(options);
  const SharedLimit limit(of_job);
  DistanceOptions sided = options;
  sided.enough = 0;
  const ShapeDistance found = least_distance(a, b, sided);
  sided.time_limit = limit.remaining().time_limit;
  return meeting_at(found, a, b, tolerance, sided);
}

ShapeMeeting meeting_at(const ShapeDistance& found, const MeasuredShape& a, const MeasuredShape& b,
                        double tolerance, const DistanceOptions& options, Crossings crossings) {
  ShapeMeeting result;
  result.a = found.a;
  result.b = found.b;
  result.lower = found.lower;
  result.upper = found.upper;
  result.pairs = found.pairs;
  if (found.lower > 0) {
    result.answer = Meeting::No;
  } else if (found.upper <= tolerance) {
    const Crossing crossing = crossing_of(a, b, found, tolerance, limits_of(options), crossings);
    result.answer = crossing == Crossing::NotProven ? Meeting::Within : Meeting::Yes;
    result.through = crossing == Crossing::ThroughBoth;
  }
  return result;
}

}  // namespace blossom::occt
