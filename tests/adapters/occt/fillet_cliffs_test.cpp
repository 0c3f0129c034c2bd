// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets with a radius larger than a face beside the edge is wide: the ball leans on the far edge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <gp_Ax2.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

using testing::expect_sound;
using testing::told;

// What a disc of radius r leaves free between a line that it touches and a wall of height h at a
// right angle to it, on whose end it leans: its centre is c from the wall.
struct Corner {
  double c, area, moment;  // moment: of the area about the wall

  Corner(double r, double h) {
    c = std::sqrt(2 * r * h - h * h);
    area = r * c - (c * (r - h) + r * r * std::asin(c / r)) / 2;
    const double about_centre = r * c * c / 2 - (r * r * r - std::pow(r - h, 3)) / 3;
    moment = c * area - about_centre;
  }
};

int edge_where(const TopoDS_Shape& shape, const Vec3& middle) {
  for (const EdgeFacts& each : edge_facts(shape))
    if (distance(each.middle, middle) < 1e-6) return each.number;
  ADD_FAILURE() << "no edge there";
  return 0;
}

int edge_of_kind(const TopoDS_Shape& shape, EdgeKind kind) {
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == kind) return each.number;
  ADD_FAILURE() << "no edge of that kind";
  return 0;
}

double more_in(const FilletResult& made) {
  return made.solids.empty() ? 0 : made.solids.front().volume - made.volume_before;
}

// A block with a step: the floor at 0, the upper level at h.
TopoDS_Shape stepped(double h) {
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [x, z] :
       {std::pair{-10.0, -5.0}, {20.0, -5.0}, {20.0, 0.0}, {0.0, 0.0}, {0.0, h}, {-10.0, h}})
    outline.Add(gp_Pnt(x, 0, z));
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 10, 0))
      .Shape();
}

// A disc of radius 5 and height h on a plate.
TopoDS_Shape boss(double h) {
  return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(gp_Pnt(-15, -15, -5), gp_Pnt(15, 15, 0)).Shape(),
                          BRepPrimAPI_MakeCylinder(5, h).Shape())
      .Shape();
}

TEST(FilletAtACliff, InAStepLowerThanTheRadiusLeansOnTheUpperEdge) {
  for (const double radius : {2.0, 2.5, 5.0, 20.0}) {
    const TopoDS_Shape shape = stepped(2);
    const FilletResult made = fillet(shape, {edge_where(shape, {0, 5, 0})}, {.radius = radius});
    expect_sound(made);
    EXPECT_NEAR(more_in(made), 10 * Corner(radius, 2).area, 1e-9) << radius;
    EXPECT_EQ(made.notes.size(), radius > 2 ? 1U : 0U);
    if (made.notes.empty()) continue;
    const std::string upper = std::to_string(edge_where(shape, {0, 5, 2}));
    EXPECT_NE(made.notes.front().find("leans on edge " + upper), std::string::npos)
        << made.notes.front();
  }
}

TEST(FilletAtACliff, OfTheUpperEdgeLeansOnTheLowerOne) {
  const TopoDS_Shape shape = stepped(2);
  const FilletResult made = fillet(shape, {edge_where(shape, {0, 5, 2})}, {.radius = 5});
  expect_sound(made);
  EXPECT_NEAR(more_in(made), -10 * Corner(5, 2).area, 1e-9);
}

TEST(FilletAtACliff, RoundALowBossLeansOnItsRim) {
  const TopoDS_Shape shape = boss(1);
  const FilletResult made = fillet(shape, {edge_of_kind(shape, EdgeKind::Concave)}, {.radius = 3});
  expect_sound(made);
  const Corner across(3, 1);
  const double ring = 2 * std::numbers::pi * (5 * across.area + across.moment);
  EXPECT_NEAR(more_in(made), ring, 1e-8);
}

// The floor is 20 wide, which the contact of a ball of 101 on the wall's edge has used up.
TEST(FilletAtACliff, OfALargeBallLeansOnTheEndOfTheFloorToo) {
  const TopoDS_Shape shape = stepped(2);
  const int edge = edge_where(shape, {0, 5, 0});
  const FilletResult on_floor = fillet(shape, {edge}, {.radius = 100});
  expect_sound(on_floor);
  EXPECT_NEAR(more_in(on_floor), 10 * Corner(100, 2).area, 1e-7);

  const double r = 110, chord = std::sqrt(404.0);
  const FilletResult made = fillet(shape, {edge}, {.radius = r});
  expect_sound(made);
  const double segment =
      r * r * std::asin(chord / (2 * r)) - chord / 2 * std::sqrt(r * r - chord * chord / 4);
  EXPECT_NEAR(more_in(made), 10 * (20 - segment), 1e-7);
  EXPECT_NE(made.notes.front().find(" and on edge "), std::string::npos) << made.notes.front();
}

// The upper face rises from the edge, so the ball meets it there and not the edge.
TEST(FilletAtACliff, IsRefusedWhereTheBallMeetsTheFaceBehind) {
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [x, z] : {std::pair{-10.0, -5.0},
                             {20.0, -5.0},
                             {20.0, 0.0},
                             {0.0, 0.0},
                             {0.0, 2.0},
                             {-1.0, 4.0},
                             {-10.0, 9.0}})
    outline.Add(gp_Pnt(x, 0, z));
  outline.Close();
  const TopoDS_Shape shape =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 10, 0))
          .Shape();
  const int edge = edge_where(shape, {0, 5, 0});
  const FilletResult small = fillet(shape, {edge}, {.radius = 2.5});
  expect_sound(small);
  EXPECT_NEAR(more_in(small), 10 * Corner(2.5, 2).area, 1e-9);
  const FilletResult large = fillet(shape, {edge}, {.radius = 8});
  EXPECT_TRUE(large.solids.empty());
  ASSERT_EQ(large.refused.size(), 1U);
  // The normals of the slope and of the ball at the edge agree at 2 / (1 - 1 / sqrt(5)).
  EXPECT_NEAR(large.refused.front().largest.value_or(0), 2 / (1 - 1 / std::sqrt(5.0)), 0.04)
      << told(large);
}

// What a ball of radius 2 leaves round a post of radius 5 over a square plate, by sums over angles
// and distances from the axis: the plate's sides cut it off.
double over_square(double half) {
  constexpr int kAngles = 400, kDistances = 4000;
  double sum = 0;
  for (int i = 0; i < kAngles; ++i) {
    const double angle = (i + 0.5) / kAngles * std::numbers::pi / 4;
    const double last = std::min(7.0, half / std::cos(angle)), step = (last - 5) / kDistances;
    for (int k = 0; k < kDistances; ++k) {
      const double away = 5 + (k + 0.5) * step, in = 7 - away;
      sum += (2 - std::sqrt(4 - in * in)) * away * step;
    }
  }
  return sum * 2 * std::numbers::pi / kAngles;
}

// The contact leaves the plate over each of its sides and comes back: the sides grow up to the
// strip, and the plate falls apart into its corners. The edge's vertex lies beside a side, or not.
TEST(FilletAtACliff, ThatTheContactComesBackOverIsCutOffByItsWall) {
  for (const double turn : {0.0, 0.3, std::numbers::pi / 4}) {
    const gp_Ax2 axis({0, 0, 0}, {0, 0, 1}, {std::cos(turn), std::sin(turn), 0});
    const TopoDS_Shape shape =
        BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(gp_Pnt(-6.5, -6.5, -5), gp_Pnt(6.5, 6.5, 0)).Shape(),
                         BRepPrimAPI_MakeCylinder(axis, 5, 10).Shape())
            .Shape();
    const FilletResult made =
        fillet(shape, {edge_of_kind(shape, EdgeKind::Concave)}, {.radius = 2});
    expect_sound(made);
    EXPECT_NEAR(more_in(made), over_square(6.5), 1e-4) << turn;
    EXPECT_EQ(made.solids.front().faces.size(), 12U);  // 8, the strip, and three pieces more
  }
}

}  // namespace
}  // namespace blossom::occt
