// SPDX-License-Identifier: LGPL-2.1-or-later
// The same intersection whichever way the same two surfaces are written down.

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/subdivision/patch_subdivision.h"
#include "core/surface_intersection.h"
#include "tests/support/components.h"
#include "tests/support/cubic_family.h"
#include "tests/support/intersection_checks.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::Components;
using testing::components;
using testing::constant;
using testing::Cubic;
using testing::cubic_pair;
using testing::CubicPair;
using testing::linear;
using testing::loop;
using testing::moved;
using testing::oval;
using testing::Random;
using testing::random_motion;
using testing::random_weight;
using testing::uniform;

const Cubic kX = linear(-0.43, 1, 0), kY = linear(-0.57, 0, 1), kMiddleY = linear(-0.5, 0, 1);
const Cubic kLine = linear(-0.6, 1, 0.2);

// Parts of one tangential curve may have places of their own.
std::vector<PlaceKind> kinds(const SurfaceIntersection& found) {
  std::vector<PlaceKind> all;
  for (const Place& place : found.places)
    if (place.kind != PlaceKind::Tangential || all.empty() || all.back() != place.kind)
      all.push_back(place.kind);
  return all;
}

struct Row {
  const char* name;
  Cubic h;
  Components expected;
  std::vector<PlaceKind> places{};
  double accuracy = 1e-5;  ///< of lengths: a curve may end anywhere in a place

  bool regular() const { return places.empty(); }
};

const std::vector<Row> kRows{
    {"transversal", linear(-0.5, 1, 0) + 0.3 * kMiddleY + 0.4 * (kMiddleY * kMiddleY), {.open = 1}},
    {"loop_2e_1", loop(0.43, 0.57, 0.2), {.closed = 1}},
    {"loop_1e_1", loop(0.43, 0.57, 0.1), {.closed = 1}},
    {"loop_5e_2", loop(0.43, 0.57, 0.05), {.closed = 1}},
    {"loop_2e_2", loop(0.43, 0.57, 0.02), {.closed = 1}},
    {"loop_1e_2", loop(0.43, 0.57, 0.01), {.closed = 1}},
    {"loop_5e_3", loop(0.43, 0.57, 0.005), {.closed = 1}},
    {"loop_1e_3", loop(0.43, 0.57, 0.001), {.closed = 1}},
    {"near_tangent_1e_2", kLine* kLine + constant(-1e-4), {.open = 2}},
    {"near_tangent_1e_3", kLine* kLine + constant(-1e-6), {.open = 2}},
    {"near_crossing_1e_3", kX* kY + constant(-1e-3), {.open = 2}},
    {"near_crossing_1e_5", kX* kY + constant(-1e-5), {.open = 2}},
    {"oval_and_branch", oval(0.2, 0.4, 0.7), {.open = 1, .closed = 1}},
    {"small_oval_and_branch", oval(0.3, 0.33, 0.7), {.open = 1, .closed = 1}},
    {"near_disjoint", loop(0.43, 0.57, 0) + constant(1e-6), {}},
    {"touch", loop(0.43, 0.57, 0), {.points = 1}, {PlaceKind::Touch}},
    {"tangent_curve", kLine* kLine, {.open = 1, .tangential = 1}, {PlaceKind::Tangential}},
    {"near_tangent_1e_4",
     kLine* kLine + constant(-1e-8),
     {.open = 1, .tangential = 1},
     {PlaceKind::Tangential}},
    {"crossing", kX* kY, {.open = 4, .nodes = 1}, {PlaceKind::Node}},
    {"node",
     kY* kY + -1.0 * (kX * kX * linear(-0.13, 1, 0)),
     {.open = 3, .nodes = 1},
     {PlaceKind::Node}},
    {"cusp", kY* kY + -1.0 * (kX * kX * kX), {.open = 1}, {PlaceKind::Cusp}},
    {"acnode", oval(0.3, 0.3, 0.6), {.open = 1, .points = 1}, {PlaceKind::Touch}},
    {"tacnode", kY*(kY + -1.0 * (kX * kX)), {.open = 4, .nodes = 1}, {PlaceKind::Node}, 0.07},
    {"odd_contact", kLine* kLine* kLine, {.open = 1, .tangential = 1}, {PlaceKind::Tangential}},
};

struct Change {
  const char* name;
  std::function<CubicPair(const CubicPair&, Random&)> apply;
  double scale = 1;
  int draws = 1;  ///< of what is random in it
};

Change motion(const char* name, double scale) {
  const auto apply = [scale](const CubicPair& pair, Random& random) {
    testing::Motion motion = random_motion(random);
    motion.scale = scale;
    return CubicPair{moved(pair.a, motion), moved(pair.b, motion)};
  };
  return {name, apply, scale, 3};
}

Change scaling(const char* name, double scale) {
  const auto apply = [scale](const CubicPair& pair, Random&) {
    return CubicPair{moved(pair.a, {.scale = scale}), moved(pair.b, {.scale = scale})};
  };
  return {name, apply, scale};
}

Change elevation(const char* name, int a, int b) {
  const auto apply = [a, b](const CubicPair& pair, Random&) {
    return CubicPair{testing::elevated(pair.a, a), testing::elevated(pair.b, b)};
  };
  return {name, apply};
}

BezierSurface split_in_v(const BezierSurface& surface, double cut) {
  return testing::exchanged(testing::split_in_u(testing::exchanged(surface), cut));
}

Change split(const char* name, const auto& cut_a, const auto& cut_b) {
  const auto apply = [=](const CubicPair& pair, Random& random) {
    const double cut = uniform(random, 0.15, 0.85);
    return CubicPair{cut_a(pair.a, cut), cut_b(pair.b, cut)};
  };
  return {name, apply, 1, 3};
}

BezierSurface same(const BezierSurface& surface, double) { return surface; }

// Into n x n patches, cut anywhere.
BezierSurface in_pieces(const BezierSurface& surface, int n, Random& random) {
  const auto cuts = [&] {
    std::vector<double> all{0, 1};
    for (int k = 1; k < n; ++k) all.insert(all.end() - 1, (k - uniform(random, -0.35, 0.35)) / n);
    return all;
  };
  BezierSurface cut{cuts(), cuts()};
  cut.rational = surface.rational;
  cut.patches = subdivide(surface.patches(0, 0), cut.u_knots, cut.v_knots);
  return cut;
}

Change pieces(const char* name, int n) {
  const auto apply = [n](const CubicPair& pair, Random& random) {
    return CubicPair{in_pieces(pair.a, n, random), in_pieces(pair.b, n, random)};
  };
  return {name, apply, 1, 5};
}

const std::vector<Change> kChanges{
    {"swapped",
     [](const CubicPair& p, Random&) {
       return CubicPair{p.b, p.a};
     }},
    {"reversed",
     [](const CubicPair& p, Random&) {
       return CubicPair{testing::reversed(p.a), testing::reversed(p.b)};
     }},
    {"exchanged",
     [](const CubicPair& p, Random&) {
       return CubicPair{testing::exchanged(p.a), testing::exchanged(p.b)};
     }},
    motion("rotated", 1),
    motion("rotated_and_small", 1e-3),
    motion("rotated_and_large", 1e3),
    scaling("small", 1e-3),
    scaling("large", 1e3),
    elevation("elevated_a", 5, 3),
    elevation("elevated_b", 3, 5),
    elevation("elevated_both", 7, 7),
    split("split_a_in_u", testing::split_in_u, same),
    split("split_a_in_v", split_in_v, same),
    split("split_b_in_u", same, testing::split_in_u),
    split("split_b_in_v", same, split_in_v),
    split("split_both", testing::split_in_u, split_in_v),
    pieces("in_four_pieces", 2),
    pieces("in_nine_pieces", 3),
    {"weighted_a",
     [](const CubicPair& p, Random& random) {
       return CubicPair{testing::weighted(p.a, random_weight(random)), p.b};
     },
     1, 3},
    {"weighted_b",
     [](const CubicPair& p, Random& random) {
       return CubicPair{p.a, testing::weighted(p.b, random_weight(random))};
     },
     1, 3},
};

class Metamorphic : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  const Row& row() const { return kRows[static_cast<std::size_t>(std::get<0>(GetParam()))]; }
  const Change& change() const {
    return kChanges[static_cast<std::size_t>(std::get<1>(GetParam()))];
  }
};

TEST_P(Metamorphic, ChangesNothing) {
  const CubicPair pair = cubic_pair(row().h);
  const std::vector<double> before = testing::sorted_lengths(intersect(pair.a, pair.b), 1);
  for (int seed = 0; seed < change().draws; ++seed) {
    SCOPED_TRACE(seed);
    Random random = testing::seeded(seed);
    const CubicPair changed = change().apply(pair, random);

    const SurfaceIntersection found = intersect(
        changed.a, changed.b, {.tolerances = {.point = Tolerances{}.point * change().scale}});

    EXPECT_EQ(components(found), row().expected);
    EXPECT_EQ(kinds(found), row().places);
    EXPECT_NE(found.status, Status::Stopped);
    if (row().regular()) {
      EXPECT_EQ(found.status, Status::Complete);
    }
    const std::vector<double> after = testing::sorted_lengths(found, change().scale);
    ASSERT_EQ(after.size(), before.size());
    const double accuracy = row().regular() ? 1e-6 : row().accuracy;
    for (std::size_t i = 0; i < after.size(); ++i)
      EXPECT_NEAR(after[i], before[i], accuracy * before[i]);
  }
}

// The whole of a lies on b.
TEST(MetamorphicOverlap, ChangesNothing) {
  const CubicPair pair = cubic_pair(constant(0));
  const auto boundary = [](const SurfaceIntersection& found) {
    double sum = 0;
    for (const Overlap& overlap : found.overlaps)
      for (std::size_t i = 0; i + 1 < overlap.boundary.size(); ++i)
        sum += distance(overlap.boundary[i].point, overlap.boundary[i + 1].point);
    return sum;
  };
  const double before = boundary(intersect(pair.a, pair.b));
  for (const Change& change : kChanges) {
    SCOPED_TRACE(change.name);
    Random random = testing::seeded(0);
    const CubicPair changed = change.apply(pair, random);

    const SurfaceIntersection found = intersect(
        changed.a, changed.b, {.tolerances = {.point = Tolerances{}.point * change.scale}});

    EXPECT_EQ(found.status, Status::Tolerance);
    EXPECT_EQ(components(found), Components{});
    EXPECT_EQ(found.overlaps.size(), 1u);
    EXPECT_EQ(kinds(found), std::vector{PlaceKind::Overlap});
    EXPECT_NEAR(boundary(found) / change.scale, before, 1e-4 * before);
  }
}

// Where patches have corners in the band along a contact of third order it lies over several of
// them, over some for a short stretch only.
TEST(MetamorphicPieces, OddContactStaysOneCurve) {
  struct Draw {
    int pieces, seed;
  };
  for (const double scale : {1.0, 0.1})
    for (const Draw& draw : std::vector<Draw>{
             {2, 2}, {2, 34}, {2, 45}, {2, 120}, {2, 181}, {3, 9}, {3, 34}, {3, 42}}) {
      SCOPED_TRACE(std::to_string(draw.pieces) + " pieces, seed " + std::to_string(draw.seed));
      const CubicPair pair = cubic_pair(scale * (kLine * kLine * kLine));
      Random random = testing::seeded(draw.seed);
      const BezierSurface a = in_pieces(pair.a, draw.pieces, random);
      const BezierSurface b = in_pieces(pair.b, draw.pieces, random);

      const SurfaceIntersection found = intersect(a, b);

      EXPECT_EQ(components(found), (Components{.open = 1, .tangential = 1}));
      EXPECT_EQ(kinds(found), std::vector{PlaceKind::Tangential});
      EXPECT_EQ(found.status, Status::Tolerance);
      ASSERT_EQ(found.curves.size(), 1u);
      EXPECT_NEAR(found.curves[0].length, intersect(pair.a, pair.b).curves[0].length, 1e-5);
    }
}

// Everything that was found, to the last bit.
TEST(Threads, ChangeNothing) {
  for (const Row& row : kRows) {
    const CubicPair pair = cubic_pair(row.h);
    const SurfaceIntersection alone = intersect(pair.a, pair.b, {.threads = 1});
    for (const int threads : {0, 2, 5}) {
      SCOPED_TRACE(row.name + std::string(" with ") + std::to_string(threads));
      const SurfaceIntersection found = intersect(pair.a, pair.b, {.threads = threads});
      EXPECT_EQ(found.status, alone.status);
      EXPECT_EQ(found.certificate.excluded, alone.certificate.excluded);
      EXPECT_EQ(found.certificate.certified, alone.certificate.certified);
      EXPECT_EQ(kinds(found), kinds(alone));
      ASSERT_EQ(found.curves.size(), alone.curves.size());
      for (std::size_t i = 0; i < alone.curves.size(); ++i) {
        EXPECT_EQ(found.curves[i].curve.points, alone.curves[i].curve.points);
        EXPECT_EQ(found.curves[i].deviation.between, alone.curves[i].deviation.between);
      }
    }
  }
}

// Likewise, whichever comes first, but for what belongs to which of them.
TEST(SwappedSurfaces, ChangeNothing) {
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.name);
    const CubicPair pair = cubic_pair(row.h);
    const SurfaceIntersection found = intersect(pair.a, pair.b), other = intersect(pair.b, pair.a);
    EXPECT_EQ(found.status, other.status);
    EXPECT_EQ(found.certificate.excluded, other.certificate.excluded);
    EXPECT_EQ(kinds(found), kinds(other));
    ASSERT_EQ(found.curves.size(), other.curves.size());
    for (std::size_t i = 0; i < found.curves.size(); ++i) {
      EXPECT_EQ(found.curves[i].curve.points, other.curves[i].curve.points);
      EXPECT_EQ(found.curves[i].chart_a.points, other.curves[i].chart_b.points);
      EXPECT_EQ(found.curves[i].chart_b.points, other.curves[i].chart_a.points);
    }
  }
}

std::string case_name(const ::testing::TestParamInfo<std::tuple<int, int>>& which) {
  const auto [row, change] = which.param;
  return std::string(kRows[static_cast<std::size_t>(row)].name) + "__" +
         kChanges[static_cast<std::size_t>(change)].name;
}

INSTANTIATE_TEST_SUITE_P(Rows, Metamorphic,
                         ::testing::Combine(::testing::Range(0, static_cast<int>(kRows.size())),
                                            ::testing::Range(0, static_cast<int>(kChanges.size()))),
                         case_name);

}  // namespace
}  // namespace blossom
