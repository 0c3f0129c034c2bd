// SPDX-License-Identifier: LGPL-2.1-or-later
// What is claimed is true, where a claim is easily false: loops smaller than any sample or no
// deeper than the tolerance, surfaces apart by about the tolerance, loops cut by a border or a
// corner, in any position and of any size.
//
// Two graphs over the plane meet where h = 0, and the truth is a list of such points. A claim
// `complete` is false if a part of the truth is on no curve, a curve is not part of the truth, or
// their number is wrong. BLOSSOM_TRIALS sets how many draws there are, BLOSSOM_SEED the first.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "core/surface_intersection.h"
#include "tests/support/components.h"
#include "tests/support/cubic_draws.h"
#include "tests/support/draws.h"
#include "tests/support/intersection_checks.h"
#include "tests/support/random.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::Components;
using testing::components;
using testing::constant;
using testing::Cubic;
using testing::linear;
using testing::log_uniform;
using testing::pick;
using testing::Random;
using testing::setting;
using testing::text;
using testing::uniform;

using std::numbers::pi;

struct Plant {
  std::string kind;
  Cubic h;
  std::vector<Vec2> truth{};  ///< points with h = 0 in the unit square
  Components exact{};
  double size = 1;  ///< what the truth's position is compared to
  std::string details{};
};

template <std::size_t N>
double one_of(Random& random, const std::array<double, N>& values) {
  return values[static_cast<std::size_t>(pick(random, 0, static_cast<int>(N) - 1))];
}

bool in_square(const Vec2& p) { return p[0] >= 0 && p[0] <= 1 && p[1] >= 0 && p[1] <= 1; }

// The part of a circle in the unit square; arcs shorter than 1/3600 of it are not told apart.
Plant circle(std::string kind, double x, double y, double r, double scale) {
  constexpr int kSteps = 3600;
  Plant plant{std::move(kind), testing::loop(x, y, r, scale), {}, {}, r, {}};
  int starts = 0;
  for (int i = 0; i < kSteps; ++i) {
    const auto point = [&](int k) {
      return Vec2{x + r * std::cos(2 * pi * k / kSteps), y + r * std::sin(2 * pi * k / kSteps)};
    };
    if (!in_square(point(i))) continue;
    starts += !in_square(point(i + kSteps - 1));
    if (i % 30 == 0 || !in_square(point(i + kSteps - 1))) plant.truth.push_back(point(i));
  }
  plant.exact.open = starts;
  plant.exact.closed = starts == 0 && !plant.truth.empty();
  plant.details = text("centre ", x, " ", y, " radius ", r, " scale ", scale);
  return plant;
}

constexpr std::array kScales{1.0, 8.0, 100.0};

// No deeper than some tolerances; every other one in the very middle of cells.
Plant shallow_loop(Random& random, double tolerance) {
  const double scale = one_of(random, kScales);
  const double depth =
      tolerance * one_of(random, std::array{0.5, 0.9, 0.99, 1.0, 1.01, 1.1, 2.0, 10.0});
  const bool dyadic = pick(random, 0, 1) == 1;
  const double x = dyadic ? pick(random, 1, 15) / 16.0 : uniform(random, 0.1, 0.9);
  const double y = dyadic ? pick(random, 1, 15) / 16.0 : uniform(random, 0.1, 0.9);
  return circle("shallow loop", x, y, std::sqrt(depth / scale), scale);
}

Plant tiny_loop(Random& random, double) {
  const double r = log_uniform(random, 1e-7, 1e-4);
  return circle("tiny loop", uniform(random, 0.1, 0.9), uniform(random, 0.1, 0.9), r,
                one_of(random, kScales));
}

Plant border_loop(Random& random, double) {
  const double r = log_uniform(random, 1e-5, 1e-2);
  const double off = r * uniform(random, -1.2, 1.2), along = uniform(random, 0.1, 0.9);
  const bool far = pick(random, 0, 1) == 1;
  const double x = far ? 1 - off : off;
  const bool exchanged = pick(random, 0, 1) == 1;
  return circle("border loop", exchanged ? along : x, exchanged ? x : along, r,
                one_of(random, kScales));
}

Plant corner_loop(Random& random, double) {
  const double r = log_uniform(random, 1e-5, 1e-2);
  const double x = r * uniform(random, -0.6, 0.95), y = r * uniform(random, -0.6, 0.95);
  return circle("corner loop", pick(random, 0, 1) == 1 ? 1 - x : x,
                pick(random, 0, 1) == 1 ? 1 - y : y, r, one_of(random, kScales));
}

constexpr std::array kGaps{0.5, 0.9, 1.0, 1.1, 2.0};

Plant gap_at_a_point(Random& random, double tolerance) {
  const double scale = one_of(random, kScales), gap = tolerance * one_of(random, kGaps);
  const double x = uniform(random, 0.1, 0.9), y = uniform(random, 0.1, 0.9);
  return {"gap at a point",
          testing::loop(x, y, 0, scale) + constant(gap),
          {},
          {},
          1,
          text("centre ", x, " ", y, " scale ", scale, " gap ", gap)};
}

void keep_inside(Plant& plant) {
  std::erase_if(plant.truth, [](const Vec2& p) { return !in_square(p); });
}

bool corners_are_clear(const Cubic& h) {
  return std::min({std::abs(h(0, 0)), std::abs(h(1, 0)), std::abs(h(0, 1)), std::abs(h(1, 1))}) >
         4e-3;
}

Plant gap_along_a_line(Random& random, double tolerance) {
  const testing::Frame f(random);
  const double gap = tolerance * one_of(random, kGaps);
  return {"gap along a line", f.x * f.x + constant(gap), {}, {}, 1, text("gap ", gap)};
}

Plant shallow_lines(Random& random, double tolerance) {
  for (;;) {
    const testing::Frame f(random);
    const double depth = tolerance * one_of(random, std::array{0.5, 0.99, 1.01, 2.0, 10.0});
    const double e = std::sqrt(depth);
    Plant plant{"shallow lines",      f.x * f.x + constant(-depth), {}, {.open = 2}, e,
                text("depth ", depth)};
    for (int i = -100; i <= 100; ++i)
      for (const double x : {-e, e}) plant.truth.push_back(f.point(x, i / 70.0));
    keep_inside(plant);
    if (corners_are_clear(plant.h)) return plant;
  }
}

Plant narrow_crossing(Random& random, double tolerance) {
  for (;;) {
    const testing::Frame f(random);
    const double d = tolerance * one_of(random, std::array{0.5, 0.99, 1.01, 2.0, 10.0});
    Plant plant{"narrow crossing", f.x * f.y + constant(-d), {}, {.open = 2}, std::sqrt(d),
                text("d ", d)};
    for (int i = -60; i <= 60; ++i)
      for (const double sign : {-1.0, 1.0}) {
        const double x = std::sqrt(d) * std::pow(1.4 / std::sqrt(d), i / 60.0);
        plant.truth.push_back(f.point(sign * x, sign * d / x));
      }
    keep_inside(plant);
    if (corners_are_clear(plant.h)) return plant;
  }
}

struct Placed {
  Cubic base;
  testing::Motion motion;
  testing::CubicPair pair;
  double tolerance = 1e-7;  ///< model units
  bool swapped = false;

  Vec3 point(const Vec2& uv) const {
    const Vec3 p{uv[0], uv[1], base(uv[0], uv[1])};
    Vec3 moved = motion.shift;
    for (int k = 0; k < 3; ++k)
      moved[k] += motion.scale * dot(motion.rotation[static_cast<std::size_t>(k)], p);
    return moved;
  }
};

Placed place(const Plant& plant, double tolerance, Random& random) {
  Placed placed;
  placed.base = testing::random_base(random);
  placed.motion = testing::random_motion(random);
  placed.motion.scale = one_of(random, std::array{1e-3, 1.0, 1e3});
  placed.motion.shift *= placed.motion.scale;
  placed.tolerance = tolerance * placed.motion.scale;
  const testing::CubicPair pair = cubic_pair(plant.h, placed.base);
  placed.pair = {moved(pair.a, placed.motion), moved(pair.b, placed.motion)};
  placed.swapped = pick(random, 0, 1) == 1;
  if (placed.swapped) std::swap(placed.pair.a, placed.pair.b);
  return placed;
}

// How far from a point of the truth a curve may run beside it: as far as h stays below the distance
// that the curve states, but by no more than half the size of what is looked for.
double leeway(const Plant& plant, const Placed& placed, const SurfaceIntersection& found,
              const Vec2& uv) {
  constexpr double kStep = 1e-6;
  const double x = uv[0], y = uv[1];
  const double slope = std::hypot(plant.h(x + kStep, y) - plant.h(x - kStep, y),
                                  plant.h(x, y + kStep) - plant.h(x, y - kStep)) /
                       (2 * kStep);
  double gap = placed.tolerance;
  for (const IntersectionCurve& curve : found.curves) gap = std::max(gap, curve.deviation.between);
  return gap + std::min(gap / slope, 0.5 * plant.size * placed.motion.scale);
}

bool all_truth_is_found(const Plant& plant, const Placed& placed,
                        const SurfaceIntersection& found) {
  const testing::CurveDistance curves(found);
  return std::all_of(plant.truth.begin(), plant.truth.end(), [&](const Vec2& uv) {
    return curves.to(placed.point(uv)) <= leeway(plant, placed, found, uv);
  });
}

// What is wrong with a claim to be complete; empty if nothing is.
std::string fault(const Plant& plant, const Placed& placed, const SurfaceIntersection& found) {
  constexpr double kOnBoth = 1e-9;  // of h at the samples, which are on both surfaces to rounding
  if (components(found) != plant.exact) return "another number";
  if (!found.places.empty()) return "with places";
  if (largest_offset(plant.h, placed.swapped, found) > kOnBoth) return "a curve that is none";
  if (!all_truth_is_found(plant, placed, found)) return "a part of the truth is missing";
  return "";
}

std::string described(const Plant& plant, const Placed& placed, const SurfaceIntersection& found) {
  return text(plant.kind, ", ", plant.details, ", size of the model ", placed.motion.scale,
              ", tolerance ", placed.tolerance, placed.swapped ? ", swapped" : "", "\n  found ",
              components(found), " ", to_string(found.status), ", exact ", plant.exact);
}

Plant random_plant(Random& random, double tolerance) {
  constexpr std::array kKinds{shallow_loop,   tiny_loop,        border_loop,   corner_loop,
                              gap_at_a_point, gap_along_a_line, shallow_lines, narrow_crossing};
  return kKinds[static_cast<std::size_t>(pick(random, 0, kKinds.size() - 1))](random, tolerance);
}

TEST(ClaimsToBeComplete, AreTrueWherePlantsInviteFalseOnes) {
  const int first = setting("BLOSSOM_SEED", 0), trials = setting("BLOSSOM_TRIALS", 200);
  std::map<std::string, int> outcomes;
  for (int seed = first; seed < first + trials; ++seed) {
    Random random = testing::seeded(seed);
    const double tolerance = one_of(random, std::array{1e-9, 1e-7, 1e-5});
    const Plant plant = random_plant(random, tolerance);
    const Placed placed = place(plant, tolerance, random);

    const SurfaceIntersection found =
        intersect(placed.pair.a, placed.pair.b, {.tolerances = {.point = placed.tolerance}});

    ++outcomes[plant.kind + ": " + to_string(found.status)];
    if (found.status != Status::Complete) continue;
    EXPECT_EQ(fault(plant, placed, found), "")
        << "seed " << seed << ", " << described(plant, placed, found);
  }
  for (const auto& [outcome, count] : outcomes) std::cout << outcome << ": " << count << "\n";
}

}  // namespace
}  // namespace blossom
