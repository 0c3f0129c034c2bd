// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids of revolution and of extrusion whose curved faces are on one surface.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/solid_trim.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

constexpr double kDegree = testing::kPi / 180;
const gp_Ax1 kUp({0, 0, 0}, {0, 0, 1});

Handle(Geom_BSplineCurve) through(const std::vector<gp_Pnt>& points) {
  const Handle(TColgp_HArray1OfPnt) all =
      new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) all->SetValue(static_cast<int>(i) + 1, points[i]);
  GeomAPI_Interpolate made(all, false, 1e-9);
  made.Perform();
  return made.Curve();
}

TopoDS_Face face_beside(const Handle(Geom_BSplineCurve) & curve, const gp_Pnt& foot_of_start,
                        const gp_Pnt& foot_of_end) {
  const gp_Pnt from = curve->StartPoint(), to = curve->EndPoint();
  return BRepBuilderAPI_MakeFace(
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve).Edge(),
                              BRepBuilderAPI_MakeEdge(to, foot_of_end).Edge(),
                              BRepBuilderAPI_MakeEdge(foot_of_end, foot_of_start).Edge(),
                              BRepBuilderAPI_MakeEdge(foot_of_start, from).Edge())
          .Wire());
}

// A vase with many waves.
TopoDS_Shape vase(double angle) {
  const Handle(Geom_BSplineCurve) curve = through(
      {{10, 0, 0}, {18, 0, 3}, {10.1, 0, 6}, {18, 0, 9}, {10.2, 0, 12}, {17, 0, 15}, {5, 0, 18}});
  const TopoDS_Face face = face_beside(curve, {0, 0, 0}, {0, 0, 18});
  return angle == 360 ? BRepPrimAPI_MakeRevol(face, kUp).Shape()
                      : BRepPrimAPI_MakeRevol(face, kUp, angle * kDegree).Shape();
}

TopoDS_Shape turned_by(const TopoDS_Shape& shape, double degrees) {
  gp_Trsf turn;
  turn.SetRotation(kUp, degrees * kDegree);
  return BRepBuilderAPI_Transform(shape, turn, true).Shape();
}

// A wavy wall over a part of its curve, along a slanted direction.
TopoDS_Shape wall(double from, double to, double start, bool reversed) {
  const Handle(Geom_BSplineCurve) curve = through({{0, 1.2, 0},
                                                   {2, -1.8, 0},
                                                   {4, 0.3, 0},
                                                   {6, 1.9, 0},
                                                   {8, -0.7, 0},
                                                   {10, 1.5, 0},
                                                   {12, -2, 0},
                                                   {14, 0, 0}});
  if (from > 0 || to < 1) curve->Segment(from, to);
  if (reversed) curve->Reverse();
  const TopoDS_Face face =
      face_beside(curve, {curve->StartPoint().X(), -10, 0}, {curve->EndPoint().X(), -10, 0});
  const gp_Vec along(3, 2, 10);
  gp_Trsf step;
  step.SetTranslation(start * along);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_Transform(face, step, true).Shape(), along).Shape();
}

SolidTrimResult made_of(SolidOperation operation, const TopoDS_Shape& a, const TopoDS_Shape& b) {
  IntersectionOptions options;
  options.time_limit = 60;
  const SolidTrimResult made = trim_solids(trim_tool(a), {trim_tool(b)}, operation, options);
  EXPECT_EQ(made.obstacles.empty() ? std::string() : made.obstacles.front(), "");
  for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  return made;
}

// With the part of b that is in a: each operation, in both orders.
void expect_part_in_common(const TopoDS_Shape& a, const TopoDS_Shape& b, double part) {
  const SolidTrimResult made = made_of(SolidOperation::Common, a, b);
  const double of_a = made.total.part, of_b = made.total.tools, common = part * of_b;
  const double near = 1e-9 * (of_a + of_b);
  EXPECT_NEAR(made.total.result, common, near);
  EXPECT_NEAR(made_of(SolidOperation::Common, b, a).total.result, common, near);
  EXPECT_NEAR(made_of(SolidOperation::Fuse, a, b).total.result, of_a + of_b - common, near);
  EXPECT_NEAR(made_of(SolidOperation::Cut, a, b).total.result, of_a - common, near);
  EXPECT_NEAR(made_of(SolidOperation::Cut, b, a).total.result, of_b - common, near);
}

TEST(SweptSolids, AVaseIsOneWithItselfTurnedAboutItsAxis) {
  const TopoDS_Shape whole = vase(360);
  for (const double angle : {30.0, 90.0, 180.0})
    expect_part_in_common(whole, turned_by(whole, angle), 1);
}

TEST(SweptSolids, PartsOfAVaseHaveInCommonWhatTheirAnglesHave) {
  const TopoDS_Shape part = vase(200);
  expect_part_in_common(part, turned_by(part, 100), 0.5);
  expect_part_in_common(part, turned_by(part, 200), 0.2);
}

TEST(SweptSolids, WallsAlongPartsOfOneCurveAreOnOneSurface) {
  const TopoDS_Shape whole = wall(0, 1, 0, false);
  for (const bool reversed : {false, true}) {
    expect_part_in_common(whole, wall(0, 1, 0.4, reversed), 0.6);
    expect_part_in_common(whole, wall(0.13, 0.81, -0.3, reversed), 0.7);
  }
}

}  // namespace
}  // namespace blossom::occt
