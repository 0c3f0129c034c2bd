// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/missing_curves.h"
// Edges without a curve in the parameters of a face that they bound: made by Open CASCADE's shape
// healing where it can.

#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <ShapeFix_Edge.hxx>
#include <ShapeFix_Wire.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/convert/edge_charts.h"

namespace blossom::occt {
namespace {

/// The missing curves of one wire; those on closed surfaces are brought side by side.
void add_curves(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  ShapeFix_Wire fix;
  fix.Load(wire);
  fix.SetFace(face);
  for (int i = 1; i <= fix.NbEdges(); ++i) {
    const TopoDS_Edge edge = fix.WireData()->Edge(i);
    if (!has_curve_on(edge, face))
      fix.FixEdgeTool()->FixAddPCurve(edge, face, fix.WireData()->IsSeam(i));
  }
  fix.FixShifted();
  for (int i = 1; i <= fix.NbEdges(); ++i)
    if (has_curve_on(fix.WireData()->Edge(i), face))
      fix.FixEdgeTool()->FixSameParameter(fix.WireData()->Edge(i), face);
}

}  // namespace

bool has_curve_on(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  if (keeps_chart_curve(edge, face)) return true;
  TopLoc_Location place;
  if (!BRep_Tool::Surface(face, place)->IsKind(STANDARD_TYPE(Geom_Plane))) {
    double first = 0, last = 0;  // a plane below trims has one, too
    return !BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull();
  }
  double first = 0, last = 0;
  return !BRep_Tool::Curve(edge, place, first, last).IsNull();
}

std::vector<MissingCurve> missing_curves(const TopoDS_Shape& shape) {
  std::vector<MissingCurve> missing;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next())
      if (!has_curve_on(TopoDS::Edge(edge.Current()), TopoDS::Face(face.Current())))
        missing.push_back({TopoDS::Face(face.Current()), TopoDS::Edge(edge.Current())});
  return missing;
}

void add_missing_curves(const TopoDS_Shape& shape) {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    if (missing_curves(it.Current()).empty()) continue;
    const TopoDS_Face face = TopoDS::Face(it.Current().Oriented(TopAbs_FORWARD));
    for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next())
      add_curves(TopoDS::Wire(wire.Current()), face);
  }
}

}  // namespace blossom::occt
