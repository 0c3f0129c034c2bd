// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/grown_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/convert/edge_charts.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {
namespace {

constexpr int kChartSamples = 32;  // of a chart curve, to see how far it goes
constexpr double kRoom = 0.5;      // of what was seen past a border: charts swing between samples

// A row of weighted control points, and its knots, each as often as it counts.
struct Row {
  std::size_t degree = 1;
  std::vector<double> knots;
  std::vector<Vec<double, 4>> points;
};

// The polar form of the last span, by de Boor's algorithm with one argument a step.
Vec<double, 4> polar(const Row& row, const std::vector<double>& arguments) {
  const std::size_t p = row.degree, first = row.points.size() - 1 - p;
  std::vector<Vec<double, 4>> d(row.points.end() - static_cast<std::ptrdiff_t>(p) - 1,
                                row.points.end());
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t i = p; i >= r; --i) {
      const double low = row.knots[first + i], high = row.knots[first + i + p + 1 - r];
      const double share = (arguments[r - 1] - low) / (high - low);
      d[i] = (1 - share) * d[i - 1] + share * d[i];
    }
  return d[p];
}

// The row with its last knot moved: control points are polar values at the knots between theirs.
//
// Source: Ramshaw 1989, "Blossoms are polar forms".
void move_last_knot(Row& row, double to) {
  const Row old = row;
  const std::size_t p = row.degree, count = row.points.size();
  std::fill(row.knots.end() - static_cast<std::ptrdiff_t>(p) - 1, row.knots.end(), to);
  for (std::size_t i = count - p; i < count; ++i) {
    const auto from = row.knots.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    row.points[i] = polar(old, {from, from + static_cast<std::ptrdiff_t>(p)});
  }
}

void turn(Row& row) {
  std::ranges::reverse(row.points);
  std::ranges::reverse(row.knots);
  for (double& knot : row.knots) knot = -knot;
}

void grow(Row& row, const Interval& to) {
  if (to.to > row.knots.back()) move_last_knot(row, to.to);
  if (to.from >= row.knots.front()) return;
  turn(row);
  move_last_knot(row, -to.from);
  turn(row);
}

std::vector<double> flat_knots(const Handle(Geom_BSplineSurface) & of, bool in_u) {
  const TColStd_Array1OfReal& knots = in_u ? of->UKnotSequence() : of->VKnotSequence();
  return {knots.begin(), knots.end()};
}

// Over a larger range of u or v.
Handle(Geom_BSplineSurface)
    grown(const Handle(Geom_BSplineSurface) & of, bool in_u, const Interval& to) {
  const int along = in_u ? of->NbUPoles() : of->NbVPoles();
  const int across = in_u ? of->NbVPoles() : of->NbUPoles();
  TColgp_Array2OfPnt poles(1, of->NbUPoles(), 1, of->NbVPoles());
  TColStd_Array2OfReal weights(1, of->NbUPoles(), 1, of->NbVPoles());
  for (int k = 1; k <= across; ++k) {
    Row row{
        static_cast<std::size_t>(in_u ? of->UDegree() : of->VDegree()), flat_knots(of, in_u), {}};
    for (int i = 1; i <= along; ++i) {
      const gp_Pnt p = in_u ? of->Pole(i, k) : of->Pole(k, i);
      const double w = in_u ? of->Weight(i, k) : of->Weight(k, i);
      row.points.push_back({w * p.X(), w * p.Y(), w * p.Z(), w});
    }
    grow(row, to);
    for (int i = 1; i <= along; ++i) {
      const Vec<double, 4>& h = row.points[static_cast<std::size_t>(i) - 1];
      if (!(h[3] > 0)) return of;
      const int u = in_u ? i : k, v = in_u ? k : i;
      poles(u, v) = gp_Pnt(h[0] / h[3], h[1] / h[3], h[2] / h[3]);
      weights(u, v) = h[3];
    }
  }
  TColStd_Array1OfReal u_knots = of->UKnots(), v_knots = of->VKnots();
  TColStd_Array1OfReal& knots = in_u ? u_knots : v_knots;
  knots.ChangeFirst() = std::min(knots.First(), to.from);
  knots.ChangeLast() = std::max(knots.Last(), to.to);
  const TColStd_Array1OfInteger u_counts = of->UMultiplicities(), v_counts = of->VMultiplicities();
  if (of->IsURational() || of->IsVRational())
    return new Geom_BSplineSurface(poles, weights, u_knots, v_knots, u_counts, v_counts,
                                   of->UDegree(), of->VDegree());
  return new Geom_BSplineSurface(poles, u_knots, v_knots, u_counts, v_counts, of->UDegree(),
                                 of->VDegree());
}

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
  const auto spline = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face, location));
  if (spline.IsNull()) return face;
  std::array<Interval, 2> own;
  spline->Bounds(own[0].from, own[0].to, own[1].from, own[1].to);
  const std::array<Interval, 2> box = range_of_charts(face, edges, own);
  const std::array<bool, 2> closes{spline->IsUClosed() == Standard_True,
                                   spline->IsVClosed() == Standard_True};
  Handle(Geom_BSplineSurface) surface = spline;
  for (const std::size_t k : {0U, 1U})
    if (!closes[k] && !(box[k] == own[k])) surface = grown(surface, k == 0, box[k]);
  if (surface == spline) return face;
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
