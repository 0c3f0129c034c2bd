// SPDX-License-Identifier: LGPL-2.1-or-later
// Any curve as Bezier spans.

#include <algorithm>
#include <cmath>
#include <utility>

#include <BRep_Tool.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <GeomAPI.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <gp.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/curves_detail.h"
#include "core/forms/spans/arc_spans.h"
#include "core/forms/spans/fitted_spans.h"

namespace blossom::occt {
namespace {

CurveSpans polynomial(const std::vector<Vec3>& points, const Interval& place) {
  RationalBezierCurve curve;
  for (const Vec3& p : points) curve.points.push_back(with_weight(p, 1));
  return {{{std::move(curve), place, ParameterLaw::Linear}}};
}

CurveSpans line_spans(const Geom_Line& line, const Interval& range) {
  return polynomial({vec(line.Value(range.from)), vec(line.Value(range.to))}, range);
}

/// P(t) = O + t^2 / (4 f) X + t Y; the middle Bezier point has t^2 -> t0 t1.
CurveSpans parabola_spans(const Geom_Parabola& parabola, const Interval& range) {
  const gp_Parab shape = parabola.Parab();
  const Vec3 origin = vec(shape.Location());
  const Vec3 x = vec(shape.XAxis().Direction().XYZ()) * (1 / (4 * shape.Focal()));
  const Vec3 y = vec(shape.YAxis().Direction().XYZ());
  const double t0 = range.from, t1 = range.to;
  const Vec3 middle = origin + (t0 * t1) * x + ((t0 + t1) / 2) * y;
  return polynomial({vec(parabola.Value(t0)), middle, vec(parabola.Value(t1))}, range);
}

CurveSpans conic_spans(const gp_Ax2& axes, double a, double b, const Interval& range,
                       ArcCuts cuts) {
  return ellipse_spans(vec(axes.Location()), a * vec(axes.XDirection().XYZ()),
                       b * vec(axes.YDirection().XYZ()), range, cuts);
}

CurveSpans bspline_spans(const Geom_BSplineCurve& curve, const Interval& range) {
  std::vector<Vec4> poles;
  for (int i = 1; i <= curve.NbPoles(); ++i)
    poles.push_back(homogeneous(curve.Pole(i), curve.IsRational() ? curve.Weight(i) : 1));
  const FlatKnots knots =
      flat_knots(curve.Degree(), curve.Knots(), curve.Multiplicities(), curve.IsPeriodic());
  return spline_spans(knots, spans_in(knots, range), poles);
}

// Here and below the words of a message are made only where there is one to write.
CurveSpans fitted_curve(const Handle(Geom_Curve) & curve, const Interval& range, double tolerance) {
  const GeomAdaptor_Curve adaptor(curve, range.from, range.to);
  TColStd_Array1OfReal found(1, adaptor.NbIntervals(GeomAbs_CN) + 1);
  adaptor.Intervals(found, GeomAbs_CN);
  std::vector<double> breaks(found.begin(), found.end());
  breaks.front() = range.from;
  breaks.back() = range.to;
  const auto value = [&](double t) {
    const gp_XYZ point = curve->Value(t).XYZ();
    if (!is_finite(point)) check_finite(point, "the curve at " + std::to_string(t));
    return vec(point);
  };
  return fitted_spans(value, breaks, tolerance);
}

CurveSpans spans_of(const Handle(Geom_Curve) & curve, const Interval& range, double tolerance,
                    ArcCuts cuts) {
  if (const auto line = Handle(Geom_Line)::DownCast(curve); !line.IsNull())
    return line_spans(*line, range);
  if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull())
    return conic_spans(circle->Position(), circle->Radius(), circle->Radius(), range, cuts);
  if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve); !ellipse.IsNull())
    return conic_spans(ellipse->Position(), ellipse->MajorRadius(), ellipse->MinorRadius(), range,
                       cuts);
  if (const auto parabola = Handle(Geom_Parabola)::DownCast(curve); !parabola.IsNull())
    return parabola_spans(*parabola, range);
  if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(curve); !bezier.IsNull()) {
    const RationalBezierCurve whole = from_occt(*bezier);
    if (range == Interval{0, 1}) return curve_spans(whole);
    const FlatKnots knots(bezier->Degree());
    return spline_spans(knots, spans_in(knots, range), whole.points);
  }
  if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve); !spline.IsNull())
    return bspline_spans(*spline, range);
  return fitted_curve(curve, range, tolerance);
}

template <class Curve>
void check_poles(const Curve& curve) {
  const bool rational = curve.IsRational();
  WeightRange weights;
  for (int i = 1; i <= curve.NbPoles(); ++i) {
    const gp_XYZ pole = curve.Pole(i).XYZ();
    if (!is_bounded(pole)) check_bounded(pole, "control point " + std::to_string(i));
    if (!rational) continue;
    const double weight = curve.Weight(i);
    if (!(weight > 0 && std::isfinite(weight))) check_weight(weight, "weight " + std::to_string(i));
    weights.add(weight);
  }
  weights.check();
}

// (wx, wy, 0, w); numbers that are not finite are refused where curves are checked.
RationalBezierCurve points_of(const Geom2d_BezierCurve& curve) {
  RationalBezierCurve result;
  result.points.reserve(static_cast<std::size_t>(curve.NbPoles()));
  for (int i = 1; i <= curve.NbPoles(); ++i) {
    const gp_Pnt2d p = curve.Pole(i);
    const double w = curve.Weight(i);
    result.points.push_back({w * p.X(), w * p.Y(), 0, w});
  }
  return result;
}

}  // namespace

void check_numbers(const Geom_Curve& curve) {
  if (const auto* bezier = dynamic_cast<const Geom_BezierCurve*>(&curve)) {
    check_poles(*bezier);
  } else if (const auto* spline = dynamic_cast<const Geom_BSplineCurve*>(&curve)) {
    check_poles(*spline);
    for (int i = 1; i <= spline->NbKnots(); ++i)
      check_finite({spline->Knot(i), 0, 0}, "knot " + std::to_string(i));
  } else if (const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(&curve)) {
    check_numbers(*trimmed->BasisCurve());
  } else if (const auto* offset = dynamic_cast<const Geom_OffsetCurve*>(&curve)) {
    check_finite({offset->Offset(), 0, 0}, "the offset");
    check_numbers(*offset->BasisCurve());
  } else {
    check_bounded(curve.Value(0.5).XYZ(), "a number of the curve");
  }
}

CurveSpans profile_spans(const Handle(Geom_Curve) & curve, const Interval& range, double tolerance,
                         ArcCuts cuts) {
  if (curve.IsNull()) throw BadModel("there is no curve");
  return guarded("converting a curve", [&] {
    const Handle(Geom_Curve) basis = basis_of(curve);
    check_numbers(*basis);
    Interval natural{basis->FirstParameter(), basis->LastParameter()};
    if (basis->IsPeriodic()) natural = {-Precision::Infinite(), Precision::Infinite()};
    return spans_of(basis, checked_range(range, natural, "the curve's range"), tolerance, cuts);
  });
}

CurveSpans bezier_spans(const Handle(Geom_Curve) & curve, const Interval& range, double tolerance) {
  const auto hyperbola =
      curve.IsNull() ? Handle(Geom_Hyperbola)() : Handle(Geom_Hyperbola)::DownCast(basis_of(curve));
  if (hyperbola.IsNull()) return profile_spans(curve, range, tolerance);
  return guarded("converting a curve", [&] {
    check_numbers(*hyperbola);
    const Interval natural{hyperbola->FirstParameter(), hyperbola->LastParameter()};
    const gp_Ax2 axes = hyperbola->Position();
    return hyperbola_spans(vec(axes.Location()),
                           hyperbola->MajorRadius() * vec(axes.XDirection().XYZ()),
                           hyperbola->MinorRadius() * vec(axes.YDirection().XYZ()),
                           checked_range(range, natural, "the curve's range"));
  });
}

CurveSpans bezier_spans(const Handle(Geom2d_Curve) & curve, const Interval& range,
                        double tolerance) {
  if (curve.IsNull()) throw BadModel("there is no curve in the plane");
  // Bezier curves go without the detour, which takes longer than an intersection.
  const auto bezier = Handle(Geom2d_BezierCurve)::DownCast(curve);
  if (!bezier.IsNull() && range == Interval{0, 1}) return curve_spans(points_of(*bezier));
  const Handle(Geom_Curve) lifted = guarded(
      "lifting a curve into space", [&] { return GeomAPI::To3d(curve, gp_Pln(gp::XOY())); });
  return bezier_spans(lifted, range, tolerance);
}

CurveSpans bezier_spans(const TopoDS_Edge& edge, double tolerance) {
  Interval range;
  if (edge.IsNull()) throw BadModel("there is no edge");
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (curve.IsNull()) throw BadModel("an edge has no curve in space");
  return bezier_spans(curve, range, tolerance);
}

}  // namespace blossom::occt
