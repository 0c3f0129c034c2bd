// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/cells/valley.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/surface_intersection.h"
#include "tests/support/cubic_draws.h"
#include "tests/support/draws.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::linear;
using testing::log_uniform;
using testing::uniform;

// A loop goes round the corner of the patch: some cell has but a little of it, beside the place
// where the branch turns back, and is read by a model that is off by more than that.
TEST(ValleyCell, HasNoPointsOfABranchBesideIt) {
  auto random = testing::seeded(3);
  for (int draw = 0; draw < 700; ++draw) {
    SCOPED_TRACE(draw);
    const double r = log_uniform(random, 2e-3, 5e-2), k = log_uniform(random, 1e-2, 1),
                 l = log_uniform(random, 1e-2, 1), y = uniform(random, 0.3, 0.7),
                 x = uniform(random, 0.3, 0.7);
    const testing::Cubic base = testing::random_base(random);
    const testing::Cubic to_x = linear(-x, 1, 0), to_y = linear(-y, 0, 1);
    const testing::Cubic h =
        to_x * to_x + to_y * to_y + testing::constant(-r * r) + (k * r) * to_x + (l * r) * to_y;
    const SurfaceIntersection found =
        intersect(testing::graph(base + h, {x, 0}, {1 - x, 0}, {0, y}),
                  testing::graph(base, {-0.6, 0.3}, {1.6, -1.2}, {1.2, 1.6}));
    ASSERT_EQ(found.curves.size(), 1u);
    const auto& samples = found.curves[0].samples;
    EXPECT_LT(samples.size(), 500u);
    EXPECT_TRUE(std::ranges::all_of(
        samples, [](const SurfacePoint& p) { return p.uv_a[0] > -1e-9 && p.uv_a[1] < 1 + 1e-9; }));
  }
}

}  // namespace
}  // namespace blossom
