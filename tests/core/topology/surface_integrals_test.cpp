// SPDX-License-Identifier: LGPL-2.1-or-later
// Areas, volumes and moments of trimmed surfaces beside closed forms.

#include "core/topology/surface_integrals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>
#include <vector>

#include "core/forms/spans/swept_surface.h"
#include "tests/support/flat_trims.h"

namespace blossom {
namespace {

constexpr double kNear = 1e-10;  // relative, as the header promises

IntegrandSurface plane(double height) {
  IntegrandSurface surface;
  surface.jet = [height](const Vec2& uv) {
    return SurfaceJet{{uv[0], uv[1], height}, {1, 0, 0}, {0, 1, 0}};
  };
  surface.u_knots = surface.v_knots = {-10, 10};
  surface.lines = DensityLines::Constant;
  return surface;
}

IntegrandSurface exact(const BezierSurface& spans, DensityLines lines) {
  return {spans, {}, spans.u_knots, spans.v_knots, lines};
}

FaceTrims rectangle(const Interval& u, const Interval& v) {
  testing::FlatLoops loops;
  loops.add_polygon({{u.from, v.from}, {u.to, v.from}, {u.to, v.to}, {u.from, v.to}});
  return testing::trims_of(loops);
}

const MeridianFrame kFrame{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TEST(TrimmedArea, OfAFaceWithAHoleLeavesTheHoleOut) {
  const FaceTrims trims = testing::square_without_disc();
  const double wanted = 16 - std::numbers::pi;
  EXPECT_NEAR(trimmed_area(plane(3), trims), wanted, kNear * wanted);
  EXPECT_NEAR(trimmed_cone_volume(plane(3), trims, {1, 1, 0}), wanted, kNear * wanted);
  EXPECT_NEAR(trimmed_cone_volume(plane(3), trims, {1, 1, 3}), 0, 1e-12);
}

// What is known of the surface's lines saves one integral, and changes nothing.
TEST(TrimmedArea, IsTheSameAlongKnownLinesAndWithoutThem) {
  const Interval u{0.2, 4}, v{-1, 1.2};
  const BezierSurface cylinder = turned_surface(straight_meridian(kFrame, 2, 0, 1, v), u);
  const BezierSurface sphere = turned_surface(circular_meridian(kFrame, 0, 2, v), u);
  const FaceTrims trims = rectangle(u, v);
  const double of_cylinder = 2 * length(u) * length(v);
  const double of_sphere = 4 * length(u) * (std::sin(v.to) - std::sin(v.from));
  for (const DensityLines lines : {DensityLines::Any, DensityLines::Even})
    EXPECT_NEAR(trimmed_area(exact(cylinder, lines), trims), of_cylinder, kNear * of_cylinder);
  for (const DensityLines lines : {DensityLines::Any, DensityLines::Turning}) {
    EXPECT_NEAR(trimmed_area(exact(sphere, lines), trims), of_sphere, kNear * of_sphere);
    EXPECT_NEAR(trimmed_cone_volume(exact(sphere, lines), trims, kFrame.origin), 2 * of_sphere / 3,
                kNear * of_sphere);
  }
}

// A part of 1e-4 by 0.1 of a strip whose coordinates are rounded to 1e-11 of its width: noise of
// normals must not ask for ever smaller cells.
TEST(TrimmedConeVolume, OfASliverIsFoundAtOnce) {
  constexpr int kDegree = 5;
  BezierSurface surface{{0, 3.1736e-4}, {0, 1}};
  surface.rational = true;
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  Grid<Vec4>& points = surface.patches(0, 0).points;
  points = Grid<Vec4>(kDegree + 1, 3);
  for (int i = 0; i <= kDegree; ++i)
    for (int j = 0; j < 3; ++j)
      points(i, j) = Vec4{9.7463210113984733 - 7.93e-5 * i + 7.7e-5 * j,
                          -8.878382604055334 - 0.049 * j - 9e-8 * (i + i * i),
                          j == 2 ? 0.119337 + 7.8e-6 * i : 0, 1} *
                     (j == 1 ? 0.63506821445238515 - 3.06e-5 * i : 1);
  const std::clock_t start = std::clock();  // of the processor: what else runs does not count
  const double volume = trimmed_cone_volume(
      exact(surface, DensityLines::Any), rectangle({1.269e-4, 1.9037e-4}, {0, 1}), {-12, -6.77, 0});
  EXPECT_GT(std::abs(volume), 1e-9);
  EXPECT_LT(static_cast<double>(std::clock() - start), 0.1 * CLOCKS_PER_SEC);
}

// Of a high degree with weights: normals at 1e7 are known no better than to 1e-7 there.
TEST(TrimmedArea, IsTheSameFarFromTheOrigin) {
  constexpr int kDegree = 13;
  const auto area_at = [&](double far) {
    BezierSurface surface{{0, 1}, {0, 1}};
    surface.rational = true;
    surface.patches = Grid<RationalBezierPatch>(1, 1);
    Grid<Vec4>& points = surface.patches(0, 0).points;
    points = Grid<Vec4>(kDegree + 1, 2);
    for (int i = 0; i <= kDegree; ++i)
      for (int j = 0; j < 2; ++j)
        points(i, j) =
            Vec4{far + 2 * std::cos(0.3 * i), 2 * std::sin(0.3 * i) - far, far + 3 * j, 1} *
            (1 + 0.5 * std::cos(i));
    return trimmed_area(exact(surface, DensityLines::Any), rectangle({0.1, 0.9}, {0.2, 0.7}));
  };
  EXPECT_NEAR(area_at(1e7), area_at(0), 1e-6);
}

TEST(TrimmedArea, IsNoneBeyondTheBorderOfTheSurface) {
  const BezierSurface cylinder = turned_surface(straight_meridian(kFrame, 2, 0, 1, {0, 3}), {0, 1});
  const FaceTrims trims = rectangle({-1e-3, 1}, {0, 3 + 1e-3});
  EXPECT_NEAR(trimmed_area(exact(cylinder, DensityLines::Any), trims), 6, 1e-8);
}

TEST(TrimmedConeMoments, OfAPyramidAreItsClosedForms) {
  const FaceTrims square = rectangle({0, 2}, {0, 1});
  const ConeMoments found = trimmed_cone_moments(plane(3), square, {});
  EXPECT_NEAR(found.volume, 2, 1e-12);
  // The centre of a cone is three quarters on the way to that of its base.
  EXPECT_LT(distance(found.first, 2 * 0.75 * Vec3{1, 0.5, 3}), 1e-11);
  // Over the base: the mean of x x is 4/3, of x y 1/2, of z z 9.
  EXPECT_NEAR(found.second[0], 2 * 0.6 * 4 / 3, 1e-11);
  EXPECT_NEAR(found.second[2], 2 * 0.6 * 9, 1e-11);
  EXPECT_NEAR(found.second[3], 2 * 0.6 * 0.5, 1e-11);
  const Vec3 moment = trimmed_area_moment(plane(3), square, {0, 0, 1});
  EXPECT_LT(distance(moment, 2 * Vec3{1, 0.5, 2}), 1e-11);
}

TEST(PolygonArea, CountsTrianglesWithTheirSigns) {
  const std::vector<Vec2> bent{{0, 0}, {4, 0}, {1, 1}, {0, 4}, {0, 0}};  // not convex
  EXPECT_NEAR(polygon_area(plane(0).jet, bent), 4, 1e-12);
}

}  // namespace
}  // namespace blossom
