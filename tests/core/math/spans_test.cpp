// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/spans.h"

#include <gtest/gtest.h>

namespace blossom {
namespace {

TEST(SpanOf, IsTheLastThatBeginsThereAndAnEndOneBeyond) {
  const std::vector<double> knots{0, 1, 1, 3};
  EXPECT_EQ(span_of(knots, 0.5), 0u);
  EXPECT_EQ(span_of(knots, 1), 2u);  // past the one without a length
  EXPECT_EQ(span_of(knots, 2), 2u);
  EXPECT_EQ(span_of(knots, 3), 2u);
  EXPECT_EQ(span_of(knots, -7), 0u);
  EXPECT_EQ(span_of(knots, 7), 2u);
  EXPECT_EQ(span_of({0, 1}, 5), 0u);
}

}  // namespace
}  // namespace blossom
