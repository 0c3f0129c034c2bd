// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets whose sections change along the edge, or are no circles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <GeomLProp_SLProps.hxx>

#include "adapters/occt/blending/continuity.h"
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

// A block 20 x 20 x 10 with one rounded upright edge; the edges of its top on that and beside it.
TopoDS_Shape block_with_round_corner() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20., 20., 10.).Shape();
  return fillet(box,
                testing::edges_where(box, EdgeKind::Convex,
                                     [](const Vec3& at) { return at[0] == 20 && at[1] == 20; }),
                {.radius = 4})
      .solids.front()
      .solid;
}

// Evenly along a line and an arc is at two rates along the way of the ball, whose envelope would
// have two sections where they meet.
TEST(FilletOfChangingRadius, MeetsAtAnArc) {
  const TopoDS_Shape block = block_with_round_corner();
  const std::vector<int> top = testing::edges_where(
      block, EdgeKind::Convex, [](const Vec3& at) { return at[2] == 10 && at[0] == 20; });
  ASSERT_EQ(top.size(), 1U);
  for (const RadiusLaw& law :
       {RadiusLaw::linear({0, 1}, 1, 2), RadiusLaw::linear({0, 1}, 3, 0.5),
        RadiusLaw::smooth({0, 1}, 1, 3), RadiusLaw::table({0, 0.4, 1}, {1, 2, 1.5})}) {
    const FilletResult made = fillet(block, top, {.law = law});
    expect_sound(made, 1e-6);
    EXPECT_EQ(made.status, Status::Complete);
    EXPECT_TRUE(made.notes.empty()) << made.notes.front();
    EXPECT_EQ(made.edges.size(), 3U);
    EXPECT_LT(made.solids.front().volume, made.volume_before);
    for (const EdgeContinuity& each : edge_continuity(made.solids.front().solid)) {
      if (!each.found || each.found->angle.value > 0.1) continue;
      EXPECT_LT(each.found->angle.value, 1e-6) << each.number;
    }
  }
}

TEST(FilletOfChangingRadius, GoesRoundClosedRunsWhereItComesBack) {
  const RadiusLaw back = RadiusLaw::table({0, 0.3, 0.7, 1}, {1, 1.5, 1.2, 1});
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  const std::vector<int> rim =
      testing::edges_where(pin, EdgeKind::Convex, [](const Vec3& at) { return at[2] == 10; });
  const FilletResult round = fillet(pin, rim, {.law = back});
  expect_sound(round, 1e-6);
  EXPECT_EQ(round.status, Status::Complete);
  EXPECT_LT(round.solids.front().volume, round.volume_before);
  // All four upright edges rounded: the top goes round over lines and arcs.
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20., 20., 10.).Shape();
  const auto upright =
      testing::edges_where(box, EdgeKind::Convex, [](const Vec3& at) { return at[2] == 5; });
  const TopoDS_Shape block = fillet(box, upright, {.radius = 4}).solids.front().solid;
  const std::vector<int> top = testing::edges_where(
      block, EdgeKind::Convex, [](const Vec3& at) { return at[2] == 10 && at[0] == 20; });
  const FilletResult all = fillet(block, top, {.law = back});
  expect_sound(all, 1e-6);
  EXPECT_EQ(all.status, Status::Complete);
  EXPECT_EQ(all.edges.size(), 8U);
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

TEST(FilletOfChangingRadius, TellsTheStepOfALawThatDoesNotComeBack) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  const std::vector<int> rims =
      testing::edges_where(shape, EdgeKind::Convex, [](const Vec3&) { return true; });
  ASSERT_EQ(rims.size(), 2U);
  const FilletResult made = fillet(shape, rims, {.law = RadiusLaw::linear({0, 1}, 1, 2)});
  EXPECT_TRUE(made.solids.empty());
  ASSERT_FALSE(made.refused.empty());
  EXPECT_EQ(made.refused.front().fault, FilletFault::Edge);
  EXPECT_NE(made.refused.front().cause.find("1 at its start, and 2 at its end"), std::string::npos)
      << made.refused.front().cause;
}

}  // namespace
}  // namespace blossom::occt
