// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets with a radius larger than a face beside the edge is wide: the ball leans on the far edge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeHalfSpace.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/convert/surfaces.h"
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

// A low pad ends where the floor goes on, and a slot in the middle of the block.
TEST(FilletAtACliff, EndsWhereTheFloorGoesOnOrTheWallDoesNot) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(20, 20, 10).Shape();
  const TopoDS_Shape pad =
      BRepAlgoAPI_Fuse(block, BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 10), 12, 12, 2).Shape()).Shape();
  const TopoDS_Shape slot =
      BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeBox(gp_Pnt(7, 10, 8), 6, 10, 2).Shape()).Shape();
  const double area = Corner(3, 2).area;
  for (const auto& [shape, middle, size] :
       {std::tuple{pad, Vec3{12, 6, 12}, 12.0}, {slot, Vec3{7, 15, 10}, 10.0}}) {
    const FilletResult made = fillet(shape, {edge_where(shape, middle)}, {.radius = 3});
    expect_sound(made);
    EXPECT_NEAR(more_in(made), -size * area, 1e-9);
  }
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

// A prism over an outline in x and z, 10 long.
TopoDS_Shape prism(const std::vector<std::pair<double, double>>& outline) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const auto& [x, z] : outline) polygon.Add(gp_Pnt(x, 0, z));
  polygon.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), gp_Vec(0, 10, 0))
      .Shape();
}

using Outline = std::vector<std::pair<double, double>>;

// A floor, a wall of height 2, and two slopes behind it.
const Outline kSlopes{{-10, -5}, {20, -5}, {20, 0}, {0, 0}, {0, 2}, {-1, 4}, {-10, 9}};

// Between the floor, a ball on it with its centre c from the wall, and the corners of the wall up
// to its last contact, seen along the edge; the ball touches there.
double under_ball(double r, const Outline& corners) {
  const auto [last_x, last_z] = corners.back();
  const double c = last_x + std::sqrt(last_z * (2 * r - last_z));
  double area = 0;  // of the polygon from the floor's contact over the corners and the centre
  Outline around{{c, 0}};
  for (const auto& each : corners) around.push_back(each);
  around.emplace_back(c, r);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto& [x, z] = around[i];
    const auto& [next_x, next_z] = around[(i + 1) % around.size()];
    area += 0.5 * (next_x * z - x * next_z);
  }
  return area - 0.5 * r * r * std::acos((r - last_z) / r);
}

// The ball leans on the wall's upper edge until it touches the slope, on which it rolls until it
// comes to its end; there it leans on that.
TEST(FilletAtACliff, OfAWallThatIsBentRollsOnOverTheSlopesBehind) {
  const TopoDS_Shape shape = prism(kSlopes);
  const int edge = edge_where(shape, {0, 5, 0});
  const double cosine = 1 / std::sqrt(5.0);  // of the slope
  for (const double r : {2.5, 5.0, 8.0}) {
    const FilletResult made = fillet(shape, {edge}, {.radius = r});
    expect_sound(made);
    // The normals of the slope and of the ball agree at the edge of 2 / (1 - cosine) = 3.6, and at
    // its end for 4 / (1 - cosine) = 7.2.
    const double height = r * (1 - cosine);
    const std::pair end = r < 3.6   ? std::pair{0.0, 2.0}
                          : r < 7.2 ? std::pair{1 - height / 2, height}
                                    : std::pair{-1.0, 4.0};
    Outline corners{{0, 0}, {0, 2}, end};
    EXPECT_NEAR(more_in(made), 10 * under_ball(r, corners), 1e-7) << r;
  }
}

// A wall on a floor that bends down by 7.5 degrees along a line askew to the wall: 0.5 from it at
// one end, 1.5 at the other. The bend is at a right angle to no end.
TopoDS_Shape bent_floor() {
  const gp_Pnt from(0.5, 0, 0);
  const gp_Vec along(1, 10, 0);
  const double fall = std::tan(7.5 * std::numbers::pi / 180);
  const gp_Vec down = gp_Vec(10, -1, 0).Normalized() + gp_Vec(0, 0, -fall);
  const TopoDS_Face slope =
      BRepBuilderAPI_MakeFace(gp_Pln(from, gp_Dir(down.Crossed(along)))).Face();
  const TopoDS_Shape above = BRepPrimAPI_MakeHalfSpace(slope, gp_Pnt(5, 5, 5)).Solid();
  const TopoDS_Shape floor =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-3, 0, -5), gp_Pnt(10, 10, 0)).Shape(), above);
  return BRepAlgoAPI_Fuse(floor, BRepPrimAPI_MakeBox(gp_Pnt(-3, 0, -1), gp_Pnt(0, 10, 5)).Shape())
      .Shape();
}

// The largest difference from r of the least distances of centres from a body: of balls of radius r
// that touch the new faces from outside of the material.
double off_balls(const FilletResult& made, const TopoDS_Shape& body, double r) {
  TopoDS_Compound faces;
  BRep_Builder().MakeCompound(faces);
  for (TopExp_Explorer it(body, TopAbs_FACE); it.More(); it.Next())
    BRep_Builder().Add(faces, it.Current());
  double worst = 0;
  for (const FilletFace& each : made.solids.front().faces) {
    if (each.from > 0) continue;
    const ParameterBox box = parameter_box(each.face);
    for (const double u : {0.1, 0.5, 0.9})
      for (const double v : {0.25, 0.75}) {
        BRepGProp_Face surface(each.face);
        gp_Pnt point;
        gp_Vec normal;
        surface.Normal(at(box.u, u), at(box.v, v), point, normal);
        const gp_Pnt centre = point.Translated(r * normal.Normalized());
        const BRepExtrema_DistShapeShape to(BRepBuilderAPI_MakeVertex(centre).Vertex(), faces);
        worst = std::max(worst, std::abs(to.Value() - r));
      }
  }
  return worst;
}

// The contact comes to the bend, goes along it, and on over the slope behind; the middle of the
// edge is before, beside or behind that, or the ball leans on the bend where that ends.
TEST(FilletAtACliff, GoesAlongABendOfTheFloorAndOnBehindIt) {
  const TopoDS_Shape shape = bent_floor();
  const TopoDS_Shape mould =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-3, 0, -5), gp_Pnt(10, 10, 5)).Shape(), shape);
  const int edge = edge_where(shape, {0, 5, 0}), counterpart = edge_where(mould, {0, 5, 0});
  for (const double r : {0.4, 0.505, 0.95, 1.02, 1.52, 3.0}) {
    const FilletResult made = fillet(shape, {edge}, {.radius = r});
    expect_sound(made);
    if (made.solids.empty()) continue;
    EXPECT_LE(off_balls(made, shape, r), 1e-6) << r;
    EXPECT_EQ(made.notes.empty(), r < 0.5 || r > 1.6) << r;
    const FilletResult inside_out = fillet(mould, {counterpart}, {.radius = r});
    expect_sound(inside_out);
    if (inside_out.solids.empty()) continue;
    EXPECT_NEAR(more_in(made), -more_in(inside_out), 1e-7) << r;
  }
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

// A shaft of radius 10 with a key slot, round at its ends, 6 wide and 4 deep.
TopoDS_Shape key_slot(double length) {
  const TopoDS_Shape shaft = BRepPrimAPI_MakeCylinder(10, 60).Shape();
  TopoDS_Shape slot = BRepPrimAPI_MakeBox(gp_Pnt(6, -3, 15), 6, 6, length).Shape();
  for (const double end : {15.0, 15 + length}) {
    BRepAlgoAPI_Fuse fuse(slot,
                          BRepPrimAPI_MakeCylinder(gp_Ax2({6, 0, end}, gp::DX()), 3, 6).Shape());
    fuse.SimplifyResult();
    slot = fuse.Shape();
  }
  return BRepAlgoAPI_Cut(shaft, slot).Shape();
}

// What a disc of radius r that leans on (6, 3) leaves free of the shaft's section beside the slot:
// round it, by half the integral of x dy - y dx.
double beside_slot(double r) {
  const double far = 10 - r;  // of the centre (x, y) from the axis
  const double corner = std::hypot(6, 3), along = std::atan2(3, 6);
  const double turn = std::acos((far * far + corner * corner - r * r) / (2 * far * corner));
  const double x = far * std::cos(along + turn), y = far * std::sin(along + turn);
  const double wall = std::asin(0.3), contact = along + turn;
  double from = contact, to = std::atan2(3 - y, 6 - x);  // about the centre
  if (to > from) to -= 2 * std::numbers::pi;
  double round = 100 * (contact - wall);  // the shaft
  round -= 3 * (std::sqrt(91) - 6);       // the slot's wall
  round += r * r * (to - from) +
           r * (x * (std::sin(to) - std::sin(from)) - y * (std::cos(to) - std::cos(from)));
  return std::abs(round) / 2;
}

// At its round ends the slot is deep enough for the ball, beside its length it is not: there the
// ball leans on the edge of the floor.
TEST(FilletAtACliff, OfAKeySlotLeansOnTheFloorsEdgeBesideItsLength) {
  const double radius = 2.6;
  std::vector<double> less;
  for (const double length : {20.0, 26.0}) {
    const TopoDS_Shape shape = key_slot(length);
    const std::vector<EdgeFacts> edges = edge_facts(shape);
    const auto rim = std::ranges::find_if(edges, [](const EdgeFacts& each) {
      return std::abs(each.middle[1] - 3) < 1e-6 && each.middle[0] > 6.5 &&
             each.kind == EdgeKind::Convex;
    });
    ASSERT_NE(rim, edges.end());
    const FilletResult made = fillet(shape, {rim->number}, {.radius = radius});
    expect_sound(made);
    EXPECT_EQ(made.edges.size(), 6U);
    less.push_back(-more_in(made));
  }
  EXPECT_NEAR(less[1] - less[0], 2 * 6 * beside_slot(radius), 1e-6);
}

}  // namespace
}  // namespace blossom::occt
