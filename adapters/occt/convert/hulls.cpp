// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/convert/hulls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <BRepBndLib.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/surfaces_detail.h"
#include "core/bounds/box_tree.h"

namespace blossom::occt {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
// Of a period, or of the range where there is none: twice what `parameter_box` moves borders by.
constexpr double kSnapping = 4e-9;
// Coordinates from here on mean that there is no end.
constexpr double kEndless = 1e50;

void move_points(const gp_Trsf& move, std::size_t first, std::vector<Vec3>& points) {
  for (std::size_t i = first; i < points.size(); ++i) {
    gp_XYZ at(points[i][0], points[i][1], points[i][2]);
    move.Transforms(at);
    points[i] = vec(at);
  }
}

// --- curves

// Of an arc c + x cos t + y sin t: its ends and where tangents meet, one for each sixth of a turn.
void add_arc_hull(const Vec3& c, const Vec3& x, const Vec3& y, const Interval& turn,
                  std::vector<Vec3>& hull) {
  const double angle = std::min(length(turn), kTurn);
  const int pieces = 1 + static_cast<int>(6 * angle / kTurn);
  const auto at_angle = [&](double t, double far) {
    return c + (far * std::cos(t)) * x + (far * std::sin(t)) * y;
  };
  const double step = angle / pieces;
  for (int i = 0; i < pieces; ++i) {
    const double from = turn.from + i * step;
    hull.push_back(at_angle(from, 1));
    hull.push_back(at_angle(from + 0.5 * step, 1 / std::cos(0.5 * step)));
  }
  hull.push_back(at_angle(turn.from + angle, 1));
}

bool weights_are_positive(const TColStd_Array1OfReal* weights) {
  return weights == nullptr ||
         std::all_of(weights->begin(), weights->end(), [](double w) { return w > 0; });
}

template <class Curve>
bool add_poles(const Curve& curve, std::vector<Vec3>& hull) {
  if (!weights_are_positive(curve.Weights())) return false;
  for (const gp_Pnt& p : curve.Poles()) hull.push_back(vec(p));
  return true;
}

template <class Curve>
void add_conic(const Curve& conic, double along_x, double along_y, const Interval& range,
               std::vector<Vec3>& hull) {
  const gp_Ax2& axes = conic.Position();
  add_arc_hull(vec(axes.Location()), along_x * vec(axes.XDirection().XYZ()),
               along_y * vec(axes.YDirection().XYZ()), range, hull);
}

bool add_curve_hull(const Handle(Geom_Curve) & curve, const Interval& range,
                    std::vector<Vec3>& hull) {
  const Handle(Geom_Curve) basis = basis_of(curve);
  const Geom_Curve* c = basis.get();
  if (const auto* line = dynamic_cast<const Geom_Line*>(c)) {
    hull.push_back(vec(line->Value(range.from)));
    hull.push_back(vec(line->Value(range.to)));
    return true;
  }
  if (const auto* spline = dynamic_cast<const Geom_BSplineCurve*>(c))
    return add_poles(*spline, hull);
  if (const auto* bezier = dynamic_cast<const Geom_BezierCurve*>(c))
    return add_poles(*bezier, hull);
  if (const auto* circle = dynamic_cast<const Geom_Circle*>(c)) {
    add_conic(*circle, circle->Radius(), circle->Radius(), range, hull);
    return true;
  }
  if (const auto* ellipse = dynamic_cast<const Geom_Ellipse*>(c)) {
    add_conic(*ellipse, ellipse->MajorRadius(), ellipse->MinorRadius(), range, hull);
    return true;
  }
  return false;
}

// --- pcurves, in the plane z = 0

bool add_pcurve_hull(const Handle(Geom2d_Curve) & curve, const Interval& range,
                     std::vector<Vec3>& chart) {
  return add_curve_hull(GeomAPI::To3d(curve, gp_Pln()), range, chart);
}

// A surface and its location in a face, as edges of the face refer to it. Those of one face mostly
// have one location.
class SurfaceOfFace {
 public:
  SurfaceOfFace(const Handle(Geom_Surface) & surface, const TopLoc_Location& location)
      : surface_(surface), location_(location), from_edge_(location) {}

  // Adds the pcurves that an edge keeps on the surface; false if there is none.
  bool add_kept_pcurves(const TopoDS_Edge& edge, std::vector<Vec3>& chart) {
    if (edge.Location() != edge_) {
      edge_ = edge.Location();
      from_edge_ = location_.Predivided(edge_);
    }
    const auto* record = static_cast<const BRep_TEdge*>(edge.TShape().get());
    bool any = false;
    for (BRep_ListIteratorOfListOfCurveRepresentation it(record->Curves()); it.More(); it.Next()) {
      const Handle(BRep_CurveRepresentation)& kept = it.Value();
      if (!kept->IsCurveOnSurface(surface_, from_edge_)) continue;
      Interval range;
      static_cast<const BRep_GCurve&>(*kept).Range(range.from, range.to);
      if (!add_pcurve_hull(kept->PCurve(), range, chart)) return false;
      if (kept->IsCurveOnClosedSurface() && !add_pcurve_hull(kept->PCurve2(), range, chart))
        return false;
      any = true;
    }
    return any;
  }

 private:
  const Handle(Geom_Surface) & surface_;
  const TopLoc_Location& location_;
  TopLoc_Location edge_, from_edge_;
};

// --- surfaces

template <class Surface>
bool add_surface_poles(const Surface& surface, std::vector<Vec3>& hull) {
  const TColgp_Array2OfPnt& poles = surface.Poles();
  const TColStd_Array2OfReal* weights = surface.Weights();
  for (int i = poles.LowerRow(); i <= poles.UpperRow(); ++i)
    for (int j = poles.LowerCol(); j <= poles.UpperCol(); ++j) {
      if (weights != nullptr && !(weights->Value(i, j) > 0)) return false;
      hull.push_back(vec(poles(i, j)));
    }
  return true;
}

// Every point of a profile turned about an axis.
void add_turned(const std::vector<Vec3>& profile, const gp_Ax1& axis, const Interval& turn,
                std::vector<Vec3>& hull) {
  const Vec3 origin = vec(axis.Location()), direction = vec(axis.Direction().XYZ());
  for (const Vec3& p : profile) {
    const Vec3 foot = origin + dot(p - origin, direction) * direction;
    add_arc_hull(foot, p - foot, cross(direction, p - foot), turn, hull);
  }
}

struct ChartBox {
  Interval u, v;
};

ChartBox box_of(const std::vector<Vec3>& chart) {
  ChartBox box{{chart[0][0], chart[0][0]}, {chart[0][1], chart[0][1]}};
  for (const Vec3& p : chart) {
    box.u = {std::min(box.u.from, p[0]), std::max(box.u.to, p[0])};
    box.v = {std::min(box.v.from, p[1]), std::max(box.v.to, p[1])};
  }
  return box;
}

// With what snapping parameters to seams may add.
ChartBox snapped(const ChartBox& box, const Geom_Surface& surface) {
  const auto wider = [](const Interval& range, double size) {
    return Interval{range.from - kSnapping * size, range.to + kSnapping * size};
  };
  return {wider(box.u, surface.IsUPeriodic() ? surface.UPeriod() : length(box.u)),
          wider(box.v, surface.IsVPeriodic() ? surface.VPeriod() : length(box.v))};
}

// What turns at u = 0 about the axis of an elementary surface; empty of others.
std::vector<Vec3> profile_of(const Geom_ElementarySurface& surface, const Interval& v) {
  const gp_Ax3& axes = surface.Position();
  const Vec3 o = vec(axes.Location()), x = vec(axes.XDirection().XYZ()),
             z = vec(axes.Direction().XYZ());
  std::vector<Vec3> profile;
  if (const auto* cylinder = dynamic_cast<const Geom_CylindricalSurface*>(&surface)) {
    for (const double t : {v.from, v.to}) profile.push_back(o + cylinder->Radius() * x + t * z);
  } else if (const auto* cone = dynamic_cast<const Geom_ConicalSurface*>(&surface)) {
    const double angle = cone->SemiAngle();
    for (const double t : {v.from, v.to})
      profile.push_back(o + (cone->RefRadius() + t * std::sin(angle)) * x +
                        (t * std::cos(angle)) * z);
  } else if (const auto* sphere = dynamic_cast<const Geom_SphericalSurface*>(&surface)) {
    add_arc_hull(o, sphere->Radius() * x, sphere->Radius() * z, v, profile);
  } else if (const auto* torus = dynamic_cast<const Geom_ToroidalSurface*>(&surface)) {
    const double r = torus->MinorRadius();
    add_arc_hull(o + torus->MajorRadius() * x, r * x, r * z, v, profile);
  }
  return profile;
}

bool add_swept(const Geom_Surface& surface, const ChartBox& box, std::vector<Vec3>& hull) {
  if (const auto* elementary = dynamic_cast<const Geom_ElementarySurface*>(&surface)) {
    const std::vector<Vec3> profile = profile_of(*elementary, box.v);
    // Turned about a left-handed frame's axis the angle runs backwards.
    const bool direct = elementary->Position().Direct();
    add_turned(profile, elementary->Axis(), direct ? box.u : Interval{-box.u.to, -box.u.from},
               hull);
    return !profile.empty();
  }
  std::vector<Vec3> profile;
  if (const auto* turned = dynamic_cast<const Geom_SurfaceOfRevolution*>(&surface)) {
    if (!add_curve_hull(turned->BasisCurve(), box.v, profile)) return false;
    add_turned(profile, turned->Axis(), box.u, hull);
    return true;
  }
  if (const auto* extruded = dynamic_cast<const Geom_SurfaceOfLinearExtrusion*>(&surface)) {
    if (!add_curve_hull(extruded->BasisCurve(), box.u, profile)) return false;
    for (const Vec3& p : profile)
      for (const double t : {box.v.from, box.v.to})
        hull.push_back(p + t * vec(extruded->Direction().XYZ()));
    return true;
  }
  return false;
}

// Of a plane: the pcurves that are kept, else the edges in space, as Open CASCADE projects them.
bool add_plane(const TopoDS_Face& face, const Handle(Geom_Surface) & surface,
               const Geom_Plane& plane, const TopLoc_Location& location, std::vector<Vec3>& hull) {
  const gp_Ax3& axes = plane.Position();
  const Vec3 o = vec(axes.Location()), n = vec(axes.Direction().XYZ());
  const Vec3 x = vec(axes.XDirection().XYZ()), y = vec(axes.YDirection().XYZ());
  SurfaceOfFace known(surface, location);
  std::vector<Vec3> chart;
  for (TopoDS_Iterator wire(face, false, false); wire.More(); wire.Next()) {
    if (wire.Value().ShapeType() != TopAbs_WIRE) continue;
    for (TopoDS_Iterator it(wire.Value(), false, true); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Value());
      chart.clear();
      if (known.add_kept_pcurves(edge, chart)) {
        for (const Vec3& p : chart) hull.push_back(o + p[0] * x + p[1] * y);
        continue;
      }
      std::vector<Vec3> points;
      if (!add_hull(edge, points)) return false;
      if (const TopLoc_Location move = location.Inverted() * edge.Location(); !move.IsIdentity())
        move_points(move.Transformation(), 0, points);
      for (const Vec3& p : points) hull.push_back(p - dot(p - o, n) * n);
    }
  }
  return true;
}

bool add_trimmed(const TopoDS_Face& face, const Handle(Geom_Surface) & surface,
                 const Geom_Surface& basis, const TopLoc_Location& location,
                 std::vector<Vec3>& hull) {
  SurfaceOfFace known(surface, location);
  std::vector<Vec3> chart;
  for (TopoDS_Iterator wire(face, false, false); wire.More(); wire.Next()) {
    if (wire.Value().ShapeType() != TopAbs_WIRE) continue;
    for (TopoDS_Iterator it(wire.Value(), false, true); it.More(); it.Next())
      if (!known.add_kept_pcurves(TopoDS::Edge(it.Value()), chart)) return false;
  }
  return !chart.empty() && add_swept(basis, snapped(box_of(chart), basis), hull);
}

// Without the location of the surface in the face.
bool add_unplaced(const TopoDS_Face& face, const Handle(Geom_Surface) & surface,
                  const TopLoc_Location& location, std::vector<Vec3>& hull) {
  const Handle(Geom_Surface) basis = basis_of(surface);
  if (const auto* spline = dynamic_cast<const Geom_BSplineSurface*>(basis.get()))
    return add_surface_poles(*spline, hull);
  if (const auto* bezier = dynamic_cast<const Geom_BezierSurface*>(basis.get()))
    return add_surface_poles(*bezier, hull);
  if (const auto* plane = dynamic_cast<const Geom_Plane*>(basis.get()))
    return add_plane(face, surface, *plane, location, hull);
  return add_trimmed(face, surface, *basis, location, hull);
}

}  // namespace

bool add_hull(const TopoDS_Edge& edge, std::vector<Vec3>& hull) {
  TopLoc_Location location;
  Interval range;
  const Handle(Geom_Curve)& curve = BRep_Tool::Curve(TopoDS::Edge(edge.Located(TopLoc_Location())),
                                                     location, range.from, range.to);
  if (curve.IsNull()) throw BadModel("an edge has no curve in space");
  const std::size_t first = hull.size();
  if (!add_curve_hull(curve, range, hull)) return false;
  if (!location.IsIdentity()) move_points(location.Transformation(), first, hull);
  return true;
}

bool add_hull(const TopoDS_Face& face, std::vector<Vec3>& hull) {
  TopLoc_Location location;
  const TopoDS_Face unplaced = TopoDS::Face(face.Located(TopLoc_Location()));
  const Handle(Geom_Surface)& surface = BRep_Tool::Surface(unplaced, location);
  if (surface.IsNull()) throw BadModel("the face has no surface");
  const std::size_t first = hull.size();
  if (!add_unplaced(unplaced, surface, location, hull)) return false;
  if (!location.IsIdentity()) move_points(location.Transformation(), first, hull);
  return true;
}

bool has_end(const std::vector<Vec3>& hull) {
  return !hull.empty() &&
         std::all_of(hull.begin(), hull.end(), [](const Vec3& p) { return norm(p) < kEndless; });
}

namespace {

// Where an angle of the tube is negative, as in tori of FreeCAD, Open CASCADE counts its quarters
// from the wrong end.
void add_torus(const TopoDS_Face& face, Bnd_Box& box) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull() || !basis_of(surface)->IsKind(STANDARD_TYPE(Geom_ToroidalSurface))) return;
  std::vector<Vec3> hull;
  if (!add_hull(face, hull)) return;
  Bnd_Box own;
  for (const Vec3& p : hull) own.Add(pnt(p).Transformed(face.Location().Transformation()));
  own.SetGap(BRep_Tool::Tolerance(face));
  box.Add(own);
}

}  // namespace

Bnd_Box bounds_of(const TopoDS_Shape& shape, BoxKind kind) {
  Bnd_Box box;
  if (shape.IsNull()) return box;
  if (kind == BoxKind::Least)
    BRepBndLib::AddOptimal(shape, box, Standard_False, Standard_False);
  else
    BRepBndLib::Add(shape, box, Standard_False);
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    add_torus(TopoDS::Face(it.Current()), box);
  return box;
}

Vec3 middle_of(const TopoDS_Shape& shape) {
  const Bnd_Box box = bounds_of(shape);
  if (box.IsVoid() || box.IsOpen()) return {};
  return vec(0.5 * (box.CornerMin().XYZ() + box.CornerMax().XYZ()));
}

HullBound placed_hull(std::vector<Vec3> hull, const gp_Trsf& place) {
  if (place.Form() != gp_Identity) move_points(place, 0, hull);
  Box box;
  for (const Vec3& p : hull) box = joined(box, {p, p});
  return {std::move(hull), 0x1p-48 * (max_norm(box.low) + max_norm(box.high))};
}

}  // namespace blossom::occt
