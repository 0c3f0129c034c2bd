// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/least_box.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/kept_forms.h"
#include "adapters/occt/soundness.h"

namespace blossom::occt {
namespace {

// kDistanceResolution of what the largest coordinates of a shape and a plane beyond it sum up to.
constexpr double kAccuracy = 1e-8;

// What searches and edges are precise to.
constexpr double kPrecision = 2e-7;

void expect_box(const LeastBox& found, const Vec3& low, const Vec3& high) {
  EXPECT_LE(found.precision, kPrecision);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(found.box.low[k], low[k], kAccuracy) << k;
    EXPECT_NEAR(found.box.high[k], high[k], kAccuracy) << k;
  }
}

TEST(LeastBox, OfABoxIsTheBox) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-1, 2, 30), gp_Pnt(4, 5, 31)).Shape();
  expect_box(least_box(box), {-1, 2, 30}, {4, 5, 31});
}

TEST(LeastBox, OfAnUprightTorusHasItsOuterRadii) {
  const gp_Ax2 axes(gp_Pnt(1, 0, 0), gp_Dir(0, 1, 0));
  expect_box(least_box(BRepPrimAPI_MakeTorus(axes, 3, 1).Shape()), {-3, -1, -4}, {5, 1, 4});
}

// With angles of 45 degrees to the axis a torus reaches R cos 45 + r along it.
TEST(LeastBox, OfATurnedTorusIsTangentToIt) {
  const gp_Ax2 axes(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 1));
  const double reach = 3 * std::numbers::sqrt2 / 2 + 1;
  expect_box(least_box(BRepPrimAPI_MakeTorus(axes, 3, 1).Shape()), {-4, -reach, -reach},
             {4, reach, reach});
}

TEST(LeastBox, EndsWhereTrimsDo) {
  const TopoDS_Shape half = BRepPrimAPI_MakeSphere(2, 0, std::numbers::pi / 2).Shape();
  expect_box(least_box(half), {-2, -2, 0}, {2, 2, 2});
}

// z = 2 u (1 - u) (1 + v) over the unit square: the control points reach up to 2.
TEST(LeastBox, OfASplineIsLessThanThatOfItsControlPoints) {
  TColgp_Array2OfPnt poles(1, 3, 1, 2);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(0.5 * i, j, i == 1 ? 1 + j : 0);
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Shape();
  expect_box(least_box(face), {0, 0, 0}, {1, 1, 1});
}

// No search begins for what has no control point outside: a limit that is reached at once is not
// felt.
TEST(LeastBox, DoesNotSearchWhatControlPointsKeepInside) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) poles(i + 1, j + 1) = gp_Pnt(i, j, i == 1 && j == 1 ? 2.5 : 1);
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  builder.Add(all, BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Shape());
  builder.Add(all, BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, 0), gp_Pnt(3, 3, 3)).Shape());
  expect_box(least_box(all, [] { return true; }), {-1, -1, 0}, {3, 3, 3});
}

// The dome reaches out on one side alone; the other sides are those of points.
TEST(LeastBox, SearchesTheSidesThatControlPointsPass) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) poles(i + 1, j + 1) = gp_Pnt(i, j, i == 1 && j == 1 ? -4 : 0);
  const gp_Trsf lift = [] {
    gp_Trsf move;
    move.SetTranslation(gp_Vec(1, 2, 3));
    return move;
  }();
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Shape();
  expect_box(least_box(face.Moved(lift)), {1, 2, 2}, {3, 4, 3});
}

// A dome of which the offset has no exact form.
TEST(LeastBox, TakesTheFormThatTheCheckOfAFaceMade) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) poles(i + 1, j + 1) = gp_Pnt(i, j, i == 1 && j == 1 ? 4 : 0);
  const Handle(Geom_OffsetSurface) offset =
      new Geom_OffsetSurface(new Geom_BezierSurface(poles), 0.1);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(offset, 1e-7);
  const LeastBox alone = least_box(face);
  EXPECT_NEAR(alone.box.high[2], 1.1, kPrecision);
  KeptForms forms;
  EXPECT_TRUE(face_problems(face, &forms).empty());
  // What is kept is what the face was, which shows that it is not converted again.
  offset->SetOffsetValue(0.2);
  const LeastBox taken = least_box(face, {}, &forms);
  EXPECT_EQ(taken.box.high[2], alone.box.high[2]);
  EXPECT_EQ(taken.precision, alone.precision);
  EXPECT_NEAR(least_box(face, {}, &forms).box.high[2], 1.2, kPrecision);
}

// A cylinder's rims go farthest, a half of a cone's where it is cut.
TEST(LeastBox, OfRuledFacesIsThatOfTheirEdges) {
  const double along = std::numbers::sqrt2 / 2;
  const gp_Ax2 axes(gp_Pnt(1, 2, 3), gp_Dir(along, 0, along));
  const TopoDS_Shape pipe = BRepPrimAPI_MakeCylinder(axes, 2, 10).Shape();
  expect_box(least_box(pipe), {1 - 2 * along, 0, 3 - 2 * along},
             {1 + 12 * along, 4, 3 + 12 * along});
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(gp_Ax2(), 2, 0, 5, std::numbers::pi).Shape();
  expect_box(least_box(cone), {-2, 0, 0}, {2, 2, 5});
}

// An edge may be a tenth off its face: then the face counts.
TEST(LeastBox, DoesNotTakeLooseEdgesForTheBorder) {
  BRepPrimAPI_MakeCylinder pipe(2, 10);
  const BRep_Builder builder;
  for (TopExp_Explorer it(pipe.Face(), TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    double from = 0, to = 0;
    const auto rim = Handle(Geom_Circle)::DownCast(BRep_Tool::Curve(edge, from, to));
    builder.UpdateEdge(edge, 0.1);
    if (!rim.IsNull()) rim->SetRadius(1.9);
  }
  expect_box(least_box(pipe.Face()), {-2, -2, 0}, {2, 2, 10});
}

// What Open CASCADE's operations leave: the box is known to the edges' tolerance.
TEST(LeastBox, TakesEdgesForTheBorderWithinTheirTolerance) {
  constexpr double kLoose = 4e-6, kRadius = 400;
  const gp_Ax2 tilted(gp_Pnt(0, 0, 0), gp_Dir(0.3, 0.2, 1));
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(tilted, kRadius, 100, 250).Shape();
  const LeastBox tight = least_box(cone);
  const BRep_Builder builder;
  for (TopExp_Explorer it(cone, TopAbs_EDGE); it.More(); it.Next())
    builder.UpdateEdge(TopoDS::Edge(it.Current()), kLoose);
  const LeastBox loose = least_box(cone);
  EXPECT_LE(loose.precision, 1.01 * kLoose);
  EXPECT_LE(max_norm(loose.box.low - tight.box.low), kLoose);
  EXPECT_LE(max_norm(loose.box.high - tight.box.high), kLoose);
}

TEST(LeastBox, OfArcsIsInClosedForm) {
  const double part = 0.9 * std::numbers::pi, half = std::numbers::sqrt2 / 2;
  const gp_Elips ellipse(gp_Ax2(gp_Pnt(0, 0, 1), gp_Dir(0, 0, 1), gp_Dir(1, 1, 0)), 5, 3);
  const TopoDS_Shape arc = BRepBuilderAPI_MakeEdge(ellipse, -part, part).Shape();
  const LeastBox box = least_box(arc);
  EXPECT_EQ(box.precision, 0);
  const double reach = std::sqrt(0.5 * (25 + 9));
  expect_box(box, {-reach, -reach, 1}, {reach, reach, 1});
  const TopoDS_Shape less = BRepBuilderAPI_MakeEdge(ellipse, 0, part).Shape();
  expect_box(least_box(less), {-reach, half * (5 * std::cos(part) + 3 * std::sin(part)), 1},
             {5 * half, reach, 1});
}

TEST(LeastBox, TakesEdgesAndVerticesWithoutFaces) {
  const gp_Circ circle(gp_Ax2(), 2);
  const TopoDS_Shape arc = BRepBuilderAPI_MakeEdge(circle, 0, 0.75 * std::numbers::pi).Shape();
  expect_box(least_box(arc), {-std::numbers::sqrt2, 0, 0}, {2, 2, 0});
  expect_box(least_box(BRepBuilderAPI_MakeVertex(gp_Pnt(1, 2, 3)).Shape()), {1, 2, 3}, {1, 2, 3});
}

TEST(LeastBox, OfNothingIsRefused) {
  TopoDS_Compound nothing;
  BRep_Builder().MakeCompound(nothing);
  EXPECT_THROW(least_box(nothing), BadModel);
}

}  // namespace
}  // namespace blossom::occt
