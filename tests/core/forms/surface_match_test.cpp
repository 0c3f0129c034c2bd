// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/surface_match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace blossom {
namespace {

constexpr double kWithin = 1e-10;

// Rational, 2 x 3 spans of degrees 2 and 3, without any symmetry.
BezierSurface waves() {
  BezierSurface surface{.u_knots = {-1, 0.5, 2}, .v_knots = {0, 1, 1.5, 4}, .rational = true};
  surface.patches = Grid<RationalBezierPatch>(2, 3);
  for (int p = 0; p < 2; ++p)
    for (int q = 0; q < 3; ++q) {
      RationalBezierPatch& patch = surface.patches(p, q);
      patch.points = Grid<Vec4>(3, 4);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j) {
          const double x = 2 * p + i, y = 3 * q + j, w = 1 + 0.1 * std::sin(x + 2 * y);
          patch.points(i, j) = Vec4{w * x, w * y * (1 + 0.01 * x), w * std::cos(x * y), w};
        }
    }
  return surface;
}

template <class T>
Grid<T> turned(const Grid<T>& grid, bool exchanged, bool reversed) {
  const int m = grid.rows(), n = grid.columns();
  Grid<T> result = exchanged ? Grid<T>(n, m) : Grid<T>(m, n);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const int row = reversed ? m - 1 - i : i;
      (exchanged ? result(j, row) : result(row, j)) = grid(i, j);
    }
  return result;
}

// The surface with u reversed, and then the directions exchanged.
BezierSurface turned(BezierSurface surface, bool exchanged, bool reversed) {
  if (reversed) {
    std::reverse(surface.u_knots.begin(), surface.u_knots.end());
    for (double& knot : surface.u_knots) knot = 7 - 2 * knot;
  }
  if (exchanged) std::swap(surface.u_knots, surface.v_knots);
  surface.patches = turned(surface.patches, exchanged, reversed);
  for (RationalBezierPatch& patch : surface.patches.values())
    patch.points = turned(patch.points, exchanged, reversed);
  return surface;
}

void expect_same_points(const BezierSurface& a, const BezierSurface& b, const SurfaceMatch& found) {
  for (const double u : {-1.0, -0.3, 0.5, 1.1, 2.0})
    for (const double v : {0.0, 0.7, 1.2, 3.3, 4.0})
      EXPECT_LE(distance(point_at(a, {u, v}), point_at(b, found.map({u, v}))), found.gap + 1e-13);
}

TEST(SurfaceMatch, OfACopyIsTheIdentityWithoutAGap) {
  const std::optional<SurfaceMatch> found = match(waves(), waves(), kWithin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->gap, 0);
  EXPECT_EQ(found->map({0.3, 1.7}), (Vec2{0.3, 1.7}));
}

TEST(SurfaceMatch, SeesThroughReversedAndExchangedParameters) {
  for (const bool exchanged : {false, true})
    for (const bool reversed : {false, true}) {
      const BezierSurface other = turned(waves(), exchanged, reversed);
      const std::optional<SurfaceMatch> found = match(waves(), other, kWithin);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->gap, 0);
      expect_same_points(waves(), other, *found);
      const std::optional<SurfaceMatch> back = match(other, waves(), kWithin);
      ASSERT_TRUE(back);
      EXPECT_LE(distance(back->map(found->map({0.3, 1.7})), Vec2{0.3, 1.7}), 1e-14);
    }
}

// Points moved, weights changed by a factor of their own, an inexact form: each is in the bound.
TEST(SurfaceMatch, BoundsWhatTheNumbersDifferBy) {
  BezierSurface moved = waves();
  for (RationalBezierPatch& patch : moved.patches.values())
    for (Vec4& p : patch.points.values()) p = 2.0 * p + Vec4{0, 0, 3e-11 * p[3], 0};
  BezierSurface heavier = waves();
  heavier.patches(1, 1).points(1, 2) = (1 + 1e-12) * heavier.patches(1, 1).points(1, 2);
  BezierSurface inexact = waves();
  inexact.error = 2e-11;
  for (const auto& [other, least] :
       {std::pair{moved, 1.4e-11}, std::pair{heavier, 1e-12}, std::pair{inexact, 2e-11}}) {
    const std::optional<SurfaceMatch> found = match(waves(), other, kWithin);
    ASSERT_TRUE(found);
    EXPECT_GE(found->gap, least);
    EXPECT_LE(found->gap, kWithin);
    expect_same_points(waves(), other, *found);
  }
}

// What approximations are off says nothing against their being of one surface.
TEST(SurfaceMatch, AddsWhatInexactFormsAreOff) {
  BezierSurface inexact = waves();
  inexact.error = 3 * kWithin;
  const std::optional<SurfaceMatch> found = match(inexact, inexact, kWithin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->gap, 6 * kWithin);
}

TEST(SurfaceMatch, IsNoneOfSurfacesThatDiffer) {
  BezierSurface moved = waves();
  moved.patches(1, 2).points(2, 3)[2] += 2 * kWithin;
  BezierSurface heavier = waves();
  heavier.patches(1, 1).points(1, 2) = 1.001 * heavier.patches(1, 1).points(1, 2);
  BezierSurface divided = waves();
  divided.v_knots[1] = 1.01;
  BezierSurface of_angles = waves();
  of_angles.v_law = ParameterLaw::Angle;
  for (const BezierSurface& other : {moved, heavier, divided, of_angles})
    EXPECT_FALSE(match(waves(), other, kWithin));
}

}  // namespace
}  // namespace blossom
