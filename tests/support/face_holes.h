// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces with polygonal holes in them.

#pragma once

#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "tests/support/holes.h"

namespace blossom::testing {

/// The graph of a cubic over [0, 1]^2 as a face, x = u and y = v, with a hole whose corners are
/// given with the clock; without one if there are none.
inline TopoDS_Face graph_face(const std::vector<Vec2>& hole, const Height& z = base_cubic) {
  const Handle(Geom_Surface) surface = occt::to_occt(collar({0, 0}, {1, 0}, {0, 1}, z));
  BRepBuilderAPI_MakeFace maker(surface, 1e-7);
  if (hole.empty()) return maker.Face();
  BRepBuilderAPI_MakeWire wire;
  std::vector<TopoDS_Vertex> corners;
  for (const Vec2& p : hole) {
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, surface->Value(p[0], p[1]), 1e-7);
    corners.push_back(vertex);
  }
  for (std::size_t k = 0; k < hole.size(); ++k) {
    const Vec2 &a = hole[k], &b = hole[(k + 1) % hole.size()];
    wire.Add(BRepBuilderAPI_MakeEdge(
        GCE2d_MakeSegment(gp_Pnt2d(a[0], a[1]), gp_Pnt2d(b[0], b[1])).Value(), surface, corners[k],
        corners[(k + 1) % hole.size()]));
  }
  maker.Add(wire.Wire());
  TopoDS_Face face = maker.Face();
  BRepLib::BuildCurves3d(face);
  return face;
}

/// A square hole along iso-parameter lines.
inline TopoDS_Face squarely_holed() {
  return graph_face({{0.3, 0.3}, {0.3, 0.7}, {0.7, 0.7}, {0.7, 0.3}});
}

/// The same square turned by half a right angle.
inline TopoDS_Face slantly_holed() {
  return graph_face({{0.25, 0.5}, {0.5, 0.75}, {0.75, 0.5}, {0.5, 0.25}});
}

/// The unit cube without its face z = 1.
inline TopoDS_Shape open_box() {
  TopoDS_Compound box;
  BRep_Builder().MakeCompound(box);
  BRepPrimAPI_MakeBox maker(1, 1, 1);
  for (TopExp_Explorer it(maker.Shape(), TopAbs_FACE); it.More(); it.Next())
    if (!it.Current().IsSame(maker.TopFace())) BRep_Builder().Add(box, it.Current());
  return box;
}

}  // namespace blossom::testing
