// SPDX-License-Identifier: LGPL-2.1-or-later
// Chamfers: straight lines across the edge between borders at given distances from it.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/strips/chamfer_borders.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"

namespace blossom::occt {
namespace {

constexpr double kChamferBeyond = 4;  // distances: how far open strips go on past the edge
constexpr double kSameForm = 1e-9;    // of the distance: borders that are lines and circles
constexpr int kSteps = 16;  // along the edge, and past each end, to see how far borders go

struct Borders {
  std::vector<double> at;
  std::array<std::vector<BorderPoint>, 2> points;
};

// Those that have to be, and as far beyond as there are points on both faces.
Borders borders_over(const Chamfering& of, const Interval& wanted) {
  using Row = std::pair<double, std::array<BorderPoint, 2>>;
  std::vector<Row> rows;
  const auto add_from = [&](double end, double goal) {
    for (int i = 1; i <= kSteps && goal != end; ++i) {
      const double x = at(Interval{end, goal}, static_cast<double>(i) / kSteps);
      const auto both = of.at_edge(x);
      if (!both) return;
      rows.emplace_back(x, *both);
    }
  };
  const auto add_on_edge = [&](int step) {
    const double x = at(of.sure, static_cast<double>(step) / kSteps);
    const auto both = of.at_edge(x);
    if (!both) of.refuse(kNoBorderPoint, x);
    rows.emplace_back(x, *both);
  };
  add_on_edge(0);
  add_on_edge(kSteps);
  for (int i = 1; i < kSteps; ++i) add_on_edge(i);
  add_from(of.sure.from, wanted.from);
  add_from(of.sure.to, wanted.to);
  std::ranges::sort(rows, {}, &Row::first);
  Borders made;
  for (const auto& [x, both] : rows) {
    made.at.push_back(x);
    for (const std::size_t k : {0U, 1U}) made.points[k].push_back(both[k]);
  }
  return made;
}

// Whether a quantity is the same at all points of a border.
template <class Value>
bool is_constant(const Borders& borders, std::size_t side, double room, const Value& value) {
  const auto first = value(0U);
  for (std::size_t i = 1; i < borders.points[side].size(); ++i)
    if (norm(value(i) - first) > room) return false;
  return true;
}

// Whether a border is one point, as in the middle of an arc whose radius is the distance.
bool is_point(const Borders& borders, std::size_t side, double room) {
  return is_constant(borders, side, room,
                     [&](std::size_t i) { return borders.points[side][i].point; });
}

// Beside an edge that is bent by no more than the distance a border goes where the edge goes.
void check_ways(const Chamfering& of, const Borders& borders) {
  const double room = kSameForm * (of.profile.distance[0] + of.profile.distance[1]);
  for (const std::size_t k : {0U, 1U}) {
    if (is_point(borders, k, room)) continue;
    for (std::size_t i = 0; i + 1 < borders.at.size(); ++i) {
      const double x = 0.5 * (borders.at[i] + borders.at[i + 1]);
      if (x < of.domain.from || x > of.domain.to) continue;
      const Vec3 way = borders.points[k][i + 1].point - borders.points[k][i].point;
      if (dot(way, unit(vec(of.curve->DN(x, 1)))) > 0) continue;
      throw FilletRefused({FilletFault::Pinch, of.edge,
                           "the edge is bent so much that the chamfer's border on face " +
                               std::to_string(of.faces[k]) +
                               " turns back: the distance is too large",
                           x, borders.points[k][i].point, std::nullopt});
    }
  }
}

// The surface of straight lines between two splines with the same knots.
Handle(Geom_BSplineSurface)
    ruled(const Handle(Geom_BSplineCurve) & a, const Handle(Geom_BSplineCurve) & b) {
  TColgp_Array2OfPnt poles(1, a->NbPoles(), 1, 2);
  for (int i = 1; i <= a->NbPoles(); ++i) {
    poles(i, 1) = a->Pole(i);
    poles(i, 2) = b->Pole(i);
  }
  TColStd_Array1OfReal knots(1, a->NbKnots()), ends(1, 2);
  TColStd_Array1OfInteger multiplicities(1, a->NbKnots()), twice(1, 2);
  a->Knots(knots);
  a->Multiplicities(multiplicities);
  ends(1) = 0;
  ends(2) = 1;
  twice.Init(2);
  return new Geom_BSplineSurface(poles, knots, ends, multiplicities, twice, a->Degree(), 1);
}

void set_contact(const Chamfering& of, const FittedBorders& borders, std::size_t side,
                 const Handle(Geom_Curve) & curve, RolledStrip& strip) {
  RolledContact& contact = strip.contacts[side];
  contact.face = of.faces[side];
  contact.curve = curve;
  contact.chart = to_occt(borders.charts[side]);
  contact.w = static_cast<double>(side);
}

void set_fitted(const Chamfering& of, const Interval& range, RolledStrip& strip) {
  const FittedBorders borders = fitted_borders(of, range);
  const Handle(Geom_BSplineCurve) left = to_occt(borders.rows[0]), right = to_occt(borders.rows[1]);
  strip.surface = ruled(left, right);
  strip.range = borders.range;
  set_contact(of, borders, 0, left, strip);
  set_contact(of, borders, 1, right, strip);
}

bool is_elementary(const Handle(Geom_Surface) & surface) {
  return !Handle(Geom_ElementarySurface)::DownCast(surface).IsNull();
}

// A chart curve that stays in a point.
Handle(Geom2d_Curve) standing_chart(const Vec2& uv, const Interval& range) {
  TColgp_Array1OfPnt2d poles(1, 2);
  poles.Init({uv[0], uv[1]});
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = range.from;
  knots(2) = range.to;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(2);
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
}

void add_border(const Chamfering& of, std::size_t side, const Handle(Geom_Curve) & curve, double w,
                const BorderPoint& middle, RolledStrip& strip) {
  const int number = of.faces[side];
  Handle(Geom2d_Curve) chart;
  const auto circle = Handle(Geom_Circle)::DownCast(curve);
  if (!circle.IsNull() && circle->Radius() == 0) {
    chart = standing_chart(middle.uv, strip.range);
  } else if (is_elementary(of.surfaces[side])) {
    const SurfaceProjector feet(of.body.face(number), Precision::Confusion());
    chart = image_of(curve, strip.range, feet, middle.uv, Precision::Confusion()).chart;
  } else {
    const FittedBorders borders = fitted_borders(of, strip.range);
    strip.range = borders.range;
    chart = to_occt(borders.charts[side]);
  }
  strip.contacts[side] = {number, curve, chart, w};
}

// Of a line whose borders are lines: a plane.
bool set_plane(const Chamfering& of, const Borders& borders, const gp_Lin& line,
               RolledStrip& strip) {
  const double room = kSameForm * (of.profile.distance[0] + of.profile.distance[1]);
  const Vec3 origin = vec(line.Location().XYZ()), axis = vec(line.Direction().XYZ());
  std::array<Vec3, 2> off;
  for (const std::size_t k : {0U, 1U}) {
    const auto value = [&](std::size_t i) {
      return borders.points[k][i].point - (origin + borders.at[i] * axis);
    };
    if (!is_constant(borders, k, room, value)) return false;
    off[k] = value(0);
  }
  const Vec3 across = off[1] - off[0];
  const gp_Ax3 frame(pnt(origin + off[0]), dir(cross(axis, across)), dir(axis));
  strip.surface = new Geom_Plane(frame);
  strip.range = {borders.at.front(), borders.at.back()};
  const std::size_t middle = borders.at.size() / 2;
  for (const std::size_t k : {0U, 1U})
    add_border(of, k, new Geom_Line(pnt(origin + off[k]), line.Direction()),
               k == 0 ? 0 : norm(across), borders.points[k][middle], strip);
  return true;
}

// Of a circle whose borders are circles round its axis: a cylinder or a cone.
bool set_round(const Chamfering& of, const Borders& borders, const gp_Circ& circle,
               RolledStrip& strip) {
  const double room = kSameForm * (of.profile.distance[0] + of.profile.distance[1]);
  const Vec3 origin = vec(circle.Location().XYZ()), axis = vec(circle.Axis().Direction().XYZ());
  std::array<Vec2, 2> flat;  // radius and height
  for (const std::size_t k : {0U, 1U}) {
    const auto value = [&](std::size_t i) {
      const Vec3 from = borders.points[k][i].point - origin;
      const double height = dot(from, axis);
      return Vec2{norm(from - height * axis), height};
    };
    if (!is_constant(borders, k, room, value)) return false;
    flat[k] = value(0);
    if (flat[k][0] <= room) flat[k][0] = 0;  // the apex
  }
  const double rise = flat[1][1] - flat[0][1], widening = flat[1][0] - flat[0][0];
  if (std::abs(rise) <= room) return false;
  const auto frame_at_height = [&](double height) {
    gp_Ax2 frame = circle.Position();
    frame.SetLocation(pnt(origin + height * axis));
    return frame;
  };
  const gp_Ax3 frame(frame_at_height(flat[0][1]));
  const double angle = std::atan(widening / rise);
  if (std::abs(widening) <= room)
    strip.surface = new Geom_CylindricalSurface(frame, flat[0][0]);
  else
    strip.surface = new Geom_ConicalSurface(frame, angle, flat[0][0]);
  strip.range = {borders.at.front(), borders.at.back()};
  const double slant = std::abs(widening) <= room ? rise : rise / std::cos(angle);
  const std::size_t middle = borders.at.size() / 2;
  for (const std::size_t k : {0U, 1U})
    add_border(of, k, new Geom_Circle(frame_at_height(flat[k][1]), flat[k][0]), k == 0 ? 0 : slant,
               borders.points[k][middle], strip);
  return true;
}

bool points_outwards(const Chamfering& of, const RolledStrip& strip) {
  const double x = at(of.sure, 0.5);
  const double w = 0.5 * (strip.contacts[0].w + strip.contacts[1].w);
  const SurfaceJet frame = frame_at(strip.surface, strip.chart(x, w));
  const Vec3 out = of.body.corner(of.body.use(of.edge, true), x).normal +
                   of.body.corner(of.body.use(of.edge, false), x).normal;
  return dot(cross(frame.du, frame.dv), out) > 0;
}

Chamfering chamfering(const BodyEdges& body, int edge, bool concave, const ChamferProfile& profile,
                      const std::array<int, 2>& faces) {
  Chamfering of{body, edge, concave, profile};
  of.curve = BRep_Tool::Curve(body.edge(edge), of.domain.from, of.domain.to);
  of.sure = of.domain;
  of.faces = faces;
  for (const std::size_t k : {0U, 1U}) {
    const TopoDS_Face face = body.face(faces[k]);
    of.surfaces[k] = BRep_Tool::Surface(face);
    if (is_elementary(of.surfaces[k])) of.feet[k].emplace(face, Precision::Confusion());
  }
  return of;
}

// How far strips go on past their edges, in its parameter.
double beyond_edge(const Chamfering& of, const BRepAdaptor_Curve& form) {
  const double speed = of.curve->DN(at(of.domain, 0.5), 1).Magnitude();
  const double beyond =
      kChamferBeyond * std::max(of.profile.distance[0], of.profile.distance[1]) / speed;
  if (form.GetType() != GeomAbs_Circle) return beyond;
  const double left = 2 * std::numbers::pi - length(of.domain);
  return std::min({beyond, kMaxTurn, std::max(0.25 * left, 0.0)});
}

// wanted   range of the strip, if borders go so far
RolledStrip strip_over(const Chamfering& of, const Interval& wanted, bool closed) {
  RolledStrip strip;
  strip.edge = of.edge;
  strip.concave = of.concave;
  strip.radius = std::max(of.profile.distance[0], of.profile.distance[1]);
  strip.is_ball = false;
  strip.closed = closed;
  strip.spine = of.curve;
  strip.edge_range = of.domain;
  const BRepAdaptor_Curve form(of.body.edge(of.edge));
  const Borders borders = borders_over(of, wanted);
  check_ways(of, borders);
  const bool exact =
      (form.GetType() == GeomAbs_Line && set_plane(of, borders, form.Line(), strip)) ||
      (form.GetType() == GeomAbs_Circle && set_round(of, borders, form.Circle(), strip));
  const double room = kSameForm * (of.profile.distance[0] + of.profile.distance[1]);
  if (!exact && (is_point(borders, 0, room) || is_point(borders, 1, room)))
    of.refuse("the chamfer's border on a face is a point, in which only a cone can end",
              at(of.sure, 0.5));
  if (!exact) set_fitted(of, {borders.at.front(), borders.at.back()}, strip);
  strip.outward = points_outwards(of, strip);
  return strip;
}

}  // namespace

RolledStrip chamfer_strip(const BodyEdges& body, int edge, bool concave,
                          const ChamferProfile& profile) {
  const Chamfering of = chamfering(body, edge, concave, profile,
                                   {body.use(edge, true).face, body.use(edge, false).face});
  const bool closed = body.vertex({edge, true}).IsSame(body.vertex({edge, false}));
  const double beyond = closed ? 0 : beyond_edge(of, BRepAdaptor_Curve(body.edge(edge)));
  return strip_over(of, {of.domain.from - beyond, of.domain.to + beyond}, closed);
}

RolledStrip chamfer_strip(const BodyEdges& body, const GuidedPlace& place, bool concave,
                          const ChamferProfile& profile) {
  Chamfering of = chamfering(body, place.edge, concave, profile, place.faces);
  for (const std::size_t k : {0U, 1U})
    if (place.faces[k] != body.use(place.edge, k == 0).face) of.near[k] = place.charts[k];
  const BRepAdaptor_Curve form(body.edge(place.edge));
  const bool goes_past = form.GetType() == GeomAbs_Line || form.GetType() == GeomAbs_Circle;
  const double beyond = beyond_edge(of, form), past = goes_past ? beyond : 0;
  const double goal = std::clamp(place.at + (place.ahead ? beyond : -beyond), of.domain.from - past,
                                 of.domain.to + past);
  const double first = at(Interval{place.at, goal}, 1.0 / kSteps);
  of.sure = {std::min(place.at, first), std::max(place.at, first)};
  return strip_over(of, {std::min(place.at, goal), std::max(place.at, goal)}, false);
}

}  // namespace blossom::occt
