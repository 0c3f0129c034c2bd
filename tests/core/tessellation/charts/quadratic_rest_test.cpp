// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/charts/quadratic_rest.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/forms/evaluation.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/tessellation/charts/spline_chart.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

// A patch over [0, 1]^2 in four parts.
std::vector<PlacedNet> quarters(const BezierPatch& patch, double u, double v) {
  std::vector<PlacedNet> parts;
  for (const Interval in_u : {Interval{0, u}, Interval{u, 1}})
    for (const Interval in_v : {Interval{0, v}, Interval{v, 1}})
      parts.push_back({sub_patch(patch, in_u, in_v), in_u, in_v});
  return parts;
}

BezierPatch random_patch_of(int rows, int columns, testing::Random& random) {
  BezierPatch patch{Grid<Vec3>(rows, columns)};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      patch.points(i, j) = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
  return patch;
}

Vec3 value(const BezierPatch& patch, const Vec2& uv) {
  RationalBezierPatch weighted{Grid<Vec4>(patch.points.rows(), patch.points.columns())};
  for (int i = 0; i < patch.points.rows(); ++i)
    for (int j = 0; j < patch.points.columns(); ++j) {
      const Vec3& p = patch.points(i, j);
      weighted.points(i, j) = {p[0], p[1], p[2], 1};
    }
  return point_at(weighted, uv[0], uv[1]);
}

TEST(QuadraticRest, OfAQuadraticSurfaceIsNone) {
  // (u + v^2, 3 u v - v, 2 u^2 + u v + 1) by its blossom.
  BezierPatch patch{Grid<Vec3>(3, 3)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double u = i / 2.0, v = j / 2.0, uu = i == 2 ? 1 : 0, vv = j == 2 ? 1 : 0;
      patch.points(i, j) = {u + vv, 3 * u * v - v, 2 * uu + u * v + 1};
    }

  const QuadraticRest found = quadratic_rest(quarters(patch, 0.3, 0.6));

  EXPECT_LE(norm(found.rest), 1e-14);
  EXPECT_LE(distance(found.uu, {0, 0, 4}), 1e-12);
  EXPECT_LE(distance(found.uv, {0, 3, 1}), 1e-12);
  EXPECT_LE(distance(found.vv, {2, 0, 0}), 1e-12);
}

// Without bounds on derivatives, which are taken to be enormous, the form alone bounds the facet.
TEST(QuadraticRest, BoundsFacetsOfRandomSurfaces) {
  auto random = seeded(5);
  JetEnclosure unknown;
  unknown.uu.radius = unknown.uv.radius = unknown.vv.radius = {1e9, 1e9, 1e9};
  unknown.length_u = unknown.length_v = 1e9;
  for (int trial = 0; trial < 200; ++trial) {
    const BezierPatch patch = random_patch_of(2 + trial % 5, 2 + trial % 4, random);
    const QuadraticRest form = quadratic_rest(quarters(patch, 0.4, 0.7));
    std::array<Vec2, 3> corners;
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = {uniform(random, 0, 1), uniform(random, 0, 1)};
      p[k] = value(patch, corners[k]);
    }
    const double bound = facet_distance(unknown, {0, 0, 1}, corners, form);
    for (int i = 0; i <= 12; ++i)
      for (int j = 0; i + j <= 12; ++j) {
        const double s = i / 12.0, t = j / 12.0, r = 1 - s - t;
        const Vec2 uv = r * corners[0] + s * corners[1] + t * corners[2];
        const Vec3 on_facet = r * p[0] + s * p[1] + t * p[2];
        EXPECT_LE(distance(value(patch, uv), on_facet), bound + 1e-12);
      }
  }
}

// Forty waves of the height 1e-3, each a piece of degree 5. By second derivatives, which are 4000
// times as large, a facet over all of them would be off by 6.
TEST(QuadraticRest, OfWavesIsAsLargeAsTheyAreHigh) {
  constexpr int kWaves = 40;
  constexpr double kHigh = 1e-3;
  BezierSurface surface;
  surface.v_knots = {0, 1};
  surface.patches = Grid<RationalBezierPatch>(kWaves, 1);
  for (int k = 0; k <= kWaves; ++k) surface.u_knots.push_back(static_cast<double>(k) / kWaves);
  for (int k = 0; k < kWaves; ++k) {
    RationalBezierPatch& patch = surface.patches(k, 0);
    patch.points = Grid<Vec4>(6, 2);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 2; ++j) {
        const double side = k % 2 == 0 ? kHigh : -kHigh;
        patch.points(i, j) = {(k + i / 5.0) / kWaves, static_cast<double>(j),
                              i == 2 || i == 3 ? side : 0, 1};
      }
  }
  // Three waves are what a facet asks of its own; over more of them cells decide.
  const SplineChart chart(surface, 1e-4);
  const std::array corners{Vec2{0, 0}, Vec2{3.0 / kWaves, 0}, Vec2{0, 1}};

  EXPECT_LE(chart.facet_distance(corners, {0, 0, 1}, 0), 4 * kHigh);
}

}  // namespace
}  // namespace blossom
