// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/bounds/patch_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/forms/evaluation.h"

namespace blossom {
namespace {

constexpr int kShort = 3, kLong = 37;  // spans: no multiple of a block's side

// Bilinear patches over a wave of a few turns, one weight throughout.
BezierSurface wave(int rows, int columns, double turn, double weight) {
  BezierSurface surface;
  for (int i = 0; i <= rows; ++i) surface.u_knots.push_back(i);
  for (int j = 0; j <= columns; ++j) surface.v_knots.push_back(j);
  surface.patches = Grid<RationalBezierPatch>(rows, columns);
  surface.rational = weight != 1;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      Grid<Vec4> net(2, 2);
      for (int k = 0; k < 4; ++k) {
        const double u = (i + k / 2) / double(rows), v = (j + k % 2) / double(columns);
        const Vec3 x{u, v, 0.2 * std::sin(turn * u + 9 * v)};
        net(k / 2, k % 2) = {weight * x[0], weight * x[1], weight * x[2], weight};
      }
      surface.patches(i, j).points = std::move(net);
    }
  return surface;
}

Box box_of(const RationalBezierPatch& patch) {
  Box box;
  for (const Vec4& p : patch.points.values()) box = joined(box, {projected(p), projected(p)});
  return box;
}

class PatchBoxesOf : public ::testing::TestWithParam<double> {};  // a weight

TEST_P(PatchBoxesOf, ListThePairsThatMeetOnceEach) {
  const BezierSurface a = wave(kShort, kLong, 3, GetParam()), b = wave(kLong, kShort, -4, 1);
  std::set<std::array<int, 2>> expected;
  for (int i = 0; i < kShort * kLong; ++i)
    for (int j = 0; j < kShort * kLong; ++j)
      if (meet(box_of(a.patches.values()[static_cast<std::size_t>(i)]),
               box_of(b.patches.values()[static_cast<std::size_t>(j)])))
        expected.insert({i, j});
  const auto found = meeting_patches(PatchBoxes(a), PatchBoxes(b));
  EXPECT_LT(found.size(), a.patches.values().size() * b.patches.values().size() / 2);
  const std::set<std::array<int, 2>> pairs(found.begin(), found.end());
  EXPECT_EQ(pairs.size(), found.size());
  EXPECT_TRUE(std::ranges::includes(pairs, expected));  // rounding may add a few
  EXPECT_LE(pairs.size(), expected.size() + 8);
}

TEST_P(PatchBoxesOf, HoldAllControlPoints) {
  const BezierSurface surface = wave(kLong, kLong, 3, GetParam());
  Box all;
  for (const RationalBezierPatch& patch : surface.patches.values())
    all = joined(all, box_of(patch));
  EXPECT_EQ(PatchBoxes(surface).all().low, all.low);
  EXPECT_EQ(PatchBoxes(surface).all().high, all.high);
}

INSTANTIATE_TEST_SUITE_P(Weights, PatchBoxesOf, ::testing::Values(1.0, 2.0));

TEST(PatchBoxes, OfOnePatchAreItsBox) {
  const BezierSurface low = wave(1, 1, 0, 1);
  BezierSurface high = low;
  for (Vec4& p : high.patches(0, 0).points.values()) p[2] += 1;
  EXPECT_EQ(meeting_patches(PatchBoxes(low), PatchBoxes(low)),
            (std::vector<std::array<int, 2>>{{0, 0}}));
  EXPECT_TRUE(meeting_patches(PatchBoxes(low), PatchBoxes(high)).empty());
}

}  // namespace
}  // namespace blossom
