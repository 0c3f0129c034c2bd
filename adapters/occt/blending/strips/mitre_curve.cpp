// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/mitre_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <gp.hxx>

#include "adapters/occt/faces/surface_projector.h"
#include "core/math/linear_solve.h"

namespace blossom::occt {
namespace {

constexpr int kFirstSteps = 32;  // of a way, doubled until points between lie on the curve
constexpr int kMaxSteps = 512;
constexpr int kMitreSteps = 12;
constexpr double kMitreConverged = 1e-3;  // of the tolerance
constexpr double kTouching = 1e-2;        // sine of the angle below which strips count as touching
constexpr double kJump = 0.5;             // of a step: corrected further, it is another curve
// Of a step: how far from the known end the last prediction may be.
constexpr double kArrival = 0.25;

struct StripFrame {
  Vec3 point, by_t, by_w;
};

StripFrame frame_of(const RolledStrip& strip, double t, double w) {
  const SurfaceJet frame = frame_at(strip.surface, strip.chart(t, w));
  if (strip.along_u) return {frame.point, frame.du, frame.dv};
  return {frame.point, frame.dv, frame.du};
}

// Where a point is on a strip: t and w.
Vec2 place_on(const RolledStrip& strip, const Vec3& point) {
  const Vec2 near =
      strip.chart(at(strip.edge_range, 0.5), 0.5 * (strip.contacts[0].w + strip.contacts[1].w));
  const Vec2 uv = SurfaceProjector(strip.bare_face(), Precision::Confusion()).foot(point, near);
  return strip.along_u ? uv : Vec2{uv[1], uv[0]};
}

// t of the first strip, and both parameters of the second one: what is looked for at each w.
using Unknowns = Vec3;

struct CurvePoint {
  double w = 0;
  Unknowns x;
  Vec3 point;
};

class MitreTracer {
 public:
  MitreTracer(const RolledStrip& strip, const RolledStrip& other, double tolerance)
      : strip_(strip), other_(other), tolerance_(tolerance) {}

  CurvePoint start_at(const Vec3& point) const;
  double crossing_sine(const CurvePoint& at) const;
  std::optional<std::vector<CurvePoint>> way(const CurvePoint& start, const CurvePoint& end,
                                             int steps) const;

 private:
  std::optional<CurvePoint> solved(double w, Unknowns guess, double reach) const;
  std::optional<Unknowns> rate(const CurvePoint& at) const;

  const RolledStrip& strip_;
  const RolledStrip& other_;
  double tolerance_;
};

CurvePoint MitreTracer::start_at(const Vec3& point) const {
  const Vec2 a = place_on(strip_, point), b = place_on(other_, point);
  return {a[1], {a[0], b[0], b[1]}, point};
}

double MitreTracer::crossing_sine(const CurvePoint& at) const {
  const StripFrame a = frame_of(strip_, at.x[0], at.w), b = frame_of(other_, at.x[1], at.x[2]);
  return norm(cross(unit(cross(a.by_t, a.by_w)), unit(cross(b.by_t, b.by_w))));
}

SquareMatrix<3> columns(const StripFrame& a, const StripFrame& b) {
  SquareMatrix<3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    const int k = static_cast<int>(i);
    m[i] = {a.by_t[k], -b.by_t[k], -b.by_w[k]};
  }
  return m;
}

// By Newton's method; nothing if it leads further away than `reach`.
std::optional<CurvePoint> MitreTracer::solved(double w, Unknowns guess, double reach) const {
  const Vec3 first = frame_of(strip_, guess[0], w).point;
  for (int step = 0; step < kMitreSteps; ++step) {
    const StripFrame a = frame_of(strip_, guess[0], w), b = frame_of(other_, guess[1], guess[2]);
    if (distance(a.point, first) > reach) return std::nullopt;
    if (step > 0 && distance(a.point, b.point) <= kMitreConverged * tolerance_)
      return CurvePoint{w, guess, a.point};
    Vec3 change = b.point - a.point;
    if (!solve(columns(a, b), change)) return std::nullopt;
    guess += change;
  }
  return std::nullopt;
}

std::optional<Unknowns> MitreTracer::rate(const CurvePoint& at) const {
  const StripFrame a = frame_of(strip_, at.x[0], at.w), b = frame_of(other_, at.x[1], at.x[2]);
  Vec3 rate = -a.by_w;
  if (!solve(columns(a, b), rate)) return std::nullopt;
  return rate;
}

// Points from the start to the end, which is known: only that the way leads there is looked at.
std::optional<std::vector<CurvePoint>> MitreTracer::way(const CurvePoint& start,
                                                        const CurvePoint& end, int steps) const {
  const double h = (end.w - start.w) / steps;
  const double whole = distance(start.point, end.point);
  auto here = solved(start.w, start.x, whole / steps);
  if (!here) return std::nullopt;
  const auto first_rate = rate(*here);
  if (!first_rate) return std::nullopt;
  std::vector<CurvePoint> points{*here};
  for (int i = 1; i <= steps; ++i) {
    const std::size_t n = points.size();
    // By the points before: a straight line at first, then a parabola.
    Unknowns guess = points[n - 1].x + h * *first_rate;
    if (n == 2) guess = 2.0 * points[1].x - points[0].x;
    if (n > 2) guess = 3.0 * (points[n - 1].x - points[n - 2].x) + points[n - 3].x;
    const double w = start.w + i * h;
    const Vec3 ahead = frame_of(strip_, guess[0], w).point;
    const double step = distance(ahead, points[n - 1].point);
    if (i == steps) {
      if (distance(ahead, end.point) > kArrival * step + tolerance_) return std::nullopt;
      points.push_back(end);
      break;
    }
    const auto next = solved(w, guess, kJump * step);
    if (!next) return std::nullopt;
    points.push_back(*next);
  }
  return points;
}

// Curves through the points in space and in both charts, by the length of the chords.
EndCurve curves_through(const RolledStrip& strip, const RolledStrip& other,
                        const std::vector<CurvePoint>& points) {
  const int count = static_cast<int>(points.size());
  const Handle(TColgp_HArray1OfPnt) places = new TColgp_HArray1OfPnt(1, count);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, count);
  const std::array charts{Handle(TColgp_HArray1OfPnt2d)(new TColgp_HArray1OfPnt2d(1, count)),
                          Handle(TColgp_HArray1OfPnt2d)(new TColgp_HArray1OfPnt2d(1, count))};
  double length = 0;
  for (int i = 1; i <= count; ++i) {
    const CurvePoint& p = points[static_cast<std::size_t>(i) - 1];
    if (i > 1) length += distance(p.point, points[static_cast<std::size_t>(i) - 2].point);
    places->SetValue(i, {p.point[0], p.point[1], p.point[2]});
    parameters->SetValue(i, length);
    const Vec2 a = strip.chart(p.x[0], p.w), b = other.chart(p.x[1], p.x[2]);
    charts[0]->SetValue(i, {a[0], a[1]});
    charts[1]->SetValue(i, {b[0], b[1]});
  }
  GeomAPI_Interpolate in_space(places, parameters, Standard_False, gp::Resolution());
  Geom2dAPI_Interpolate on_strip(charts[0], parameters, Standard_False, gp::Resolution());
  Geom2dAPI_Interpolate on_other(charts[1], parameters, Standard_False, gp::Resolution());
  in_space.Perform();
  on_strip.Perform();
  on_other.Perform();
  EndCurve made;
  made.curve = in_space.Curve();
  made.on_strip = on_strip.Curve();
  made.on_face = on_other.Curve();
  made.range = {0, length};
  return made;
}

// Between all points, and so where curves through them are worst.
double largest_gap(const EndCurve& made, const RolledStrip& strip, const RolledStrip& other,
                   const std::vector<CurvePoint>& points) {
  double largest = 0, before = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double after = before + distance(points[i - 1].point, points[i].point);
    for (const double part : {0.3, 0.5, 0.7}) {
      const double x = at({before, after}, part);
      const gp_Pnt point = made.curve->Value(x);
      const gp_Pnt2d a = made.on_strip->Value(x), b = made.on_face->Value(x);
      largest = std::max({largest, point.Distance(strip.surface->Value(a.X(), a.Y())),
                          point.Distance(other.surface->Value(b.X(), b.Y()))});
    }
    before = after;
  }
  return largest;
}

}  // namespace

std::optional<EndCurve> mitre_curve(const RolledStrip& strip, const RolledStrip& other,
                                    const Vec3& from, const Vec3& to, double tolerance) {
  const MitreTracer tracer(strip, other, tolerance);
  const CurvePoint at_from = tracer.start_at(from), at_to = tracer.start_at(to);
  const bool forward = tracer.crossing_sine(at_from) >= tracer.crossing_sine(at_to);
  const CurvePoint &start = forward ? at_from : at_to, &end = forward ? at_to : at_from;
  if (tracer.crossing_sine(start) < kTouching) return std::nullopt;
  for (int steps = kFirstSteps; steps <= kMaxSteps; steps *= 2) {
    const auto points = tracer.way(start, end, steps);
    if (!points) continue;  // shorter steps may stay on the curve
    EndCurve made = curves_through(strip, other, *points);
    if (largest_gap(made, strip, other, *points) > tolerance) continue;
    made.forward = forward;
    return made;
  }
  return std::nullopt;
}

}  // namespace blossom::occt
