// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/drawings/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <GCPnts_QuasiUniformDeflection.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <gp_Circ.hxx>

#include "adapters/occt/base/points.h"

namespace blossom::drawings {
namespace {

using occt::vec;

Stroke polyline(const GeomAdaptor_Curve& curve, const occt::SectionCurve& of,
                const DrawingFrame& frame, double deviation) {
  Stroke stroke{.kind = StrokeKind::Polyline};
  const auto add = [&](double t) { stroke.points.push_back(frame.of(vec(curve.Value(t).XYZ()))); };
  if (curve.GetType() == GeomAbs_BSplineCurve && curve.Degree() == 1) {  // it is one already
    const Handle(Geom_BSplineCurve) spline = curve.BSpline();
    add(of.range.from);
    for (int k = 1; k <= spline->NbKnots(); ++k)
      if (spline->Knot(k) > of.range.from && spline->Knot(k) < of.range.to) add(spline->Knot(k));
    add(of.range.to);
    stroke.from = stroke.points.front();
    stroke.to = stroke.points.back();
    return stroke;
  }
  const GCPnts_QuasiUniformDeflection points(curve, deviation, of.range.from, of.range.to);
  if (points.IsDone() && points.NbPoints() > 1)
    for (int i = 1; i <= points.NbPoints(); ++i)
      stroke.points.push_back(frame.of(vec(points.Value(i).XYZ())));
  else
    for (const Vec3& sample : of.samples) stroke.points.push_back(frame.of(sample));
  stroke.from = stroke.points.front();
  stroke.to = stroke.points.back();
  return stroke;
}

Stroke forward_stroke(const occt::SectionCurve& of, const DrawingFrame& frame, double deviation) {
  const GeomAdaptor_Curve curve(of.curve, of.range.from, of.range.to);
  const Vec2 from = frame.of(vec(curve.Value(of.range.from).XYZ()));
  const Vec2 to = frame.of(vec(curve.Value(of.range.to).XYZ()));
  if (curve.GetType() == GeomAbs_Line) return {.kind = StrokeKind::Line, .from = from, .to = to};
  if (curve.GetType() != GeomAbs_Circle) return polyline(curve, of, frame, deviation);
  const gp_Circ circle = curve.Circle();
  const double sweep = of.range.to - of.range.from;
  const bool whole = sweep > 2 * std::numbers::pi * (1 - 1e-12);
  return {.kind = whole ? StrokeKind::Circle : StrokeKind::Arc,
          .from = from,
          .to = to,
          .centre = frame.of(vec(circle.Location().XYZ())),
          .radius = circle.Radius(),
          .counter_clockwise = dot(vec(circle.Axis().Direction().XYZ()), frame.normal) > 0,
          .sweep = sweep};
}

Stroke reversed(Stroke stroke) {
  std::swap(stroke.from, stroke.to);
  stroke.counter_clockwise = !stroke.counter_clockwise;
  std::ranges::reverse(stroke.points);
  return stroke;
}

}  // namespace

DrawingFrame::DrawingFrame(const occt::Plane& plane) : normal(unit(plane.normal)) {
  origin = normal * dot(normal, plane.point);
  constexpr double kUpright = 1e-9;  // of a unit normal: a plane that has no z to speak of
  const bool level = std::abs(normal[0]) < kUpright && std::abs(normal[1]) < kUpright;
  const Vec3 up = level ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  y = unit(up - normal * dot(up, normal));
  x = cross(y, normal);
}

DrawnPart drawn(const occt::PlaneSection& section, const DrawingFrame& frame, double deviation) {
  DrawnPart part;
  for (const occt::SectionWire& wire : section.wires) {
    DrawnWire made{.strokes = {}, .closed = wire.closed, .bounding = wire.bounding};
    for (const occt::CurveUse& use : wire.uses) {
      Stroke stroke = forward_stroke(section.curves[use.curve], frame, deviation);
      made.strokes.push_back(use.forward ? std::move(stroke) : reversed(std::move(stroke)));
    }
    part.wires.push_back(std::move(made));
  }
  for (const std::size_t node : section.points)
    part.points.push_back(frame.of(section.nodes[node].point));
  return part;
}

void DrawingBox::add(const Vec2& point) {
  for (int k = 0; k < 2; ++k) {
    low[k] = std::min(low[k], point[k]);
    high[k] = std::max(high[k], point[k]);
  }
}

// By points on it; what bulges out between them is less than a pen is wide.
void DrawingBox::add_arc(const Stroke& arc) {
  constexpr int kSteps = 32;
  const Vec2 start = arc.from - arc.centre;
  for (int i = 1; i < kSteps; ++i) {
    const double angle = (arc.counter_clockwise ? 1 : -1) * arc.sweep * i / kSteps;
    const double c = std::cos(angle), s = std::sin(angle);
    add(arc.centre + Vec2{c * start[0] - s * start[1], s * start[0] + c * start[1]});
  }
}

void DrawingBox::add(const DrawnPlane& plane) {
  for (const DrawnPart& part : plane.parts) {
    for (const Vec2& point : part.points) add(point);
    for (const DrawnWire& wire : part.wires)
      for (const Stroke& stroke : wire.strokes) {
        if (stroke.kind != StrokeKind::Circle) add(stroke.from);
        if (stroke.kind != StrokeKind::Circle) add(stroke.to);
        for (const Vec2& point : stroke.points) add(point);
        if (stroke.kind == StrokeKind::Circle)
          for (const double side : {-1.0, 1.0})
            add(stroke.centre + Vec2{side * stroke.radius, side * stroke.radius});
        if (stroke.kind == StrokeKind::Arc) add_arc(stroke);
      }
  }
}

}  // namespace blossom::drawings
