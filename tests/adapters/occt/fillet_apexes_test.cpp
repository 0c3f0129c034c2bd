// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips where their faces have no normal: at the apex of a cone and the poles of a ball.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_volumes.h"

namespace blossom::occt {
namespace {

using testing::edges_where;
using testing::expect_change;
using testing::integral;
using testing::kCut;

// A quarter of a cone, whose upright edge ends in the apex.
TEST(FilletAtAnApex, StripEndsInTheCone) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCone(50, 0, 120, std::numbers::pi / 2).Shape();
  const std::vector<int> edges = edges_where(
      shape, EdgeKind::Convex, [](const Vec3& at) { return std::hypot(at[0], at[1]) < 1e-9; });
  ASSERT_EQ(edges.size(), 1U);
  // At the distances x, y from the planes the cone is 120 (1 - hypot(x, y) / 50) high; the ball
  // leaves what is nearer to the axis than its arc, which begins at R(a) from it.
  const double r = 10;
  const double less = 2 * integral(0, std::sqrt(std::numbers::pi / 4), [&](double s) {
                        const double a = s * s,
                                     sum = std::cos(a) + std::sin(a);  // the root is smooth in s
                        const double far = r * (sum - std::sqrt(std::sin(2 * a)));
                        return 2 * s * 120 * (far * far / 2 - far * far * far / 150);
                      });

  expect_change(fillet(shape, edges, {.radius = r}), -less, 1e-6);
}

// What balls of radius 10 between the plane y = 0 and the cone leave of it under a point. Their
// centres are on or under z = 94 - 2.4 hypot(x, y), y >= 10, and those that reach highest have
// y = 10 beside the plane; elsewhere one touches the cone itself.
double height_under_balls(double x, double y) {
  const double away = std::hypot(x, y), cone = 120 - 2.4 * away;
  const double foot = (away - 10 * 12 / 13.0) / away;  // of the ball's centre that touches there
  if (y * foot >= 10) return cone;
  const double half = std::sqrt(100 - (y - 10) * (y - 10));
  double from = x - half, to = x + half;
  const auto reach = [&](double t) {
    return 94 - 2.4 * std::hypot(t, 10) + std::sqrt(std::max(0.0, half * half - (x - t) * (x - t)));
  };
  for (int i = 0; i < 60; ++i) {  // it is concave
    const double p = from + 0.382 * (to - from), q = from + 0.618 * (to - from);
    (reach(p) < reach(q) ? from : to) = reach(p) < reach(q) ? p : q;
  }
  return std::min(cone, reach(0.5 * (from + to)));
}

// A slanting edge of it: towards the apex the ball rises along a hyperbola, never back, until it
// comes to its summit in the plane behind. There both contacts leave their faces at once, and what
// no ball reaches above it goes, the apex with it.
TEST(FilletAtAnApex, StripOfTheConeEndsInThePlaneBehind) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCone(50, 0, 120, std::numbers::pi / 2).Shape();
  const std::vector<int> edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
    return std::abs(at[1]) < 1e-9 && std::abs(at[2] - 60) < 1e-9 && at[0] > 1;
  });
  ASSERT_EQ(edges.size(), 1U);
  constexpr int kCells = 500;
  double less = 0;  // over squares of 0.1
  for (int i = 0; i < kCells; ++i)
    for (int k = 0; k < kCells / 2; ++k) {
      const double x = 0.1 * (i + 0.5), y = 0.1 * (k + 0.5);
      const double whole = 120 - 2.4 * std::hypot(x, y);
      if (whole > 0) less += 0.01 * (whole - std::max(0.0, height_under_balls(x, y)));
    }

  const FilletResult made = fillet(shape, edges, {.radius = 10});

  expect_change(made, -less, 1e-3 * less);
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_EQ(made.solids.front().faces.size(), 5U);
  int ends = 0;  // of the strip: the last ball's circle, in the plane behind
  for (const FilletFace& each : made.solids.front().faces)
    for (TopExp_Explorer it(each.face, TopAbs_VERTEX); each.from == 0 && it.More(); it.Next()) {
      const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(it.Current()));
      if (std::abs(p.X()) > 1e-6) continue;
      ++ends;
      EXPECT_NEAR(p.Distance({0, 10, 70}), 10, 1e-6);
      EXPECT_TRUE(std::abs(p.Y()) < 1e-6 || std::abs(p.Z() - (120 - 2.4 * p.Y())) < 1e-6);
    }
  EXPECT_EQ(ends, 4);  // both, in two edges each
}

// Three quarters of a ball: in its notch the poles would come to lie inside of the ball's face.
TEST(FilletInTheNotchOfABall, EndsInPlanesBeforeThePolesAndSaysWhy) {
  const double half = std::numbers::pi / 2;
  const TopoDS_Shape shape = BRepPrimAPI_MakeSphere(10, -half, half, 3 * half).Shape();
  const std::vector<int> edges =
      edges_where(shape, EdgeKind::Concave, [](const Vec3&) { return true; });
  ASSERT_EQ(edges.size(), 1U);

  const FilletResult made = fillet(shape, edges, {.radius = 1});

  for (const FilletRefusal& each : made.refused) ADD_FAILURE() << each.text();
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front().solid).IsValid());
  const double more = made.solids.front().volume - made.volume_before;
  EXPECT_LT(more, 20 * kCut);
  EXPECT_GT(more, 16 * kCut);
  ASSERT_EQ(made.notes.size(), 2U);
  for (const std::string& each : made.notes)
    EXPECT_NE(each.find("it ends in a pole of face"), std::string::npos) << each;
}

}  // namespace
}  // namespace blossom::occt
