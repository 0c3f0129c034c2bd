// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/tessellation.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/forms/algebra/de_casteljau.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::lerp;
using testing::random_patch;
using testing::seeded;
using testing::uniform;

RationalBezierPatch random_rational_patch(testing::Random& random, int n, int m) {
  RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
  for (Vec4& point : patch.points.values()) point[3] = uniform(random, 0.5, 2);
  return patch;
}

Vec3 in_space(const Vec4& p) { return {p[0] / p[3], p[1] / p[3], p[2] / p[3]}; }

// x = u, y = v, z = u^2: second derivatives (0, 0, 2), 0, 0.
RationalBezierPatch gutter() {
  RationalBezierPatch patch{Grid<Vec4>(3, 2)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) patch.points(i, j) = {0.5 * i, 1.0 * j, i == 2 ? 1.0 : 0.0, 1};
  return patch;
}

TEST(Tessellation, OfAGutterNeedsCellsAcrossItOnly) {
  const SecondDerivativeBounds bounds = second_derivative_bounds(gutter());
  EXPECT_EQ(bounds.uu, 2);
  EXPECT_EQ(bounds.uv, 0);
  EXPECT_EQ(bounds.vv, 0);

  const CellCount cells = cells_for_tolerance(gutter(), 0.0101);  // chord error 1 / (4 n^2)

  EXPECT_EQ(cells.u, 5);
  EXPECT_EQ(cells.v, 1);
}

TEST(Tessellation, OfAGutterHasTheChordErrorOfAParabola) {
  // z = u^2 over a chord of length 1 / 4: the sagitta is 1 / 64, reached in the middle.
  EXPECT_EQ(chord_bound(second_derivative_bounds(gutter()), {4, 1}), 1.0 / 64);
}

TEST(Tessellation, OfAPlaneIsOneCell) {
  RationalBezierPatch plane{Grid<Vec4>(2, 2)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) plane.points(i, j) = {1.0 * i, 1.0 * j, 0, 1};

  const CellCount cells = cells_for_tolerance(plane, 1e-9);

  EXPECT_EQ(cells.u, 1);
  EXPECT_EQ(cells.v, 1);
  EXPECT_EQ(points_on_grid(plane, cells)(1, 1), (Vec3{1, 1, 0}));
}

class TessellationProperty : public ::testing::TestWithParam<int> {};

TEST_P(TessellationProperty, TrianglesStayWithinTheTolerance) {
  auto random = seeded(GetParam());
  const RationalBezierPatch patch =
      random_rational_patch(random, GetParam() % 6, 1 + GetParam() % 4);
  const double tolerance = 0.02;

  const CellCount cells = cells_for_tolerance(patch, tolerance);
  const Grid<Vec3> points = points_on_grid(patch, cells);

  EXPECT_LE(chord_bound(second_derivative_bounds(patch), cells), tolerance);
  for (int sample = 0; sample < 200; ++sample) {
    const int i = testing::pick(random, 0, cells.u - 1), j = testing::pick(random, 0, cells.v - 1);
    const double s = uniform(random, 0, 1), t = uniform(random, 0, 1 - s);
    const Vec3 chord = points(i, j) * (1 - s - t) + points(i + 1, j) * s + points(i, j + 1) * t;
    const Vec3 exact = in_space(point_at(patch, (i + s) / cells.u, (j + t) / cells.v));
    EXPECT_LE(distance(chord, exact), tolerance);
  }
}

TEST_P(TessellationProperty, SecondDifferencesAreBelowTheBounds) {
  auto random = seeded(GetParam());
  const RationalBezierPatch patch =
      random_rational_patch(random, 1 + GetParam() % 4, 1 + GetParam() % 5);
  const SecondDerivativeBounds bounds = second_derivative_bounds(patch);
  const auto at = [&](double u, double v) { return in_space(point_at(patch, u, v)); };
  const double h = 0x1p-10;
  for (int sample = 0; sample < 50; ++sample) {
    const double u = uniform(random, h, 1 - h), v = uniform(random, h, 1 - h);
    const Vec3 uu = (at(u + h, v) - at(u, v) * 2 + at(u - h, v)) * (1 / (h * h));
    const Vec3 uv = (at(u + h, v + h) - at(u - h, v + h) - at(u + h, v - h) + at(u - h, v - h)) *
                    (0.25 / (h * h));
    EXPECT_LE(norm(uu), bounds.uu + 1e-6);
    EXPECT_LE(norm(uv), bounds.uv + 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, TessellationProperty, ::testing::Range(0, 24));

TEST(Tessellation, RefusesTolerancesAndWeightsThatAreNotPositive) {
  RationalBezierPatch patch = gutter();
  EXPECT_THROW(cells_for_tolerance(patch, 0), InvalidInput);
  EXPECT_THROW(cells_for_tolerance(patch, std::nan("")), InvalidInput);
  EXPECT_THROW(cells_for_tolerance(patch, 1e-20), InvalidInput);
  EXPECT_THROW(points_on_grid(patch, {0, 1}), InvalidInput);
  patch.points(0, 0)[3] = 0;
  EXPECT_THROW(cells_for_tolerance(patch, 0.1), InvalidInput);
}

}  // namespace
}  // namespace blossom
