// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/pairs/run_curves.h"

#include <algorithm>
#include <optional>

#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Line.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/faces/surface_projector.h"
#include "core/results/hermite_curves.h"

namespace blossom::occt {
namespace {

constexpr double kRunFitShare = 0.1;  // of the tolerance
constexpr int kMaxRunPieces = 1024;
constexpr int kMinRunPieces = 16;  // of a curve that is not straight
constexpr double kInside = 1e-3;   // of a run: a place on it near its start

Handle(Geom_Curve) curve_of(const TopoDS_Edge& edge) {
  Interval range;
  return BRep_Tool::Curve(edge, range.from, range.to);
}

std::optional<Conic> conic_of(const Handle(Geom_Curve) & curve) {
  const Handle(Geom_Curve) basis = basis_of(curve);
  if (const auto line = Handle(Geom_Line)::DownCast(basis)) {
    const gp_Ax1 axis = line->Position();
    return Conic{
        ConicKind::Line, vec(axis.Location().XYZ()), vec(axis.Direction().XYZ()), {}, 0, 0};
  }
  const auto circle = Handle(Geom_Circle)::DownCast(basis);
  if (circle.IsNull()) return {};
  const gp_Ax2 axes = circle->Position();
  return Conic{ConicKind::Circle,
               vec(axes.Location().XYZ()),
               vec(axes.XDirection().XYZ()),
               vec(axes.YDirection().XYZ()),
               circle->Radius(),
               circle->Radius()};
}

class RunOnFaces {
 public:
  RunOnFaces(const OutlineRun& run, const TopoDS_Face& a, const TopoDS_Face& b, double tolerance)
      : on_a_(a, tolerance), on_b_(b, tolerance), curve_(curve_of(run.a.edge)), run_(run) {}

  Vec3 point(double t) const {
    const gp_Pnt p = curve_->Value(t);
    return vec(p.XYZ());
  }

  std::vector<HermiteJet> jets(int pieces) const {
    // The edges' own images say in which turn of periods the run lies.
    Vec2 near_a = vec(run_.a.chart->Value(at(run_.at_a, kInside)));
    Vec2 near_b = vec(run_.b.chart->Value(at(run_.at_b, kInside)));
    std::vector<HermiteJet> all;
    for (int i = 0; i <= pieces; ++i) {
      gp_Pnt p;
      gp_Vec d;
      curve_->D1(at(run_.at_a, static_cast<double>(i) / pieces), p, d);
      const Vec3 point = vec(p.XYZ()), rate = vec(d.XYZ());
      near_a = on_a_.foot(point, near_a);
      near_b = on_b_.foot(point, near_b);
      all.push_back({{point, near_a, near_b},
                     {rate, chart_step(frame_at(on_a_.surface(), near_a), rate),
                      chart_step(frame_at(on_b_.surface(), near_b), rate)}});
    }
    return all;
  }

  Deviation gaps(const SurfacePoint& x) const {
    return {
        on_a_.gap(x.point, x.uv_a), on_b_.gap(x.point, x.uv_b),
        distance(frame_at(on_a_.surface(), x.uv_a).point, frame_at(on_b_.surface(), x.uv_b).point),
        false};
  }

 private:
  SurfaceProjector on_a_, on_b_;
  Handle(Geom_Curve) curve_;
  const OutlineRun& run_;
};

// What the curve, and its spline, are off between its samples.
void measure_run(const RunOnFaces& on_faces, IntersectionCurve& curve) {
  curve.deviation = {0, 0, 0, false};
  curve.length = 0;
  for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i) {
    const Interval piece{curve.sample_parameters[i], curve.sample_parameters[i + 1]};
    for (const double part : {0.0, 0.3, 0.5, 0.8}) {
      const double t = at(piece, part);
      const Vec3 point = on_faces.point(t);
      const Deviation gaps =
          on_faces.gaps({curve.conic ? point : point_at(curve.curve, t), point_at(curve.chart_a, t),
                         point_at(curve.chart_b, t)});
      raise(curve.deviation, gaps);
      curve.deviation.conic =
          std::max(curve.deviation.conic, distance(point, point_at(curve.curve, t)));
    }
    const Vec3 middle = on_faces.point(at(piece, 0.5));
    curve.length +=
        distance(curve.samples[i].point, middle) + distance(middle, curve.samples[i + 1].point);
  }
  if (curve.conic) curve.length = arc_length(*curve.conic, curve.curve.domain());
}

}  // namespace

double parameter_beside(const OutlineRun& run, double t) {
  const Interval range{std::min(run.at_b.from, run.at_b.to), std::max(run.at_b.from, run.at_b.to)};
  const GeomAPI_ProjectPointOnCurve foot(curve_of(run.a.edge)->Value(t), curve_of(run.b.edge),
                                         range.from, range.to);
  return foot.NbPoints() > 0 ? foot.LowerDistanceParameter() : at(run.at_b, 0.5);
}

IntersectionCurve run_curve(const OutlineRun& run, const TopoDS_Face& a, const TopoDS_Face& b,
                            double tolerance) {
  const RunOnFaces on_faces(run, a, b, tolerance);
  const std::optional<Conic> conic = conic_of(curve_of(run.a.edge));
  const bool straight = conic && conic->kind == ConicKind::Line;
  IntersectionCurve curve;
  for (int pieces = straight ? 1 : kMinRunPieces; pieces <= kMaxRunPieces; pieces *= 2) {
    curve = hermite_curve(on_faces.jets(pieces), run.at_a);
    curve.conic = conic;
    measure_run(on_faces, curve);
    const Deviation& d = curve.deviation;
    if (std::max({d.a, d.b, d.between, d.conic}) <= run.gap + kRunFitShare * tolerance) break;
  }
  curve.tangential = true;
  curve.ends = {CurveEnd::Trim, CurveEnd::Trim};
  const bool whole = distance(curve.samples.front().point, curve.samples.back().point) <= tolerance;
  if (whole && !straight) {
    curve.closed = true;
    curve.ends = {CurveEnd::Closed, CurveEnd::Closed};
    curve.samples.back().point = curve.samples.front().point;
  }
  return curve;
}

}  // namespace blossom::occt
