// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/papers/q_patch.h"
#include "core/math/index.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/errors.h"
#include "core/math/detail/bernstein.h"
#include "core/papers/q_bernstein.h"
#include "tests/core/papers/q_cases.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::exact;
using testing::exact_curve;
using testing::exact_gap;
using testing::exact_pairs;
using testing::ExactCurve;
using testing::ExactInterval;
using testing::ExactPoint2;
using testing::ExactPoint3;
using testing::ExactQ;
using testing::fraction;
using testing::power;
using testing::Random;
using testing::Rational;
using testing::seeded;
using testing::uniform;

using ExactPatch3 = QBezierPatchOf<ExactPoint3>;
ExactPoint3 combination(const Grid<ExactPoint3>& net, const std::vector<Rational>& along_u,
                        const std::vector<Rational>& along_v) {
  ExactPoint3 sum{};
  for (int k = 0; k < net.rows(); ++k)
    for (int l = 0; l < net.columns(); ++l) {
      const Rational weight = along_u[index(k)] * along_v[index(l)];
      sum += net(k, l) * weight;
    }
  return sum;
}

TEST(QPatch, BilinearIsTheClassicalOneWhateverTheParameters) {
  QBezierPatch patch{Grid<Vec3>(2, 2), {0, 1}, {0, 1}, {0.5, 1}, {2, 3}};
  patch.points(0, 1) = {0, 1, 0};
  patch.points(1, 0) = {1, 0, 0};
  patch.points(1, 1) = {1, 1, 1};
  EXPECT_EQ(point_at(patch, 0.5, 0.25), (Vec3{0.5, 0.25, 0.125}));
  EXPECT_EQ(bezier_form(patch).points, patch.points);
}

// Random admissible patches of degrees 1..3 in each direction.
class QPatchProperty : public ::testing::TestWithParam<int> {
 protected:
  Random random_ = seeded(GetParam() + 400);
  ExactPatch3 patch_ = random_patch([this](int n) { return exact_curve(random_, n); });
  Rational u_ = fraction(random_), v_ = fraction(random_);

  template <class CurveOf>
  ExactPatch3 random_patch(CurveOf curve_of) {
    const ExactCurve along_u = curve_of(1 + GetParam() % 3),
                     along_v = curve_of(1 + GetParam() / 3 % 3);
    Grid<ExactPoint3> net(along_u.degree() + 1, along_v.degree() + 1);
    for (ExactPoint3& point : net.values()) point = testing::exact_points(random_, 0)[0];
    return {net, along_u.interval, along_v.interval, along_u.q, along_v.q};
  }
  std::vector<int> shuffled(int n) {
    std::vector<int> permutation = identity_permutation(n);
    std::shuffle(permutation.begin(), permutation.end(), random_);
    return permutation;
  }
};

TEST_P(QPatchProperty, IsTheCombinationOfItsNetByBothBases) {
  const auto along_u = q_bernstein(patch_.degree_u(), u_, patch_.u, patch_.q);
  const auto along_v = q_bernstein(patch_.degree_v(), v_, patch_.v, patch_.r);
  EXPECT_EQ(point_at(patch_, u_, v_), combination(patch_.points, along_u, along_v));
}

TEST_P(QPatchProperty, EveryPairOfPermutationsGivesTheSamePoint) {
  EXPECT_EQ(point_at(patch_, u_, v_, shuffled(patch_.degree_u()), shuffled(patch_.degree_v())),
            point_at(patch_, u_, v_));
}

TEST_P(QPatchProperty, HasAMonomialFormAndComesBackFromIt) {
  const auto polynomial = monomial_form(patch_);
  EXPECT_EQ(combination(polynomial.coefficients, detail::powers(u_, patch_.degree_u()),
                        detail::powers(v_, patch_.degree_v())),
            point_at(patch_, u_, v_));
  EXPECT_EQ(q_bezier_form(polynomial, patch_.u, patch_.v, patch_.q, patch_.r), patch_);
}

TEST_P(QPatchProperty, HasAClassicalFormAndComesBackFromIt) {
  const auto classical = bezier_form(patch_);
  const Rational s = (u_ - patch_.u.from) / (patch_.u.to - patch_.u.from);
  const Rational t = (v_ - patch_.v.from) / (patch_.v.to - patch_.v.from);
  EXPECT_EQ(combination(classical.points, detail::bernstein(patch_.degree_u(), s),
                        detail::bernstein(patch_.degree_v(), t)),
            point_at(patch_, u_, v_));
  EXPECT_EQ(q_bezier_form(classical, patch_.u, patch_.v, patch_.q, patch_.r), patch_);
}

TEST_P(QPatchProperty, NetHoldsTheSeparableBlossomAtTheEnds) {
  const auto polynomial = monomial_form(patch_);
  for (int k = 0; k <= patch_.degree_u(); ++k)
    for (int l = 0; l <= patch_.degree_v(); ++l)
      EXPECT_EQ(q_blossom_at(polynomial, patch_.q, patch_.r,
                             q_control_arguments(patch_.degree_u(), k, patch_.u, patch_.q),
                             q_control_arguments(patch_.degree_v(), l, patch_.v, patch_.r)),
                patch_.points(k, l));
}

TEST_P(QPatchProperty, BlossomIsSymmetricAndLinearInEachDirection) {
  const auto polynomial = monomial_form(patch_);
  auto along_u = exact_pairs(random_, patch_.degree_u());
  auto along_v = exact_pairs(random_, patch_.degree_v());
  const auto value = [&] { return q_blossom_at(polynomial, patch_.q, patch_.r, along_u, along_v); };
  const ExactPoint3 before = value();
  std::shuffle(along_u.begin(), along_u.end(), random_);
  std::shuffle(along_v.begin(), along_v.end(), random_);
  EXPECT_EQ(value(), before);
  const Rational s = fraction(random_), t = fraction(random_);
  along_u[0] *= s;
  along_v[0] *= t;
  const Rational both = s * t;
  EXPECT_EQ(value(), before * both);
}

TEST_P(QPatchProperty, QuadrantsAreThePatchAndShareTheirBorders) {
  const ExactPatch3 safe = random_patch([this](int n) { return testing::safe_curve(random_, n); });
  const Rational s = safe.u.from + (safe.u.to - safe.u.from) / 3;
  const Rational t = safe.v.from + (safe.v.to - safe.v.from) * 2 / 5;
  const auto quadrants = subdivide(safe, s, t);
  const int n = safe.degree_u(), m = safe.degree_v();
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      EXPECT_EQ(point_at(quadrants(i, j), u_, v_), point_at(safe, u_, v_));
      EXPECT_EQ(quadrants(i, j).u,
                (i == 0 ? ExactInterval{safe.u.from, s} : ExactInterval{s, safe.u.to}));
      EXPECT_EQ(quadrants(i, j).v,
                (j == 0 ? ExactInterval{safe.v.from, t} : ExactInterval{t, safe.v.to}));
    }
  EXPECT_EQ(quadrants(0, 0).points(n, m), quadrants(1, 1).points(0, 0));
  EXPECT_EQ(quadrants(0, 1).points(n, 0), quadrants(1, 0).points(0, m));
}

INSTANTIATE_TEST_SUITE_P(Seeds, QPatchProperty, ::testing::Range(0, 27));

// Degrees up to 12 in double, against exact arithmetic on the same numbers.
class QPatchAccuracy : public ::testing::TestWithParam<int> {
 protected:
  Random random_ = seeded(GetParam());
  double short_number(double low, double high) {
    return std::floor(uniform(random_, low, high) * 64) / 64;
  }
  QBezierPatch patch_{
      testing::random_patch(random_, 1 + GetParam() % 12, 1 + 5 * GetParam() % 12).points,
      {short_number(0, 0.5), short_number(1, 2)},
      {short_number(0, 0.5), short_number(1, 2)},
      {short_number(0.5, 1), 1},
      {short_number(-0.8, -0.5), 1}};
  ExactPatch3 same_{exact(patch_.points),
                    {Rational(patch_.u.from), Rational(patch_.u.to)},
                    {Rational(patch_.v.from), Rational(patch_.v.to)},
                    {Rational(patch_.q.q1), Rational(1)},
                    {Rational(patch_.r.q1), Rational(1)}};
};

TEST_P(QPatchAccuracy, ValuesAreWithinTheRunningBound) {
  const double u = short_number(0, 2), v = short_number(0, 2);
  const ExactPoint3 wanted =
      combination(same_.points, q_bernstein(same_.degree_u(), Rational(u), same_.u, same_.q),
                  q_bernstein(same_.degree_v(), Rational(v), same_.v, same_.r));
  EXPECT_LE(exact_gap(point_at(patch_, u, v), wanted),
            q_evaluation_error(patch_, u, v, identity_permutation(patch_.degree_u()),
                               identity_permutation(patch_.degree_v())));
}

TEST_P(QPatchAccuracy, ClassicalFormIsWithinTheStatedBound) {
  const Grid<Vec3> net = bezier_form(patch_).points;
  const Grid<ExactPoint3> wanted = bezier_form(same_).points;
  const double bound = bezier_form_error(patch_);
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) EXPECT_LE(exact_gap(net(i, j), wanted(i, j)), bound);
}

INSTANTIATE_TEST_SUITE_P(Seeds, QPatchAccuracy, ::testing::Range(0, 24));

TEST(QPatch, RefusesWhatHasNoBasisInEitherDirection) {
  const Grid<Vec3> net(3, 3);
  const QBezierPatch in_u{net, {0.5, 1}, {0, 1}, {2, 1}, {}};
  const QBezierPatch in_v{net, {0, 1}, {0, 1}, {}, {1, -1}};
  const QBezierPatch fine{net, {0, 1}, {0, 1}, {2, 1}, {}};
  for (const QBezierPatch& patch : {in_u, in_v}) {
    EXPECT_THROW(point_at(patch, 0.75, 0.75), InvalidInput);
    EXPECT_THROW(bezier_form(patch), InvalidInput);
    EXPECT_THROW(bezier_form_error(patch), InvalidInput);
    EXPECT_THROW(monomial_form(patch), InvalidInput);
    EXPECT_THROW(subdivide(patch, 0.75, 0.5), InvalidInput);
  }
  EXPECT_THROW(subdivide(fine, 0.5, 0.5), InvalidInput);  // [1/2, 1] with ratio 2
  EXPECT_THROW(point_at(fine, 0.5, 0.5, std::vector<int>{1, 1}, std::vector<int>{1, 2}),
               InvalidInput);
  EXPECT_THROW(q_bezier_form(BezierPatch{net}, {0, 1}, {1, 1}, {}, {}), InvalidInput);
  EXPECT_THROW(q_bezier_form(MonomialPatch{net}, {0, 1}, {0, 1}, {0, 1}, {}), InvalidInput);
  EXPECT_THROW(q_blossom_at(MonomialPatch{net}, {}, {}, std::vector<Vec2>(2), std::vector<Vec2>(1)),
               InvalidInput);
}

}  // namespace
}  // namespace blossom
