// SPDX-License-Identifier: LGPL-2.1-or-later
// Certified cases for Blossom and for Open CASCADE's two intersectors, in one program.
//
//   occt_cases CASES_FOLDER OUT_FOLDER [--limit SECONDS] [--only PREFIX]
//
// Blossom works in one thread, as the others do, and once more in as many as there are cores.

#include <memory>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Section.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_IntSS.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/intersection.h"
#include "tests/bench/peers/case_runner.h"

namespace blossom::bench {
namespace {

constexpr int kSamples = 1500;  // chords within 2e-4 of the size, as the scorer asks

Point point_of(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

Point point_of(const SurfacePoint& p) { return {p.point[0], p.point[1], p.point[2]}; }

std::vector<Point> points_of(const std::vector<SurfacePoint>& list) {
  std::vector<Point> points;
  for (const SurfacePoint& p : list) points.push_back(point_of(p));
  return points;
}

SampledCurve sampled(const Adaptor3d_Curve& curve) {
  SampledCurve result;
  const double from = curve.FirstParameter(), to = curve.LastParameter();
  for (int k = 0; k <= kSamples; ++k)
    result.points.push_back(point_of(curve.Value(from + (to - from) * k / kSamples)));
  result.closed = curve.Value(from).Distance(curve.Value(to)) < 1e-6 * (to - from);
  return result;
}

// threads   0: as many as there are cores
Solver blossom_solver(const std::string& name, int threads) {
  struct State {
    std::vector<TopoDS_Face> a, b;
    IntersectionOptions options;
    occt::ShapeIntersection found;
  };
  const auto state = std::make_shared<State>();
  const auto prepare = [state, threads](const Pair& pair) {
    state->a = {pair.a};
    state->b = {pair.b};
    state->options.tolerances.point = pair.tolerance;
    state->options.threads = threads;
  };
  const auto solve = [state] {
    state->found = occt::intersect(state->a, state->b, state->options);
  };
  const auto answer = [state] {
    Answer result;
    result.claim = to_string(state->found.status);
    if (state->found.status == Status::Stopped) result.status = "stopped";
    for (const occt::FaceIntersection& pair : state->found.pairs) {
      for (const IntersectionCurve& curve : pair.found.curves)
        result.curves.push_back({curve.closed, curve.tangential, points_of(curve.samples)});
      for (const SurfacePoint& p : pair.found.points) result.points.push_back(point_of(p));
      for (const Overlap& overlap : pair.found.overlaps)
        result.overlaps.push_back(points_of(overlap.boundary));
    }
    return result;
  };
  return {name, prepare, solve, answer};
}

Solver intss_solver() {
  struct State {
    Pair pair;
    GeomAPI_IntSS found;
  };
  const auto state = std::make_shared<State>();
  const auto solve = [state] {
    state->found.Perform(BRep_Tool::Surface(state->pair.a), BRep_Tool::Surface(state->pair.b),
                         state->pair.tolerance);
  };
  const auto answer = [state] {
    Answer result;
    if (!state->found.IsDone()) result.status = "notdone";
    for (int k = 1; result.status == "ok" && k <= state->found.NbLines(); ++k)
      result.curves.push_back(sampled(GeomAdaptor_Curve(state->found.Line(k))));
    return result;
  };
  return {"occt_intss", [state](const Pair& pair) { state->pair = pair; }, solve, answer};
}

// Vertices of the section that no edge of it uses.
std::vector<Point> lone_points(const TopoDS_Shape& section) {
  std::vector<Point> points;
  for (TopExp_Explorer v(section, TopAbs_VERTEX, TopAbs_EDGE); v.More(); v.Next())
    points.push_back(point_of(BRep_Tool::Pnt(TopoDS::Vertex(v.Current()))));
  return points;
}

Solver section_solver() {
  struct State {
    Pair pair;
    std::unique_ptr<BRepAlgoAPI_Section> found;
  };
  const auto state = std::make_shared<State>();
  const auto solve = [state] {
    state->found = std::make_unique<BRepAlgoAPI_Section>(state->pair.a, state->pair.b, false);
    state->found->SetRunParallel(false);
    state->found->Approximation(true);
    state->found->ComputePCurveOn1(true);
    state->found->ComputePCurveOn2(true);
    state->found->Build();
  };
  const auto answer = [state] {
    Answer result;
    if (!state->found->IsDone()) {
      result.status = "notdone";
      return result;
    }
    for (TopExp_Explorer e(state->found->Shape(), TopAbs_EDGE); e.More(); e.Next())
      if (const TopoDS_Edge edge = TopoDS::Edge(e.Current()); !BRep_Tool::Degenerated(edge))
        result.curves.push_back(sampled(BRepAdaptor_Curve(edge)));
    result.points = lone_points(state->found->Shape());
    return result;
  };
  return {"occt_section", [state](const Pair& pair) { state->pair = pair; }, solve, answer};
}

}  // namespace
}  // namespace blossom::bench

int main(int argc, char** argv) {
  using namespace blossom::bench;
  return run_cases(argc, argv,
                   {blossom_solver("blossom", 1), blossom_solver("blossom_all_cores", 0),
                    intss_solver(), section_solver()});
}
