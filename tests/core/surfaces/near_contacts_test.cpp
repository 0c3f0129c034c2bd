// SPDX-License-Identifier: LGPL-2.1-or-later
// Gaps below the tolerance are contacts: a bowl, a trough or a ball a little above a plane, or a
// little in it, in any pose and size.
//
// A draw is named by its seed. BLOSSOM_TRIALS sets how many there are, BLOSSOM_SEED the first.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

#include "core/surface_intersection.h"
#include "tests/support/draws.h"
#include "tests/support/random.h"
#include "tests/support/solids.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::Random;

using testing::setting;

enum class Above { Bowl, Trough, Ball };

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

struct NearDraw {
  Above kind = Above::Bowl;
  double gap = 0;  // in tolerances
  BezierSurface above, plane;
  std::string words;
};

NearDraw random_near_draw(Random& random) {
  NearDraw draw;
  draw.kind = static_cast<Above>(testing::pick(random, 0, 2));
  const double tolerance = 1e-7;
  const int sign = testing::pick(random, 0, 3) == 0 ? -1 : 1;
  draw.gap = testing::pick(random, 0, 2) == 0
                 ? testing::uniform(random, -2, 2)
                 : sign * std::pow(10, testing::uniform(random, -6, 0.3));
  const double scale =
      testing::pick(random, 0, 1) == 0 ? 1 : std::pow(10, testing::uniform(random, -3, 4));
  const double gap = draw.gap * tolerance / scale;
  const double p = testing::uniform(random, 0.1, 2), q = testing::uniform(random, 0.1, 2);
  // Corners of cells are places of their own.
  const bool even = testing::pick(random, 0, 2) == 0;
  const double a = even ? 0.25 * testing::pick(random, -2, 2) : testing::uniform(random, -0.8, 0.8);
  const double b = even ? 0.25 * testing::pick(random, -2, 2) : testing::uniform(random, -0.8, 0.8);
  if (draw.kind == Above::Bowl) draw.above = bowl(p, q, a, b, gap);
  if (draw.kind == Above::Trough) draw.above = bowl(p, 0, a, b, gap);
  testing::Motion motion = testing::random_motion(random);
  if (testing::pick(random, 0, 3) == 0) motion.rotation = testing::Motion{}.rotation;
  if (draw.kind == Above::Ball) {
    testing::Motion own = testing::random_motion(random);
    own.shift = {a, b, 1 + gap};
    draw.above = testing::moved(testing::unit_sphere(), own);
  }
  motion.scale = scale;
  for (int k = 0; k < 3; ++k) motion.shift[k] *= scale;
  draw.above = testing::moved(draw.above, motion);
  draw.plane = testing::moved(
      testing::quadrilateral({-1.1, -1.2, 0}, {-1.1, 1.3, 0}, {1.2, -1.2, 0}, {1.2, 1.3, 0}),
      motion);
  std::ostringstream text;
  text << (draw.kind == Above::Bowl     ? "bowl"
           : draw.kind == Above::Trough ? "trough"
                                        : "ball")
       << ", gap " << draw.gap << " tolerances, scale " << scale;
  draw.words = text.str();
  return draw;
}

// What is wrong with the answer; empty if nothing is.
std::string fault(const NearDraw& draw, const SurfaceIntersection& found) {
  if (found.status == Status::Stopped) return "stopped";
  const bool any = !found.curves.empty() || !found.points.empty() || !found.overlaps.empty() ||
                   !found.places.empty();
  // Rounding of nets may move them by some of their last digits.
  if (draw.gap < 0.99 && !any) return "nothing where they are nearer than the tolerance";
  if (draw.gap > 1.99 && !found.curves.empty()) return "a curve where they are apart";
  return "";
}

TEST(NearContacts, AreNeverMissed) {
  const int first = setting("BLOSSOM_SEED", 0), trials = setting("BLOSSOM_TRIALS", 100);
  int faults = 0;
  for (int seed = first; seed < first + trials; ++seed) {
    Random random = testing::seeded(seed);
    const NearDraw draw = random_near_draw(random);
    const bool swapped = testing::pick(random, 0, 1) == 1;
    const SurfaceIntersection found = swapped
                                          ? intersect(draw.plane, draw.above, {.time_limit = 10})
                                          : intersect(draw.above, draw.plane, {.time_limit = 10});
    const std::string why = fault(draw, found);
    EXPECT_EQ(why, "") << "seed " << seed << ", " << draw.words;
    faults += !why.empty();
  }
  std::cout << trials << " draws, " << faults << " faults\n";
}

}  // namespace
}  // namespace blossom
