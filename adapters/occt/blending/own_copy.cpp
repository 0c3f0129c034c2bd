// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/own_copy.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

namespace blossom::occt {
namespace {

// Model units, a hundredth of what edges are given at least: they keep to the plane as they did to
// the spline.
constexpr double kFlat = 0.01 * 1e-7;

TopoDS_Shape copied(const TopoDS_Shape& shape, TopTools_DataMapOfShapeShape& known) {
  const TopoDS_Shape plain = shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
  if (!known.IsBound(plain)) {
    TopoDS_Shape made = plain.EmptyCopied();
    if (made.ShapeType() == TopAbs_FACE)
      BRep_Builder().NaturalRestriction(TopoDS::Face(made),
                                        BRep_Tool::NaturalRestriction(TopoDS::Face(plain)));
    for (TopoDS_Iterator it(plain, Standard_False, Standard_False); it.More(); it.Next())
      BRep_Builder().Add(made, copied(it.Value(), known));
    made.Closed(plain.Closed());
    made.Infinite(plain.Infinite());
    made.Convex(plain.Convex());
    known.Bind(plain, made);
  }
  return known.Find(plain).Located(shape.Location(), false).Oriented(shape.Orientation());
}

// The plane that a spline is, with its normal; null if it is none. It lies in the hull of its
// poles.
template <class Spline>
Handle(Geom_Plane) plane_of_poles(const Spline& surface) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface.Bounds(u0, u1, v0, v1);
  gp_Pnt point;
  gp_Vec du, dv;
  surface.D1(0.5 * (u0 + u1), 0.5 * (v0 + v1), point, du, dv);
  const gp_Vec normal = du.Crossed(dv);
  if (normal.Magnitude() < Precision::SquareConfusion() || du.Magnitude() < Precision::Confusion())
    return {};
  const Handle(Geom_Plane) plane = new Geom_Plane(gp_Ax3(point, normal, du));
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int k = 1; k <= surface.NbVPoles(); ++k)
      if (plane->Pln().Distance(surface.Pole(i, k)) > kFlat) return {};
  return plane;
}

Handle(Geom_Plane) plane_of(Handle(Geom_Surface) surface) {
  if (const auto part = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface); !part.IsNull())
    surface = part->BasisSurface();
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull())
    return plane_of_poles(*spline);
  if (const auto patch = Handle(Geom_BezierSurface)::DownCast(surface); !patch.IsNull())
    return plane_of_poles(*patch);
  return {};
}

}  // namespace

void flatten(const TopoDS_Shape& copy) {
  for (TopExp_Explorer it(copy, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    TopLoc_Location place;
    const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, place);
    if (surface.IsNull()) continue;
    if (const Handle(Geom_Plane) plane = plane_of(surface); !plane.IsNull())
      BRep_Builder().UpdateFace(face, plane, place, BRep_Tool::Tolerance(face));
  }
}

void unflatten(const TopoDS_Face& copy, const TopoDS_Face& of) {
  TopLoc_Location place;
  const Handle(Geom_Surface)& surface = BRep_Tool::Surface(of, place);
  BRep_Builder().UpdateFace(copy, surface, place, BRep_Tool::Tolerance(of));
}

TopoDS_Shape own_copy(const TopoDS_Shape& shape) {
  TopTools_DataMapOfShapeShape known;
  return copied(shape, known);
}

}  // namespace blossom::occt
