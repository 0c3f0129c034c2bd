// SPDX-License-Identifier: LGPL-2.1-or-later
// Continuity across an edge: closed forms, bounds that hold, and figures that do not depend on how
// the faces are told.

#include "core/blending/continuity/continuity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "core/base/errors.h"
#include "core/blending/strips/strip.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

using std::numbers::pi;
constexpr std::array kWhole{0.0, 1.0};

RationalBezierPatch patch_of(int n, int m, const std::function<Vec4(int, int)>& point) {
  RationalBezierPatch patch{Grid<Vec4>(n + 1, m + 1)};
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) patch.points(i, j) = point(i, j);
  return patch;
}

BezierSurface surface_of(const RationalBezierPatch& patch) {
  BezierSurface surface;
  surface.u_knots = {0, 1};
  surface.v_knots = {0, 1};
  surface.patches = Grid<RationalBezierPatch>(1, 1, patch);
  for (const Vec4& point : patch.points.values()) surface.rational |= point[3] != 1;
  return surface;
}

/// The parallelogram from a corner with two sides; u along the first.
BezierSurface plane(const Vec3& corner, const Vec3& first, const Vec3& second) {
  return surface_of(patch_of(1, 1, [&](int i, int j) {
    const Vec3 p = corner + first * i + second * j;
    return Vec4{p[0], p[1], p[2], 1};
  }));
}

/// A surface of revolution round the z axis of an arc or line in the half-plane x > 0, z:
/// homogeneous (wx, wz, w). A quarter of a turn in u from the x axis on; v along the profile.
BezierSurface turned(const std::vector<Vec3>& profile) {
  const double c = std::sqrt(0.5);
  const std::array<Vec3, 3> arc{Vec3{1, 0, 1}, Vec3{c, c, c}, Vec3{0, 1, 1}};
  BezierSurface surface =
      surface_of(patch_of(2, static_cast<int>(profile.size()) - 1, [&](int i, int j) {
        const Vec3& a = arc[static_cast<std::size_t>(i)];
        const Vec3& p = profile[static_cast<std::size_t>(j)];
        return Vec4{a[0] * p[0], a[1] * p[0], a[2] * p[1], a[2] * p[2]};
      }));
  surface.u_knots = {0, pi / 2};
  surface.u_law = ParameterLaw::Angle;
  return surface;
}

/// The profile of a quarter of a circle round (x, z) from one angle on.
std::vector<Vec3> quarter(double x, double z, double radius, double from) {
  const double c = std::sqrt(0.5);
  std::vector<Vec3> profile;
  for (int k = 0; k <= 2; ++k) {
    const double angle = from + k * pi / 4, r = k == 1 ? radius / c : radius, w = k == 1 ? c : 1;
    profile.push_back({w * (x + r * std::cos(angle)), w * (z + r * std::sin(angle)), w});
  }
  return profile;
}

/// A quarter of the cylinder round the z axis, 0 <= z <= 1, with a linear parameter along z.
BezierSurface cylinder(double radius) { return turned({{radius, 0, 1}, {radius, 1, 1}}); }

BezierSurface scaled(BezierSurface surface, double factor) {
  for (RationalBezierPatch& patch : surface.patches.values())
    for (Vec4& p : patch.points.values())
      for (int c = 0; c < 3; ++c) p[c] *= factor;
  return surface;
}

/// A side of a surface and the direction of its parameter.
struct Beside {
  BezierSurface surface;
  SurfaceSide side;
  bool backward = false;

  EdgeSide at(double t) const {
    const bool along_v = side == SurfaceSide::UMin || side == SurfaceSide::UMax;
    const bool at_end = side == SurfaceSide::UMax || side == SurfaceSide::VMax;
    const std::vector<double>& knots = along_v ? surface.v_knots : surface.u_knots;
    const ParameterLaw law = along_v ? surface.v_law : surface.u_law;
    const double own = blossom::at({knots.front(), knots.back()}, backward ? 1 - t : t);
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, own);
    const int span = static_cast<int>(above - knots.begin()) - 1;
    const Interval place{*(above - 1), *above};
    const double local = local_parameter(law, place, own);
    const double speed = (backward ? -1 : 1) * (knots.back() - knots.front()) /
                         parameter_derivative(law, place, local);
    const Grid<RationalBezierPatch>& all = surface.patches;
    const int last = (along_v ? all.rows() : all.columns()) - 1;
    const RationalBezierPatch& patch =
        along_v ? all(at_end ? last : 0, span) : all(span, at_end ? last : 0);
    const double edge = at_end ? 1 : 0;
    EdgeSide result;
    result.jet = along_v ? jet_at(patch, edge, local, 2) : jet_at(patch, local, edge, 2);
    result.along = along_v ? Vec2{0, speed} : Vec2{speed, 0};
    result.left = (side == SurfaceSide::UMax || side == SurfaceSide::VMin) != backward;
    return result;
  }
  EdgeSides sides() const {
    return [*this](double t) { return at(t); };
  }
  BorderSpans spans() const { return border_spans(surface, side, backward); }
};

MeasuredContinuity measured(const Beside& a, const Beside& b, double flat = 1e-3) {
  return measured_continuity(a.sides(), b.sides(), kWhole, flat);
}

ContinuityBounds bounds(const Beside& a, const Beside& b, double flat = 1e-3) {
  const auto found = continuity_bounds(a.spans(), b.spans(), flat);
  EXPECT_TRUE(found.has_value());
  return found.value_or(ContinuityBounds{});
}

/// The bounds hold what was measured, and are no more than a tenth above it but for what nobody
/// will tell from 0.
void expect_close(const ContinuityBounds& bound, const MeasuredContinuity& found,
                  double rounding = 1e-10) {
  const auto check = [&](double upper, double lower, const char* what) {
    EXPECT_GE(upper * (1 + 1e-12) + 1e-15, lower) << what;
    EXPECT_LE(upper, 1.1 * lower + rounding) << what;
  };
  check(bound.gap, found.gap.value, "gap");
  check(bound.angle, found.angle.value, "angle");
  check(bound.difference, found.difference.value, "difference");
  check(bound.curvature, found.curvature.value, "curvature");
}

TEST(Continuity, PlaneTangentToACylinderIsG1AndApartByItsCurvature) {
  for (const double radius : {0.5, 2.0, 40.0}) {
    // The cylinder's line at angle 0, and the plane x = radius on the other side of it.
    const Beside tube{cylinder(radius), SurfaceSide::UMin};
    const Beside wall{plane({radius, 0, 0}, {0, -1, 0}, {0, 0, 1}), SurfaceSide::UMin};
    const MeasuredContinuity found = measured(tube, wall);
    EXPECT_LE(found.gap.value, 1e-15 * radius);
    EXPECT_LE(found.angle.value, 1e-15);
    EXPECT_NEAR(found.difference.value, 1 / radius, 1e-14 / radius);
    EXPECT_NEAR(found.curvature.value, 1, 1e-14);
    EXPECT_EQ(smoothness(found, {}), Smoothness::G1);
    const ContinuityBounds bound = bounds(tube, wall);
    expect_close(bound, found);
    EXPECT_NEAR(bound.difference, 1 / radius, 1e-11 / radius);
    EXPECT_TRUE(is_proven(Smoothness::G1, bound, {}));
    EXPECT_FALSE(is_proven(Smoothness::G2, bound, {}));
  }
}

TEST(Continuity, RadiusFarAboveTheSizeCountsAsFlat) {
  const Beside tube{cylinder(1e6), SurfaceSide::UMin};
  const Beside wall{plane({1e6, 0, 0}, {0, -1, 0}, {0, 0, 1}), SurfaceSide::UMin};
  EXPECT_NEAR(measured(tube, wall, 1e-3).curvature.value, 1e-3, 1e-9);
  EXPECT_NEAR(bounds(tube, wall, 1e-3).curvature, 1e-3, 1e-7);
}

TEST(Continuity, TorusFilletOfAShaftIsG1AndApartByTheFilletsCurvature) {
  // Shaft of radius 2 that ends in a fillet of radius 0.5 and a flange.
  const Beside shaft{turned({{2, 3, 1}, {2, 1, 1}}), SurfaceSide::VMax};
  const Beside fillet{turned(quarter(2.5, 1, 0.5, pi)), SurfaceSide::VMin};
  const MeasuredContinuity found = measured(shaft, fillet);
  EXPECT_LE(found.angle.value, 1e-14);
  EXPECT_NEAR(found.difference.value, 2, 1e-12);
  EXPECT_EQ(smoothness(found, {}), Smoothness::G1);
  expect_close(bounds(shaft, fillet), found);
}

TEST(Continuity, HalvesOfASphereAreG2) {
  const Beside south{turned(quarter(0, 0, 3, -pi / 2)), SurfaceSide::VMax};
  const Beside north{turned(quarter(0, 0, 3, 0)), SurfaceSide::VMin};
  const MeasuredContinuity found = measured(south, north);
  EXPECT_LE(found.curvature.value, 1e-13);
  EXPECT_EQ(smoothness(found, {}), Smoothness::G2);
  const ContinuityBounds bound = bounds(south, north);
  EXPECT_LE(bound.gap, 1e-13);
  EXPECT_LE(bound.angle, 1e-11);
  EXPECT_LE(bound.curvature, 1e-10);
  EXPECT_TRUE(is_proven(Smoothness::G2, bound, {}));
}

TEST(Continuity, MeridianIsMeasuredUpToThePoleButNotBoundedThere) {
  const Beside east{turned(quarter(0, 0, 3, 0)), SurfaceSide::UMin};
  Beside west = east;
  for (Vec4& p : west.surface.patches(0, 0).points.values()) p[1] = -p[1];
  const MeasuredContinuity found = measured(east, west);
  EXPECT_EQ(found.singular, 0);
  EXPECT_EQ(smoothness(found, {}), Smoothness::G2);
  const ContinuityBounds bound = bounds(east, west);
  EXPECT_LE(bound.gap, 1e-13);
  EXPECT_FALSE(std::isfinite(bound.angle));
  EXPECT_FALSE(is_proven(Smoothness::G2, bound, {}));
}

TEST(Continuity, BicubicCutInTwoIsG2WithoutAnyDifference) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> whole(-8, 8);
  const RationalBezierPatch patch = patch_of(3, 3, [&](int i, int j) {
    return Vec4{8.0 * i, 8.0 * j, 1.0 * whole(random), 1};
  });
  const Grid<RationalBezierPatch> cut = subdivide(patch, std::array{0.0, 0.5, 1.0}, kWhole);
  const Beside left{surface_of(cut(0, 0)), SurfaceSide::UMax},
      right{surface_of(cut(1, 0)), SurfaceSide::UMin};
  const MeasuredContinuity found = measured(left, right);
  EXPECT_EQ(found.gap.value, 0);
  EXPECT_LE(found.angle.value, 1e-15);
  EXPECT_LE(found.curvature.value, 1e-14);
  const ContinuityBounds bound = bounds(left, right);
  EXPECT_LE(bound.gap, 1e-12);
  EXPECT_LE(bound.angle, 1e-11);
  EXPECT_LE(bound.curvature, 1e-9);
}

TEST(Continuity, PlanesMeetAtTheirAngle) {
  for (const double angle : {1e-9, 1e-4, 0.3, pi / 2, 3.0}) {
    const Beside floor{plane({0, 0, 0}, {-1, 0, 0}, {0, 1, 0}), SurfaceSide::UMin};
    const Beside ramp{plane({0, 0, 0}, {std::cos(angle), 0, std::sin(angle)}, {0, 1, 0}),
                      SurfaceSide::UMin};
    const MeasuredContinuity found = measured(floor, ramp);
    EXPECT_NEAR(found.angle.value, angle, 1e-15);
    EXPECT_NEAR(bounds(floor, ramp).angle, angle, 1e-11);
    EXPECT_EQ(smoothness(found, {}), angle <= 1e-3 ? Smoothness::G2 : Smoothness::G0);
  }
}

TEST(Continuity, FaceThatFoldsBackIsAHalfTurnAway) {
  const Beside floor{plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), SurfaceSide::UMin};
  const Beside above{plane({0, 0, 0}, {2, 0, 0}, {0, 1, 0}), SurfaceSide::UMin};
  EXPECT_NEAR(measured(floor, above).angle.value, pi, 1e-15);
}

TEST(Continuity, GapIsThatBetweenTheBorders) {
  for (const double gap : {1e-9, 1e-4, 0.2}) {
    const Beside left{plane({0, 0, 0}, {-1, 0, 0}, {0, 1, 0}), SurfaceSide::UMin};
    const Beside right{plane({0, 0, gap}, {1, 0, 0}, {0, 1, 0}), SurfaceSide::UMin};
    const MeasuredContinuity found = measured(left, right);
    EXPECT_NEAR(found.gap.value, gap, 1e-16);
    EXPECT_LE(found.angle.value, 1e-15);
    EXPECT_NEAR(bounds(left, right).gap, gap, 1e-13);
    EXPECT_EQ(smoothness(found, {}), gap <= 1e-3 ? Smoothness::G2 : Smoothness::None);
  }
}

TEST(Continuity, BordersWithOtherParametersAreComparedWhereTheyAreNear) {
  const Beside left{plane({0, 0, 0}, {-1, 0, 0}, {0, 1, 0}), SurfaceSide::UMin};
  const Beside right{plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), SurfaceSide::UMin};
  const EdgeSides late = [&](double t) {
    EdgeSide side = right.at(t + 0.3 * t * (1 - t));
    side.along = side.along * (1.3 - 0.6 * t);
    return side;
  };
  EXPECT_LE(measured_continuity(left.sides(), late, kWhole, 1e-3).gap.value, 1e-15);
}

/// A random surface over [0, s] x [0, 1] with the given border u = 0.
BezierSurface wavy(std::mt19937& random, double s, int n, int m, double weight,
                   const std::vector<Vec4>& border) {
  std::uniform_real_distribution<double> noise(-1, 1);
  return surface_of(patch_of(n, m, [&](int i, int j) {
    if (i == 0) return border[static_cast<std::size_t>(j)];
    const double w = 1 + weight * noise(random);
    return Vec4{w * s * i / n, w * (1.0 * j / m + 0.05 * noise(random)), w * 0.2 * noise(random),
                w};
  }));
}

class ContinuityProperty : public ::testing::TestWithParam<int> {
 protected:
  std::mt19937 random_{static_cast<unsigned>(GetParam())};
  std::uniform_real_distribution<double> noise_{-1, 1};

  /// Two surfaces that share a border and nothing else.
  std::array<Beside, 2> pair() {
    const int m = 1 + GetParam() % 5;
    const double weight = GetParam() % 2 == 0 ? 0.0 : 0.3;
    std::vector<Vec4> border;
    for (int j = 0; j <= m; ++j) {
      const double w = 1 + weight * noise_(random_);
      border.push_back({0.1 * w * noise_(random_), w * j / m, 0.1 * w * noise_(random_), w});
    }
    const int n = 1 + GetParam() % 3;
    return {Beside{wavy(random_, 1, n, m, weight, border), SurfaceSide::UMin},
            Beside{wavy(random_, -1, 4 - n, m, weight, border), SurfaceSide::UMin}};
  }
};

TEST_P(ContinuityProperty, BoundsAreAboveAllValuesAndNear) {
  const auto [a, b] = pair();
  expect_close(bounds(a, b), measured(a, b));
}

TEST_P(ContinuityProperty, FiguresDoNotDependOnOrderDirectionOrOrientation) {
  const auto [a, b] = pair();
  const MeasuredContinuity found = measured(a, b);
  Beside a_back = a, b_back = b;
  a_back.backward = b_back.backward = true;
  const auto turned_over = [](const Beside& of) -> EdgeSides {
    return [of](double t) {
      EdgeSide side = of.at(t);
      std::swap(side.jet.u, side.jet.v);
      std::swap(side.jet.uu, side.jet.vv);
      std::swap(side.along[0], side.along[1]);
      side.left = !side.left;
      return side;
    };
  };
  for (const MeasuredContinuity& other :
       {measured(b, a), measured(a_back, b_back),
        measured_continuity(turned_over(a), b.sides(), kWhole, 1e-3)}) {
    EXPECT_NEAR(other.gap.value, found.gap.value, 1e-14);
    EXPECT_NEAR(other.angle.value, found.angle.value, 1e-9);
    EXPECT_NEAR(other.difference.value, found.difference.value, 1e-9 * found.difference.value);
    EXPECT_NEAR(other.curvature.value, found.curvature.value, 1e-9);
  }
  const ContinuityBounds bound = bounds(a, b), swapped = bounds(b_back, a_back);
  EXPECT_NEAR(swapped.angle, bound.angle, 0.1 * bound.angle);
  EXPECT_NEAR(swapped.difference, bound.difference, 0.1 * bound.difference);
}

TEST_P(ContinuityProperty, ScalingScalesLengthsAlone) {
  const auto [a, b] = pair();
  const MeasuredContinuity found = measured(a, b);
  for (const double factor : {1e-3, 1e3}) {
    const Beside big_a{scaled(a.surface, factor), a.side}, big_b{scaled(b.surface, factor), b.side};
    const MeasuredContinuity other = measured(big_a, big_b, 1e-3 / factor);
    EXPECT_NEAR(other.angle.value, found.angle.value, 1e-9);
    EXPECT_NEAR(other.difference.value * factor, found.difference.value,
                1e-9 * found.difference.value);
    EXPECT_NEAR(other.curvature.value, found.curvature.value, 1e-9);
    expect_close(bounds(big_a, big_b, 1e-3 / factor), other, 1e-10 * std::max(factor, 1 / factor));
  }
}

TEST_P(ContinuityProperty, SpansGiveTheSurfacesOwnFigures) {
  const auto [a, b] = pair();
  const MeasuredContinuity own = measured(a, b);
  const MeasuredContinuity of_spans =
      measured_continuity(edge_sides(a.spans()), edge_sides(b.spans()), kWhole, 1e-3);
  EXPECT_NEAR(of_spans.angle.value, own.angle.value, 1e-12);
  EXPECT_NEAR(of_spans.difference.value, own.difference.value, 1e-9 * own.difference.value);
  EXPECT_NEAR(of_spans.curvature.value, own.curvature.value, 1e-9);
}

TEST(Continuity, SpansOfArcsRunWithTheAngle) {
  for (const bool backward : {false, true}) {
    const Beside tube{cylinder(2), SurfaceSide::VMin, backward};
    const EdgeSides sides = edge_sides(tube.spans());
    for (const double x : {0.0, 0.2, 0.7, 1.0}) {
      const EdgeSide ours = sides(x), theirs = tube.at(x);
      EXPECT_LE(distance(ours.jet.point, theirs.jet.point), 1e-15);
      const Vec3 along = ours.along[0] * ours.jet.u + ours.along[1] * ours.jet.v;
      const Vec3 own = theirs.along[0] * theirs.jet.u + theirs.along[1] * theirs.jet.v;
      EXPECT_LE(distance(along, own), 1e-14);
    }
  }
}

TEST_P(ContinuityProperty, StripsAreProvenToBeG1) {
  const auto [a, unused] = pair();
  BezierSurface far = a.surface;
  for (Vec4& p : far.patches(0, 0).points.values()) {
    p[0] = -p[0] - 2 * p[3];
    p[2] += 0.5 * p[3] + 0.3 * p[1];
  }
  const Strip strip = strip_between(a.surface, SurfaceSide::UMin, far, SurfaceSide::UMin);
  const Beside first{strip.surface, SurfaceSide::VMin},
      last{strip.surface, SurfaceSide::VMax, strip.backward};
  for (const auto& [side, face] :
       {std::pair{first, a}, std::pair{last, Beside{far, SurfaceSide::UMin}}}) {
    const ContinuityBounds bound = bounds(face, side);
    EXPECT_LE(bound.gap, 1e-11);
    EXPECT_LE(bound.angle, 1e-10);
    EXPECT_LE(measured(face, side).angle.value, 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ContinuityProperty, ::testing::Range(0, 30));

TEST(Continuity, BoundsOfAPlaneAlongAnArcAreThoseOfItsCircle) {
  // The cap of a cylinder, as a plane left of the arc of its border, against the cylinder.
  const Beside tube{cylinder(2), SurfaceSide::VMin};
  const double c = std::sqrt(0.5);
  CurveSpans arc;
  arc.rational = true;
  arc.spans = {
      {{{{2, 0, 0, 1}, {2 * c, 2 * c, 0, c}, {0, 2, 0, 1}}}, {0, pi / 2}, ParameterLaw::Angle}};
  const auto bound = continuity_bounds(plane_border(arc, {0, 0, 1}, false), tube.spans(), 1e-3);
  ASSERT_TRUE(bound.has_value());
  EXPECT_LE(bound->gap, 1e-13);
  EXPECT_NEAR(bound->angle, pi / 2, 1e-11);
}

TEST(Continuity, BoundsAreRefusedWhereParametersDoNotCorrespond) {
  const Beside tube{cylinder(2), SurfaceSide::VMin};
  BezierSurface rational = tube.surface;
  rational.u_law = ParameterLaw::Linear;
  EXPECT_FALSE(continuity_bounds(tube.spans(), Beside{rational, SurfaceSide::VMin}.spans(), 1e-3));
  BezierSurface longer = tube.surface;
  longer.u_knots.back() += 0.1;
  EXPECT_FALSE(continuity_bounds(tube.spans(), Beside{longer, SurfaceSide::VMin}.spans(), 1e-3));
}

TEST(Continuity, SpansOfTwoBordersMeetAtAllBreaks) {
  // A bend at y = 1/3 on one side, at y = 1/2 on the other.
  const auto bent = [](double sign, double at, double angle) {
    BezierSurface surface = plane({0, 0, 0}, {sign, 0, 0}, {0, at, 0});
    const BezierSurface rest =
        plane({0, at, 0}, {sign * std::cos(angle), 0, std::sin(angle)}, {0, 1 - at, 0});
    surface.v_knots = {0, at, 1};
    Grid<RationalBezierPatch> patches(1, 2);
    patches(0, 0) = surface.patches(0, 0);
    patches(0, 1) = rest.patches(0, 0);
    surface.patches = patches;
    return Beside{surface, SurfaceSide::UMin};
  };
  EXPECT_NEAR(bounds(bent(1, 1.0 / 3, 0.1), bent(-1, 0.5, 0.2)).angle, 0.3, 1e-12);
  EXPECT_NEAR(bounds(bent(1, 1.0 / 3, 0.1), bent(-1, 0.5, -0.05)).angle, 0.1, 1e-12);
}

TEST(Continuity, RefusesBreaksThatDoNotIncreaseAndNoFlatness) {
  const Beside left{plane({0, 0, 0}, {-1, 0, 0}, {0, 1, 0}), SurfaceSide::UMin};
  const auto measure = [&](std::vector<double> breaks, double flat) {
    return measured_continuity(left.sides(), left.sides(), breaks, flat);
  };
  EXPECT_THROW(measure({0}, 1), InvalidInput);
  EXPECT_THROW(measure({0, 0.5, 0.5, 1}, 1), InvalidInput);
  EXPECT_THROW(measure({0, std::nan("")}, 1), InvalidInput);
  EXPECT_THROW(measure({0, 1}, 0), InvalidInput);
  EXPECT_THROW(continuity_bounds(left.spans(), left.spans(), -1), InvalidInput);
  EXPECT_THROW(edge_sides({}), InvalidInput);
  EXPECT_THROW(border_spans(BezierSurface{}, SurfaceSide::UMin, false), InvalidInput);
  EXPECT_THROW(plane_border(CurveSpans{}, {0, 0, 1}, false), InvalidInput);
}

TEST(Continuity, SurfaceWithoutNormalsHasOnlyAGap) {
  const Beside left{plane({0, 0, 0}, {-1, 0, 0}, {0, 1, 0}), SurfaceSide::UMin};
  const Beside crushed{plane({0, 0, 0}, {0, 0, 0}, {0, 1, 0}), SurfaceSide::UMin};
  const MeasuredContinuity found = measured(left, crushed);
  EXPECT_EQ(found.singular, found.samples);
  EXPECT_EQ(smoothness(found, {}), Smoothness::G0);
  EXPECT_FALSE(std::isfinite(bounds(left, crushed).angle));
}

}  // namespace
}  // namespace blossom
