// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/end_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <ProjLib.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/convert/grown.h"
#include "adapters/occt/convert/pcurves.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/convert/surfaces_detail.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"
#include "core/curve_surface_intersection.h"
#include "core/math/linear_solve.h"
#include "core/subdivision/extended_surface.h"
#include "core/surface_intersection.h"

namespace blossom::occt {
namespace {

constexpr int kFootSamples = 5;  // a side, of the strip's part whose feet bound what is searched
// Of a span, or of the way across a strip: how far surfaces go on past their borders.
constexpr double kBeyondBorder = 0.125;
// Of a face's length, of planes and cylinders, which nothing limits. A choice: a strip's end goes
// past a border by about its radius, and a ball that rolls on a face is about as wide as it at
// most.
constexpr double kBeyondEndless = 0.5;
// Of the way across a strip: where the curve is known to end at contacts, so that no curve on it
// closes beyond them.
constexpr double kBeyondContact = 1e-3;
constexpr double kFootRoom = 0.25;  // of the feet's box: how far beyond it is searched
// Pairs of cells. One curve between two known places takes some thousands; surfaces that touch
// along each other take all there are, and have no curve to be found.
constexpr long kMaxPairs = 100'000;
// Likewise, of cells that are looked at for contacts, which take some hundred times as long: an end
// goes through its face, and where it does so at a small angle some hundreds tell.
constexpr long kMaxContactCells = 500;
// Newton's steps to a common point of three surfaces, the last ones of which double its digits; and
// of Open CASCADE's confusion, how near it has to come to all of them.
constexpr int kCommonSteps = 20;
constexpr double kCommonAt = 0.1;

Interval widened(const Interval& of, double room) { return {of.from - room, of.to + room}; }

// Of a face's surface at the foot of a point.
Vec3 normal_near(const TopoDS_Face& face, const Vec3& point) {
  const SurfaceProjector feet(face, Precision::Confusion());
  const SurfaceJet frame = frame_at(feet.surface(), feet.foot(point, std::nullopt));
  return unit(cross(frame.du, frame.dv));
}

// What of a face's surface is near points that follow each other, in its own parameters.
ParameterBox box_near(const std::vector<Vec3>& points, const TopoDS_Face& face) {
  const SurfaceProjector feet(face, Precision::Confusion());
  std::optional<Vec2> near;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<Interval, 2> box{Interval{kFar, -kFar}, Interval{kFar, -kFar}};
  for (const Vec3& point : points) {
    near = feet.foot(point, near);
    for (int d = 0; d < 2; ++d) {
      auto& of = box[static_cast<std::size_t>(d)];
      of = {std::min(of.from, (*near)[d]), std::max(of.to, (*near)[d])};
    }
  }
  const Handle(Geom_Surface)& surface = feet.surface();
  std::array<Interval, 2> bounds;
  surface->Bounds(bounds[0].from, bounds[0].to, bounds[1].from, bounds[1].to);
  for (std::size_t d = 0; d < 2; ++d) {
    box[d] = widened(box[d], kFootRoom * length(box[d]) + Precision::Confusion());
    const bool periodic = d == 0 ? surface->IsUPeriodic() : surface->IsVPeriodic();
    if (periodic) {
      const double turn = length(bounds[d]), room = 0.5 * (turn - length(box[d]));
      if (room < 0) box[d] = widened(box[d], room);
    } else {
      box[d] = {std::max(box[d].from, bounds[d].from), std::min(box[d].to, bounds[d].to)};
    }
  }
  return {box[0], box[1]};
}

// A part of a strip, from contact to contact and a little beyond, so that no curve on it ends at a
// contact by a hair.
// beyond   of the way across
BezierSurface strip_surface(const RolledStrip& strip, const Interval& part,
                            double beyond = kBeyondBorder) {
  Interval across{strip.contacts[0].w, strip.contacts[1].w};
  if (across.from > across.to) std::swap(across.from, across.to);
  std::array<Interval, 2> bounds;
  strip.surface->Bounds(bounds[0].from, bounds[0].to, bounds[1].from, bounds[1].to);
  const Interval most = bounds[strip.along_u ? 1 : 0];
  const double room = beyond * length(across);
  const bool goes_on = across.from - room < most.from || across.to + room > most.to;
  const bool turns = strip.along_u ? strip.surface->IsVPeriodic() : strip.surface->IsUPeriodic();
  if (turns || !goes_on) across = {across.from - room, across.to + room};
  const BezierSurface surface = bezier_surface(
      strip.surface, strip.along_u ? ParameterBox{part, across} : ParameterBox{across, part});
  if (turns || !goes_on) return surface;
  const std::array parts{beyond, beyond}, none{0.0, 0.0};
  return strip.along_u ? extended(surface, none, parts) : extended(surface, parts, none);
}

// A box of a face's parameters with those of points that lie past the natural borders of its
// surface, along its tangent planes there.
ParameterBox box_with(const ParameterBox& box, const TopoDS_Face& face,
                      const std::vector<Vec3>& points) {
  const SurfaceProjector feet(face, Precision::Confusion());
  std::array<Interval, 2> own, with{box.u, box.v};
  feet.surface()->Bounds(own[0].from, own[0].to, own[1].from, own[1].to);
  const std::array<double, 2> turns = turns_of(feet.surface());
  for (const Vec3& point : points) {
    const Vec2 foot = feet.foot(point, std::nullopt);
    const SurfaceJet frame = frame_at(feet.surface(), foot);
    const Vec2 there = foot + chart_step(frame, point - frame.point);
    for (std::size_t k = 0; k < 2; ++k) {
      const double x = there[static_cast<int>(k)];
      if (turns[k] > 0) continue;
      if (x < own[k].from) with[k].from = std::min(with[k].from, x);
      if (x > own[k].to) with[k].to = std::max(with[k].to, x);
    }
  }
  return {with[0], with[1]};
}

// A face's surface near points, and a little beyond its natural borders, and beyond where the ends
// of what is looked for lie past them.
BezierSurface face_surface(const std::vector<Vec3>& points, const TopoDS_Face& face,
                           const std::vector<Vec3>& ends = {}) {
  const ParameterBox box = box_with(box_near(points, face), face, ends);
  const Handle(Geom_Surface) surface = grown(BRep_Tool::Surface(face), box);
  const ParameterBox natural = natural_bounds(*surface);
  const auto common = [](const Interval& a, const Interval& b) {
    return Interval{std::max(a.from, b.from), std::min(a.to, b.to)};
  };
  const std::array parts{kBeyondBorder, kBeyondBorder};
  return extended(bezier_surface(surface, {common(box.u, natural.u), common(box.v, natural.v)}),
                  parts, parts);
}

// A face's surface as far as its trims go, and a little beyond; further where it has no end and no
// apex.
BezierSurface trimmed_surface(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const ParameterBox own = parameter_box(face);
  std::array<Interval, 2> box{own.u, own.v}, bounds;
  surface->Bounds(bounds[0].from, bounds[0].to, bounds[1].from, bounds[1].to);
  for (std::size_t d = 0; d < 2; ++d) {
    const bool is_endless = Precision::IsInfinite(bounds[d].from) &&
                            !surface->IsKind(STANDARD_TYPE(Geom_ConicalSurface));
    double room = (is_endless ? kBeyondEndless : kBeyondBorder) * length(box[d]);
    if (d == 0 ? surface->IsUPeriodic() : surface->IsVPeriodic()) {
      room = std::clamp(0.5 * (length(bounds[d]) - length(box[d])), 0.0, room);
      box[d] = widened(box[d], room);
    } else {
      box[d] = {std::max(box[d].from - room, bounds[d].from),
                std::min(box[d].to + room, bounds[d].to)};
    }
  }
  const std::array parts{kBeyondBorder, kBeyondBorder};
  return extended(bezier_surface(surface, {box[0], box[1]}), parts, parts);
}

// Where a curve is nearest to a point.
struct Near {
  double at = 0;
  double distance = std::numeric_limits<double>::infinity();
};

Near near_point(const Handle(Geom_Curve) & curve, const Interval& range, const Vec3& point) {
  const double t = nearest_on(curve, range, point);
  return {t, distance(vec(curve->Value(t).XYZ()), point)};
}

// An exact image where the curve is a conic and Open CASCADE knows it, else the fitted one. Past
// the natural border of a surface, where feet end, only that one goes on.
Handle(Geom2d_Curve)
    exact_chart(const IntersectionCurve& found, const Spline2& fitted,
                const Handle(Geom_Curve) & curve, const Interval& range, const TopoDS_Face& face) {
  if (!found.conic) return to_occt(fitted);
  const SurfaceProjector feet(face, Precision::Confusion());
  // First, as an image that is fitted to feet on the border takes seconds.
  if (!CurveBeside(curve, range, feet).is_one_run(Precision::Confusion(), Precision::Confusion()))
    return to_occt(fitted);
  try {
    const ChartImage image =
        image_of(curve, range, feet, point_at(fitted, at(range, 0.5)), Precision::Confusion());
    if (image.deviation <= Precision::Confusion()) return image.chart;
  } catch (const Failure&) {  // it goes over the seam of a surface that has no period
  }
  return to_occt(fitted);
}

}  // namespace

std::vector<EdgeThrough> edge_through(const RolledStrip& strip, const Interval& part,
                                      const BodyEdges& body, int edge) {
  std::vector<EdgeThrough> all;
  const CurveSurfaceIntersection found =
      intersect(bezier_spans(body.edge(edge)), strip_surface(strip, part));
  for (const CurveSurfacePoint& each : found.points)
    all.push_back(
        {each.t, each.uv[strip.along_u ? 0 : 1], each.uv[strip.along_u ? 1 : 0], each.point});
  return all;
}

namespace {

// The best piece among all curves of two surfaces.
std::optional<EndCurve> best_curve(const BezierSurface& on_face, const TopoDS_Face& face,
                                   const BezierSurface& on_other, const TopoDS_Face& other,
                                   const Vec3& from, const Vec3& to, double reach) {
  IntersectionOptions options;
  options.budget = kMaxPairs;
  options.contact_budget = kMaxContactCells;
  const SurfaceIntersection found = intersect(on_face, on_other, options);
  std::optional<EndCurve> best;
  double least = reach;
  for (const IntersectionCurve& each : found.curves) {
    const Handle(Geom_Curve) spline = to_occt(each.curve);
    const Interval domain = each.curve.domain();
    const Near start = near_point(spline, domain, from), end = near_point(spline, domain, to);
    if (std::max(start.distance, end.distance) > least || start.at == end.at) continue;
    least = std::max(start.distance, end.distance);
    EndCurve made;
    made.forward = start.at < end.at;
    made.range = {std::min(start.at, end.at), std::max(start.at, end.at)};
    made.curve = each.conic ? to_occt(*each.conic) : Handle(Geom_Curve)(spline);
    made.on_face = exact_chart(each, each.chart_a, made.curve, made.range, face);
    made.on_strip = exact_chart(each, each.chart_b, made.curve, made.range, other);
    best = std::move(made);
  }
  return best;
}

}  // namespace

std::optional<EndCurve> curve_between(const RolledStrip& strip, const Interval& part,
                                      const TopoDS_Face& face, const Vec3& from, const Vec3& to,
                                      double reach) {
  std::vector<Vec3> points;
  for (int i = 0; i < kFootSamples; ++i)
    for (int k = 0; k < kFootSamples; ++k) {
      const double t = at(part, static_cast<double>(i) / (kFootSamples - 1));
      const double w =
          at({strip.contacts[0].w, strip.contacts[1].w},
             static_cast<double>(i % 2 == 0 ? k : kFootSamples - 1 - k) / (kFootSamples - 1));
      const Vec2 uv = strip.chart(t, w);
      points.push_back(vec(strip.surface->Value(uv[0], uv[1]).XYZ()));
    }
  const BezierSurface on_face = face_surface(points, face, {from, to});
  return best_curve(on_face, face, strip_surface(strip, part), strip.bare_face(), from, to, reach);
}

std::optional<EndCurve> curve_in_face(const RolledStrip& strip, const Interval& part,
                                      const TopoDS_Face& face, const Vec3& from, const Vec3& to,
                                      double reach) {
  return best_curve(trimmed_surface(face), face, strip_surface(strip, part, kBeyondContact),
                    strip.bare_face(), from, to, reach);
}

std::optional<EndCurve> curve_between(const RolledStrip& strip, const Interval& part,
                                      const RolledStrip& other, const Interval& other_part,
                                      const Vec3& from, const Vec3& to, double reach) {
  return best_curve(strip_surface(other, other_part), other.bare_face(), strip_surface(strip, part),
                    strip.bare_face(), from, to, reach);
}

std::optional<double> contact_through(const RolledStrip& of, std::size_t side, double near,
                                      const RolledStrip& other, const Interval& other_part) {
  TopoDS_Edge edge;
  BRep_Builder builder;
  builder.MakeEdge(edge, of.contacts[side].curve, Precision::Confusion());
  builder.Range(edge, of.range.from, of.range.to);
  std::optional<double> best;
  for (const CurveSurfacePoint& each :
       intersect(bezier_spans(edge), strip_surface(other, other_part)).points)
    if (!best || std::abs(each.t - near) < std::abs(*best - near)) best = each.t;
  return best;
}

std::optional<double> contact_through(const RolledStrip& of, std::size_t side, double near,
                                      const TopoDS_Face& face, const Interval& part) {
  const Handle(Geom_Curve)& contact = of.contacts[side].curve;
  std::vector<Vec3> points;
  // With room on all sides, as the contact may go straight through the face.
  for (int i = 0; i <= kFootSamples; ++i) {
    const Vec3 point = vec(contact->Value(at(part, static_cast<double>(i) / kFootSamples)).XYZ());
    for (const double room : {-of.radius, of.radius})
      for (const Vec3& axis : {Vec3{room, 0, 0}, Vec3{0, room, 0}, Vec3{0, 0, room}})
        points.push_back(point + axis);
  }
  // The face may have to go on as far as the contact does past the end of the edge.
  const double room = std::min(std::abs(near - part.from), std::abs(part.to - near));
  std::vector<Vec3> ends;
  for (const double t : {near - room, near, near + room})
    ends.push_back(vec(contact->Value(std::clamp(t, part.from, part.to))));
  TopoDS_Edge edge;
  BRep_Builder builder;
  builder.MakeEdge(edge, contact, Precision::Confusion());
  builder.Range(edge, part.from, part.to);
  std::optional<double> best;
  for (const CurveSurfacePoint& each :
       intersect(bezier_spans(edge), face_surface(points, face, ends)).points)
    if (!best || std::abs(each.t - near) < std::abs(*best - near)) best = each.t;
  return best;
}

namespace {

// One of three surfaces, and where on it the last foot was.
struct Footed {
  SurfaceProjector feet;
  std::optional<Vec2> near{};
};

Footed footed(const TopoDS_Face& face, const std::optional<Vec2>& near = std::nullopt) {
  return {SurfaceProjector(face, Precision::Confusion()), near};
}

Footed footed(const RolledStrip& strip, const Interval& part) {
  return footed(strip.bare_face(),
                strip.chart(at(part, 0.5), 0.5 * (strip.contacts[0].w + strip.contacts[1].w)));
}

// A common point of three surfaces, by Newton's method on their tangent planes at the feet of the
// last place. For planes and the cylinder of a strip it comes to the nearest one from its side and
// never past it.
std::optional<Vec3> common_point(std::array<Footed, 3>& of, Vec3 place) {
  for (int step = 0; step < kCommonSteps; ++step) {
    SquareMatrix<3> normals;
    Vec3 off;
    for (std::size_t i = 0; i < of.size(); ++i) {
      of[i].near = of[i].feet.foot(place, of[i].near);
      const SurfaceJet frame = frame_at(of[i].feet.surface(), *of[i].near);
      const Vec3 normal = unit(cross(frame.du, frame.dv));
      normals[i] = {normal[0], normal[1], normal[2]};
      off[static_cast<int>(i)] = dot(normal, frame.point - place);
    }
    if (step > 0 && norm(off) <= kCommonAt * Precision::Confusion()) return place;
    if (!solve(normals, off)) return std::nullopt;
    place += off;
  }
  return std::nullopt;
}

// A place between the contacts of a strip, or beside one by no more than `reach`; nothing for
// others.
std::optional<EdgeThrough> between_contacts(const RolledStrip& strip, const Vec2& uv,
                                            const Vec3& point, double reach) {
  const Vec2 tw = strip.along_u ? uv : Vec2{uv[1], uv[0]};
  const auto contact = [&](std::size_t side) {
    return vec(strip.contacts[side].curve->Value(tw[0]).XYZ());
  };
  const double first = strip.contacts[0].w, share = (tw[1] - first) / (strip.contacts[1].w - first);
  const double room = reach / distance(contact(0), contact(1));
  if (!(share > -room && share < 1 + room)) return std::nullopt;
  return EdgeThrough{0, tw[0], tw[1], point};
}

}  // namespace

std::optional<EdgeThrough> grown_through(const RolledStrip& strip, const Interval& part,
                                         const TopoDS_Face& a, const TopoDS_Face& b,
                                         const Vec3& vertex) {
  std::array of{footed(strip, part), footed(a), footed(b)};
  const auto place = common_point(of, vertex);
  return place ? between_contacts(strip, *of[0].near, *place, 0) : std::nullopt;
}

std::optional<EdgeThrough> mitre_through(const RolledStrip& strip, const Interval& part,
                                         const RolledStrip& other, const Interval& other_part,
                                         const TopoDS_Face& face, const Vec3& vertex,
                                         double reach) {
  std::array of{footed(strip, part), footed(other, other_part), footed(face)};
  const auto place = common_point(of, vertex);
  if (!place || !between_contacts(other, *of[1].near, *place, reach)) return std::nullopt;
  return between_contacts(strip, *of[0].near, *place, reach);
}

namespace {

// The line in which two planes meet, between the points of it that are nearest to two given ones.
// Surfaces of planes that are fitted round two near points are known to fewer digits than planes
// are, the more so the further their parameters are from 0.
std::optional<EndCurve> line_between(const gp_Pln& wall, const gp_Pln& face, const Vec3& from,
                                     const Vec3& to, double reach) {
  const Vec3 n = vec(wall.Axis().Direction().XYZ()), m = vec(face.Axis().Direction().XYZ());
  const Vec3 along = cross(n, m);
  const double sine2 = dot(along, along);
  if (sine2 < Precision::Angular() * Precision::Angular()) return std::nullopt;
  // From the point `from` to both planes, across the line.
  const auto above = [&](const gp_Pln& plane, const Vec3& normal) {
    return dot(from - vec(plane.Location().XYZ()), normal);
  };
  const double a = above(wall, n), b = above(face, m), c = dot(n, m);
  const Vec3 foot = from - ((a - b * c) / sine2) * n - ((b - a * c) / sine2) * m;
  const Vec3 way = unit(along);
  const double length = dot(to - foot, way);
  if (distance(foot, from) > reach || distance(foot + length * way, to) > reach || length == 0)
    return std::nullopt;
  EndCurve made;
  const gp_Lin line(pnt(foot), dir(way));
  made.curve = new Geom_Line(line);
  made.on_strip = new Geom2d_Line(ProjLib::Project(wall, line));
  made.on_face = new Geom2d_Line(ProjLib::Project(face, line));
  made.forward = length > 0;
  made.range = {std::min(0.0, length), std::max(0.0, length)};
  return made;
}

}  // namespace

std::optional<EndCurve> wall_curve_between(const TopoDS_Face& wall, const TopoDS_Face& face,
                                           const Vec3& from, const Vec3& to, double reach) {
  const GeomAdaptor_Surface a(BRep_Tool::Surface(wall)), b(BRep_Tool::Surface(face));
  if (a.GetType() == GeomAbs_Plane && b.GetType() == GeomAbs_Plane)
    return line_between(a.Plane(), b.Plane(), from, to, reach);
  std::vector<Vec3> points;
  for (int i = 0; i <= kFootSamples; ++i)
    points.push_back(from + (static_cast<double>(i) / kFootSamples) * (to - from));
  // A square that holds both points with room on all sides, so that no curve ends between them.
  const Vec3 middle = 0.5 * (from + to), half = to - from;
  const Vec3 aside = cross(half, normal_near(wall, middle));
  for (const double sign : {1.0, -1.0}) {
    points.push_back(middle + sign * half);
    points.push_back(middle + sign * aside);
  }
  const std::vector<Vec3> ends{from, to};
  return best_curve(face_surface(points, face, ends), face, face_surface(points, wall, ends), wall,
                    from, to, reach);
}

}  // namespace blossom::occt
