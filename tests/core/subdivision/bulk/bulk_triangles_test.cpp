// SPDX-License-Identifier: LGPL-2.1-or-later
// Bulk triangles against exact rationals, clockwise, collinear and coincident ones included.

#include "core/subdivision/bulk/bulk_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/forms/triangle.h"
#include "core/math/binomial.h"
#include "core/subdivision/bulk/bulk.h"
#include "tests/core/subdivision/bulk/bulk_samples.h"
#include "tests/support/exact.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::all_levels;
using testing::dyadic;
using testing::exact_blossom;
using testing::exact_gap;
using testing::level_name;
using testing::pick;
using testing::random_net;
using testing::Rational;
using testing::seeded;
using testing::sum_of_plane;

using Corners = std::array<Vec2, 3>;

// kLanes triangles as six lists.
struct Lists {
  std::array<LaneVector, 6> values;

  void add(const Corners& corners) {
    for (std::size_t k = 0; k < 6; ++k)
      values[k].push_back(corners[k / 2][static_cast<int>(k % 2)]);
  }
  TriangleLists spans() const {
    return {values[0], values[1], values[2], values[3], values[4], values[5]};
  }
  Corners operator[](std::size_t piece) const {
    const auto at = [&](std::size_t k) { return values[k][piece]; };
    return {Vec2{at(0), at(1)}, Vec2{at(2), at(3)}, Vec2{at(4), at(5)}};
  }
};

// Triangles of size 2^-exponent; every fourth is collinear, has two equal corners, or is a point.
Corners random_corners(testing::Random& random, int kind) {
  const int exponent = pick(random, 0, 40);
  const double size = std::ldexp(1.0, -exponent);
  const auto start = [&] { return std::min(dyadic(random, exponent), 1 - size); };
  const Vec2 corner_of_box{start(), start()};
  Corners corners;
  for (Vec2& corner : corners)
    corner = corner_of_box + size * Vec2{dyadic(random, 8), dyadic(random, 8)};
  if (kind == 1) corners[1] = corners[0];
  if (kind == 2) corners[0] = corners[1] = corners[2];
  if (kind == 3) corners[0][0] = corners[1][0] = corners[2][0];
  return corners;
}

Lists random_lists(testing::Random& random) {
  Lists lists;
  for (int k = 0; k < kLanes; ++k) lists.add(random_corners(random, k % 4));
  return lists;
}

// Arguments of the blossom: i times a, j times b, the rest c.
std::vector<double> arguments(const Corners& corners, int parameter, int n, int i, int j) {
  std::vector<double> result(static_cast<std::size_t>(n), corners[2][parameter]);
  std::fill_n(result.begin(), i, corners[0][parameter]);
  std::fill_n(result.begin() + i, j, corners[1][parameter]);
  return result;
}

// q_{nu mu} by the average over the tensor-product blossom.
Rational exact_point(NetForm form, const NetShape& shape, const LaneVector& net, int plane,
                     const Corners& corners, int nu, int mu) {
  const int n = shape.rows - 1, m = shape.columns - 1, lambda = n + m - nu - mu;
  Rational sum = 0;
  for (int i = 0; i <= std::min(nu, n); ++i)
    for (int j = 0; j <= std::min(mu, n - i); ++j) {
      const int k = n - i - j;
      if (k > lambda || nu - i > m || mu - j > m - (nu - i)) continue;
      sum += Rational(binomial(nu, i) * binomial(mu, j) * binomial(lambda, k)) *
             exact_blossom(form, shape, net, plane, arguments(corners, 0, n, i, j),
                           arguments(corners, 1, m, nu - i, mu - j));
    }
  return sum / Rational(binomial(n + m, n));
}

// The largest error of some points of a triangle. Of high degrees, points near the corner c, which
// are sums of few blossoms.
double largest_gap(NetForm form, const NetShape& shape, const LaneVector& net,
                   const LaneVector& found, std::size_t piece, int plane, const Corners& corners) {
  const int degree = shape.rows + shape.columns - 2;
  const int third = degree > 20 ? 1 : degree / 3;
  const int samples[][2] = {{0, 0}, {degree, 0}, {0, degree}, {third, third}};
  const std::size_t points = BezierTriangle::count(degree);
  double largest = 0;
  for (const auto& [nu, mu] : samples) {
    const Rational expected = exact_point(form, shape, net, plane, corners, nu, mu);
    const std::size_t place =
        static_cast<std::size_t>(plane) * points + BezierTriangle::index(degree, nu, mu);
    largest = std::max(largest, exact_gap(found[place * kLanes + piece], expected));
  }
  return largest;
}

LaneVector room_for(const TrianglePlan& plan, int planes, int triangles) {
  return LaneVector(static_cast<std::size_t>(planes * plan.points() * triangles));
}

const Corners kLowerHalf{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}};

TEST(BulkTriangles, TheLowerHalfOfTheSaddleIsKnownByHand) {
  // z = u v on the triangle (0, 0), (1, 0), (0, 1): only q_{011}, between b and c, is not 0.
  const TrianglePlan plan(1, 1);
  const LaneVector bezier{0, 0, 0, 1}, coefficients{0.25, 0.25, 0.25, 0.25};
  Lists lists;
  for (int k = 0; k < kLanes; ++k) lists.add(kLowerHalf);
  LaneVector expected = room_for(plan, 1, kLanes);
  std::fill_n(&expected[BezierTriangle::index(2, 0, 1) * kLanes], kLanes, 0.5);
  for (SimdLevel level : all_levels()) {
    LaneVector t4 = room_for(plan, 1, kLanes), t4_monomial = t4, t1 = t4;
    subdivide_triangles(NetForm::Bezier, plan, 1, bezier, lists.spans(), t4, level);
    subdivide_triangles(NetForm::Monomial, plan, 1, coefficients, lists.spans(), t4_monomial,
                        level);
    subdivide_triangles_by_differences(plan, 1, coefficients, lists.spans(), t1, level);
    EXPECT_EQ(t4, expected) << level_name(level);
    EXPECT_EQ(t4_monomial, expected) << level_name(level);
    EXPECT_EQ(t1, expected) << level_name(level);
  }
}

class BulkTrianglesProperty : public ::testing::TestWithParam<int> {
 protected:
  // Squares up to 9 first, then others, the highest degrees last.
  int n() const { return GetParam() < 9 ? 1 + GetParam() : kOther[GetParam() - 9][0]; }
  int m() const { return GetParam() < 9 ? 1 + GetParam() : kOther[GetParam() - 9][1]; }
  NetShape shape() const { return {n() + 1, m() + 1, GetParam() % 2 == 0 ? 3 : 4}; }

  static constexpr int kOther[][2] = {{1, 2},  {2, 1},  {3, 2},   {2, 5},   {0, 4},
                                      {11, 4}, {3, 13}, {12, 12}, {25, 10}, {25, 25}};
};

TEST_P(BulkTrianglesProperty, AreTheExactOnesWithinTheStatedErrors) {
  auto random = seeded(GetParam());
  const TrianglePlan plan(n(), m());
  const Lists lists = random_lists(random);
  double slack_t4 = 0, slack_t4_monomial = 0, slack_t1 = 0;
  for (SimdLevel level : all_levels()) {
    const LaneVector net = random_net(random, shape());
    LaneVector t4 = room_for(plan, shape().planes, kLanes), t4_monomial = t4, t1 = t4;
    subdivide_triangles(NetForm::Bezier, plan, shape().planes, net, lists.spans(), t4, level);
    subdivide_triangles(NetForm::Monomial, plan, shape().planes, net, lists.spans(), t4_monomial,
                        level);
    subdivide_triangles_by_differences(plan, shape().planes, net, lists.spans(), t1, level);

    const std::size_t piece = static_cast<std::size_t>(pick(random, 0, kLanes - 1));
    const int plane = pick(random, 0, shape().planes - 1);
    const Corners corners = lists[piece];
    const double sum = sum_of_plane(shape(), net, plane);
    const auto check = [&](NetForm form, const LaneVector& found, double bound, double& slack) {
      const double gap = largest_gap(form, shape(), net, found, piece, plane, corners);
      EXPECT_LE(gap, bound) << level_name(level);
      slack = std::max(slack, gap / bound);
    };
    check(NetForm::Bezier, t4, bulk_t4_error(n(), m()), slack_t4);
    check(NetForm::Monomial, t4_monomial, bulk_t4_monomial_error(n(), m()) * sum,
          slack_t4_monomial);
    check(NetForm::Monomial, t1, bulk_t1_error(n(), m()) * sum * t1_growth(n(), m(), corners),
          slack_t1);
  }
  RecordProperty("t4_error_over_bound", std::to_string(slack_t4));
  RecordProperty("t4_monomial_error_over_bound", std::to_string(slack_t4_monomial));
  RecordProperty("t1_error_over_bound", std::to_string(slack_t1));
}

TEST_P(BulkTrianglesProperty, FusedLevelsGiveTheSameBits) {
  if (!is_available(SimdLevel::Avx512)) GTEST_SKIP() << "no AVX-512 here";
  auto random = seeded(GetParam());
  const TrianglePlan plan(n(), m());
  const Lists lists = random_lists(random);
  const LaneVector net = random_net(random, shape());
  LaneVector narrow = room_for(plan, shape().planes, kLanes), wide = narrow;
  for (NetForm form : {NetForm::Bezier, NetForm::Monomial}) {
    subdivide_triangles(form, plan, shape().planes, net, lists.spans(), narrow, SimdLevel::Avx2);
    subdivide_triangles(form, plan, shape().planes, net, lists.spans(), wide, SimdLevel::Avx512);
    EXPECT_EQ(narrow, wide);
  }
  subdivide_triangles_by_differences(plan, shape().planes, net, lists.spans(), narrow,
                                     SimdLevel::Avx2);
  subdivide_triangles_by_differences(plan, shape().planes, net, lists.spans(), wide,
                                     SimdLevel::Avx512);
  EXPECT_EQ(narrow, wide);
}

TEST_P(BulkTrianglesProperty, TheChosenPathKeepsTheToleranceWhereAnyDoes) {
  if (n() + m() > 30) GTEST_SKIP() << "the errors of the net alone are above the tolerance";
  auto random = seeded(GetParam());
  const TrianglePlan plan(n(), m());
  const Lists lists = random_lists(random);
  const int planes = shape().planes;
  const LaneVector net = random_net(random, shape());
  LaneVector coefficients(net.size());
  monomial_from_bezier(shape(), net.data(), coefficients.data());
  const NetSizes sizes = net_sizes(shape(), net, coefficients);
  LaneVector t4 = room_for(plan, planes, kLanes), t1 = t4;
  subdivide_triangles(NetForm::Bezier, plan, planes, net, lists.spans(), t4);
  subdivide_triangles_by_differences(plan, planes, coefficients, lists.spans(), t1);
  for (std::size_t piece = 0; piece < kLanes; piece += 3) {
    const double tolerance = 1e-10;
    const TrianglePath path = triangle_path(n(), m(), sizes, lists[piece], tolerance);
    const LaneVector& out = path == TrianglePath::BezierT4 ? t4 : t1;
    const auto gap_of = [&](const LaneVector& found) {
      return largest_gap(NetForm::Bezier, shape(), net, found, piece, 0, lists[piece]);
    };
    EXPECT_LE(gap_of(out), tolerance);
    EXPECT_LE(gap_of(t1), triangle_error(TrianglePath::MonomialT1, n(), m(), sizes, lists[piece]));
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, BulkTrianglesProperty, ::testing::Range(0, 19));

TEST(BulkTriangles, ChooseDifferencesForSmallTrianglesAndT4ForHighDegrees) {
  const NetSizes unit{1, 1, 1e-15};
  const Corners small{Vec2{0.6, 0.6}, Vec2{0.61, 0.6}, Vec2{0.6, 0.61}};
  EXPECT_EQ(triangle_path(3, 3, unit, small, 1e-12), TrianglePath::MonomialT1);
  EXPECT_EQ(triangle_path(3, 3, unit, small, 1e-15), TrianglePath::BezierT4);
  EXPECT_EQ(triangle_path(12, 12, unit, kLowerHalf, 1e-7), TrianglePath::BezierT4);
}

TEST(BulkTriangles, RefuseWhatDoesNotFit) {
  const TrianglePlan plan(1, 1);
  const LaneVector net(4), lane(kLanes, 0.5);
  LaneVector out = room_for(plan, 1, kLanes), bad = lane;
  bad[2] = std::numeric_limits<double>::infinity();
  const TriangleLists fine{lane, lane, lane, lane, lane, lane};
  EXPECT_THROW(TrianglePlan(26, 1), InvalidInput);
  EXPECT_THROW(TrianglePlan(1, -1), InvalidInput);
  EXPECT_THROW(subdivide_triangles(NetForm::Bezier, plan, 2, net, fine, out), InvalidInput);
  EXPECT_THROW(subdivide_triangles(NetForm::Bezier, plan, 1, net, fine, bad), InvalidInput);
  try {
    subdivide_triangles_by_differences(plan, 1, net, {lane, lane, bad, lane, lane, lane}, out);
    FAIL() << "accepted an infinite corner";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "subdivide_triangles_by_differences: b_u must be finite, number 3 is not");
  }
}

}  // namespace
}  // namespace blossom
