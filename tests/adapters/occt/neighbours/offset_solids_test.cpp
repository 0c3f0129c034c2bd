// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids with offset surfaces, which are approximated: that nothing is found is proven, too.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_MakeOffsetShape.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

/// A closed wave round the z axis, as high as 10.
TopoDS_Shape prism(int points, double radius, double wave, int waves) {
  const Handle(TColgp_HArray1OfPnt) through = new TColgp_HArray1OfPnt(1, points);
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    const double r = radius + wave * std::cos(waves * angle);
    through->SetValue(i + 1, gp_Pnt(r * std::cos(angle), r * std::sin(angle), 0));
  }
  GeomAPI_Interpolate curve(through, true, 1e-7);
  curve.Perform();
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve.Curve())).Wire();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(0, 0, 10)).Shape();
}

TEST(OffsetSolids, AreProvenNotToMeetThemselves) {
  BRepOffsetAPI_MakeOffsetShape offset;
  offset.PerformByJoin(prism(5, 10, 0.5, 2), 0.7, 1e-3, BRepOffset_Skin, false, false, GeomAbs_Arc);
  std::vector<TopoDS_Face> faces;
  int offsets = 0;
  for (TopExp_Explorer it(offset.Shape(), TopAbs_FACE); it.More(); it.Next()) {
    faces.push_back(TopoDS::Face(it.Current()));
    offsets += BRep_Tool::Surface(faces.back())->IsKind(STANDARD_TYPE(Geom_OffsetSurface)) ? 1 : 0;
  }
  ASSERT_GT(offsets, 0);
  const ShapeIntersection found = self_intersect(faces, SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

}  // namespace
}  // namespace blossom::occt
