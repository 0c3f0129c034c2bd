// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/patch_blossom.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "core/base/errors.h"
#include "core/forms/algebra/de_casteljau.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::coordinate_gap;
using testing::lerp;
using testing::random_monomial_patch;
using testing::random_patch;
using testing::reference_point;
using testing::seeded;
using testing::uniform;

// z = u v^2.
MonomialPatch sheet() {
  MonomialPatch patch{Grid<Vec3>(2, 3)};
  patch.coefficients(1, 0) = {1, 0, 0};
  patch.coefficients(0, 1) = {0, 1, 0};
  patch.coefficients(1, 2) = {0, 0, 1};
  return patch;
}

TEST(PatchBlossom, OfASheetIsTheProductOfItsParameters) {
  EXPECT_EQ(blossom_at(sheet(), std::array{2.0}, std::array{3.0, 5.0}), (Vec3{2, 4, 30}));
}

TEST(PatchBlossom, GivesTheNetOfASheetOnARectangle) {
  const BezierPatch net = bezier_points(sheet(), {1, 2}, {0, 2});

  EXPECT_EQ(net.points(0, 0), (Vec3{1, 0, 0}));
  EXPECT_EQ(net.points(0, 1), (Vec3{1, 1, 0}));
  EXPECT_EQ(net.points(0, 2), (Vec3{1, 2, 4}));
  EXPECT_EQ(net.points(1, 2), (Vec3{2, 2, 8}));
}

class PatchBlossomProperty : public ::testing::TestWithParam<int> {
 protected:
  int n() const { return GetParam() % 26; }
  int m() const { return GetParam() * 7 % 26; }
  double bound() const { return blossom_error(n() + m()) * (n() + 1) * (m() + 1); }
  static std::vector<double> parameters(testing::Random& random, int count) {
    std::vector<double> result;
    for (int k = 0; k < count; ++k) result.push_back(uniform(random, 0, 1));
    return result;
  }
};

TEST_P(PatchBlossomProperty, IsSymmetricInEachDirection) {
  auto random = seeded(GetParam());
  const MonomialPatch patch = random_monomial_patch(random, n(), m());
  const BezierPatch bezier = random_patch(random, n(), m());
  std::vector<double> u = parameters(random, n()), v = parameters(random, m());
  const Vec3 value = blossom_at(patch, u, v), bezier_value = blossom_at(bezier, u, v);
  std::shuffle(u.begin(), u.end(), random);
  std::shuffle(v.begin(), v.end(), random);

  EXPECT_LE(coordinate_gap(blossom_at(patch, u, v), value), 2 * bound());
  EXPECT_LE(coordinate_gap(blossom_at(bezier, u, v), bezier_value),
            2 * de_casteljau_error(n() + m()));
}

TEST_P(PatchBlossomProperty, IsAffineInAParameterOfV) {
  if (m() == 0) return;
  auto random = seeded(GetParam());
  const BezierPatch patch = random_patch(random, n(), m());
  const std::vector<double> u = parameters(random, n());
  std::vector<double> v = parameters(random, m());
  const double a = uniform(random, 0, 1), b = uniform(random, 0, 1), s = uniform(random, 0, 1);

  v.back() = a;
  const Vec3 at_a = blossom_at(patch, u, v);
  v.back() = b;
  const Vec3 at_b = blossom_at(patch, u, v);
  v.back() = lerp(a, b, s);

  EXPECT_LE(coordinate_gap(blossom_at(patch, u, v), at_a * (1 - s) + at_b * s),
            3 * de_casteljau_error(n() + m()));
}

TEST_P(PatchBlossomProperty, IsTheSurfaceOnTheDiagonal) {
  auto random = seeded(GetParam());
  const MonomialPatch patch = random_monomial_patch(random, n(), m());
  const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);

  EXPECT_LE(coordinate_gap(blossom_at(patch, std::vector<double>(static_cast<std::size_t>(n()), u),
                                      std::vector<double>(static_cast<std::size_t>(m()), v)),
                           reference_point(patch, u, v)),
            bound());
}

TEST_P(PatchBlossomProperty, BezierPointsAreThoseOfTheSurface) {
  auto random = seeded(GetParam());
  MonomialPatch patch = random_monomial_patch(random, n(), m());
  patch.centre_u = uniform(random, -1, 1);
  patch.scale_v = uniform(random, 0.5, 2);
  const Interval u{uniform(random, -1, 2), uniform(random, -1, 2)};
  const Interval v{uniform(random, -1, 2), uniform(random, -1, 2)};
  const double s = uniform(random, 0, 1), t = uniform(random, 0, 1);

  const BezierPatch piece = bezier_points(patch, u, v);

  EXPECT_LE(coordinate_gap(reference_point(piece, s, t),
                           reference_point(patch, lerp(u.from, u.to, s), lerp(v.from, v.to, t))),
            2 * blossom_error(n() + m()) * blossom_scale(patch, u, v));
}

TEST_P(PatchBlossomProperty, ReversingUReversesTheRows) {
  auto random = seeded(GetParam());
  const MonomialPatch patch = random_monomial_patch(random, n(), m());
  const Interval u{uniform(random, 0, 1), uniform(random, 0, 1)};

  const BezierPatch forward = bezier_points(patch, u, {0, 1});
  const BezierPatch backward = bezier_points(patch, {u.to, u.from}, {0, 1});

  for (int i = 0; i <= n(); ++i)
    for (int j = 0; j <= m(); ++j)
      EXPECT_LE(coordinate_gap(forward.points(i, j), backward.points(n() - i, j)),
                2 * blossom_error(n() + m()) * blossom_scale(patch, u, {0, 1}));
}

INSTANTIATE_TEST_SUITE_P(Seeds, PatchBlossomProperty, ::testing::Range(0, 26));

TEST(PatchBlossom, RefusesWrongNumbersOfParametersAndWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(blossom_at(sheet(), std::array{2.0}, std::array{3.0}), InvalidInput);
  EXPECT_THROW(blossom_at(sheet(), std::array{nan}, std::array{3.0, 1.0}), InvalidInput);
  EXPECT_THROW(bezier_points(sheet(), {0, 1}, {nan, 1}), InvalidInput);
  EXPECT_THROW(bezier_points(MonomialPatch{}, {0, 1}, {0, 1}), InvalidInput);
}

}  // namespace
}  // namespace blossom
