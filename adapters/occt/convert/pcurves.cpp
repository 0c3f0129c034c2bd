// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/convert/pcurves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <BndLib_Add2dCurve.hxx>
#include <Bnd_Box2d.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2dConvert_ApproxCurve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/curves_detail.h"
#include "core/forms/spans/arc_spans.h"

namespace blossom::occt {
namespace {

// Of curves without a form as splines, which are fitted: of their size, far below what tolerances
// of edges leave; and their spans, a choice.
constexpr double kRelativeError = 1e-9;
constexpr int kMaxChartSpans = 400;

// C(a) = centre + cos a * x + sin a * y, over the range of the angle, in arcs of at most a
// quarter; the middle weight of an arc of half angle h is cos h.
PlanarCurve conic(const Vec2& centre, const Vec2& x, const Vec2& y, const Interval& range) {
  const int count = std::max(
      1, static_cast<int>(std::ceil(length(range) / (std::numbers::pi / 2) - kQuarterSlack)));
  PlanarCurve curve;
  for (int k = 0; k < count; ++k) {
    const Interval place{at(range, static_cast<double>(k) / count),
                         at(range, static_cast<double>(k + 1) / count)};
    const double w = std::cos(0.5 * length(place)), middle = at(place, 0.5);
    const auto point = [&](double angle, double stretch, double weight) {
      const Vec2 p = centre + stretch * (std::cos(angle) * x + std::sin(angle) * y);
      return Vec3{weight * p[0], weight * p[1], weight};
    };
    curve.spans.push_back(
        {{{point(place.from, 1, 1), point(middle, 1 / w, w), point(place.to, 1, 1)}},
         place,
         ParameterLaw::Angle});
  }
  return curve;
}

PlanarCurve spans(const Handle(Geom2d_BSplineCurve) & given, const Interval& range) {
  Interval reach = range;
  if (!given->IsPeriodic()) {  // an edge's range may exceed its curve by rounding
    reach = {std::max(range.from, given->FirstParameter()),
             std::min(range.to, given->LastParameter())};
    if (!(reach.from < reach.to))
      throw BadModel("the range of an edge lies outside of its parametric curve");
  }
  std::vector<Vec4> poles;
  for (int i = 1; i <= given->NbPoles(); ++i) {
    const gp_Pnt2d p = given->Pole(i);
    poles.push_back(homogeneous({p.X(), p.Y(), 0}, given->IsRational() ? given->Weight(i) : 1));
  }
  TColStd_Array1OfReal knots(1, given->NbKnots());
  TColStd_Array1OfInteger multiplicities(1, given->NbKnots());
  given->Knots(knots);
  given->Multiplicities(multiplicities);
  const FlatKnots flat = flat_knots(given->Degree(), knots, multiplicities, given->IsPeriodic());
  PlanarCurve curve;
  std::vector<Vec4> local(static_cast<std::size_t>(given->Degree()) + 1), points(local.size());
  for (const FlatKnots::Span& span : spans_in(flat, reach)) {
    for (std::size_t i = 0; i < local.size(); ++i)
      local[i] = poles[static_cast<std::size_t>(
          flat.pole(span.index - given->Degree() + static_cast<int>(i)))];
    SpanForm(flat, span).bezier_points(local.data(), points.data());
    PlanarBezier bezier;
    for (const Vec4& p : points) bezier.points.push_back({p[0], p[1], p[3]});
    curve.spans.push_back({std::move(bezier), span.place, ParameterLaw::Linear});
  }
  curve.spans.front().place.from = range.from;
  curve.spans.back().place.to = range.to;
  return curve;
}

// Keeps the parameter, which an exact conversion of a hyperbola, say, would not.
PlanarCurve approximated(const Handle(Geom2d_Curve) & curve, const Interval& range) {
  const Handle(Geom2d_TrimmedCurve) trimmed = new Geom2d_TrimmedCurve(curve, range.from, range.to);
  constexpr double kMinChart = 1e-6;  // units of the chart: smaller curves are fitted no better
  const double size = curve->Value(range.from).Distance(curve->Value(range.to)) +
                      curve->Value(range.from).Distance(curve->Value(at(range, 0.5)));
  Geom2dConvert_ApproxCurve convert(trimmed, kRelativeError * std::max(size, kMinChart), GeomAbs_C1,
                                    kMaxChartSpans, 8);
  if (!convert.HasResult())
    throw BadModel(std::string("a parametric curve of type ") + curve->DynamicType()->Name() +
                   " cannot be converted");
  return spans(convert.Curve(), range);
}

constexpr double kRounding = 0x1p-50;  // of the largest coordinate: a few steps of arithmetic

// The end of a line, on the isoparametric line of its start if only rounding takes it off that.
Vec2 without_rounding(const Vec2& from, Vec2 to, const Vec2& scale) {
  double largest = 0;
  for (int k = 0; k < 2; ++k)
    largest = std::max(largest, scale[k] * std::max(std::abs(from[k]), std::abs(to[k])));
  for (int k = 0; k < 2; ++k)
    if (scale[k] * std::abs(to[k] - from[k]) <= kRounding * largest) to[k] = from[k];
  return to;
}

// Open CASCADE's adaptors take a line at so small an angle for the isoparametric line of its start.
// On a cylinder of radius 4000, after 3000, that is 1e-5 beside it.
bool looks_isoparametric(const Vec2& rate) {
  constexpr double kSine = 2e-12;  // twice Precision::Angular(), which is no constant expression
  return std::ranges::any_of(std::array{rate[0], rate[1]},
                             [](double part) { return part != 0 && std::abs(part) <= kSine; });
}

}  // namespace

bool is_periodic_spline(const Handle(Geom2d_Curve) & curve) {
  const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(basis_of(curve));
  return !spline.IsNull() && spline->IsPeriodic();
}

std::array<Interval, 2> bounds_of(const Handle(Geom2d_Curve) & curve, const Interval& range) {
  Bnd_Box2d box;
  if (const auto part = part_beyond_period(curve, range)) {
    BndLib_Add2dCurve::Add(part, 0, box);
  } else {
    BndLib_Add2dCurve::Add(curve, range.from, range.to, 0, box);
  }
  std::array<Interval, 2> bounds;
  box.Get(bounds[0].from, bounds[1].from, bounds[0].to, bounds[1].to);
  return bounds;
}

PlanarCurve planar_curve(const Handle(Geom2d_Curve) & curve, const Interval& range) {
  if (!std::isfinite(range.from) || !std::isfinite(range.to) || !(range.from < range.to))
    throw BadModel("an edge has an empty or infinite parameter range");
  if (curve->IsKind(STANDARD_TYPE(Geom2d_TrimmedCurve)))
    return planar_curve(basis_of(curve), range);
  if (const auto line = Handle(Geom2d_Line)::DownCast(curve); !line.IsNull())
    return planar_line(vec(line->Value(range.from)), vec(line->Value(range.to)), range);
  if (const auto circle = Handle(Geom2d_Circle)::DownCast(curve); !circle.IsNull()) {
    const Vec2 centre = vec(circle->Location());
    return conic(centre, vec(circle->Value(0)) - centre,
                 vec(circle->Value(std::numbers::pi / 2)) - centre, range);
  }
  if (const auto ellipse = Handle(Geom2d_Ellipse)::DownCast(curve); !ellipse.IsNull()) {
    const Vec2 centre = vec(ellipse->Location());
    return conic(centre, vec(ellipse->Value(0)) - centre,
                 vec(ellipse->Value(std::numbers::pi / 2)) - centre, range);
  }
  if (const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve); !spline.IsNull())
    return spans(spline, range);
  if (const auto single = Handle(Geom2d_BezierCurve)::DownCast(curve); !single.IsNull())
    return spans(Geom2dConvert::CurveToBSplineCurve(single), range);
  return approximated(curve, range);
}

Handle(Geom2d_Curve) simplest_to_occt(const Spline2& spline, const Vec2& scale) {
  if (!is_even_line(spline)) return to_occt(without_idle_knots(spline));
  const Interval domain = spline.domain();
  const Vec2 from = spline.points.front();
  const Vec2 to = without_rounding(from, spline.points.back(), scale);
  const Vec2 rate = (1 / length(domain)) * (to - from);
  if (std::abs(norm(rate) - 1) > kEvenLine || looks_isoparametric(rate))
    return to_occt(Spline2{1, {domain.from, domain.to}, {2, 2}, {from, to}});
  const Vec2 start = from - domain.from * rate;
  return new Geom2d_Line({start[0], start[1]}, {rate[0], rate[1]});
}

}  // namespace blossom::occt
