// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/edges/pole_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/edge_charts.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

// Radians of a surface of revolution, or parameters: places on a pole that are so near are one.
constexpr double kSamePolePlace = 1e-6;

bool is_pole(const TopoDS_Edge& edge) { return BRep_Tool::Degenerated(edge); }

// Where an edge begins and ends in the chart, as it is walked.
std::pair<gp_Pnt2d, gp_Pnt2d> ends_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  Interval range;
  const Handle(Geom2d_Curve) chart = chart_curve_of(edge, face, range);
  if (chart.IsNull()) throw BadModel("an edge has no parametric curve on the face it bounds");
  const gp_Pnt2d from = chart->Value(range.from), to = chart->Value(range.to);
  return edge.Orientation() == TopAbs_REVERSED ? std::pair{to, from} : std::pair{from, to};
}

// From one place on the pole of a degenerated edge to another.
TopoDS_Edge pole_edge(const TopoDS_Edge& like, const TopoDS_Face& face, const gp_Pnt2d& from,
                      const gp_Pnt2d& to) {
  const auto [origin, other] = ends_of(like, face);
  const gp_Dir2d along(gp_Vec2d(origin, other));
  const auto place = [&, begin = origin](const gp_Pnt2d& uv) {
    return gp_Vec2d(begin, uv).Dot(gp_Vec2d(along));
  };
  const double start = place(from), length = place(to) - start;
  const gp_Pnt2d first = origin.Translated(start * gp_Vec2d(along));
  const Handle(Geom2d_Line) line = new Geom2d_Line(first, length < 0 ? along.Reversed() : along);
  TopLoc_Location location;
  const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, location);
  const TopoDS_Vertex vertex = TopExp::FirstVertex(like);
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge);
  builder.UpdateEdge(edge, line, surface, location, BRep_Tool::Tolerance(like));
  builder.Degenerated(edge, true);
  builder.Range(edge, 0, std::abs(length));
  builder.Add(edge, vertex.Oriented(TopAbs_FORWARD));
  builder.Add(edge, vertex.Oriented(TopAbs_REVERSED));
  return edge;
}

// What a run of degenerated edges becomes; nothing where its neighbours meet.
std::vector<TopoDS_Edge> fitted(const std::vector<TopoDS_Edge>& run, const TopoDS_Edge& before,
                                const TopoDS_Edge& after, const TopoDS_Face& face) {
  const TopoDS_Vertex pole = TopExp::FirstVertex(run.front());
  if (!TopExp::LastVertex(before, true).IsSame(pole) ||
      !TopExp::FirstVertex(after, true).IsSame(pole))
    return run;  // edges in another order
  const gp_Pnt2d from = ends_of(before, face).second, to = ends_of(after, face).first;
  if (from.Distance(ends_of(run.front(), face).first) <= kSamePolePlace &&
      to.Distance(ends_of(run.back(), face).second) <= kSamePolePlace)
    return run;
  if (from.Distance(to) <= kSamePolePlace) return {};
  return {pole_edge(run.front(), face, from, to)};
}

}  // namespace

std::vector<TopoDS_Edge> with_fitted_poles(const std::vector<TopoDS_Edge>& edges,
                                           const TopoDS_Face& face) {
  const auto start = std::ranges::find_if_not(edges, is_pole);
  if (start == edges.end() || std::ranges::none_of(edges, is_pole)) return edges;
  std::vector<TopoDS_Edge> walk = edges, made;
  std::ranges::rotate(walk, walk.begin() + (start - edges.begin()));
  for (std::size_t i = 0; i < walk.size();) {
    std::vector<TopoDS_Edge> run;
    const std::size_t first = i;
    while (i < walk.size() && is_pole(walk[i])) run.push_back(walk[i++]);
    if (!run.empty()) {
      const auto poles = fitted(run, walk[first - 1], walk[i % walk.size()], face);
      made.insert(made.end(), poles.begin(), poles.end());
    } else {
      made.push_back(walk[i++]);
    }
  }
  return made;
}

}  // namespace blossom::occt
