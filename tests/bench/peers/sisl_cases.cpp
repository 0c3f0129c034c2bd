// SPDX-License-Identifier: LGPL-2.1-or-later
// Certified cases for SISL: a program of its own, for comparison, that has nothing of Blossom in
// it.
//
//   sisl_cases CASES_FOLDER OUT_FOLDER [--limit SECONDS] [--only PREFIX]
//
// Two settings: a resolution of 1e-6 and of 1e-9 of the size. s1859 finds where curves are, s1310
// marches along them; both are timed.

#include <memory>
#include <string>
#include <vector>

#include <sisl.h>

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>

#include "tests/bench/peers/case_runner.h"

namespace blossom::bench {
namespace {

constexpr int kSamples = 1500;  // chords within 2e-4 of the size, as the scorer asks

struct FreeSurface {
  void operator()(SISLSurf* surface) const { freeSurf(surface); }
};
using Surface = std::unique_ptr<SISLSurf, FreeSurface>;

std::vector<double> knots_of(const TColStd_Array1OfReal& knots) {
  return {knots.begin(), knots.end()};
}

// SISL wants homogeneous points, u fastest.
Surface surface_of(const TopoDS_Face& face) {
  const Handle(Geom_BSplineSurface) spline =
      GeomConvert::SurfaceToBSplineSurface(BRep_Tool::Surface(face));
  spline->SetUNotPeriodic();
  spline->SetVNotPeriodic();
  const bool rational = spline->IsURational() || spline->IsVRational();
  std::vector<double> points;
  for (int v = 1; v <= spline->NbVPoles(); ++v)
    for (int u = 1; u <= spline->NbUPoles(); ++u) {
      const double w = rational ? spline->Weight(u, v) : 1;
      const gp_Pnt p = spline->Pole(u, v);
      for (const double x : {w * p.X(), w * p.Y(), w * p.Z()}) points.push_back(x);
      if (rational) points.push_back(w);
    }
  std::vector<double> u = knots_of(spline->UKnotSequence()), v = knots_of(spline->VKnotSequence());
  return Surface(newSurf(spline->NbUPoles(), spline->NbVPoles(), spline->UDegree() + 1,
                         spline->VDegree() + 1, u.data(), v.data(), points.data(), rational ? 2 : 1,
                         3, 1));
}

struct Run {
  Surface a, b;
  double resolution = 0;
  int points = 0, curves = 0, status = 0;
  double *uv_a = nullptr, *uv_b = nullptr;
  SISLIntcurve** found = nullptr;

  void clear() {
    free(uv_a);
    free(uv_b);
    if (found) freeIntcrvlist(found, curves);
    uv_a = uv_b = nullptr;
    found = nullptr;
    points = curves = 0;
  }

  void solve() {
    clear();
    s1859(a.get(), b.get(), 0, resolution, &points, &uv_a, &uv_b, &curves, &found, &status);
    for (int k = 0; status >= 0 && k < curves; ++k) {
      int marched = 0;
      s1310(a.get(), b.get(), found[k], resolution, 0, 1, 0, &marched);
    }
  }

  Point point_at(double* uv) const {
    std::array<double, 12> derivatives{};
    std::array<double, 3> normal{};
    int left_u = 0, left_v = 0, failed = 0;
    s1421(a.get(), 0, uv, &left_u, &left_v, derivatives.data(), normal.data(), &failed);
    return {derivatives[0], derivatives[1], derivatives[2]};
  }
};

SampledCurve sampled(SISLCurve* curve) {
  SampledCurve result;
  const double from = curve->et[curve->ik - 1], to = curve->et[curve->in];
  int left = 0, failed = 0;
  for (int k = 0; k <= kSamples; ++k) {
    Point p{};
    s1227(curve, 0, from + (to - from) * k / kSamples, &left, p.data(), &failed);
    result.points.push_back(p);
  }
  return result;
}

SampledCurve guide_of(const Run& run, const SISLIntcurve& found) {
  SampledCurve result;
  for (int k = 0; k < found.ipoint; ++k) result.points.push_back(run.point_at(found.epar1 + 2 * k));
  return result;
}

Answer answer_of(const Run& run) {
  Answer result;
  if (run.status < 0) {
    result.status = "error" + std::to_string(run.status);
    return result;
  }
  for (int k = 0; k < run.curves; ++k) {
    const SISLIntcurve& found = *run.found[k];
    result.curves.push_back(found.pgeom ? sampled(found.pgeom) : guide_of(run, found));
    result.curves.back().closed = found.itype == 2 || found.itype == 3;
  }
  for (int k = 0; k < run.points; ++k) result.points.push_back(run.point_at(run.uv_a + 2 * k));
  return result;
}

Solver sisl_solver(const std::string& name, double relative_resolution) {
  const auto run = std::make_shared<Run>();
  const auto prepare = [run, relative_resolution](const Pair& pair) {
    run->a = surface_of(pair.a);
    run->b = surface_of(pair.b);
    run->resolution = relative_resolution * pair.size;
  };
  return {name, prepare, [run] { run->solve(); }, [run] { return answer_of(*run); }};
}

}  // namespace
}  // namespace blossom::bench

int main(int argc, char** argv) {
  using namespace blossom::bench;
  return run_cases(argc, argv, {sisl_solver("sisl_1e-6", 1e-6), sisl_solver("sisl_1e-9", 1e-9)});
}
