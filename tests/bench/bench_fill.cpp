// SPDX-License-Identifier: LGPL-2.1-or-later
// Fills of n-sided holes beside BRepOffsetAPI_MakeFilling.
//
//   bench_fill
//
// The holes are regular polygons in the graph of a cubic, so the right filling is known. Prints a
// line for each number of sides and continuity: the largest angle between the normals of fill and
// neighbours at 19 places of each side, the largest distance from the graph, and milliseconds. Ours
// are the first call, which makes the layout's operator, and the median of later ones.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepOffsetAPI_MakeFilling.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BezierSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "core/blending/fills/fill.h"
#include "core/forms/evaluation.h"
#include "tests/support/holes.h"

namespace blossom::bench {
namespace {

constexpr int kPlaces = 19;
constexpr int kRuns = 21;

struct Outcome {
  double angle = 0, off = 0, milliseconds = 0, first = 0;
};

template <class Work>
double milliseconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

RationalBezierPatch collar(int n, int k) {
  return testing::collar(testing::polygon_corner(n, k), testing::polygon_corner(n, k + 1),
                         testing::outward(n, k), testing::base_cubic);
}

double off_graph(const Vec3& p) { return std::abs(p[2] - testing::base_cubic(p[0], p[1])); }

Outcome ours(int n, FillContinuity continuity) {
  const std::vector<FillSide> sides = testing::graph_hole(n, continuity);
  Outcome outcome;
  Fill made;
  outcome.first = milliseconds([&] { made = fill(sides); });
  std::vector<double> times;
  for (int i = 0; i < kRuns; ++i) times.push_back(milliseconds([&] { made = fill(sides); }));
  std::nth_element(times.begin(), times.begin() + kRuns / 2, times.end());
  outcome.milliseconds = times[kRuns / 2];
  if (made.problem != FillProblem::None) std::printf("refused: %s\n", made.message.c_str());
  for (const FillContact& side : made.figures.sides)
    outcome.angle = std::max(outcome.angle, side.normal_angle);
  for (const RationalBezierPatch& patch : made.patches)
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j)
        outcome.off = std::max(outcome.off, off_graph(point_at(patch, i / 8.0, j / 8.0)));
  return outcome;
}

/// The edge of a collar's face that lies on the hole.
TopoDS_Edge inner_edge(const TopoDS_Face& face, const RationalBezierPatch& patch) {
  const Vec3 middle = point_at(patch, 0.5, 0);
  const gp_Pnt wanted(middle[0], middle[1], middle[2]);
  TopoDS_Edge best;
  double least = 1e100;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    double from = 0, to = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(it.Current()), from, to);
    const double apart = curve->Value(0.5 * (from + to)).Distance(wanted);
    if (apart < least) best = TopoDS::Edge(it.Current());
    least = std::min(least, apart);
  }
  return best;
}

void compare(const TopoDS_Face& filling, int n, Outcome& outcome) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(filling);
  for (int k = 0; k < n; ++k) {
    const RationalBezierPatch patch = collar(n, k);
    for (int i = 0; i < kPlaces; ++i) {
      const PatchJet jet = jet_at(patch, (i + 0.5) / kPlaces, 0, 1);
      GeomAPI_ProjectPointOnSurf foot({jet.point[0], jet.point[1], jet.point[2]}, surface);
      double u = 0, v = 0;
      foot.LowerDistanceParameters(u, v);
      const gp_Dir normal = GeomLProp_SLProps(surface, u, v, 1, 1e-9).Normal();
      const Vec3 n1 = unit(cross(jet.u, jet.v)), n2{normal.X(), normal.Y(), normal.Z()};
      outcome.angle = std::max(outcome.angle, std::asin(std::min(1.0, norm(cross(n1, n2)))));
      const gp_Pnt p = foot.NearestPoint();
      outcome.off = std::max(outcome.off, off_graph({p.X(), p.Y(), p.Z()}));
    }
  }
  const gp_Pnt centre(0.5, 0.5, testing::base_cubic(0.5, 0.5));
  const gp_Pnt foot = GeomAPI_ProjectPointOnSurf(centre, surface).NearestPoint();
  outcome.off = std::max(outcome.off, off_graph({foot.X(), foot.Y(), foot.Z()}));
}

Outcome theirs(int n, FillContinuity continuity) {
  std::vector<TopoDS_Face> faces;
  for (int k = 0; k < n; ++k)
    faces.push_back(
        BRepBuilderAPI_MakeFace(Handle(Geom_Surface)(occt::to_occt(collar(n, k))), 1e-7));
  Outcome outcome;
  TopoDS_Face filling;
  outcome.milliseconds = milliseconds([&] {
    BRepOffsetAPI_MakeFilling maker;
    for (int k = 0; k < n; ++k)
      maker.Add(inner_edge(faces[static_cast<std::size_t>(k)], collar(n, k)),
                faces[static_cast<std::size_t>(k)],
                continuity == FillContinuity::G1 ? GeomAbs_G1 : GeomAbs_G2);
    maker.Build();
    filling = TopoDS::Face(maker.Shape());
  });
  compare(filling, n, outcome);
  return outcome;
}

void print_table() {
  std::printf("            ours                                          MakeFilling\n");
  std::printf(" n          angle     off       ms    first ms   angle     off       ms   ratio\n");
  for (const FillContinuity continuity : {FillContinuity::G1, FillContinuity::G2})
    for (const int n : {3, 4, 5, 6, 8}) {
      const Outcome a = ours(n, continuity), b = theirs(n, continuity);
      std::printf("%2d  %s  %9.1e %9.1e %7.3f %9.2f  %9.1e %9.1e %7.1f %7.0f\n", n,
                  to_string(continuity), a.angle, a.off, a.milliseconds, a.first, b.angle, b.off,
                  b.milliseconds, b.milliseconds / a.milliseconds);
    }
}

}  // namespace
}  // namespace blossom::bench

int main() {
  blossom::bench::print_table();
  return 0;
}
