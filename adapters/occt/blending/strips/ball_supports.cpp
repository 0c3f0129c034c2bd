// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/ball_supports.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Precision.hxx>
#include <gp_Vec.hxx>
#include <math_Jacobi.hxx>
#include <math_Matrix.hxx>
#include <math_Vector.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/surface_projector.h"
#include "core/subdivision/extended_surface.h"

namespace blossom::occt {
namespace {

// Supports go on past the natural borders of their surfaces as far as a ball's contacts may lead
// beyond the edge, but no further than so many of their outer spans.
constexpr double kSupportWidths = 2.5;  // widths
constexpr double kMaxSpans = 2;
// Of the face's box: how far surfaces that have more of them are taken beyond the trims.
constexpr double kRoom = 0.5;
constexpr int kBeyondSamples = 8;  // past the end of an edge
constexpr int kTangents = 32;      // of an edge, to find a direction across it

// The length of the outer patches on a side, across it, model units.
double outer_length(const BezierSurface& surface, bool in_u, bool first) {
  const Interval u{surface.u_knots.front(), surface.u_knots.back()};
  const Interval v{surface.v_knots.front(), surface.v_knots.back()};
  const std::vector<double>& knots = in_u ? surface.u_knots : surface.v_knots;
  const double border = first ? knots.front() : knots.back();
  const double inner = first ? knots[1] : knots[knots.size() - 2];
  double least = std::numeric_limits<double>::infinity();
  for (const double part : {0.1, 0.5, 0.9}) {
    const double along = in_u ? at(v, part) : at(u, part);
    const auto point = [&](double across) {
      return point_at(surface, in_u ? Vec2{across, along} : Vec2{along, across});
    };
    least = std::min(least, distance(point(border), point(inner)));
  }
  return least;
}

// The surface over more than the box of the trims: as far as there is more of it, and a little
// further as its outer patches go on.
// length   model units
BezierSurface surface_beyond(const TopoDS_Face& face, double length_beyond) {
  const Handle(Geom_Surface) surface = basis_of(BRep_Tool::Surface(face));
  ParameterBox box = parameter_box(face);
  std::array<Interval, 2> bounds;
  surface->Bounds(bounds[0].from, bounds[0].to, bounds[1].from, bounds[1].to);
  const std::array<bool, 2> periodic{surface->IsUPeriodic() == Standard_True,
                                     surface->IsVPeriodic() == Standard_True};
  std::array<Interval*, 2> ranges{&box.u, &box.v};
  std::array<std::array<bool, 2>, 2> goes_on{};
  for (std::size_t k = 0; k < 2; ++k) {
    Interval& range = *ranges[k];
    double room = kRoom * length(range);
    if (periodic[k]) {
      room = std::min(room, 0.5 * (length(bounds[k]) - length(range)));
      if (room > 0) range = {range.from - room, range.to + room};
      continue;
    }
    const Interval wide{range.from - room, range.to + room};
    range = {std::max(wide.from, bounds[k].from), std::min(wide.to, bounds[k].to)};
    goes_on[k] = {wide.from<bounds[k].from, wide.to> bounds[k].to};
  }
  const BezierSurface exact = bezier_surface(surface, box);
  std::array<std::array<double, 2>, 2> parts{};
  for (const std::size_t k : {0U, 1U})
    for (const std::size_t end : {0U, 1U})
      if (goes_on[k][end])
        parts[k][end] = std::min(kMaxSpans, length_beyond / outer_length(exact, k == 0, end == 0));
  return extended(exact, parts[0], parts[1]);
}

// Of du x dv of a face's surface, on which the ball is.
int side_of(const TopoDS_Face& face, bool concave) {
  return (concave ? 1 : -1) * (face.Orientation() == TopAbs_REVERSED ? -1 : 1);
}

RolledSupport support_of(const BodyEdges& body, const EdgeUseInFace& use, double parameter,
                         const BodyEdges::Corner& corner, double width, bool concave) {
  const TopoDS_Face& face = body.face(use.face);
  RolledSupport made;
  made.surface = surface_beyond(face, kSupportWidths * width);
  const Vec2 scale = body.trims(use.face).scale, chart = point_at(use.coedge->curve, parameter);
  const Vec2 uv{chart[0] / scale[0], chart[1] / scale[1]};
  made.at_edge = uv;
  made.start = uv + chart_step(frame_at(BRep_Tool::Surface(face), uv), width * corner.inwards);
  made.side = side_of(face, concave);
  const Interval u{made.surface.u_knots.front(), made.surface.u_knots.back()};
  const Interval v{made.surface.v_knots.front(), made.surface.v_knots.back()};
  made.start = {std::clamp(made.start[0], u.from, u.to), std::clamp(made.start[1], v.from, v.to)};
  return made;
}

// A chart moved by whole periods to where the converted surface is, and onto it.
Vec2 near_range(const Handle(Geom_Surface) & surface, const BezierSurface& converted, Vec2 chart) {
  const std::array<Interval, 2> ranges{
      Interval{converted.u_knots.front(), converted.u_knots.back()},
      Interval{converted.v_knots.front(), converted.v_knots.back()}};
  const std::array<double, 2> turns = turns_of(surface);
  for (int k = 0; k < 2; ++k) {
    const Interval& range = ranges[static_cast<std::size_t>(k)];
    const double turn = turns[static_cast<std::size_t>(k)];
    if (turn > 0) chart[k] += turn * std::round((at(range, 0.5) - chart[k]) / turn);
    chart[k] = std::clamp(chart[k], range.from, range.to);
  }
  return chart;
}

// The direction that is most across all of a curve: where the sum of the squares of its tangents'
// parts along it is least.
Vec3 across_curve(const Handle(Geom_Curve) & curve, const Interval& range) {
  math_Matrix squares(1, 3, 1, 3, 0.0);
  for (int i = 0; i <= kTangents; ++i) {
    const gp_Vec rate = curve->DN(at(range, static_cast<double>(i) / kTangents), 1);
    const Vec3 t = unit(Vec3{rate.X(), rate.Y(), rate.Z()});
    for (int k = 0; k < 3; ++k)
      for (int m = 0; m < 3; ++m) squares(k + 1, m + 1) += t[k] * t[m];
  }
  const math_Jacobi parts(squares);
  int least = 1;
  for (int k = 2; k <= 3; ++k)
    if (parts.Value(k) < parts.Value(least)) least = k;
  math_Vector direction(1, 3);
  parts.Vector(least, direction);
  return unit(Vec3{direction(1), direction(2), direction(3)});
}

// An edge's range with what its curve has past both ends, as far as it keeps to the face behind: a
// strip that ends where the edge does has to go over the border there.
Interval kept_to_face(const BodyEdges& body, int edge, int face, double length_beyond) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(body.edge(edge), range.from, range.to);
  const SurfaceProjector feet(body.face(face), Precision::Confusion());
  const double reach = std::max(Precision::Confusion(), BRep_Tool::Tolerance(body.edge(edge)));
  const Interval own = range;
  Interval most{curve->FirstParameter(), curve->LastParameter()};
  if (curve->IsPeriodic()) {
    const double room = 0.5 * (curve->Period() - length(own));
    most = {own.from - room, own.to + room};
  }
  for (const bool at_start : {true, false}) {
    const double end = at_start ? own.from : own.to;
    const double beyond = length_beyond / curve->DN(end, 1).Magnitude();
    const double last =
        at_start ? std::max(end - beyond, most.from) : std::min(end + beyond, most.to);
    bool keeps = true;
    for (int i = 1; i <= kBeyondSamples && keeps; ++i) {
      const Vec3 point =
          vec(curve->Value(at({end, last}, static_cast<double>(i) / kBeyondSamples)));
      const Vec3 foot = frame_at(feet.surface(), feet.foot(point, std::nullopt)).point;
      keeps = distance(point, foot) <= reach;
    }
    if (keeps) (at_start ? range.from : range.to) = last;
  }
  return range;
}

// An edge, and the angle about it of a ball near to its parameter x.
RolledSupport held_support(const BodyEdges& body, int edge, int face, double x, const Vec3& centre,
                           double length_beyond) {
  const Interval range = kept_to_face(body, edge, face, length_beyond);
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(body.edge(edge), first, last);
  gp_Pnt point;
  gp_Vec rate;
  curve->D1(x, point, rate);
  const Vec3 to_centre = centre - vec(point.XYZ()), along = unit(vec(rate.XYZ()));
  Vec3 across = across_curve(curve, range);
  if (dot(across, to_centre) < 0) across = -across;
  const Vec3 e1 = unit(across - dot(across, along) * along), e2 = cross(along, e1);
  RolledSupport made;
  made.is_edge = true;
  made.surface = bezier_surface(new Geom_SurfaceOfLinearExtrusion(curve, dir(across)),
                                {range, {-std::numbers::pi, std::numbers::pi}});
  made.start = {x, std::atan2(dot(to_centre, e2), dot(to_centre, e1))};
  made.at_edge = made.start;
  return made;
}

}  // namespace

RolledSupports rolled_supports(const BodyEdges& body, int edge, bool concave, double radius,
                               const std::optional<double>& at) {
  double first = 0, last = 0;
  BRep_Tool::Range(body.edge(edge), first, last);
  const double middle = at.value_or(0.5 * (first + last));
  const EdgeUseInFace &left = body.use(edge, true), &right = body.use(edge, false);
  const BodyEdges::Corner a = body.corner(left, middle), b = body.corner(right, middle);
  RolledSupports made;
  made.middle = a.point;
  // Of tangent planes: each contact is r tan(turn / 2) from the edge.
  made.width =
      radius * std::tan(0.5 * std::atan2(norm(cross(a.normal, b.normal)), dot(a.normal, b.normal)));
  made.of[0] = support_of(body, left, middle, a, made.width, concave);
  made.of[1] = support_of(body, right, middle, b, made.width, concave);
  return made;
}

RolledSupports supports_at(const BodyEdges& body, const BallPlace& place, bool concave,
                           double radius) {
  RolledSupports made;
  made.middle = place.centre;
  made.width = radius;
  for (const std::size_t k : {0U, 1U}) {
    RolledSupport& of = made.of[k];
    if (place.held[k] > 0) {
      of = held_support(body, place.held[k], place.faces[k], place.held_at[k], place.centre,
                        kSupportWidths * radius);
      continue;
    }
    const TopoDS_Face& face = body.face(place.faces[k]);
    of.surface = surface_beyond(face, kSupportWidths * radius);
    of.start = near_range(BRep_Tool::Surface(face), of.surface, place.charts[k]);
    of.at_edge = of.start;
    of.side = side_of(face, concave);
  }
  return made;
}

}  // namespace blossom::occt
