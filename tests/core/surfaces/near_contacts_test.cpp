// SPDX-License-Identifier: LGPL-2.1-or-later
// Gaps below the tolerance are contacts: bowls, balls, sheets and more a little above other
// surfaces, or a little in them, in any pose and size.
//
// A draw is named by its seed. BLOSSOM_TRIALS sets how many there are, BLOSSOM_SEED the first.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "core/bounds/box_tree.h"
#include "core/forms/evaluation.h"
#include "core/surface_intersection.h"
#include "tests/support/draws.h"
#include "tests/support/random.h"
#include "tests/support/solids.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::Random;

using testing::setting;

constexpr double kNearTolerance = 1e-7;

// Two surfaces, and where they are how near to each other, before both are moved and scaled.
struct NearPair {
  BezierSurface above, below;
  std::vector<Vec3> nearest;
  std::vector<double> gaps;  // there, model units
};

struct NearKind {
  const char* name;
  NearPair (*make)(Random& random, double gap);
  bool may_stop = false;  // where the gap passes the tolerance in the middle of a surface
};

struct NearDraw {
  const char* name = "";
  double gap = 0;  // in tolerances
  double scale = 1;
  bool may_stop = false;
  NearPair pair;
};

BezierSurface ground() {
  return testing::quadrilateral({-1.1, -1.2, 0}, {-1.1, 1.3, 0}, {1.2, -1.2, 0}, {1.2, 1.3, 0});
}

// Corners of cells are places of their own.
double place(Random& random) {
  return testing::pick(random, 0, 2) == 0 ? 0.25 * testing::pick(random, -2, 2)
                                          : testing::uniform(random, -0.8, 0.8);
}

void add(NearPair& pair, const Vec3& point, double gap) {
  pair.nearest.push_back(point);
  pair.gaps.push_back(std::abs(gap));
}

// z = p (x - a)^2 + q (y - b)^2 + gap over the square from -1 to 1.
BezierSurface bowl(double p, double q, double a, double b, double gap) {
  RationalBezierPatch patch{Grid<Vec4>(3, 3)};
  // In Bernstein form x^2 is 1, -1, 1.
  const auto square = [](int i, double at) {
    const double x = i - 1.0;
    return (i == 1 ? -1.0 : 1.0) - 2 * at * x + at * at;
  };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      patch.points(i, j) = {i - 1.0, j - 1.0, p * square(i, a) + q * square(j, b) + gap, 1};
  return testing::one_patch(std::move(patch));
}

NearPair bowl_over_plane(Random& random, double gap) {
  const double p = testing::uniform(random, 0.1, 2), q = testing::uniform(random, 0.1, 2);
  const double a = place(random), b = place(random);
  NearPair pair{bowl(p, q, a, b, gap), ground(), {}, {}};
  add(pair, {a, b, 0}, gap);
  return pair;
}

NearPair trough_over_plane(Random& random, double gap) {
  const double p = testing::uniform(random, 0.1, 2), a = place(random);
  NearPair pair{bowl(p, 0, a, 0, gap), ground(), {}, {}};
  for (double y = -0.9; y < 1; y += 0.3) add(pair, {a, y, 0}, gap);
  return pair;
}

// Of radius 1, with its poles anywhere.
BezierSurface ball(Random& random, const Vec3& centre) {
  testing::Motion own = testing::random_motion(random);
  own.shift = centre;
  return testing::moved(testing::unit_sphere(), own);
}

NearPair ball_over_plane(Random& random, double gap) {
  const double a = place(random), b = place(random);
  NearPair pair{ball(random, {a, b, 1 + gap}), ground(), {}, {}};
  add(pair, {a, b, 0}, gap);
  return pair;
}

NearPair ball_beside_ball(Random& random, double gap) {
  NearPair pair{ball(random, {0, 0, 1 + gap}), ball(random, {0, 0, -1}), {}, {}};
  add(pair, {0, 0, 0}, gap);
  return pair;
}

NearPair ball_in_ball(Random& random, double gap) {
  testing::Motion half;
  half.scale = testing::uniform(random, 0.3, 0.9);
  half.shift = {0, 0, half.scale - 1 + gap};
  NearPair pair{testing::moved(ball(random, {}), half), ball(random, {}), {}, {}};
  add(pair, {0, 0, -1}, gap);
  return pair;
}

// Round one centre, of radii that differ by the gap.
NearPair shell(Random& random, double gap) {
  testing::Motion less;
  less.scale = 1 - gap;
  NearPair pair{testing::moved(ball(random, {}), less), ball(random, {}), {}, {}};
  for (int k = 0; k < 8; ++k) add(pair, unit(testing::random_motion(random).rotation[0]), gap);
  return pair;
}

NearPair ring_on_plane(Random& random, double gap) {
  testing::Motion up;
  up.shift = {0, 0, 0.3 + gap};
  NearPair pair{testing::moved(testing::torus(0.7, 0.3), up), ground(), {}, {}};
  for (int k = 0; k < 8; ++k) {
    const double turn = testing::uniform(random, 0, 6.28);
    add(pair, {0.7 * std::cos(turn), 0.7 * std::sin(turn), 0}, gap);
  }
  return pair;
}

// Turned about z, on the square from -r to r.
BezierSurface sheet(Random& random, double r, double z, const Vec2& slope) {
  const double turn = testing::pick(random, 0, 1) == 0 ? 0 : testing::uniform(random, 0, 1.5);
  const double c = r * std::cos(turn), s = r * std::sin(turn);
  const auto corner = [&](double x, double y) {
    return Vec3{x, y, z + slope[0] * x + slope[1] * y};
  };
  return testing::quadrilateral(corner(-c + s, -s - c), corner(-c - s, -s + c),
                                corner(c + s, s - c), corner(c - s, s + c));
}

NearPair sheet_over_plane(Random& random, double gap) {
  NearPair pair{sheet(random, testing::uniform(random, 0.2, 2), gap, {}), ground(), {}, {}};
  for (const double x : {-0.1, 0.0, 0.1}) add(pair, {x, 0.1, 0}, gap);
  return pair;
}

// Tilted by so little that the gap stays below a few tolerances.
NearPair wedge_over_plane(Random& random, double gap) {
  const Vec2 slope{testing::uniform(random, -2, 2) * gap, testing::uniform(random, -2, 2) * gap};
  NearPair pair{sheet(random, testing::uniform(random, 0.2, 0.7), gap, slope), ground(), {}, {}};
  for (const double x : {-0.15, 0.0, 0.15})
    for (const double y : {-0.1, 0.1}) add(pair, {x, y, 0}, gap + slope[0] * x + slope[1] * y);
  return pair;
}

// A free-form surface and itself moved, cut and parametrized otherwise.
NearPair wave_over_itself(Random& random, double gap) {
  RationalBezierPatch patch{Grid<Vec4>(4, 4)};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      patch.points(i, j) = {i / 3.0, j / 3.0, testing::uniform(random, -0.3, 0.3), 1};
  testing::Motion up;
  up.shift = {0, 0, gap};
  const BezierSurface wave = testing::of_patch(patch);
  NearPair pair{testing::moved(wave, up), wave, {}, {}};
  if (testing::pick(random, 0, 1) == 1) pair.above = testing::elevated(pair.above, 4);
  if (testing::pick(random, 0, 1) == 1) pair.above = testing::exchanged(pair.above);
  if (testing::pick(random, 0, 1) == 1) pair.above = testing::split_in_u(pair.above, 0.3);
  for (int k = 0; k < 8; ++k)
    add(pair,
        point_at(patch, testing::uniform(random, 0.02, 0.98), testing::uniform(random, 0.02, 0.98)),
        gap);
  return pair;
}

constexpr std::array kNearKinds{NearKind{"bowl over plane", bowl_over_plane},
                                NearKind{"trough over plane", trough_over_plane},
                                NearKind{"ball over plane", ball_over_plane},
                                NearKind{"ball beside ball", ball_beside_ball},
                                NearKind{"ball in ball", ball_in_ball},
                                NearKind{"shell", shell},
                                NearKind{"ring on plane", ring_on_plane},
                                NearKind{"sheet over plane", sheet_over_plane},
                                NearKind{"wedge over plane", wedge_over_plane, true},
                                NearKind{"wave over itself", wave_over_itself, true}};

Vec3 moved_point(const Vec3& x, const testing::Motion& motion) {
  Vec3 result;
  for (int k = 0; k < 3; ++k)
    result[k] =
        motion.scale * dot(motion.rotation[static_cast<std::size_t>(k)], x) + motion.shift[k];
  return result;
}

NearDraw random_near_draw(Random& random) {
  NearDraw draw;
  const int kind = testing::pick(random, 0, kNearKinds.size() - 1);
  const int sign = testing::pick(random, 0, 3) == 0 ? -1 : 1;
  draw.gap = testing::pick(random, 0, 2) == 0
                 ? testing::uniform(random, -2, 2)
                 : sign * std::pow(10, testing::uniform(random, -6, 0.3));
  if (testing::pick(random, 0, 1) == 1) draw.scale = std::pow(10, testing::uniform(random, -3, 4));
  const NearKind& made = kNearKinds[static_cast<std::size_t>(setting("BLOSSOM_KIND", kind))];
  draw.name = made.name;
  draw.may_stop = made.may_stop;
  draw.pair = made.make(random, draw.gap * kNearTolerance / draw.scale);
  testing::Motion motion = testing::random_motion(random);
  if (testing::pick(random, 0, 3) == 0) motion.rotation = testing::Motion{}.rotation;
  motion.scale = draw.scale;
  for (int k = 0; k < 3; ++k) motion.shift[k] *= draw.scale;
  draw.pair.above = testing::moved(draw.pair.above, motion);
  draw.pair.below = testing::moved(draw.pair.below, motion);
  for (Vec3& x : draw.pair.nearest) x = moved_point(x, motion);
  for (double& gap : draw.pair.gaps) gap *= draw.scale;
  return draw;
}

double distance_to_curve(const IntersectionCurve& curve, const Vec3& x) {
  double least = 1e300;
  for (std::size_t i = 1; i < curve.samples.size(); ++i) {
    const Vec3 &p = curve.samples[i - 1].point, &q = curve.samples[i].point;
    const double square = dot(q - p, q - p);
    const double t = square > 0 ? std::clamp(dot(x - p, q - p) / square, 0.0, 1.0) : 0;
    least = std::min(least, distance(x, p + t * (q - p)));
  }
  return least;
}

// True if a curve, a point or a place is no farther from x than r.
bool tells(const SurfaceIntersection& found, const Vec3& x, double r) {
  const Vec3 reach{r, r, r};
  return std::ranges::any_of(found.places,
                             [&](const Place& place) {
                               return meet({place.box_low, place.box_high}, {x - reach, x + reach});
                             }) ||
         std::ranges::any_of(found.points,
                             [&](const SurfacePoint& p) { return distance(p.point, x) <= r; }) ||
         std::ranges::any_of(found.curves, [&](const IntersectionCurve& curve) {
           return distance_to_curve(curve, x) <= r;
         });
}

// What is wrong with the answer; empty if nothing is.
std::string fault(const NearDraw& draw, const SurfaceIntersection& found) {
  if (found.status == Status::Stopped && !draw.may_stop) return "stopped";
  const double size = 3 * draw.scale;
  // Rounding of nets moves them by some of their last digits.
  const double sure = 0.99 * kNearTolerance - 1e-13 * size;
  // Surfaces that bend stay within tolerance over so much of their size.
  const double reach = 3 * std::sqrt(kNearTolerance * size);
  for (std::size_t i = 0; i < draw.pair.nearest.size(); ++i)
    if (draw.pair.gaps[i] < sure && !tells(found, draw.pair.nearest[i], reach))
      return "nothing where they are nearer than the tolerance";
  if (draw.gap > 1.99 && draw.pair.gaps.size() == 1 && !found.curves.empty())
    return "a curve where they are apart";
  return "";
}

TEST(NearContacts, AreNeverMissed) {
  const int first = setting("BLOSSOM_SEED", 0), trials = setting("BLOSSOM_TRIALS", 400);
  int faults = 0;
  for (int seed = first; seed < first + trials; ++seed) {
    Random random = testing::seeded(seed);
    const NearDraw draw = random_near_draw(random);
    const bool swapped = testing::pick(random, 0, 1) == 1;
    const BezierSurface &a = swapped ? draw.pair.below : draw.pair.above,
                        &b = swapped ? draw.pair.above : draw.pair.below;
    const SurfaceIntersection found = intersect(a, b);
    const std::string why = fault(draw, found);
    EXPECT_EQ(why, "") << "seed " << seed << ", " << draw.name << ", gap " << draw.gap
                       << " tolerances, scale " << draw.scale;
    faults += !why.empty();
  }
  std::cout << trials << " draws, " << faults << " faults\n";
}

}  // namespace
}  // namespace blossom
