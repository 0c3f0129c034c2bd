// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/bodies.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/faces/face_groups.h"
#include "adapters/occt/faces/point_inside.h"
#include "adapters/occt/queries/edge_sides.h"
#include "adapters/occt/queries/solid_rays.h"
#include "adapters/occt/solids/solid_divisions.h"
#include "adapters/occt/splitting/trim_sides.h"
#include "adapters/occt/trim.h"

namespace blossom::occt {
namespace {

std::vector<TopoDS_Shape> parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return {map.cbegin(), map.cend()};
}

std::vector<TopoDS_Shape> free_parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind,
                                        TopAbs_ShapeEnum but_of) {
  TopTools_IndexedMapOfShape map;
  for (TopExp_Explorer it(shape, kind, but_of); it.More(); it.Next()) map.Add(it.Current());
  return {map.cbegin(), map.cend()};
}

Body body_of(const TopoDS_Shape& shape, int solid) {
  return {shape, solid, static_cast<int>(parts_of(shape, TopAbs_FACE).size())};
}

// A point of a part; of a face or edge not at its ends. None if there is none.
std::optional<gp_Pnt> point_of(const TopoDS_Shape& part) {
  if (part.ShapeType() == TopAbs_FACE) return point_inside(TopoDS::Face(part));
  if (part.ShapeType() == TopAbs_VERTEX) return BRep_Tool::Pnt(TopoDS::Vertex(part));
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(part), first, last);
  if (curve.IsNull()) return std::nullopt;
  return curve->Value((first + last) / 2);
}

using Parts = std::vector<TopoDS_Shape>;

// A body with what is asked about it.
class AskedBody {
 public:
  explicit AskedBody(const TopoDS_Shape& shape) : shape_(shape), box_(bounds_of(shape)) {}

  const Bnd_Box& box() const { return box_; }

  const MeasuredShape& boundary() {
    if (!boundary_) boundary_.emplace(shape_);
    return *boundary_;
  }

  /// Faces that hang together, and what belongs to no face one by one.
  const std::vector<Parts>& connected() {
    if (!connected_.empty()) return connected_;
    const Parts faces = parts_of(shape_, TopAbs_FACE);
    for (const FaceGroup& group : groups_over_edges(faces, [](const auto&) { return false; })) {
      connected_.emplace_back();
      for (const std::size_t face : group) connected_.back().push_back(faces[face]);
    }
    for (const TopoDS_Shape& edge : free_parts_of(shape_, TopAbs_EDGE, TopAbs_FACE))
      connected_.push_back({edge});
    for (const TopoDS_Shape& vertex : free_parts_of(shape_, TopAbs_VERTEX, TopAbs_EDGE))
      connected_.push_back({vertex});
    return connected_;
  }

  /// Of a solid; nothing if the point is within tolerance of the boundary, or no ray tells.
  std::optional<bool> clearly_holds(const gp_Pnt& point, double tolerance) {
    Bnd_Box around = box_;
    around.Enlarge(tolerance);
    if (around.IsOut(point)) return false;
    const Vec3 at{point.X(), point.Y(), point.Z()};
    if (nearest_point(boundary(), at, {.enough = tolerance}).lower <= tolerance)
      return std::nullopt;
    return holds(point, tolerance);
  }

  /// The same of a point that is known not to be on the boundary.
  std::optional<bool> holds(const gp_Pnt& point, double tolerance) {
    if (box_.IsOut(point)) return false;
    if (!rays_) rays_.emplace(boundary().faces(), tolerance);
    return rays_->is_inside({point.X(), point.Y(), point.Z()});
  }

 private:
  TopoDS_Shape shape_;
  Bnd_Box box_;
  std::optional<MeasuredShape> boundary_;
  std::vector<Parts> connected_;
  std::optional<SolidRays> rays_;
};

}  // namespace

std::vector<Body> bodies_of(const TopoDS_Shape& shape) {
  std::vector<Body> bodies;
  TopTools_IndexedMapOfShape bounding;
  int number = 0;
  for (const TopoDS_Shape& solid : parts_of(shape, TopAbs_SOLID)) {
    ++number;
    if (!is_closed_solid(solid)) continue;
    bodies.push_back(body_of(solid, number));
    TopExp::MapShapes(solid, TopAbs_FACE, bounding);
  }
  std::vector<TopoDS_Shape> rest;
  for (const TopoDS_Shape& face : parts_of(shape, TopAbs_FACE))
    if (!bounding.Contains(face)) rest.push_back(face);
  for (const TopoDS_Shape& edge : free_parts_of(shape, TopAbs_EDGE, TopAbs_FACE))
    rest.push_back(edge);
  for (const TopoDS_Shape& vertex : free_parts_of(shape, TopAbs_VERTEX, TopAbs_EDGE))
    rest.push_back(vertex);
  if (!rest.empty()) bodies.push_back(body_of(compound_of(rest), 0));
  return bodies;
}

struct Bodies::Impl {
  Impl(const TopoDS_Shape& shape, MeasuredShape measured)
      : bodies(bodies_of(shape)), boundary(std::move(measured)) {
    for (const Body& body : bodies) asked.emplace_back(body.shape);
  }

  const MeasuredShape& boundary_of(std::size_t i) {
    return bodies.size() == 1 ? boundary : asked[i].boundary();
  }

  std::vector<Body> bodies;
  MeasuredShape boundary;
  std::vector<AskedBody> asked;  // one for each body
};

Bodies::Bodies(const TopoDS_Shape& shape)
    : impl_(guarded("taking a shape apart", [&] {
        if (shape.IsNull()) throw BadModel("there is no shape to measure");
        return std::make_unique<Impl>(shape, MeasuredShape(shape));
      })) {}
Bodies::Bodies(const TopoDS_Shape& shape, MeasuredShape boundary)
    : impl_(guarded("taking a shape apart",
                    [&] { return std::make_unique<Impl>(shape, std::move(boundary)); })) {}
Bodies::~Bodies() = default;
Bodies::Bodies(Bodies&&) noexcept = default;
Bodies& Bodies::operator=(Bodies&&) noexcept = default;

const std::vector<Body>& Bodies::all() const { return impl_->bodies; }
const MeasuredShape& Bodies::boundary() const { return impl_->boundary; }

namespace {

// Where a body's boundary runs, with respect to another body.
struct Sides {
  bool inside = false, outside = false;
  bool same = false, opposite = false;  // along the other's boundary, as its own or turned round
  bool open = false;                    // somewhere it is not known
};

void count_sides(std::optional<bool> inside, Sides& sides) {
  if (!inside)
    sides.open = true;
  else
    (*inside ? sides.inside : sides.outside) = true;
}

void count_sides(const std::vector<SolidPiece>& pieces, Sides& sides) {
  for (const SolidPiece& piece : pieces) switch (piece.side) {
      case SolidSide::Inside: sides.inside = true; break;
      case SolidSide::Outside: sides.outside = true; break;
      case SolidSide::Same: sides.same = true; break;
      case SolidSide::Opposite: sides.opposite = true; break;
      case SolidSide::Unknown: sides.open = true; break;
    }
}

// A side of a pair, with what its boundary says.
struct Told {
  bool is_solid = false;
  Sides sides;
};

// What boundaries tell: beside one that runs inside of a solid, that solid has points outside of
// the body, and where both run the same way they have an inside in common.
Relation relation_by(const Told& a, const Told& b, Relation without_common_points) {
  const bool same_inside = a.sides.same && b.sides.same;
  if (!a.sides.inside && !b.sides.inside && !same_inside) return without_common_points;
  const auto reaches_beyond = [](const Told& one, const Told& other) {
    return one.sides.outside || one.sides.opposite || other.sides.inside ||
           (one.is_solid && !other.is_solid);
  };
  const bool a_beyond = reaches_beyond(a, b), b_beyond = reaches_beyond(b, a);
  if (a_beyond && b_beyond) return Relation::Crossing;
  if (a_beyond) return Relation::BInsideA;
  return b_beyond ? Relation::AInsideB : Relation::Equal;
}

// Of boundaries that are apart: one point of each piece tells.
Sides sides_apart(AskedBody& of, AskedBody& solid, double tolerance) {
  Sides sides;
  for (const Parts& piece : of.connected()) {
    std::optional<bool> inside;
    for (std::size_t i = 0; i < piece.size() && !inside; ++i)
      if (const std::optional<gp_Pnt> point = point_of(piece[i]))
        inside = solid.holds(*point, tolerance);
    count_sides(inside, sides);
  }
  return sides;
}

// Of boundaries that meet: what the points of parts tell for sure.
Sides sides_of_points(AskedBody& of, AskedBody& solid, double tolerance) {
  Sides sides;
  for (const Parts& piece : of.connected())
    for (const TopoDS_Shape& part : piece)
      if (const std::optional<gp_Pnt> point = point_of(part))
        if (const auto inside = solid.clearly_holds(*point, tolerance)) count_sides(inside, sides);
  return sides;
}

bool is_inside(Relation relation) {
  return relation == Relation::AInsideB || relation == Relation::BInsideA;
}

}  // namespace

/// The relation of two models on its way.
class BodyRelations {
 public:
  BodyRelations(Bodies& a, Bodies& b, double tolerance, const DistanceOptions& options)
      : a_(*a.impl_), b_(*b.impl_), tolerance_(tolerance), options_(options), limit_(job_) {
    job_.tolerances.point = tolerance;
    job_.time_limit = options.time_limit;
    job_.cancelled = options.cancelled;
  }

  ModelRelation found(const ShapeMeeting& boundaries) {
    ModelRelation result;
    for (std::size_t i = 0; i < a_.bodies.size(); ++i)
      for (std::size_t j = 0; j < b_.bodies.size(); ++j) {
        if (boxes_are_apart(i, j)) continue;
        const BodyPair pair = related(i, j, boundaries);
        if (pair.relation != Relation::Disjoint) result.pairs.push_back(pair);
        result.status = weaker(result.status, pair.status);
      }
    result.relation = of_all(result.pairs);
    return result;
  }

 private:
  bool boxes_are_apart(std::size_t i, std::size_t j) const {
    Bnd_Box around = a_.asked[i].box();
    around.Enlarge(tolerance_);
    return around.IsOut(b_.asked[j].box());
  }

  BodyPair related(std::size_t i, std::size_t j, const ShapeMeeting& boundaries) {
    const Body &body_a = a_.bodies[i], &body_b = b_.bodies[j];
    if (body_a.is_solid() && body_a.shape.IsEqual(body_b.shape))  // as a part that is there twice
      return {i, j, Relation::Equal, Status::Complete};
    const bool alone = a_.bodies.size() == 1 && b_.bodies.size() == 1;
    if (limit_.is_reached()) return {i, j, Relation::Unknown, Status::Stopped};
    const ShapeMeeting met =
        boundaries.answer == Meeting::No || alone ? boundaries : meeting_of(i, j);
    if (met.answer == Meeting::Unknown) return {i, j, Relation::Unknown, Status::Stopped};
    if (met.answer == Meeting::No) return apart(i, j);
    const bool surfaces = !a_.bodies[i].is_solid() && !b_.bodies[j].is_solid();
    if (met.answer == Meeting::Yes && (met.through || surfaces))
      return {i, j, Relation::Crossing, Status::Complete};
    return in_contact(i, j);
  }

  ShapeMeeting meeting_of(std::size_t i, std::size_t j) {
    DistanceOptions left = options_;
    left.time_limit = limit_.remaining().time_limit;
    return meeting(a_.boundary_of(i), b_.boundary_of(j), tolerance_, left);
  }

  Told told(const Bodies::Impl& of, std::size_t i) const { return {of.bodies[i].is_solid(), {}}; }

  template <class Look>
  std::pair<Told, Told> told_by(std::size_t i, std::size_t j, Look look) {
    Told a = told(a_, i), b = told(b_, j);
    if (b.is_solid) a.sides = look(a_.asked[i], b_.asked[j], tolerance_);
    if (a.is_solid) b.sides = look(b_.asked[j], a_.asked[i], tolerance_);
    return {a, b};
  }

  BodyPair apart(std::size_t i, std::size_t j) {
    const auto [a, b] = told_by(i, j, sides_apart);
    const Relation relation = relation_by(a, b, Relation::Disjoint);
    if ((a.sides.open || b.sides.open) && relation != Relation::Crossing)
      return {i, j, Relation::Unknown, Status::Tolerance};
    return {i, j, relation, Status::Complete};
  }

  // Points can show that bodies cross, and not that they do not: pieces can.
  BodyPair in_contact(std::size_t i, std::size_t j) {
    auto [a, b] = told_by(i, j, sides_of_points);
    const Relation by_points = relation_by(a, b, Relation::Touching);
    if (by_points == Relation::Crossing) return {i, j, by_points, Status::Complete};
    if (!a.is_solid && !b.is_solid) return {i, j, Relation::Touching, Status::Tolerance};
    BodyPair pair{i, j, by_points, Status::Tolerance};
    if (const std::optional<Status> split = split_along(pair, a.sides, b.sides)) {
      pair.relation = relation_by(a, b, Relation::Touching);
      pair.status = *split;
    }
    return pair;
  }

  // Nothing of what cannot be split.
  std::optional<Status> split_along(BodyPair& pair, Sides& a, Sides& b) try {
    return guarded("splitting bodies in contact", [&]() -> std::optional<Status> {
      const Body &body_a = a_.bodies[pair.a], &body_b = b_.bodies[pair.b];
      if (!body_a.is_solid()) return add_pieces(body_a, body_b, b_.asked[pair.b], a);
      if (!body_b.is_solid()) return add_pieces(body_b, body_a, a_.asked[pair.a], b);
      const TrimTool solid_a = trim_tool(body_a.shape), solid_b = trim_tool(body_b.shape);
      const IntersectionOptions left = limit_.remaining();
      SolidDivisions divisions(solid_a, solid_b, 0, left);
      while (const auto pieces = divisions.next()) {
        if (!pieces->obstacles.empty()) continue;
        count_sides(pieces->a, a);
        count_sides(pieces->b, b);
        const ShapeIntersection& faces = *divisions.first_look();
        if (faces.tolerance == tolerance_)
          pair.faces = std::make_shared<FacesMet>(solid_a.faces, solid_b.faces, faces);
        return pieces->status;
      }
      return std::nullopt;
    });
  } catch (const Failure&) {
    return std::nullopt;
  } catch (const BadModel&) {
    return std::nullopt;
  }

  // Of faces and loose edges. Nothing of vertices alone, which have no pieces.
  std::optional<Status> add_pieces(const Body& surface, const Body& solid, AskedBody& asked,
                                   Sides& sides) const {
    const Parts edges = free_parts_of(surface.shape, TopAbs_EDGE, TopAbs_FACE);
    const Parts faces = parts_of(surface.shape, TopAbs_FACE);
    if (edges.empty() && faces.empty()) return std::nullopt;
    const Status of_faces = faces.empty() ? Status::Complete : add_trimmed(surface, solid, sides);
    return weaker(of_faces, add_edges(edges, solid, asked, sides));
  }

  Status add_edges(const Parts& edges, const Body& solid, AskedBody& asked, Sides& sides) const {
    std::vector<TopoDS_Face> faces;
    for (const TopoDS_Shape& face : parts_of(solid.shape, TopAbs_FACE))
      faces.push_back(TopoDS::Face(face));
    Status status = Status::Complete;
    for (const TopoDS_Shape& edge : edges) {
      const EdgeStretches stretches =
          stretches_beside(TopoDS::Edge(edge), faces, limit_.remaining());
      status = weaker(status, stretches.status);
      for (const gp_Pnt& middle : stretches.middles)
        if (const auto inside = asked.clearly_holds(middle, tolerance_)) count_sides(inside, sides);
    }
    return status;
  }

  Status add_trimmed(const Body& surface, const Body& solid, Sides& sides) const {
    std::vector<PartFace> faces;
    for (const TopoDS_Shape& face : parts_of(surface.shape, TopAbs_FACE))
      faces.push_back({static_cast<int>(faces.size()) + 1, TopoDS::Face(face)});
    TrimOptions options;
    options.intersection = limit_.remaining();
    const TrimResult made = trim(faces, {trim_tool(solid.shape)}, options);
    for (const TrimPiece& piece : made.pieces) switch (piece.side) {
        case PieceSide::Inside: sides.inside = true; break;
        case PieceSide::Outside: sides.outside = true; break;
        case PieceSide::On: sides.same = true; break;
        default: sides.open = true; break;
      }
    return sides.open ? weaker(made.status, Status::Tolerance) : made.status;
  }

  Relation of_all(const std::vector<BodyPair>& pairs) const {
    const auto any = [&](const auto& is) {
      return std::ranges::any_of(pairs, [&](const BodyPair& pair) { return is(pair.relation); });
    };
    if (!any(has_common_points)) {
      if (any([](Relation each) { return each == Relation::Unknown; })) return Relation::Unknown;
      return pairs.empty() ? Relation::Disjoint : Relation::Touching;
    }
    const bool a_inside = all_held(pairs, &BodyPair::a, a_.bodies.size(), Relation::AInsideB);
    const bool b_inside = all_held(pairs, &BodyPair::b, b_.bodies.size(), Relation::BInsideA);
    if (a_inside && b_inside) return Relation::Equal;
    if (a_inside) return Relation::AInsideB;
    return b_inside ? Relation::BInsideA : Relation::Crossing;
  }

  static bool all_held(const std::vector<BodyPair>& pairs, std::size_t BodyPair::*side,
                       std::size_t count, Relation inside) {
    std::vector<bool> held(count, false);
    for (const BodyPair& pair : pairs)
      if (pair.relation == inside || pair.relation == Relation::Equal) held[pair.*side] = true;
    return std::ranges::all_of(held, [](bool each) { return each; });
  }

  Bodies::Impl& a_;
  Bodies::Impl& b_;
  double tolerance_;
  const DistanceOptions& options_;
  IntersectionOptions job_;
  SharedLimit limit_;
};

const char* to_string(Relation relation) {
  switch (relation) {
    case Relation::Disjoint: return "disjoint";
    case Relation::Touching: return "touching";
    case Relation::Crossing: return "crossing";
    case Relation::AInsideB: return "a inside b";
    case Relation::BInsideA: return "b inside a";
    case Relation::Equal: return "equal";
    case Relation::Unknown: break;
  }
  return "unknown";
}

bool has_common_points(Relation relation) {
  return is_inside(relation) || relation == Relation::Crossing || relation == Relation::Equal;
}

ModelRelation relation_of(Bodies& a, Bodies& b, const ShapeMeeting& boundaries, double tolerance,
                          const DistanceOptions& options) {
  return guarded("telling inside from outside",
                 [&] { return BodyRelations(a, b, tolerance, options).found(boundaries); });
}

/// A point's places on their way.
class BodyPlaces {
 public:
  BodyPlaces(Bodies& bodies, const Vec3& point, double tolerance, const DistanceOptions& options)
      : bodies_(*bodies.impl_), point_(point), tolerance_(tolerance), options_(options) {
    options_.enough = tolerance;
  }

  std::vector<PointPlace> found(const ShapeDistance& nearest) {
    std::vector<PointPlace> places;
    for (std::size_t i = 0; i < bodies_.bodies.size(); ++i)
      if (bodies_.bodies[i].is_solid()) places.push_back(place(i, nearest.lower > tolerance_));
    return places;
  }

 private:
  PointPlace place(std::size_t i, bool apart) {
    const gp_Pnt at(point_[0], point_[1], point_[2]);
    Bnd_Box box = bodies_.asked[i].box();
    box.Enlarge(tolerance_);
    if (box.IsOut(at)) return PointPlace::Outside;
    if (!apart) {
      const ShapeDistance nearest = nearest_point(bodies_.boundary_of(i), point_, options_);
      if (nearest.upper <= tolerance_) return PointPlace::OnBoundary;
      if (nearest.lower <= tolerance_) return PointPlace::Unknown;
    }
    const std::optional<bool> inside = bodies_.asked[i].holds(at, tolerance_);
    if (!inside) return PointPlace::Unknown;
    return *inside ? PointPlace::Inside : PointPlace::Outside;
  }

  Bodies::Impl& bodies_;
  Vec3 point_;
  double tolerance_;
  DistanceOptions options_;
};

const char* to_string(PointPlace place) {
  switch (place) {
    case PointPlace::Outside: return "outside";
    case PointPlace::Inside: return "inside";
    case PointPlace::OnBoundary: return "on the boundary";
    case PointPlace::Unknown: break;
  }
  return "unknown";
}

std::vector<PointPlace> places_of(Bodies& bodies, const Vec3& point, const ShapeDistance& nearest,
                                  double tolerance, const DistanceOptions& options) {
  return guarded("telling inside from outside",
                 [&] { return BodyPlaces(bodies, point, tolerance, options).found(nearest); });
}

}  // namespace blossom::occt
