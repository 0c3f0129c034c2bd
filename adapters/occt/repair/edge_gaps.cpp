// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/edge_gaps.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/convert/curve_breaks.h"
#include "adapters/occt/convert/edge_charts.h"
#include "core/base/unbounded.h"
#include "core/math/functions/golden_section.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

// Choices: of a span, whose gap has few bends, and of an edge of one span, as BRepCheck takes 23.
constexpr int kSamplesPerSpan = 12;
constexpr int kMinSamples = 96;
constexpr double kShift = 0.381966;    // of samples, as a part of their distance
constexpr int kMinSamplesOfArcs = 16;  // of sines and cosines once and twice a turn
constexpr double kStraight = 1e-9;     // sine: a line in the chart that runs along a direction
constexpr double kRefined = 1e-8;      // of the distance of two samples: where a gap is largest
constexpr int kNewtonSteps = 8;        // from a foot that is near: each doubles its digits

double finite_or_infinite(double length) { return std::isfinite(length) ? length : kInfinity; }

// The curves of an edge on a face; `place` is the range of the pcurve, `range` that of the other.
struct Curves {
  Handle(Geom_Curve) space;
  Handle(Geom2d_Curve) chart;
  Handle(Geom_Surface) surface;
  Interval range;
  Interval place;

  gp_Pnt image(double t) const {
    const gp_Pnt2d uv = chart->Value(at(place, t));
    return surface->Value(uv.X(), uv.Y());
  }
  double same_parameter(double t) const {
    return finite_or_infinite(space->Value(at(range, t)).Distance(image(t)));
  }
};

// The distance from the image at t to the curve near it, by Newton's method from t.
double gap_at(const Curves& curves, double t) {
  const gp_Pnt target = curves.image(t);
  double least = curves.same_parameter(t), s = at(curves.range, t);
  if (!std::isfinite(least)) return least;
  for (int step = 0; step < kNewtonSteps; ++step) {
    gp_Pnt point;
    gp_Vec first, second;
    curves.space->D2(s, point, first, second);
    const gp_Vec off(target, point);
    const double slope = first.SquareMagnitude() + off.Dot(second);
    if (!(slope > 0)) break;
    s = std::clamp(s - off.Dot(first) / slope, curves.range.from, curves.range.to);
    const double distance = curves.space->Value(s).Distance(target);
    if (!(distance < least)) break;
    least = distance;
  }
  return least;
}

void add_fractions(const std::vector<double>& breaks, const Interval& range,
                   std::vector<double>& knots) {
  for (const double value : breaks) knots.push_back((value - range.from) / (range.to - range.from));
}

bool is_arc(GeomAbs_CurveType type) {
  return type == GeomAbs_Line || type == GeomAbs_Circle || type == GeomAbs_Ellipse;
}

// Along a parameter line of a plane, quadric or torus, or an arc in a plane, against an arc: what
// is between them has no more than sines and cosines of the parameter.
bool are_arcs(const Curves& curves) {
  if (curves.space.IsNull() || !is_arc(GeomAdaptor_Curve(curves.space).GetType())) return false;
  const Geom2dAdaptor_Curve chart(curves.chart);
  const GeomAbs_SurfaceType surface = GeomAdaptor_Surface(curves.surface).GetType();
  if (surface == GeomAbs_Plane) return is_arc(chart.GetType());
  if (surface != GeomAbs_Cylinder && surface != GeomAbs_Cone && surface != GeomAbs_Sphere &&
      surface != GeomAbs_Torus)
    return false;
  if (chart.GetType() != GeomAbs_Line) return false;
  const gp_Dir2d along = chart.Line().Direction();
  return std::min(std::abs(along.X()), std::abs(along.Y())) <= kStraight;
}

// Straight lines on a plane, with parameters in one ratio: what is between them is largest at an
// end.
bool are_lines(const Curves& curves) {
  return !curves.space.IsNull() && GeomAdaptor_Curve(curves.space).GetType() == GeomAbs_Line &&
         GeomAdaptor_Surface(curves.surface).GetType() == GeomAbs_Plane &&
         Geom2dAdaptor_Curve(curves.chart).GetType() == GeomAbs_Line;
}

// Fractions of the ranges, increasing, from 0 to 1. Curves are interpolated at simple fractions of
// their spans, where gaps vanish, so samples lie elsewhere.
std::vector<double> sample_places(const Curves& curves) {
  if (are_lines(curves)) return {0, 1};
  std::vector<double> knots{0, 1};
  if (!curves.space.IsNull())
    add_fractions(breaks_of(curves.space, curves.range), curves.range, knots);
  add_fractions(breaks_of(curves.chart, curves.place), curves.place, knots);
  std::sort(knots.begin(), knots.end());
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  const int spans = static_cast<int>(knots.size()) - 1;
  const int each =
      are_arcs(curves) ? kMinSamplesOfArcs : std::max(kSamplesPerSpan, kMinSamples / spans);
  std::vector<double> places{0};
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Interval span{std::clamp(knots[i], 0.0, 1.0), std::clamp(knots[i + 1], 0.0, 1.0)};
    for (int k = 1; span.to > span.from && k <= each; ++k)
      places.push_back(at(span, (k - kShift) / each));
    places.push_back(span.to);
  }
  return places;
}

// The largest value at the places, refined between the neighbours of the largest unless that is
// nothing to speak of.
template <class Function>
double largest(const std::vector<double>& places, const Function& value_at, double least = 0) {
  std::size_t best = 0;
  double most = -1;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const double value = value_at(places[i]); value > most) {
      most = value;
      best = i;
    }
  const Interval around{places[best > 0 ? best - 1 : 0],
                        places[std::min(best + 1, places.size() - 1)]};
  if (most < least || !std::isfinite(most)) return most;
  return std::max(most, extremum(value_at, around, -1, kRefined).value);
}

void add_end(const TopoDS_Vertex& vertex, const gp_Pnt& end, EdgeGaps& gaps) {
  const double gap = finite_or_infinite(BRep_Tool::Pnt(vertex).Distance(end));
  const double tolerance = BRep_Tool::Tolerance(vertex);
  if (gaps.vertex_tolerance > 0 && gap * gaps.vertex_tolerance <= gaps.vertex_gap * tolerance)
    return;
  gaps.vertex_gap = gap;
  gaps.vertex_tolerance = tolerance;
}

void measure_ends(const TopoDS_Edge& edge, const Curves& curves, EdgeGaps& gaps) {
  const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
  for (const auto& [vertex, t] : {std::pair{first, 0.0}, std::pair{last, 1.0}}) {
    if (vertex.IsNull()) continue;
    if (!curves.space.IsNull()) add_end(vertex, curves.space->Value(at(curves.range, t)), gaps);
    if (!curves.chart.IsNull() && !curves.surface.IsNull()) add_end(vertex, curves.image(t), gaps);
  }
}

Curves curves_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  Curves curves;
  curves.space = BRep_Tool::Curve(edge, curves.range.from, curves.range.to);
  curves.chart = chart_curve_of(edge, face, curves.place);
  curves.surface = BRep_Tool::Surface(face);
  return curves;
}

}  // namespace

std::optional<double> same_parameter_gap(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                         double least) {
  const Curves curves = curves_of(edge, face);
  if (curves.space.IsNull() || curves.chart.IsNull() || curves.surface.IsNull()) return {};
  return largest(
      sample_places(curves), [&](double t) { return curves.same_parameter(t); },
      are_arcs(curves) ? least : 0);
}

EdgeGaps edge_gaps(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  const Curves curves = curves_of(edge, face);
  EdgeGaps gaps;
  const bool degenerated = BRep_Tool::Degenerated(edge);
  gaps.has_curve = degenerated || !curves.space.IsNull();
  gaps.has_pcurve = !curves.chart.IsNull();
  measure_ends(edge, curves, gaps);
  if (!gaps.has_pcurve || curves.surface.IsNull()) return gaps;
  const std::vector<double> places = sample_places(curves);
  if (!curves.space.IsNull()) {
    gaps.same_parameter = largest(places, [&](double t) { return curves.same_parameter(t); });
    gaps.gap = largest(places, [&](double t) { return gap_at(curves, t); });
  } else if (const TopoDS_Vertex pole = TopExp::FirstVertex(edge); degenerated && !pole.IsNull()) {
    const gp_Pnt point = BRep_Tool::Pnt(pole);
    gaps.gap = gaps.same_parameter = largest(
        places, [&](double t) { return finite_or_infinite(point.Distance(curves.image(t))); });
  }
  return gaps;
}

}  // namespace blossom::occt
