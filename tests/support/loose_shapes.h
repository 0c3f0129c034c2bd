// SPDX-License-Identifier: LGPL-2.1-or-later
// Cylinders whose rims do not fit their faces.

#pragma once

#include <vector>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Circle.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace blossom::testing {

/// The curve of an edge in the parameters of a face.
inline Handle(Geom2d_Curve) image_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double first = 0, last = 0;
  return BRep_Tool::CurveOnSurface(edge, face, first, last);
}

/// The side of a cylinder, its first face.
inline TopoDS_Face side_of(const TopoDS_Shape& cylinder) {
  return TopoDS::Face(TopExp_Explorer(cylinder, TopAbs_FACE).Current());
}

/// The rims of a cylinder: its edges that are no seam.
inline std::vector<TopoDS_Edge> rims_of(const TopoDS_Shape& cylinder) {
  std::vector<TopoDS_Edge> rims;
  const TopoDS_Face side = side_of(cylinder);
  for (TopExp_Explorer it(side, TopAbs_EDGE); it.More(); it.Next())
    if (const TopoDS_Edge edge = TopoDS::Edge(it.Current()); !BRep_Tool::IsClosed(edge, side))
      rims.push_back(edge);
  return rims;
}

/// A cylinder one of whose rims has an image on the side that lies off it, with tolerances that
/// cover it.
inline TopoDS_Shape cylinder_with_loose_image(double off) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  const TopoDS_Face side = side_of(cylinder);
  const TopoDS_Edge rim = rims_of(cylinder).front();
  const auto moved =
      Handle(Geom2d_Curve)::DownCast(image_of(rim, side)->Translated(gp_Vec2d(0, off)));
  BRep_Builder().UpdateEdge(rim, moved, side, 1.1 * off);
  for (TopExp_Explorer it(rim, TopAbs_VERTEX); it.More(); it.Next())
    BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), 1.1 * off);
  return cylinder;
}

/// A cylinder one of whose rims is wider in space than its faces, without a tolerance that says so.
inline TopoDS_Shape cylinder_with_wide_rim(double off) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  const TopoDS_Edge rim = rims_of(cylinder).front();
  double first = 0, last = 0;
  const auto circle = Handle(Geom_Circle)::DownCast(BRep_Tool::Curve(rim, first, last));
  BRep_Builder().UpdateEdge(rim, new Geom_Circle(circle->Position(), 1 + off), 1e-7);
  return cylinder;
}

}  // namespace blossom::testing
