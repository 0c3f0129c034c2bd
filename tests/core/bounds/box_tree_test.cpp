// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/bounds/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <set>

#include "core/base/unbounded.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::random_point;
using testing::seeded;
using testing::uniform;

std::vector<Box> random_boxes(testing::Random& random, int count) {
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 centre = random_point(random);
    const Vec3 half{uniform(random, 0, 0.1), uniform(random, 0, 0.1), uniform(random, 0, 0.1)};
    boxes.push_back({centre - half, centre + half});
  }
  return boxes;
}

TEST(LineProbe, EntersABoxAtItsNearSide) {
  const Box box{{1, -1, -1}, {2, 1, 1}};
  EXPECT_EQ(LineProbe({0, 0, 0}, {1, 0, 0}, 0, kInfinity).entry(box), 1);
  EXPECT_EQ(LineProbe({3, 0, 0}, {-2, 0, 0}, 0, kInfinity).entry(box), 0.5);
  EXPECT_EQ(LineProbe({0, 0, 0}, {-1, 0, 0}, 0, kInfinity).entry(box), kInfinity);
  EXPECT_EQ(LineProbe({0, 0, 0}, {-1, 0, 0}, -kInfinity, kInfinity).entry(box), -2);
  EXPECT_EQ(LineProbe({0, 0, 0}, {1, 0, 0}, 0, 0.5).entry(box), kInfinity);
}

TEST(LineProbe, MeetsABoxWhoseSideItRunsIn) {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  for (const double sign : {0.0, -0.0})
    for (const double side : {0.0, 1.0})
      EXPECT_EQ(LineProbe({-1, side, 0.5}, {1, sign, sign}, 0, kInfinity).entry(box), 1);
  EXPECT_EQ(LineProbe({-1, 1.5, 0.5}, {1, 0, 0}, 0, kInfinity).entry(box), kInfinity);
  const Box flat{{0, 0, 0}, {1, 1, 0}};
  EXPECT_EQ(LineProbe({-1, 0.5, 0}, {1, 0, 0}, 0, kInfinity).entry(flat), 1);
}

class BoxTreeProperty : public ::testing::TestWithParam<int> {};

TEST_P(BoxTreeProperty, PairsEachTwoBoxesThatMeetOnce) {
  auto random = seeded(GetParam());
  const std::vector<Box> boxes = random_boxes(random, 1 + 300 * GetParam());
  std::mutex told;
  std::multiset<std::array<int, 2>> found;
  BoxTree(boxes).for_each_pair([&](int i, int j) {
    const std::lock_guard guard(told);
    found.insert({std::min(i, j), std::max(i, j)});
  });
  std::multiset<std::array<int, 2>> wanted;
  for (std::size_t j = 0; j < boxes.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (meet(boxes[i], boxes[j])) wanted.insert({static_cast<int>(i), static_cast<int>(j)});
  EXPECT_EQ(found, wanted);
}

TEST_P(BoxTreeProperty, VisitsAllBoxesAlongALine) {
  auto random = seeded(GetParam());
  const std::vector<Box> boxes = random_boxes(random, 1 + 40 * GetParam());
  const BoxTree tree(boxes);
  const Vec3 origin = random_point(random), direction = random_point(random);
  const LineProbe probe(origin, direction, 0, kInfinity);

  std::set<int> visited;
  tree.for_each_along(probe, [&](int i, double entry) {
    EXPECT_EQ(entry, probe.entry(boxes[static_cast<std::size_t>(i)]));
    visited.insert(i);
    return kInfinity;
  });

  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    EXPECT_EQ(visited.contains(i), probe.entry(boxes[static_cast<std::size_t>(i)]) < kInfinity);
}

TEST_P(BoxTreeProperty, FindsTheBoxNearestToAPoint) {
  auto random = seeded(GetParam());
  const std::vector<Box> boxes = random_boxes(random, 1 + 40 * GetParam());
  const Vec3 point = 2 * random_point(random);

  double bound = kInfinity;
  int visits = 0;
  BoxTree(boxes).for_each_near(point, bound, [&](int i) {
    ++visits;
    return bound = std::min(bound, squared_distance(boxes[static_cast<std::size_t>(i)], point));
  });

  double nearest = kInfinity;
  for (const Box& box : boxes) nearest = std::min(nearest, squared_distance(box, point));
  EXPECT_EQ(bound, nearest);
  EXPECT_LE(visits, 40);
}

INSTANTIATE_TEST_SUITE_P(Seeds, BoxTreeProperty, ::testing::Range(0, 12));

}  // namespace
}  // namespace blossom
