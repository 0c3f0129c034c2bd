// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets whose sections change along the edge, or are no circles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <GeomLProp_SLProps.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "core/base/errors.h"
#include "tests/adapters/occt/fillet_checks.h"
#include "tests/adapters/occt/fillet_volumes.h"

namespace blossom::occt {
namespace {

using testing::expect_sound;
using testing::kCut;

TEST(FilletOfChangingRadius, TakesTheSameFromBothSidesOfAnEdge) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const FilletResult up = fillet(shape, {1}, {.law = RadiusLaw::linear({0, 1}, 1, 2)});
  const FilletResult down = fillet(shape, {1}, {.law = RadiusLaw::linear({0, 1}, 2, 1)});
  expect_sound(up);
  expect_sound(down);
  ASSERT_EQ(up.solids.size(), 1U);
  EXPECT_NEAR(up.solids.front().volume, down.solids.front().volume, 1e-6);
  // Sections of the cone are similar: what goes is in proportion to the integral of r^2.
  const FilletResult twice = fillet(shape, {1}, {.law = RadiusLaw::linear({0, 1}, 2, 3)});
  expect_sound(twice);
  const double slope_free = 10 * kCut * 7.0 / 3;
  EXPECT_NEAR(1000 - up.solids.front().volume, slope_free, 0.02 * slope_free);
}

// What goes is in proportion to the integral of r^2, but for the slopes of the cones.
TEST(FilletOfChangingRadius, GoesByALaw) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  for (const RadiusLaw& law :
       {RadiusLaw::smooth({0, 1}, 1, 2), RadiusLaw::table({0, 0.3, 0.7, 1}, {1, 1.6, 1.4, 1})}) {
    const FilletResult made = fillet(shape, {1}, {.law = law});
    expect_sound(made);
    ASSERT_EQ(made.solids.size(), 1U);
    double squares = 0;
    for (int i = 0; i < 1000; ++i) squares += std::pow(law.at((i + 0.5) / 1000).value, 2) / 1000;
    const double expected = 10 * kCut * squares;
    EXPECT_NEAR(1000 - made.solids.front().volume, expected, 0.05 * expected);
  }
  EXPECT_THROW(fillet(shape, {1}, {.law = RadiusLaw::table({0, 0.1, 0.9, 1}, {9, 0.1, 0.1, 9})}),
               InvalidInput);
}

// Evenly along a line and an arc is at two rates along the way of the ball: there its envelope has
// two sections.
TEST(FilletOfChangingRadius, TellsThatStripsDoNotQuiteMeetAtAnArc) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20., 20., 10.).Shape();
  const TopoDS_Shape block =
      fillet(box,
             testing::edges_where(box, EdgeKind::Convex,
                                  [](const Vec3& at) { return at[0] == 20 && at[1] == 20; }),
             {.radius = 4})
          .solids.front()
          .solid;
  const std::vector<int> top = testing::edges_where(
      block, EdgeKind::Convex, [](const Vec3& at) { return at[2] == 10 && at[0] == 20; });
  ASSERT_EQ(top.size(), 1U);
  const FilletResult even = fillet(block, top, {.radius = 1});
  EXPECT_EQ(even.status, Status::Complete);
  EXPECT_TRUE(even.notes.empty());
  const FilletResult made = fillet(block, top, {.law = RadiusLaw::linear({0, 1}, 1, 2)});
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_EQ(made.status, Status::Tolerance);
  ASSERT_EQ(made.notes.size(), 2U);
  EXPECT_NE(made.notes.front().find("do not quite meet"), std::string::npos);
}

class FilletOfSection : public ::testing::TestWithParam<SectionKind> {};

// Beside a plane the sections begin without curvature, where circles have that of the ball.
TEST_P(FilletOfSection, HasTheCurvaturesOfItsFaces) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const FilletResult made = fillet(shape, {1}, {.radius = 2, .section = {.kind = GetParam()}});
  expect_sound(made);
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_LT(made.solids.front().volume, 1000);
  int blends = 0;
  for (const FilletFace& face : made.solids.front().faces) {
    if (face.from != 0) continue;
    ++blends;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face.face);
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    surface->Bounds(u0, u1, v0, v1);
    const auto curvature = [&](double v) {
      GeomLProp_SLProps at(surface, (u0 + u1) / 2, v, 2, 1e-9);
      return std::max(std::abs(at.MaxCurvature()), std::abs(at.MinCurvature()));
    };
    for (const double v : {v0, v1}) EXPECT_LE(curvature(v), 1e-6);
    EXPECT_GE(curvature((v0 + v1) / 2), 0.1);
  }
  EXPECT_EQ(blends, 1);
}

INSTANTIATE_TEST_SUITE_P(Kinds, FilletOfSection,
                         ::testing::Values(SectionKind::Curvature, SectionKind::CurvatureRate));

TEST(FilletOfChangingRadius, IsRefusedRoundClosedEdges) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  const std::vector<int> rims =
      testing::edges_where(shape, EdgeKind::Convex, [](const Vec3&) { return true; });
  ASSERT_EQ(rims.size(), 2U);
  const FilletResult made = fillet(shape, rims, {.law = RadiusLaw::linear({0, 1}, 1, 2)});
  EXPECT_TRUE(made.solids.empty());
  ASSERT_FALSE(made.refused.empty());
  EXPECT_EQ(made.refused.front().fault, FilletFault::Edge);
}

}  // namespace
}  // namespace blossom::occt
