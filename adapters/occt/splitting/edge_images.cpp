// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/edge_images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomProjLib.hxx>
#include <Precision.hxx>
#include <ProjLib_Cone.hxx>
#include <ProjLib_Cylinder.hxx>
#include <ProjLib_Sphere.hxx>
#include <ProjLib_Torus.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curve_breaks.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/edge_charts.h"
#include "core/forms/quintic_spline.h"
#include "core/math/functions/bisection.h"
#include "core/math/functions/golden_section.h"

namespace blossom::occt {
namespace {

constexpr int kEdgeSamples = 64;    // of an edge, to see where it lies on the other surface
constexpr int kHalvings = 48;       // of the interval between two samples, for the end of a run
constexpr double kNearest = 1e-10;  // of the same interval: where a curve is nearest to a border
constexpr int kNewtonSteps = 4;
constexpr int kMinPieces = 16, kMaxPieces = 512;  // between knots of a fitted run
constexpr double kFitShare = 0.1;                 // of the tolerance
constexpr double kExactShare = 1e-3;  // of the tolerance: a projection so near is taken as exact
constexpr int kImageSteps = 32;       // of an image, between which it is compared with its curve,
constexpr int kSpanSteps = 4;         // and of each of its spans, where these are many
constexpr double kStart = 1e-3;       // of a run: a place on it near its start
constexpr double kSamePlace = 1e-9;   // of a run: joints so near are one
// Of a parameter: between joints nearer than this there are few numbers left.
constexpr double kFewNumbers = 0x1p-40;

double least_piece(const Interval& run) {
  return std::max(kSamePlace * length(run),
                  kFewNumbers * std::max(std::abs(run.from), std::abs(run.to)));
}

// Open CASCADE's approximations go astray in single spans, however short, and are right in others.
double deviation(const Handle(Geom_Curve) & curve, const Handle(Geom2d_Curve) & chart,
                 const Interval& range, const SurfaceProjector& feet) {
  std::vector<double> ends = breaks_of(chart, range);
  ends.insert(ends.begin(), range.from);
  ends.push_back(range.to);
  const int steps = std::max(kSpanSteps, kImageSteps / static_cast<int>(ends.size() - 1));
  double largest = 0;
  for (std::size_t span = 0; span + 1 < ends.size(); ++span)
    for (int i = span == 0 ? 0 : 1; i <= steps; ++i) {
      const double t = at(Interval{ends[span], ends[span + 1]}, static_cast<double>(i) / steps);
      const gp_Pnt2d uv = chart->Value(t);
      largest = std::max(largest, feet.gap(vec(curve->Value(t)), {uv.X(), uv.Y()}));
    }
  return largest;
}

template <class Projector, class Surface>
bool has_image(const GeomAdaptor_Curve& curve, const Surface& surface) {
  Projector projector(surface);
  switch (curve.GetType()) {
    case GeomAbs_Line: projector.Project(curve.Line()); break;
    case GeomAbs_Circle: projector.Project(curve.Circle()); break;
    case GeomAbs_Ellipse: projector.Project(curve.Ellipse()); break;
    default: return true;
  }
  return projector.IsDone();
}

// Whether Open CASCADE may know the image of a curve. Of lines and conics on elementary surfaces
// that are none of their parameter lines it makes an approximation, which is never exact and takes
// as long as the fit that follows.
bool may_have_image(const Handle(Geom_Curve) & curve, const Interval& range,
                    const Handle(Geom_Surface) & surface) {
  const GeomAdaptor_Curve of(curve, range.from, range.to);
  const GeomAdaptor_Surface on(surface);
  switch (on.GetType()) {
    case GeomAbs_Cylinder: return has_image<ProjLib_Cylinder>(of, on.Cylinder());
    case GeomAbs_Cone: return has_image<ProjLib_Cone>(of, on.Cone());
    case GeomAbs_Sphere: return has_image<ProjLib_Sphere>(of, on.Sphere());
    case GeomAbs_Torus: return has_image<ProjLib_Torus>(of, on.Torus());
    default: return true;
  }
}

// Whether a curve has all of a range. On a surface of revolution Open CASCADE's end at the seam,
// and evaluate beyond.
bool covers(const Handle(Geom2d_Curve) & chart, const Interval& range) {
  const double room = Precision::PConfusion();
  return chart->IsPeriodic() || (chart->FirstParameter() <= range.from + room &&
                                 chart->LastParameter() >= range.to - room);
}

// What Open CASCADE makes of it; null if that is not exact, or not all.
Handle(Geom2d_Curve) projected(const Handle(Geom_Curve) & curve, const Interval& range,
                               const SurfaceProjector& feet, double tolerance) {
  try {
    if (!may_have_image(curve, range, feet.surface())) return {};
    double found = tolerance;
    const Handle(Geom2d_Curve) chart =
        GeomProjLib::Curve2d(curve, range.from, range.to, feet.surface(), found);
    if (!chart.IsNull() && covers(chart, range) &&
        deviation(curve, chart, range, feet) <= kExactShare * tolerance)
      return chart;
  } catch (const Standard_Failure&) {
    return {};  // it has none; one is fitted
  }
  return {};
}

}  // namespace

CurveBeside::CurveBeside(const TopoDS_Edge& edge, const TopoDS_Face& face,
                         const SurfaceProjector& feet)
    : feet_(feet), surface_(BRep_Tool::Surface(face)) {
  chart_ = chart_curve_of(edge, face, range_);
  if (chart_.IsNull()) throw BadModel("an edge has no parametric curve on the face it bounds");
}

CurveBeside::CurveBeside(Handle(Geom_Curve) curve, const Interval& range,
                         const SurfaceProjector& feet)
    : feet_(feet), curve_(std::move(curve)), range_(range) {}

CurveOnSurfaceJet CurveBeside::in_space(double t) const {
  if (!curve_.IsNull()) {
    gp_Pnt point;
    gp_Vec rate;
    curve_->D1(t, point, rate);
    return {vec(point), vec(rate), {}, {}};
  }
  gp_Pnt2d c;
  gp_Vec2d d;
  chart_->D1(t, c, d);
  const SurfaceJet own = frame_at(surface_, {c.X(), c.Y()});
  return {own.point, d.X() * own.du + d.Y() * own.dv, {}, {}};
}

Vec3 CurveBeside::bend(double t) const {
  if (!curve_.IsNull()) return vec(curve_->DN(t, 2));
  gp_Pnt2d c;
  gp_Vec2d d, dd;
  chart_->D2(t, c, d, dd);
  const Vec2 uv{c.X(), c.Y()};
  const SurfaceJet own = frame_at(surface_, uv);
  const SurfaceBend of = bend_at(surface_, uv);
  return dd.X() * own.du + dd.Y() * own.dv + d.X() * d.X() * of.uu + 2 * d.X() * d.Y() * of.uv +
         d.Y() * d.Y() * of.vv;
}

CurveOnSurfaceJet CurveBeside::jet(double t, const std::optional<Vec2>& near) const {
  CurveOnSurfaceJet jet = in_space(t);
  jet.uv = feet_.foot(jet.point, near);
  jet.uv_rate = chart_step(frame_at(feet_.surface(), jet.uv), jet.rate);
  return jet;
}

CurveOnSurfaceJet CurveBeside::end_jet(double end, double inner,
                                       const std::optional<Vec2>& near) const {
  const CurveOnSurfaceJet found = jet(end, near);
  const SurfacePole* pole = feet_.pole_at(found.point);
  if (pole == nullptr) return found;
  return pole_jet(*pole, end, jet(at({end, inner}, kStart), near).uv);
}

// In a pole S does not depend on its free parameter f, and a curve that comes to it with the rate T
// and the second derivative K has
//   T = S_g g'    K = S_gg g'^2 + 2 S_fg f' g' + S_g g''
// with g the other parameter: f is where S_g is along T, and f' follows from K without its share
// along S_g.
CurveOnSurfaceJet CurveBeside::pole_jet(const SurfacePole& pole, double t,
                                        const Vec2& beside) const {
  const int g = pole.fixed, f = 1 - g;
  CurveOnSurfaceJet jet = in_space(t);
  jet.uv = beside;
  jet.uv[g] = pole.value;
  const auto along = [&] {
    const SurfaceJet frame = frame_at(feet_.surface(), jet.uv);
    return g == 0 ? frame.du : frame.dv;
  };
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Vec3 s_g = along(), s_fg = bend_at(feet_.surface(), jet.uv).uv;
    const Vec3 normal = cross(s_g, s_fg);
    const double slope = dot(cross(jet.rate, s_fg), normal);
    if (slope == 0) return jet;  // a curve that stops there has no direction
    jet.uv[f] -= dot(cross(jet.rate, s_g), normal) / slope;
  }
  const Vec3 s_g = along();
  const SurfaceBend of = bend_at(feet_.surface(), jet.uv);
  const Vec3 aside = of.uv - (dot(of.uv, s_g) / dot(s_g, s_g)) * s_g;
  jet.uv_rate[g] = dot(jet.rate, s_g) / dot(s_g, s_g);
  const Vec3 rest = bend(t) - jet.uv_rate[g] * jet.uv_rate[g] * (g == 0 ? of.uu : of.vv);
  jet.uv_rate[f] = dot(rest, aside) / (2 * jet.uv_rate[g] * dot(aside, aside));
  return jet;
}

std::vector<Interval> CurveBeside::between_poles(const Interval& run) const {
  std::vector<Interval> parts{run};
  for (const SurfacePole& pole : feet_.poles()) {
    const auto approach = [&](double t) {
      const CurveOnSurfaceJet at = in_space(t);
      return dot(at.point - pole.point, at.rate);
    };
    for (int i = 0; i < kEdgeSamples; ++i) {
      Interval around{at(run, static_cast<double>(i) / kEdgeSamples),
                      at(run, (i + 1.0) / kEdgeSamples)};
      if (approach(around.from) > 0 || approach(around.to) <= 0) continue;
      around = bisected(around, kHalvings, [&](double t) { return !(approach(t) > 0); });
      const double least = least_piece(run);
      if (feet_.pole_at(in_space(around.to).point) != &pole || around.to < run.from + least ||
          around.to > run.to - least)
        continue;
      const auto part = std::find_if(parts.begin(), parts.end(),
                                     [&](const Interval& each) { return around.to < each.to; });
      const double end = part->to;
      part->to = around.to;
      parts.insert(std::next(part), {around.to, end});
    }
  }
  return parts;
}

CurveBeside::Standing CurveBeside::standing(double t) const {
  const Vec3 point = in_space(t).point;
  const Vec2 uv = feet_.foot(point, {});
  return {point, feet_.gap(point, uv), feet_.clearance(point, uv)};
}

bool CurveBeside::lies_on(double t, const RunLimits& limits) const {
  return limits.hold(standing(t));
}

// The end of a run between a parameter that belongs to it and one that does not. A curve that
// leaves over the border ends there, and not where the border is too far behind.
double CurveBeside::run_end(double on, double off, RunLimits limits) const {
  const RunLimits sharp{limits.reach, kFitShare * kFitShare * limits.past};
  if (lies_on(on, sharp)) limits = sharp;
  return bisected({on, off}, kHalvings, [&](double t) { return lies_on(t, limits); }).from;
}

// Where between two parameters the curve is nearest to the border, or farthest past it.
double CurveBeside::least_clearance(Interval around) const {
  const auto clearance = [&](double t) { return standing(t).clearance; };
  return extremum(clearance, around, 1, kNearest).place;
}

bool CurveBeside::is_one_run(double reach, double past) const {
  const RunLimits limits{reach, past};
  if (!lies_on(range_.from, limits) || !lies_on(range_.to, limits)) return false;
  const std::vector<Interval> found = runs(reach, past);
  return found.size() == 1 && found.front() == range_;
}

std::vector<Interval> CurveBeside::runs(double reach, double past) const {
  const RunLimits limits{reach, past};
  std::vector<Interval> runs;
  double before = range_.from;
  Standing there = standing(before);
  for (int i = 0; i <= kEdgeSamples; ++i) {
    const double t = at(range_, static_cast<double>(i) / kEdgeSamples);
    // No nearer than the last gap less the way from there, and so in no run: it needs no foot.
    if (there.gap - distance(there.point, in_space(t).point) > reach) {
      before = t;
      continue;
    }
    const Standing here = standing(t);
    const bool on = limits.hold(here);
    const bool goes_on = !runs.empty() && runs.back().to == before;
    if (on && goes_on) {
      // It may be past the border between two samples, if it does not run along it.
      const auto [low, high] = std::minmax(there.clearance, here.clearance);
      const bool may_leave = low < distance(there.point, here.point) &&
                             (high > past || !lies_on(0.5 * (before + t), limits));
      const double out = may_leave ? least_clearance({before, t}) : before;
      if (may_leave && !lies_on(out, limits)) {
        runs.back().to = run_end(before, out, limits);
        runs.push_back({run_end(t, out, limits), t});
      }
      runs.back().to = t;
    } else if (on) {
      runs.push_back({i > 0 ? run_end(t, before, limits) : t, t});
    } else if (goes_on) {
      runs.back().to = run_end(before, t, limits);
    }
    before = t;
    there = here;
  }
  std::erase_if(runs, [](const Interval& run) { return !(run.from < run.to); });
  return runs;
}

// Where the image crosses a knot line of the surface, which it does with a jump of its curvature.
void CurveBeside::add_knot_lines(const Interval& run, std::vector<double>& joints) const {
  const GeomAdaptor_Surface surface(feet_.surface());
  if (surface.GetType() <= GeomAbs_Torus) return;  // planes, quadrics and tori have none
  std::array<TColStd_Array1OfReal, 2> knots{
      TColStd_Array1OfReal(1, surface.NbUIntervals(GeomAbs_CN) + 1),
      TColStd_Array1OfReal(1, surface.NbVIntervals(GeomAbs_CN) + 1)};
  surface.UIntervals(knots[0], GeomAbs_CN);
  surface.VIntervals(knots[1], GeomAbs_CN);
  std::vector<Vec2> samples{jet(at(run, kStart), {}).uv};
  for (int i = 1; i <= kEdgeSamples; ++i)
    samples.push_back(i < kEdgeSamples
                          ? jet(at(run, static_cast<double>(i) / kEdgeSamples), samples.back()).uv
                          : end_jet(run.to, run.from, samples.back()).uv);
  for (int k = 0; k < 2; ++k)
    for (const double knot : knots[static_cast<std::size_t>(k)])
      for (int i = 0; i < kEdgeSamples; ++i) {
        const Vec2 &from = samples[static_cast<std::size_t>(i)],
                   &to = samples[static_cast<std::size_t>(i) + 1];
        if ((from[k] < knot) == (to[k] < knot)) continue;
        const Interval around{at(run, static_cast<double>(i) / kEdgeSamples),
                              at(run, (i + 1.0) / kEdgeSamples)};
        const auto is_before = [&](double t) {
          return (jet(t, from).uv[k] < knot) == (from[k] < knot);
        };
        joints.push_back(bisected(around, kHalvings, is_before).to);
      }
}

// The ends of the run, and between them where the curve or its image is less than smooth.
std::vector<double> CurveBeside::joints(const Interval& run) const {
  std::vector<double> at{run.from};
  const std::vector<double> breaks =
      chart_.IsNull() ? breaks_of(curve_, run) : breaks_of(chart_, run);
  at.insert(at.end(), breaks.begin(), breaks.end());
  add_knot_lines(run, at);
  std::sort(at.begin(), at.end());
  const double least = least_piece(run);
  std::vector<double> apart{run.from};
  for (const double t : at)
    if (t > apart.back() + least && t < run.to - least) apart.push_back(t);
  apart.push_back(run.to);
  return apart;
}

// The second derivative of the image, none in a pole:
//   K = S_uu u'^2 + 2 S_uv u' v' + S_vv v'^2 + S_u u'' + S_v v''
std::optional<Vec2> CurveBeside::uv_bend(const CurveOnSurfaceJet& at, double t) const {
  if (feet_.pole_at(at.point) != nullptr) return std::nullopt;
  const SurfaceBend of = bend_at(feet_.surface(), at.uv);
  const double u = at.uv_rate[0], v = at.uv_rate[1];
  return chart_step(frame_at(feet_.surface(), at.uv),
                    bend(t) - u * u * of.uu - 2 * u * v * of.uv - v * v * of.vv);
}

FaceCut CurveBeside::hermite_cut(const std::vector<double>& ends, double tolerance) const {
  // A start on a seam has two places.
  std::optional<Vec2> near = jet(at({ends.front(), ends.back()}, kStart), {}).uv;
  std::vector<QuinticJet<Vec3>> in_space;
  std::vector<QuinticJet<Vec2>> in_chart;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const bool first = i == 0, last = i + 1 == ends.size();
    const CurveOnSurfaceJet here = first  ? end_jet(ends[i], ends[1], near)
                                   : last ? end_jet(ends[i], ends[i - 1], near)
                                          : jet(ends[i], near);
    near = here.uv;
    in_space.push_back({here.point, here.rate, bend(ends[i])});
    in_chart.push_back({here.uv, here.uv_rate, uv_bend(here, ends[i])});
  }
  return {quintic_through(ends, in_space), quintic_through(ends, in_chart), tolerance};
}

// The curve may be as far from its image as it is within reach of the surface.
double CurveBeside::off(const FaceCut& cut, double t) const {
  const Vec2 image = point_at(cut.chart, t);
  const CurveOnSurfaceJet here = jet(t, image);
  const Vec3 foot = frame_at(feet_.surface(), here.uv).point;
  return std::max(distance(here.point, point_at(cut.curve, t)), feet_.gap(foot, image));
}

// Pieces are halved where they are off: beside a pole an image turns within a small part of it.
FaceCut CurveBeside::fitted_cut(const Interval& run, double wanted, double tolerance) const {
  const std::vector<double> joints = this->joints(run);
  const std::size_t most = kMaxPieces * (joints.size() - 1);
  const double least = least_piece(run);
  std::vector<double> ends{run.from};
  for (std::size_t k = 0; k + 1 < joints.size(); ++k)
    for (int i = 1; i <= kMinPieces; ++i)
      ends.push_back(at({joints[k], joints[k + 1]}, static_cast<double>(i) / kMinPieces));
  for (;;) {
    FaceCut cut = hermite_cut(ends, tolerance);
    std::vector<double> finer{run.from};
    double largest = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double middle = 0.5 * (ends[i] + ends[i + 1]), off = this->off(cut, middle);
      largest = std::max(largest, off);
      if (off > wanted && ends[i + 1] - ends[i] > least) finer.push_back(middle);
      finer.push_back(ends[i + 1]);
    }
    if (finer.size() > ends.size() && finer.size() <= most + 1) {
      ends = std::move(finer);
      continue;
    }
    // As where it crosses the seam of a surface that is closed but has no period.
    if (largest > tolerance) throw Failure("an edge has no image in the chart of the other face");
    return cut;
  }
}

std::vector<FaceCut> edge_cuts(const TopoDS_Face& face, const SurfaceProjector& feet, double reach,
                               double tolerance) {
  std::vector<FaceCut> cuts;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge) || is_seam(edge, face)) continue;
    const CurveBeside beside(edge, face, feet);
    const double allowed = std::max(tolerance, BRep_Tool::Tolerance(edge));
    for (const Interval& run : beside.runs(reach, allowed))
      for (const Interval& part : beside.between_poles(run))
        cuts.push_back(beside.fitted_cut(part, kFitShare * allowed, allowed));
  }
  return cuts;
}

ChartImage image_of(const Handle(Geom_Curve) & curve, const Interval& range,
                    const SurfaceProjector& feet, const std::optional<Vec2>& near,
                    double tolerance) {
  Handle(Geom2d_Curve) chart = projected(curve, range, feet, tolerance);
  if (chart.IsNull()) {
    const CurveBeside beside(curve, range, feet);
    chart = to_occt(beside.fitted_cut(range, kExactShare * tolerance, tolerance).chart);
  }
  if (near) {
    const gp_Pnt2d middle = chart->Value(at(range, 0.5));
    const Vec2 wanted = feet.foot(vec(curve->Value(at(range, 0.5))), near);
    const Vec2 turns = feet.turns();
    const auto move = [&](int k, double from) {
      return turns[k] > 0 ? turns[k] * std::round((wanted[k] - from) / turns[k]) : 0;
    };
    chart = Handle(Geom2d_Curve)::DownCast(
        chart->Translated(gp_Vec2d(move(0, middle.X()), move(1, middle.Y()))));
  }
  return {chart, deviation(curve, chart, range, feet)};
}

}  // namespace blossom::occt
