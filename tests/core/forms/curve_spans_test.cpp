// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/curve_spans.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/errors.h"
#include "core/forms/evaluation.h"
#include "tests/support/curves.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::coordinate_gap;
using testing::random_curve;
using testing::reference_point;
using testing::seeded;
using testing::uniform;

TEST(CurveSpans, CircleHasItsAnglesAsParameters) {
  const CurveSpans circle = testing::circle({1, 2}, 3);
  for (const double angle : {0.0, 0.3, 1.7, 4.0, 6.28})
    EXPECT_LE(coordinate_gap(point_at(circle, angle),
                             Vec3{1 + 3 * std::cos(angle), 2 + 3 * std::sin(angle), 0}),
              1e-14);
}

TEST(CurveSpans, RefusesGapsInParametersAndBadWeights) {
  CurveSpans curve = testing::polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  EXPECT_NO_THROW(validate(curve, "c"));
  curve.spans[1].place.from = 1.5;
  EXPECT_THROW(validate(curve, "c"), InvalidInput);
  curve = testing::circle({0, 0}, 1);
  curve.spans[2].curve.points[1][3] = 0;
  EXPECT_THROW(validate(curve, "c"), InvalidInput);
}

TEST(CurveJet, PointsAreRightWithinTheStatedError) {
  auto random = seeded(1);
  for (int n = 1; n <= kMaxDegree; ++n) {
    const BezierCurve curve = random_curve(random, n);
    const double t = uniform(random, 0, 1);
    const CurveJet jet = jet_at(curve_spans(curve).spans[0].curve, t);
    EXPECT_LE(coordinate_gap(jet.point, reference_point(curve, t)), evaluation_error(n));
  }
}

// X / w with X = t^2, w = 1 + t: first (t^2 + 2t) / w^2, second 2 / w^3.
TEST(CurveJet, DerivativesOfAQuotientAreKnown) {
  const RationalBezierCurve curve{{{0, 0, 0, 1}, {0, 0, 0, 1.5}, {1, 0, 0, 2}}};
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    const CurveJet jet = jet_at(curve, t);
    const double w = 1 + t;
    EXPECT_NEAR(jet.point[0], t * t / w, 1e-15);
    EXPECT_NEAR(jet.first[0], (t * t + 2 * t) / (w * w), 1e-14);
    EXPECT_NEAR(jet.second[0], 2 / (w * w * w), 1e-14);
  }
}

}  // namespace
}  // namespace blossom
