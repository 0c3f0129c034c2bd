// SPDX-License-Identifier: LGPL-2.1-or-later
// (q1,q2)-blossoms against exact reference values: 28 curves, 5 patches, 8 Marsden sums, 7 sets of
// numbers, and 8 sets of parameters that must be refused. In rationals every number must be equal;
// in doubles it must be within the stated bound of the exact result for the same doubles.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/base/errors.h"
#include "core/papers/q_bernstein.h"
#include "core/papers/q_curve.h"
#include "core/papers/q_patch.h"
#include "tests/support/golden.h"

namespace blossom {
namespace {

using testing::exact_gap;
using testing::ExactPoint;
using testing::Json;
using testing::number;
using testing::numbers;
using testing::points;
using testing::Rational;
using testing::read_golden;
using testing::rounded;

using GoldenCurve = QBezierCurveOf<ExactPoint>;
using ExactPatch = QBezierPatchOf<ExactPoint>;

const Json& golden() {
  static const Json data = read_golden("qblossom_golden.json");
  return data;
}

IntervalOf<Rational> interval(const Json& test, const char* from = "a", const char* to = "b") {
  return {number(test.at(from)), number(test.at(to))};
}

QParametersOf<Rational> parameters(const Json& test, const char* q1 = "q1", const char* q2 = "q2") {
  return {number(test.at(q1)), number(test.at(q2))};
}

class QGoldenCurve : public ::testing::TestWithParam<int> {
 protected:
  const Json& test_ = golden().at("cases").at(static_cast<std::size_t>(GetParam()));
  ::testing::ScopedTrace trace_{__FILE__, __LINE__, test_.at("label").get<std::string>()};
  GoldenCurve curve_{points(test_.at("control_points")), interval(test_), parameters(test_)};
  int n() const { return curve_.degree(); }

  // The curve with rounded data, and that as exact data again.
  QBezierCurve double_curve() const {
    return {rounded(curve_.points),
            {rounded(curve_.interval.from), rounded(curve_.interval.to)},
            {rounded(curve_.q.q1), rounded(curve_.q.q2)}};
  }
  static GoldenCurve same(const QBezierCurve& curve) {
    return {testing::exact(curve.points),
            {Rational(curve.interval.from), Rational(curve.interval.to)},
            {Rational(curve.q.q1), Rational(curve.q.q2)}};
  }
};

TEST_P(QGoldenCurve, HasTheGivenValuesAndBasis) {
  for (const Json& place : test_.at("evaluation")) {
    const Rational x = number(place.at("x"));
    EXPECT_EQ(q_bernstein(n(), x, curve_.interval, curve_.q), numbers(place.at("basis")));
    EXPECT_EQ(point_at(curve_, x), testing::point(place.at("value")));
  }
}

TEST_P(QGoldenCurve, HasTheGivenMonomialAndClassicalForms) {
  const MonomialCurveOf<ExactPoint> polynomial{points(test_.at("monomial"))};
  const BezierCurveOf<ExactPoint> classical{points(test_.at("classical"))};
  EXPECT_EQ(monomial_form(curve_), polynomial);
  EXPECT_EQ(q_bezier_form(polynomial, curve_.interval, curve_.q), curve_);
  EXPECT_EQ(bezier_form(curve_), classical);
  EXPECT_EQ(q_bezier_form(classical, curve_.interval, curve_.q), curve_);
}

TEST_P(QGoldenCurve, HasTheGivenBlossom) {
  std::vector<Vec<Rational, 2>> arguments;
  for (const Json& pair : test_.at("blossom").at("arguments"))
    arguments.push_back(testing::parameters(pair));
  const ExactPoint value = testing::point(test_.at("blossom").at("value"));
  EXPECT_EQ(
      q_blossom_at(MonomialCurveOf<ExactPoint>{points(test_.at("monomial"))}, curve_.q, arguments),
      value);
  EXPECT_EQ(q_blossom_levels(curve_.points, curve_.interval, curve_.q, arguments).back()[0], value);
}

TEST_P(QGoldenCurve, IsCutIntoTheGivenPointsWhereverTheyHaveABasis) {
  const Json& cut = test_.at("subdivision");
  const Rational t = number(cut.at("t"));
  const auto& [a, b] = curve_.interval;
  const QCutPoints<ExactPoint> found = q_cut_points(curve_, t);

  EXPECT_EQ(found.left, points(cut.at("left")));
  EXPECT_EQ(found.right, points(cut.at("right")));
  const bool left = cut.at("left_admissible").get<bool>();
  const bool right = cut.at("right_admissible").get<bool>();
  EXPECT_EQ(q_basis_obstacle(n(), IntervalOf<Rational>{a, t}, curve_.q).empty(), left);
  EXPECT_EQ(q_basis_obstacle(n(), IntervalOf<Rational>{t, b}, curve_.q).empty(), right);
  if (!left || !right) {
    EXPECT_THROW(subdivide(curve_, t), InvalidInput);
    return;
  }
  EXPECT_EQ(subdivide(curve_, t).left, (GoldenCurve{found.left, {a, t}, curve_.q}));
  EXPECT_EQ(subdivide(curve_, t).right, (GoldenCurve{found.right, {t, b}, curve_.q}));
}

TEST_P(QGoldenCurve, HasTheGivenSignOfItsBasis) {
  const Grid<Rational> matrix = q_conversion_matrix(n(), curve_.interval, curve_.q);
  const auto values = matrix.values();
  EXPECT_EQ(std::all_of(values.begin(), values.end(), [](const Rational& v) { return v >= 0; }),
            test_.at("basis_nonnegative_on_interval").get<bool>());
}

TEST_P(QGoldenCurve, IsWithinTheStatedErrorsInDouble) {
  const QBezierCurve curve = double_curve();
  const GoldenCurve wanted = same(curve);
  for (const Json& place : test_.at("evaluation")) {
    const double x = rounded(number(place.at("x")));
    EXPECT_LE(
        exact_gap(point_at(curve, x), point_at(wanted, Rational(x))),
        q_evaluation_error(curve.points, curve.interval, curve.q, x, identity_permutation(n())));
  }
  const std::vector<Vec3> classical = bezier_form(curve).points;
  const std::vector<ExactPoint> wanted_classical = bezier_form(wanted).points;
  const double t = rounded(number(test_.at("subdivision").at("t")));
  const QCutPoints<Vec3> cut = q_cut_points(curve, t);
  const QCutPoints<ExactPoint> wanted_cut = q_cut_points(wanted, Rational(t));
  for (std::size_t k = 0; k < classical.size(); ++k) {
    EXPECT_LE(exact_gap(classical[k], wanted_classical[k]), bezier_form_error(curve));
    EXPECT_LE(exact_gap(cut.left[k], wanted_cut.left[k]), q_cut_error(curve, t));
    EXPECT_LE(exact_gap(cut.right[k], wanted_cut.right[k]), q_cut_error(curve, t));
  }
}

TEST_P(QGoldenCurve, HasTheGivenControlPointsWithinTheStatedErrorInDouble) {
  const MonomialCurve polynomial{rounded(points(test_.at("monomial")))};
  const QBezierCurve curve = double_curve();
  const GoldenCurve exact_curve = same(curve);
  const auto found = q_control_points(polynomial, curve.interval, curve.q);
  const auto wanted =
      q_control_points(MonomialCurveOf<ExactPoint>{testing::exact(polynomial.coefficients)},
                       exact_curve.interval, exact_curve.q);
  for (int k = 0; k <= n(); ++k) {
    const auto arguments = q_control_arguments(n(), k, curve.interval, curve.q);
    EXPECT_LE(exact_gap(found[static_cast<std::size_t>(k)], wanted[static_cast<std::size_t>(k)]),
              q_blossom_error(n()) * q_blossom_scale(polynomial, curve.q, arguments));
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, QGoldenCurve, ::testing::Range(0, 28));

TEST(QGolden, EvaluationHasTheGivenLevels) {
  int compared = 0;
  for (const Json& test : golden().at("cases")) {
    if (!test.contains("de_casteljau")) continue;
    SCOPED_TRACE(test.at("label").get<std::string>());
    const Json& given = test.at("de_casteljau");
    const auto levels =
        q_evaluation_levels(points(test.at("control_points")), interval(test), parameters(test),
                            number(given.at("x")), given.at("permutation").get<std::vector<int>>());
    const Json& first = given.at("levels_first_coordinate");
    ASSERT_EQ(levels.size(), first.size());
    for (std::size_t r = 0; r < levels.size(); ++r) {
      std::vector<Rational> found;
      for (const ExactPoint& point : levels[r]) found.push_back(point[0]);
      EXPECT_EQ(found, numbers(first.at(r))) << "level " << r;
    }
    ++compared;
  }
  EXPECT_EQ(compared, 10);
}

class QGoldenPatch : public ::testing::TestWithParam<int> {
 protected:
  const Json& test_ = golden().at("tensor").at(static_cast<std::size_t>(GetParam()));
  ::testing::ScopedTrace trace_{__FILE__, __LINE__, test_.at("label").get<std::string>()};
  ExactPatch patch_{testing::net(test_.at("control_points")), interval(test_),
                    interval(test_, "c", "d"), parameters(test_), parameters(test_, "r1", "r2")};
};

TEST_P(QGoldenPatch, IsExactInRationals) {
  const MonomialPatchOf<ExactPoint> polynomial{testing::net(test_.at("monomial"))};
  const BezierPatchOf<ExactPoint> classical{testing::net(test_.at("classical"))};
  EXPECT_EQ(monomial_form(patch_), polynomial);
  EXPECT_EQ(q_bezier_form(polynomial, patch_.u, patch_.v, patch_.q, patch_.r), patch_);
  EXPECT_EQ(bezier_form(patch_), classical);
  EXPECT_EQ(q_bezier_form(classical, patch_.u, patch_.v, patch_.q, patch_.r), patch_);
  for (const Json& place : test_.at("evaluation"))
    EXPECT_EQ(point_at(patch_, number(place.at("u")), number(place.at("v"))),
              testing::point(place.at("value")));
}

TEST_P(QGoldenPatch, HasTheGivenQuadrants) {
  const Json& cut = test_.at("subdivision");
  const auto quadrants = subdivide(patch_, number(cut.at("s")), number(cut.at("t")));
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const std::string name = std::to_string(i) + std::to_string(j);
      ASSERT_TRUE(cut.at("admissible").at(name).get<bool>());
      EXPECT_EQ(quadrants(i, j).points, testing::net(cut.at("quadrants").at(name)));
    }
}

TEST_P(QGoldenPatch, IsWithinTheStatedErrorsInDouble) {
  const QBezierPatch patch{rounded(patch_.points),
                           {rounded(patch_.u.from), rounded(patch_.u.to)},
                           {rounded(patch_.v.from), rounded(patch_.v.to)},
                           {rounded(patch_.q.q1), rounded(patch_.q.q2)},
                           {rounded(patch_.r.q1), rounded(patch_.r.q2)}};
  const ExactPatch wanted{testing::exact(patch.points),
                          {Rational(patch.u.from), Rational(patch.u.to)},
                          {Rational(patch.v.from), Rational(patch.v.to)},
                          {Rational(patch.q.q1), Rational(patch.q.q2)},
                          {Rational(patch.r.q1), Rational(patch.r.q2)}};
  for (const Json& place : test_.at("evaluation")) {
    const double u = rounded(number(place.at("u"))), v = rounded(number(place.at("v")));
    EXPECT_LE(exact_gap(point_at(patch, u, v), point_at(wanted, Rational(u), Rational(v))),
              q_evaluation_error(patch, u, v, identity_permutation(patch.degree_u()),
                                 identity_permutation(patch.degree_v())));
  }
  const Grid<Vec3> net = bezier_form(patch).points;
  const Grid<ExactPoint> wanted_net = bezier_form(wanted).points;
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j)
      EXPECT_LE(exact_gap(net(i, j), wanted_net(i, j)), bezier_form_error(patch));
}

INSTANTIATE_TEST_SUITE_P(Cases, QGoldenPatch, ::testing::Range(0, 5));

TEST(QGolden, NumbersAreTheGivenOnes) {
  for (const Json& test : golden().at("numbers")) {
    const int n = test.at("n").get<int>();
    const auto q = parameters(test);
    std::vector<Rational> integers;
    for (int k = 0; k <= n; ++k) integers.push_back(q_integer(k, q));
    EXPECT_EQ(integers, numbers(test.at("integers")));
    EXPECT_EQ(q_binomials(n, q), numbers(test.at("binomials")));
    EXPECT_EQ(q_diagonal_factors(n, q), numbers(test.at("diagonal_factors")));
  }
}

TEST(QGolden, MarsdenSumsHaveTheGivenTerms) {
  for (const Json& test : golden().at("marsden")) {
    const int n = test.at("n").get<int>();
    const Rational t = number(test.at("t")), x = number(test.at("x"));
    EXPECT_EQ(q_marsden_terms(n, t, x, interval(test), parameters(test)),
              numbers(test.at("terms")));
    EXPECT_EQ(q_marsden_product(n, t, x, interval(test), parameters(test)), number(test.at("sum")));
  }
}

TEST(QGolden, InadmissibleParametersAreRefusedWithTheGivenReason) {
  // The beginning of the reason in the data, and what our message says.
  const std::map<std::string, std::string> words{
      {"q1=0", "q1 = 0 and"},        {"q2=0", "q2 = 0 and"},
      {"q1=-q2", "q1 = -q2 = "},     {"q1 a = q2 b", "q1 a = q2 b on"},
      {"q1^2 a", "q1^2 a = q2^2 b"}, {"a=b", "a = b on"}};
  for (const Json& test : golden().at("inadmissible")) {
    const std::string reason = test.at("reason").get<std::string>();
    const int n = test.at("n").get<int>();
    const auto wanted = std::find_if(words.begin(), words.end(), [&](const auto& entry) {
      return reason.starts_with(entry.first);
    });
    ASSERT_NE(wanted, words.end()) << reason;
    const GoldenCurve curve{std::vector<ExactPoint>(static_cast<std::size_t>(n + 1)),
                            interval(test), parameters(test)};
    try {
      point_at(curve, Rational(1));
      ADD_FAILURE() << "accepted in spite of " << reason;
    } catch (const InvalidInput& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("point_at: " + wanted->second))
          << error.what();
    }
    EXPECT_TRUE(q_basis_obstacle(n,
                                 Interval{rounded(curve.interval.from), rounded(curve.interval.to)},
                                 QParameters{rounded(curve.q.q1), rounded(curve.q.q2)})
                    .starts_with(wanted->second));
  }
}

TEST(QGolden, HasNoCasesBeyondTheOnesTested) {
  EXPECT_EQ(golden().at("cases").size(), 28u);
  EXPECT_EQ(golden().at("tensor").size(), 5u);
  EXPECT_EQ(golden().at("marsden").size(), 8u);
  EXPECT_EQ(golden().at("numbers").size(), 7u);
  EXPECT_EQ(golden().at("inadmissible").size(), 8u);
}

}  // namespace
}  // namespace blossom
