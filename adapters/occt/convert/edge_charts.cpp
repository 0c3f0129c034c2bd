// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/convert/edge_charts.h"

#include <cmath>

#include <BRep_CurveRepresentation.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <gp_Ax22d.hxx>
#include <gp_Trsf.hxx>

namespace blossom::occt {
namespace {

// Sine of the angle to the plane: what lies in it so nearly is shorter in projection by half the
// square, less than rounding.
constexpr double kTilt = 1e-8;

// The coordinates of a plane.
class PlaneChart {
 public:
  explicit PlaneChart(const gp_Ax3& place) : place_(place) {}

  bool holds(const gp_Dir& direction) const {
    return std::abs(direction.Dot(place_.Direction())) <= kTilt;
  }
  gp_Pnt2d at(const gp_Pnt& point) const {
    const gp_Vec off(place_.Location(), point);
    return {off.Dot(place_.XDirection()), off.Dot(place_.YDirection())};
  }
  gp_Dir2d along(const gp_Dir& direction) const {
    return {direction.Dot(place_.XDirection()), direction.Dot(place_.YDirection())};
  }
  gp_Ax22d at(const gp_Ax2& axes) const {
    return {at(axes.Location()), along(axes.XDirection()), along(axes.YDirection())};
  }

 private:
  gp_Ax3 place_;
};

// Null if it is another kind of curve, or leaves the plane.
Handle(Geom2d_Curve) in_plane(const Handle(Geom_Curve) & curve, const PlaneChart& chart) {
  if (const auto line = Handle(Geom_Line)::DownCast(curve); !line.IsNull()) {
    const gp_Ax1& axis = line->Position();
    if (!chart.holds(axis.Direction())) return {};
    return new Geom2d_Line(chart.at(axis.Location()), chart.along(axis.Direction()));
  }
  const auto conic = Handle(Geom_Conic)::DownCast(curve);
  if (conic.IsNull()) return {};
  const gp_Ax2& axes = conic->Position();
  if (!chart.holds(axes.XDirection()) || !chart.holds(axes.YDirection())) return {};
  if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull())
    return new Geom2d_Circle(chart.at(axes), circle->Radius());
  if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve); !ellipse.IsNull())
    return new Geom2d_Ellipse(chart.at(axes), ellipse->MajorRadius(), ellipse->MinorRadius());
  return {};
}

bool keeps_chart_curve(const TopoDS_Edge& edge, const Handle(Geom_Surface) & surface,
                       const TopLoc_Location& place) {
  const TopLoc_Location from_edge = place.Predivided(edge.Location());
  const auto* record = static_cast<const BRep_TEdge*>(edge.TShape().get());
  for (BRep_ListIteratorOfListOfCurveRepresentation it(record->Curves()); it.More(); it.Next())
    if (it.Value()->IsCurveOnSurface(surface, from_edge)) return true;
  return false;
}

// Null where it takes more than a change of coordinates.
Handle(Geom2d_Curve) in_plane(const TopoDS_Edge& edge, const Handle(Geom_Plane) & plane,
                              const TopLoc_Location& place, Interval& range) {
  TopLoc_Location of_curve;
  Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, of_curve, range.from, range.to);
  if (curve.IsNull()) return {};
  if (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve); !trimmed.IsNull())
    curve = trimmed->BasisCurve();
  gp_Ax3 axes = plane->Position();
  if (const TopLoc_Location way = place.Predivided(of_curve); !way.IsIdentity()) {
    const gp_Trsf& move = way.Transformation();
    if (move.ScaleFactor() != 1) return {};
    axes.Transform(move);
  }
  return in_plane(curve, PlaneChart(axes));
}

}  // namespace

Handle(Geom2d_Curve)
    chart_curve_of(const TopoDS_Edge& edge, const TopoDS_Face& face, Interval& range) {
  TopLoc_Location place;
  const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, place);
  const auto plane = Handle(Geom_Plane)::DownCast(surface);
  if (!plane.IsNull() && !keeps_chart_curve(edge, surface, place))
    if (const Handle(Geom2d_Curve) chart = in_plane(edge, plane, place, range); !chart.IsNull())
      return chart;
  // By the face: of a seam, the side depends on how that is turned.
  return BRep_Tool::CurveOnSurface(edge, face, range.from, range.to);
}

Handle(Geom2d_Curve) plane_curve_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  TopLoc_Location place;
  const auto plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face, place));
  Interval range;
  return plane.IsNull() ? nullptr : in_plane(edge, plane, place, range);
}

Handle(Geom2d_Curve) plane_curve_of(const Handle(Geom_Curve) & curve, const TopoDS_Face& face) {
  const auto plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face));
  return plane.IsNull() ? nullptr : in_plane(curve, PlaneChart(plane->Position()));
}

bool is_seam(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  if (!BRep_Tool::IsClosed(edge, face)) return false;
  int uses = 0;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (it.Current().IsSame(edge)) ++uses;
  return uses > 1;
}

bool keeps_chart_curve(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  TopLoc_Location place;
  const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, place);
  return keeps_chart_curve(edge, surface, place);
}

}  // namespace blossom::occt
