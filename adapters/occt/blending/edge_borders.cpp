// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/edge_borders.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomLib.hxx>
#include <Geom_Plane.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curve_breaks.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

/// How far a curve may leave a line in the parameters, or its parameter a proportional one, as a
/// part of its length there: roundings of its poles. What it leaves an iso-parameter line by goes
/// into the errors.
constexpr double kStraight = 1e-12;

/// Places looked at between breaks of the curve for where it crosses knots of the surface.
constexpr int kCrossingSamples = 32;
constexpr int kBisections = 50;

// The curve in the parameters and the surface under it, without trims.
struct Chart {
  Handle(Geom2d_Curve) curve;
  Interval place;
  Handle(Geom_Surface) surface;
  bool left = true;  ///< the face lies to the left of the curve

  Vec2 uv(double x) const { return vec(curve->Value(at(place, x))); }
};

EdgeSide side_at(const Chart& chart, double x) {
  gp_Pnt2d uv;
  gp_Vec2d along;
  chart.curve->D1(at(chart.place, x), uv, along);
  gp_Pnt point;
  gp_Vec u, v, uu, vv, uv_mixed;
  chart.surface->D2(uv.X(), uv.Y(), point, u, v, uu, vv, uv_mixed);
  return {{vec(point.XYZ()), vec(u), vec(v), vec(uu), vec(uv_mixed), vec(vv)},
          Vec2{along.X(), along.Y()} * length(chart.place),
          chart.left};
}

Chart chart_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  Chart chart;
  chart.curve = chart_curve_of(edge, face, chart.place);
  if (chart.curve.IsNull()) throw BadModel("an edge has no curve in the parameters of a face");
  chart.surface = basis_of(BRep_Tool::Surface(face));
  if (chart.surface.IsNull()) throw BadModel("a face has no surface");
  if (!std::isfinite(length(chart.place)) || !(length(chart.place) > 0))
    throw BadModel("the range of an edge is empty or not finite");
  chart.left = edge.Orientation() == TopAbs_FORWARD;
  return chart;
}

/// Where the surface is less than curvature-continuous along a parameter line, in one direction.
std::vector<double> rough_lines(const GeomAdaptor_Surface& surface, bool u) {
  const int count = u ? surface.NbUIntervals(GeomAbs_C2) : surface.NbVIntervals(GeomAbs_C2);
  TColStd_Array1OfReal all(1, count + 1);
  u ? surface.UIntervals(all, GeomAbs_C2) : surface.VIntervals(all, GeomAbs_C2);
  std::vector<double> inner;
  for (int i = 2; i <= count; ++i) inner.push_back(all(i));
  return inner;
}

double crossing(const Chart& chart, int coordinate, double line, double from, double to) {
  const bool rises = chart.uv(from)[coordinate] < line;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (from + to) / 2;
    ((chart.uv(middle)[coordinate] < line) == rises ? from : to) = middle;
  }
  return (from + to) / 2;
}

void add_crossings(const Chart& chart, int coordinate, const std::vector<double>& lines,
                   std::vector<double>& breaks) {
  if (lines.empty()) return;
  const std::vector<double> ends = breaks;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    for (int k = 0; k < kCrossingSamples; ++k) {
      const Interval span{ends[i], ends[i + 1]};
      const double from = at(span, 1.0 * k / kCrossingSamples),
                   to = at(span, (k + 1.0) / kCrossingSamples);
      const double a = chart.uv(from)[coordinate], b = chart.uv(to)[coordinate];
      for (const double line : lines)
        if ((a < line) != (b < line)) breaks.push_back(crossing(chart, coordinate, line, from, to));
    }
}

/// Of the curve and of the surface under it.
std::vector<double> breaks_of_chart(const Chart& chart) {
  std::vector<double> breaks{0, 1};
  for (const double t : breaks_of(chart.curve, chart.place))
    breaks.push_back((t - chart.place.from) / length(chart.place));
  std::sort(breaks.begin(), breaks.end());
  const GeomAdaptor_Surface surface(chart.surface);
  add_crossings(chart, 0, rough_lines(surface, true), breaks);
  add_crossings(chart, 1, rough_lines(surface, false), breaks);
  return breaks;
}

std::optional<BorderSpans> plane_spans(const Chart& chart, const Geom_Plane& plane,
                                       std::string& reason) {
  const gp_Ax3& axes = plane.Position();
  // Axes of a mirrored plane are left-handed; their mirror image in v is not.
  const auto curve = axes.Direct()
                         ? chart.curve
                         : Handle(Geom2d_Curve)::DownCast(chart.curve->Mirrored(gp::OX2d()));
  const gp_Ax2 frame(axes.Location(), axes.Direction(), axes.XDirection());
  const CurveSpans spans = profile_spans(GeomLib::To3d(frame, curve), chart.place);
  if (spans.error > 0) {
    reason = "its curve in a plane is none of lines, conics and splines";
    return {};
  }
  const Vec3 normal = vec(axes.XDirection().Crossed(axes.YDirection()).XYZ());
  return plane_border(spans, chart.left ? normal : -normal, false);
}

/// The ends of a curve that is a straight line with a proportional parameter.
struct Segment {
  Vec2 from;
  Vec2 to;
};

/// A B-spline is one if each pole is where the mean of its knots is.
bool is_proportional(const Geom2d_BSplineCurve& spline, const Interval& place,
                     const Segment& segment) {
  if (spline.IsRational() || spline.IsPeriodic()) return false;
  TColStd_Array1OfReal knots(1, spline.NbPoles() + spline.Degree() + 1);
  spline.KnotSequence(knots);
  const Vec2 whole = segment.to - segment.from;
  for (int i = 1; i <= spline.NbPoles(); ++i) {
    double mean = 0;
    for (int k = 1; k <= spline.Degree(); ++k) mean += knots(i + k) / spline.Degree();
    const Vec2 pole = segment.from + whole * ((mean - place.from) / length(place));
    if (!(max_norm(pole - vec(spline.Pole(i))) <= kStraight * max_norm(whole))) return false;
  }
  return true;
}

std::optional<Segment> segment_of(const Chart& chart) {
  const Handle(Geom2d_Curve) curve = basis_of(chart.curve);
  const Segment segment{chart.uv(0), chart.uv(1)};
  if (!Handle(Geom2d_Line)::DownCast(curve).IsNull()) return segment;
  if (const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve))
    if (is_proportional(*spline, chart.place, segment)) return segment;
  if (const auto bezier = Handle(Geom2d_BezierCurve)::DownCast(curve))
    if (bezier->Degree() == 1 && !bezier->IsRational()) return segment;
  return {};
}

/// An iso-parameter line with the strip of the surface that the face has beside it.
struct IsoLineOfFace {
  ParameterBox box;
  SurfaceSide side;
  bool backward = false;
  double off = 0;  ///< how far it leaves the line, in the parameter across
};

std::vector<double> knots_of(const GeomAdaptor_Surface& surface, bool u) {
  const int count = u ? surface.NbUIntervals(GeomAbs_CN) : surface.NbVIntervals(GeomAbs_CN);
  TColStd_Array1OfReal all(1, count + 1);
  u ? surface.UIntervals(all, GeomAbs_CN) : surface.VIntervals(all, GeomAbs_CN);
  return {all.begin(), all.end()};
}

/// The last knot that is no farther than a sliver from c, or c.
double past_sliver(const std::vector<double>& knots, double c, bool up) {
  const double most = kSliver * (knots.back() - knots.front());
  double start = c;
  for (const double knot : knots)
    if (std::abs(knot - c) <= most && (up ? knot > start : knot < start)) start = knot;
  return start;
}

/// The knot behind c, no farther than the limit.
double next_knot(const std::vector<double>& knots, double c, double limit) {
  double next = limit;
  for (const double knot : knots)
    if (limit > c ? knot > c && knot < next : knot < c && knot > next) next = knot;
  return next;
}

std::optional<IsoLineOfFace> iso_line_of(const Chart& chart, const Segment& segment,
                                         const ParameterBox& of_face) {
  const Vec2 run = segment.to - segment.from;
  const bool along_v = std::abs(run[1]) > std::abs(run[0]);
  const int along = along_v ? 1 : 0, across = 1 - along;
  if (!(std::abs(run[across]) <= kStraight * std::abs(run[along]))) return {};
  const bool rises = run[along] > 0;
  // To the left of a line that rises in v is smaller u, of one that rises in u larger v.
  const bool up = chart.left == (along_v != rises);
  const double c = segment.from[across];
  const Interval& limits = along_v ? of_face.u : of_face.v;
  const double limit = up ? limits.to : limits.from;
  if (!(up ? limit > c : limit < c)) return {};
  const std::vector<double> knots = knots_of(GeomAdaptor_Surface(chart.surface), along_v);
  const double start = past_sliver(knots, c, up);
  const double next = next_knot(knots, start, limit);
  if (!(up ? next > start : next < start)) return {};
  const Interval in = up ? Interval{start, next} : Interval{next, start};
  const Interval on{std::min(segment.from[along], segment.to[along]),
                    std::max(segment.from[along], segment.to[along])};
  IsoLineOfFace line;
  line.box = along_v ? ParameterBox{in, on} : ParameterBox{on, in};
  line.side = along_v ? (up ? SurfaceSide::UMin : SurfaceSide::UMax)
                      : (up ? SurfaceSide::VMin : SurfaceSide::VMax);
  line.backward = !rises;
  line.off = std::abs(run[across]);
  return line;
}

void drop_slivers(BorderSpans& spans) {
  std::erase_if(spans, [](const BorderSpan& span) { return length(span.place) < kSliver; });
}

/// Errors for an edge that leaves its line: by the derivative across, per the depth of the box.
void add_error(BorderSpans& spans, double part_of_depth) {
  if (part_of_depth == 0) return;
  for (BorderSpan& span : spans) {
    Vec4 most;
    for (const auto* row : {&span.across, &span.bend})
      for (const Vec4& p : *row)
        for (int c = 0; c < 4; ++c) most[c] = std::max(most[c], std::abs(p[c]));
    span.error += most * part_of_depth;
    span.across_error += most * part_of_depth;
  }
}

std::optional<IsoCollar> collar_of(const Chart& chart, const TopoDS_Face& face,
                                   std::string& reason) {
  const std::optional<Segment> segment = segment_of(chart);
  const auto line = segment ? iso_line_of(chart, *segment, parameter_box(face)) : std::nullopt;
  if (!line) {
    reason = "its curve on a surface is no iso-parameter line";
    return {};
  }
  const bool along_v = line->side == SurfaceSide::UMin || line->side == SurfaceSide::UMax;
  IsoCollar collar{.surface = bezier_surface(chart.surface, line->box),
                   .side = line->side,
                   .backward = line->backward,
                   .off = line->off / length(along_v ? line->box.u : line->box.v)};
  if (collar.surface.error == 0) return collar;
  reason = "a surface is neither polynomial nor rational";
  return {};
}

std::optional<BorderSpans> iso_spans(const Chart& chart, const TopoDS_Face& face,
                                     std::string& reason) {
  const std::optional<IsoCollar> collar = collar_of(chart, face, reason);
  if (!collar) return {};
  BorderSpans spans = border_spans(collar->surface, collar->side, collar->backward);
  add_error(spans, collar->off);
  drop_slivers(spans);
  return spans;
}

std::optional<BorderSpans> spans_of(const Chart& chart, const TopoDS_Face& face,
                                    std::string& reason) {
  try {
    if (const auto plane = Handle(Geom_Plane)::DownCast(chart.surface))
      return plane_spans(chart, *plane, reason);
    return iso_spans(chart, face, reason);
  } catch (const BadModel& error) {
    reason = error.what();
    return {};
  }
}

}  // namespace

EdgeBorder edge_border(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  return guarded("looking at a face beside an edge", [&] {
    const Chart chart = chart_of(edge, face);
    EdgeBorder border;
    border.spans = spans_of(chart, face, border.no_spans);
    if (border.spans) {
      border.breaks = {0, 1};
      for (const BorderSpan& span : *border.spans) border.breaks.push_back(span.place.from);
      border.sides = edge_sides(*border.spans);
    } else {
      border.breaks = breaks_of_chart(chart);
      border.sides = [chart](double x) { return side_at(chart, x); };
    }
    std::sort(border.breaks.begin(), border.breaks.end());
    return border;
  });
}

std::optional<IsoCollar> iso_collar(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  return guarded("looking at a face beside an edge", [&] {
    std::string reason;
    return collar_of(chart_of(edge, face), face, reason);
  });
}

}  // namespace blossom::occt
