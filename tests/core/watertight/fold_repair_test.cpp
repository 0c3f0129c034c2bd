// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/fold_repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/watertight/orientation_check.h"
#include "core/watertight/watertight.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Random;
using testing::seeded;
using testing::uniform;

constexpr double kStep = 1e-5;

Vec3 normal_at(const BezierTriangle& triangle, double x, double y) {
  const Vec3 at = point_at(triangle, x, y);
  return cross(point_at(triangle, x + kStep, y) - at, point_at(triangle, x, y + kStep) - at);
}

// Of degree n over the unit triangle, each point off its place by up to `off`.
BezierTriangle drawn(Random& random, int n, double off) {
  BezierTriangle triangle{n, {}};
  for (int nu = 0; nu <= n; ++nu)
    for (int mu = 0; nu + mu <= n; ++mu)
      triangle.points.push_back(
          Vec3{double(nu) / n, double(mu) / n, 0} +
          off * Vec3{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)});
  return triangle;
}

BezierTriangle shaken(Random& random, BezierTriangle triangle, double off) {
  for (Vec3& p : triangle.points)
    p += off * Vec3{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
  return triangle;
}

TEST(TurnedNormals, AreToldByACornerThatPassesTheSideAcross) {
  const BezierTriangle triangle{1, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}};
  BezierTriangle near = triangle, beyond = triangle;
  near.points[0] = {0.49, 0.49, 0};
  beyond.points[0] = {0.51, 0.51, 0};

  EXPECT_TRUE(turns_nowhere(triangle, triangle, 0));
  EXPECT_TRUE(turns_nowhere(triangle, near, 0));
  EXPECT_FALSE(turns_nowhere(triangle, beyond, 0));
}

TEST(TurnedNormals, AreToldByAnInnerPointThatFoldsAPart) {
  Random random = seeded(3);
  const BezierTriangle triangle = drawn(random, 3, 0);
  BezierTriangle folded = triangle;
  folded(1, 1) = {1.4, -0.4, 0};

  EXPECT_FALSE(turns_nowhere(triangle, folded, 0));
}

// Two sides leave the corner at the origin in one direction, as at a pole: the normal is zero
// there.
TEST(TurnedNormals, MayTurnWhereTheyAreNarrowerThanAsked) {
  const BezierTriangle tip{
      2, {{0, 0, 0}, {0.5, 0, 0}, {1, 0.1, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, -0.1, 0}}};
  BezierTriangle crossed = tip;
  crossed(0, 1)[1] -= 1e-5;
  crossed(1, 0)[1] += 1e-5;

  EXPECT_TRUE(turns_nowhere(tip, tip, 0));
  EXPECT_FALSE(turns_nowhere(tip, crossed, 0));
  EXPECT_FALSE(turns_nowhere(tip, crossed, 1e-11));
  EXPECT_TRUE(turns_nowhere(tip, crossed, 1e-6));
}

TEST(TurnedNormals, AreProvenSoundOnlyIfNoNormalTurns) {
  Random random = seeded(4);
  int proven = 0, turned = 0;
  for (int draw = 0; draw < 400; ++draw) {
    const int degree = 1 + draw % 5;
    const BezierTriangle given = drawn(random, degree, 0.1 / degree);
    const BezierTriangle moved =
        shaken(random, given, std::pow(10, uniform(random, -2, 0.5)) / degree);
    double least = 1;
    for (int i = 0; i <= 32; ++i)
      for (int j = 0; i + j <= 32; ++j) {
        const double x = i / 32.0, y = j / 32.0;
        const Vec3 a = normal_at(given, x, y), b = normal_at(moved, x, y);
        least = std::min(least, dot(a, b) / (norm(a) * norm(b)));
      }
    if (turns_nowhere(given, moved, 0)) {
      EXPECT_GT(least, -1e-3) << draw;
      ++proven;
    }
    if (least > 0.1) {
      EXPECT_TRUE(turns_nowhere(given, moved, 0)) << draw << " " << least;
    }
    turned += least < 0 ? 1 : 0;
  }
  EXPECT_GT(proven, 150);
  EXPECT_GT(turned, 50);
}

// The surface's own side at the pole is not quite a point, and turned over there.
TEST(TurnedNormals, OfAPatchMayBeAnyBesideAPoleThatBecomesAPoint) {
  BezierPatch fan{Grid<Vec3>(2, 2)};
  fan.points(0, 0) = {1e-6, 0, 0};
  fan.points(1, 0) = {0, 0, 0};
  fan.points(0, 1) = {0, 1, 0};
  fan.points(1, 1) = {0.5, 1, 0};
  BezierPatch moved = fan;
  moved.points(0, 0) = moved.points(1, 0) = {0, 0, 0};

  EXPECT_TRUE(turns_nowhere(fan, moved, 0));
}

TEST(TurnedNormals, RefuseWhatIsNoTriangle) {
  const BezierTriangle point{0, {{0, 0, 0}}}, broken{2, {{0, 0, 0}}};
  const BezierTriangle triangle{1, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}};

  EXPECT_THROW(turns_nowhere(point, triangle, 0), InvalidInput);
  EXPECT_THROW(turns_nowhere(triangle, broken, 0), InvalidInput);
}

TEST(TurnedNormals, OfPatchesAreToldByACornerThatPassesTheDiagonal) {
  BezierPatch patch{Grid<Vec3>(2, 2)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) patch.points(i, j) = {double(i), double(j), 0};
  BezierPatch near = patch, beyond = patch;
  near.points(0, 0) = {0.49, 0.49, 0};
  beyond.points(0, 0) = {0.51, 0.51, 0};

  EXPECT_TRUE(turns_nowhere(patch, patch, 0));
  EXPECT_TRUE(turns_nowhere(patch, near, 0));
  EXPECT_FALSE(turns_nowhere(patch, beyond, 0));
}

// A square in two patches that meet `strip` beside its left border. That border is an edge which
// runs up to `gap` to the right of it.
CommonModel square_with_a_strip(double strip, double gap) {
  CommonFace face{{{0, strip, 1}, {0, 1}}, {}, {0, 1, 2, 3}};
  face.surface.patches = Grid<RationalBezierPatch>(2, 1);
  for (int i = 0; i < 2; ++i) {
    Grid<Vec4>& net = face.surface.patches(i, 0).points = Grid<Vec4>(2, 2);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        net(a, b) = {face.surface.u_knots[static_cast<std::size_t>(i + a)], double(b), 0, 1};
  }
  face.chart.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CommonModel model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    const Vec2 a = face.chart.corners[static_cast<std::size_t>(k)];
    const Vec2 b = face.chart.corners[static_cast<std::size_t>(next)];
    face.chart.borders.push_back({planar_line(a, b, {0, 1}), false, k, next, {}});
    const double bow = k == 3 ? gap : 0;
    model.edges.push_back({[=](double t) {
                             const Vec2 p = (1 - t) * a + t * b;
                             return Vec3{p[0] + 4 * bow * t * (1 - t), p[1], 0};
                           },
                           {0, 1},
                           k,
                           next});
    model.edges.back().apart = bow;
  }
  model.faces = {face};
  return model;
}

TEST(SparedTurns, CarryTrianglesAlongThatAreNarrowerThanTheirEdgeIsMoved) {
  for (const double strip : {1e-6, 1e-5, 1e-4, 2e-4, 1e-2}) {
    const WatertightPieces made = watertight_pieces(square_with_a_strip(strip, 3e-4));

    ASSERT_EQ(made.obstacle, "");
    EXPECT_TRUE(made.turned.empty()) << strip << ' ' << made.turned.size();
    EXPECT_LE(made.deviation, 6.1e-4);
    for (const WatertightPiece& piece : made.pieces) {
      const auto* triangle = std::get_if<BezierTriangle>(&piece.form);
      for (double x = 0.02; triangle && x < 1; x += 0.08)
        for (double y = 0.02; x + y < 1; y += 0.08)
          EXPECT_GT(normal_at(*triangle, x, y)[2], 0) << strip;
    }
  }
}

}  // namespace
}  // namespace blossom
