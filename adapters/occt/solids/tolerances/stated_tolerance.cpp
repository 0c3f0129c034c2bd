// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/tolerances/stated_tolerance.h"

#include <algorithm>
#include <vector>

#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

constexpr double kEdgeShare = 0.1;  // of the shortest edge: what a tolerance may be at most
// Of the confusion: steps of Open CASCADE raise a tolerance by so much without a reason.
constexpr double kUnstated = 1.001;

struct StatedFace {
  double tolerance = 0;
  Bnd_Box box;
};

// Nothing if it is what all shapes have.
double stated(double tolerance) {
  return tolerance > kUnstated * Precision::Confusion() ? tolerance : 0;
}

double stated_by(const TopoDS_Face& face, double point) {
  double tolerance = stated(BRep_Tool::Tolerance(face));
  for (TopExp_Explorer it(face, TopAbs_EDGE); tolerance > 0 && it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    if (!BRep_Tool::Degenerated(edge))
      tolerance = std::min(tolerance, kEdgeShare * edge_length(edge));
  }
  return std::max(0.5 * point, tolerance);
}

std::vector<StatedFace> stated_by(const TrimTool& solid, double point) {
  std::vector<StatedFace> all;
  for (const TopoDS_Face& face : solid.faces) {
    all.push_back({stated_by(face, point), bounds_of(face)});
  }
  return all;
}

constexpr int kGapSamples = 16;  // of an edge along another one

struct CorneredEdge {
  TopoDS_Edge edge;
  RangedCurve curve;
  double tolerance = 0;  // the lesser of its vertices
  Bnd_Box box;
};

std::vector<CorneredEdge> cornered_edges(const TrimTool& solid) {
  TopTools_IndexedMapOfShape edges;
  for (const TopoDS_Face& face : solid.faces) TopExp::MapShapes(face, TopAbs_EDGE, edges);
  std::vector<CorneredEdge> all;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD));
    if (BRep_Tool::Degenerated(edge)) continue;
    CorneredEdge made{edge, curve_of(edge), 0, {}};
    const TopoDS_Vertex from = TopExp::FirstVertex(edge), to = TopExp::LastVertex(edge);
    if (made.curve.curve.IsNull() || from.IsNull() || to.IsNull()) continue;
    const double least = std::min(BRep_Tool::Tolerance(from), BRep_Tool::Tolerance(to));
    made.tolerance = std::min(stated(least), kEdgeShare * edge_length(edge));
    made.box = bounds_of(edge);
    all.push_back(std::move(made));
  }
  return all;
}

// The largest distance of an edge from another one if it runs along it; else 0.
double gap_along(const CorneredEdge& edge, const CorneredEdge& other) {
  double largest = 0;
  for (int i = 0; i <= kGapSamples; ++i) {
    const double t = at(edge.curve.range, static_cast<double>(i) / kGapSamples);
    const double gap = foot_on(other.curve, edge.curve.curve->Value(t)).distance;
    if (gap > edge.tolerance) return 0;
    largest = std::max(largest, gap);
  }
  return largest;
}

}  // namespace

double gap_between_corners(const TrimTool& a, const TrimTool& b) {
  return guarded("comparing corners", [&] {
    const std::vector<CorneredEdge> of_a = cornered_edges(a), of_b = cornered_edges(b);
    double largest = 0;
    const auto consider = [&](const CorneredEdge& edge, const CorneredEdge& other) {
      if (edge.tolerance <= largest) return;
      Bnd_Box reached = edge.box;
      reached.Enlarge(edge.tolerance);
      if (!reached.IsOut(other.box)) largest = std::max(largest, gap_along(edge, other));
    };
    for (const CorneredEdge& x : of_a)
      for (const CorneredEdge& y : of_b) {
        consider(x, y);
        consider(y, x);
      }
    return largest;
  });
}

double stated_tolerance(const TrimTool& a, const TrimTool& b, double point) {
  const auto states = [](const TopoDS_Face& face) {
    return stated(BRep_Tool::Tolerance(face)) > 0;
  };
  if (std::ranges::none_of(a.faces, states) && std::ranges::none_of(b.faces, states)) return point;
  return guarded("reading tolerances", [&] {
    const std::vector<StatedFace> of_a = stated_by(a, point), of_b = stated_by(b, point);
    double largest = point;
    for (const StatedFace& x : of_a)
      for (const StatedFace& y : of_b)
        if (x.tolerance + y.tolerance > largest && !x.box.IsOut(y.box))
          largest = x.tolerance + y.tolerance;
    return largest;
  });
}

}  // namespace blossom::occt
