// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Lin.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/strips/face_contacts.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "adapters/occt/faces/elementary_faces.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"

namespace blossom::occt {
namespace {

// How far a face may be from one that is the same all along the edge, model units: its points are
// off the swept one by no more than a tenth of what counts as one point.
constexpr double kSweepError = 1e-8;
// Strips go on past the edge by so many times the width of their wider side, which is enough for
// end faces at more than 7 degrees to the edge; where the charts of the faces do not go on so far,
// as beyond a pole, by a part of it.
constexpr double kBeyond = 8;
constexpr double kLessBeyond = 0.75;
constexpr double kMinBeyond = 0.1;
constexpr int kStarts = 32;       // directions in which the start of a closed strip is looked for
constexpr double kMinGap = 1e-2;  // of a turn, radians: what an open strip leaves free
constexpr double kOnAxis = 1e-9;  // of the radius: so near to the axis is on it

// The plane across the edge at its middle; the edge's direction is x cross y for a line. Round an
// axis y is the axis, x points away from it, and the origin lies on it.
struct Section {
  Vec3 origin, x, y;
  Vec2 flat(const Vec3& p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
  Vec2 flat_direction(const Vec3& d) const { return {dot(d, x), dot(d, y)}; }
};

// A face in the section: a line or a circle, and how far the centre is off it along the normal.
struct Profile {
  bool is_circle = false;
  Vec2 point;   // of the line; the circle's centre
  Vec2 normal;  // of the line, outwards
  double radius = 0;
  double turned = 1;  // the circle's outward normal points away from its centre, or to it

  Vec2 foot(const Vec2& centre) const {
    if (is_circle) return point + radius * unit(centre - point);
    return centre - dot(centre - point, normal) * normal;
  }
};

std::vector<Vec2> line_meets(const Vec2& point, const Vec2& normal, const Vec2& centre,
                             double radius) {
  const double height = dot(point - centre, normal);
  const double square = radius * radius - height * height;
  if (square < 0) return {};
  const Vec2 foot = centre + height * normal, along{-normal[1], normal[0]};
  return {foot + std::sqrt(square) * along, foot - std::sqrt(square) * along};
}

// The common points of two profiles' parallels.
std::vector<Vec2> centres(Profile a, Profile b, double offset) {
  for (Profile* each : {&a, &b})
    if (each->is_circle)
      each->radius += each->turned * offset;
    else
      each->point += offset * each->normal;
  if ((a.is_circle && a.radius <= 0) || (b.is_circle && b.radius <= 0)) return {};
  if (!a.is_circle && !b.is_circle) {
    const double sine = a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0];
    if (std::abs(sine) < Precision::Angular()) return {};
    const double p = dot(a.point, a.normal), q = dot(b.point, b.normal);
    return {Vec2{p * b.normal[1] - q * a.normal[1], q * a.normal[0] - p * b.normal[0]} *
            (1 / sine)};
  }
  if (a.is_circle && b.is_circle) {
    const Vec2 between = b.point - a.point;
    const double d = norm(between);
    if (d == 0) return {};
    // The line through the common points of both circles.
    const double along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
    return line_meets(a.point + (along / d) * between, between * (1 / d), a.point, a.radius);
  }
  const Profile &line = a.is_circle ? b : a, &circle = a.is_circle ? a : b;
  return line_meets(line.point, line.normal, circle.point, circle.radius);
}

struct Side {
  BodyEdges::Corner corner;
  Profile profile;
};

// Of an edge on a line: nothing unless the face is the same all along.
std::optional<Profile> along_line(const Elementary& face, const Section& section, const Vec3& axis,
                                  double length, const BodyEdges::Corner& corner) {
  Profile made;
  made.normal = unit(section.flat_direction(corner.normal));
  made.point = section.flat(corner.point);
  const double sine = face.kind == ElementaryKind::Plane ? std::abs(dot(face.axis, axis))
                                                         : norm(cross(face.axis, axis));
  if (sine * length > kSweepError) return std::nullopt;
  if (face.kind == ElementaryKind::Plane) return made;
  if (face.kind != ElementaryKind::Cylinder) return std::nullopt;
  made.is_circle = true;
  made.point = section.flat(face.centre);
  made.radius = face.radius;
  return made;
}

// Of an edge on a circle.
std::optional<Profile> round_axis(const Elementary& face, const Section& section, double size,
                                  const BodyEdges::Corner& corner) {
  Profile made;
  made.normal = unit(section.flat_direction(corner.normal));
  made.point = section.flat(corner.point);
  const Vec3 off = face.centre - section.origin;
  const double aside = norm(off - dot(off, section.y) * section.y);
  const double sine = norm(cross(face.axis, section.y));
  const bool is_turned = sine * size <= kSweepError;
  switch (face.kind) {
    case ElementaryKind::Plane: return is_turned ? std::optional(made) : std::nullopt;
    case ElementaryKind::Cylinder:
    case ElementaryKind::Cone:
      return is_turned && aside <= kSweepError ? std::optional(made) : std::nullopt;
    case ElementaryKind::Sphere:
      if (aside > kSweepError) return std::nullopt;
      made.is_circle = true;
      made.point = {0, dot(off, section.y)};
      made.radius = face.radius;
      return made;
    case ElementaryKind::Torus:
      if (!is_turned || aside > kSweepError) return std::nullopt;
      made.is_circle = true;
      made.point = {face.radius, dot(off, section.y)};
      made.radius = face.minor;
      return made;
  }
  return std::nullopt;
}

struct Rolling {
  const BodyEdges& body;
  int edge;
  bool concave;
  double radius;
  Section section;
  std::array<int, 2> held;
  std::array<Side, 2> sides;

  [[noreturn]] void refuse(const std::string& cause) const {
    double first = 0, last = 0;
    BRep_Tool::Range(body.edge(edge), first, last);
    throw FilletRefused(
        {FilletFault::NoBall, edge, cause, 0.5 * (first + last), sides[0].corner.point, {}});
  }
  Vec2 centre() const;
};

// The one next to the edge whose contacts lie in the faces.
Vec2 Rolling::centre() const {
  const Vec2 edge_point = section.flat(sides[0].corner.point);
  const double offset = concave ? radius : -radius;
  std::optional<Vec2> best;
  for (const Vec2& each : centres(sides[0].profile, sides[1].profile, offset)) {
    bool beside = true;
    for (std::size_t k = 0; k < 2; ++k) {
      const Side& side = sides[k];
      beside = beside && dot(side.profile.foot(each) - edge_point,
                             section.flat_direction(side.corner.inwards)) > 0;
      // Of two balls that lean on an edge, one is on the other side of the faces.
      if (held[k] > 0)
        beside = beside &&
                 offset * dot(each - edge_point, section.flat_direction(side.corner.normal)) > 0;
    }
    if (beside && (!best || distance(each, edge_point) < distance(*best, edge_point))) best = each;
  }
  if (!best) refuse("no ball of that radius touches both faces beside the edge");
  return *best;
}

// An edge across the section: a point, whose parallel is a circle about it. Nothing unless it is
// the same all along.
std::optional<Profile> held_profile(const BodyEdges& body, int edge, bool concave,
                                    const Section& section, double size, const Vec3* line) {
  const BRepAdaptor_Curve curve(body.edge(edge));
  Profile made;
  made.is_circle = true;
  made.turned = concave ? 1 : -1;
  const Vec3 point = vec(curve.Value(curve.FirstParameter()).XYZ());
  if (line != nullptr) {
    if (curve.GetType() != GeomAbs_Line) return std::nullopt;
    if (norm(cross(vec(curve.Line().Direction().XYZ()), *line)) * size > kSweepError)
      return std::nullopt;
    made.point = section.flat(point);
    return made;
  }
  if (curve.GetType() != GeomAbs_Circle) return std::nullopt;
  const gp_Circ circle = curve.Circle();
  const Vec3 off = vec(circle.Location().XYZ()) - section.origin;
  const double height = dot(off, section.y);
  if (norm(off - height * section.y) > kSweepError ||
      norm(cross(vec(circle.Axis().Direction().XYZ()), section.y)) * size > kSweepError)
    return std::nullopt;
  made.point = {circle.Radius(), height};
  return made;
}

std::optional<Rolling> rolling(const BodyEdges& body, int edge, bool concave, double radius,
                               const Section& section, const std::array<int, 2>& held, double size,
                               const Vec3* line) {
  Rolling made{body, edge, concave, radius, section, held, {}};
  double first = 0, last = 0;
  BRep_Tool::Range(body.edge(edge), first, last);
  for (std::size_t k = 0; k < 2; ++k) {
    const EdgeUseInFace& use = body.use(edge, k == 0);
    Side& side = made.sides[k];
    side.corner = body.corner(use, 0.5 * (first + last));
    if (held[k] > 0) {
      const auto profile = held_profile(body, held[k], concave, section, size, line);
      if (!profile) return std::nullopt;
      side.profile = *profile;
      continue;
    }
    const auto face = elementary_of(BRep_Tool::Surface(body.face(use.face)));
    if (!face) return std::nullopt;
    const auto profile = line != nullptr ? along_line(*face, section, *line, size, side.corner)
                                         : round_axis(*face, section, size, side.corner);
    if (!profile) return std::nullopt;
    side.profile = *profile;
    if (profile->is_circle)
      side.profile.turned = dot(section.flat(side.corner.point) - profile->point,
                                section.flat_direction(side.corner.normal)) > 0
                                ? 1
                                : -1;
  }
  return made;
}

// Angles of both contacts about the centre, the short way from the first to the second, beginning
// in [0, 2 pi).
std::array<double, 2> angles(const std::array<Vec2, 2>& feet, const Vec2& centre) {
  std::array<double, 2> at{};
  for (std::size_t k = 0; k < 2; ++k)
    at[k] = std::atan2(feet[k][1] - centre[1], feet[k][0] - centre[0]);
  const double turn = std::remainder(at[1] - at[0], 2 * std::numbers::pi);
  if (at[0] < 0 && at[0] + turn < 0) at[0] += 2 * std::numbers::pi;
  return {at[0], at[0] + turn};
}

// The contact's curve in its face.
void add_contact(const Rolling& of, std::size_t k, Handle(Geom_Curve) curve, double w,
                 RolledStrip& strip) {
  const EdgeUseInFace& use = of.body.use(of.edge, k == 0);
  const TopoDS_Face& face = of.body.face(use.face);
  const SurfaceProjector feet(face, Precision::Confusion());
  const Interval domain = use.coedge->curve.domain();
  const Vec2 scale = of.body.trims(use.face).scale;
  const Vec2 near = point_at(use.coedge->curve, at(domain, 0.5));
  const ChartImage image =
      image_of(curve, strip.range, feet, Vec2{near[0] / scale[0], near[1] / scale[1]},
               Precision::Confusion());
  strip.contacts[k] = {use.face, std::move(curve), image.chart, w};
}

RolledStrip strip_of(const Rolling& of) {
  RolledStrip strip;
  strip.edge = of.edge;
  strip.concave = of.concave;
  strip.radius = of.radius;
  strip.outward = !of.concave;
  strip.held = of.held;
  return strip;
}

double width(const Rolling& of, const std::array<Vec2, 2>& feet) {
  const Vec2 edge_point = of.section.flat(of.sides[0].corner.point);
  return std::max(distance(feet[0], edge_point), distance(feet[1], edge_point));
}

RolledStrip along(const Rolling& of, const Vec3& axis, const Interval& edge_range) {
  const Vec2 centre = of.centre();
  const std::array<Vec2, 2> feet{of.sides[0].profile.foot(centre),
                                 of.sides[1].profile.foot(centre)};
  const auto in_space = [&](const Vec2& p) {
    return of.section.origin + p[0] * of.section.x + p[1] * of.section.y;
  };
  RolledStrip strip = strip_of(of);
  strip.along_u = false;
  const double beyond = kBeyond * width(of, feet);
  strip.edge_range = edge_range;
  strip.range = {edge_range.from - beyond, edge_range.to + beyond};
  // The seam is opposite to the strip.
  const Vec2 e0 = unit(feet[0] - centre), e1 = unit(feet[1] - centre);
  const Vec2 middle = norm(e0 + e1) > 0 ? unit(e0 + e1) : Vec2{-e0[1], e0[0]};
  const Vec3 x = -(middle[0] * of.section.x + middle[1] * of.section.y);
  const gp_Ax3 frame(pnt(in_space(centre)), dir(axis), dir(x));
  strip.surface = new Geom_CylindricalSurface(frame, of.radius);
  strip.spine = new Geom_Line(frame.Location(), dir(axis));
  const Vec3 y = cross(axis, x);
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3 out = in_space(feet[k]) - in_space(centre);
    double angle = std::atan2(dot(out, y), dot(out, x));
    if (angle < 0) angle += 2 * std::numbers::pi;
    add_contact(of, k, new Geom_Line(pnt(in_space(feet[k])), dir(axis)), angle, strip);
  }
  return strip;
}

// How near to the axis a ball turns on the spot, and leaves a sphere. Radii in files have few
// digits: a torus of less than what counts as one place would have a border of less than that.
double on_axis(double radius) {
  return std::max(kOnAxis * radius, kSamePlace * Precision::Confusion());
}

// axis   along y of the section
// beyond   how far an open strip goes on, in widths
RolledStrip round(const Rolling& of, const Interval& edge_range, bool closed, const Vec3& start,
                  double beyond) {
  Vec2 centre = of.centre();
  std::array<Vec2, 2> feet{of.sides[0].profile.foot(centre), of.sides[1].profile.foot(centre)};
  for (Vec2* each : {&centre, &feet[0], &feet[1]})
    if (std::abs((*each)[0]) <= on_axis(of.radius)) (*each)[0] = 0;
  if (centre[0] < 0 || feet[0][0] < 0 || feet[1][0] < 0)
    of.refuse("the ball is too large for the circle that it rolls along: it would reach its axis");
  const Section& in = of.section;
  RolledStrip strip = strip_of(of);
  strip.closed = closed;
  strip.edge_range = strip.range = edge_range;
  if (!closed) {
    const double size = in.flat(of.sides[0].corner.point)[0];
    const double room = 0.5 * (2 * std::numbers::pi - length(edge_range)) - kMinGap;
    const double more = std::clamp(beyond * width(of, feet) / size, 0.0, std::max(room, 0.0));
    strip.range = {edge_range.from - more, edge_range.to + more};
  }
  const auto frame_at_height = [&](double height) {
    return gp_Ax2(pnt(in.origin + height * in.y), dir(in.y), dir(start));
  };
  const std::array<double, 2> w = angles(feet, centre);
  const gp_Ax3 frame(frame_at_height(centre[1]));
  if (centre[0] == 0)
    strip.surface = new Geom_SphericalSurface(frame, of.radius);
  else
    strip.surface = new Geom_ToroidalSurface(frame, centre[0], of.radius);
  strip.spine = new Geom_Circle(frame_at_height(centre[1]), centre[0]);
  for (std::size_t k = 0; k < 2; ++k)
    add_contact(of, k, new Geom_Circle(frame_at_height(feet[k][1]), feet[k][0]), w[k], strip);
  return strip;
}

// A closed strip begins where the ball touches both faces, if it does so anywhere, so that no hole
// or notch lies across its beginning: at a direction from the axis, or as near after it as can be.
RolledStrip closed_round(const Rolling& of, const Vec3& first) {
  std::optional<RolledStrip> plain;
  for (int i = 0; i < kStarts; ++i) {
    const double angle = i * 2 * std::numbers::pi / kStarts;
    const Vec3 start = std::cos(angle) * first + std::sin(angle) * cross(of.section.y, first);
    RolledStrip strip = round(of, {0, 2 * std::numbers::pi}, true, start, 0);
    if (std::ranges::all_of(strip.contacts, [&](const RolledContact& contact) {
          return lies_inside(of.body, contact, 0);
        }))
      return strip;
    if (!plain) plain = std::move(strip);
  }
  return *plain;
}

std::optional<RolledStrip> along_line(const BodyEdges& body, int edge, bool concave, double radius,
                                      const std::array<int, 2>& held,
                                      const BRepAdaptor_Curve& curve) {
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  const Vec3 axis = vec(curve.Line().Direction().XYZ());
  const BodyEdges::Corner corner = body.corner(body.use(edge, true), 0.5 * (first + last));
  const Section section{corner.point, corner.inwards, cross(axis, corner.inwards)};
  const auto of = rolling(body, edge, concave, radius, section, held, last - first, &axis);
  if (!of) return std::nullopt;
  const double half = 0.5 * (last - first);
  return along(*of, axis, {-half, half});
}

std::optional<RolledStrip> round_axis(const BodyEdges& body, int edge, bool concave, double radius,
                                      const std::array<int, 2>& held,
                                      const BRepAdaptor_Curve& curve) {
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  const gp_Circ circle = curve.Circle();
  const Vec3 centre = vec(circle.Location().XYZ()), axis = vec(circle.Axis().Direction().XYZ());
  const bool closed = last - first > 2 * std::numbers::pi - Precision::PConfusion() &&
                      body.vertex({edge, true}).IsSame(body.vertex({edge, false}));
  const BodyEdges::Corner corner = body.corner(body.use(edge, true), 0.5 * (first + last));
  const Vec3 out = unit(corner.point - centre);
  const Section section{centre, out, axis};
  const auto of = rolling(body, edge, concave, radius, section, held, circle.Radius(), nullptr);
  if (!of) return std::nullopt;
  if (closed) return closed_round(*of, -out);
  const double half = 0.5 * (last - first);
  const auto made = [&](double beyond) {
    return round(*of, {std::numbers::pi - half, std::numbers::pi + half}, false, -out, beyond);
  };
  for (double beyond = kBeyond; beyond > kMinBeyond; beyond *= kLessBeyond) {
    try {
      return made(beyond);
    } catch (const Failure&) {  // the contact leaves the chart of a face
    }
  }
  return made(0);
}

}  // namespace

Handle(Geom2d_Curve) RolledStrip::contact_line(double w) const {
  return new Geom2d_Line(along_u ? gp_Pnt2d(0, w) : gp_Pnt2d(w, 0),
                         along_u ? gp_Dir2d(1, 0) : gp_Dir2d(0, 1));
}

Handle(Geom2d_Curve) RolledStrip::section_line(double t) const {
  return new Geom2d_Line(along_u ? gp_Pnt2d(t, 0) : gp_Pnt2d(0, t),
                         along_u ? gp_Dir2d(0, 1) : gp_Dir2d(1, 0));
}

TopoDS_Face RolledStrip::bare_face() const {
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, surface, Precision::Confusion());
  return face;
}

std::optional<RolledStrip> swept_strip(const BodyEdges& body, int edge, bool concave, double radius,
                                       const std::array<int, 2>& held) {
  const BRepAdaptor_Curve curve(body.edge(edge));
  switch (curve.GetType()) {
    case GeomAbs_Line: return along_line(body, edge, concave, radius, held, curve);
    case GeomAbs_Circle: return round_axis(body, edge, concave, radius, held, curve);
    default: return std::nullopt;
  }
}

}  // namespace blossom::occt
