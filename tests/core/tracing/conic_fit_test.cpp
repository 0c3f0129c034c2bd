// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/conic_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

using std::numbers::pi;
constexpr double kSlack = 1e-11;

std::vector<Vec3> points_of(const std::function<Vec3(double)>& curve, const Interval& range,
                            int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(curve(at(range, (i + 0.5) / count)));
  return points;
}

struct Sample {
  Conic conic;
  Interval range;
};

// A conic of a kind somewhere in space, and a part of it that may run backwards.
Sample random_sample(testing::Random& random, ConicKind kind) {
  const auto vector = [&] {
    return Vec3{uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)};
  };
  const Vec3 x = unit(vector()), y = unit(cross(x, vector()));
  const double major = uniform(random, 0.5, 2.0), minor = major * uniform(random, 0.1, 0.9);
  Conic conic{kind, vector(), x, y, major, kind == ConicKind::Circle ? major : minor};
  const double turn = conic.is_closed() ? uniform(random, 0.5, 2 * pi) : uniform(random, 0.5, 2.0);
  const double start = uniform(random, -1.5, 1.5);
  return {conic, uniform(random, 0.0, 1.0) < 0.5 ? Interval{start, start + turn}
                                                 : Interval{start + turn, start}};
}

TEST(ConicThrough, FindsConicsOfEveryKind) {
  auto random = seeded(5);
  for (const ConicKind kind : {ConicKind::Line, ConicKind::Circle, ConicKind::Ellipse,
                               ConicKind::Parabola, ConicKind::Hyperbola})
    for (int trial = 0; trial < 200; ++trial) {
      const auto [conic, range] = random_sample(random, kind);
      const auto curve = [&](double t) { return point_at(conic, t); };
      const std::vector<Vec3> points = points_of(curve, range, trial % 2 == 0 ? 7 : 24);
      const auto found = conic_through(points, kSlack);
      ASSERT_TRUE(found) << to_string(kind);
      EXPECT_EQ(found->kind, kind);
      for (double t = 0.1; t < 1; t += 0.1) {  // between the points, too
        const Vec3 p = curve(at(range, t));
        EXPECT_LE(distance(point_at(*found, parameter_at(*found, p)), p), 2 * kSlack);
      }
      for (std::size_t i = 1; i < points.size(); ++i) {
        const double step = parameter_at(*found, points[i]) - parameter_at(*found, points[i - 1]);
        EXPECT_GT(found->is_closed() ? std::remainder(step, 2 * pi) : step, 0);
      }
    }
}

TEST(ConicThrough, FindsTheEllipsesAxes) {
  const Conic ellipse{ConicKind::Ellipse, {3, 4, 5}, {0.6, 0.8, 0}, {0, 0, 1}, 7, 0.25};
  const auto found = conic_through(
      points_of([&](double t) { return point_at(ellipse, t); }, {0.3, 0.3 + 2 * pi}, 24), kSlack);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, ConicKind::Ellipse);
  EXPECT_LE(distance(found->centre, ellipse.centre), 1e-13);
  EXPECT_NEAR(found->major, 7, 1e-13);
  EXPECT_NEAR(found->minor, 0.25, 1e-13);
  EXPECT_NEAR(std::abs(dot(found->x, ellipse.x)), 1, 1e-14);
}

TEST(ConicThrough, RefusesOtherCurves) {
  const Interval range{-0.5, 0.8};
  const std::vector<std::function<Vec3(double)>> others{
      [](double t) {
        return Vec3{std::cos(t), std::sin(t), 0.01 * t * t};
      },  // not plane
      [](double t) {
        return Vec3{t, t * t * t, 0};
      },
      [](double t) {
        return Vec3{t, std::exp(t), 1};
      },
      [](double t) {
        return Vec3{t, 0, std::pow(t, 6)};
      },
  };
  for (const auto& curve : others)
    for (const int count : {7, 24})
      EXPECT_FALSE(conic_through(points_of(curve, range, count), kSlack));
}

TEST(ConicThrough, RefusesAPointOffTheCurve) {
  const Conic circle{ConicKind::Circle, {}, {1, 0, 0}, {0, 1, 0}, 1, 1};
  for (const double off : {3 * kSlack, -3 * kSlack})
    for (std::size_t i = 0; i < 24; ++i) {
      auto points = points_of([&](double t) { return point_at(circle, t); }, {0, 2 * pi}, 24);
      ASSERT_TRUE(conic_through(points, kSlack));
      points[i][2] += 30 * off;
      EXPECT_FALSE(conic_through(points, kSlack)) << i;
      points[i][2] = 0;
      points[i] *= 1 + 30 * off;
      EXPECT_FALSE(conic_through(points, kSlack)) << i;
    }
}

TEST(ConicThrough, WantsSixPointsThatAreSpread) {
  const Conic line{ConicKind::Line, {}, {1, 0, 0}, {}, 0, 0};
  const auto points = points_of([&](double t) { return point_at(line, t); }, {0, 1}, 6);
  EXPECT_TRUE(conic_through(points, kSlack));
  EXPECT_FALSE(conic_through({points.data(), 5}, kSlack));
  EXPECT_FALSE(conic_through(std::vector<Vec3>(8, Vec3{1, 2, 3}), kSlack));
}

}  // namespace
}  // namespace blossom
