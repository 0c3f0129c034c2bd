// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/whole.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <sstream>
#include <utility>

#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/blossom/curve_blossom.h"
#include "core/blossom/patch_blossom.h"

namespace blossom::nets {
namespace {

struct Knot {
  double at = 0;
  int multiplicity = 0;
};

// One direction of the source: spans between knots, and how often each inner knot counts.
struct SourceDirection {
  std::vector<double> knots;
  ParameterLaw law = ParameterLaw::Linear;
  int degree = 1;
  std::vector<Knot> own{};  // of a B-spline; none: spans meet in knots of full multiplicity
  bool is_bezier = false;   // has no inner knots
  double period = 0;

  double room() const { return kOneKnot * (knots.back() - knots.front()); }

  int multiplicity(double knot) const {
    if (is_bezier) return 0;
    if (own.empty()) return degree;
    for (const Knot& each : own) {
      const double off = knot - each.at;
      const double turns = period > 0 ? std::round(off / period) * period : 0;
      if (std::abs(off - turns) <= room()) return std::min(each.multiplicity, degree);
    }
    return 0;  // spans were halved there
  }
};

// One direction of the result: its knots one by one, and for each pole the span that gives it with
// the parameters of its blossom there.
struct PoleRule {
  std::size_t span = 0;
  std::vector<double> parameters;  // local, p of them
};

struct WholeDirection {
  int degree = 1;
  std::vector<Knot> knots{};
  std::vector<PoleRule> poles{};
};

// The parameter of a span at one of the source; beyond its ends it goes on.
double local(const SourceDirection& of, std::size_t span, double parameter) {
  const Interval place{of.knots[span], of.knots[span + 1]};
  if (of.law == ParameterLaw::Linear) return (parameter - place.from) / (place.to - place.from);
  return local_parameter(of.law, place, std::clamp(parameter, place.from, place.to));
}

// The span in the middle of a stretch, which is not empty.
std::size_t span_within(const SourceDirection& of, double from, double to) {
  const double middle = 0.5 * (from + to);
  const auto next = std::upper_bound(of.knots.begin() + 1, of.knots.end() - 1, middle);
  return static_cast<std::size_t>(next - of.knots.begin()) - 1;
}

WholeDirection whole(const SourceDirection& of, const Interval& place) {
  const int p = of.degree;
  WholeDirection made{.degree = p, .knots = {{place.from, p + 1}}};
  for (const double knot : of.knots)
    if (knot > place.from + of.room() && knot < place.to - of.room())
      if (const int multiplicity = of.multiplicity(knot); multiplicity > 0)
        made.knots.push_back({knot, multiplicity});
  made.knots.push_back({place.to, p + 1});
  std::vector<double> flat;
  for (const Knot& knot : made.knots)
    flat.insert(flat.end(), static_cast<std::size_t>(knot.multiplicity), knot.at);
  const auto degree = static_cast<std::size_t>(p);
  for (std::size_t i = 0; i + degree + 1 < flat.size(); ++i) {
    PoleRule rule{span_within(of, flat[i], flat[i + degree + 1]), {}};
    // Of full multiplicity, the knots of a pole are the ends of one span, or of a part of it.
    if (of.law == ParameterLaw::Angle) rule.span = span_within(of, flat[i + 1], flat[i + degree]);
    for (std::size_t k = 1; k <= degree; ++k)
      rule.parameters.push_back(local(of, rule.span, flat[i + k]));
    made.poles.push_back(std::move(rule));
  }
  return made;
}

std::string text_of(const Interval& range) {
  std::ostringstream text;
  text << "[" << range.from << ", " << range.to << "]";
  return text.str();
}

// The wanted place turned forward; what is within rounding of the ends lies on them.
Interval checked(const SourceDirection& of, const std::optional<Interval>& wanted,
                 const char* name) {
  const Interval all{of.knots.front(), of.knots.back()};
  if (!wanted) return all;
  Interval place{std::min(wanted->from, wanted->to), std::max(wanted->from, wanted->to)};
  const double room = of.room();
  if (place.from < all.from - room || place.to > all.to + room)
    throw occt::BadModel(std::string(name) + " " + text_of(place) + " leaves the parameters " +
                         text_of(all));
  place = {std::max(place.from, all.from), std::min(place.to, all.to)};
  if (!(place.to - place.from > room))
    throw occt::BadModel(std::string(name) + " " + text_of(place) + " is empty");
  return place;
}

bool is_reversed(const std::optional<Interval>& wanted) {
  return wanted && wanted->from > wanted->to;
}

std::array<SourceDirection, 2> directions_of(const TopoDS_Face& face, const BezierSurface& form) {
  const RationalBezierPatch& first = form.patches(0, 0);
  std::array<SourceDirection, 2> made{SourceDirection{form.u_knots, form.u_law, first.degree_u()},
                                      SourceDirection{form.v_knots, form.v_law, first.degree_v()}};
  const Handle(Geom_Surface) surface = occt::basis_of(BRep_Tool::Surface(face));
  if (!Handle(Geom_BezierSurface)::DownCast(surface).IsNull())
    made[0].is_bezier = made[1].is_bezier = true;
  const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (spline.IsNull()) return made;
  for (int i = 1; i <= spline->NbUKnots(); ++i)
    made[0].own.push_back({spline->UKnot(i), spline->UMultiplicity(i)});
  for (int i = 1; i <= spline->NbVKnots(); ++i)
    made[1].own.push_back({spline->VKnot(i), spline->VMultiplicity(i)});
  if (spline->IsUPeriodic()) made[0].period = spline->UPeriod();
  if (spline->IsVPeriodic()) made[1].period = spline->VPeriod();
  return made;
}

struct OcctKnots {
  TColStd_Array1OfReal knots;
  TColStd_Array1OfInteger multiplicities;

  explicit OcctKnots(const WholeDirection& of)
      : knots(1, static_cast<int>(of.knots.size())),
        multiplicities(1, static_cast<int>(of.knots.size())) {
    for (std::size_t i = 0; i < of.knots.size(); ++i) {
      knots.SetValue(static_cast<int>(i) + 1, of.knots[i].at);
      multiplicities.SetValue(static_cast<int>(i) + 1, of.knots[i].multiplicity);
    }
  }
};

gp_Pnt point_of(const Vec4& p) { return {p[0] / p[3], p[1] / p[3], p[2] / p[3]}; }

Handle(Geom_BSplineSurface)
    surface_of(const BezierSurface& form, const WholeDirection& u, const WholeDirection& v) {
  const int rows = static_cast<int>(u.poles.size()), columns = static_cast<int>(v.poles.size());
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns; ++j) {
      const PoleRule& in_u = u.poles[static_cast<std::size_t>(i) - 1];
      const PoleRule& in_v = v.poles[static_cast<std::size_t>(j) - 1];
      const Vec4 pole = blossom_at(
          form.patches(static_cast<int>(in_u.span), static_cast<int>(in_v.span)),
          std::span<const double>(in_u.parameters), std::span<const double>(in_v.parameters));
      if (!(pole[3] > 0)) throw occt::BadModel("a weight would not be positive");
      poles.SetValue(i, j, point_of(pole));
      weights.SetValue(i, j, pole[3]);
    }
  const OcctKnots of_u(u), of_v(v);
  return form.rational
             ? new Geom_BSplineSurface(poles, weights, of_u.knots, of_v.knots, of_u.multiplicities,
                                       of_v.multiplicities, u.degree, v.degree)
             : new Geom_BSplineSurface(poles, of_u.knots, of_v.knots, of_u.multiplicities,
                                       of_v.multiplicities, u.degree, v.degree);
}

SourceDirection direction_of(const Handle(Geom_Curve) & given, const CurveSpans& form) {
  SourceDirection made;
  for (const CurveSpan& span : form.spans) made.knots.push_back(span.place.from);
  made.knots.push_back(form.spans.back().place.to);
  made.law = form.spans.front().law;
  made.degree = form.spans.front().curve.degree();
  const Handle(Geom_Curve) curve = occt::basis_of(given);
  made.is_bezier = !Handle(Geom_BezierCurve)::DownCast(curve).IsNull();
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  if (spline.IsNull()) return made;
  for (int i = 1; i <= spline->NbKnots(); ++i)
    made.own.push_back({spline->Knot(i), spline->Multiplicity(i)});
  if (spline->IsPeriodic()) made.period = spline->Period();
  return made;
}

Handle(Geom_BSplineCurve) curve_of(const CurveSpans& form, const WholeDirection& u) {
  const int count = static_cast<int>(u.poles.size());
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal weights(1, count);
  for (int i = 1; i <= count; ++i) {
    const PoleRule& rule = u.poles[static_cast<std::size_t>(i) - 1];
    const Vec4 pole =
        blossom_at(form.spans[rule.span].curve, std::span<const double>(rule.parameters));
    if (!(pole[3] > 0)) throw occt::BadModel("a weight would not be positive");
    poles.SetValue(i, point_of(pole));
    weights.SetValue(i, pole[3]);
  }
  const OcctKnots knots(u);
  return form.rational
             ? new Geom_BSplineCurve(poles, weights, knots.knots, knots.multiplicities, u.degree)
             : new Geom_BSplineCurve(poles, knots.knots, knots.multiplicities, u.degree);
}

reports::Json point_json(const gp_Pnt& p) { return reports::Json::array({p.X(), p.Y(), p.Z()}); }

}  // namespace

Handle(Geom_BSplineSurface) whole_surface(const TopoDS_Face& face, const NetSource& source,
                                          const std::optional<std::array<Interval, 2>>& rectangle) {
  return named(source, [&] {
    const BezierSurface form = occt::bezier_surface(face);
    const std::array<SourceDirection, 2> of = directions_of(face, form);
    const auto wanted = [&](std::size_t k) {
      return rectangle ? std::optional<Interval>((*rectangle)[k]) : std::nullopt;
    };
    Handle(Geom_BSplineSurface) made =
        surface_of(form, whole(of[0], checked(of[0], wanted(0), "the rectangle's u")),
                   whole(of[1], checked(of[1], wanted(1), "the rectangle's v")));
    if (is_reversed(wanted(0))) made->UReverse();
    if (is_reversed(wanted(1))) made->VReverse();
    return made;
  });
}

Handle(Geom_BSplineCurve) whole_curve(const TopoDS_Edge& edge, const NetSource& source,
                                      const std::optional<Interval>& interval) {
  return named(source, [&]() -> Handle(Geom_BSplineCurve) {
    Interval range;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
    if (curve.IsNull()) return {};
    const CurveSpans form = occt::profile_spans(curve, range);
    const SourceDirection of = direction_of(curve, form);
    Handle(Geom_BSplineCurve) made =
        curve_of(form, whole(of, checked(of, interval, "the interval")));
    if (is_reversed(interval)) made->Reverse();
    return made;
  });
}

reports::Json spline_json(const Geom_BSplineSurface& surface) {
  reports::Json json = {{"kind", "surface"}, {"degree", {surface.UDegree(), surface.VDegree()}}};
  for (const char* list : {"u_knots", "v_knots", "u_multiplicities", "v_multiplicities", "poles"})
    json[list] = reports::Json::array();
  for (int i = 1; i <= surface.NbUKnots(); ++i) {
    json["u_knots"].push_back(surface.UKnot(i));
    json["u_multiplicities"].push_back(surface.UMultiplicity(i));
  }
  for (int i = 1; i <= surface.NbVKnots(); ++i) {
    json["v_knots"].push_back(surface.VKnot(i));
    json["v_multiplicities"].push_back(surface.VMultiplicity(i));
  }
  const bool rational = surface.IsURational() || surface.IsVRational();
  if (rational) json["weights"] = reports::Json::array();
  for (int i = 1; i <= surface.NbUPoles(); ++i) {
    reports::Json row = reports::Json::array(), weights = reports::Json::array();
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      row.push_back(point_json(surface.Pole(i, j)));
      weights.push_back(surface.Weight(i, j));
    }
    json["poles"].push_back(row);
    if (rational) json["weights"].push_back(weights);
  }
  return json;
}

reports::Json spline_json(const Geom_BSplineCurve& curve) {
  reports::Json json = {{"kind", "curve"}, {"degree", curve.Degree()}};
  for (const char* list : {"knots", "multiplicities", "poles"}) json[list] = reports::Json::array();
  for (int i = 1; i <= curve.NbKnots(); ++i) {
    json["knots"].push_back(curve.Knot(i));
    json["multiplicities"].push_back(curve.Multiplicity(i));
  }
  for (int i = 1; i <= curve.NbPoles(); ++i) json["poles"].push_back(point_json(curve.Pole(i)));
  if (!curve.IsRational()) return json;
  json["weights"] = reports::Json::array();
  for (int i = 1; i <= curve.NbPoles(); ++i) json["weights"].push_back(curve.Weight(i));
  return json;
}

}  // namespace blossom::nets
