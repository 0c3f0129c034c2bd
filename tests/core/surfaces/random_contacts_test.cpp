// SPDX-License-Identifier: LGPL-2.1-or-later
// Random pairs of patches in and near contact, with the answer known by construction.
//
// Two graphs c + h and c over the plane meet where h = 0. The base c is any cubic, h a loop, a
// pair of lines, a crossing, a node, a cusp or an acnode in any place and direction; both surfaces
// are then turned and two thirds of them raised to degree (5,5).
//
// A draw is named by its seed. BLOSSOM_TRIALS sets how many there are, BLOSSOM_SEED the first.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/surface_intersection.h"
#include "tests/support/components.h"
#include "tests/support/cubic_draws.h"
#include "tests/support/draws.h"
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

constexpr double kTolerance = 1e-7;

// What is less deep than this many tolerances may be taken as contact or as what it is.
constexpr double kBand = 6;

// Curves are written within the tolerance, and within more where they are led into a contact that
// is not quite one; this much would be a jump.
constexpr double kWellWritten = 1e-5;

// A contact nearer to the border than its own size, or a curve that all but touches the border,
// has another answer.
constexpr double kBorderMargin = 1e-5;

// Strips and branches with a gap of one to two tolerances, found as a strip in one part and as two
// branches in another.
constexpr std::array kKnownFaults{985, 1391};

struct Draw {
  std::string kind;
  Cubic h;
  Components exact;      ///< where h = 0
  Components merged;     ///< when what is less deep than the tolerance counts as contact
  double depth = 0;      ///< the largest |h| on the way between the two answers
  int border_roots = 0;  ///< sign changes of h along the border
  bool contact = false;  ///< the exact answer has a contact
  std::string details{};

  std::vector<Components> accepted() const {
    if (depth > kBand * kTolerance) return {exact};
    return {exact, merged};
  }
};

Draw loop_draw(Random& random) {
  const testing::Frame f(random);
  const double k = pick(random, 0, 1) == 0 ? 1 : 8, r = log_uniform(random, 1e-4, 0.2);
  return {"loop",        k * (f.x * f.x + f.y * f.y + constant(-r * r)),
          {.closed = 1}, {.points = 1},
          k * r * r,     0,
          false,         text("K ", k, " r ", r)};
}

Draw gap_draw(Random& random) {
  const testing::Frame f(random);
  const double k = pick(random, 0, 1) == 0 ? 1 : 8, gap = log_uniform(random, 1e-10, 1e-3);
  return {"gap", k * (f.x * f.x + f.y * f.y) + constant(gap),
          {},    {.points = 1},
          gap,   0,
          false, text("K ", k, " gap ", gap)};
}

Draw lines_draw(Random& random) {
  const testing::Frame f(random);
  const double e = log_uniform(random, 1e-8, 0.05);
  return {"lines",     f.x * f.x + constant(-e * e),
          {.open = 2}, {.open = 1, .tangential = 1},
          e * e,       4,
          false,       text("e ", e)};
}

Draw parallel_draw(Random& random) {
  const testing::Frame f(random);
  const double e = log_uniform(random, 1e-8, 0.05);
  return {
      "parallel",   f.x * f.x + constant(e * e), {}, {.open = 1, .tangential = 1}, e * e, 0, false,
      text("e ", e)};
}

Draw crossing_draw(Random& random) {
  const testing::Frame f(random);
  const double sign = pick(random, 0, 1) == 0 ? 1 : -1, d = log_uniform(random, 1e-8, 1e-2);
  return {"crossing",  f.x * f.y + constant(-sign * d),
          {.open = 2}, {.open = 4, .nodes = 1},
          d,           4,
          false,       text("d ", sign * d)};
}

// The loop is 4 s^3 / 27 deep.
Draw node_draw(Random& random) {
  const testing::Frame f(random);
  const double s = log_uniform(random, 1e-3, 0.2);
  return {"node",
          f.y * f.y + -1.0 * (f.x * f.x * (f.x + constant(s))),
          {.open = 3, .nodes = 1},
          {.open = 1},
          4 * s * s * s / 27,
          2,
          true,
          text("s ", s)};
}

Draw cusp_draw(Random& random) {
  const testing::Frame f(random);
  const double k = uniform(random, 0.3, 3);
  return {"cusp",       f.y * f.y + -k * (f.x * f.x * f.x), {.open = 1}, {.open = 1}, 1, 2, true,
          text("k ", k)};
}

Draw acnode_draw(Random& random) {
  const testing::Frame f(random);
  const double s = log_uniform(random, 1e-3, 0.2);
  return {"acnode",
          f.y * f.y + -1.0 * (f.x * f.x * (f.x + constant(-s))),
          {.open = 1, .points = 1},
          {.open = 1},
          4 * s * s * s / 27,
          2,
          true,
          text("s ", s)};
}

Draw oval_draw(Random& random) {
  const testing::Frame f(random);
  const double s = uniform(random, 0.02, 0.2), t = uniform(random, 0.02, 0.2);
  return {"oval",
          f.y * f.y + -1.0 * (f.x * (f.x + constant(s)) * (f.x + constant(-t))),
          {.open = 1, .closed = 1},
          {},
          1,
          2,
          false,
          text("s ", s, " t ", t)};
}

// Sign changes of h along the border of the unit square; -1 if there is nearly one more.
int border_roots(const Cubic& h) {
  constexpr int kSteps = 4000;
  std::vector<double> values;
  for (int i = 0; i < kSteps; ++i) values.push_back(h(double(i) / kSteps, 0));
  for (int i = 0; i < kSteps; ++i) values.push_back(h(1, double(i) / kSteps));
  for (int i = 0; i < kSteps; ++i) values.push_back(h(1 - double(i) / kSteps, 1));
  for (int i = 0; i < kSteps; ++i) values.push_back(h(0, 1 - double(i) / kSteps));
  int roots = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double a = values[i], b = values[(i + 1) % values.size()],
                 c = values[(i + 2) % values.size()];
    if ((a < 0) != (b < 0)) ++roots;
    const bool one_sign = (a < 0) == (b < 0) && (b < 0) == (c < 0);
    if (one_sign && std::abs(b) < kBorderMargin && std::abs(b) <= std::abs(a) &&
        std::abs(b) <= std::abs(c))
      return -1;
  }
  return roots;
}

// The lines' answers hold where no corner is near them; those of the others, where the border
// meets the curve as often as it should.
bool fits_the_square(const Draw& draw) {
  if (draw.kind == "lines" || draw.kind == "parallel")
    return std::min({std::abs(draw.h(0, 0)), std::abs(draw.h(1, 0)), std::abs(draw.h(0, 1)),
                     std::abs(draw.h(1, 1))}) > 4e-3;
  return border_roots(draw.h) == draw.border_roots;
}

Draw random_draw(Random& random) {
  constexpr std::array kKinds{loop_draw, loop_draw, gap_draw,    lines_draw, parallel_draw,
                              node_draw, cusp_draw, acnode_draw, oval_draw,  crossing_draw};
  const auto& kind = kKinds[static_cast<std::size_t>(pick(random, 0, kKinds.size() - 1))];
  for (;;)
    if (Draw draw = kind(random); fits_the_square(draw)) return draw;
}

struct PlacedDraw {
  testing::CubicPair pair;
  bool swapped = false;
  bool raised = false;
};

PlacedDraw place(const Draw& draw, Random& random) {
  const testing::CubicPair pair = cubic_pair(draw.h, testing::random_base(random));
  const testing::Motion motion = testing::random_motion(random);
  PlacedDraw placed{{moved(pair.a, motion), moved(pair.b, motion)}};
  placed.raised = pick(random, 0, 2) > 0;
  if (placed.raised)
    placed.pair = {testing::elevated(placed.pair.a, 5), testing::elevated(placed.pair.b, 5)};
  placed.swapped = pick(random, 0, 1) == 1;
  if (placed.swapped) std::swap(placed.pair.a, placed.pair.b);
  return placed;
}

// More samples than that are a fit that did not settle.
constexpr std::size_t kMaxSamples = 2000;

// The splines stay near the surfaces and are as long as the chords of their samples.
bool well_written(const IntersectionCurve& curve) {
  double chords = 0;
  for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i)
    chords += distance(curve.samples[i].point, curve.samples[i + 1].point);
  return curve.samples.size() <= kMaxSamples && curve.deviation.between <= kWellWritten &&
         std::abs(curve.length - chords) <= 0.01 * chords;
}

// What is wrong with an answer; empty if nothing is.
std::string fault(const Draw& draw, const PlacedDraw& placed, const SurfaceIntersection& found) {
  const Components c = components(found);
  if (found.status == Status::Complete && (draw.contact || c != draw.exact))
    return "false complete";
  if (found.status == Status::Stopped) return "stopped";
  const std::vector<Components> accepted = draw.accepted();
  if (std::find(accepted.begin(), accepted.end(), c) == accepted.end()) return "wrong";
  if (largest_offset(draw.h, placed.swapped, found) > kBand * kTolerance) return "off the curve";
  for (const IntersectionCurve& curve : found.curves)
    if (!well_written(curve)) return "badly written";
  return "";
}

std::string described(const Draw& draw, const PlacedDraw& placed,
                      const SurfaceIntersection& found) {
  std::ostringstream out;
  out << draw.kind << " " << draw.details << " depth " << draw.depth
      << (placed.raised ? ", raised" : "") << (placed.swapped ? ", swapped" : "") << "\n  found "
      << components(found) << " " << to_string(found.status) << ", accepted";
  for (const Components& c : draw.accepted()) out << " " << c;
  for (const std::string& reason : found.certificate.reasons) out << "\n  " << reason;
  for (const Place& place : found.places)
    out << "\n  place: " << to_string(place.kind) << " of size "
        << norm(place.box_high - place.box_low);
  for (const IntersectionCurve& curve : found.curves)
    out << "\n  curve: " << curve.length << ", deviation " << curve.deviation.between;
  return out.str();
}

struct Trial {
  std::string fault;
  std::string description;
  double milliseconds = 0;
};

Trial tried(int seed) {
  Random random = testing::seeded(seed);
  const Draw draw = random_draw(random);
  const PlacedDraw placed = place(draw, random);
  const auto start = std::chrono::steady_clock::now();
  const SurfaceIntersection found = intersect(placed.pair.a, placed.pair.b);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return {fault(draw, placed, found), described(draw, placed, found), time.count()};
}

// The draw of a seed, put to the test.
Trial trial(int seed) {
  Trial done = tried(seed);
  EXPECT_EQ(done.fault, "") << "seed " << seed << ", " << done.description;
  return done;
}

TEST(RandomContacts, HaveTheComponentsTheyWereBuiltWith) {
  const int first = setting("BLOSSOM_SEED", 0), trials = setting("BLOSSOM_TRIALS", 100);
  std::map<std::string, int> faults;
  std::vector<double> milliseconds;
  for (int seed = first; seed < first + trials; ++seed) {
    if (std::find(kKnownFaults.begin(), kKnownFaults.end(), seed) != kKnownFaults.end()) continue;
    const Trial done = trial(seed);
    milliseconds.push_back(done.milliseconds);
    if (!done.fault.empty()) ++faults[done.fault];
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  std::cout << trials << " draws, median " << milliseconds[milliseconds.size() / 2]
            << " ms, longest " << milliseconds.back() << " ms\n";
  for (const auto& [why, count] : faults) std::cout << why << ": " << count << "\n";
}

// Cusps whose closest point Newton's method did not reach, one rounded off by less than the
// tolerance, a crossing that misses its centre, an arc across the very corner of a cell, strips
// whose gap tells neither a point nor a curve, one that no fit can be better
// than, a branch with a sharp turn, and a loop that one order takes for a cusp.
TEST(RandomContacts, StayRightWhereTheyOnceWereWrong) {
  for (const int seed : {42, 572, 191, 3, 1143, 878, 1525, 1581, 2955, 1184}) trial(seed);
}

// They are left out above; what becomes right is to be named there no more.
TEST(RandomContacts, AreWrongWhereThatIsKnownAndNeverSaidToBeComplete) {
  for (const int seed : kKnownFaults) {
    const Trial done = tried(seed);
    EXPECT_EQ(done.fault, "wrong") << "seed " << seed << ", " << done.description;
  }
}

}  // namespace
}  // namespace blossom
