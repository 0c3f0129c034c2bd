// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/fills/fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/errors.h"
#include "core/blending/fills/fill_layout.h"
#include "core/forms/evaluation.h"
#include "tests/support/holes.h"

namespace blossom {
namespace {

using testing::base_cubic;
using testing::graph_hole;
using testing::loose_hole;
using testing::set_back_corner;

/// Angles and curvatures that conditions to rounding leave.
constexpr double kAngle = 1e-12;
constexpr double kCurvature = 1e-9;

double largest_angle(const Fill& made) {
  double angle = made.figures.inside.normal_angle;
  for (const FillContact& side : made.figures.sides) angle = std::max(angle, side.normal_angle);
  return angle;
}

double largest_bend(const Fill& made) {
  double difference = made.figures.inside.curvature_difference;
  for (const FillContact& side : made.figures.sides)
    difference = std::max(difference, side.curvature_difference);
  return difference / made.figures.largest_curvature;
}

double largest_gap(const Fill& made) {
  double gap = 0;
  for (const FillContact& side : made.figures.sides) gap = std::max(gap, side.gap);
  return gap;
}

/// Largest distance in z from the graph, at 9 x 9 places of each patch.
double off_graph(const Fill& made, const testing::Height& z) {
  double largest = 0;
  for (const RationalBezierPatch& patch : made.patches)
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j) {
        const Vec3 p = point_at(patch, i / 8.0, j / 8.0);
        largest = std::max(largest, std::abs(p[2] - z(p[0], p[1])));
      }
  return largest;
}

class FillOfNumber : public ::testing::TestWithParam<int> {};

TEST_P(FillOfNumber, FindsTheKnownCubicAsAStarThatIsG1ToRounding) {
  const Fill made = fill(graph_hole(GetParam(), FillContinuity::G1));
  ASSERT_EQ(made.problem, FillProblem::None) << made.message;
  EXPECT_EQ(made.layout, FillLayout::Star);
  EXPECT_EQ(made.patches.size(), static_cast<std::size_t>(GetParam()));
  EXPECT_LE(largest_angle(made), kAngle);
  EXPECT_LE(largest_gap(made), 1e-14);
  EXPECT_LE(off_graph(made, base_cubic), kAngle);
  EXPECT_FALSE(made.rational);
}

TEST_P(FillOfNumber, FindsTheKnownCubicAsAStarThatIsG2ToRounding) {
  const Fill made = fill(graph_hole(GetParam(), FillContinuity::G2));
  ASSERT_EQ(made.problem, FillProblem::None) << made.message;
  EXPECT_EQ(made.layout, FillLayout::Star);
  EXPECT_EQ(made.reached, FillContinuity::G2);
  EXPECT_LE(largest_angle(made), kAngle);
  EXPECT_LE(largest_bend(made), kCurvature);
  EXPECT_LE(off_graph(made, base_cubic), kAngle);
}

TEST_P(FillOfNumber, ReproducesCubicsInEveryLayout) {
  const auto z = [](double x, double y) { return 2 * x * x * x - x * x * y + 3 * y * y * y - x; };
  for (const FillLayout layout : {FillLayout::Star, FillLayout::Ring, FillLayout::DeepRing}) {
    const Fill made = fill(graph_hole(GetParam(), FillContinuity::G1, z), {.layout = layout});
    ASSERT_EQ(made.problem, FillProblem::None) << made.message;
    EXPECT_EQ(made.layout, layout);
    EXPECT_LE(off_graph(made, z), kAngle) << to_string(layout);
  }
}

TEST_P(FillOfNumber, TakesTheRingWhereTwistsDisagree) {
  const std::vector<FillSide> sides = loose_hole(GetParam(), FillContinuity::G1, 2, 1, GetParam());
  const Fill made = fill(sides);
  ASSERT_EQ(made.problem, FillProblem::None) << made.message;
  EXPECT_EQ(made.layout, FillLayout::Ring);
  EXPECT_EQ(made.patches.size(), static_cast<std::size_t>(3 * GetParam()));
  EXPECT_LE(largest_angle(made), kAngle);
  EXPECT_LE(largest_gap(made), 1e-14);
}

TEST_P(FillOfNumber, RefusesTheStarWhereTwistsDisagree) {
  const Fill made = fill(loose_hole(GetParam(), FillContinuity::G1, 2, 1, GetParam()),
                         {.layout = FillLayout::Star});
  EXPECT_EQ(made.problem, FillProblem::Conditions);
  EXPECT_TRUE(made.patches.empty());
  EXPECT_NE(made.message.find("twists"), std::string::npos) << made.message;
}

INSTANTIATE_TEST_SUITE_P(Sides, FillOfNumber, ::testing::Values(3, 4, 5, 6, 7, 8, 12));

class FillOfSecondOrder : public ::testing::TestWithParam<int> {};

TEST_P(FillOfSecondOrder, TakesTheDeepRingWhereSecondFormsAgree) {
  const Fill made = fill(loose_hole(GetParam(), FillContinuity::G2, 3, 2, GetParam()));
  ASSERT_EQ(made.problem, FillProblem::None) << made.message;
  EXPECT_EQ(made.layout, FillLayout::DeepRing);
  EXPECT_EQ(made.patches.size(), static_cast<std::size_t>(5 * GetParam()));
  EXPECT_EQ(made.reached, FillContinuity::G2);
  EXPECT_LE(largest_angle(made), 1e-10);
  EXPECT_LE(largest_bend(made), 1e-7);
}

TEST_P(FillOfSecondOrder, IsG1AndSaysSoWhereSecondFormsDisagree) {
  const Fill made = fill(loose_hole(GetParam(), FillContinuity::G2, 2, 1, GetParam()));
  ASSERT_EQ(made.problem, FillProblem::None) << made.message;
  EXPECT_EQ(made.reached, FillContinuity::G1);
  EXPECT_LE(largest_angle(made), 1e-10);
  EXPECT_GT(largest_bend(made), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Sides, FillOfSecondOrder, ::testing::Values(3, 4, 5, 6));

TEST(Fill, NeedsNoNeighbourWhereOnlyTheBorderIsAsked) {
  for (const int n : {3, 4, 5, 8}) {
    std::vector<FillSide> sides = graph_hole(n, FillContinuity::G0);
    for (FillSide& side : sides) side.across = side.bend = {};
    const Fill made = fill(sides);
    ASSERT_EQ(made.problem, FillProblem::None) << n << made.message;
    EXPECT_LE(largest_gap(made), 1e-14);
    EXPECT_LE(made.figures.inside.normal_angle, kAngle);
  }
}

TEST(Fill, TakesADifferentContinuityForEachSide) {
  std::vector<FillSide> sides = graph_hole(5, FillContinuity::G2);
  sides[1].continuity = FillContinuity::G1;
  sides[3] = {.edge = sides[3].edge, .across = {}, .bend = {}, .continuity = FillContinuity::G0};
  const Fill made = fill(sides);
  ASSERT_EQ(made.problem, FillProblem::None) << made.message;
  EXPECT_LE(largest_angle(made), 1e-10);
  EXPECT_EQ(made.figures.sides[3].normal_angle, 0);
  EXPECT_EQ(made.figures.sides[1].curvature_difference, 0);
  EXPECT_LE(made.figures.sides[0].curvature_difference, kCurvature * 10);
}

class FillOfCorner : public ::testing::TestWithParam<std::array<double, 3>> {};

TEST_P(FillOfCorner, MeetsThreeCylindersAndThreePlanes) {
  // Cylinders and planes do not twist along their borders, so even the star can do it.
  for (const FillLayout layout : {FillLayout::Star, FillLayout::Ring}) {
    const Fill made = fill(set_back_corner(GetParam(), 4), {.layout = layout});
    ASSERT_EQ(made.problem, FillProblem::None) << made.message;
    EXPECT_TRUE(made.rational);
    EXPECT_GT(made.least_weight, 0.5);
    EXPECT_LE(largest_angle(made), kAngle);
    EXPECT_LE(largest_gap(made), 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, FillOfCorner,
                         ::testing::Values(std::array{1.0, 1.0, 1.0}, std::array{1.0, 2.0, 3.0},
                                           std::array{0.5, 2.0, 0.7}));

/// Largest distance between the control points of two fills, after a map of those of the first.
template <class Map>
double apart(const Fill& a, const Fill& b, int first, const Map& map) {
  const std::size_t n = a.patches.size();
  const std::size_t shift = static_cast<std::size_t>(first) * n / a.figures.sides.size();
  double largest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const auto p = a.patches[k].points.values(), q = b.patches[(k + shift) % n].points.values();
    for (std::size_t i = 0; i < p.size(); ++i)
      largest = std::max(largest, distance(map(projected(p[i])), projected(q[i])));
  }
  return largest;
}

TEST(Fill, IsTheSameFromWhicheverSideOneStarts) {
  const std::vector<FillSide> sides = loose_hole(5, FillContinuity::G1, 2, 1, 7);
  std::vector<FillSide> turned = sides;
  std::rotate(turned.begin(), turned.begin() + 2, turned.end());
  EXPECT_LE(apart(fill(turned), fill(sides), 2, [](const Vec3& p) { return p; }), 1e-12);
}

TEST(Fill, GoesWithMotionsAndScales) {
  const std::vector<FillSide> sides = loose_hole(5, FillContinuity::G1, 2, 1, 7);
  const Fill made = fill(sides);
  for (const double scale : {1e-3, 1.0, 1e3}) {
    const auto map = [&](const Vec3& p) {
      const double c = std::cos(0.7), s = std::sin(0.7);
      return Vec3{scale * (c * p[0] - s * p[2]) + 3 * scale, scale * p[1] - scale,
                  scale * (s * p[0] + c * p[2])};
    };
    std::vector<FillSide> moved = sides;
    for (FillSide& side : moved)
      for (Row* const row : {&side.edge, &side.across, &side.bend})
        for (Vec4& p : *row) {
          const Vec3 base = map({}), image = map({p[0], p[1], p[2]});
          for (int x = 0; x < 3; ++x) p[x] = image[x] - base[x] * (1 - p[3]);
        }
    const Fill other = fill(moved, {.tolerances = {.point = 1e-7 * scale}});
    ASSERT_EQ(other.problem, FillProblem::None) << other.message;
    EXPECT_LE(apart(made, other, 0, map), 1e-12 * scale);
  }
}

/// The hole walked round the other way.
std::vector<FillSide> reversed(std::vector<FillSide> sides) {
  std::reverse(sides.begin(), sides.end());
  for (FillSide& side : sides)
    for (Row* const row : {&side.edge, &side.across, &side.bend})
      std::reverse(row->begin(), row->end());
  return sides;
}

TEST(Fill, IsAsGoodWalkedRoundTheOtherWay) {
  for (const int n : {3, 4, 6}) {
    const Fill made = fill(reversed(loose_hole(n, FillContinuity::G1, 2, 1, n)));
    ASSERT_EQ(made.problem, FillProblem::None) << made.message;
    EXPECT_LE(largest_angle(made), kAngle);
  }
}

struct BadHole {
  const char* name;
  FillProblem problem;
  std::function<void(std::vector<FillSide>&)> spoil;
};

void move(Row& row, std::size_t i, const Vec4& by) { row[i] += by; }

class BadFill : public ::testing::TestWithParam<BadHole> {};

TEST_P(BadFill, IsRefusedWithItsReasonAndNothingIsGivenOut) {
  std::vector<FillSide> sides = graph_hole(4, FillContinuity::G1);
  GetParam().spoil(sides);
  const Fill made = fill(sides);
  EXPECT_EQ(made.problem, GetParam().problem) << to_string(made.problem) << ": " << made.message;
  EXPECT_TRUE(made.patches.empty());
  EXPECT_FALSE(made.message.empty());
}

const BadHole kBadHoles[] = {
    {"SidesThatDoNotJoin", FillProblem::Gap,
     [](auto& sides) {
       move(sides[1].edge, 3, {0, 0, 2e-7, 0});
     }},
    {"SidesInTheWrongOrder", FillProblem::Gap, [](auto& sides) { std::swap(sides[0], sides[1]); }},
    {"SideThatRunsBackwards", FillProblem::Gap,
     [](auto& sides) { std::reverse(sides[2].edge.begin(), sides[2].edge.end()); }},
    {"TangentPlanesThatDiffer", FillProblem::TangentPlanes,
     [](auto& sides) {
       move(sides[0].across, 0, {0, 0, 1e-5, 0});
     }},
    {"EdgeOutOfTheNeighboursPlane", FillProblem::TangentPlanes,
     [](auto& sides) {
       sides[3] = {
           .edge = sides[3].edge, .across = {}, .bend = {}, .continuity = FillContinuity::G0};
       move(sides[3].edge, 2, {0, 0, 0.01, 0});
     }},
    {"SideWithoutLength", FillProblem::DegenerateSide,
     [](auto& sides) {
       const Vec4 corner = sides[0].edge.front();
       sides[0].edge.assign(4, corner);
       sides[1].edge.front() = corner;
     }},
    {"SideWithoutTangent", FillProblem::DegenerateSide,
     [](auto& sides) { sides[0].edge[1] = sides[0].edge[0]; }},
    {"NeighbourWithoutTangentPlane", FillProblem::DegenerateSide,
     [](auto& sides) { sides[2].across.assign(4, Vec4{}); }},
    {"NeighbourAlongItsSide", FillProblem::DegenerateSide,
     [](auto& sides) { sides[2].across.front() = sides[2].edge[1] - sides[2].edge[0]; }},
    {"NeighbourOnTheHolesSide", FillProblem::ReflexCorner,
     [](auto& sides) {
       for (FillSide& side : sides)
         for (Vec4& p : side.across) p = -p;
     }},
    {"CornerThatRunsOn", FillProblem::FlatCorner,
     [](auto& sides) {
       for (FillSide& side : sides)
         side = {.edge = {side.edge.front(), side.edge.back()},
                 .across = {},
                 .bend = {},
                 .continuity = FillContinuity::G0};
       const Vec4 middle = 0.5 * (sides[0].edge[0] + sides[0].edge[1]);
       sides.insert(sides.begin() + 1, sides[0]);
       sides[0].edge[1] = sides[1].edge[0] = middle;
     }},
    {"CornerThatRunsBack", FillProblem::FlatCorner,
     [](auto& sides) {
       for (FillSide& side : sides)
         side = {.edge = {side.edge.front(), side.edge.back()},
                 .across = {},
                 .bend = {},
                 .continuity = FillContinuity::G0};
       sides.resize(3);
       const Vec4 a = sides[0].edge[0], b = sides[0].edge[1];
       sides[1].edge = {b, 0.5 * (a + b)};
       sides[2].edge = {0.5 * (a + b), a};
     }},
    {"DegreeThatIsTooHigh", FillProblem::Degree,
     [](auto& sides) { sides[1].across = raised(sides[1].across, 13); }},
};

INSTANTIATE_TEST_SUITE_P(Rows, BadFill, ::testing::ValuesIn(kBadHoles),
                         [](const auto& row) { return row.param.name; });

TEST(Fill, ThrowsAtWhatIsNoHole) {
  const std::vector<FillSide> sides = graph_hole(4, FillContinuity::G1);
  std::vector<FillSide> bad(sides.begin(), sides.begin() + 2);
  EXPECT_THROW(fill(bad), InvalidInput);
  EXPECT_THROW(fill(std::vector<FillSide>(13, sides[0])), InvalidInput);
  bad = sides;
  bad[1].edge.clear();
  EXPECT_THROW(fill(bad), InvalidInput);
  bad = sides;
  bad[1].edge[1][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fill(bad), InvalidInput);
  bad = sides;
  bad[2].across[1][0] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(fill(bad), InvalidInput);
  bad = sides;
  bad[1].edge[1][3] = -1;
  EXPECT_THROW(fill(bad), InvalidInput);
  bad = sides;
  bad[1].across.clear();
  bad[1].bend.clear();
  EXPECT_THROW(fill(bad), InvalidInput);
  bad = graph_hole(4, FillContinuity::G2);
  bad[0].bend.clear();
  EXPECT_THROW(fill(bad), InvalidInput);
  bad = sides;
  bad[0].edge = raised(bad[0].edge, 20);
  EXPECT_THROW(fill(bad), InvalidInput);
}

}  // namespace
}  // namespace blossom
