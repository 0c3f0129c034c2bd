// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/degree.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/base/errors.h"
#include "core/forms/algebra/detail/products.h"
#include "tests/core/forms/exact_forms.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::exact;
using testing::exact_gap;
using testing::exact_point;
using testing::pick;
using testing::random_curve;
using testing::random_patch;
using testing::random_triangle;
using testing::Rational;
using testing::reference_point;
using testing::seeded;

TEST(Degree, OfALineIsRaisedByHand) {
  const BezierCurve line{{{0, 0, 0}, {3, 6, 0}}};

  EXPECT_EQ(elevated(line, 3).points,
            (std::vector<Vec3>{{0, 0, 0}, {1, 2, 0}, {2, 4, 0}, {3, 6, 0}}));
  EXPECT_EQ(elevated(line, 1), line);
}

TEST(Degree, OfATriangleIsRaisedByHand) {
  const BezierTriangle plane{1, {{0, 0, 0}, {0, 2, 0}, {2, 0, 0}}};

  EXPECT_EQ(elevated(plane, 2).points,
            (std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}}));
}

TEST(Degree, OfAParabolaReducedGivesTheChordAndItsDistance) {
  const ReducedOf<BezierCurve> chord = reduced(BezierCurve{{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}}}, 1);

  EXPECT_EQ(chord.form.points, (std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}}));
  EXPECT_GE(chord.error, 1);  // of the control point; the curve's own is 1/2
  EXPECT_LE(chord.error, 1 + 1e-14);
}

class DegreeProperty : public ::testing::TestWithParam<int> {};

TEST_P(DegreeProperty, RaisedOverRationalsLeavesTheFormAsItIs) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 4), m = pick(random, 0, 4), more = pick(random, 0, 3);
  const auto net = exact(random_patch(random, n, m).points);
  const auto triangle = exact(random_triangle(random, n));

  const auto higher = detail::elevated_net(net, more, 2);
  const auto higher_triangle = detail::elevated_once(triangle);

  for (int k = 0; k <= 8; ++k)
    for (int l = 0; l <= 8; ++l) {
      const Rational u(k, 3), v(l, 5);
      EXPECT_EQ(exact_point(higher, u, v), exact_point(net, u, v));
      EXPECT_EQ(exact_point(higher_triangle, u, v), exact_point(triangle, u, v));
    }
}

TEST_P(DegreeProperty, RaisedIsWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 25), degree = pick(random, n, 60);
  const BezierCurve curve = random_curve(random, n);
  const BezierTriangle triangle = random_triangle(random, 3);

  const BezierCurve higher = elevated(curve, degree);
  const auto expected = detail::elevated_net(detail::one_row(exact(curve.points)), 0, degree - n);
  const BezierTriangle higher_triangle = elevated(triangle, 5);
  const auto expected_triangle = detail::elevated_once(detail::elevated_once(exact(triangle)));

  for (int k = 0; k <= degree; ++k)
    EXPECT_LE(exact_gap(higher.points[static_cast<std::size_t>(k)], expected(0, k)),
              elevation_error(degree));
  for (std::size_t k = 0; k < expected_triangle.points.size(); ++k)
    EXPECT_LE(exact_gap(higher_triangle.points[k], expected_triangle.points[k]),
              triangle_elevation_error(3, 5));
}

TEST_P(DegreeProperty, ReducedGivesBackWhatWasRaised) {
  auto random = seeded(GetParam());
  const int n = pick(random, 1, 9), degree = pick(random, n, 14);
  const BezierCurve curve = random_curve(random, n);

  const ReducedOf<BezierCurve> back = reduced(elevated(curve, degree), n);

  for (int k = 0; k <= n; ++k) {
    const auto at = static_cast<std::size_t>(k);
    EXPECT_LE(max_norm(back.form.points[at] - curve.points[at]), 1e-9);
  }
  EXPECT_LE(back.error, 1e-13);
}

TEST_P(DegreeProperty, ReducedStaysWithinItsError) {
  auto random = seeded(GetParam());
  const int n = pick(random, 1, 12), degree = pick(random, 0, n);
  const BezierCurve curve = random_curve(random, n);
  const BezierPatch patch = random_patch(random, n, 4);

  const ReducedOf<BezierCurve> lower = reduced(curve, degree);
  const ReducedOf<BezierPatch> lower_patch = reduced(patch, degree, 3);

  for (int k = 0; k <= 20; ++k) {
    const double t = k / 20.0;
    EXPECT_LE(distance(reference_point(lower.form, t), reference_point(curve, t)), lower.error);
    EXPECT_LE(
        distance(reference_point(lower_patch.form, t, 1 - t), reference_point(patch, t, 1 - t)),
        lower_patch.error);
  }
  if (degree > 0) {
    EXPECT_EQ(lower.form.points.front(), curve.points.front());
    EXPECT_EQ(lower.form.points.back(), curve.points.back());
  }
}

TEST_P(DegreeProperty, ReducedHasAnErrorThatHoldsExactly) {
  auto random = seeded(GetParam());
  const int n = pick(random, 1, 20), degree = pick(random, 0, n);
  const BezierCurve curve = random_curve(random, n);
  // Hardly more than rounding is left of the distance where the curve was raised before.
  const BezierCurve given = GetParam() % 2 == 0 ? curve : elevated(curve, n + 3);

  const ReducedOf<BezierCurve> lower = reduced(given, degree);

  const auto raised =
      detail::elevated_net(detail::one_row(exact(lower.form.points)), 0, given.degree() - degree);
  for (int k = 0; k <= given.degree(); ++k) {
    const auto gap = exact(given.points[static_cast<std::size_t>(k)]) - raised(0, k);
    EXPECT_LE(dot(gap, gap), Rational(lower.error) * Rational(lower.error));
  }
}

// Of the points of a form raised to degree 6 from those of one of that degree.
template <class Form>
double squared_distance(const Form& lower, const Form& form) {
  double sum = 0;
  const Form higher = elevated(lower, 6);
  for (std::size_t k = 0; k < higher.points.size(); ++k) {
    const Vec3 gap = higher.points[k] - form.points[k];
    sum += dot(gap, gap);
  }
  return sum;
}

TEST_P(DegreeProperty, ReducedIsNearestAmongItsNeighbours) {
  auto random = seeded(GetParam());
  const BezierCurve curve = random_curve(random, 6);
  const BezierCurve lower = reduced(curve, 4).form;

  for (std::size_t k = 1; k < 4; ++k)
    for (double step : {-1e-3, 1e-3}) {
      BezierCurve neighbour = lower;
      neighbour.points[k][GetParam() % 3] += step;
      EXPECT_GT(squared_distance(neighbour, curve), squared_distance(lower, curve));
    }
}

// The points of side mu = 0, from c to a.
std::vector<Vec3> side(const BezierTriangle& triangle) {
  std::vector<Vec3> points;
  for (int nu = 0; nu <= triangle.degree; ++nu) points.push_back(triangle(nu, 0));
  return points;
}

TEST_P(DegreeProperty, OfATriangleReducedGivesBackWhatWasRaised) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 6);
  const BezierTriangle triangle = random_triangle(random, n);

  const auto back = reduced(elevated(triangle, n + pick(random, 0, 4)), n);

  ASSERT_EQ(back.form.degree, n);
  for (std::size_t k = 0; k < triangle.points.size(); ++k)
    EXPECT_LE(max_norm(back.form.points[k] - triangle.points[k]), 1e-10);
  EXPECT_LE(back.error, 1e-13);
}

TEST_P(DegreeProperty, OfATriangleReducedHasTheSidesReducedAndItsErrorHoldsExactly) {
  auto random = seeded(GetParam());
  const int n = pick(random, 1, 9), degree = pick(random, 1, n);
  const BezierTriangle triangle = random_triangle(random, n);

  const auto lower = reduced(triangle, degree);

  const std::vector<Vec3> of_side = reduced(BezierCurve{side(triangle)}, degree).form.points;
  for (std::size_t k = 0; k < of_side.size(); ++k)
    EXPECT_LE(max_norm(side(lower.form)[k] - of_side[k]), 1e-12);
  EXPECT_EQ(lower.form(0, degree), triangle(0, n));
  auto raised = exact(lower.form);
  while (raised.degree < n) raised = detail::elevated_once(raised);
  for (std::size_t k = 0; k < raised.points.size(); ++k) {
    const auto gap = exact(triangle.points[k]) - raised.points[k];
    EXPECT_LE(dot(gap, gap), Rational(lower.error) * Rational(lower.error));
  }
}

TEST_P(DegreeProperty, OfATriangleReducedIsNearestAmongItsNeighbours) {
  auto random = seeded(GetParam());
  const BezierTriangle triangle = random_triangle(random, 6);
  const BezierTriangle lower = reduced(triangle, 4).form;

  for (const auto& [nu, mu] : {std::pair{1, 1}, {1, 2}, {2, 1}})
    for (double step : {-1e-3, 1e-3}) {
      BezierTriangle neighbour = lower;
      neighbour(nu, mu)[GetParam() % 3] += step;
      EXPECT_GT(squared_distance(neighbour, triangle), squared_distance(lower, triangle));
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, DegreeProperty, ::testing::Range(0, 30));

TEST(Degree, OfATriangleReducedToAConstantIsTheMeanOfThePoints) {
  const auto middle = reduced(BezierTriangle{1, {{0, 0, 0}, {3, 0, 0}, {0, 3, 3}}}, 0);

  EXPECT_LE(max_norm(middle.form.points[0] - Vec3{1, 1, 1}), 1e-15);
  EXPECT_GE(middle.error * middle.error, 9 - 1e-12);  // to (0, 3, 3)
  EXPECT_LE(middle.error, 3 + 1e-12);
}

TEST(Degree, OfManyTrianglesIsReducedAsThatOfEach) {
  auto random = seeded(1);
  const TriangleReduction reduction(7, 4);
  for (int i = 0; i < 3; ++i) {
    const BezierTriangle triangle = random_triangle(random, 7);
    EXPECT_EQ(reduction(triangle).form, reduced(triangle, 4).form);
    EXPECT_EQ(reduction(triangle).error, reduced(triangle, 4).error);
  }
  EXPECT_THROW(reduction(random_triangle(random, 6)), InvalidInput);
  EXPECT_THROW(TriangleReduction(4, 5), InvalidInput);
  EXPECT_THROW(TriangleReduction(61, 5), InvalidInput);
}

TEST(Degree, OfTheHighestTrianglesIsReduced) {
  auto random = seeded(1);
  const BezierTriangle triangle = random_triangle(random, 24);

  EXPECT_LE(reduced(elevated(triangle, 25), 24).error, 1e-11);
}

TEST(Degree, RefusesTheWrongDirection) {
  const BezierCurve line{{{0, 0, 0}, {1, 0, 0}}};
  EXPECT_THROW(elevated(line, 0), InvalidInput);
  EXPECT_THROW(elevated(line, 61), InvalidInput);
  EXPECT_THROW(reduced(line, 2), InvalidInput);
  EXPECT_THROW(reduced(line, -1), InvalidInput);
  EXPECT_THROW(elevated(BezierCurve{}, 3), InvalidInput);
  EXPECT_THROW(elevated(BezierTriangle{2, std::vector<Vec3>(5)}, 3), InvalidInput);
  EXPECT_THROW(reduced(BezierTriangle{2, std::vector<Vec3>(5)}, 1), InvalidInput);
  EXPECT_THROW(reduced(BezierTriangle{2, std::vector<Vec3>(6)}, 3), InvalidInput);
  EXPECT_THROW(reduced(BezierTriangle{61, std::vector<Vec3>(1953)}, 3), InvalidInput);
}

}  // namespace
}  // namespace blossom
