// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/critical_places.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

CriticalPair pair_in(const Vec3& low, const Vec3& high) {
  CriticalPair pair;
  pair.low = low;
  pair.high = high;
  return pair;
}

// Two rows of boxes that touch their neighbours.
std::vector<CriticalPair> two_rows(int count) {
  std::vector<CriticalPair> pairs;
  for (int i = 0; i < count; ++i)
    for (const double y : {0.0, 0.5}) {
      const double x = static_cast<double>(i) / count, width = 1.01 / count;
      pairs.push_back(pair_in({x, y, 0}, {x + width, y + width, width}));
    }
  return pairs;
}

TEST(CriticalPlaces, GatherWhatMeets) {
  for (const int count : {20, 4000}) {  // by their boxes, and over a grid
    const auto clusters = clusters_of(two_rows(count));
    ASSERT_EQ(clusters.size(), 2u) << count;
    for (const CriticalCluster& cluster : clusters)
      EXPECT_EQ(cluster.pairs.size(), static_cast<std::size_t>(count));
  }
}

// Each box covers most of a fine grid, in which they would be marked billions of times.
TEST(CriticalPlaces, GatherLargeBoxesByACoarseGrid) {
  auto random = seeded(3);
  std::vector<CriticalPair> pairs;
  for (int i = 0; i < 60'000; ++i) {
    Vec3 low, high;
    for (int k = 0; k < 3; ++k) {
      low[k] = uniform(random, 0, 0.1);
      high[k] = uniform(random, 0.9, 1);
    }
    pairs.push_back(pair_in(low, high));
  }
  EXPECT_EQ(clusters_of(pairs).size(), 1u);
}

}  // namespace
}  // namespace blossom
