// SPDX-License-Identifier: LGPL-2.1-or-later
// Bezier curves and splines, number by number.

#include "adapters/occt/convert/curves.h"

#include <algorithm>

#include <BRep_CurveRepresentation.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves_detail.h"

namespace blossom::occt {
namespace {

TColStd_Array1OfInteger multiplicity_array(const std::vector<int>& multiplicities) {
  TColStd_Array1OfInteger array(1, static_cast<int>(multiplicities.size()));
  std::copy(multiplicities.begin(), multiplicities.end(), array.begin());
  return array;
}

}  // namespace

RationalBezierCurve from_occt(const Geom_BezierCurve& curve) {
  check_numbers(curve);
  RationalBezierCurve result;
  for (int i = 1; i <= curve.NbPoles(); ++i)
    result.points.push_back(homogeneous(curve.Pole(i), curve.IsRational() ? curve.Weight(i) : 1));
  return result;
}

Handle(Geom_BezierCurve) to_occt(const RationalBezierCurve& curve) {
  const int count = curve.degree() + 1;
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal weights(1, count);
  bool rational = false;
  for (int i = 1; i <= count; ++i) {
    const Vec4& point = curve.points[static_cast<std::size_t>(i - 1)];
    poles(i) = euclidean(point);
    weights(i) = point[3];
    rational = rational || point[3] != 1;
  }
  return guarded("making a Bezier curve", [&]() -> Handle(Geom_BezierCurve) {
    if (rational) return new Geom_BezierCurve(poles, weights);
    return new Geom_BezierCurve(poles);
  });
}

Handle(Geom_BSplineCurve) to_occt(const Spline& spline) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(spline.points.size()));
  std::transform(spline.points.begin(), spline.points.end(), poles.begin(), pnt);
  return guarded("making a B-spline curve", [&]() -> Handle(Geom_BSplineCurve) {
    return new Geom_BSplineCurve(poles, knot_array(spline.knots),
                                 multiplicity_array(spline.multiplicities), spline.degree);
  });
}

Handle(Geom2d_BSplineCurve) to_occt(const Spline2& spline) {
  TColgp_Array1OfPnt2d poles(1, static_cast<int>(spline.points.size()));
  std::transform(spline.points.begin(), spline.points.end(), poles.begin(),
                 [](const Vec2& p) { return gp_Pnt2d(p[0], p[1]); });
  return guarded("making a B-spline curve in a chart", [&]() -> Handle(Geom2d_BSplineCurve) {
    return new Geom2d_BSplineCurve(poles, knot_array(spline.knots),
                                   multiplicity_array(spline.multiplicities), spline.degree);
  });
}

Handle(Geom_Curve) to_occt(const Conic& conic) {
  return guarded("making a conic", [&]() -> Handle(Geom_Curve) {
    const gp_Pnt centre = pnt(conic.centre);
    const gp_Dir x(conic.x[0], conic.x[1], conic.x[2]);
    if (conic.kind == ConicKind::Line) return new Geom_Line(centre, x);
    const Vec3 normal = cross(conic.x, conic.y);
    const gp_Ax2 axes(centre, gp_Dir(normal[0], normal[1], normal[2]), x);
    switch (conic.kind) {
      case ConicKind::Circle: return new Geom_Circle(axes, conic.major);
      case ConicKind::Parabola: return new Geom_Parabola(axes, conic.major);
      case ConicKind::Hyperbola: return new Geom_Hyperbola(axes, conic.major, conic.minor);
      default: return new Geom_Ellipse(axes, conic.major, conic.minor);
    }
  });
}

Handle(Geom_Curve) basis_of(Handle(Geom_Curve) curve) {
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
    curve = trimmed->BasisCurve();
  return curve;
}

Handle(Geom2d_Curve) basis_of(Handle(Geom2d_Curve) curve) {
  while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve))
    curve = trimmed->BasisCurve();
  return curve;
}

namespace {

template <class Spline, class Curve>
opencascade::handle<Spline> part_of(const Curve& curve, const Interval& range) {
  const auto spline = opencascade::handle<Spline>::DownCast(basis_of(curve));
  if (spline.IsNull() || !spline->IsPeriodic()) return {};
  if (spline->FirstParameter() <= range.from && range.to <= spline->LastParameter()) return {};
  const auto part = opencascade::handle<Spline>::DownCast(spline->Copy());
  part->Segment(range.from, std::min(range.to, range.from + spline->Period()));
  TColStd_Array1OfReal knots(1, part->NbKnots());
  part->Knots(knots);
  const double moved = range.from - part->FirstParameter();  // the cut is in the first period
  for (double& knot : knots) knot += moved;
  part->SetKnots(knots);
  return part;
}

}  // namespace

Handle(Geom_BSplineCurve)
    part_beyond_period(const Handle(Geom_Curve) & curve, const Interval& range) {
  return part_of<Geom_BSplineCurve>(curve, range);
}

Handle(Geom2d_BSplineCurve)
    part_beyond_period(const Handle(Geom2d_Curve) & curve, const Interval& range) {
  return part_of<Geom2d_BSplineCurve>(curve, range);
}

void leave_periods(const TopoDS_Edge& edge) {
  for (const Handle(BRep_CurveRepresentation) & each :
       Handle(BRep_TEdge)::DownCast(edge.TShape())->Curves()) {
    const auto curve = Handle(BRep_GCurve)::DownCast(each);
    if (curve.IsNull()) continue;
    const Interval range{curve->First(), curve->Last()};
    if (curve->IsCurve3D()) {
      if (curve->Curve3D().IsNull()) continue;
      if (const auto part = part_beyond_period(curve->Curve3D(), range)) curve->Curve3D(part);
      continue;
    }
    if (const auto part = part_beyond_period(curve->PCurve(), range)) curve->PCurve(part);
    if (!curve->IsCurveOnClosedSurface()) continue;
    if (const auto part = part_beyond_period(curve->PCurve2(), range)) curve->PCurve2(part);
  }
}

namespace {

constexpr double kLengthError = 1e-7;  // asked of Open CASCADE's adaptive rule, part of the length

}  // namespace

// Without an error that is asked for, Open CASCADE's rule has a few points for the whole curve, and
// errs by 0.5 % on an ellipse.
double curve_length(const Adaptor3d_Curve& curve, const Interval& range) {
  return GCPnts_AbscissaPoint::Length(curve, range.from, range.to, kLengthError);
}

double edge_length(const TopoDS_Edge& edge) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (curve.IsNull()) return Precision::Infinite();
  if (const auto part = part_beyond_period(curve, range))
    return curve_length(GeomAdaptor_Curve(part), range);
  return curve_length(GeomAdaptor_Curve(curve), range);
}

}  // namespace blossom::occt
