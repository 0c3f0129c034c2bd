// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/ball_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/blending/balls/chart_cell.h"
#include "core/forms/evaluation.h"
#include "tests/support/ball_shapes.h"
#include "tests/support/spline_surfaces.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::floor_face;
using testing::plane_patch;
using testing::wall_face;
using testing::whole_cylinder;

using std::numbers::pi;

BallTrack edge_track(const BezierSurface& floor, const BezierSurface& wall, double r) {
  const BallSupport a = whole_support(floor, 1), b = whole_support(wall, 1);
  const auto start = ball_beside_edge(a, b, r, {Vec2{0.5, 1}, Vec2{0.5, 0}});
  if (!start) throw InvalidInput("no ball beside the edge");
  return track_through(a, b, r, *start).value();
}

// Two planes along the x axis that meet at an angle; the first is the floor z = 0.
struct Wedge {
  BezierSurface floor, wall;

  explicit Wedge(double angle)
      : floor(plane_patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 3}, {0, 10})),
        wall(plane_patch({0, 0, 0}, {1, 0, 0}, {0, std::cos(angle), std::sin(angle)}, {0, 3},
                         {0, 10})) {}

  BallTrack track(double r) const {
    return track_through(whole_support(floor, 1), whole_support(wall, -1), r,
                         {Vec2{1, 1}, Vec2{1, 1}})
        .value();
  }
  BallTrack track(const RadiusLaw& law) const {
    const BallGuide guide{[](double x) { return CurveJet{{x, 0, 0}, {1, 0, 0}, {}}; }, {0.5, 2.5}};
    return track_through(whole_support(floor, 1), whole_support(wall, -1), law, guide, 1,
                         {Vec2{1, 0.3}, Vec2{1, 0.3}})
        .value();
  }
};

// Largest distance of points of the strip from where `off` is 0.
template <class Off>
double worst_of(const BezierSurface& surface, const Off& off, int count = 20) {
  double worst = 0;
  for (int i = 0; i <= count; ++i)
    for (int j = 0; j <= count; ++j) {
      const double u = at({surface.u_knots.front(), surface.u_knots.back()}, double(i) / count);
      worst = std::max(worst, std::abs(off(point_at(surface, {u, double(j) / count}))));
    }
  return worst;
}

TEST(BallStrip, BetweenPlanesIsACylinder) {
  for (const double angle : {0.3, pi / 2, 2.5}) {
    const Wedge wedge(angle);
    const double r = 0.4, d = r / std::tan(angle / 2);
    const BallTrack track = wedge.track(r);

    const BallStrip strip = ball_strip(track, track.domain());

    ASSERT_TRUE(strip.analytic);
    const AnalyticStrip& a = *strip.analytic;
    EXPECT_EQ(a.surface.kind, ElementaryKind::Cylinder);
    EXPECT_NEAR(a.surface.radius, r, 1e-14);
    EXPECT_NEAR(length(a.along), 3, 1e-12);
    EXPECT_NEAR(std::abs(length(a.across)), pi - angle, 1e-12);
    EXPECT_LT(distance(a.x, Vec3{0, 0, -1}), 1e-14);
    EXPECT_EQ(strip.poles.rows(), 6);  // one span
    EXPECT_EQ(strip.surface.patches.columns(), 1);
    EXPECT_EQ(strip.poles.columns(), angle < pi / 3 ? 5 : 3);
    EXPECT_LT(
        worst_of(strip.surface, [&](const Vec3& p) { return std::hypot(p[1] - d, p[2] - r) - r; }),
        1e-13);
  }
}

TEST(BallStrip, RoundACylinderOnAPlateIsATorus) {
  const double R = 1.5, r = 0.4;
  const BezierSurface plate = plane_patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-5, 5}, {-5, 5});
  const BezierSurface cylinder = whole_cylinder(R, 3);
  const BallTrack track = track_through(whole_support(plate, 1), whole_support(cylinder, 1), r,
                                        {Vec2{0.3, 2}, Vec2{1.3, 0.5}})
                              .value();

  const BallStrip strip = ball_strip(track, track.domain());

  ASSERT_TRUE(strip.analytic);
  const AnalyticStrip& a = *strip.analytic;
  EXPECT_TRUE(strip.closed);
  EXPECT_EQ(a.surface.kind, ElementaryKind::Torus);
  EXPECT_NEAR(a.surface.radius, R + r, 1e-13);
  EXPECT_NEAR(a.surface.minor, r, 1e-13);
  EXPECT_LT(distance(a.surface.centre, Vec3{0, 0, r}), 1e-13);
  EXPECT_NEAR(length(a.along), 2 * pi, 1e-12);
  EXPECT_NEAR(std::abs(length(a.across)), pi / 2, 1e-12);
  EXPECT_LT(distance(a.x, Vec3{1, 0, 0}), 1e-13);  // starts at the cylinder's seam
  const auto off = [&](const Vec3& p) {
    return std::hypot(std::hypot(p[0], p[1]) - R - r, p[2] - r) - r;
  };
  EXPECT_LT(worst_of(strip.surface, off, 100), 1e-8);
  EXPECT_LT(strip.contacts[0].normal_angle, 2e-7);
  EXPECT_LT(strip.contacts[1].normal_angle, 2e-7);
  EXPECT_NEAR(std::abs(strip.contacts[1].chart.points.back()[0] -
                       strip.contacts[1].chart.points.front()[0]),
              2 * pi, 1e-12);
  EXPECT_LT(distance(strip.contacts[0].row.points.back(), strip.contacts[0].row.points.front()),
            1e-300);
}

TEST(BallStrip, OfALinearLawAlongALineIsACone) {
  const Wedge wedge(pi / 2);
  const BallTrack track = wedge.track(RadiusLaw::linear({0, 3}, 0.1, 0.7));

  const BallStrip strip = ball_strip(track, track.domain());

  ASSERT_TRUE(strip.analytic);
  const AnalyticStrip& a = *strip.analytic;
  EXPECT_EQ(a.surface.kind, ElementaryKind::Cone);
  // c = (x, r, r), r = 0.1 + 0.2 x.
  EXPECT_NEAR(std::sin(a.surface.angle), 0.2 / std::sqrt(1 + 2 * 0.04), 1e-13);
  EXPECT_LT(distance(a.surface.centre, Vec3{-0.5, 0, 0}), 1e-12);
  const Vec3 axis = unit(Vec3{1, 0.2, 0.2});
  EXPECT_LT(distance(a.surface.axis, axis), 1e-13);
  const auto off = [&](const Vec3& p) {
    const Vec3 way = p - Vec3{-0.5, 0, 0};
    return std::atan2(norm(cross(way, axis)), dot(way, axis)) - a.surface.angle;
  };
  EXPECT_LT(worst_of(strip.surface, off), 1e-9);
  EXPECT_LT(strip.contacts[0].normal_angle, 2e-7);
  EXPECT_LT(strip.contacts[1].normal_angle, 2e-7);
}

TEST(BallStrip, BetweenFreeFormFacesIsAsNearAsWanted) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  for (const double r : {0.02, 0.05, 0.1, 0.2, 0.4}) {
    const BallTrack track = edge_track(floor, wall, r);

    const BallStrip strip = ball_strip(track, track.domain());

    EXPECT_LE(strip.poles.rows() * strip.poles.columns(), 78) << r;
    EXPECT_LT(strip.section_error, 1e-8);
    EXPECT_FALSE(strip.analytic);
    for (const StripContactCurve& contact : strip.contacts) {
      EXPECT_TRUE(contact.proven);
      EXPECT_LT(contact.gap, 1e-8);
      EXPECT_LT(contact.normal_angle, 2e-7);
    }
    // All of the strip is at the ball's distance from the centre at its parameter.
    for (int i = 0; i <= 200; ++i) {
      const double u = at(track.domain(), i / 200.0);
      const BallPoint ball = track.at(u);
      for (const double v : {0.0, 0.3, 0.5, 0.9, 1.0})
        EXPECT_NEAR(distance(point_at(strip.surface, {u, v}), ball.centre), r, 1e-8);
      for (std::size_t k = 0; k < 2; ++k) {
        const Vec2 chart = point_at(strip.contacts[k].chart, u);
        EXPECT_LT(distance(point_at(k == 0 ? floor : wall, chart), ball.contacts[k].point), 1e-8);
      }
    }
  }
}

TEST(BallStrip, ReachesWhatIsAskedFor) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallTrack track = edge_track(floor, wall, 0.1);
  for (const double angle : {1e-6, 1e-8, 1e-9}) {
    const BallStrip strip = ball_strip(track, track.domain(), {.gap = 0.1 * angle, .angle = angle});
    for (const StripContactCurve& contact : strip.contacts) {
      EXPECT_LT(contact.gap, 0.1 * angle);
      EXPECT_LT(contact.normal_angle, angle);
    }
  }
}

TEST(BallStrip, OverKnotLinesHasKnotsThere) {
  Grid<Vec3> net(8, 8);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) net(i, j) = {double(i), double(j), 0.4 * std::sin(1.7 * i + j)};
  const BezierSurface floor = testing::uniform_cubic(net, false, false);
  const BezierSurface wall = plane_patch({0, 3.6, -5}, {1, 0, 0}, {0, 0, 1}, {0, 8}, {0, 10});
  const BallTrack track = track_through(whole_support(floor, 1), whole_support(wall, 1), 0.25,
                                        {Vec2{2.5, 2.2}, Vec2{3.5, 5.2}})
                              .value();
  const BallStrip strip = ball_strip(track, track.domain());
  for (const StripContactCurve& contact : strip.contacts) {
    EXPECT_LT(contact.gap, 1e-8);
    EXPECT_LT(contact.normal_angle, 2e-7);
    EXPECT_TRUE(contact.proven);
  }
  EXPECT_LT(strip.section_error, 1e-8);
  for (const double s : track.breaks()) {
    const auto knot = std::find(strip.knots.begin(), strip.knots.end(), s);
    ASSERT_NE(knot, strip.knots.end());
    EXPECT_GE(strip.multiplicities[static_cast<std::size_t>(knot - strip.knots.begin())], 4);
  }
}

// A span that is finer than its neighbour behind a knot line takes over that one's error, divided
// by its own length: it would only get finer.
TEST(BallStrip, OverKnotLinesHasNeighboursOfAboutOneLength) {
  Grid<Vec3> net(8, 8);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) net(i, j) = {double(i), double(j), i < 4 ? 0.0 : 0.3 * (i % 2)};
  const BezierSurface floor = testing::uniform_cubic(net, false, false);
  const BezierSurface wall = plane_patch({0, 3.6, -5}, {1, 0, 0}, {0, 0, 1}, {0, 8}, {0, 10});
  const BallTrack track = track_through(whole_support(floor, 1), whole_support(wall, 1), 0.25,
                                        {Vec2{2.5, 2.2}, Vec2{3.5, 5.2}})
                              .value();
  ASSERT_GT(track.breaks().size(), 2U);

  const BallStrip strip = ball_strip(track, track.domain());

  for (std::size_t i = 0; i + 2 < strip.knots.size(); ++i) {
    const double ratio =
        (strip.knots[i + 1] - strip.knots[i]) / (strip.knots[i + 2] - strip.knots[i + 1]);
    EXPECT_LT(std::abs(std::log2(ratio)), 1.01) << strip.knots[i + 1];
  }
}

TEST(BallStrip, OfAVariableRadiusTouchesItsSurfaces) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallSupport a = whole_support(floor, 1), b = whole_support(wall, 1);
  const testing::Cubic c = testing::base_cubic();
  const BallGuide guide{[&](double x) {
                          return CurveJet{{x, 0.5, c(x, 0.5)},
                                          {1, 0, 0.9 * x * x + 0.12 * x + 0.1375},
                                          {0, 0, 1.8 * x + 0.12}};
                        },
                        {0, 1}};
  const auto start = ball_beside_edge(a, b, 0.075, {Vec2{0.5, 1}, Vec2{0.5, 0}});
  ASSERT_TRUE(start);
  for (const RadiusLaw& law :
       {RadiusLaw::linear({0, 1}, 0.03, 0.12), RadiusLaw::smooth({0, 1}, 0.03, 0.12),
        RadiusLaw::table({0, 0.4, 1}, {0.06, 0.08, 0.05})}) {
    const BallTrack track = track_through(a, b, law, guide, 0.5, *start).value();
    const BallStrip strip = ball_strip(track, track.domain());
    EXPECT_LT(strip.section_error, 1e-8);
    EXPECT_LE(strip.poles.rows() * strip.poles.columns(), 150);
    for (const StripContactCurve& contact : strip.contacts) {
      EXPECT_LT(contact.gap, 1e-8);
      EXPECT_LT(contact.normal_angle, 2e-7);
    }
  }
}

TEST(BallStrip, CutAnywhereHasTheSameBorders) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallTrack track = edge_track(floor, wall, 0.1);
  const Interval part{at(track.domain(), 0.2), at(track.domain(), 0.7)};
  const BallStrip strip = ball_strip(track, part);
  EXPECT_EQ(strip.surface.u_knots.front(), part.from);
  EXPECT_EQ(strip.surface.u_knots.back(), part.to);
  for (const double u : {part.from, part.to}) {
    const BallPoint ball = track.at(u);
    EXPECT_LT(distance(point_at(strip.surface, {u, 0}), ball.contacts[0].point), 1e-15);
    EXPECT_LT(distance(point_at(strip.surface, {u, 1}), ball.contacts[1].point), 1e-15);
  }
}

// Growing at both ends, and shrinking again: knots of the strip before are kept, all else is as of
// a strip made at once.
TEST(BallStrip, ThatGrowsIsAsNearAsOneMadeAtOnce) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallTrack track = edge_track(floor, wall, 0.1);
  StripMaker maker(track);
  std::vector<double> before;
  for (const auto& [from, to] : {std::pair{0.4, 0.6}, std::pair{0.4, 0.61}, std::pair{0.13, 0.61},
                                 std::pair{0.0, 1.0}, std::pair{0.3, 0.9}}) {
    const Interval part{at(track.domain(), from), at(track.domain(), to)};
    const BallStrip grown = maker.strip(part), fresh = ball_strip(track, part);
    EXPECT_EQ(grown.knots.front(), part.from);
    EXPECT_EQ(grown.knots.back(), part.to);
    EXPECT_LE(grown.knots.size(), fresh.knots.size() + 8);
    EXPECT_LT(grown.section_error, 1e-8);
    for (const StripContactCurve& contact : grown.contacts) {
      EXPECT_LT(contact.gap, 1e-8);
      EXPECT_LT(contact.normal_angle, 2e-7);
    }
    for (int i = 0; i <= 200; ++i) {
      const BallPoint ball = track.at(at(part, i / 200.0));
      for (const double v : {0.0, 0.3, 1.0}) {
        const Vec3 point = point_at(grown.surface, {at(part, i / 200.0), v});
        EXPECT_NEAR(distance(point, ball.centre), 0.1, 2e-8);
      }
    }
    const auto kept = std::ranges::count_if(
        before, [&](double knot) { return std::ranges::count(grown.knots, knot) > 0; });
    EXPECT_TRUE(kept > 0 || before.size() <= 2) << from << " " << to;
    before.assign(grown.knots.begin() + 1, grown.knots.end() - 1);
  }
}

TEST(BallStrip, IsTheSameOfSwappedTurnedAndScaledSurfaces) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallTrack track = edge_track(floor, wall, 0.1);
  auto random = testing::seeded(7);
  for (const double scale : {1e-3, 1.0, 1e3}) {
    testing::Motion motion = testing::random_motion(random);
    motion.scale = scale;
    const BezierSurface a = testing::moved(floor, motion), b = testing::moved(wall, motion);
    const BallTrack moved = track_through(whole_support(b, 1), whole_support(a, 1), 0.1 * scale,
                                          {Vec2{0.5, 0.1}, Vec2{0.5, 0.8}})
                                .value();
    const BallStrip strip = ball_strip(moved, moved.domain(), {.gap = 1e-8 * scale});
    EXPECT_NEAR(length(moved.domain()), scale * length(track.domain()), 1e-9 * scale);
    EXPECT_LT(strip.contacts[0].gap, 1e-8 * scale);
    EXPECT_LT(strip.contacts[0].normal_angle, 2e-7);
    EXPECT_LT(strip.poles.rows(), 26);
    const Vec3 middle = moved.at(at(moved.domain(), 0.5)).centre;
    // Exchanged surfaces turn the direction.
    const Vec3 expected = track.at(at(track.domain(), 0.5)).centre;
    Vec3 image = motion.shift;
    for (int k = 0; k < 3; ++k)
      image[k] += scale * dot(motion.rotation[static_cast<std::size_t>(k)], expected);
    EXPECT_LT(distance(middle, image), 1e-9 * scale);
  }
}

TEST(BallStrip, OfAConicHasItsShoulderThere) {
  const Wedge wedge(pi / 2);
  const BallTrack track = wedge.track(0.4);
  for (const double rho : {0.25, std::numbers::sqrt2 - 1, 0.7}) {
    const BallStrip strip =
        ball_strip(track, track.domain(), {.section = SectionKind::Conic, .rho = rho});
    const Vec3 shoulder = point_at(strip.surface, {1, 0.5});
    const double expected = 0.2 * (1 - rho);  // from the chord's middle (0.2, 0.2) to the corner
    EXPECT_NEAR(shoulder[1], expected, 1e-14);
    EXPECT_NEAR(shoulder[2], expected, 1e-14);
    EXPECT_LT(strip.contacts[0].normal_angle, 1e-12);
  }
}

TEST(BallStrip, OfAChamferIsFlatBetweenPlanes) {
  const Wedge wedge(pi / 2);
  const BallTrack track = wedge.track(0.4);
  const BallStrip strip = ball_strip(track, track.domain(), {.section = SectionKind::Chamfer});
  EXPECT_EQ(strip.poles.columns(), 2);
  EXPECT_LT(worst_of(strip.surface, [](const Vec3& p) { return p[1] + p[2] - 0.4; }), 1e-14);
}

// The curvature of a surface in the direction of v, positive towards a normal.
double curvature_across(const BezierSurface& surface, const Vec2& uv, const Vec3& normal) {
  const PatchJet jet = chart_jet(surface, cell_at(surface, uv), uv, 2);
  return dot(jet.vv, normal) / dot(jet.v, jet.v);
}

TEST(BallStrip, OfContinuousCurvatureHasTheSurfacesCurvature) {
  const double R = 1.5, r = 0.4;
  const BezierSurface plate = plane_patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-5, 5}, {-5, 5});
  const BezierSurface round = testing::upper_sphere(R);
  const BallTrack track = track_through(whole_support(plate, 1), whole_support(round, 1), r,
                                        {Vec2{0.3, 2}, Vec2{1.3, 0.5}})
                              .value();
  const BallStrip strip = ball_strip(track, track.domain(), {.section = SectionKind::Curvature});
  EXPECT_LT(strip.contacts[1].normal_angle, 2e-7);
  for (const double t : {0.1, 0.5, 0.8}) {
    const double u = at(track.domain(), t);
    const BallPoint ball = track.at(u);
    EXPECT_NEAR(curvature_across(strip.surface, {u, 0}, ball.contacts[0].normal), 0, 1e-6);
    EXPECT_NEAR(curvature_across(strip.surface, {u, 1}, ball.contacts[1].normal), -1 / R, 1e-6);
  }
}

// A floor of two planes that make a slight crease across the way, as exported surfaces have them
// along knot lines: no strip that is whole is tangent to both, and short spans do not help.
TEST(BallStrip, OverASlightCreaseTakesFewSpans) {
  for (const double crease : {1.4e-5, -1.4e-5, 1e-6}) {
    BezierSurface floor = plane_patch({-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1}, {0, 2});
    const BezierSurface next = plane_patch({0, 0, 0}, {1, 0, crease}, {0, 1, 0}, {0, 1}, {0, 2});
    floor.u_knots = {0, 1, 2};
    const RationalBezierPatch first = floor.patches(0, 0), second = next.patches(0, 0);
    floor.patches = Grid<RationalBezierPatch>(2, 1, first);
    floor.patches(1, 0) = second;
    const BezierSurface wall = testing::bicubic([](double s, double t) {
      return Vec3{2 * s - 1, 0.1 * s * s, 1.5 * t - 0.5};
    });
    const BallTrack track = track_through(whole_support(floor, 1), whole_support(wall, -1), 0.2,
                                          {Vec2{0.6, 0.3}, Vec2{0.3, 0.5}})
                                .value();
    ASSERT_GT(length(track.domain()), 1.5);
    const BallStrip strip = ball_strip(track, track.domain());
    EXPECT_LT(strip.knots.size(), 40U) << crease;
    EXPECT_LT(strip.contacts[0].gap, 0.2 * std::abs(crease) + 1e-8);
    EXPECT_LT(strip.contacts[0].normal_angle, 2 * std::abs(crease) + 2e-7);
  }
}

// Off the floor z = f(x), along a section, a strip is of the order of the first derivative in which
// they differ.
TEST(BallStrip, OfContinuousRatesOfCurvatureLeavesTheSurfaceByFourthOrder) {
  const auto height = [](double x, double y) {
    return 0.3 * x * x + 0.4 * x * x * x + 0.2 * x * y;
  };
  const BezierSurface floor = testing::bicubic([&](double s, double t) {
    return Vec3{2 * s - 1, 2 * t - 1, height(2 * s - 1, 2 * t - 1)};
  });
  const BezierSurface wall = plane_patch({0.6, 0, 0}, {0, 1, 0}, {0.3, 0, 1}, {-1, 1}, {-1, 2});
  const BallTrack track = track_through(whole_support(floor, 1), whole_support(wall, -1), 0.2,
                                        {Vec2{0.7, 0.5}, Vec2{0, 0.3}})
                              .value();
  for (const auto& [kind, order] :
       {std::pair{SectionKind::Curvature, 3}, std::pair{SectionKind::CurvatureRate, 4}}) {
    const BallStrip strip = ball_strip(track, track.domain(), {.section = kind, .gap = 1e-10});
    EXPECT_EQ(strip.poles.columns(), 2 * order);
    EXPECT_LT(strip.contacts[0].normal_angle, 2e-7);
    for (const double t : {0.2, 0.5, 0.7}) {
      const double u = at(track.domain(), t);
      const auto off = [&](double v) {
        const Vec3 p = point_at(strip.surface, {u, v});
        return std::abs(p[2] - height(p[0], p[1]));
      };
      EXPECT_NEAR(std::log2(off(0.1) / off(0.05)), order, 0.5) << u;
    }
  }
}

TEST(BallStrip, RefusesWhatHasNoEnvelope) {
  const Wedge wedge(pi / 2);
  const BallTrack track = wedge.track(0.4);
  EXPECT_THROW(ball_strip(track, {0, 0}), InvalidInput);
  EXPECT_THROW(ball_strip(track, {-1, 1}), InvalidInput);
  EXPECT_THROW(ball_strip(track, track.domain(), {.section = SectionKind::Conic, .rho = 1}),
               InvalidInput);
  EXPECT_THROW(ball_strip(track, track.domain(), {.gap = 0}), InvalidInput);
}

}  // namespace
}  // namespace blossom
