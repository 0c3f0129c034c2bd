// SPDX-License-Identifier: LGPL-2.1-or-later
// Random pairs of curves with a number of common points that is known exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/curve_intersection.h"
#include "core/forms/algebra/degree.h"
#include "tests/support/curves.h"
#include "tests/support/random.h"
#include "tests/support/sturm.h"

namespace blossom {
namespace {

using testing::bezier;
using testing::circle;
using testing::in_space;
using testing::seeded;

using std::numbers::pi;

double gap_at(const CurveSpans& a, const CurveSpans& b, const CurvePoint& point) {
  return distance(point_at(a, point.a), point_at(b, point.b));
}

// Every listed point is on both curves; proven ones to rounding.
void expect_on_both(const CurveIntersection& found, const CurveSpans& a, const CurveSpans& b) {
  for (const CurvePoint& p : found.points) {
    EXPECT_LE(gap_at(a, b, p), p.proven ? 1e-12 : 1e-7);
    EXPECT_LE(distance(p.point, point_at(a, p.a)), 1e-12);
    EXPECT_LE(p.box_a.from, p.a);
    EXPECT_LE(p.a, p.box_a.to);
    EXPECT_LE(p.box_b.from, p.b);
    EXPECT_LE(p.b, p.box_b.to);
  }
}

// Circles at random distances, down to the tolerance and below: two crossings, none or a contact.
TEST(CurveIntersection, RandomCirclesNearContactAreRight) {
  auto random = seeded(11);
  for (int trial = 0; trial < 2000; ++trial) {
    const double r = testing::uniform(random, 0.3, 1.3), q = testing::uniform(random, 0.3, 1.3);
    const bool inner = trial % 2 == 0;
    const double sign = testing::pick(random, 0, 1) ? 1 : -1;
    const double gap = sign * std::pow(10, -testing::uniform(random, 1, 12));
    const double d = inner ? std::abs(r - q) - gap : r + q + gap;
    if (d < 0.05) continue;
    const double angle = testing::uniform(random, 0, 2 * pi);
    const CurveSpans a = circle({0.1, 0.2}, r);
    const CurveSpans b = circle({0.1 + d * std::cos(angle), 0.2 + d * std::sin(angle)}, q);
    const CurveIntersection found = intersect(a, b);
    SCOPED_TRACE("trial " + std::to_string(trial) + ", gap " + std::to_string(gap * 1e12) + "e-12");
    if (gap > 1e-7) {
      EXPECT_EQ(found.status, Status::Complete);
      EXPECT_TRUE(found.points.empty());
    } else if (gap > 0) {
      EXPECT_EQ(found.status, Status::Tolerance);
      EXPECT_EQ(found.points.size() + found.overlaps.size(), 1U);
    } else if (found.status == Status::Complete) {
      EXPECT_EQ(found.points.size(), 2U);
    } else {
      EXPECT_FALSE(found.places.empty());
      EXPECT_LE(found.points.size(), 2U);
    }
  }
}

// Graphs y = f(x) and y = g(x) of degree 1..7 with small dyadic coordinates, sheared by whole
// numbers, elevated, reversed and turned into space: the number of crossings is the number of
// roots of f - g, exactly.
class RandomGraphs : public ::testing::TestWithParam<int> {};

BezierCurve graph(const std::vector<double>& y, int sheared) {
  BezierCurve curve;
  const double n = static_cast<double>(y.size()) - 1;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double x = static_cast<double>(i) / n;
    curve.points.push_back({x + sheared * y[i], y[i], 0});
  }
  return curve;
}

TEST_P(RandomGraphs, HaveAsManyCrossingsAsTheirDifferenceHasRoots) {
  auto random = seeded(GetParam());
  for (int trial = 0; trial < 100; ++trial) {
    const int n = testing::pick(random, 1, 3) == 1 ? testing::pick(random, 1, 2)
                                                   : testing::pick(random, 2, 4) * 2 - 1;
    std::vector<double> f, g;
    std::vector<testing::Rational> difference;
    for (int i = 0; i <= n; ++i) {
      f.push_back(testing::pick(random, -64, 64) / 32.0);
      g.push_back(testing::pick(random, -64, 64) / 32.0);
      difference.emplace_back(f.back() - g.back());
    }
    if (f.front() == g.front() || f.back() == g.back()) continue;
    const int count = testing::count_roots(testing::powers(difference), 0, 1);
    const int sheared = testing::pick(random, -2, 2);
    BezierCurve a = graph(f, sheared), b = graph(g, sheared);
    if (testing::pick(random, 0, 1)) b = elevated(b, n + testing::pick(random, 1, 3));
    if (testing::pick(random, 0, 1)) std::reverse(b.points.begin(), b.points.end());
    CurveSpans p = curve_spans(a), q = curve_spans(b);
    if (testing::pick(random, 0, 2) == 0) {
      p = in_space(p);
      q = in_space(q);
    }
    const CurveIntersection found = intersect(p, q);
    EXPECT_EQ(static_cast<int>(found.points.size()), count)
        << "degree " << n << ", trial " << trial << ", status " << to_string(found.status);
    expect_on_both(found, p, q);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomGraphs, ::testing::Range(0, 100));

// Beyond a common end, whose control points are equal bit for bit, random curves cross or do not:
// nothing of that is a contact.
TEST(CurveIntersection, CommonEndsAreProven) {
  auto random = seeded(11);
  const auto curve = [&] {
    std::vector<Vec3> points;
    for (int i = testing::pick(random, 2, 6); i >= 0; --i)
      points.push_back({testing::uniform(random, -1, 1), testing::uniform(random, -1, 1), 0});
    return points;
  };
  for (int trial = 0; trial < 400; ++trial) {
    const std::vector<Vec3> a = curve();
    std::vector<Vec3> b = curve();
    b.front() = a.back();
    CurveSpans p = bezier(a), q = bezier(b);
    if (trial % 2 == 1) {
      p = in_space(p);
      q = in_space(q);
    }
    const CurveIntersection found = intersect(p, q);
    EXPECT_EQ(found.status, Status::Complete) << "trial " << trial;
    const bool has_end = std::ranges::any_of(
        found.points, [](const CurvePoint& x) { return x.a == 1 && x.b == 0 && x.proven; });
    EXPECT_TRUE(has_end) << "trial " << trial;
  }
}

// y = f(x) and y = f(x) + s (x - c) + (x - c)^3: they cross in the inflection of their difference,
// and turn by far more than by the angle between them.
TEST(CurveIntersection, CrossingsOfSmallAngleAreProvenInAnInflection) {
  auto random = seeded(12);
  for (int trial = 0; trial < 200; ++trial) {
    const double c = testing::pick(random, 3, 13) / 16.0;
    const double slope = std::ldexp(1.0, -testing::pick(random, 3, 10));
    std::vector<double> f, g;
    for (int i = 0; i <= 3; ++i) {
      f.push_back(testing::pick(random, -16, 16) / 64.0);
      g.push_back(f.back() + slope * (i / 3.0 - c) + std::pow(1 - c, i) * std::pow(-c, 3 - i));
    }
    CurveSpans p = curve_spans(graph(f, 0)), q = curve_spans(graph(g, 0));
    if (trial % 2 == 1) {
      p = in_space(p);
      q = in_space(q);
    }
    const CurveIntersection found = intersect(p, q);
    EXPECT_EQ(found.status, Status::Complete) << "trial " << trial << ", slope " << slope;
    ASSERT_EQ(found.points.size(), 1U);
    EXPECT_NEAR(found.points[0].a, c, 1e-10);
  }
}

// y = f(x) and y = f(x) + s (x - c)^order, with small dyadic numbers: one common point, however
// long the curves stay within tolerance of each other.
TEST(CurveIntersection, ContactsOfHigherOrderArePoints) {
  auto random = seeded(5);
  for (int trial = 0; trial < 600; ++trial) {
    const int order = 2 + trial % 3;
    const double c = testing::pick(random, 3, 13) / 16.0, s = testing::pick(random, 1, 64) / 4.0;
    std::vector<double> f, g;
    for (int i = 0; i <= order; ++i) {
      f.push_back(testing::pick(random, -64, 64) / 32.0);
      g.push_back(f.back() + s * std::pow(1 - c, i) * std::pow(-c, order - i));
    }
    CurveSpans p = curve_spans(graph(f, 0)), q = curve_spans(graph(g, 0));
    if (trial % 2 == 1) {
      p = in_space(p);
      q = in_space(q);
    }
    const CurveIntersection found = intersect(p, q);
    SCOPED_TRACE(trial);
    EXPECT_EQ(found.status, Status::Tolerance);
    EXPECT_TRUE(found.overlaps.empty());
    ASSERT_EQ(found.points.size(), 1U);
    EXPECT_NEAR(found.points[0].a, c, std::pow(1e-7 / s, 1.0 / order));
  }
}

}  // namespace
}  // namespace blossom
