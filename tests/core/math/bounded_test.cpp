// SPDX-License-Identifier: LGPL-2.1-or-later
// Interval arithmetic against exact rationals, alone and through the formulas of the core.

#include "core/math/bounded.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/blossom/detail/closed_form.h"
#include "core/blossom/detail/composition.h"
#include "core/blossom/detail/normal_net.h"
#include "core/blossom/detail/triangle_conversion.h"
#include "core/forms/algebra/detail/conversion.h"
#include "core/forms/algebra/detail/sign.h"
#include "core/subdivision/detail/triangle.h"
#include "tests/support/exact.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::exact;
using testing::pick;
using testing::random_curve;
using testing::random_patch;
using testing::Rational;
using testing::seeded;
using testing::uniform;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kMin = std::numeric_limits<double>::denorm_min();

bool contains(const Bounded& range, const Rational& x) {
  return (std::isinf(range.lower()) || Rational(range.lower()) <= x) &&
         (std::isinf(range.upper()) || x <= Rational(range.upper()));
}

// The nearest doubles outwards: the bounds are as close as they can be.
bool is_tight(const Bounded& range, const Rational& x) {
  return contains(range, x) && std::nextafter(range.lower(), kInfinity) >= range.upper();
}

TEST(Bounded, OfNumbersThatDoublesHoldHasNoWidth) {
  EXPECT_EQ(Bounded(1) + Bounded(2), Bounded(3));
  EXPECT_EQ(Bounded(1) - Bounded(2), Bounded(-1));
  EXPECT_EQ(Bounded(3) * Bounded(0.5), Bounded(1.5));
  EXPECT_EQ(Bounded(3) / Bounded(2), Bounded(1.5));
  EXPECT_EQ(Bounded(), Bounded(0));
}

TEST(Bounded, OfRangesIsKnownByHand) {
  EXPECT_EQ(Bounded(-1, 2) + Bounded(3, 5), Bounded(2, 7));
  EXPECT_EQ(Bounded(-1, 2) - Bounded(3, 5), Bounded(-6, -1));
  EXPECT_EQ(Bounded(-1, 2) * Bounded(3, 5), Bounded(-5, 10));
  EXPECT_EQ(Bounded(-1, 2) * Bounded(-3, 5), Bounded(-6, 10));
  EXPECT_EQ(Bounded(1, 2) / Bounded(-4, -2), Bounded(-1, -0.25));
  EXPECT_EQ(-Bounded(1, 2), Bounded(-2, -1));
  EXPECT_EQ(Bounded(1, 2) / Bounded(0, 1), Bounded(-kInfinity, kInfinity));
  EXPECT_TRUE(Bounded(1, 2).is_positive());
  EXPECT_FALSE(Bounded(0, 2).is_positive());
  EXPECT_TRUE(Bounded(-1, -0.5).is_negative());
}

TEST(Bounded, HoldsWhatOverflowsOrUnderflows) {
  EXPECT_EQ(Bounded(kLargest) + Bounded(kLargest), Bounded(kLargest, kInfinity));
  EXPECT_EQ(Bounded(kLargest) * Bounded(-2), Bounded(-kInfinity, -kLargest));
  EXPECT_EQ(Bounded(kLargest) / Bounded(kMin), Bounded(kLargest, kInfinity));
  EXPECT_EQ(Bounded(0) * Bounded(-kInfinity, kInfinity), Bounded(0));
  const Bounded tiny = Bounded(kMin) * Bounded(kMin);
  EXPECT_TRUE(tiny.lower() <= 0 && tiny.upper() > 0);
  const Bounded half = Bounded(kMin) / Bounded(2);
  EXPECT_TRUE(half.lower() <= 0 && half.upper() > 0);
}

TEST(Bounded, RefusesEndsInTheWrongOrder) {
  EXPECT_THROW(Bounded(2, 1), InvalidInput);
  EXPECT_THROW(Bounded(std::numeric_limits<double>::quiet_NaN()), InvalidInput);
}

class BoundedProperty : public ::testing::TestWithParam<int> {};

TEST_P(BoundedProperty, HoldsExactResultsAndIsTight) {
  auto random = seeded(GetParam());
  for (int k = 0; k < 200; ++k) {
    const double a = std::ldexp(uniform(random, -1, 1), pick(random, -60, 60));
    const double b = std::ldexp(uniform(random, -1, 1), pick(random, -60, 60));
    const Rational x(a), y(b);
    EXPECT_TRUE(is_tight(Bounded(a) + Bounded(b), x + y)) << a << " " << b;
    EXPECT_TRUE(is_tight(Bounded(a) - Bounded(b), x - y)) << a << " " << b;
    EXPECT_TRUE(is_tight(Bounded(a) * Bounded(b), x * y)) << a << " " << b;
    EXPECT_TRUE(is_tight(Bounded(a) / Bounded(b), x / y)) << a << " " << b;
  }
}

TEST_P(BoundedProperty, HoldsResultsOfAllNumbersInItsRanges) {
  auto random = seeded(GetParam());
  for (int k = 0; k < 100; ++k) {
    double ends[4];
    for (double& end : ends) end = uniform(random, -1, 1);
    const Bounded a(std::min(ends[0], ends[1]), std::max(ends[0], ends[1]));
    const Bounded b(std::min(ends[2], ends[3]), std::max(ends[2], ends[3]));
    const Rational s(pick(random, 0, 8), 8), t(pick(random, 0, 8), 8);
    const Rational x = Rational(a.lower()) * s + Rational(a.upper()) * (1 - s);
    const Rational y = Rational(b.lower()) * t + Rational(b.upper()) * (1 - t);
    EXPECT_TRUE(contains(a + b, x + y));
    EXPECT_TRUE(contains(a - b, x - y));
    EXPECT_TRUE(contains(a * b, x * y));
    if (y != 0) {
      EXPECT_TRUE(contains(a / b, x / y));
    }
  }
}

// The same formula in both scalars.

template <int Dim>
Vec<Bounded, Dim> bounded(const Vec<double, Dim>& point) {
  Vec<Bounded, Dim> result;
  for (int i = 0; i < Dim; ++i) result[i] = Bounded(point[i]);
  return result;
}

template <int Dim>
std::vector<Vec<Bounded, Dim>> bounded(const std::vector<Vec<double, Dim>>& points) {
  std::vector<Vec<Bounded, Dim>> result;
  for (const auto& point : points) result.push_back(bounded(point));
  return result;
}

template <int Dim>
Grid<Vec<Bounded, Dim>> bounded(const Grid<Vec<double, Dim>>& net) {
  Grid<Vec<Bounded, Dim>> result(net.rows(), net.columns());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) result(i, j) = bounded(net(i, j));
  return result;
}

template <int Dim>
void expect_holds(std::span<const Vec<Bounded, Dim>> ranges,
                  std::span<const Vec<Rational, Dim>> values, double width) {
  ASSERT_EQ(ranges.size(), values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    for (int i = 0; i < Dim; ++i) {
      EXPECT_TRUE(contains(ranges[k][i], values[k][i])) << k;
      EXPECT_LE(ranges[k][i].upper() - ranges[k][i].lower(), width) << k;
    }
}

template <int Dim>
void expect_holds(const Grid<Vec<Bounded, Dim>>& ranges, const Grid<Vec<Rational, Dim>>& values,
                  double width) {
  expect_holds<Dim>(ranges.values(), values.values(), width);
}

// Well above the widths seen, well below anything that would be useless.
constexpr double kNarrow = 1e-12;

TEST_P(BoundedProperty, HoldsPointsOfTheoremsOneAndTwo) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 6), m = pick(random, 0, 5);
  const double ends[] = {uniform(random, -1, 1), uniform(random, -1, 1)};
  const IntervalOf<Bounded> u{Bounded(ends[0]), Bounded(ends[1])};
  const IntervalOf<Rational> exact_u{Rational(ends[0]), Rational(ends[1])};
  const Grid<Vec3> c = random_patch(random, n, m).points;

  expect_holds(
      detail::bezier_net(MonomialPatchOf<Vec<Bounded, 3>>{bounded(c), 0.5, 0, 0.5, 1}, u, u),
      detail::bezier_net(MonomialPatchOf<Vec<Rational, 3>>{exact(c), 0.5, 0, 0.5, 1}, exact_u,
                         exact_u),
      1e4 * kNarrow);
  expect_holds(product(detail::subdivision_matrix(n, u), bounded(c)),
               product(detail::subdivision_matrix(n, exact_u), exact(c)), 1e2 * kNarrow);
  expect_holds(detail::monomial_net(bounded(c), Origin::Middle),
               detail::monomial_net(exact(c), Origin::Middle), kNarrow);
}

TEST_P(BoundedProperty, HoldsPointsOfTheoremThree) {
  auto random = seeded(GetParam());
  const Grid<Vec3> c = random_patch(random, pick(random, 0, 3), pick(random, 0, 2)).points;
  const int degree = c.rows() + c.columns() - 2;
  std::array<Vec2, 3> corners;
  for (Vec2& corner : corners) corner = {uniform(random, 0, 1), uniform(random, 0, 1)};
  const std::array ours{bounded(corners[0]), bounded(corners[1]), bounded(corners[2])};
  const std::array theirs{exact(corners[0]), exact(corners[1]), exact(corners[2])};

  expect_holds<3>(detail::triangle_points(bounded(c), ours, degree),
                  detail::triangle_points(exact(c), theirs, degree), kNarrow);
  expect_holds<3>(detail::triangle_from_net(bounded(c), ours),
                  detail::triangle_from_net(exact(c), theirs), kNarrow);
}

TEST_P(BoundedProperty, HoldsCompositionsNormalsAndConversions) {
  auto random = seeded(GetParam());
  const RationalBezierPatch patch =
      random_patch<Vec4>(random, pick(random, 1, 3), pick(random, 1, 3));
  const BezierCurve2 curve = random_curve<Vec2>(random, pick(random, 0, 4));
  const BezierTriangle triangle = testing::random_triangle(random, pick(random, 0, 4));
  const BezierTriangleOf<Vec<Bounded, 3>> our_triangle{triangle.degree, bounded(triangle.points)};
  const BezierTriangleOf<Vec<Rational, 3>> exact_triangle{triangle.degree, exact(triangle.points)};

  expect_holds<4>(
      detail::composition(bounded(patch.points), detail::parameter_forms(bounded(curve.points))),
      detail::composition(exact(patch.points), detail::parameter_forms(exact(curve.points))),
      1e3 * kNarrow);
  expect_holds(detail::normal_net(bounded(patch.points)), detail::normal_net(exact(patch.points)),
               1e2 * kNarrow);
  expect_holds(detail::rational_derivative(bounded(patch.points), 1, 1),
               detail::rational_derivative(exact(patch.points), 1, 1), 1e3 * kNarrow);
  expect_holds(detail::collapsed_net(our_triangle), detail::collapsed_net(exact_triangle), kNarrow);
}

TEST_P(BoundedProperty, HoldsValues) {
  auto random = seeded(GetParam());
  std::vector<Bounded> ours;
  std::vector<Rational> theirs;
  for (int k = 0; k < 8; ++k) {
    const double c = uniform(random, -1, 1);
    ours.push_back(Bounded(c));
    theirs.push_back(Rational(c));
  }
  const double t = uniform(random, -1, 2);

  EXPECT_TRUE(contains(detail::homogeneous_value(ours, Bounded(t), Bounded(1)),
                       detail::homogeneous_value(theirs, Rational(t), Rational(1))));
}

INSTANTIATE_TEST_SUITE_P(Seeds, BoundedProperty, ::testing::Range(0, 20));

}  // namespace
}  // namespace blossom
