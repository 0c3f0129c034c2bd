// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/conic_deviation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "core/tracing/spline_fit.h"

namespace blossom {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kWithin = 1e-7;

Vec3 point_on(const ElementaryChart& s, const Vec2& uv) {
  const auto [u, v] = uv.coordinates;
  const Vec3 e = std::cos(u) * s.x + std::sin(u) * s.y;
  switch (s.kind) {
    case ElementaryKind::Plane: return s.origin + u * s.x + v * s.y;
    case ElementaryKind::Cylinder: return s.origin + s.radius * e + v * s.z;
    case ElementaryKind::Cone:
      return s.origin + (s.radius + v * std::sin(s.angle)) * e + v * std::cos(s.angle) * s.z;
    case ElementaryKind::Sphere: return s.origin + s.radius * (std::cos(v) * e + std::sin(v) * s.z);
    case ElementaryKind::Torus: break;
  }
  return s.origin + (s.radius + s.minor * std::cos(v)) * e + s.minor * std::sin(v) * s.z;
}

// An image in a chart with its first two derivatives.
using Image = std::function<std::array<Vec2, 3>(double)>;

// The spline through jets at even steps.
template <class Point>
SplineOf<Point> through(const std::function<std::array<Point, 3>(double)>& jet,
                        const Interval& range, int pieces) {
  SplineOf<Point> spline{kFitDegree, {range.from}, {kFitDegree + 1}, {jet(range.from)[0]}};
  for (int i = 1; i <= pieces; ++i) {
    const double from = spline.knots.back(), to = at(range, static_cast<double>(i) / pieces);
    const auto points = hermite_points(jet(from), jet(to), to - from);
    spline.points.insert(spline.points.end(), points.begin() + 1, points.end());
    spline.knots.push_back(to);
    spline.multiplicities.push_back(i == pieces ? kFitDegree + 1 : kFitDegree);
  }
  return spline;
}

struct ConicCase {
  std::string name;
  ElementaryChart surface;
  Conic conic;
  Image image;
  Interval range{0.3, 5.1};
};

IntersectionCurve curve_of(const ConicCase& given, int pieces) {
  IntersectionCurve curve;
  const std::function<std::array<Vec3, 3>(double)> space = [&](double t) {
    return std::array{point_at(given.conic, t), derivative_at(given.conic, t),
                      second_derivative_at(given.conic, t)};
  };
  curve.conic = given.conic;
  curve.curve = through<Vec3>(space, given.range, pieces);
  curve.chart_a = curve.chart_b = through<Vec2>(given.image, given.range, pieces);
  return curve;
}

double sampled(const IntersectionCurve& curve, const Spline2& chart, const ElementaryChart& s) {
  double most = 0;
  for (int i = 0; i <= 5000; ++i) {
    const double t = at(curve.curve.domain(), i / 5000.0);
    most = std::max(most, distance(point_at(*curve.conic, t), point_on(s, point_at(chart, t))));
  }
  return most;
}

const Vec3 kX = unit(Vec3{2, -1, 0.5}), kZ = unit(cross(kX, Vec3{0.3, 1, 2})), kY = cross(kZ, kX);
const Vec3 kO{3, -2, 7};

Image straight(Vec2 from, Vec2 rate) {
  return [=](double t) { return std::array{from + t * rate, rate, Vec2{}}; };
}

std::vector<ConicCase> conic_cases() {
  const ElementaryChart plane{ElementaryKind::Plane, kO, kX, kY, kZ};
  const ElementaryChart cylinder{ElementaryKind::Cylinder, kO, kX, kY, kZ, 3};
  const ElementaryChart cone{ElementaryKind::Cone, kO, kX, kY, kZ, 2, 0, 0.4};
  const ElementaryChart ball{ElementaryKind::Sphere, kO, kX, kY, kZ, 4};
  const ElementaryChart ring{ElementaryKind::Torus, kO, kX, kY, kZ, 5, 1.5};
  const double tilt = 0.7;  // of a plane through a cylinder
  const Conic ellipse{
      ConicKind::Ellipse, kO + 2 * kZ, unit(kX + tilt * kZ), kY, 3 * std::hypot(1, tilt), 3};
  const auto circle = [](const Vec3& centre, const Vec3& x, const Vec3& y, double r) {
    return Conic{ConicKind::Circle, centre, x, y, r, r};
  };
  const auto in_plane = [](double t) {
    return std::array{Vec2{1 + 2 * std::cos(t), -3 + 2 * std::sin(t)},
                      Vec2{-2 * std::sin(t), 2 * std::cos(t)},
                      Vec2{-2 * std::cos(t), -2 * std::sin(t)}};
  };
  const auto wave = [=](double t) {
    return std::array{Vec2{t, 2 + 3 * tilt * std::cos(t)}, Vec2{1, -3 * tilt * std::sin(t)},
                      Vec2{0, -3 * tilt * std::cos(t)}};
  };
  const double cone_radius = 2 + 1.5 * std::sin(0.4), out = 5 + 1.5 * std::cos(0.8);
  const Vec3 e = std::cos(0.9) * kX + std::sin(0.9) * kY;
  const Vec3 ruling = std::sin(0.4) * e + std::cos(0.4) * kZ;
  return {
      {"CircleInPlane", plane, circle(kO + kX - 3 * kY, kX, kY, 2), in_plane},
      {"LineInPlane", plane, {ConicKind::Line, kO + kY, kX, kY}, straight({0, 1}, {1, 0})},
      {"CircleOfCylinder", cylinder, circle(kO + 1.5 * kZ, kX, kY, 3), straight({0, 1.5}, {1, 0})},
      {"BackwardCircle", cylinder, circle(kO + 1.5 * kZ, kX, -1 * kY, 3),
       straight({2 * kPi, 1.5}, {-1, 0})},
      {"EllipseOfCylinder", cylinder, ellipse, wave},
      {"RulingOfCylinder",
       cylinder,
       {ConicKind::Line, kO + 3 * e, kZ, kX},
       straight({0.9, 0}, {0, 1})},
      {"CircleOfCone", cone, circle(kO + 1.5 * std::cos(0.4) * kZ, kX, kY, cone_radius),
       straight({0, 1.5}, {1, 0})},
      {"RulingOfCone", cone, {ConicKind::Line, kO + 2 * e, ruling, kX}, straight({0.9, 0}, {0, 1})},
      {"ParallelOfSphere", ball, circle(kO + 4 * std::sin(0.5) * kZ, kX, kY, 4 * std::cos(0.5)),
       straight({0, 0.5}, {1, 0})},
      {"MeridianOfSphere", ball, circle(kO, e, kZ, 4), straight({0.9, 0}, {0, 1}), {-1.2, 1.3}},
      {"ParallelOfTorus", ring, circle(kO + 1.5 * std::sin(0.8) * kZ, kX, kY, out),
       straight({0, 0.8}, {1, 0})},
      {"MeridianOfTorus", ring, circle(kO + 5 * e, e, kZ, 1.5), straight({0.9, 0}, {0, 1})},
  };
}

class ConicDeviation : public ::testing::TestWithParam<ConicCase> {};

TEST_P(ConicDeviation, OfAFitIsHardlyMoreThanOccurs) {
  const ConicCase& given = GetParam();
  const IntersectionCurve curve = curve_of(given, 30);
  const double seen = sampled(curve, curve.chart_a, given.surface);

  const auto found = conic_deviation(curve, given.surface, given.surface, kWithin);

  ASSERT_TRUE(found);
  EXPECT_TRUE(found->proven);
  EXPECT_GE(found->a, seen);
  EXPECT_LE(found->a, 3 * seen + 1e-12);
  EXPECT_EQ(found->a, found->b);
  EXPECT_LE(found->conic, kWithin);
}

// Each control point that is moved moves the bound with it, whichever parameter it is.
TEST_P(ConicDeviation, HoldsAMovedImage) {
  const ConicCase& given = GetParam();
  for (const int d : {0, 1}) {
    IntersectionCurve curve = curve_of(given, 30);
    for (std::size_t k = 0; k < curve.chart_a.points.size(); ++k)
      curve.chart_a.points[k][d] += k % 3 == 0 ? 5e-9 : 2e-9;
    const double seen = sampled(curve, curve.chart_a, given.surface);

    const auto found = conic_deviation(curve, given.surface, given.surface, kWithin);

    ASSERT_TRUE(found);
    EXPECT_GE(found->a, seen);
    EXPECT_GE(found->between, seen - found->b);
  }
}

TEST_P(ConicDeviation, IsNotKnownOfAnotherConic) {
  const ConicCase& given = GetParam();
  IntersectionCurve curve = curve_of(given, 30);
  curve.conic->centre += 1e-3 * kX + 1e-3 * kY + 1e-3 * kZ;

  EXPECT_FALSE(conic_deviation(curve, given.surface, given.surface, kWithin));
}

TEST_P(ConicDeviation, IsNotKnownOfAnImageElsewhere) {
  const ConicCase& given = GetParam();
  IntersectionCurve curve = curve_of(given, 30);
  for (Vec2& pole : curve.chart_b.points) pole = pole + Vec2{1e-3, 1e-3};

  EXPECT_FALSE(conic_deviation(curve, given.surface, given.surface, kWithin));
}

INSTANTIATE_TEST_SUITE_P(, ConicDeviation, ::testing::ValuesIn(conic_cases()),
                         [](const auto& each) { return each.param.name; });

// No law is claimed that does not hold: an inclined circle of a sphere, or knots that are simple.
TEST(ConicDeviationLaws, AreNotAssumed) {
  const ElementaryChart ball{ElementaryKind::Sphere, kO, kX, kY, kZ, 4};
  const Vec3 x = unit(kX + kZ);
  const ConicCase inclined{
      "", ball, {ConicKind::Circle, kO, x, kY, 4, 4}, straight({0, 0}, {1, 0})};
  EXPECT_FALSE(conic_deviation(curve_of(inclined, 30), ball, ball, kWithin));

  ConicCase circle = conic_cases()[2];
  IntersectionCurve curve = curve_of(circle, 30);
  curve.curve.multiplicities[1] = 4;
  curve.curve.points.pop_back();
  EXPECT_FALSE(conic_deviation(curve, circle.surface, circle.surface, kWithin));
}

}  // namespace
}  // namespace blossom
