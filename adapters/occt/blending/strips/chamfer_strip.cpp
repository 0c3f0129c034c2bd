// SPDX-License-Identifier: LGPL-2.1-or-later
// Chamfers: in each plane across the edge, a point of each face at a given distance from it.
//
//   (S - E) . E' = 0,   |S - E| = d      by Newton's method in the chart of each face
//   (S - P) . m = 0                      for the second one, if an angle at the first, P, is given
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
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
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <gp.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"

namespace blossom::occt {
namespace {

constexpr double kChamferBeyond = 4;      // distances: how far open strips go on past the edge
constexpr double kSameForm = 1e-9;        // of the distance: borders that are lines and circles
constexpr double kFitError = 1e-8;        // model units, of interpolated borders at half steps
constexpr int kFewest = 16, kMost = 512;  // steps along the edge
constexpr int kNewtonSteps = 30;
constexpr double kConverged = 1e-13;                                         // of the distance
constexpr double kPointNoise = 64 * std::numeric_limits<double>::epsilon();  // of coordinates

// A point of a border.
struct BorderPoint {
  Vec3 point;
  Vec2 uv;
};

struct Chamfering {
  const BodyEdges& body;
  int edge;
  bool concave;
  ChamferProfile profile;
  Handle(Geom_Curve) curve{};
  Interval domain{};
  std::array<Handle(Geom_Surface), 2> surfaces{};

  [[noreturn]] void refuse(const std::string& cause, double x) const {
    throw FilletRefused(
        {FilletFault::NoBall, edge, cause, x, vec(curve->Value(x).XYZ()), std::nullopt});
  }
  std::optional<std::array<BorderPoint, 2>> at_edge(double x) const;
  std::optional<BorderPoint> solved(std::size_t side, Vec2 uv, const Vec3& across,
                                    const std::function<std::pair<double, Vec3>(const Vec3&)>& f,
                                    const Vec3& origin) const;
};

// Newton's method for (S - origin) . across = 0 and a second function with its gradient.
std::optional<BorderPoint> Chamfering::solved(
    std::size_t side, Vec2 uv, const Vec3& across,
    const std::function<std::pair<double, Vec3>(const Vec3&)>& f, const Vec3& origin) const {
  const double enough =
      kConverged * (profile.distance[0] + profile.distance[1]) + kPointNoise * norm(origin);
  for (int i = 0; i < kNewtonSteps; ++i) {
    const SurfaceFrame at = frame_at(surfaces[side], uv);
    const double g = dot(at.point - origin, across);
    const auto [h, gradient] = f(at.point);
    if (std::abs(g) + std::abs(h) <= enough) return BorderPoint{at.point, uv};
    const double a = dot(at.du, across), b = dot(at.dv, across);
    const double c = dot(at.du, gradient), d = dot(at.dv, gradient);
    const double det = a * d - b * c;
    if (det == 0 || !std::isfinite(det)) return std::nullopt;
    uv -= Vec2{(g * d - b * h) / det, (a * h - g * c) / det};
  }
  return std::nullopt;
}

// Both points of the plane across the edge at a parameter, which may be past its ends.
std::optional<std::array<BorderPoint, 2>> Chamfering::at_edge(double x) const {
  const double inside = std::clamp(x, domain.from, domain.to);
  gp_Pnt p;
  gp_Vec rate;
  curve->D1(x, p, rate);
  const Vec3 origin = vec(p.XYZ()), along = unit(vec(rate.XYZ()));
  std::array<BodyEdges::Corner, 2> corners;
  std::array<Vec2, 2> charts;
  for (const std::size_t k : {0U, 1U}) {
    const EdgeUseInFace& use = body.use(edge, k == 0);
    corners[k] = body.corner(use, inside);
    const Vec2 chart = point_at(use.coedge->curve, inside), scale = body.trims(use.face).scale;
    charts[k] = {chart[0] / scale[0], chart[1] / scale[1]};
  }
  std::array<double, 2> reach = profile.distance;
  const std::size_t given = profile.given, other = 1 - given;
  if (profile.angle) {
    // The triangle of the tangent planes.
    const double opening =
        std::acos(std::clamp(dot(corners[0].inwards, corners[1].inwards), -1., 1.));
    const double rest = std::numbers::pi - *profile.angle - opening;
    if (rest <= 0) refuse("the chamfer at that angle does not meet the other face", inside);
    reach[other] = reach[given] * std::sin(*profile.angle) / std::sin(rest);
  }
  std::array<BorderPoint, 2> found;
  for (const std::size_t k : {given, other}) {
    const SurfaceFrame frame = frame_at(surfaces[k], charts[k]);
    const Vec3 step = origin + reach[k] * corners[k].inwards - frame.point;
    const Vec2 start = charts[k] + chart_step(frame, step);
    std::optional<BorderPoint> made;
    if (k == other && profile.angle) {
      const double turn = concave ? 1 : -1;
      const Vec3 chord = -std::cos(*profile.angle) * corners[given].inwards +
                         turn * std::sin(*profile.angle) * corners[given].normal;
      const Vec3 normal = unit(cross(along, chord)), from = found[given].point;
      made = solved(
          k, start, along,
          [&](const Vec3& s) {
            return std::pair{dot(s - from, normal), normal};
          },
          origin);
    } else {
      const double distance_wanted = reach[k];
      made = solved(
          k, start, along,
          [&](const Vec3& s) {
            const double far = norm(s - origin);
            return std::pair{far - distance_wanted, (1 / far) * (s - origin)};
          },
          origin);
    }
    if (!made) return std::nullopt;
    found[k] = *made;
  }
  return found;
}

struct Borders {
  std::vector<double> at;
  std::array<std::vector<BorderPoint>, 2> points;
};

// As far beyond the edge as there are points on both faces.
Borders borders_over(const Chamfering& of, const Interval& wanted, int steps) {
  Borders made;
  for (int i = 0; i <= steps; ++i) {
    const double x = at(wanted, static_cast<double>(i) / steps);
    const auto both = of.at_edge(x);
    const bool on_edge = x >= of.domain.from && x <= of.domain.to;
    if (!both && on_edge)
      of.refuse("a face has no point at the chamfer's distance from the edge", x);
    if (!both && x > of.domain.to) break;
    if (!both) {
      made = {};
      continue;
    }
    made.at.push_back(x);
    for (const std::size_t k : {0U, 1U}) made.points[k].push_back((*both)[k]);
  }
  return made;
}

Handle(Geom_BSplineCurve) spline_through(const Borders& borders, std::size_t side) {
  const int count = static_cast<int>(borders.at.size());
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, count);
  for (int i = 1; i <= count; ++i) {
    const auto place = static_cast<std::size_t>(i) - 1;
    points->SetValue(i, pnt(borders.points[side][place].point));
    parameters->SetValue(i, borders.at[place]);
  }
  GeomAPI_Interpolate maker(points, parameters, Standard_False, gp::Resolution());
  maker.Perform();
  return maker.Curve();
}

Handle(Geom2d_BSplineCurve) chart_through(const Borders& borders, std::size_t side) {
  const int count = static_cast<int>(borders.at.size());
  const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, count);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, count);
  for (int i = 1; i <= count; ++i) {
    const auto place = static_cast<std::size_t>(i) - 1;
    const Vec2& uv = borders.points[side][place].uv;
    points->SetValue(i, {uv[0], uv[1]});
    parameters->SetValue(i, borders.at[place]);
  }
  Geom2dAPI_Interpolate maker(points, parameters, Standard_False, gp::Resolution());
  maker.Perform();
  return maker.Curve();
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

// How far the splines are off at half steps.
double fit_error(const Chamfering& of, const Borders& borders,
                 const Handle(Geom_BSplineCurve) & left, const Handle(Geom_BSplineCurve) & right) {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < borders.at.size(); ++i) {
    const double x = 0.5 * (borders.at[i] + borders.at[i + 1]);
    const auto both = of.at_edge(x);
    if (!both) continue;
    largest = std::max({largest, distance((*both)[0].point, vec(left->Value(x).XYZ())),
                        distance((*both)[1].point, vec(right->Value(x).XYZ()))});
  }
  return largest;
}

void set_contact(const Chamfering& of, const Borders& borders, std::size_t side,
                 const Handle(Geom_Curve) & curve, RolledStrip& strip) {
  RolledContact& contact = strip.contacts[side];
  contact.face = of.body.use(of.edge, side == 0).face;
  contact.curve = curve;
  contact.chart = chart_through(borders, side);
  contact.w = static_cast<double>(side);
}

void set_fitted(const Chamfering& of, const Interval& wanted, RolledStrip& strip) {
  for (int steps = kFewest;; steps *= 2) {
    const Borders borders = borders_over(of, wanted, steps);
    const Handle(Geom_BSplineCurve) left = spline_through(borders, 0);
    const Handle(Geom_BSplineCurve) right = spline_through(borders, 1);
    if (steps < kMost && fit_error(of, borders, left, right) > kFitError) continue;
    strip.surface = ruled(left, right);
    strip.range = {borders.at.front(), borders.at.back()};
    set_contact(of, borders, 0, left, strip);
    set_contact(of, borders, 1, right, strip);
    return;
  }
}

// Whether a quantity is the same at all points of a border.
template <class Value>
bool is_constant(const Borders& borders, std::size_t side, double room, const Value& value) {
  const auto first = value(0U);
  for (std::size_t i = 1; i < borders.points[side].size(); ++i)
    if (norm(value(i) - first) > room) return false;
  return true;
}

bool is_elementary(const Handle(Geom_Surface) & surface) {
  return !Handle(Geom_ElementarySurface)::DownCast(surface).IsNull();
}

// The chart of a border by the edge's parameter, through points that Newton's method found in it.
Handle(Geom2d_Curve) fitted_chart(const Chamfering& of, std::size_t side,
                                  const Handle(Geom_Curve) & curve, const Interval& range) {
  const Handle(Geom_Surface)& surface = of.surfaces[side];
  for (int steps = kFewest;; steps *= 2) {
    const Borders borders = borders_over(of, range, steps);
    const Handle(Geom2d_Curve) chart = chart_through(borders, side);
    double error = 0;
    for (std::size_t i = 0; i + 1 < borders.at.size(); ++i) {
      const double x = 0.5 * (borders.at[i] + borders.at[i + 1]);
      const gp_Pnt2d uv = chart->Value(x);
      error = std::max(error, curve->Value(x).Distance(surface->Value(uv.X(), uv.Y())));
    }
    if (steps >= kMost || error <= kFitError) return chart;
  }
}

void add_border(const Chamfering& of, std::size_t side, const Handle(Geom_Curve) & curve, double w,
                const BorderPoint& middle, RolledStrip& strip) {
  const int number = of.body.use(of.edge, side == 0).face;
  Handle(Geom2d_Curve) chart;
  if (is_elementary(of.surfaces[side])) {
    const SurfaceProjector feet(of.body.face(number), Precision::Confusion());
    chart = image_of(curve, strip.range, feet, middle.uv, Precision::Confusion()).chart;
  } else {
    chart = fitted_chart(of, side, curve, strip.range);
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
    if (flat[k][0] <= room) return false;
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
  const double x = at(of.domain, 0.5);
  const double w = 0.5 * (strip.contacts[0].w + strip.contacts[1].w);
  const SurfaceFrame frame = frame_at(strip.surface, strip.chart(x, w));
  const Vec3 out = of.body.corner(of.body.use(of.edge, true), x).normal +
                   of.body.corner(of.body.use(of.edge, false), x).normal;
  return dot(cross(frame.du, frame.dv), out) > 0;
}

}  // namespace

RolledStrip chamfer_strip(const BodyEdges& body, int edge, bool concave,
                          const ChamferProfile& profile) {
  Chamfering of{body, edge, concave, profile};
  of.curve = BRep_Tool::Curve(body.edge(edge), of.domain.from, of.domain.to);
  for (const std::size_t k : {0U, 1U})
    of.surfaces[k] = BRep_Tool::Surface(body.face(body.use(edge, k == 0).face));
  RolledStrip strip;
  strip.edge = edge;
  strip.concave = concave;
  strip.radius = std::max(profile.distance[0], profile.distance[1]);
  strip.is_ball = false;
  strip.closed = body.vertex({edge, true}).IsSame(body.vertex({edge, false}));
  strip.spine = of.curve;
  strip.edge_range = of.domain;
  const double speed = of.curve->DN(at(of.domain, 0.5), 1).Magnitude();
  const double beyond = strip.closed ? 0 : kChamferBeyond * strip.radius / speed;
  Interval wanted{of.domain.from - beyond, of.domain.to + beyond};
  const BRepAdaptor_Curve form(body.edge(edge));
  if (form.GetType() == GeomAbs_Circle && length(wanted) > 2 * std::numbers::pi) wanted = of.domain;
  const Borders borders = borders_over(of, wanted, kFewest);
  const bool exact =
      (form.GetType() == GeomAbs_Line && set_plane(of, borders, form.Line(), strip)) ||
      (form.GetType() == GeomAbs_Circle && set_round(of, borders, form.Circle(), strip));
  if (!exact) set_fitted(of, wanted, strip);
  strip.outward = points_outwards(of, strip);
  return strip;
}

}  // namespace blossom::occt
