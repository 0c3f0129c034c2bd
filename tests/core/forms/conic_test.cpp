// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/conic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace blossom {
namespace {

using std::numbers::pi;

std::vector<Conic> one_of_each() {
  const Vec3 centre{1, -2, 0.5}, x = unit(Vec3{1, 2, 2}), y = unit(Vec3{-2, -1, 2});
  return {{ConicKind::Line, centre, x, y, 0, 0},
          {ConicKind::Circle, centre, x, y, 3, 3},
          {ConicKind::Ellipse, centre, x, y, 3, 0.5},
          {ConicKind::Parabola, centre, x, y, 0.7, 0},
          {ConicKind::Hyperbola, centre, x, y, 0.4, 1.5}};
}

TEST(Conic, HasThePointsOfItsEquation) {
  for (const Conic& conic : one_of_each())
    for (const double t : {-1.4, -0.3, 0.0, 0.9, 1.5}) {
      const Vec3 arm = point_at(conic, t) - conic.centre;
      const double x = dot(arm, conic.x), y = dot(arm, conic.y), a = conic.major, b = conic.minor;
      EXPECT_NEAR(dot(arm, cross(conic.x, conic.y)), 0, 1e-14);
      switch (conic.kind) {
        case ConicKind::Line: EXPECT_NEAR(y, 0, 1e-14); break;
        case ConicKind::Parabola: EXPECT_NEAR(y * y, 4 * a * x, 1e-13); break;
        case ConicKind::Hyperbola: EXPECT_NEAR(x * x / (a * a) - y * y / (b * b), 1, 1e-12); break;
        default: EXPECT_NEAR(x * x / (a * a) + y * y / (b * b), 1, 1e-13);
      }
    }
}

TEST(Conic, FindsTheParameterOfItsPoints) {
  for (const Conic& conic : one_of_each())
    for (const double t : {-3.1, -1.4, -0.3, 0.0, 0.9, 3.1})
      EXPECT_NEAR(parameter_at(conic, point_at(conic, t)), t, 1e-12) << to_string(conic.kind);
}

TEST(Conic, HasTheDerivativesOfItsPoints) {
  constexpr double h = 1e-4;
  for (const Conic& conic : one_of_each())
    for (const double t : {-1.4, 0.0, 0.9}) {
      const Vec3 before = point_at(conic, t - h), at = point_at(conic, t),
                 after = point_at(conic, t + h);
      EXPECT_LE(distance((after - before) * (0.5 / h), derivative_at(conic, t)), 1e-7);
      EXPECT_LE(distance((after - 2 * at + before) * (1 / (h * h)), second_derivative_at(conic, t)),
                1e-6);
    }
}

TEST(Conic, HasKnownLengths) {
  const std::vector<Conic> all = one_of_each();
  EXPECT_DOUBLE_EQ(arc_length(all[0], {-1, 2}), 3);
  EXPECT_DOUBLE_EQ(arc_length(all[1], {0, 2 * pi}), 6 * pi);
  const double eccentricity = std::sqrt(1 - 0.25 / 9);
  EXPECT_NEAR(arc_length(all[2], {0, 2 * pi}), 12 * std::comp_ellint_2(eccentricity), 1e-11);
  const double s = 1.5 / 1.4;  // y / (2 focal)
  EXPECT_NEAR(arc_length(all[3], {0, 1.5}), 0.7 * (s * std::hypot(1, s) + std::asinh(s)), 1e-11);
  double sum = 0;
  for (int i = 0; i < 100000; ++i)
    sum += distance(point_at(all[4], i * 2e-5), point_at(all[4], (i + 1) * 2e-5));
  EXPECT_NEAR(arc_length(all[4], {0, 2}), sum, 1e-8);
}

// Sixth derivatives by the rules: d^2 is -1 or +1 times the arm for the central conics.
TEST(Conic, BoundsItsSixthDerivative) {
  for (const Conic& conic : one_of_each()) {
    const double bound = sixth_derivative_bound(conic, {-1, 1.5});
    const bool central = conic.kind == ConicKind::Ellipse || conic.kind == ConicKind::Circle ||
                         conic.kind == ConicKind::Hyperbola;
    for (double t = -1; t <= 1.5; t += 0.125)
      EXPECT_GE(bound * (1 + 1e-14), central ? norm(point_at(conic, t) - conic.centre) : 0);
  }
}

}  // namespace
}  // namespace blossom
