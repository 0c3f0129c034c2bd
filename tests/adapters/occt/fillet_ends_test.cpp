// SPDX-License-Identifier: LGPL-2.1-or-later
// Where strips end: in faces that grow, and in one another at edges of the other kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <gp_Ax2.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/chamfered_angle.h"
#include "tests/adapters/occt/fillet_checks.h"
#include "tests/adapters/occt/fillet_volumes.h"

namespace blossom::occt {
namespace {

using testing::chamfered_angle;
using testing::edges_where;
using testing::expect_change;
using testing::integral;
using testing::kCut;

TopoDS_Shape prism(const std::vector<gp_Pnt>& outline, const gp_Vec& way) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& each : outline) wire.Add(each);
  wire.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire(), true).Face(), way).Shape();
}

// An angle of two bars: its inner corner is at (5, 5).
const std::vector<gp_Pnt> kAngle{{0, 0, 0}, {30, 0, 0}, {30, 5, 0},
                                 {5, 5, 0}, {5, 25, 0}, {0, 25, 0}};

TEST(FilletAtAnInnerCorner, TheOtherWallGrowsAndEndsTheStrip) {
  const TopoDS_Shape shape = prism(kAngle, {0, 0, 20});
  const std::vector<int> edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
    return std::abs(at[1] - 5) < 1e-9 && std::abs(at[2] - 20) < 1e-9 && at[0] < 29;
  });
  ASSERT_EQ(edges.size(), 1U);

  expect_change(fillet(shape, edges, {.radius = 1}), -25 * kCut, 1e-9);
}

TEST(FilletAtAnInnerCorner, AWallThatGoesBackLeavesMoreOfTheStrip) {
  // The wall goes away from the edge by a third of the way behind it.
  const TopoDS_Shape shape =
      prism({{0, 0, 0}, {30, 0, 0}, {30, 5, 0}, {12, 5, 0}, {6, 23, 0}, {0, 23, 0}}, {0, 0, 20});
  const std::vector<int> edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
    return std::abs(at[1] - 5) < 1e-9 && std::abs(at[2] - 20) < 1e-9 && at[0] < 29;
  });
  ASSERT_EQ(edges.size(), 1U);
  // At the distance y behind the edge the wall, gone on, stands y / 3 further along.
  const double r = 1;
  const auto height = [&](double y) { return r - std::sqrt(2 * r * y - y * y); };
  const double less = integral(0, 1, [&](double s) {
    const double y = s * s;  // the root is smooth in s
    return 2 * s * height(y) * (18 - y / 3);
  });

  expect_change(fillet(shape, edges, {.radius = r}), -less, 1e-9);
}

// Once the inner corner is round, the rims of both bars go on in one another.
TEST(FilletAtAnInnerCorner, EdgesThatFilletsGoOnInAreToldAmongThoseRounded) {
  const TopoDS_Shape shape = prism(kAngle, {0, 0, 20});
  const auto on_top = [](const Vec3& at) { return std::abs(at[2] - 20) < 1e-9; };
  const std::vector<int> inner = edges_where(shape, EdgeKind::Convex, [&](const Vec3& at) {
    return on_top(at) &&
           ((std::abs(at[1] - 5) < 1e-9 && at[0] > 5) || (std::abs(at[0] - 5) < 1e-9 && at[1] > 5));
  });
  ASSERT_EQ(inner.size(), 2U);
  std::vector<int> asked = edges_where(shape, EdgeKind::Concave, [](const Vec3&) { return true; });
  ASSERT_EQ(asked.size(), 1U);
  asked.push_back(inner.front());

  const FilletResult made = fillet(shape, asked, {.radius = 1});

  ASSERT_EQ(made.solids.size(), 1U);
  for (const int edge : inner)
    EXPECT_TRUE(std::ranges::find(made.edges, edge) != made.edges.end()) << edge;
}

// Once the inner corner is round, the rim that was asked for goes on in that of the other bar. A
// groove in that bar's top leaves no room for the ball: the fillet ends before it, and says so.
TEST(FilletAtAnInnerCorner, EndsThereWhereTheRimBehindHasNoRoom) {
  const TopoDS_Shape groove = BRepPrimAPI_MakeBox(gp_Pnt(4.2, 8, 15), gp_Pnt(4.7, 30, 25)).Shape();
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(prism(kAngle, {0, 0, 20}), groove).Shape();
  std::vector<int> asked = edges_where(shape, EdgeKind::Concave, [](const Vec3& at) {
    return distance(at, {5, 5, 10}) < 1e-9;
  });
  const std::vector<int> rim = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
    return distance(at, {17.5, 5, 20}) < 1e-9;
  });
  ASSERT_EQ(asked.size() + rim.size(), 2U);
  asked.insert(asked.end(), rim.begin(), rim.end());

  const FilletResult made = fillet(shape, asked, {.radius = 1});

  testing::expect_sound(made);
  std::ranges::sort(asked);
  EXPECT_EQ(made.edges, asked);
  EXPECT_EQ(made.notes.size(), 2U);
  ASSERT_EQ(made.solids.size(), 1U);
  const double added = 20 * kCut, taken = 24 * kCut;  // the strip stops a little before the blend
  EXPECT_NEAR(made.solids.front().volume, made.volume_before + added - taken, 0.3 * kCut);
}

// A corner cut out of a block, with a bore beside it that leaves one rim of the cut no room. The
// strip's contact comes to the end of the other fillet just where the edge itself ends.
TEST(FilletAtACutCorner, EndsWhereItsContactAndItsEdgeMeetTheOtherFillet) {
  for (const double radius : {0.9, 1.4, 1.5, 1.9}) {
    const double width = 3.118754, depth = 2.301211, length = 5.357061;
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(60, 40, 11.145981).Shape();
    const TopoDS_Shape corner =
        BRepPrimAPI_MakeBox(gp_Pnt(60 - width, 40 - length, 11.145981 - depth), 20, 20, 20).Shape();
    const gp_Ax2 axis({60, 40 - length - 3.5, -1}, gp::DZ());
    const TopoDS_Shape bore = BRepPrimAPI_MakeCylinder(axis, 3.3, 20).Shape();
    const TopoDS_Shape shape = BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(block, corner).Shape(), bore);
    const double floor = 11.145981 - depth;
    std::vector<int> asked = edges_where(shape, EdgeKind::Concave, [&](const Vec3& at) {
      return distance(at, {60 - width / 2, 40 - length, floor}) < 1e-6;
    });
    const std::vector<int> rim = edges_where(shape, EdgeKind::Convex, [&](const Vec3& at) {
      return distance(at, {60, 40 - length / 2, floor}) < 1e-6;
    });
    ASSERT_EQ(asked.size() + rim.size(), 2U);
    asked.insert(asked.end(), rim.begin(), rim.end());

    const FilletResult made = fillet(shape, asked, {.radius = radius});

    testing::expect_sound(made);
    std::ranges::sort(asked);
    EXPECT_EQ(made.edges, asked) << radius;
  }
}

// A boss stands across an edge, which the fillet takes off beside it: the boss's side grows down to
// the strip, wherever its seam is.
TEST(FilletBesideABoss, IsTheSameWhereverItsSeamIs) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(20, 20, 10).Shape();
  std::optional<double> volume;
  for (const double degrees : {90, 160, 170, 178, 15, 1}) {
    const double angle = degrees * std::numbers::pi / 180;
    const gp_Ax2 axis({10, 0, 0}, gp::DZ(), {std::cos(angle), std::sin(angle), 0});
    const TopoDS_Shape boss = BRepPrimAPI_MakeCylinder(axis, 5, 20).Shape();
    const TopoDS_Shape shape = BRepAlgoAPI_Fuse(block, boss).Shape();
    const std::vector<int> edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
      return std::abs(at[1]) < 1e-9 && std::abs(at[2] - 10) < 1e-9;
    });
    ASSERT_EQ(edges.size(), 2U);

    const FilletResult made = fillet(shape, edges, {.radius = 2});

    testing::expect_sound(made);
    EXPECT_TRUE(made.notes.empty()) << made.notes.front();
    ASSERT_EQ(made.solids.size(), 1U) << degrees;
    if (!volume) volume = made.solids.front().volume;
    EXPECT_NEAR(made.solids.front().volume, *volume, 1e-9 * *volume) << degrees;
  }
}

// A step across a bar: the bar's side grows up the step, also just beside the line of its seam.
TEST(FilletOfAStep, IsTheSameWhereverTheSeamIs) {
  for (const double radius : {0.5, 4.0}) {
    const double added = integral(0, std::sqrt(radius), [&](double s) {
      const double y = s * s;  // the root is smooth in s
      return 4 * s * (radius - std::sqrt(2 * radius * y - y * y)) * std::sqrt(576 - y * y);
    });
    for (const double degrees : {0.0, 180.0, 90.0, 0.5}) {
      const double angle = degrees * std::numbers::pi / 180;
      const gp_Ax2 axis(gp::Origin(), gp::DZ(), {std::cos(angle), std::sin(angle), 0});
      const TopoDS_Shape bar = BRepPrimAPI_MakeCylinder(axis, 24, 30).Shape();
      const TopoDS_Shape shape =
          BRepAlgoAPI_Cut(bar, BRepPrimAPI_MakeBox(gp_Pnt(-30, 0, 10), 60, 60, 60).Shape()).Shape();
      const std::vector<int> edges =
          edges_where(shape, EdgeKind::Concave, [](const Vec3&) { return true; });
      ASSERT_EQ(edges.size(), 1U);
      SCOPED_TRACE(degrees);
      expect_change(fillet(shape, edges, {.radius = radius}), added, 1e-6);
    }
  }
}

// At its narrow end the face is as wide as the ball's contact is from the edge: that comes to the
// vertex there, and the strip ends in the end face, not in the slanted one.
TEST(FilletOfATaperedPlate, EndsInItsEndFaceThroughTheCorner) {
  const TopoDS_Shape shape = prism({{0, 0, 0}, {10, 0, 0}, {10, 2, 0}, {0, 1, 0}}, {0, 0, 5});
  const std::vector<int> edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
    return std::abs(at[1]) < 1e-9 && std::abs(at[2] - 5) < 1e-9;
  });
  ASSERT_EQ(edges.size(), 1U);
  for (const double radius : {0.99, 1.0})
    expect_change(fillet(shape, edges, {.radius = radius}), -10 * kCut * radius * radius, 1e-7);
}

// Beside the middle of its edge the plate is narrower than the ball's contact is from it, but not
// at the wide end: from there the strip runs out over the far side, and down that to the narrow
// end.
TEST(FilletOfATaperedPlate, BeginsWhereItIsWideEnough) {
  const TopoDS_Shape shape = prism({{0, 0, 0}, {10, 0, 0}, {10, 3, 0}, {0, 0.5, 0}}, {0, 0, 5});
  const std::vector<int> edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
    return distance(at, {5, 0, 5}) < 1e-9;
  });
  const double r = 2;
  const auto below_arc = [&](double s) {
    return 0.5 * (s * std::sqrt(r * r - s * s) + r * r * std::asin(s / r));
  };
  const auto section = [&](double width) {
    return r * width - below_arc(r) + below_arc(r - width);
  };
  const double narrow = integral(0, 6, [&](double x) { return section(0.5 + x / 4); });

  expect_change(fillet(shape, edges, {.radius = r}), -narrow - 4 * section(r), 1e-9);
}

// An edge of length 1 of a prism over a parallelogram. Beside its middle the contact is beyond the
// leaning face, but further on it is in both faces; the ends are parallel planes, so that the strip
// takes off as much as a straight one of the edge's length.
TEST(FilletOfALeaningFace, BeginsWhereTheBallTouchesBothFaces) {
  for (const double lean : {0.6, -0.6, 0.9}) {
    const TopoDS_Shape shape =
        prism({{0, 0, 0}, {1, 0, 0}, {1 + 4 * lean, 4, 0}, {4 * lean, 4, 0}}, {0, 0, 3});
    const std::vector<int> edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
      return distance(at, {0.5, 0, 3}) < 1e-9;
    });

    const FilletResult made = fillet(shape, edges, {.radius = 1});

    expect_change(made, -kCut, 1e-9);
    EXPECT_TRUE(made.notes.empty()) << made.notes.front();
  }
}

TEST(FilletOfAShell, SaysThatItsEdgesAreOfNoSolid) {
  const TopoDS_Shape shell = BRepPrimAPI_MakeBox(10, 10, 10).Shell();

  const FilletResult made = fillet(shell, {1}, {.radius = 1});

  EXPECT_TRUE(made.solids.empty());
  ASSERT_EQ(made.refused.size(), 1U);
  EXPECT_NE(made.refused.front().text().find("it belongs to no solid"), std::string::npos)
      << made.refused.front().text();
}

// Blocks on blocks whose sides are in one plane, but not one face, as a union leaves them.
TEST(FilletEnds, InTwoPiecesOfOnePlaneGrowsOneOfThem) {
  for (const double radius : {1.0, 2.0, 3.0})
    for (const double from : {-5.0, 0.0}) {
      const TopoDS_Shape shape =
          BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(gp_Pnt(-10, 0, -5), gp_Pnt(20, 10, 0)).Shape(),
                           BRepPrimAPI_MakeBox(gp_Pnt(-10, 0, from), gp_Pnt(0, 10, 2)).Shape())
              .Shape();
      const std::vector<int> edges =
          edges_where(shape, EdgeKind::Concave, [](const Vec3&) { return true; });
      ASSERT_EQ(edges.size(), 1U);
      const FilletResult made = fillet(shape, edges, {.radius = radius});
      testing::expect_sound(made);
      const double c = std::sqrt(4 * radius - 4);  // a ball of 3 leans on the edge above
      const double area =
          radius > 2 ? radius * c - (c * (radius - 2) + radius * radius * std::asin(c / radius)) / 2
                     : radius * radius * (1 - std::numbers::pi / 4);
      EXPECT_NEAR(made.solids.front().volume - made.volume_before, 10 * area, 1e-9) << radius;
      EXPECT_EQ(made.notes.size(), radius > 2 ? 1U : 0U);
    }
}

// The inner edge ends between two chamfers that meet at their own inner edge, which goes on up to
// the strip as they do.
TEST(FilletEnds, BetweenTwoFacesThatGrowSoDoesTheirEdge) {
  const TopoDS_Shape angle = chamfered_angle();
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, 0), gp_Pnt(35, 25, 12)).Shape();
  const TopoDS_Shape inside_out = BRepAlgoAPI_Cut(block, angle).Shape();
  const auto is_inner = [](const Vec3& at) {
    return std::abs(at[0] - 15) < 1e-6 && std::abs(at[1] - 10) < 1e-6;
  };
  for (const double r : {0.5, 1.0, 3.0}) {
    // At a distance b from the nearer side the chamfer is 8 - b high.
    const double more = 2 * integral(0, r * (1 - std::sqrt(0.5)), [r](double b) {
                          return (8 - b) * (r - b - std::sqrt(r * r - (r - b) * (r - b)));
                        });
    expect_change(fillet(angle, edges_where(angle, EdgeKind::Concave, is_inner), {.radius = r}),
                  more, 1e-6);
    expect_change(
        fillet(inside_out, edges_where(inside_out, EdgeKind::Convex, is_inner), {.radius = r}),
        -more, 1e-6);
  }
}

// A wall on a plate, their sides in one plane but in three faces, as a union leaves them: at the
// foot of the wall's edge the plate's top takes what the ball lays bare, up to a border between
// sides.
TEST(FilletEnds, AtASmoothBorderBetweenPiecesOfOnePlane) {
  const TopoDS_Shape shape =
      BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(25, 14, 3)).Shape(),
                       BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(3, 14, 30)).Shape())
          .Shape();
  const std::vector<int> edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
    return distance(at, Vec3{3, 0, 16.5}) < 1e-9;
  });
  ASSERT_EQ(edges.size(), 1U);
  for (const double r : {0.5, 1.0, 2.0})
    expect_change(fillet(shape, edges, {.radius = r}), -27 * kCut * r * r, 1e-9);
}

// A branch as thick as its pipe: where both touch, strips of the edges above and below narrow to
// one point. Together they add what each adds alone.
TEST(FilletOfABranch, StripsOfBothSidesEndInOnePoint) {
  const TopoDS_Shape pipe =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -25), gp_Dir(0, 0, 1)), 10, 50).Shape();
  const TopoDS_Shape branch =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), 10, 30).Shape();
  const TopoDS_Shape shape = BRepAlgoAPI_Fuse(pipe, branch).Shape();
  const auto more = [&](const std::vector<int>& edges) {
    const FilletResult made = fillet(shape, edges, {.radius = 1});
    testing::expect_sound(made);
    return made.solids.empty() ? 0 : made.solids.front().volume - made.volume_before;
  };
  const auto above = edges_where(shape, EdgeKind::Concave, [](const Vec3&at) { return at[2] > 0; }),
             below = edges_where(shape, EdgeKind::Concave, [](const Vec3&at) { return at[2] < 0; });
  ASSERT_FALSE(above.empty() || below.empty());
  std::vector<int> all = above;
  all.insert(all.end(), below.begin(), below.end());
  EXPECT_NEAR(more(all), more(above) + more(below), 1e-7);
}

// What small balls of radius 1 would take along the edge of two bores, one round z of radius 6, the
// other round x of radius 4.5 and 1.5 beside it: per length the corner between tangent planes.
double taken_at_bores() {
  return integral(0, 2 * std::numbers::pi, [](double b) {
    const double y = 1.5 + 4.5 * std::cos(b), x = std::sqrt(std::max(0.0, 36 - y * y));
    if (x < 1e-9) return 0.0;  // they touch
    const double half = 0.5 * std::acos(y / 6 * std::cos(b));
    const double rate = y * 4.5 * std::sin(b) / x;
    return (std::tan(half) - half) * std::hypot(rate, 4.5);
  });
}

// Their edge begins and ends where they touch. The way of the ball crosses itself there, and both
// of its ends are in that place: each is taken for the end of the edge on its own side.
TEST(FilletOfTwoBores, BeginsAndEndsInThePlaceWhereTheyTouch) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -15), 20, 20, 30).Shape();
  const TopoDS_Shape bored =
      BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -20}, gp::DZ()), 6, 40).Shape())
          .Shape();
  const TopoDS_Shape shape =
      BRepAlgoAPI_Cut(bored,
                      BRepPrimAPI_MakeCylinder(gp_Ax2({0, 1.5, 0}, gp::DX()), 4.5, 20).Shape())
          .Shape();
  const auto edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
    return std::hypot(at[0], at[1]) < 6.1 && std::abs(at[2]) < 5;
  });
  ASSERT_FALSE(edges.empty());
  const double taken = taken_at_bores();
  for (const double r : {0.05, 0.3, 0.4, 1.0}) {
    const FilletResult made = fillet(shape, edges, {.radius = r});
    testing::expect_sound(made);
    ASSERT_EQ(made.solids.size(), 1U);
    const double less = made.volume_before - made.solids.front().volume;
    EXPECT_NEAR(less / (r * r), taken, 0.1 * r * taken) << r;
  }
}

// What strips of radius r add round the foot of three upright sides and a slope of 15 over 20, and
// take away inside out. The ball touches the slope lower than the sides, so that strips of both
// meet in mitres.
double strips_round_a_wedge(double thickness, double r) {
  // How far strips come from a side and from the slope at height z.
  const auto upright = [&](double z) { return r - std::sqrt(2 * r * z - z * z); };
  const auto sloping = [&](double z) {
    return z < 0.2 * r ? r / 3 + 4 * z / 3 - std::sqrt(2 * r * z - z * z) : 0.0;
  };
  const auto ring = [&](double z) {
    const double w = upright(z), v = sloping(z);
    return 2 * w * (20 - 4 * z / 3) + (w + v) * thickness + 2 * w * w + 2 * w * v;
  };
  const double low = std::sqrt(0.2 * r), high = std::sqrt(r);  // z = s^2
  const auto by_root = [&](double s) { return 2 * s * ring(s * s); };
  return integral(0, low, by_root) + integral(low, high, by_root);
}

// A triangular rib of height 15 and length 20 on a plate.
TEST(FilletRoundARib, StripsOfFacesAtDifferentAnglesMeetInAMitre) {
  const double thickness = 4, r = 1;
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -5), gp_Pnt(40, 14, 0)).Shape();
  const TopoDS_Shape rib = prism({{0, 0, 0}, {20, 0, 0}, {0, 0, 15}}, {0, thickness, 0});
  const TopoDS_Shape shape = BRepAlgoAPI_Fuse(plate, rib).Shape();
  const std::vector<int> edges =
      edges_where(shape, EdgeKind::Concave, [](const Vec3& at) { return std::abs(at[2]) < 1e-9; });
  ASSERT_EQ(edges.size(), 4U);
  expect_change(fillet(shape, edges, {.radius = r}), strips_round_a_wedge(thickness, r), 1e-8);
}

// The same inside out: the rim of a pocket with three upright walls and a slope.
TEST(FilletRoundAPocket, StripsOfFacesAtDifferentAnglesMeetInAMitre) {
  const double r = 1;
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -20), gp_Pnt(40, 14, 0)).Shape();
  const TopoDS_Shape pocket = prism({{0, 0, 0}, {20, 0, 0}, {0, 0, -15}}, {0, 4, 0});
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(block, pocket).Shape();
  const std::vector<int> edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
    return std::abs(at[2]) < 1e-9 && at[0] > -1 && at[0] < 21 && at[1] > -1 && at[1] < 5;
  });
  ASSERT_EQ(edges.size(), 4U);
  expect_change(fillet(shape, edges, {.radius = r}), -strips_round_a_wedge(4, r), 1e-8);
}

// A cylinder of radius 10 on one side of a chord; the last 0.3 of the arc are an edge of their own.
// The contact comes to the chord before the ball is beside the seam.
TEST(FilletOfASegment, EndsBeforeAShortPieceOfItsEdgeAsIfThatWereNotCutOff) {
  const auto volume_less = [](double turned) {
    const gp_Ax2 axes(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1),
                      gp_Dir(std::cos(turned), std::sin(turned), 0));
    const TopoDS_Shape drum = BRepPrimAPI_MakeCylinder(axes, 10, 5).Shape();
    const double x = std::sqrt(100 - 0.09);
    const TopoDS_Shape beside =
        prism({{x, 0.3, -1}, {x + 20, 20.3, -1}, {x - 40, 20.3, -1}, {x - 40, -39.7, -1}},
              gp_Vec(0, 0, 7));
    ShapeUpgrade_UnifySameDomain one_wall(BRepAlgoAPI_Cut(drum, beside).Shape(), false, true);
    one_wall.Build();
    const TopoDS_Shape part = one_wall.Shape();
    const std::vector<int> top = edges_where(part, EdgeKind::Convex, [](const Vec3& middle) {
      return middle[2] == 5 && std::hypot(middle[0], middle[1]) > 9.99;
    });
    const FilletResult made = fillet(part, top, {.radius = 1});
    for (const FilletRefusal& each : made.refused) ADD_FAILURE() << each.text();
    for (const std::string& each : made.notes) ADD_FAILURE() << each;
    if (made.solids.empty()) return 0.0;
    EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front().solid).IsValid());
    return made.volume_before - made.solids.front().volume;
  };
  const double whole = volume_less(1.5);
  EXPECT_GT(whole, 2.0);
  EXPECT_NEAR(volume_less(0), whole, 1e-7);
}

// A plate 20 x 20 x 10 with a slot that begins 1.4 behind a side and is open at its end, where it
// comes to a corner that is cut off by 2. The cut goes along itself down the slot's wall.
TEST(ChamferBesideASlot, GoesDownTheSlotsWallAtItsEnd) {
  const TopoDS_Shape part =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 20, 10).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(5, 1.4, 7), gp_Pnt(25, 6, 15)).Shape());
  const std::vector<int> corner = edges_where(part, EdgeKind::Convex, [](const Vec3& middle) {
    return std::abs(middle[0] - 20) < 1e-9 && middle[1] == 0 && std::abs(middle[2] - 5) < 1e-9;
  });
  ASSERT_EQ(corner.size(), 1U);
  // Of the triangle of 2 x 2 the upper 3 lack what is in the slot.
  const double below = 2 * 7, above = (2 - 0.6 * 0.6 / 2) * 3;
  expect_change(fillet(part, corner, {.chamfer = ChamferSize{2}}), -below - above, 1e-9);
}

// A ball as large as the arc in a run of edges turns on the spot there, and leaves an eighth of a
// sphere: on a box with a rounded corner, and at the bottom of a pocket of that form.
TEST(FilletOfTheRadiusOfAnArc, TurnsOnTheSpot) {
  const double r = 3;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 20, 10).Shape();
  const std::vector<int> upright =
      edges_where(box, EdgeKind::Convex, [](const Vec3& at) { return at[0] == 20 && at[1] == 20; });
  const FilletResult rounded = fillet(box, upright, {.radius = r});
  ASSERT_EQ(rounded.solids.size(), 1U);
  const TopoDS_Shape block = rounded.solids.front().solid;
  const TopoDS_Shape pocket =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -5), gp_Pnt(25, 25, 10)).Shape(), block)
          .Shape();
  const double at_arc = r * r * r * std::numbers::pi * (1.0 / 4 - 1.0 / 6);
  const double change = 34 * kCut * r * r + at_arc;
  const auto arc_at = [](double z) {
    return [z](const Vec3& at) {
      return std::abs(at[2] - z) < 1e-9 && std::abs(at[0] - at[1]) < 1e-9 && at[0] > 18 &&
             at[0] < 20;
    };
  };

  expect_change(fillet(block, edges_where(block, EdgeKind::Convex, arc_at(10)), {.radius = r}),
                -change, 1e-9);
  // The other walls' edges at the bottom are sharp: what is beside them ends in the walls.
  expect_change(fillet(pocket, edges_where(pocket, EdgeKind::Concave, arc_at(0)), {.radius = r}),
                change, 1e-9);
}

}  // namespace
}  // namespace blossom::occt
