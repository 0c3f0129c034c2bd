// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/self_intersection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/forms/algebra/conversion.h"
#include "tests/support/random.h"
#include "tests/support/solids.h"
#include "tests/support/spline_surfaces.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::extruded;
using testing::moved;
using testing::Random;
using testing::seeded;
using testing::uniform;
using testing::uniform_cubic;

// Every sample is one point at two different places of the surface, and the splines are as near
// to it as the report says.
void expect_sound(const SurfaceIntersection& found, const BezierSurface& surface,
                  double off = 1e-9) {
  for (const IntersectionCurve& curve : found.curves) {
    EXPECT_GE(curve.samples.size(), 48u);
    EXPECT_TRUE(curve.deviation.proven);
    EXPECT_LE(std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}), 1e-7);
    for (const SurfacePoint& x : curve.samples) {
      EXPECT_LE(distance(point_at(surface, x.uv_a), x.point), off);
      EXPECT_LE(distance(point_at(surface, x.uv_b), x.point), off);
    }
  }
}

void expect_nothing(const BezierSurface& surface) {
  const SurfaceIntersection found = self_intersect(surface);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.curves.empty());
  EXPECT_TRUE(found.points.empty());
  EXPECT_TRUE(found.places.empty());
  for (const std::string& reason : found.certificate.reasons) ADD_FAILURE() << reason;
}

// The largest |normal . x - height| of the samples.
double off_plane(const SurfaceIntersection& found, const Vec3& normal, double height) {
  double off = 0;
  for (const IntersectionCurve& curve : found.curves)
    for (const SurfacePoint& x : curve.samples)
      off = std::max(off, std::abs(dot(normal, x.point) - height));
  return off;
}

// (t^2, t^3 - t, 0), t = -1.5 .. 1.5, crosses itself at t = -1 and 1, in (1, 0, 0).
std::vector<Vec3> alpha_curve() {
  return {{2.25, -1.875, 0}, {-0.75, 3.875, 0}, {-0.75, -3.875, 0}, {2.25, 1.875, 0}};
}

TEST(SelfIntersection, LoopMovedAlongALineMeetsItselfInOneLine) {
  const BezierSurface surface = extruded(alpha_curve(), {0, 0, 2});
  const SurfaceIntersection found = self_intersect(surface);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.places.empty());
  ASSERT_EQ(found.curves.size(), 1u);
  expect_sound(found, surface);
  const IntersectionCurve& line = found.curves.front();
  EXPECT_FALSE(line.closed);
  EXPECT_NEAR(line.length, 2, 1e-9);
  EXPECT_LE(off_plane(found, {1, 0, 0}, 1), 1e-9);
  EXPECT_LE(off_plane(found, {0, 1, 0}, 0), 1e-9);
  EXPECT_NEAR(line.samples[10].uv_a[0], 1.0 / 6, 1e-9);
  EXPECT_NEAR(line.samples[10].uv_b[0], 5.0 / 6, 1e-9);
}

// A lemniscate by points of its net. Half a turn about the origin reverses it, and leaves two of
// its parameters where they are, both in the middle of a span: so it passes the origin twice.
BezierSurface figure_eight(bool closed, double slope) {
  constexpr int kPoints = 16;
  Grid<Vec3> net(closed ? kPoints : kPoints + 1, 5);
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < 5; ++j) {
      const double t = 2 * std::numbers::pi * (i + 0.5) / kPoints;
      net(i, j) = {std::sin(t) + slope * j, std::sin(2 * t), static_cast<double>(j)};
    }
  return uniform_cubic(net, closed, false);
}

TEST(SelfIntersection, FigureEightMovedAlongALineMeetsItselfInItsAxis) {
  for (const double slope : {0.0, 0.3}) {
    const BezierSurface surface = figure_eight(true, slope);
    const SurfaceIntersection found = self_intersect(surface);
    EXPECT_EQ(found.status, Status::Complete);
    ASSERT_EQ(found.curves.size(), 1u);
    expect_sound(found, surface);
    EXPECT_NEAR(found.curves.front().length, 2 * std::hypot(1, slope), 1e-9);
    EXPECT_LE(off_plane(found, {1, 0, -slope}, 0), 1e-9);
    EXPECT_LE(off_plane(found, {0, 1, 0}, 0), 1e-9);
  }
}

// (u, u v, v^2) over [-1, 1]^2 meets itself in u = 0, z = v^2, and has a pinch point.
BezierSurface whitney_umbrella() {
  RationalBezierPatch patch{Grid<Vec4>(2, 3)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 3; ++j) {
      const double u = 2 * i - 1, v = j - 1;
      patch.points(i, j) = {u, u * v, j == 1 ? -1.0 : 1.0, 1};
    }
  return testing::of_patch(patch);
}

TEST(SelfIntersection, WhitneyUmbrellaHasALineThatEndsInItsPinchPoint) {
  const BezierSurface surface = whitney_umbrella();
  const SurfaceIntersection found = self_intersect(surface);
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.curves.size(), 1u);
  expect_sound(found, surface);
  EXPECT_NEAR(found.curves.front().length, 1, 1e-6);
  ASSERT_EQ(found.places.size(), 1u);
  const Place& place = found.places.front();
  EXPECT_EQ(place.kind, PlaceKind::Cusp);
  for (int k = 0; k < 3; ++k) {
    EXPECT_LE(place.box_low[k], 0);
    EXPECT_GE(place.box_high[k], 0);
    EXPECT_LE(place.box_high[k] - place.box_low[k], 1e-6);
  }
  const auto& ends = found.curves.front().ends;
  EXPECT_EQ(std::count(ends.begin(), ends.end(), CurveEnd::Place), 1);
}

// The umbrella, its parameters turned and scaled by an affine map: (a, b) -> (u, v).
BezierSurface askew_umbrella() {
  const double p = 0.43, q = 0.61;  // the pinch point's parameters
  MonomialPatch patch{Grid<Vec3>(3, 3)};
  // u = 2 (a - p) + (b - q), v = (b - q) - (a - p)
  const auto u = [](int i, int j) { return i == 1 && j == 0 ? 2.0 : i == 0 && j == 1 ? 1.0 : 0.0; };
  const auto v = [](int i, int j) {
    return i == 1 && j == 0 ? -1.0 : i == 0 && j == 1 ? 1.0 : 0.0;
  };
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      patch.coefficients(i, j)[0] += u(i, j);
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l) {
          patch.coefficients(i + k, j + l)[1] += u(i, j) * v(k, l);
          patch.coefficients(i + k, j + l)[2] += v(i, j) * v(k, l);
        }
    }
  patch.centre_u = p;
  patch.centre_v = q;
  const BezierPatch points = bezier_form(patch);
  RationalBezierPatch result{Grid<Vec4>(3, 3)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vec3& x = points.points(i, j);
      result.points(i, j) = {x[0], x[1], x[2], 1};
    }
  return testing::of_patch(result);
}

TEST(SelfIntersection, PinchPointMayLieAskewToTheParameters) {
  const BezierSurface surface = askew_umbrella();
  const SurfaceIntersection found = self_intersect(surface);
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.curves.size(), 1u);
  expect_sound(found, surface);
  EXPECT_LE(off_plane(found, {1, 0, 0}, 0), 1e-9);
  EXPECT_LE(off_plane(found, {0, 1, 0}, 0), 1e-9);
  ASSERT_EQ(found.places.size(), 1u);
  EXPECT_EQ(found.places.front().kind, PlaceKind::Cusp);
  EXPECT_LE(distance(found.places.front().box_low, found.places.front().box_high), 1e-4);
}

// A cubic with a cusp, moved along a line: the proof fails all along an edge.
TEST(SelfIntersection, CuspidalEdgeStaysOpen) {
  // (t^2, t^3), t = -0.9 .. 1.1.
  const BezierSurface surface =
      extruded({{0.81, -0.729, 0}, {-0.39, 0.891, 0}, {-0.77 / 3, -1.089, 0}, {1.21, 1.331, 0}},
               {0, 0, 0.5});
  const SurfaceIntersection found = self_intersect(surface);
  EXPECT_EQ(found.status, Status::Stopped);
  EXPECT_TRUE(found.curves.empty());
  ASSERT_FALSE(found.places.empty());
  EXPECT_EQ(found.places.front().kind, PlaceKind::Open);
}

// A fold whose two legs touch along a line: x = t (1 - t^2), y = t^4 - 2 t^2 passes (0, -1) with
// the same tangent at t = -1 and 1.
TEST(SelfIntersection, LegsThatTouchAreOneTangentialCurve) {
  // t = -1.5 .. 1.5; point k is the blossom at 4 - k copies of -1.5 and k of 1.5.
  std::vector<Vec3> curve;
  for (int k = 0; k <= 4; ++k) {
    std::array<double, 5> sigma{1, 0, 0, 0, 0};  // elementary symmetric polynomials
    for (int i = 0; i < 4; ++i)
      for (std::size_t n = 4; n > 0; --n) sigma[n] += (i < k ? 1.5 : -1.5) * sigma[n - 1];
    curve.push_back({sigma[1] / 4 - sigma[3] / 4, sigma[4] - 2 * sigma[2] / 6, 0});
  }
  const BezierSurface surface = extruded(curve, {0, 0, 1});
  const SurfaceIntersection found = self_intersect(surface);
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_TRUE(found.curves.front().tangential);
  EXPECT_NEAR(found.curves.front().length, 1, 1e-9);
  expect_sound(found, surface);
}

// Bicubic patches with random nets have pinch points and loops; nothing may be wrong about them.
TEST(SelfIntersection, CurvesOfRandomPatchesLieOnThem) {
  int complete = 0, curves = 0;
  for (int seed = 0; seed < 20; ++seed) {
    Random random = seeded(1000 + seed);
    RationalBezierPatch patch{Grid<Vec4>(4, 4)};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        patch.points(i, j) = {i + uniform(random, -2, 2), j + uniform(random, -2, 2),
                              uniform(random, -2, 2), 1};
    const BezierSurface surface = testing::of_patch(patch);
    const SurfaceIntersection found = self_intersect(surface);
    SCOPED_TRACE(seed);
    expect_sound(found, surface);
    complete += found.status == Status::Complete;
    curves += static_cast<int>(found.curves.size());
  }
  EXPECT_GE(complete, 4);
  EXPECT_GE(curves, 15);
}

// A quarter of a tube bent to radius 1 and moved inwards by 1.6: past its centre in the middle.
// The net of the offset is fitted, so only its symmetry is exact.
BezierSurface offset_valley(double by) {
  Grid<Vec3> net(21, 8);
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) {
      const double x = 0.2 * (i - 10), y = 0.3 * j;  // z = x^2 / 2, radius of curvature 1
      const Vec3 normal = unit(Vec3{-x, 0, 1});
      net(i, j) = Vec3{x, y, x * x / 2} + normal * by;
    }
  return uniform_cubic(net, false, false);
}

TEST(SelfIntersection, OffsetBeyondTheRadiusOfCurvatureCrossesItselfInItsPlaneOfSymmetry) {
  const BezierSurface surface = offset_valley(1.6);
  const SurfaceIntersection found = self_intersect(surface);
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.curves.size(), 1u);
  expect_sound(found, surface);
  EXPECT_NEAR(found.curves.front().length, 0.3 * 5, 1e-9);
  EXPECT_LE(off_plane(found, {1, 0, 0}, 0), 1e-9);
  expect_nothing(offset_valley(0.6));
}

// A tube along a loop in the x-y plane that crosses itself once, thicker at one of the passes.
BezierSurface crossing_tube() {
  constexpr int kAlong = 24, kRound = 8;
  Grid<Vec3> net(kAlong, kRound);
  for (int i = 0; i < kAlong; ++i) {
    const double t = 2 * std::numbers::pi * (i + 0.4) / kAlong;
    const Vec3 centre{2 * std::sin(t), std::sin(2 * t), 0};
    const Vec3 tangent = unit(Vec3{2 * std::cos(t), 2 * std::cos(2 * t), 0});
    const Vec3 side{-tangent[1], tangent[0], 0};
    const double radius = 0.25 + 0.08 * std::cos(t);
    for (int j = 0; j < kRound; ++j) {
      const double s = 2 * std::numbers::pi * (j + 0.2) / kRound;
      net(i, j) = centre + side * (radius * std::cos(s)) + Vec3{0, 0, radius * std::sin(s)};
    }
  }
  return uniform_cubic(net, true, true);
}

// Both go round the tube, so they begin and end in its seam.
TEST(SelfIntersection, TubeThroughItselfHasTwoLoops) {
  const BezierSurface surface = crossing_tube();
  const SurfaceIntersection found = self_intersect(surface);
  EXPECT_EQ(found.status, Status::Complete);
  expect_sound(found, surface);
  EXPECT_EQ(found.curves.size(), 2u);
  for (const IntersectionCurve& curve : found.curves) {
    EXPECT_LE(distance(curve.samples.front().point, curve.samples.back().point), 1e-9);
    EXPECT_NEAR(std::abs(curve.samples.front().uv_a[1] - curve.samples.back().uv_a[1]), 8, 1e-9);
  }
}

// Counts and lengths by construction; random motions leave no symmetry of the places in the nets.
struct Known {
  BezierSurface surface;
  std::size_t curves;
  double length;  // of all; 0: not known
  Status status;
};

TEST(SelfIntersection, OfKnownSurfacesIsTheSameInAnyPlace) {
  Random random = seeded(3);
  for (int trial = 0; trial < 6; ++trial) {
    const double slope = uniform(random, -1, 1);
    const std::array<Known, 6> all{
        Known{extruded(alpha_curve(), {slope, 0.3, 2}), 1, 0, Status::Complete},
        {figure_eight(true, slope), 1, 2 * std::hypot(1, slope), Status::Complete},
        {whitney_umbrella(), 1, 1, Status::Tolerance},
        {offset_valley(uniform(random, 1.1, 2)), 1, 1.5, Status::Complete},
        {offset_valley(uniform(random, -1, 0.9)), 0, 0, Status::Complete},
        {crossing_tube(), 2, 0, Status::Complete}};
    for (const Known& known : all) {
      SCOPED_TRACE(std::to_string(trial) + ", surface " + std::to_string(&known - all.data()));
      const BezierSurface surface = moved(known.surface, testing::random_motion(random));
      const SurfaceIntersection found = self_intersect(surface);
      EXPECT_EQ(found.status, known.status);
      EXPECT_EQ(found.curves.size(), known.curves);
      expect_sound(found, surface, 4e-9);  // 1e-9 of the size
      double length = 0;
      for (const IntersectionCurve& curve : found.curves) length += curve.length;
      if (known.length > 0) {
        EXPECT_NEAR(length, known.length, 2e-6);
      }
    }
  }
}

TEST(SelfIntersection, ClosedSurfacesDoNotMeetThemselves) {
  expect_nothing(testing::torus(2, 0.5));
  expect_nothing(testing::unit_sphere());
  expect_nothing(testing::revolved_circle(1.5, 1, -1, 2));
}

// A height over the unit square with weights: u and v are exact.
BezierSurface random_height_field(Random& random, double height, bool rational) {
  const int n = testing::pick(random, 1, 5), m = testing::pick(random, 1, 5);
  Grid<double> weight(n + 1, m + 1, 1.0);
  if (rational)
    for (double& w : weight.values()) w = uniform(random, 0.4, 2.5);
  // w, w u and w v of degrees n + 1 and m + 1.
  RationalBezierPatch patch{Grid<Vec4>(n + 2, m + 2)};
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j)
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l) {
          // B_i^n times 1 - u or u is this part of B_(i + k)^(n + 1).
          const double part = (k == 0 ? n + 1.0 - i : i + 1.0) / (n + 1) *
                              (l == 0 ? m + 1.0 - j : j + 1.0) / (m + 1) * weight(i, j);
          Vec4& p = patch.points(i + k, j + l);
          p = p + Vec4{k * part, l * part, 0, part};
        }
  for (Vec4& p : patch.points.values()) p[2] = p[3] * uniform(random, -height, height);
  return testing::of_patch(patch);
}

BezierSurface random_spline_field(Random& random, double height) {
  Grid<Vec3> net(testing::pick(random, 4, 9), testing::pick(random, 4, 9));
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j)
      net(i, j) = {static_cast<double>(i), static_cast<double>(j),
                   uniform(random, -height, height)};
  return uniform_cubic(net, false, false);
}

TEST(SelfIntersection, HeightFieldsDoNotMeetThemselves) {
  Random random = seeded(7);
  for (int trial = 0; trial < 500; ++trial) {
    const double height = std::pow(10, uniform(random, -4, 1));
    BezierSurface surface = trial % 3 == 0 ? random_spline_field(random, height)
                                           : random_height_field(random, height, trial % 3 == 1);
    if (trial % 2 == 0) surface = moved(surface, testing::random_motion(random));
    SCOPED_TRACE(trial);
    expect_nothing(surface);
  }
}

TEST(SelfIntersection, RefusesWhatIsNoSurfaceOrNoTolerance) {
  BezierSurface surface = whitney_umbrella();
  IntersectionOptions options;
  options.tolerances.point = 0;
  EXPECT_THROW(self_intersect(surface, options), InvalidInput);
  surface.u_knots = {1, 0};
  EXPECT_THROW(self_intersect(surface), InvalidInput);
}

}  // namespace
}  // namespace blossom
