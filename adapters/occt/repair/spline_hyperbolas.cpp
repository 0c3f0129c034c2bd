// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/spline_hyperbolas.h"
#include "adapters/occt/convert/curves.h"

#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <GeomConvert_ApproxCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

namespace blossom::occt {
namespace {

constexpr double kHyperbolaWithin = 1e-9;  // model units: a hundredth of the least tolerance
constexpr int kMaxSpans = 100;             // a choice, as is the degree
constexpr int kMaxSplineDegree = 9;

bool is_hyperbola(const Handle(Geom_Curve) & curve) {
  return basis_of(curve)->IsKind(STANDARD_TYPE(Geom_Hyperbola));
}

// Null if there is none.
Handle(Geom_Curve) spline_of(const BRep_Curve3D& of) try {
  const Handle(Geom_Curve) part = new Geom_TrimmedCurve(of.Curve3D(), of.First(), of.Last());
  const GeomConvert_ApproxCurve made(part, kHyperbolaWithin, GeomAbs_C2, kMaxSpans,
                                     kMaxSplineDegree);
  if (!made.HasResult() || made.MaxError() > kHyperbolaWithin) return {};
  return made.Curve().get();
} catch (const Standard_Failure&) {
  return {};
}

}  // namespace

SplineHyperbolas::SplineHyperbolas(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const auto& curves = Handle(BRep_TEdge)::DownCast(edges(i).TShape())->Curves();
    for (BRep_ListIteratorOfListOfCurveRepresentation it(curves); it.More(); it.Next()) {
      const auto of = Handle(BRep_Curve3D)::DownCast(it.Value());
      if (of.IsNull() || of->Curve3D().IsNull() || !is_hyperbola(of->Curve3D())) continue;
      const Handle(Geom_Curve) spline = spline_of(*of);
      if (spline.IsNull()) continue;
      given_.push_back({of, of->Curve3D()});
      of->Curve3D(spline);
    }
  }
}

SplineHyperbolas::~SplineHyperbolas() {
  for (const Given& each : given_) each.of->Curve3D(each.curve);
}

}  // namespace blossom::occt
