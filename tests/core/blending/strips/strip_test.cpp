// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips: borders and tangent planes kept exactly, whatever the degrees, knots and weights.

#include "core/blending/strips/strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/forms/evaluation.h"

namespace blossom {
namespace {

/// A net of n + 1 by m + 1 homogeneous points from their indices.
RationalBezierPatch patch_of(int n, int m, const std::function<Vec4(int, int)>& point) {
  RationalBezierPatch patch{Grid<Vec4>(n + 1, m + 1)};
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) patch.points(i, j) = point(i, j);
  return patch;
}

Vec4 weighted(double x, double y, double z, double w) { return {w * x, w * y, w * z, w}; }

BezierSurface surface_of(const RationalBezierPatch& patch, const Interval& u, const Interval& v) {
  BezierSurface surface;
  surface.u_knots = {u.from, u.to};
  surface.v_knots = {v.from, v.to};
  surface.patches = Grid<RationalBezierPatch>(1, 1, patch);
  for (const Vec4& point : patch.points.values()) surface.rational |= point[3] != 1;
  return surface;
}

/// The square [x, x + 1] x [0, 1] in the plane z = 0, u along x.
BezierSurface square(double x) {
  return surface_of(patch_of(1, 1, [&](int i, int j) { return weighted(x + i, j, 0, 1); }), {0, 1},
                    {0, 1});
}

/// A wavy surface over [x, x + 2] x [0, 3]; `weight` is how far weights may leave 1.
BezierSurface random_surface(std::mt19937& random, double x, int n, int m, int u_spans, int v_spans,
                             double weight) {
  std::uniform_real_distribution<double> noise(-1, 1);
  const int rows = n * u_spans + 1, columns = m * v_spans + 1;
  Grid<Vec4> net(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      net(i, j) = weighted(x + 2.0 * i / (rows - 1), 3.0 * j / (columns - 1), 0.3 * noise(random),
                           1 + weight * noise(random));
  BezierSurface surface;
  surface.u_knots = {0.5};
  surface.v_knots = {-1};
  for (int i = 0; i < u_spans; ++i)
    surface.u_knots.push_back(surface.u_knots.back() + 1.5 + noise(random));
  for (int j = 0; j < v_spans; ++j)
    surface.v_knots.push_back(surface.v_knots.back() + 1.5 + noise(random));
  surface.rational = weight != 0;
  surface.patches = Grid<RationalBezierPatch>(u_spans, v_spans);
  for (int p = 0; p < u_spans; ++p)
    for (int q = 0; q < v_spans; ++q)
      surface.patches(p, q) =
          patch_of(n, m, [&](int i, int j) { return net(n * p + i, m * q + j); });
  return surface;
}

/// A quarter of the cylinder of radius 1 round the z axis, 0 <= z <= 1; u is the angle.
BezierSurface quarter_cylinder() {
  const double w = std::sqrt(0.5);
  BezierSurface surface = surface_of(
      patch_of(
          2, 1,
          [&](int i, int j) { return weighted(i < 2 ? 1 : 0, i > 0 ? 1 : 0, j, i == 1 ? w : 1); }),
      {0, std::numbers::pi / 2}, {0, 1});
  surface.u_law = ParameterLaw::Angle;
  return surface;
}

/// Where the border of a surface is, and which way is out.
struct BorderJet {
  Vec3 point;
  Vec3 along;
  Vec3 outwards;
};

/// The border at fraction x of its range, from the whole patch.
BorderJet border_jet(const BezierSurface& surface, SurfaceSide side, double x) {
  const bool along_v = side == SurfaceSide::UMin || side == SurfaceSide::UMax;
  const bool at_end = side == SurfaceSide::UMax || side == SurfaceSide::VMax;
  const std::vector<double>& knots = along_v ? surface.v_knots : surface.u_knots;
  const double parameter = knots.front() + x * (knots.back() - knots.front());
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, parameter);
  const int span = static_cast<int>(above - knots.begin()) - 1;
  const Interval place{*(above - 1), *above};
  const double t = local_parameter(along_v ? surface.v_law : surface.u_law, place, parameter);
  const double edge = at_end ? 1 : 0;
  const Grid<RationalBezierPatch>& all = surface.patches;
  const RationalBezierPatch& patch =
      along_v ? all(at_end ? all.rows() - 1 : 0, span) : all(span, at_end ? all.columns() - 1 : 0);
  const PatchJet jet = along_v ? jet_at(patch, edge, t, 1) : jet_at(patch, t, edge, 1);
  const double sign = at_end ? 1 : -1;
  return {jet.point, along_v ? jet.v : jet.u, sign * (along_v ? jet.u : jet.v)};
}

double plane_angle(const Vec3& a1, const Vec3& a2, const Vec3& b1, const Vec3& b2) {
  const Vec3 a = cross(a1, a2), b = cross(b1, b2);
  return std::atan2(norm(cross(a, b)), std::abs(dot(a, b)));
}

/// Rows of these tests lie 0.1 and more apart, with coordinates below 10: what rounding of
/// strip_gap_bound can turn, times 100 for tangents that are nearly parallel.
constexpr double kAngle = 1e-10;

/// What the strip promises, checked against the neighbours' own patches at fractions that are
/// not sampled by the strip itself.
void expect_smooth(const Strip& strip, const BezierSurface& a, SurfaceSide side_a,
                   const BezierSurface& b, SurfaceSide side_b) {
  const double bound = strip_gap_bound(strip.surface);
  for (int k = 0; k <= 50; ++k) {
    const double x = k / 50.0;
    const BorderJet of_a = border_jet(a, side_a, x);
    const BorderJet of_b = border_jet(b, side_b, strip.backward ? 1 - x : x);
    const BorderJet first = border_jet(strip.surface, SurfaceSide::VMin, x);
    const BorderJet last = border_jet(strip.surface, SurfaceSide::VMax, x);
    EXPECT_LE(distance(first.point, of_a.point), bound);
    EXPECT_LE(distance(last.point, of_b.point), bound);
    EXPECT_LE(plane_angle(first.along, first.outwards, of_a.along, of_a.outwards), kAngle);
    EXPECT_LE(plane_angle(last.along, last.outwards, of_b.along, of_b.outwards), kAngle);
    EXPECT_LT(dot(first.outwards, of_a.outwards), 0);
    EXPECT_LT(dot(last.outwards, of_b.outwards), 0);
  }
  for (const StripContact& contact : strip.contacts) {
    EXPECT_LE(contact.gap, bound);
    EXPECT_LE(contact.normal_angle, kAngle);
  }
  const Grid<RationalBezierPatch>& spans = strip.surface.patches;
  for (int span = 1; span < spans.rows(); ++span)
    for (int j = 0; j <= spans(0, 0).degree_v(); ++j) {
      const Vec4& end = spans(span - 1, 0).points(spans(span - 1, 0).degree_u(), j);
      EXPECT_LE(max_norm(end - spans(span, 0).points(0, j)), 1e-11) << "spans part at " << span;
    }
}

TEST(Strip, BetweenTwoSquaresIsThePlaneWithEvenRows) {
  const Strip strip = strip_between(square(0), SurfaceSide::UMax, square(4), SurfaceSide::UMin);

  const Grid<Vec4>& net = strip.surface.patches(0, 0).points;
  ASSERT_EQ(net.rows(), 2);
  ASSERT_EQ(net.columns(), 4);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 4; ++j) EXPECT_EQ(net(i, j), weighted(1.0 + j, i, 0, 1)) << i << ", " << j;
  EXPECT_FALSE(strip.backward);
  EXPECT_DOUBLE_EQ(strip.contacts[0].scale, 3);
}

TEST(Strip, WeightsMoveTheInnerRows) {
  const Strip strip = strip_between(square(0), SurfaceSide::UMax, square(4), SurfaceSide::UMin,
                                    {.weight_a = 2, .weight_b = 0.5});

  const Grid<Vec4>& net = strip.surface.patches(0, 0).points;
  EXPECT_EQ(net(0, 1), weighted(3, 0, 0, 1));
  EXPECT_EQ(net(1, 2), weighted(3.5, 1, 0, 1));
}

// A surface of degree 2k + 1 cut at v = 0.3 and v = 0.7: with the right lengths the strip of order
// k is what was cut out.
class StripOrder : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Orders, StripOrder, ::testing::Range(1, 4));

TEST_P(StripOrder, GivesBackTheMiddleOfASurfaceOfItsDegree) {
  std::mt19937 random(7);
  const int m = 2 * GetParam() + 1;
  const BezierSurface whole = random_surface(random, 0, 4, m, 1, 1, 0);
  const auto part = [&](double from, double to) {
    return surface_of(patch_of(4, m,
                               [&](int i, int j) {
                                 // The blossom of row i at m - j times `from` and j times `to`.
                                 std::vector<Vec4> row;
                                 for (int k = 0; k <= m; ++k)
                                   row.push_back(whole.patches(0, 0).points(i, k));
                                 for (int left = m; left > 0; --left) {
                                   const double t = left > j ? from : to;
                                   for (std::size_t k = 0; k < std::size_t(left); ++k)
                                     row[k] = (1 - t) * row[k] + t * row[k + 1];
                                 }
                                 return row[0];
                               }),
                      {0, 1}, {from, to});
  };
  const BezierSurface low = part(0, 0.3), high = part(0.7, 1);
  const Strip natural =
      strip_between(low, SurfaceSide::VMax, high, SurfaceSide::VMin, {.order = GetParam()});

  const Strip strip = strip_between(low, SurfaceSide::VMax, high, SurfaceSide::VMin,
                                    {.order = GetParam(),
                                     .weight_a = 0.4 / natural.contacts[0].scale,
                                     .weight_b = 0.4 / natural.contacts[1].scale});

  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10; ++j) {
      const Vec3 ours = jet_at(strip.surface.patches(0, 0), i / 10.0, j / 10.0, 1).point;
      const Vec3 cut_out = jet_at(whole.patches(0, 0), i / 10.0, 0.3 + 0.4 * j / 10.0, 1).point;
      EXPECT_LE(distance(ours, cut_out), 1e-13);
    }
}

TEST(Strip, JoinsACylinderToASplineSurface) {
  std::mt19937 random(3);
  const BezierSurface cylinder = quarter_cylinder();
  BezierSurface other = random_surface(random, 0, 3, 3, 2, 1, 0);
  for (RationalBezierPatch& patch : other.patches.values())
    for (Vec4& point : patch.points.values()) point = {point[0], point[1] + 1, point[2] + 3, 1};

  const Strip strip = strip_between(cylinder, SurfaceSide::VMax, other, SurfaceSide::VMin);

  ASSERT_EQ(strip.surface.patches.rows(), 2);
  EXPECT_EQ(strip.surface.patches(0, 0).degree_u(), 3);
  for (int span = 0; span < 2; ++span)
    for (int k = 0; k <= 20; ++k) {
      const PatchJet jet = jet_at(strip.surface.patches(span, 0), k / 20.0, 0, 1);
      EXPECT_NEAR(std::hypot(jet.point[0], jet.point[1]), 1, strip_gap_bound(strip.surface));
      EXPECT_NEAR(jet.point[2], 1, strip_gap_bound(strip.surface));
      const Vec3 normal = unit(cross(jet.u, jet.v));
      EXPECT_NEAR(normal[2], 0, 1e-13);
      EXPECT_NEAR(normal[0] * jet.point[1] - normal[1] * jet.point[0], 0, 1e-13);
    }
  EXPECT_LE(strip.contacts[1].gap, strip_gap_bound(strip.surface));
  EXPECT_LE(strip.contacts[1].normal_angle, 1e-12);
}

// The rulings at the ends of the arc: the weights change across the border, not along it.
TEST(Strip, KeepsTheDegreeWhereWeightsSeparate) {
  const BezierSurface cylinder = quarter_cylinder();
  BezierSurface plane = square(0);
  for (Vec4& point : plane.patches(0, 0).points.values()) point = {-2 - point[0], 1, point[1], 1};

  const Strip strip = strip_between(cylinder, SurfaceSide::UMax, plane, SurfaceSide::UMin);

  EXPECT_EQ(strip.surface.patches(0, 0).degree_u(), 1);
  expect_smooth(strip, cylinder, SurfaceSide::UMax, plane, SurfaceSide::UMin);
}

TEST(Strip, DoublesTheDegreeWhereWeightsDoNotSeparate) {
  std::mt19937 random(11);
  const BezierSurface a = random_surface(random, 0, 2, 3, 1, 1, 0.4);
  const BezierSurface b = random_surface(random, 5, 3, 2, 1, 1, 0.4);

  const Strip strip = strip_between(a, SurfaceSide::UMax, b, SurfaceSide::UMin);

  EXPECT_EQ(strip.surface.patches(0, 0).degree_u(), 6);
  for (const Vec4& point : strip.surface.patches(0, 0).points.values()) EXPECT_GT(point[3], 0);
  expect_smooth(strip, a, SurfaceSide::UMax, b, SurfaceSide::UMin);
}

TEST(Strip, FindsThatTheOtherBorderRunsBackwards) {
  std::mt19937 random(5);
  const BezierSurface a = random_surface(random, 0, 3, 2, 1, 2, 0);
  BezierSurface b = random_surface(random, 5, 2, 4, 1, 3, 0);
  const Strip forward = strip_between(a, SurfaceSide::UMax, b, SurfaceSide::UMin);
  EXPECT_FALSE(forward.backward);

  for (RationalBezierPatch& patch : b.patches.values())
    for (Vec4& point : patch.points.values()) point[1] = 3 - point[1];
  const Strip strip = strip_between(a, SurfaceSide::UMax, b, SurfaceSide::UMin);

  EXPECT_TRUE(strip.backward);
  expect_smooth(strip, a, SurfaceSide::UMax, b, SurfaceSide::UMin);
  const Strip twisted =
      strip_between(a, SurfaceSide::UMax, b, SurfaceSide::UMin, {.pairing = Pairing::Forward});
  EXPECT_FALSE(twisted.backward);
  expect_smooth(twisted, a, SurfaceSide::UMax, b, SurfaceSide::UMin);
}

// The same surface, its second span with homogeneous points three times as long.
TEST(Strip, DoesNotSeeACommonFactorOfASpansWeights) {
  std::mt19937 random(17);
  const BezierSurface a = random_surface(random, 0, 3, 2, 1, 2, 0.2);
  const BezierSurface b = random_surface(random, 5, 3, 2, 1, 1, 0);
  BezierSurface scaled = a;
  for (Vec4& point : scaled.patches(0, 1).points.values()) point *= 3;

  const Strip strip = strip_between(scaled, SurfaceSide::UMax, b, SurfaceSide::UMin);

  expect_smooth(strip, a, SurfaceSide::UMax, b, SurfaceSide::UMin);
}

TEST(Strip, BetweenClosedBordersIsClosed) {
  const double w = std::sqrt(0.5);
  const double xs[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, ys[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
  BezierSurface tube;
  tube.v_knots = {0, 1};
  tube.closed_u = tube.rational = true;
  tube.patches = Grid<RationalBezierPatch>(4, 1);
  for (int k = 0; k <= 4; ++k) tube.u_knots.push_back(k * std::numbers::pi / 2);
  for (int k = 0; k < 4; ++k)
    tube.patches(k, 0) = patch_of(2, 1, [&](int i, int j) {
      return weighted(xs[2 * k + i], ys[2 * k + i], j, i == 1 ? w : 1);
    });
  BezierSurface wider = tube;
  for (RationalBezierPatch& patch : wider.patches.values())
    for (Vec4& p : patch.points.values()) p = {2 * p[0], 2 * p[1], p[2] + 4 * p[3], p[3]};

  const Strip strip = strip_between(tube, SurfaceSide::VMax, wider, SurfaceSide::VMin);

  EXPECT_TRUE(strip.surface.closed_u);
  EXPECT_FALSE(strip.backward);
  expect_smooth(strip, tube, SurfaceSide::VMax, wider, SurfaceSide::VMin);
}

TEST(Strip, RefusesWhatHasNoStrip) {
  const BezierSurface a = square(0), b = square(4);
  const auto message = [](const std::function<void()>& work) -> std::string {
    try {
      work();
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "nothing was thrown";
  };

  EXPECT_EQ(message([&] { strip_between(a, SurfaceSide::UMax, a, SurfaceSide::UMax); }),
            "strip: the borders coincide, there is nothing between them");
  for (const int order : {0, 4})
    EXPECT_THROW(strip_between(a, SurfaceSide::UMax, b, SurfaceSide::UMin, {.order = order}),
                 InvalidInput);
  EXPECT_THROW(strip_between(a, SurfaceSide::UMax, b, SurfaceSide::UMin, {.weight_a = 0}),
               InvalidInput);
  EXPECT_THROW(strip_between(a, SurfaceSide::UMax, b, SurfaceSide::UMin,
                             {.weight_b = std::numeric_limits<double>::infinity()}),
               InvalidInput);

  const BezierSurface cone = surface_of(
      patch_of(1, 1, [](int i, int j) { return weighted(i, i * j, 0, 1); }), {0, 1}, {0, 1});
  EXPECT_EQ(message([&] { strip_between(a, SurfaceSide::UMax, cone, SurfaceSide::UMin); }),
            "strip: the border umin of b is a point");

  const BezierSurface folded =
      surface_of(patch_of(2, 1, [](int i, int j) { return weighted(i < 2 ? 0 : 1, j, 0, 1); }),
                 {0, 1}, {0, 1});
  EXPECT_THROW(strip_between(folded, SurfaceSide::UMin, b, SurfaceSide::UMin), InvalidInput);

  std::mt19937 random(2);
  const BezierSurface high = random_surface(random, 0, 2, 13, 1, 1, 0.2);
  EXPECT_EQ(message([&] { strip_between(high, SurfaceSide::UMin, b, SurfaceSide::UMin); }),
            "strip: the strip would have degree 26, at most 25 is possible");

  BezierSurface broken = a;
  broken.u_knots = {1, 0};
  EXPECT_THROW(strip_between(broken, SurfaceSide::UMax, b, SurfaceSide::UMin), InvalidInput);
}

TEST(Strip, MeasuresWhatOthersHaveMadeOfIt) {
  std::mt19937 random(23);
  const BezierSurface a = random_surface(random, 0, 3, 2, 1, 2, 0);
  const BezierSurface b = random_surface(random, 5, 3, 2, 1, 1, 0);
  BezierSurface strip = strip_between(a, SurfaceSide::UMax, b, SurfaceSide::UMin).surface;
  for (Vec4& point : strip.patches(1, 0).points.values()) point[2] += 0.25;

  const Border border_a = border_of(a, SurfaceSide::UMax, 2);
  const Border border_b = border_of(b, SurfaceSide::UMin, 2);

  const auto contacts = strip_contacts(strip, border_a, border_b, false);

  for (const StripContact& contact : contacts) {
    EXPECT_LE(contact.gap, 0.25);
    EXPECT_GT(contact.gap, 0.1);
  }
  for (int i = 0; i < 3; ++i) strip.patches(0, 0).points(i, 1)[2] += 0.1;
  EXPECT_GT(strip_contacts(strip, border_a, border_b, false)[0].normal_angle, 0.01);
  EXPECT_THROW(strip_contacts(b, border_a, border_b, false), InvalidInput);
}

TEST(Strip, NamesItsSides) {
  EXPECT_STREQ(to_string(SurfaceSide::UMin), "umin");
  EXPECT_STREQ(to_string(SurfaceSide::UMax), "umax");
  EXPECT_STREQ(to_string(SurfaceSide::VMin), "vmin");
  EXPECT_STREQ(to_string(SurfaceSide::VMax), "vmax");
}

/// How high a surface lies over a tangent plane of another one: over the point `step` along
/// `across` in the plane through `origin` square to `along`.
double height_over(const RationalBezierPatch& patch, const Vec3& origin, const Vec3& along,
                   const Vec3& across, const Vec3& normal, double u, double v, double step) {
  for (int newton = 0; newton < 20; ++newton) {
    const PatchJet jet = jet_at(patch, u, v, 1);
    const double f = dot(jet.point - origin, along), g = dot(jet.point - origin, across) - step;
    const double fu = dot(jet.u, along), fv = dot(jet.v, along);
    const double gu = dot(jet.u, across), gv = dot(jet.v, across);
    const double determinant = fu * gv - fv * gu;
    u -= (f * gv - g * fv) / determinant;
    v -= (fu * g - gu * f) / determinant;
  }
  return dot(jet_at(patch, u, v, 1).point - origin, normal);
}

/// How far the strip's extension over its border leaves the surface that it continues, at two
/// distances, one half of the other.
std::pair<double, double> leaves_by(const Strip& strip, const BezierSurface& a, double step) {
  const RationalBezierPatch& patch = a.patches(0, 0);
  const PatchJet jet = jet_at(patch, 1, 0.4, 1);
  const Vec3 normal = unit(cross(jet.u, jet.v)), along = unit(jet.v), across = cross(along, normal);
  const auto off = [&](double s) {
    return std::abs(
        height_over(patch, jet.point, along, across, normal, 1, 0.4, s) -
        height_over(strip.surface.patches(0, 0), jet.point, along, across, normal, 0.4, 0, s));
  };
  return {off(step), off(step / 2)};
}

// Taylor's rule: what agrees to order k leaves by the power k + 1 of the distance.
TEST_P(StripOrder, ContinuesASurfaceToItsOrder) {
  for (const double weight : {0.0, 0.3}) {
    std::mt19937 random(31);
    const BezierSurface a = random_surface(random, 0, 3, 2, 1, 1, weight);
    const BezierSurface b = random_surface(random, 5, 3, 2, 1, 1, weight);
    const Strip strip =
        strip_between(a, SurfaceSide::UMax, b, SurfaceSide::UMin, {.order = GetParam()});

    const auto [far, near] = leaves_by(strip, a, 0.02);

    EXPECT_NEAR(std::log2(far / near), GetParam() + 1, 0.3) << "weight " << weight;
  }
}

// All pairs of sides, all orders, degrees 1 to 7, one to three spans, polynomial and rational. The
// parameter is the seed.
class StripProperty : public ::testing::TestWithParam<int> {};

TEST_P(StripProperty, MeetsBothSurfacesToRounding) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  const auto pick = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const int order = pick(1, 3);
  const auto surface = [&](double x) {
    const double weight = pick(0, 1) * 0.3;
    const int most = weight == 0 ? 7 : 6;
    return random_surface(random, x, pick(1, most), pick(1, most), pick(1, 3), pick(1, 3), weight);
  };
  const BezierSurface a = surface(0), b = surface(6);
  const SurfaceSide side_a = static_cast<SurfaceSide>(GetParam() % 4);
  const SurfaceSide side_b = static_cast<SurfaceSide>(GetParam() / 4 % 4);

  const Strip strip = strip_between(a, side_a, b, side_b, {.order = order, .weight_b = 1.5});

  expect_smooth(strip, a, side_a, b, side_b);
  if (order == 1) return;
  for (const StripContact& contact : strip.contacts) EXPECT_LE(contact.curvature, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Seeds, StripProperty, ::testing::Range(0, 208));

}  // namespace
}  // namespace blossom
