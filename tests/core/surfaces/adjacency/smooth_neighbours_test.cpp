// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/adjacency/smooth_neighbours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/cells/direction_cones.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/evaluation.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/surface_intersection.h"

namespace blossom {
namespace {

const IntersectionOptions kOptions;

BezierSurface surface_of(const RationalBezierPatch& patch) {
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  surface.patches(0, 0) = patch;
  return surface;
}

// Half of a tube of radius 1, by a cubic: from v = 0 at y = 0 to v = 1 at y = 0, upper or lower.
RationalBezierPatch half_tube(double side) {
  constexpr double kBow = 4.0 / 3;
  RationalBezierPatch patch{Grid<Vec4>(4, 4)};
  const std::array<Vec2, 4> profile{Vec2{1, 0}, Vec2{1, side * kBow}, Vec2{-1, side * kBow},
                                    Vec2{-1, 0}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Vec2& p = profile[static_cast<std::size_t>(j)];
      patch.points(i, j) = {p[0], p[1], 0.9 * i + 0.2 * i * i, 1};
    }
  return patch;
}

RationalBezierPatch wavy() {
  RationalBezierPatch patch{Grid<Vec4>(4, 4)};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      patch.points(i, j) = {i + 0.1 * j, j - 0.07 * i * i, std::sin(2.3 * i + j), 1};
  return patch;
}

// The patch seen with u and v turned round or exchanged.
RationalBezierPatch turned(const RationalBezierPatch& patch, int way) {
  RationalBezierPatch result = patch;
  const Grid<Vec4>& net = patch.points;
  const int n = net.rows() - 1;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const int k = (way & 1) != 0 ? n - i : i, l = (way & 2) != 0 ? n - j : j;
      result.points(i, j) = (way & 4) != 0 ? net(l, k) : net(k, l);
    }
  return result;
}

class Turned : public ::testing::TestWithParam<int> {};

TEST_P(Turned, HalvesMeetInTheirBorder) {
  const RationalBezierPatch whole = wavy();
  const BezierSurface a = surface_of(sub_patch(whole, {0, 0.5}, {0, 1}));
  const BezierSurface b = surface_of(turned(sub_patch(whole, {0.5, 1}, {0, 1}), GetParam()));
  const SurfaceIntersection found = intersect(a, b);
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_EQ(found.certificate.critical, 0);
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_TRUE(found.points.empty() && found.places.empty());
  const IntersectionCurve& curve = found.curves.front();
  EXPECT_TRUE(curve.tangential);
  EXPECT_LE(std::max(curve.deviation.a, curve.deviation.b), 1e-7);
  for (const double t : {0.0, 0.3, 1.0}) {
    const Vec3 x = point_at(curve.curve, at(curve.curve.domain(), t));
    EXPECT_LE(
        distance(x, point_at(a, {1, point_at(curve.chart_a, at(curve.curve.domain(), t))[1]})),
        1e-7);
  }
}

TEST_P(Turned, QuartersMeetInTheirCorner) {
  const RationalBezierPatch whole = wavy();
  const BezierSurface a = surface_of(sub_patch(whole, {0, 0.5}, {0, 0.5}));
  const BezierSurface b = surface_of(turned(sub_patch(whole, {0.5, 1}, {0.5, 1}), GetParam()));
  const SurfaceIntersection found = intersect(a, b);
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_EQ(found.certificate.critical, 0);
  EXPECT_TRUE(found.curves.empty());
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_LE(distance(found.points.front().point, point_at(whole, 0.5, 0.5)), 1e-12);
}

// From a wave along the y axis to x = 3 `way`, rising by `slope`.
RationalBezierPatch side_of_crease(double way, double slope) {
  constexpr std::array kWave{0.0, 0.5, 0.25, 0.75};
  RationalBezierPatch patch{Grid<Vec4>(4, 4)};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      patch.points(i, j) = {way * i, j + 0.125 * i * i,
                            kWave[static_cast<std::size_t>(j)] + slope * i, 1};
  return patch;
}

bool is_taken(const BezierSurface& a, const BezierSurface& b) {
  std::vector<StartPair> pairs{{0, 0, 0, 0}};
  SurfaceCells cells_a(a, {}, CellForm::Auto, 0.4865), cells_b(b, {}, CellForm::Auto, 0.4865);
  take_neighbours(cells_a, cells_b, pairs, 1e-7, WorkLimit(kOptions));
  return pairs.empty();
}

void expect_meeting_in_crease(const BezierSurface& a, const BezierSurface& b) {
  EXPECT_TRUE(is_taken(a, b));
  const SurfaceIntersection found = intersect(a, b);
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.curves.size(), 1u);
  const IntersectionCurve& curve = found.curves.front();
  EXPECT_FALSE(curve.tangential);
  EXPECT_LE(std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}), 1e-7);
  const auto y_at = [&](double t) { return point_at(curve.curve, t)[1]; };
  EXPECT_NEAR(std::abs(y_at(curve.curve.domain().to) - y_at(curve.curve.domain().from)), 3, 1e-12);
}

TEST_P(Turned, SidesOfACreaseMeetInIt) {
  expect_meeting_in_crease(surface_of(side_of_crease(-1, 0.5)),
                           surface_of(turned(side_of_crease(1, 1), GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Ways, Turned, ::testing::Range(0, 8));

// The border is one curve with another parameter and of another degree: doubles hold both exactly.
TEST(SmoothNeighbours, SidesOfACreaseMeetInItWhateverItsParameter) {
  const BezierSurface a = surface_of(side_of_crease(-1, 0.5));
  RationalBezierPatch side = elevated(side_of_crease(1, 1), 3, 4);
  for (const double ratio : {1.0, 2.0, 0.25}) {
    BezierSurface b = surface_of(side);
    b.rational = true;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 5; ++j)
        b.patches(0, 0).points(i, j) = side.points(i, j) * std::pow(ratio, j);
    expect_meeting_in_crease(a, b);
    expect_meeting_in_crease(b, a);
  }
}

// Paths from one to the other turn back in it.
TEST_P(Turned, SidesOfAFoldMeetInIt) {
  for (const double slope : {0.6, 1.5, -20.0})
    expect_meeting_in_crease(surface_of(side_of_crease(-1, 0.5)),
                             surface_of(turned(side_of_crease(-1, slope), GetParam())));
}

// Beside the fold they cross again.
TEST(SmoothNeighbours, SidesOfAFoldThatCrossAreSearched) {
  RationalBezierPatch side = side_of_crease(-1, 0.9);
  for (int j = 0; j < 4; ++j) side.points(3, j)[2] -= 4;
  const BezierSurface a = surface_of(side_of_crease(-1, 0.5)), b = surface_of(side);
  EXPECT_FALSE(is_taken(a, b));
  EXPECT_EQ(intersect(a, b).curves.size(), 2u);
}

TEST(SmoothNeighbours, SidesOfACreaseThatAreAlmostTheSameAreSearched) {
  RationalBezierPatch side = side_of_crease(1, 1);
  side.points(0, 2)[2] += 1e-15;
  EXPECT_FALSE(is_taken(surface_of(side_of_crease(-1, 0.5)), surface_of(side)));
}

// Neither half is small: the proof needs parts of them.
TEST(SmoothNeighbours, HalvesOfATubeMeetInBothBorders) {
  const SurfaceIntersection found = intersect(surface_of(half_tube(1)), surface_of(half_tube(-1)));
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_EQ(found.certificate.critical, 0);
  EXPECT_EQ(found.curves.size(), 2u);
}

// Two quarters of a cone from its apex, v = 0, to a circle of radius 1 at this height: from `turn`
// quarters on.
BezierSurface half_cone(int turn, double height, const Vec3& apex = {}) {
  constexpr double kWeight = std::numbers::sqrt2 / 2;
  BezierSurface surface{{0, 1, 2}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(2, 1);
  for (int k = 0; k < 2; ++k) {
    const double angle = (turn + k) * std::numbers::pi / 2;
    const Vec2 x{std::cos(angle), std::sin(angle)}, y{-x[1], x[0]};
    RationalBezierPatch patch{Grid<Vec4>(3, 2)};
    for (int i = 0; i < 3; ++i) {
      const Vec2 p = (i < 2 ? x : Vec2{}) + (i > 0 ? y : Vec2{});
      const double w = i == 1 ? kWeight : 1;
      patch.points(i, 0) = {w * apex[0], w * apex[1], w * apex[2], w};
      patch.points(i, 1) = {w * (apex[0] + p[0]), w * (apex[1] + p[1]), w * (apex[2] + height), w};
    }
    surface.patches(k, 0) = patch;
  }
  surface.rational = true;
  return surface;
}

int taken(const BezierSurface& a, const BezierSurface& b) {
  std::vector<StartPair> pairs;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) pairs.push_back({i, 0, j, 0});
  SurfaceCells cells_a(a, {}, CellForm::Auto, 0.4865), cells_b(b, {}, CellForm::Auto, 0.4865);
  take_neighbours(cells_a, cells_b, pairs, 1e-7, WorkLimit(kOptions));
  return 4 - static_cast<int>(pairs.size());
}

// Quarters beside each other meet in a line that ends in the apex, those across there alone.
TEST(SmoothNeighbours, HalvesOfAConeMeetInTwoLinesAndTheApex) {
  for (const double height : {0.1, 1.0, 5.0})
    for (const Vec3& apex : {Vec3{}, Vec3{0.3, 17.1, -2.9}}) {
      const BezierSurface a = half_cone(0, height, apex), b = half_cone(2, height, apex);
      EXPECT_EQ(taken(a, b), 4) << height;
      const SurfaceIntersection found = intersect(a, b);
      EXPECT_EQ(found.status, Status::Tolerance);
      EXPECT_EQ(found.certificate.critical, 0);
      double length = 0;
      for (const IntersectionCurve& curve : found.curves) length += curve.length;
      EXPECT_NEAR(length, 2 * std::hypot(1, height), 1e-7);
      EXPECT_TRUE(found.points.empty() && found.places.empty());
    }
}

// Each quarter has one that it coincides with: nothing is proven of that.
TEST(SmoothNeighbours, QuartersOfAConeThatCoincideAreSearched) {
  EXPECT_LE(taken(half_cone(0, 1), half_cone(0, 1)), 2);
  EXPECT_LE(taken(half_cone(0, 1), half_cone(1, 1)), 3);
}

// Of cones about the same axis that open to both sides no parts meet but in the apex.
TEST(SmoothNeighbours, ConesTipToTipMeetInTheirApex) {
  const SurfaceIntersection found = intersect(half_cone(0, 1), half_cone(0, -1));
  EXPECT_EQ(found.certificate.critical, 0);
  EXPECT_TRUE(found.curves.empty());
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_LE(norm(found.points.front().point), 1e-12);
}

// A bulge leads the way back through the other cone.
TEST(SmoothNeighbours, ConeThatComesBackIsSearched) {
  BezierSurface b{{0, 1}, {0, 1}};
  b.patches = Grid<RationalBezierPatch>(1, 1);
  RationalBezierPatch patch{Grid<Vec4>(3, 4)};
  const std::array<Vec2, 4> profile{Vec2{0, 0}, Vec2{0, -1}, Vec2{1.5, -1}, Vec2{0.5, 1.5}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) {
      const Vec2& p = profile[static_cast<std::size_t>(j)];
      patch.points(i, j) = {p[0], (i - 1) * 0.1 * j, p[1], 1};
    }
  b.patches(0, 0) = patch;
  const SurfaceIntersection found = intersect(half_cone(3, 1), b);
  EXPECT_GE(found.curves.size(), 1u);
}

// The surface with every coordinate moved by up to `most`.
BezierSurface shaken(BezierSurface surface, double most) {
  int k = 0;
  for (Vec4& p : surface.patches(0, 0).points.values())
    for (int axis = 0; axis < 3; ++axis) p[axis] += most * std::sin(1.0 + 7.0 * k++);
  return surface;
}

// As of a file that was written with so many digits.
TEST(SmoothNeighbours, MayHaveBordersThatRoundingMoved) {
  const RationalBezierPatch whole = wavy();
  const BezierSurface a = surface_of(sub_patch(whole, {0, 0.5}, {0, 1}));
  const BezierSurface half = surface_of(sub_patch(whole, {0.5, 1}, {0, 1}));
  for (const double most : {1e-15, 1e-12, 2e-11}) {
    const SurfaceIntersection found = intersect(a, shaken(half, most));
    EXPECT_EQ(found.status, Status::Tolerance);
    EXPECT_EQ(found.certificate.critical, 0) << most;
    ASSERT_EQ(found.curves.size(), 1u);
    EXPECT_TRUE(found.points.empty() && found.places.empty());
  }
}

TEST(SmoothNeighbours, MayHaveCornersThatRoundingMoved) {
  const RationalBezierPatch whole = wavy();
  BezierSurface b = surface_of(sub_patch(whole, {0.5, 1}, {0.5, 1}));
  for (Vec4& p : b.patches(0, 0).points.values()) p -= Vec4{1e-12, 1e-12, 0, 0};
  const SurfaceIntersection found = intersect(surface_of(sub_patch(whole, {0, 0.5}, {0, 0.5})), b);
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_EQ(found.certificate.critical, 0);
  EXPECT_EQ(found.points.size(), 1u);
}

// Beyond that nothing is proven by paths that jump: the search has to look.
TEST(SmoothNeighbours, BordersFartherApartAreSearched) {
  const RationalBezierPatch whole = wavy();
  const BezierSurface a = surface_of(sub_patch(whole, {0, 0.5}, {0, 1}));
  const BezierSurface b = shaken(surface_of(sub_patch(whole, {0.5, 1}, {0, 1})), 1e-9);
  std::vector<StartPair> pairs{{0, 0, 0, 0}};
  SurfaceCells cells_a(a, {}, CellForm::Auto, 0.4865), cells_b(b, {}, CellForm::Auto, 0.4865);
  EXPECT_TRUE(take_neighbours(cells_a, cells_b, pairs, 1e-7, WorkLimit(kOptions)).arcs.empty());
  EXPECT_EQ(pairs.size(), 1u);
}

// Cones so near each other that a jump of 1 may be made up for far from it.
TEST(DirectionCones, APathMayJumpWhereConesAreWellApart) {
  const Vec3 thin{1e-4, 1e-4, 1e-4};
  const auto at_angle = [&](double angle) {
    return DirectionCones{{{1, 0, 0}, thin}, {{std::cos(angle), std::sin(angle), 0}, thin}};
  };
  EXPECT_TRUE(is_injective(at_angle(2e-3)));
  EXPECT_FALSE(is_injective_with_jump(at_angle(2e-3)));
  EXPECT_TRUE(is_injective_with_jump(at_angle(0.1)));
}

// What the halves have in common is outside of the part of one of them.
TEST(SmoothNeighbours, BorderOutsideOfAPartIsNotReported) {
  const RationalBezierPatch whole = wavy();
  IntersectionOptions options;
  options.part_a = [](const Interval& u, const Interval&) {
    return u.from > 0.8 ? PartSide::Outside : u.to < 0.8 ? PartSide::Inside : PartSide::Mixed;
  };
  const SurfaceIntersection found =
      intersect(surface_of(sub_patch(whole, {0, 0.5}, {0, 1})),
                surface_of(sub_patch(whole, {0.5, 1}, {0, 1})), options);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.curves.empty() && found.points.empty() && found.places.empty());
}

// Parts of two half cones that reach the apex: the line in which quarters beside each other meet
// tells of it only if it counts itself.
TEST(SmoothNeighbours, AnApexIsReportedWhereTheLineToItDoesNotCount) {
  const auto within = [](double from, double to) {
    return [from, to](const Interval& u, const Interval&) {
      if (u.to < from || u.from > to) return PartSide::Outside;
      return u.from >= from && u.to <= to ? PartSide::Inside : PartSide::Mixed;
    };
  };
  const BezierSurface a = half_cone(0, 1), b = half_cone(2, 1);
  for (const auto& [from, to] : {std::pair{0.3, 0.7}, {1.3, 1.7}, {1.3, 2.0}}) {
    IntersectionOptions options;
    options.part_a = within(from, to);
    options.part_b = within(0.3, 0.7);

    const SurfaceIntersection found = intersect(a, b, options);

    EXPECT_EQ(found.status, Status::Tolerance) << from << ' ' << to;
    EXPECT_TRUE(found.curves.empty()) << from << ' ' << to;
    ASSERT_EQ(found.points.size(), 1u) << from << ' ' << to;
    EXPECT_LE(norm(found.points[0].point), 1e-9);
  }
}

// A sheet that turns back in its border lies beside the other one, not behind it.
TEST(SmoothNeighbours, OneFoldedBackIsNone) {
  const RationalBezierPatch whole = wavy();
  const RationalBezierPatch half = sub_patch(whole, {0, 0.5}, {0, 1});
  RationalBezierPatch folded = half;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) folded.points(i, j)[2] += 0.02 * (3 - i) * (3 - i) * (2 - i);
  std::vector<StartPair> pairs{{0, 0, 0, 0}};
  const BezierSurface a = surface_of(half), b = surface_of(folded);
  SurfaceCells cells_a(a, {}, CellForm::Auto, 0.4865), cells_b(b, {}, CellForm::Auto, 0.4865);
  EXPECT_TRUE(take_neighbours(cells_a, cells_b, pairs, 1e-7, WorkLimit(kOptions)).arcs.empty());
  EXPECT_EQ(pairs.size(), 1u);
}

// A third arm of the second surface comes back through the first one: the border is not all.
TEST(SmoothNeighbours, OneThatComesBackIsSearched) {
  RationalBezierPatch a{Grid<Vec4>(2, 2)}, b{Grid<Vec4>(5, 2)};
  for (int j = 0; j < 2; ++j) {
    a.points(0, j) = {-3, 1.0 * j, 0, 1};
    a.points(1, j) = {0, 1.0 * j, 0, 1};
    const std::array<Vec2, 5> loop{Vec2{0, 0}, Vec2{4, 0}, Vec2{2, 6}, Vec2{-3, 3}, Vec2{-1, -2}};
    for (int i = 0; i < 5; ++i) {
      const Vec2& p = loop[static_cast<std::size_t>(i)];
      b.points(i, j) = {p[0], 1.0 * j, p[1], 1};
    }
  }
  std::vector<StartPair> pairs{{0, 0, 0, 0}};
  const BezierSurface of_a = surface_of(a), of_b = surface_of(b);
  SurfaceCells cells_a(of_a, {}, CellForm::Auto, 0.4865);
  SurfaceCells cells_b(of_b, {}, CellForm::Auto, 0.4865);
  EXPECT_TRUE(take_neighbours(cells_a, cells_b, pairs, 1e-7, WorkLimit(kOptions)).arcs.empty());
  EXPECT_EQ(pairs.size(), 1u);
}

}  // namespace
}  // namespace blossom
