// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/cleaning/short_spans.h"

#include <gtest/gtest.h>

#include "tests/support/region_checks.h"

namespace blossom {
namespace {

using testing::heights;

constexpr double kSpanTolerance = 1e-6;

PlanarSpan straight(const Vec2& from, const Vec2& to, const Interval& place) {
  return {{{{from[0], from[1], 1}, {to[0], to[1], 1}}}, place, ParameterLaw::Linear};
}

// Along u = 0.3, in spans that become shorter and shorter towards its end.
PlanarCurve refined() {
  PlanarCurve curve;
  double from = 0;
  for (const double to : {0.9, 0.99999, 0.9999999, 1.0}) {
    curve.spans.push_back(straight({0.3, from}, {0.3, to}, {from, to}));
    from = to;
  }
  return curve;
}

TEST(ShortSpans, BecomePartsOfTheirNeighbours) {
  const PlanarCurve made =
      without_short_spans(heights({0, 1}, {0, 1}, 3), refined(), kSpanTolerance);

  ASSERT_EQ(made.spans.size(), 2u);
  EXPECT_EQ(made.spans[1].place.from, 0.9);
  EXPECT_EQ(made.domain().to, 1);
}

TEST(ShortSpans, TakeNoPointFartherThanTheDistance) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 3);
  PlanarCurve given = refined();
  given.spans[2] = straight({0.3, 0.99999}, {0.30001, 0.9999999}, given.spans[2].place);
  given.spans[3] = straight({0.30001, 0.9999999}, {0.3, 1}, given.spans[3].place);

  const PlanarCurve made = without_short_spans(surface, given, kSpanTolerance);

  for (std::size_t k = 0; k + 1 < made.spans.size(); ++k)
    EXPECT_EQ(made.spans[k].place.to, made.spans[k + 1].place.from);
  for (const PlanarSpan& span : given.spans)
    for (int k = 0; k <= 10; ++k) {
      const double t = at(span.place, k / 10.0);
      EXPECT_LE(
          distance(point_at(surface, point_at(given, t)), point_at(surface, point_at(made, t))),
          kSpanTolerance);
    }
}

TEST(ShortSpans, StayWhereTheCurveHasACorner) {
  PlanarCurve given;
  given.spans = {straight({0.3, 0}, {0.3, 0.5}, {0, 1}),
                 straight({0.3, 0.5}, {0.30004, 0.5}, {1, 2}),
                 straight({0.30004, 0.5}, {0.30004, 1}, {2, 3})};
  const PlanarCurve made = without_short_spans(heights({0, 1}, {0, 1}, 3), given, kSpanTolerance);
  EXPECT_EQ(made.spans.size(), 3u);
}

}  // namespace
}  // namespace blossom
