// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/closed_corners.h"
#include "adapters/occt/convert/curves.h"

#include <algorithm>
#include <cmath>
#include <ranges>

#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

namespace blossom::occt {
namespace {

constexpr double kBend = 8;        // in gaps: how much of a curve is bent
constexpr double kMaxBent = 0.25;  // of a curve
constexpr double kMaxGap = 2;      // in tolerances of the vertex
constexpr int kMinDegree = 3;      // so that a straight one, too, is bent smoothly

Handle(BRep_Curve3D) curve_of(const TopoDS_Edge& edge) {
  const auto& curves = Handle(BRep_TEdge)::DownCast(edge.TShape())->Curves();
  for (BRep_ListIteratorOfListOfCurveRepresentation it(curves); it.More(); it.Next())
    if (it.Value()->IsCurve3D() && !it.Value()->Curve3D().IsNull())
      return Handle(BRep_Curve3D)::DownCast(it.Value());
  return {};
}

bool can_be_bent(const Handle(Geom_Curve) & given) {
  const Handle(Geom_Curve) curve = basis_of(given);
  return curve->IsKind(STANDARD_TYPE(Geom_BezierCurve)) ||
         curve->IsKind(STANDARD_TYPE(Geom_BSplineCurve));
}

// Where the curve of an edge begins or ends.
struct End {
  Handle(BRep_Curve3D) of;
  bool last = false;
  gp_Trsf place;  // of the curve in the shape

  double parameter() const { return last ? of->Last() : of->First(); }
  gp_Pnt point() const { return of->Curve3D()->Value(parameter()).Transformed(place); }
};

// The same curve but for its end; null if it does not keep its parameters as a spline. With one
// more knot there, only the last pole has to move.
Handle(Geom_Curve) bent(const End& end, const gp_Pnt& to) {
  const double first = end.of->First(), last = end.of->Last();
  const Handle(Geom_BSplineCurve) spline =
      GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(end.of->Curve3D(), first, last));
  if (spline->IsPeriodic()) spline->SetNotPeriodic();
  const double slack = Precision::PConfusion() * (last - first);
  if (std::abs(spline->FirstParameter() - first) > slack ||
      std::abs(spline->LastParameter() - last) > slack)
    return {};
  spline->IncreaseDegree(std::max(kMinDegree, spline->Degree()));
  const gp_Pnt own = to.Transformed(end.place.Inverted());
  const double speed = spline->DN(end.parameter(), 1).Magnitude();
  const double length = kBend * own.Distance(spline->Value(end.parameter())) / speed;
  const double bend = std::min(length, kMaxBent * (last - first));
  spline->InsertKnot(end.last ? last - bend : first + bend, 1, Precision::PConfusion());
  spline->SetPole(end.last ? spline->NbPoles() : 1, own);
  return spline.get();
}

// A curve that cannot be bent is written as it is.
Handle(Geom_Curve) bent_or_null(const End& end, const gp_Pnt& to) {
  try {
    return bent(end, to);
  } catch (const Standard_Failure&) {
    return {};
  }
}

// The ends of curves at one vertex.
struct Corner {
  double tolerance = 0;
  std::vector<End> ends;

  // Where all of them can be: at the end of one that is not to be bent, else in their middle.
  gp_Pnt common() const {
    gp_XYZ sum;
    for (const End& end : ends) {
      if (!can_be_bent(end.of->Curve3D())) return end.point();
      sum += end.point().XYZ();
    }
    return sum / static_cast<double>(ends.size());
  }
};

// Of an edge that is used in several places, in the first one.
std::vector<Corner> corners_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape vertices;
  TopTools_MapOfShape done;
  std::vector<Corner> corners;
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
    if (!done.Add(edge.Located(TopLoc_Location())) || BRep_Tool::Degenerated(edge)) continue;
    const Handle(BRep_Curve3D) curve = curve_of(edge);
    if (curve.IsNull()) continue;
    const gp_Trsf place = (edge.Location() * curve->Location()).Transformation();
    for (const bool last : {false, true}) {
      const TopoDS_Vertex vertex = last ? TopExp::LastVertex(edge) : TopExp::FirstVertex(edge);
      if (vertex.IsNull()) continue;
      const auto number = static_cast<std::size_t>(vertices.Add(vertex)) - 1;
      if (number == corners.size()) corners.push_back({BRep_Tool::Tolerance(vertex), {}});
      corners[number].ends.push_back({curve, last, place});
    }
  }
  return corners;
}

}  // namespace

ClosedCorners::ClosedCorners(const TopoDS_Shape& shape) {
  for (const Corner& corner : corners_of(shape)) {
    const gp_Pnt common = corner.common();
    for (const End& end : corner.ends) {
      const double gap = end.point().Distance(common);
      if (gap <= Precision::Confusion() || gap > kMaxGap * corner.tolerance ||
          !can_be_bent(end.of->Curve3D()))
        continue;
      bend(end.of, bent_or_null(end, common), gap);
    }
  }
}

void ClosedCorners::bend(const Handle(BRep_Curve3D) & of, const Handle(Geom_Curve) & curve,
                         double gap) {
  if (curve.IsNull()) return;
  given_.push_back({of, of->Curve3D()});
  of->Curve3D(curve);
  worst_ = std::max(worst_, gap);
}

ClosedCorners::~ClosedCorners() {
  for (const Given& each : std::views::reverse(given_)) each.of->Curve3D(each.curve);
}

}  // namespace blossom::occt
