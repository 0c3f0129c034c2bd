// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/grown_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/convert/grown.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

constexpr int kChartSamples = 32;  // of a chart curve, to see how far it goes
constexpr double kRoom = 0.5;      // of what was seen past a border: charts swing between samples

// What of the range of u and v has to be added to, so that chart curves lie in it.
std::array<Interval, 2> range_of_charts(const TopoDS_Face& face,
                                        const std::vector<TopoDS_Edge>& edges,
                                        const std::array<Interval, 2>& own) {
  std::array<Interval, 2> box = own;
  for (const TopoDS_Edge& edge : edges) {
    Interval range;
    const Handle(Geom2d_Curve) chart = chart_curve_of(edge, face, range);
    if (chart.IsNull()) continue;
    for (int i = 0; i <= kChartSamples; ++i) {
      const gp_Pnt2d uv = chart->Value(at(range, static_cast<double>(i) / kChartSamples));
      const std::array<double, 2> place{uv.X(), uv.Y()};
      for (std::size_t k = 0; k < 2; ++k)
        box[k] = {std::min(box[k].from, place[k]), std::max(box[k].to, place[k])};
    }
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const double low = own[k].from - box[k].from, high = box[k].to - own[k].to;
    const double least = Precision::PConfusion() * length(own[k]);
    box[k].from = low > least ? box[k].from - kRoom * low : own[k].from;
    box[k].to = high > least ? box[k].to + kRoom * high : own[k].to;
  }
  return box;
}

void add_charts(const TopoDS_Edge& edge, const TopoDS_Face& from, const TopoDS_Face& to) {
  const BRep_Builder builder;
  const double tolerance = BRep_Tool::Tolerance(edge);
  const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) chart = BRep_Tool::CurveOnSurface(forward, from, first, last);
  if (chart.IsNull()) return;
  if (!BRep_Tool::IsClosed(edge, from)) return builder.UpdateEdge(edge, chart, to, tolerance);
  const Handle(Geom2d_Curve) other =
      BRep_Tool::CurveOnSurface(TopoDS::Edge(forward.Reversed()), from, first, last);
  builder.UpdateEdge(edge, chart, other, to, tolerance);
}

}  // namespace

TopoDS_Face grown_to_edges(const TopoDS_Face& face, const std::vector<TopoDS_Edge>& edges) {
  TopLoc_Location location;
  const Handle(Geom_Surface) own_surface = basis_of(BRep_Tool::Surface(face, location));
  std::array<Interval, 2> own;
  own_surface->Bounds(own[0].from, own[0].to, own[1].from, own[1].to);
  const std::array<Interval, 2> box = range_of_charts(face, edges, own);
  const Handle(Geom_Surface) surface = grown(own_surface, {box[0], box[1]});
  if (surface == own_surface) return face;
  const TopoDS_Face made = TopoDS::Face(face.EmptyCopied());
  BRep_Builder().UpdateFace(made, surface, location, BRep_Tool::Tolerance(face));
  const TopoDS_Face of = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  const TopoDS_Face to = TopoDS::Face(made.Oriented(TopAbs_FORWARD));
  for (const TopoDS_Edge& edge : edges) add_charts(edge, of, to);
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (it.Current().Orientation() == TopAbs_INTERNAL)
      add_charts(TopoDS::Edge(it.Current()), of, to);
  return made;
}

}  // namespace blossom::occt
