// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/square_form.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/forms/evaluation.h"
#include "tests/support/quadric_patches.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

using testing::random_point;
using testing::seeded;
using testing::uniform;

CellTree tree_of(const RationalBezierPatch& patch, bool rational) {
  return CellTree(patch, rational, Vec3{}, CellForm::Bezier, 0.5);
}

TEST(SquareForm, IsExactAboutTheCentreOfASphere) {
  const CellTree tree = tree_of(testing::sphere_octant({1, 2, 3}, 2), true);
  const SquareForm form = square_form(tree[0], tree.shape(), {{1, 2, 3}});
  EXPECT_NEAR(form.nearest, 2, 1e-11);
  EXPECT_NEAR(form.farthest, 2, 1e-11);
  EXPECT_LE(form.nearest, 2);
  EXPECT_GE(form.farthest, 2);
}

TEST(SquareForm, IsExactAboutTheAxisOfACylinder) {
  const CellTree tree = tree_of(testing::cylinder_quarter(1.5, 4), true);
  const SquareForm form = square_form(tree[0], tree.shape(), {{0, 0, 7}, {0, 0, 1}});
  EXPECT_NEAR(form.nearest, 1.5, 1e-11);
  EXPECT_NEAR(form.farthest, 1.5, 1e-11);
}

// The foot of a point over a square is inside it, or beyond one of its sides.
TEST(SquareForm, TellsWhetherTheFootIsInASquare) {
  const BezierSurface square = testing::quadrilateral({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0});
  const CellTree tree = tree_of(square.patches(0, 0), false);
  const auto may_be = [&](const Vec3& p) {
    return square_form(tree[0], tree.shape(), {p}, {true, true}).may_be_stationary;
  };
  EXPECT_TRUE(may_be({0.3, 0.6, 2}));
  EXPECT_FALSE(may_be({1.1, 0.6, 2}));
  EXPECT_FALSE(may_be({0.3, -0.1, 2}));
}

TEST(CircleDistance, IsExactOnATorus) {
  const RationalBezierPatch patch = testing::torus_quarter(2, 0.5);
  const CellTree tree = tree_of(patch, true);
  const auto circle = centre_circle(patch, {0.3, 0.6});
  ASSERT_TRUE(circle);
  EXPECT_LE(norm(circle->point), 1e-12);
  EXPECT_NEAR(std::abs(circle->axis[2]), 1, 1e-12);
  EXPECT_NEAR(circle->radius, 2, 1e-12);
  const DistanceRange range = circle_distance(tree[0], tree.shape(), *circle);
  EXPECT_NEAR(range.nearest, 0.5, 1e-10);
  EXPECT_NEAR(range.farthest, 0.5, 1e-10);
  EXPECT_FALSE(centre_circle(testing::sphere_octant({1, 2, 3}, 2), {0.3, 0.6}));
}

class SquareFormProperty : public ::testing::TestWithParam<int> {};

TEST_P(SquareFormProperty, HoldsSamplesAndNeverDeniesAFoot) {
  auto random = seeded(GetParam());
  const bool rational = GetParam() % 2 == 1;
  RationalBezierPatch patch{Grid<Vec4>(4, 3)};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      patch.points(i, j) = testing::weighted(Vec3{i / 3.0, j / 2.0, 0} + 0.3 * random_point(random),
                                             rational ? uniform(random, 0.5, 2) : 1.0);
  const CellTree tree = tree_of(patch, rational);
  // Over an inner point along the normal the distance is stationary there.
  const PatchJet jet = jet_at(patch, uniform(random, 0.1, 0.9), uniform(random, 0.1, 0.9), 1);
  const Vec3 centre = jet.point + uniform(random, -3, 3) * unit(cross(jet.u, jet.v));
  const SquareForm form = square_form(tree[0], tree.shape(), {centre}, {true, true});
  EXPECT_TRUE(form.may_be_stationary);
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) {
      const double far = distance(point_at(patch, i / 20.0, j / 20.0), centre);
      EXPECT_LE(form.nearest, far);
      EXPECT_GE(form.farthest, far);
    }
}

// Small patches, since nothing is known of cells that reach from the circle to its axis.
TEST_P(SquareFormProperty, HoldsSamplesOfTheDistanceFromACircle) {
  auto random = seeded(GetParam());
  const bool rational = GetParam() % 2 == 1;
  RationalBezierPatch patch{Grid<Vec4>(3, 4)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      patch.points(i, j) = testing::weighted(Vec3{i / 2.0, j / 3.0, 0} + 0.2 * random_point(random),
                                             rational ? uniform(random, 0.5, 2) : 1.0);
  const CellTree tree = tree_of(patch, rational);
  const Centre circle{2.0 * random_point(random), unit(random_point(random)),
                      uniform(random, 0.3, 3)};
  const DistanceRange range = circle_distance(tree[0], tree.shape(), circle);
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) {
      const Vec3 x = point_at(patch, i / 20.0, j / 20.0) - circle.point;
      const double height = dot(x, circle.axis);
      const double far = std::hypot(norm(x - height * circle.axis) - circle.radius, height);
      EXPECT_LE(range.nearest, far);
      EXPECT_GE(range.farthest, far);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, SquareFormProperty, ::testing::Range(0, 24));

TEST(CentreOfCurvature, IsThatOfASphere) {
  const RationalBezierPatch patch = testing::sphere_octant({1, 2, 3}, 2);
  const PatchJet jet = jet_at(patch, 0.4, 0.3, 2);
  for (const double sign : {1.0, -1.0}) {
    const auto centre = centre_of_curvature(jet, sign * unit(jet.point - Vec3{1, 2, 3}));
    ASSERT_TRUE(centre);
    EXPECT_LE(distance(centre->point, {1, 2, 3}), 1e-12);
    EXPECT_EQ(norm(centre->axis), 0);
  }
}

TEST(CentreOfCurvature, IsOnTheAxisOfACylinder) {
  const PatchJet jet = jet_at(testing::cylinder_quarter(1.5, 4), 0.4, 0.3, 2);
  const auto centre = centre_of_curvature(jet, unit(Vec3{jet.point[0], jet.point[1], 0}));
  ASSERT_TRUE(centre);
  EXPECT_LE(std::hypot(centre->point[0], centre->point[1]), 1e-12);
  EXPECT_NEAR(std::abs(centre->axis[2]), 1, 1e-12);
}

TEST(CentreOfCurvature, OfAPlaneIsNone) {
  const BezierSurface square = testing::quadrilateral({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0});
  EXPECT_FALSE(centre_of_curvature(jet_at(square.patches(0, 0), 0.5, 0.5, 2), {0, 0, 1}));
}

}  // namespace
}  // namespace blossom
