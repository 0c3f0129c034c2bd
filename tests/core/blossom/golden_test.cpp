// SPDX-License-Identifier: LGPL-2.1-or-later
// The closed forms against exact reference values: 33 curves, 25 patches and 26 triangles, with
// reversed, degenerate and extrapolating pieces. In rationals every number must be equal; in
// doubles it must be within the stated bound of the header.

#include <gtest/gtest.h>

#include "core/blossom/curve_blossom.h"
#include "core/blossom/detail/closed_form.h"
#include "core/blossom/patch_blossom.h"
#include "core/blossom/triangle_blossom.h"
#include "core/subdivision/detail/triangle.h"
#include "tests/support/golden.h"

namespace blossom {
namespace {

using testing::corners;
using testing::exact_gap;
using testing::ExactPoint;
using testing::Json;
using testing::number;
using testing::Rational;
using testing::read_golden;
using testing::rounded;

const Json& golden() {
  static const Json data = read_golden("blossom_golden.json");
  return data;
}

// What rounding the data to double may change, relative to the same scale: each term has one
// coefficient and at most `degree` parameters.
double input_error(const Json& test, int degree) {
  return test.at("inputs_exact_in_double").get<bool>() ? 0 : (degree + 2) * 0x1p-53;
}

std::string name(const Json& test) {
  return test.at("label").get<std::string>() + ", degree " +
         std::to_string(test.at("n").get<int>());
}

IntervalOf<Rational> interval(const Json& test, const char* from, const char* to) {
  return {number(test.at(from)), number(test.at(to))};
}

Interval rounded_interval(const Json& test, const char* from, const char* to) {
  return {rounded(number(test.at(from))), rounded(number(test.at(to)))};
}

class GoldenCurve : public ::testing::TestWithParam<int> {
 protected:
  const Json& test() const { return golden().at("curve").at(static_cast<std::size_t>(GetParam())); }
};

TEST_P(GoldenCurve, IsExactInRationals) {
  SCOPED_TRACE(name(test()));
  const MonomialCurveOf<ExactPoint> curve{testing::points(test().at("coefficients"))};
  const std::vector<ExactPoint> whole = testing::points(test().at("bernstein01"));
  const std::vector<ExactPoint> expected = testing::points(test().at("control_points"));
  const auto piece = interval(test(), "a", "b");

  EXPECT_EQ(detail::bezier_line(curve, piece), expected);
  EXPECT_EQ(detail::bezier_line(curve, {Rational(0), Rational(1)}), whole);
  EXPECT_EQ(product(detail::subdivision_matrix(curve.degree(), piece), whole), expected);
  EXPECT_EQ(detail::monomial_line(whole, Origin::Start), curve.coefficients);
}

TEST_P(GoldenCurve, IsWithinTheStatedErrorInDouble) {
  SCOPED_TRACE(name(test()));
  const MonomialCurve curve{rounded(testing::points(test().at("coefficients")))};
  const std::vector<ExactPoint> expected = testing::points(test().at("control_points"));
  const int n = curve.degree();
  const double scale = test().at("scale").get<double>();

  const BezierCurve piece = bezier_points(curve, rounded_interval(test(), "a", "b"));

  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_LE(exact_gap(piece.points[k], expected[k]),
              (blossom_error(n) + input_error(test(), n)) * scale);
  EXPECT_NEAR(blossom_scale(curve, rounded_interval(test(), "a", "b")), scale,
              (blossom_error(n) + input_error(test(), n)) * scale);
}

TEST_P(GoldenCurve, HasTheGivenBlossom) {
  SCOPED_TRACE(name(test()));
  const std::vector<ExactPoint> coefficients = testing::points(test().at("coefficients"));
  const std::vector<Rational> arguments = testing::numbers(test().at("blossom").at("arguments"));
  const ExactPoint expected = testing::point(test().at("blossom").at("value"));

  const auto weights = detail::monomial_blossoms(std::span<const Rational>(arguments));
  ExactPoint value{};
  for (std::size_t i = 0; i < weights.size(); ++i) value += coefficients[i] * weights[i];

  EXPECT_EQ(value, expected);
}

INSTANTIATE_TEST_SUITE_P(Cases, GoldenCurve, ::testing::Range(0, 33));

class GoldenPatch : public ::testing::TestWithParam<int> {
 protected:
  const Json& test() const {
    return golden().at("tensor").at(static_cast<std::size_t>(GetParam()));
  }
};

TEST_P(GoldenPatch, IsExactInRationals) {
  SCOPED_TRACE(name(test()));
  const MonomialPatchOf<ExactPoint> patch{testing::net(test().at("coefficients"))};
  const Grid<ExactPoint> whole = testing::net(test().at("bernstein01"));
  const Grid<ExactPoint> expected = testing::net(test().at("control_points"));
  const auto u = interval(test(), "a", "b"), v = interval(test(), "c", "d");

  EXPECT_EQ(detail::bezier_net(patch, u, v), expected);
  EXPECT_EQ(detail::monomial_net(whole, Origin::Start), patch.coefficients);
  const auto along_u = detail::subdivision_matrix(patch.degree_u(), u);
  const auto along_v = detail::subdivision_matrix(patch.degree_v(), v);
  EXPECT_EQ(product_transposed(product(along_u, whole), along_v), expected);
}

TEST_P(GoldenPatch, IsWithinTheStatedErrorInDouble) {
  SCOPED_TRACE(name(test()));
  const MonomialPatch patch{rounded(testing::net(test().at("coefficients")))};
  const Grid<ExactPoint> expected = testing::net(test().at("control_points"));
  const int total = patch.degree_u() + patch.degree_v();
  const double bound =
      (blossom_error(total) + input_error(test(), total)) * test().at("scale").get<double>();

  const BezierPatch piece =
      bezier_points(patch, rounded_interval(test(), "a", "b"), rounded_interval(test(), "c", "d"));

  for (int i = 0; i < expected.rows(); ++i)
    for (int j = 0; j < expected.columns(); ++j)
      EXPECT_LE(exact_gap(piece.points(i, j), expected(i, j)), bound);
}

INSTANTIATE_TEST_SUITE_P(Cases, GoldenPatch, ::testing::Range(0, 25));

// The points of a triangle, row after row.
std::vector<ExactPoint> control_points(const Json& test) {
  std::vector<ExactPoint> list;
  for (const Json& row : test.at("control_points"))
    for (const Json& value : row) list.push_back(testing::point(value));
  return list;
}

class GoldenTriangle : public ::testing::TestWithParam<int> {
 protected:
  const Json& test() const {
    return golden().at("triangle").at(static_cast<std::size_t>(GetParam()));
  }
  int degree() const { return test().at("N").get<int>(); }
  std::vector<ExactPoint> expected() const { return control_points(test()); }
};

TEST_P(GoldenTriangle, IsExactInRationals) {
  SCOPED_TRACE(name(test()));
  const Grid<ExactPoint> coefficients = testing::net(test().at("coefficients"));

  EXPECT_EQ(detail::triangle_points(coefficients, corners(test()), degree()), expected());
}

TEST_P(GoldenTriangle, IsWithinTheStatedErrorInDouble) {
  SCOPED_TRACE(name(test()));
  const MonomialPatch patch{rounded(testing::net(test().at("coefficients")))};
  const double bound = (triangle_blossom_error(degree(), patch.degree_u(), patch.degree_v()) +
                        input_error(test(), degree())) *
                       test().at("scale").get<double>();

  const BezierTriangle piece = bezier_points(patch, rounded(corners(test())), degree());

  const std::vector<ExactPoint> wanted = expected();
  ASSERT_EQ(piece.points.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k)
    EXPECT_LE(exact_gap(piece.points[k], wanted[k]), bound);
}

INSTANTIATE_TEST_SUITE_P(Cases, GoldenTriangle, ::testing::Range(0, 26));

TEST(GoldenTriangles, ComeOutOfTheTensorProductNetToo) {
  int compared = 0;
  for (const Json& test : golden().at("triangle")) {
    SCOPED_TRACE(name(test));
    const MonomialPatchOf<ExactPoint> patch{testing::net(test.at("coefficients"))};
    if (test.at("N").get<int>() != patch.degree_u() + patch.degree_v()) continue;
    const IntervalOf<Rational> unit{Rational(0), Rational(1)};
    EXPECT_EQ(detail::triangle_from_net(detail::bezier_net(patch, unit, unit), corners(test)),
              control_points(test));
    ++compared;
  }
  EXPECT_EQ(compared, 24);
}

TEST(GoldenPatches, HaveTheGivenBlossoms) {
  int compared = 0;
  for (const Json& test : golden().at("tensor")) {
    if (!test.contains("blossom")) continue;
    SCOPED_TRACE(name(test));
    const Grid<ExactPoint> coefficients = testing::net(test.at("coefficients"));
    const auto u = testing::numbers(test.at("blossom").at("u_arguments"));
    const auto v = testing::numbers(test.at("blossom").at("v_arguments"));
    const auto along_u = detail::monomial_blossoms(std::span<const Rational>(u));
    const auto along_v = detail::monomial_blossoms(std::span<const Rational>(v));
    ExactPoint value{};
    for (int i = 0; i < coefficients.rows(); ++i)
      for (int j = 0; j < coefficients.columns(); ++j) {
        const Rational weight = along_u[detail::index(i)] * along_v[detail::index(j)];
        value += coefficients(i, j) * weight;
      }
    EXPECT_EQ(value, testing::point(test.at("blossom").at("value")));
    ++compared;
  }
  EXPECT_EQ(compared, 18);
}

TEST(GoldenTriangles, HaveTheGivenBlossoms) {
  int compared = 0;
  for (const Json& test : golden().at("triangle")) {
    if (!test.contains("blossom")) continue;
    SCOPED_TRACE(name(test));
    const Grid<ExactPoint> coefficients = testing::net(test.at("coefficients"));
    std::vector<Vec<Rational, 2>> arguments;
    for (const Json& pair : test.at("blossom").at("arguments"))
      arguments.push_back(testing::parameters(pair));
    const Grid<Rational> weights =
        detail::triangle_blossoms(std::span<const Vec<Rational, 2>>(arguments),
                                  coefficients.rows() - 1, coefficients.columns() - 1);
    ExactPoint value{};
    for (int i = 0; i < weights.rows(); ++i)
      for (int j = 0; j < weights.columns(); ++j) value += coefficients(i, j) * weights(i, j);
    EXPECT_EQ(value, testing::point(test.at("blossom").at("value")));
    ++compared;
  }
  EXPECT_EQ(compared, 15);
}

TEST(Golden, HasNoCasesBeyondTheOnesTested) {
  EXPECT_EQ(golden().at("curve").size(), 33u);
  EXPECT_EQ(golden().at("tensor").size(), 25u);
  EXPECT_EQ(golden().at("triangle").size(), 26u);
}

}  // namespace
}  // namespace blossom
