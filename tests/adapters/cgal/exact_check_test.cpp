// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/cgal/exact_check.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/support/golden.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::Json;
using testing::random_monomial_curve;
using testing::random_monomial_patch;
using testing::read_golden;
using testing::rounded;
using testing::seeded;
using testing::uniform;

// Exact points that are rounded once: half a unit in the last place, or one where the number type
// truncates.
constexpr double kOneRounding = 0x1p-52;

TEST(ExactCheck, GivesHandValuesExactly) {
  const MonomialCurve square{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

  EXPECT_EQ(cgal::exact_bezier_points(square, {1, 3}).points,
            (std::vector<Vec3>{{1, 1, 0}, {2, 3, 0}, {3, 9, 0}}));
  EXPECT_EQ(cgal::check_bezier_points(square, {1, 3}).largest_error, 0);
}

TEST(ExactCheck, AgreesWithTheReferenceTriangleOfTheTables) {
  const Json tables = read_golden("vlachkova_tables.json");
  const MonomialPatch surface{rounded(testing::net(tables.at("coefficients")))};
  const Json& triangle = tables.at("S4");

  const BezierTriangle exact =
      cgal::exact_bezier_points(surface, rounded(testing::corners(triangle)), 5);

  // The coefficients in double differ from the printed fractions by half a unit each.
  for (const Json& entry : triangle.at("control_points"))
    EXPECT_LE(testing::exact_gap(exact(entry.at("nu").get<int>(), entry.at("mu").get<int>()),
                                 testing::point(entry.at("value"))),
              64 * kOneRounding);
}

TEST(ExactCheck, AgreesWithBoostsRationals) {
  const Json golden = read_golden("blossom_golden.json");
  int compared = 0;
  for (const Json& test : golden.at("curve")) {
    if (!test.at("inputs_exact_in_double").get<bool>()) continue;
    const MonomialCurve curve{rounded(testing::points(test.at("coefficients")))};
    const Interval interval{rounded(testing::number(test.at("a"))),
                            rounded(testing::number(test.at("b")))};
    const auto expected = testing::points(test.at("control_points"));

    const BezierCurve exact = cgal::exact_bezier_points(curve, interval);

    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_LE(testing::exact_gap(exact.points[k], expected[k]),
                kOneRounding * max_norm(exact.points[k]));
    ++compared;
  }
  EXPECT_GE(compared, 10);
}

class ExactCheckProperty : public ::testing::TestWithParam<int> {};

TEST_P(ExactCheckProperty, DoublesAreWithinTheStatedBound) {
  auto random = seeded(GetParam());
  const int n = GetParam() % 13, m = GetParam() % 7;
  const Interval u{uniform(random, -1, 2), uniform(random, -1, 2)};
  const Interval v{uniform(random, 0, 1), uniform(random, 0, 1)};
  MonomialPatch patch = random_monomial_patch(random, n, m);
  patch.centre_u = 0.5;
  patch.scale_u = 0.5;

  const cgal::ExactCheck curve = cgal::check_bezier_points(random_monomial_curve(random, n), u);
  const cgal::ExactCheck net = cgal::check_bezier_points(patch, u, v);

  EXPECT_TRUE(curve.within()) << curve.largest_error << " above " << curve.bound;
  EXPECT_TRUE(net.within()) << net.largest_error << " above " << net.bound;
}

TEST_P(ExactCheckProperty, DoublesOfATriangleAreWithinTheStatedBound) {
  auto random = seeded(GetParam());
  const int n = GetParam() % 4, m = GetParam() % 3;
  const MonomialPatch patch = random_monomial_patch(random, n, m);
  const TriangleCorners corners{{{uniform(random, 0, 1), uniform(random, 0, 1)},
                                 {uniform(random, 0, 1), uniform(random, 0, 1)},
                                 {uniform(random, 0, 1), uniform(random, 0, 1)}}};

  const cgal::ExactCheck check = cgal::check_bezier_points(patch, corners, n + m);

  EXPECT_TRUE(check.within()) << check.largest_error << " above " << check.bound;
}

TEST_P(ExactCheckProperty, CompositionsAndNormalsAreWithinTheStatedBounds) {
  auto random = seeded(GetParam());
  const int n = 1 + GetParam() % 3, m = 1 + GetParam() % 2, d = GetParam() % 6;
  const RationalBezierPatch patch = testing::random_patch<Vec4>(random, n, m);
  const BezierCurve2 curve = testing::random_curve<Vec2>(random, d);

  const cgal::ExactCheck composed = cgal::check_composition(patch, curve);
  const cgal::ExactCheck normals = cgal::check_normal_net(testing::random_patch(random, n, m));
  const cgal::ExactCheck rational_normals = cgal::check_normal_net(patch);

  EXPECT_TRUE(composed.within()) << composed.largest_error << " above " << composed.bound;
  EXPECT_TRUE(normals.within()) << normals.largest_error << " above " << normals.bound;
  EXPECT_TRUE(rational_normals.within()) << rational_normals.largest_error;
  EXPECT_GT(rational_normals.largest_error, 0);
}

TEST_P(ExactCheckProperty, SignsAreThoseOfTheCore) {
  auto random = seeded(GetParam());
  const int n = 1 + GetParam() % 7;
  BezierFunction f;
  BezierFunction2 g{Grid<double>(n + 1, 2)};
  // Small whole numbers give many zeros.
  for (int k = 0; k <= n; ++k) f.points.push_back(testing::pick(random, -1, 1));
  for (double& c : g.points.values()) c = testing::pick(random, -1, 1);

  for (double numerator : {-1.0, 0.0, 1.0, 2.0, uniform(random, 0, 1)})
    for (double denominator : {-3.0, 1.0, 2.0}) {
      const Ratio t{numerator, denominator}, half{1, 2};
      EXPECT_EQ(cgal::exact_sign_at(f, t), sign_at(f, t));
      EXPECT_EQ(cgal::exact_sign_at(g, t, half), sign_at(g, t, half));
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ExactCheckProperty, ::testing::Range(0, 26));

TEST(ExactCheck, SeesTheRoundingOfAThird) {
  // 1/3 is no double, so the point at 1/3 of a parabola cannot be exact either.
  const MonomialCurve square{{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}};

  const cgal::ExactCheck check = cgal::check_bezier_points(square, {1.0 / 3, 1});

  EXPECT_GT(check.largest_error, 0);
  EXPECT_TRUE(check.within());
}

TEST(ExactCheck, RefusesWhatTheCoreRefuses) {
  EXPECT_THROW(cgal::exact_bezier_points(MonomialCurve{}, {0, 1}), InvalidInput);
  EXPECT_THROW(cgal::check_bezier_points(MonomialPatch{}, {0, 1}, {0, 1}), InvalidInput);
  EXPECT_THROW(cgal::check_composition(RationalBezierPatch{}, BezierCurve2{}), InvalidInput);
  EXPECT_THROW(cgal::exact_sign_at(BezierFunction{}, Ratio{}), InvalidInput);
}

TEST(ExactCheck, NamesTheLibraryItUses) {
  EXPECT_EQ(std::string(cgal::version()).rfind("CGAL 5.", 0), 0u);
}

}  // namespace
}  // namespace blossom
