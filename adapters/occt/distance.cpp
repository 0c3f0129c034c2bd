// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/chart_region.h"
#include "adapters/occt/curves.h"
#include "adapters/occt/errors.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/surfaces.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

struct EdgeSpan {
  TopoDS_Edge edge;
  Interval place;
  ParameterLaw law = ParameterLaw::Linear;
};

// A face; its trims are made when a question comes near it.
struct MeasuredFace {
  struct Trims {
    FaceTrims trims;
    ChartRegion region;

    explicit Trims(const TopoDS_Face& face) : trims(face_trims(face)), region(trims) {}
  };

  TopoDS_Face face;
  std::once_flag once{};
  std::unique_ptr<Trims> made{};

  explicit MeasuredFace(const TopoDS_Face& f) : face(f) {}

  const Trims& trims() {
    std::call_once(once, [&] { made = std::make_unique<Trims>(face); });
    return *made;
  }
};

}  // namespace

struct MeasuredShape::Impl {
  explicit Impl(const TopoDS_Shape& shape) {
    if (shape.IsNull()) throw BadModel("there is no shape to measure");
    map_parts(shape);
    for (int i = 1; i <= maps[0].Extent(); ++i) add_face(TopoDS::Face(maps[0](i)));
    for (int i = 1; i <= maps[1].Extent(); ++i) add_edge(TopoDS::Edge(maps[1](i)));
    for (int i = 1; i <= maps[2].Extent(); ++i) {
      const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(maps[2](i)));
      set.points.push_back({p.X(), p.Y(), p.Z()});
    }
    if (set.points.empty() && set.curves.empty() && set.surfaces.empty())
      throw BadModel("there is nothing in the shape to measure");
    set.trims = [this](int face, const Vec2& low, const Vec2& high) {
      return side(faces[static_cast<std::size_t>(face)], low, high);
    };
  }

  // As TopExp::MapShapes for faces, edges and vertices, but what several parts share is entered
  // once: placing parts takes most of the time.
  void map_parts(const TopoDS_Shape& shape) {
    const TopAbs_ShapeEnum kind = shape.ShapeType();
    TopTools_IndexedMapOfShape* const map = kind == TopAbs_FACE     ? &maps[0]
                                            : kind == TopAbs_EDGE   ? &maps[1]
                                            : kind == TopAbs_VERTEX ? &maps[2]
                                                                    : nullptr;
    if (map != nullptr) {
      const int known = map->Extent();
      if (map->Add(shape) <= known) return;
    }
    for (TopoDS_Iterator part(shape); part.More(); part.Next()) map_parts(part.Value());
  }

  void add_face(const TopoDS_Face& face) {
    faces.emplace_back(face);
    set.surfaces.push_back(bezier_surface(face));
    error = std::max(error, set.surfaces.back().error);
  }

  void add_edge(const TopoDS_Edge& edge) {
    if (BRep_Tool::Degenerated(edge)) return;  // a point: its vertex is there
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull()) throw BadModel("an edge has no curve in space");
    CurveSpans found = bezier_spans(curve, {first, last});
    error = std::max(error, found.error);
    for (CurveSpan& span : found.spans) {
      // Between spans the curve may have a kink, so ends of spans count as points.
      if (&span != &found.spans.front()) add_joint(edge, span);
      set.curves.push_back(std::move(span.curve));
      spans.push_back({edge, span.place, span.law});
    }
  }

  void add_joint(const TopoDS_Edge& edge, const CurveSpan& span) {
    const Vec4& p = span.curve.points.front();
    joints.push_back({edge, {span.place.from, 0}, Vec3{p[0], p[1], p[2]} * (1 / p[3])});
  }

  static TrimSide side(MeasuredFace& face, const Vec2& low, const Vec2& high) {
    const MeasuredFace::Trims& made = face.trims();
    PlanarBox box;
    for (int k = 0; k < 2; ++k) {
      box.low[k] = low[k] * made.trims.scale[k];
      box.high[k] = high[k] * made.trims.scale[k];
    }
    switch (made.region.place(made.trims, box)) {
      case ChartRegion::Place::Inside: return TrimSide::Inside;
      case ChartRegion::Place::Outside: return TrimSide::Outside;
      case ChartRegion::Place::Near: return TrimSide::Mixed;
    }
    return TrimSide::Mixed;
  }

  MeasuredSet set;  // till it is prepared
  std::optional<PreparedSet> prepared;
  TopTools_IndexedMapOfShape maps[3];  // faces, edges, vertices
  std::deque<MeasuredFace> faces;
  std::vector<EdgeSpan> spans;
  std::vector<ShapePoint> joints;  // where spans of an edge meet; points behind the vertices
  double error = 0;
};

MeasuredShape::MeasuredShape(const TopoDS_Shape& shape)
    : impl_(guarded("preparing a shape to measure", [&] {
        auto made = std::make_unique<Impl>(shape);
        for (const ShapePoint& joint : made->joints) made->set.points.push_back(joint.point);
        made->prepared.emplace(std::move(made->set));
        return made;
      })) {}
MeasuredShape::~MeasuredShape() = default;
MeasuredShape::MeasuredShape(MeasuredShape&&) noexcept = default;
MeasuredShape& MeasuredShape::operator=(MeasuredShape&&) noexcept = default;

const PreparedSet& MeasuredShape::set() const { return *impl_->prepared; }
double MeasuredShape::error() const { return impl_->error; }
std::vector<TopoDS_Face> MeasuredShape::faces() const {
  std::vector<TopoDS_Face> all;
  for (const MeasuredFace& face : impl_->faces) all.push_back(face.face);
  return all;
}

ShapePoint MeasuredShape::named(const DistanceEnd& end) const {
  const auto index = static_cast<std::size_t>(end.index);
  const int vertices = impl_->maps[2].Extent();
  switch (end.kind) {
    case DistanceEnd::Kind::Surface: return {impl_->faces[index].face, end.uv, end.point};
    case DistanceEnd::Kind::Curve: {
      const EdgeSpan& span = impl_->spans[index];
      return {span.edge, {parameter_at(span.law, span.place, end.uv[0]), 0}, end.point};
    }
    case DistanceEnd::Kind::Point: break;
  }
  if (end.index < vertices) return {impl_->maps[2](end.index + 1), {}, end.point};
  return impl_->joints[index - static_cast<std::size_t>(vertices)];
}

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

// The faces that a face, edge or vertex belongs to.
std::vector<TopoDS_Face> faces_with(const TopoDS_Shape& part, const std::vector<TopoDS_Face>& all) {
  std::vector<TopoDS_Face> found;
  for (const TopoDS_Face& face : all) {
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(face, parts);
    if (parts.Contains(part)) found.push_back(face);
  }
  return found;
}

// Whether the intersection of faces is proven to hold a curve along which they cross.
bool cross_proven(const std::vector<TopoDS_Face>& a, const std::vector<TopoDS_Face>& b) {
  if (a.empty() || b.empty()) return false;
  for (const FaceIntersection& pair : intersect(a, b).pairs)
    for (const IntersectionCurve& curve : pair.found.curves)
      if (pair.found.status == Status::Complete && !curve.tangential) return true;
  return false;
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

std::vector<ShapeFoot> foot_points(const MeasuredShape& shape, const Vec3& point,
                                   double tolerance) {
  std::vector<ShapeFoot> feet;
  for (FootPoint& foot : blossom::foot_points(shape.set().set(), point, tolerance)) {
    if (shape.error() > 0) foot.status = weaker(foot.status, Status::Tolerance);
    const ShapePoint place = shape.named(foot.at);
    // Two spans of an edge find the foot where they meet.
    const bool known = std::any_of(feet.begin(), feet.end(), [&](const ShapeFoot& other) {
      return other.at.on.IsSame(place.on) && distance(other.at.point, place.point) <= 2 * tolerance;
    });
    if (!known) feet.push_back({place, foot});
  }
  return feet;
}

ShapeMeeting meeting(const MeasuredShape& a, const MeasuredShape& b, double tolerance,
                     const DistanceOptions& options) {
  if (!(tolerance > 0)) throw InvalidInput("meeting: the tolerance must be positive");
  DistanceOptions sided = options;
  sided.enough = 0;
  const ShapeDistance found = least_distance(a, b, sided);
  ShapeMeeting result{Meeting::Unknown, found.a, found.b, found.lower, found.upper, found.pairs};
  if (found.lower > 0)
    result.answer = Meeting::No;
  else if (found.upper <= tolerance)
    result.answer =
        cross_proven(faces_with(found.a.on, a.faces()), faces_with(found.b.on, b.faces()))
            ? Meeting::Yes
            : Meeting::Within;
  return result;
}

}  // namespace blossom::occt
