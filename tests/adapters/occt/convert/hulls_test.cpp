// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/convert/hulls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Elips.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "core/bounds/box_tree.h"
#include "tests/support/shapes.h"

namespace blossom::occt {
namespace {

Box box_of(const HullBound& hull) {
  Box box;
  for (const Vec3& p : hull.points) box = joined(box, {p, p});
  return widened(box, hull.margin);
}

bool holds(const Box& box, const gp_Pnt& p) {
  const Vec3 x{p.X(), p.Y(), p.Z()};
  return squared_distance(box, x) <= 1e-24;
}

gp_Trsf turned() {
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 2, 3)), 0.7);
  move.SetTranslation(gp_Vec(3, -2, 5));
  return move * turn;
}

// All edges and faces, where they are and turned about: points of them lie in the hull's box, which
// is not much larger than they are.
void expect_hulls(const TopoDS_Shape& shape, double largest_ratio) {
  const TopoDS_Shape moved = shape.Moved(turned());
  for (TopExp_Explorer it(moved, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    std::vector<Vec3> points;
    ASSERT_TRUE(add_hull(face, points));
    const Box box = box_of(placed_hull(points, face.Location().Transformation()));
    double u0, u1, v0, v1;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    Box sampled;
    for (int i = 0; i <= 400; ++i) {
      const gp_Pnt2d uv(u0 + (u1 - u0) * (i % 20) / 19, v0 + (v1 - v0) * (i / 20) / 20);
      if (BRepClass_FaceClassifier(face, uv, 1e-9).State() == TopAbs_OUT) continue;
      const gp_Pnt p = surface->Value(uv.X(), uv.Y());
      EXPECT_TRUE(holds(box, p)) << surface->DynamicType()->Name();
      sampled = joined(sampled, {{p.X(), p.Y(), p.Z()}, {p.X(), p.Y(), p.Z()}});
    }
    EXPECT_LE(diagonal(box), largest_ratio * diagonal(sampled)) << surface->DynamicType()->Name();
  }
  for (TopExp_Explorer it(moved, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    std::vector<Vec3> points;
    ASSERT_TRUE(add_hull(edge, points));
    const Box box = box_of(placed_hull(points, edge.Location().Transformation()));
    double first, last;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    for (int i = 0; i <= 40; ++i)
      EXPECT_TRUE(holds(box, curve->Value(first + (last - first) * i / 40)));
  }
}

TEST(Hulls, HoldElementaryFaces) {
  const double third = 2 * std::numbers::pi / 3;
  expect_hulls(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), 1.05);
  expect_hulls(BRepPrimAPI_MakeCylinder(2, 3, third).Shape(), 1.2);
  expect_hulls(BRepPrimAPI_MakeCone(2, 0.5, 3, third).Shape(), 1.2);
  expect_hulls(BRepPrimAPI_MakeCone(2, 0, 3).Shape(), 1.2);
  expect_hulls(BRepPrimAPI_MakeSphere(2, -0.3, 1.1, third).Shape(), 1.2);
  expect_hulls(BRepPrimAPI_MakeTorus(3, 1, 0.2, 2.1, third).Shape(), 1.3);
  expect_hulls(BRepPrimAPI_MakeTorus(3, 1).Shape(), 1.2);
}

TEST(Hulls, HoldSweptAndSplineFaces) {
  const TopoDS_Edge arc =
      BRepBuilderAPI_MakeEdge(gp_Elips(gp_Ax2(gp_Pnt(5, 0, 0), gp_Dir(0, 1, 0)), 2, 1), 0.3, 2);
  expect_hulls(BRepPrimAPI_MakePrism(arc, gp_Vec(1, 3, 2)).Shape(), 1.2);
  expect_hulls(BRepPrimAPI_MakeRevol(arc, gp_Ax1(), 1.0).Shape(), 1.2);
  expect_hulls(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeSphere(2).Shape()).Shape(), 1.8);
}

TEST(Hulls, TurnBackwardsAboutLeftHandedAxes) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(0.2, 0.3, 1)));
  expect_hulls(
      BRepBuilderAPI_Transform(BRepPrimAPI_MakeCylinder(2, 3, 1.0).Shape(), mirror).Shape(), 1.2);
}

// A face 1 x 1 on a cylinder of radius 1000, which begins so near to the seam that its surface is
// taken from there: 6e-6 more than the face.
TopoDS_Face face_of(const TopoDS_Shape& shape) {
  return TopoDS::Face(TopExp_Explorer(shape, TopAbs_FACE).Current());
}

// FreeCAD makes tori with angles of the tube from -180 to 180 degrees, and Open CASCADE's own box
// has no height then.
TEST(Bounds, HoldToriWhateverTheAngleOfTheTube) {
  using std::numbers::pi;
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 2, -1)), 0.7);
  for (const gp_Trsf& move : {gp_Trsf(), turn})
    for (const double from : {-pi, -0.5 * pi, -0.3, 0.0, 0.4 * pi})
      for (const double angle : {2 * pi, 0.5 * pi}) {
        const TopoDS_Face face = face_of(BRepPrimAPI_MakeTorus(3, 1, from, from + angle).Shape());
        const TopoDS_Shape moved = face.Moved(TopLoc_Location(move));
        for (const BoxKind kind : {BoxKind::Quick, BoxKind::Least}) {
          const Bnd_Box box = bounds_of(moved, kind);
          for (int i = 0; i <= 12; ++i)
            for (int j = 0; j <= 12; ++j) {
              const gp_Pnt p =
                  BRep_Tool::Surface(face)->Value(2 * pi * i / 12, from + angle * j / 12);
              EXPECT_FALSE(box.IsOut(p.Transformed(move))) << from << ' ' << angle;
            }
        }
      }
}

TEST(Hulls, HoldWhatSnappingToTheSeamAdds) {
  const double radius = 1000, from = 6e-9;
  const gp_Cylinder cylinder(gp_Ax3(), radius);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(cylinder, from, from + 1 / radius, 0, 1).Face();
  const BezierSurface surface = bezier_surface(face);
  ASSERT_EQ(surface.u_knots.front(), 0);
  std::vector<Vec3> points;
  ASSERT_TRUE(add_hull(face, points));
  const Box box = box_of(placed_hull(points, gp_Trsf()));
  for (const double v : {0.0, 1.0}) EXPECT_TRUE(holds(box, gp_Pnt(radius, 0, v)));
  EXPECT_LE(diagonal(box), 1.01 * std::sqrt(2.0));
}

}  // namespace
}  // namespace blossom::occt
