// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/arc_bend.h"

#include <gtest/gtest.h>

#include "tests/support/cubic_family.h"

namespace blossom {
namespace {

// Graph a is 0 along v = k u^2, and b is the plane 0 over a larger square.
TEST(ArcBend, IsThatOfAParabola) {
  for (const double k : {-0.7, 0.2, 1.0}) {
    SCOPED_TRACE(k);
    const testing::Cubic x = testing::linear(0, 1, 0), y = testing::linear(0, 0, 1);
    const BezierSurface a = testing::graph(0.5 * (y + -k * (x * x)), {0, 0}, {1, 0}, {0, 1});
    const BezierSurface b = testing::graph({}, {-0.3, -0.3}, {1.7, 0}, {0, 1.7});
    CellTree tree_a(a.patches(0, 0), false, {}, CellForm::Bezier, 0.5);
    CellTree tree_b(b.patches(0, 0), false, {}, CellForm::Bezier, 0.5);
    const PairModel model(tree_a, tree_a[0], tree_b, tree_b[0]);
    ArcStretches stretches(model, 0);

    const auto of_v = bend_over(model, stretches.stretch(1), 0, 1);
    const auto of_s = bend_over(model, stretches.stretch(1), 0, 2);
    const auto of_u = bend_over(model, stretches.stretch(1), 0, 0);

    ASSERT_TRUE(of_v && of_s && of_u);
    EXPECT_LE(of_v->from, 2 * k);
    EXPECT_GE(of_v->to, 2 * k);
    EXPECT_LE(length(*of_v), 1e-6);
    EXPECT_LE(of_s->from, 0);
    EXPECT_GE(of_s->to, 0);
    EXPECT_EQ(length(*of_u), 0);
  }
}

}  // namespace
}  // namespace blossom
