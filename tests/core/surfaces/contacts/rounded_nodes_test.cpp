// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes in which the surfaces are a few roundings of coordinates apart, as files have them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/forms/algebra/products.h"
#include "core/surface_intersection.h"
#include "tests/support/draws.h"
#include "tests/support/random.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::Random;

// Of both branches together, where the surfaces stay within tolerance and one may stand for the
// other.
constexpr double kInContact = 1e-2;

// The distance from a line through (x, y), by its angle.
BezierFunction2 distance_from_line(double x, double y, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), at_0 = s * x - c * y;
  BezierFunction2 f{Grid<double>(2, 2)};
  f.points(0, 0) = at_0;
  f.points(1, 0) = at_0 - s;
  f.points(0, 1) = at_0 + c;
  f.points(1, 1) = at_0 - s + c;
  return f;
}

// The graph of a function of degree 2 over the unit square.
BezierSurface graph_over_square(const BezierFunction2& z, double scale, double lift) {
  Grid<Vec4> net(3, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) net(i, j) = {i / 2.0, j / 2.0, scale * z.points(i, j) + lift, 1};
  return testing::of_patch(RationalBezierPatch{net});
}

// Of what lies in the unit square of a line through (x, y).
double length_in_square(double x, double y, double angle) {
  double from = -1e9, to = 1e9;
  for (const auto& [p, run] : {std::pair{x, std::cos(angle)}, std::pair{y, std::sin(angle)}}) {
    from = std::max(from, std::min(-p / run, (1 - p) / run));
    to = std::min(to, std::max(-p / run, (1 - p) / run));
  }
  return to - from;
}

// Two lines that cross at a small angle, in a saddle that is lifted by a rounding. Branches are
// hyperbolas: they pass the node or end in it, and are all written down.
TEST(RoundedNodes, BranchesBesideThemAreWritten) {
  Random random = testing::seeded(31);
  for (int trial = 0; trial < 240; ++trial) {
    SCOPED_TRACE(trial);
    const double x = testing::uniform(random, 0.3, 0.7), y = testing::uniform(random, 0.3, 0.7);
    const double turn = testing::uniform(random, 0, std::numbers::pi);
    const double angle = testing::uniform(random, 0.05, 0.3);
    const BezierFunction2 saddle =
        product(distance_from_line(x, y, turn), distance_from_line(x, y, turn + angle));
    const double scale = testing::log_uniform(random, 0.3, 3);
    const double lift = testing::log_uniform(random, 1e-13, 8e-12) * (trial % 2 == 0 ? 1 : -1);
    const SurfaceIntersection found =
        intersect(graph_over_square(saddle, scale, lift), graph_over_square(saddle, 0, 0), {});
    EXPECT_NE(found.status, Status::Stopped);
    double length = 0;
    for (const IntersectionCurve& curve : found.curves) {
      length += curve.length;
      EXPECT_LE(std::max(curve.deviation.a, curve.deviation.b), 1e-7);
    }
    EXPECT_NEAR(length, length_in_square(x, y, turn) + length_in_square(x, y, turn + angle),
                kInContact);
  }
}

}  // namespace
}  // namespace blossom
