// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/spline.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/tracing/spline_fit.h"

namespace blossom {
namespace {

// On a circle by its angle, the derivatives too.
std::array<Vec2, 3> on_circle(double t) {
  const Vec2 point{std::cos(t), std::sin(t)};
  return {point, {-point[1], point[0]}, -1.0 * point};
}

// Hermite pieces of degree 5, each knot as often as pieces need it.
Spline2 pieces_of_circle(const std::vector<double>& knots) {
  Spline2 spline{5, knots, std::vector<int>(knots.size(), 5), {}};
  spline.multiplicities.front() = spline.multiplicities.back() = 6;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const auto piece =
        hermite_points(on_circle(knots[i]), on_circle(knots[i + 1]), knots[i + 1] - knots[i]);
    spline.points.insert(spline.points.end(), piece.begin() + (i == 0 ? 0 : 1), piece.end());
  }
  return spline;
}

double farthest(const Spline2& a, const Spline2& b) {
  double most = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = at(a.domain(), i / 1000.0);
    most = std::max(most, distance(point_at(a, t), point_at(b, t)));
  }
  return most;
}

TEST(IdleKnots, AreTakenOutWhereCurvatureIsContinuous) {
  const Spline2 pieces = pieces_of_circle({0, 0.1, 0.5, 0.6, 1.4, 2});
  const Spline2 sparse = without_idle_knots(pieces);
  EXPECT_EQ(sparse.multiplicities, (std::vector<int>{6, 3, 3, 3, 3, 6}));
  EXPECT_EQ(sparse.points.size(), 18u);
  EXPECT_LE(farthest(pieces, sparse), kSmoothJoin);
}

TEST(IdleKnots, StayWhereAPieceBendsOtherwise) {
  Spline2 pieces = pieces_of_circle({0, 0.5, 1, 1.5, 2});
  pieces.points[12][0] += 1e-6;  // changes the second derivative at 1 from the right
  const Spline2 sparse = without_idle_knots(pieces);
  EXPECT_EQ(sparse.multiplicities, (std::vector<int>{6, 3, 5, 3, 6}));
  EXPECT_LE(farthest(pieces, sparse), kSmoothJoin);
}

TEST(IdleKnots, AreNotLookedForInOtherSplines) {
  const Spline2 pieces = pieces_of_circle({0, 0.5, 1, 2});
  const Spline2 once = without_idle_knots(pieces);
  EXPECT_EQ(without_idle_knots(once), once);
  const Spline2 chord{1, {0, 1, 2}, {2, 1, 2}, {{0, 0}, {1, 0}, {2, 0}}};
  EXPECT_EQ(without_idle_knots(chord), chord);
}

}  // namespace
}  // namespace blossom
