// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/stated_tolerance.h"

#include <algorithm>
#include <vector>

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/base/errors.h"
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

double length_of(const TopoDS_Edge& edge) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (curve.IsNull()) return Precision::Infinite();
  return GCPnts_AbscissaPoint::Length(GeomAdaptor_Curve(curve, range.from, range.to));
}

// Nothing if it is what all shapes have.
double stated(double tolerance) {
  return tolerance > kUnstated * Precision::Confusion() ? tolerance : 0;
}

double stated_by(const TopoDS_Face& face, double point) {
  double tolerance = stated(BRep_Tool::Tolerance(face));
  for (TopExp_Explorer it(face, TopAbs_EDGE); tolerance > 0 && it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    if (!BRep_Tool::Degenerated(edge))
      tolerance = std::min(tolerance, kEdgeShare * length_of(edge));
  }
  return std::max(0.5 * point, tolerance);
}

std::vector<StatedFace> stated_by(const TrimTool& solid, double point) {
  std::vector<StatedFace> all;
  for (const TopoDS_Face& face : solid.faces) {
    all.push_back({stated_by(face, point), {}});
    BRepBndLib::Add(face, all.back().box, false);
  }
  return all;
}

}  // namespace

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
