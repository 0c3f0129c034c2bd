// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/rays/ray_casting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/forms/evaluation.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

using testing::one_patch;
using testing::quadrilateral;
using testing::random_point;
using testing::reference_point;
using testing::seeded;
using testing::uniform;

constexpr double kRounding = 1e-12;

RationalBezierPatch random_rational(testing::Random& random, int n, int m, double largest_weight) {
  RationalBezierPatch patch{Grid<Vec4>(n + 1, m + 1)};
  for (Vec4& p : patch.points.values())
    p = testing::weighted(random_point(random),
                          std::exp(uniform(random, 0, 1) * std::log(largest_weight)));
  return patch;
}

Vec3 exact_point(const RationalBezierPatch& patch, const Vec2& at) {
  const Vec4 p = reference_point(patch, at[0], at[1]);
  return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

double gap_to_line(const Ray& ray, const Vec3& point) {
  return norm(cross(point - ray.origin, unit(ray.direction)));
}

// The square [0, 2] x [0, 4] at z = 1.
BezierSurface table() { return quadrilateral({0, 0, 1}, {0, 4, 1}, {2, 0, 1}, {2, 4, 1}); }

TEST(RayCasting, HitsATableWhereHandsPutIt) {
  const RayCaster caster({table()});
  const std::vector<RayHit> hits = caster.all_hits({{0.5, 1, 4}, {0, 0, -1}});

  ASSERT_EQ(hits.size(), 1u);
  EXPECT_DOUBLE_EQ(hits[0].parameter, 3);
  EXPECT_EQ(hits[0].point, (Vec3{0.5, 1, 1}));
  EXPECT_NEAR(hits[0].uv[0], 0.25, 1e-15);
  EXPECT_NEAR(hits[0].uv[1], 0.25, 1e-15);
  EXPECT_EQ(hits[0].normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(hits[0].status, Status::Complete);
  EXPECT_FALSE(hits[0].grazing);
  EXPECT_FALSE(hits[0].border);
}

TEST(RayCasting, KeepsToTheRaysEnds) {
  const RayCaster caster({table()});
  const auto hits = [&](double from, double to) {
    return caster.all_hits({{0.5, 1, 4}, {0, 0, -1}, from, to}).size();
  };
  EXPECT_EQ(hits(0, 2.9), 0u);
  EXPECT_EQ(hits(0, 3), 1u);
  EXPECT_EQ(hits(3, 9), 1u);
  EXPECT_EQ(hits(3.1, kInfinity), 0u);
  EXPECT_EQ(hits(-kInfinity, kInfinity), 1u);
  EXPECT_EQ(caster.all_hits({{0.5, 1, 4}, {0, 0, 1}}).size(), 0u);
  EXPECT_EQ(caster.all_hits({{0.5, 1, 4}, {0, 0, 1}, -kInfinity, 0}).size(), 1u);
}

TEST(RayCasting, MeasuresInLengthsOfTheDirection) {
  const RayCaster caster({table()});
  const std::vector<RayHit> hits = caster.all_hits({{0.5, 1, 4}, {0, 0, -2e-3}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_DOUBLE_EQ(hits[0].parameter, 1500);
}

TEST(RayCasting, RefusesRaysWithoutDirection) {
  const RayCaster caster({table()});
  EXPECT_THROW(caster.all_hits({{0, 0, 0}, {0, 0, 0}}), InvalidInput);
  EXPECT_THROW(caster.all_hits({{0, 0, 0}, {0, std::nan(""), 1}}), InvalidInput);
  EXPECT_THROW(caster.all_hits({{0, kInfinity, 0}, {0, 0, 1}}), InvalidInput);
  EXPECT_THROW(caster.all_hits({{0, 0, 0}, {0, 0, 1}, 1, 0}), InvalidInput);
  EXPECT_THROW(RayCaster({}), InvalidInput);
  EXPECT_THROW(RayCaster({table()}, Tolerances{0}), InvalidInput);
}

TEST(RayCasting, HitsASharedCornerOrBorderOnce) {
  BezierSurface surface = table();
  surface.u_knots = surface.v_knots = {0, 1, 3};
  surface.patches = Grid<RationalBezierPatch>(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      surface.patches(i, j) =
          quadrilateral({i + 0., j + 0., 0.1 * i * j}, {i + 0., j + 1., 0.1 * i * (j + 1)},
                        {i + 1., j + 0., 0.1 * (i + 1) * j},
                        {i + 1., j + 1., 0.1 * (i + 1) * (j + 1)})
              .patches(0, 0);
  const RayCaster caster({surface});
  for (const Vec3& direction : {Vec3{0, 0, -1}, Vec3{0.2, -0.3, -1}})
    for (const Vec2& at : {Vec2{1, 1}, Vec2{1, 0.3}, Vec2{1.7, 1}, Vec2{0, 0}, Vec2{2, 0.5}}) {
      const Vec3 point{at[0], at[1], 0.1 * at[0] * at[1]};
      const std::vector<RayHit> hits = caster.all_hits({point - 3 * direction, direction});
      ASSERT_EQ(hits.size(), 1u) << at[0] << " " << at[1];
      EXPECT_EQ(hits[0].status, Status::Complete);
      EXPECT_TRUE(hits[0].border);
      EXPECT_LE(distance(hits[0].point, point), kRounding);
      EXPECT_NEAR(hits[0].uv[0], at[0] <= 1 ? at[0] : 2 * at[0] - 1, kRounding);
    }
}

TEST(RayCasting, HitsEdgesAndCornersOfACubeOnce) {
  const RayCaster caster(testing::unit_cube());
  const Vec3 inside{0.4, 0.3, 0.2};
  for (const Vec3& target : {Vec3{1, 1, 0.5}, Vec3{0, 0.25, 1}, Vec3{1, 1, 1}, Vec3{0, 1, 0}}) {
    const std::vector<RayHit> hits = caster.all_hits({inside, target - inside});
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].parameter, 1, kRounding);
    EXPECT_TRUE(hits[0].border);
    EXPECT_LE(distance(hits[0].point, target), kRounding);
  }
}

TEST(RayCasting, ReportsAStretchAlongAPlane) {
  const RayCaster caster({table()});
  const std::vector<RayHit> hits = caster.all_hits({{-3, 1, 1}, {1, 0, 0}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].status, Status::Tolerance);
  EXPECT_TRUE(hits[0].grazing);
  EXPECT_NEAR(hits[0].first, 3, 1e-6);
  EXPECT_NEAR(hits[0].last, 5, 1e-6);
  EXPECT_LE(gap_to_line({{-3, 1, 1}, {1, 0, 0}}, hits[0].point), 1e-7);
  EXPECT_TRUE(caster.all_hits({{-3, 1, 1 + 1e-6}, {1, 0, 0}}).empty());
}

TEST(RayCasting, JoinsTheSidesOfACubeToAStretchInItsTop) {
  const std::vector<RayHit> hits =
      RayCaster(testing::unit_cube()).all_hits({{-3, 0.5, 1}, {1, 0, 0}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_NEAR(hits[0].first, 3, 1e-6);
  EXPECT_NEAR(hits[0].last, 4, 1e-6);
}

TEST(RayCasting, ReportsAStretchAlongARulingOfACylinder) {
  BezierSurface pipe = testing::torus(1, 0.25);
  pipe.v_law = ParameterLaw::Linear;
  pipe.v_knots = {0, 1};
  pipe.closed_v = false;
  Grid<RationalBezierPatch> patches(4, 1);
  for (int i = 0; i < 4; ++i) {
    patches(i, 0).points = Grid<Vec4>(3, 2);
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 2; ++l) {
        const Vec3 p = testing::quarter_arc(i * std::numbers::pi / 2)[static_cast<std::size_t>(k)];
        patches(i, 0).points(k, l) = {p[0], p[1], p[2] * l, p[2]};
      }
  }
  pipe.patches = patches;
  const Vec3 foot{std::cos(0.4), std::sin(0.4), -1};
  const std::vector<RayHit> hits = RayCaster({pipe}).all_hits({foot, {0, 0, 1}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].status, Status::Tolerance);
  EXPECT_NEAR(hits[0].first, 1, 1e-5);
  EXPECT_NEAR(hits[0].last, 2, 1e-5);
}

TEST(RayCasting, HitsThePolesOfASphereOnce) {
  const RayCaster caster({testing::unit_sphere()});
  for (const Vec3& direction : {Vec3{0, 0, 1}, Vec3{0.3, -0.2, 1}}) {
    const std::vector<RayHit> hits = caster.all_hits({Vec3{0, 0, 1} - 0.5 * direction, direction});
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].parameter, 0.5, 1e-7);
    EXPECT_LE(distance(hits[0].point, {0, 0, 1}), 1e-7);
    EXPECT_FALSE(hits[0].grazing);
    EXPECT_LE(hits[0].last - hits[0].first, 1e-6);
  }
}

TEST(RayCasting, TellsATouchFromTwoHitsAndFromNone) {
  auto random = seeded(5);
  const RayCaster caster({testing::unit_sphere()});
  for (int i = 0; i < 50; ++i) {
    const Vec3 normal = unit(random_point(random));
    const Vec3 direction = unit(cross(normal, random_point(random)));
    const auto hits_at = [&](double height) {
      return caster.all_hits({height * normal - 2 * direction, direction});
    };
    const std::vector<RayHit> touch = hits_at(1);
    ASSERT_EQ(touch.size(), 1u) << i;
    EXPECT_TRUE(touch[0].grazing);
    EXPECT_EQ(touch[0].status, Status::Tolerance);
    EXPECT_LE(touch[0].first, 2 + 1e-9);
    EXPECT_GE(touch[0].last, 2 - 1e-9);
    EXPECT_LE(distance(touch[0].point, normal), 1e-6);
    EXPECT_TRUE(hits_at(1 + 1e-12).empty());
    const std::vector<RayHit> two = hits_at(1 - 1e-10);
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[0].status, Status::Complete);
    EXPECT_NEAR(two[1].parameter - two[0].parameter, 2 * std::sqrt(2e-10), 1e-8);
  }
}

TEST(RayCasting, FindsBothHitsOfEveryLineThroughASphere) {
  auto random = seeded(1);
  const RayCaster caster({testing::unit_sphere()});
  for (int i = 0; i < 1000; ++i) {
    const Ray ray{3 * random_point(random), random_point(random), -kInfinity, kInfinity};
    const double a = dot(ray.direction, ray.direction), b = dot(ray.origin, ray.direction);
    const double discriminant = b * b - a * (dot(ray.origin, ray.origin) - 1);
    const std::vector<RayHit> hits = caster.all_hits(ray);
    ASSERT_EQ(hits.size(), discriminant > 0 ? 2u : 0u) << i;
    if (hits.empty()) continue;
    EXPECT_NEAR(hits[0].parameter, (-b - std::sqrt(discriminant)) / a, 1e-9);
    EXPECT_NEAR(hits[1].parameter, (-b + std::sqrt(discriminant)) / a, 1e-9);
    for (const RayHit& hit : hits) {
      EXPECT_EQ(hit.status, Status::Complete);
      EXPECT_NEAR(norm(hit.point), 1, kRounding);
      EXPECT_LE(gap_to_line(ray, hit.point), kRounding);
      EXPECT_LE(distance(point_at(caster.cells().surfaces()[0], hit.uv), hit.point), kRounding);
    }
  }
}

TEST(RayCasting, EntersAndLeavesATorusInTurn) {
  auto random = seeded(2);
  const RayCaster caster({testing::torus(2, 0.75)});
  std::array<int, 5> seen{};
  for (int i = 0; i < 1000; ++i) {
    const Ray ray{3 * random_point(random), random_point(random), -kInfinity, kInfinity};
    const std::vector<RayHit> hits = caster.all_hits(ray);
    ASSERT_TRUE(hits.size() == 0 || hits.size() == 2 || hits.size() == 4) << i;
    ++seen[hits.size()];
    for (std::size_t k = 0; k < hits.size(); ++k) {
      const double sign = dot(hits[k].normal, ray.direction) * (k % 2 == 0 ? 1 : -1);
      EXPECT_LT(sign, 0) << i;
      const Vec3& p = hits[k].point;
      EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 2, p[2]), 0.75, kRounding);
    }
  }
  EXPECT_GT(seen[0], 50);
  EXPECT_GT(seen[2], 50);
  EXPECT_GT(seen[4], 10);
}

TEST(RayCasting, LeavesACubeOnceFromInside) {
  auto random = seeded(3);
  const RayCaster caster(testing::unit_cube());
  for (int i = 0; i < 1000; ++i) {
    const Vec3 inside = 0.5 * (Vec3{1, 1, 1} + 0.99 * random_point(random));
    EXPECT_EQ(caster.all_hits({inside, random_point(random)}).size(), 1u) << i;
  }
}

// Every root that a fine grid of Newton starts finds, slowly.
std::vector<Vec2> roots_by_search(const RationalBezierPatch& patch, const Ray& ray) {
  constexpr int kStarts = 24;
  std::vector<Vec2> roots;
  for (int i = 0; i <= kStarts; ++i)
    for (int j = 0; j <= kStarts; ++j) {
      Vec2 x{i / double{kStarts}, j / double{kStarts}};
      double step = 1;
      for (int k = 0; k < 30 && step > 1e-14 && max_norm(x) < 3; ++k) {
        const PatchJet jet = jet_at(patch, x[0], x[1], 1);
        const Vec3 r = ray.origin - jet.point;
        const double area = dot(cross(jet.u, jet.v), ray.direction);
        const Vec2 move{dot(r, cross(jet.v, ray.direction)) / area,
                        dot(r, cross(ray.direction, jet.u)) / area};
        x += move;
        step = max_norm(move);
      }
      const bool inside = x[0] >= 0 && x[0] <= 1 && x[1] >= 0 && x[1] <= 1;
      if (!(step <= 1e-12) || !inside) continue;
      if (std::none_of(roots.begin(), roots.end(),
                       [&](const Vec2& known) { return max_norm(known - x) < 1e-7; }))
        roots.push_back(x);
    }
  return roots;
}

// Properties over degrees 1..5, random nets, polynomial and with weights up to 1000.
class RayCastingProperty : public ::testing::TestWithParam<int> {
 protected:
  RationalBezierPatch patch(testing::Random& random) const {
    const int n = 1 + GetParam() % 5, m = 1 + GetParam() / 5 % 5;
    return random_rational(random, n, m, GetParam() % 2 == 0 ? 1 : 1000);
  }
};

TEST_P(RayCastingProperty, FindsThePointsThatRaysAreBuiltThrough) {
  auto random = seeded(GetParam());
  const RationalBezierPatch net = patch(random);
  const RayCaster caster({one_patch(net)});
  for (int i = 0; i < 20; ++i) {
    const Vec2 at{uniform(random, 0, 1), uniform(random, 0, 1)};
    const Vec3 target = exact_point(net, at);
    const Ray ray{target - random_point(random), random_point(random), -kInfinity, kInfinity};
    Ray through = ray;
    through.direction = target - ray.origin;
    const std::vector<RayHit> hits = caster.all_hits(through);
    EXPECT_TRUE(std::any_of(hits.begin(), hits.end(), [&](const RayHit& hit) {
      return distance(hit.point, target) < 1e-9 && max_norm(hit.local - at) < 1e-7;
    })) << i;
    for (const RayHit& hit : hits) {
      EXPECT_LE(gap_to_line(through, hit.point), 1e-11);
      EXPECT_LE(distance(exact_point(net, hit.local), hit.point), kRounding);
    }
  }
}

TEST_P(RayCastingProperty, FindsAllThatASlowSearchFinds) {
  auto random = seeded(GetParam());
  const RationalBezierPatch net = patch(random);
  const RayCaster caster({one_patch(net)});
  for (int i = 0; i < 5; ++i) {
    const Ray ray{random_point(random), random_point(random), -kInfinity, kInfinity};
    const std::vector<RayHit> hits = caster.all_hits(ray);
    const std::vector<Vec2> roots = roots_by_search(net, ray);
    EXPECT_GE(hits.size(), roots.size());
    for (const Vec2& root : roots)
      EXPECT_TRUE(std::any_of(hits.begin(), hits.end(), [&](const RayHit& hit) {
        return max_norm(hit.local - root) < 1e-7;
      })) << i;
    for (const RayHit& hit : hits) EXPECT_EQ(hit.status, Status::Complete);
  }
}

TEST_P(RayCastingProperty, GivesTheFirstOfAllHitsFirst) {
  auto random = seeded(GetParam());
  const RayCaster caster({one_patch(patch(random)), one_patch(patch(random))});
  std::vector<Ray> rays;
  for (int i = 0; i < 40; ++i) rays.push_back({2 * random_point(random), random_point(random)});
  const std::vector<std::vector<RayHit>> first = caster.first_hits(rays),
                                         all = caster.all_hits(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::vector<RayHit> alone = caster.all_hits(rays[i]);
    ASSERT_EQ(all[i].size(), alone.size());
    ASSERT_EQ(first[i].empty(), alone.empty());
    if (alone.empty()) continue;
    EXPECT_EQ(first[i].front().parameter, alone.front().parameter);
    EXPECT_EQ(first[i].front().local, alone.front().local);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RayCastingProperty, ::testing::Range(0, 50));

TEST(RayCasting, AsksTheFilterAboutEachHit) {
  const RayCaster caster(testing::unit_cube());
  RayQuery query(caster);
  const Ray ray{{0.3, 0.4, -2}, {0, 0, 1}};
  EXPECT_EQ(query.all_hits(ray).size(), 2u);
  const auto upper = [](RayHit& hit) { return hit.point[2] > 0.5; };
  ASSERT_EQ(query.first_hits(ray, upper).size(), 1u);
  EXPECT_DOUBLE_EQ(query.first_hits(ray, upper)[0].parameter, 3);
}

TEST(RayCasting, CountsWhatPassesWithinReachOfABorder) {
  const RayCaster caster({table()}, {}, {1e-3});
  const std::vector<RayHit> hits = caster.all_hits({{2 + 4e-4, 1, 4}, {0, 0, -1}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_NEAR(hits[0].beyond, 4e-4, kRounding);
  EXPECT_EQ(hits[0].point, (Vec3{2, 1, 1}));
  EXPECT_TRUE(caster.all_hits({{2 + 1.1e-3, 1, 4}, {0, 0, -1}}).empty());
  EXPECT_THROW(RayCaster({table()}, {}, {1e-3, 1e-3}), InvalidInput);
}

TEST(RayCasting, SaysSoWhenTheSurfaceIsOnlyAnApproximation) {
  BezierSurface surface = table();
  surface.error = 1e-6;
  const std::vector<RayHit> hits = RayCaster({surface}).all_hits({{0.5, 1, 4}, {0, 0, -1}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].status, Status::Tolerance);
}

}  // namespace
}  // namespace blossom
