// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/pairs/shared_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/faces/face_trims.h"
#include "core/results/hermite_curves.h"

namespace blossom::occt {
namespace {

constexpr int kMinPieces = 48;
constexpr int kMaxPieces = 1024;
constexpr double kFitShare = 0.25;        // of the edge's tolerance, left to the curves' fit
constexpr double kTangentialSine = 1e-3;  // below it all along, the faces touch

// An edge as each of two faces has it: turned the other way it may have another chart curve.
struct EdgeUses {
  TopoDS_Edge in_a, in_b;
};

// The edge and its two chart curves, evaluated by one parameter.
class EdgeOnFaces {
 public:
  EdgeOnFaces(const EdgeUses& edge, const TopoDS_Face& a, const TopoDS_Face& b)
      : surface_a_(a, false), surface_b_(b, false) {
    space_ = BRep_Tool::Curve(edge.in_a, range_.from, range_.to);
    Interval ignored;
    chart_a_ = chart_curve_of(edge.in_a, a, ignored);
    chart_b_ = chart_curve_of(edge.in_b, b, ignored);
    if (space_.IsNull() || chart_a_.IsNull() || chart_b_.IsNull())
      throw BadModel("a shared edge has no curve in space or on a face");
  }

  const Interval& range() const { return range_; }

  SurfacePoint at(double t) const {
    const gp_Pnt p = space_->Value(t);
    const gp_Pnt2d a = chart_a_->Value(t), b = chart_b_->Value(t);
    return {{p.X(), p.Y(), p.Z()}, {a.X(), a.Y()}, {b.X(), b.Y()}};
  }

  // Gauss's rule of five points: of a piece that hardly turns, exact but for rounding.
  double length(const Interval& piece) const {
    constexpr std::array kNodes{0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array kWeights{128.0 / 225, 0.4786286704993665, 0.2369268850561891};
    const auto speed = [&](double x) { return norm(jet(::blossom::at(piece, x)).rate.point); };
    double sum = kWeights[0] * speed(0.5);
    for (std::size_t i = 1; i < kNodes.size(); ++i)
      sum += kWeights[i] * (speed(0.5 - 0.5 * kNodes[i]) + speed(0.5 + 0.5 * kNodes[i]));
    return 0.5 * sum * blossom::length(piece);
  }

  HermiteJet jet(double t) const {
    gp_Pnt p;
    gp_Vec dp;
    gp_Pnt2d a, b;
    gp_Vec2d da, db;
    space_->D1(t, p, dp);
    chart_a_->D1(t, a, da);
    chart_b_->D1(t, b, db);
    return {{{p.X(), p.Y(), p.Z()}, {a.X(), a.Y()}, {b.X(), b.Y()}},
            {{dp.X(), dp.Y(), dp.Z()}, {da.X(), da.Y()}, {db.X(), db.Y()}}};
  }

  std::vector<HermiteJet> jets(int pieces) const {
    std::vector<HermiteJet> all;
    for (int i = 0; i <= pieces; ++i)
      all.push_back(jet(::blossom::at(range_, static_cast<double>(i) / pieces)));
    return all;
  }

  double sine(const SurfacePoint& x) const {
    const gp_Vec na = normal(surface_a_, x.uv_a), nb = normal(surface_b_, x.uv_b);
    const double product = na.Magnitude() * nb.Magnitude();
    return product > 0 ? na.Crossed(nb).Magnitude() / product : 0;
  }

  Deviation gaps(const SurfacePoint& x) const {
    const gp_Pnt p(x.point[0], x.point[1], x.point[2]);
    const gp_Pnt a = surface_a_.Value(x.uv_a[0], x.uv_a[1]);
    const gp_Pnt b = surface_b_.Value(x.uv_b[0], x.uv_b[1]);
    return {p.Distance(a), p.Distance(b), a.Distance(b), false};
  }

 private:
  static gp_Vec normal(const BRepAdaptor_Surface& surface, const Vec2& uv) {
    gp_Pnt p;
    gp_Vec du, dv;
    surface.D1(uv[0], uv[1], p, du, dv);
    return du.Crossed(dv);
  }

  BRepAdaptor_Surface surface_a_, surface_b_;
  Handle(Geom_Curve) space_;
  Handle(Geom2d_Curve) chart_a_, chart_b_;
  Interval range_;
};

void measure(const EdgeOnFaces& edge, IntersectionCurve& curve) {
  curve.deviation = {0, 0, 0, false};
  const auto look = [&](double t) {
    const SurfacePoint x{point_at(curve.curve, t), point_at(curve.chart_a, t),
                         point_at(curve.chart_b, t)};
    raise(curve.deviation, edge.gaps(x));
  };
  curve.length = 0;
  for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i) {
    const Interval piece{curve.sample_parameters[i], curve.sample_parameters[i + 1]};
    for (const double t : {0.0, 0.3, 0.5, 0.8}) look(at(piece, t));
    curve.length += edge.length(piece);
  }
}

// More pieces until the fit adds little to what the edge itself is off by.
IntersectionCurve curve_of(const EdgeOnFaces& edge, double tolerance) {
  for (int pieces = kMinPieces;; pieces *= 2) {
    IntersectionCurve curve = hermite_curve(edge.jets(pieces), edge.range());
    double off = 0;
    for (int i = 0; i < pieces; ++i) {
      const double t = at(edge.range(), (i + 0.5) / pieces);
      off = std::max(off, distance(point_at(curve.curve, t), edge.at(t).point));
    }
    if (off > kFitShare * tolerance && pieces < kMaxPieces) continue;
    measure(edge, curve);
    return curve;
  }
}

SharedEdge shared_edge(const EdgeUses& uses, const TopoDS_Face& a, const TopoDS_Face& b) {
  const EdgeOnFaces on_faces(uses, a, b);
  const TopoDS_Edge& edge = uses.in_a;
  SharedEdge result;
  result.tolerance = BRep_Tool::Tolerance(edge);
  result.curve = curve_of(on_faces, result.tolerance);
  IntersectionCurve& curve = result.curve;
  curve.least_angle = 1;
  for (const SurfacePoint& x : curve.samples) {
    const double sine = on_faces.sine(x);
    result.most_sine = std::max(result.most_sine, sine);
    curve.least_angle = std::min(curve.least_angle, sine);
    const Deviation gaps = on_faces.gaps(x);
    result.gap = std::max({result.gap, gaps.a, gaps.b, gaps.between});
  }
  curve.least_angle = std::asin(std::min(curve.least_angle, 1.0));
  curve.tangential = result.most_sine < kTangentialSine;
  curve.ends = {CurveEnd::BorderA, CurveEnd::BorderA};
  const double gap = distance(curve.samples.front().point, curve.samples.back().point);
  if (gap <= result.tolerance && TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge))) {
    curve.closed = true;
    curve.ends = {CurveEnd::Closed, CurveEnd::Closed};
    curve.samples.back().point = curve.samples.front().point;
  }
  return result;
}

TopTools_IndexedMapOfShape parts_of(const TopoDS_Face& face, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(face, kind, parts);
  return parts;
}

// Zero is what the map answers for none.
int number_in(const TopTools_IndexedMapOfShape& shapes, const TopoDS_Shape& shape) {
  return shapes.FindIndex(shape) - 1;
}

}  // namespace

std::vector<SharedEdge> shared_edges(const TopoDS_Face& a, const TopoDS_Face& b) {
  std::vector<SharedEdge> result;
  if (a.IsSame(b)) return result;
  const TopTools_IndexedMapOfShape of_a = parts_of(a, TopAbs_EDGE), of_b = parts_of(b, TopAbs_EDGE);
  std::optional<std::array<TrimShapes, 2>> shapes;
  for (int i = 1; i <= of_a.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(of_a(i));
    if (!of_b.Contains(edge) || BRep_Tool::Degenerated(edge)) continue;
    if (is_seam(edge, a) || is_seam(edge, b)) continue;
    if (!shapes) shapes = {trim_shapes(a), trim_shapes(b)};
    SharedEdge& added =
        result.emplace_back(shared_edge({edge, TopoDS::Edge(of_b(of_b.FindIndex(edge)))}, a, b));
    added.in_a = number_in((*shapes)[0].edges, edge);
    added.in_b = number_in((*shapes)[1].edges, edge);
  }
  return result;
}

std::vector<SharedVertex> shared_vertices(const TopoDS_Face& a, const TopoDS_Face& b) {
  std::vector<SharedVertex> result;
  const TopTools_IndexedMapOfShape of_a = parts_of(a, TopAbs_VERTEX),
                                   of_b = parts_of(b, TopAbs_VERTEX);
  std::optional<std::array<TrimShapes, 2>> shapes;
  for (int i = 1; i <= of_a.Extent(); ++i) {
    if (!of_b.Contains(of_a(i))) continue;
    if (!shapes) shapes = {trim_shapes(a), trim_shapes(b)};
    const TopoDS_Vertex vertex = TopoDS::Vertex(of_a(i));
    result.push_back({number_in((*shapes)[0].vertices, vertex),
                      number_in((*shapes)[1].vertices, vertex), vec(BRep_Tool::Pnt(vertex)),
                      BRep_Tool::Tolerance(vertex)});
  }
  return result;
}

}  // namespace blossom::occt
