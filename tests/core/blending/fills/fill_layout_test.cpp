// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/fills/fill_layout.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "core/base/errors.h"
#include "core/blending/fills/fill_operator.h"

namespace blossom {
namespace {

constexpr std::array kLayouts{FillLayout::Star, FillLayout::Ring, FillLayout::DeepRing};

double det(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

TEST(PolygonLayout, CoversThePolygonWithConvexQuads) {
  for (const FillLayout kind : kLayouts)
    for (int n = kMinFillSides; n <= kMaxFillSides; ++n) {
      const PolygonLayout layout = polygon_layout(kind, n);
      double area = 0;
      for (int quad = 0; quad < static_cast<int>(layout.quads.size()); ++quad)
        for (int edge = 0; edge < 4; ++edge) {
          const auto c = corners_from(layout, {quad, edge, 0});
          EXPECT_GT(det(c[1] - c[0], c[3] - c[0]), 0.01) << to_string(kind) << n;
          area += det(c[0], c[1]) / 2;
        }
      EXPECT_NEAR(area, std::sin(sector_angle(n)) / 2, 1e-15) << to_string(kind) << n;
    }
}

TEST(PolygonLayout, HasAnInnerEdgeForEveryTwoOpenSidesOfQuads) {
  // Each quad of a sector has four edges; two of the sector's are halves of the polygon's side.
  for (const FillLayout kind : kLayouts)
    for (int n = kMinFillSides; n <= kMaxFillSides; ++n) {
      const PolygonLayout layout = polygon_layout(kind, n);
      EXPECT_EQ(2 * layout.shared.size(), 4 * layout.quads.size() - 2) << to_string(kind) << n;
    }
}

TEST(PolygonLayout, HasZeroOneOrTwoInnerEdgesAtACorner) {
  for (const FillLayout kind : kLayouts) {
    const PolygonLayout layout = polygon_layout(kind, 5);
    int at_corner = 0;
    for (const SharedQuadEdge& edge : layout.shared) {
      const auto c = corners_from(layout, edge.a);
      for (int end = 0; end < 2; ++end)
        at_corner += std::abs(norm(c[static_cast<std::size_t>(end)]) - 1) < 1e-12;
    }
    EXPECT_EQ(at_corner, static_cast<int>(kind)) << to_string(kind);
  }
}

TEST(PolygonLayout, RefusesTwoSidesAndThirteen) {
  EXPECT_THROW(polygon_layout(FillLayout::Star, 2), InvalidInput);
  EXPECT_THROW(polygon_layout(FillLayout::Ring, 13), InvalidInput);
}

TEST(FillOperator, IsMadeOnceForEachLayoutAndShared) {
  const auto a = fill_operator(FillLayout::Star, 4, 5, FillGoal::First);
  EXPECT_EQ(a, fill_operator(FillLayout::Star, 4, 5, FillGoal::First));
  EXPECT_NE(a, fill_operator(FillLayout::Star, 4, 6, FillGoal::First));
}

TEST(FillOperator, IsOneForThreadsThatAskAtTheSameTime) {
  std::array<std::shared_ptr<const FillOperator>, 4> made;
  std::vector<std::thread> threads;
  for (auto& one : made)
    threads.emplace_back([&one] { one = fill_operator(FillLayout::Ring, 7, 5, FillGoal::First); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& one : made) EXPECT_EQ(one, made.front());
}

TEST(FillOperator, RefusesDegreesThatItIsNotMadeFor) {
  EXPECT_THROW(FillOperator(FillLayout::Star, 4, 1, FillGoal::First), InvalidInput);
  EXPECT_THROW(FillOperator(FillLayout::Star, 4, kMaxFillDegree + 1, FillGoal::First),
               InvalidInput);
}

}  // namespace
}  // namespace blossom
