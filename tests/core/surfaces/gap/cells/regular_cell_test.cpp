// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces that cross at small angles: a patch and a larger one of the same surface, turned a
// little.

#include "core/surfaces/gap/cells/regular_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/subdivision/patch_subdivision.h"
#include "core/surface_intersection.h"
#include "tests/support/components.h"
#include "tests/support/cubic_family.h"
#include "tests/support/random.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::Components;
using testing::components;
using testing::Motion;
using testing::uniform;

Vec3 middle_of(const BezierSurface& surface) {
  Vec3 sum;
  for (const Vec4& p : surface.patches(0, 0).points.values()) sum += Vec3{p[0], p[1], p[2]};
  return sum * (1.0 / 16);
}

// About the axis x through a point.
BezierSurface turned(const BezierSurface& surface, const Vec3& about, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Motion to, turn, back;
  to.shift = -about;
  turn.rotation = {Vec3{1, 0, 0}, Vec3{0, c, -s}, Vec3{0, s, c}};
  back.shift = about;
  return moved(moved(moved(surface, to), turn), back);
}

class TurnedCopy : public ::testing::TestWithParam<double> {};

// The search needs no more cells at a small angle than at a large one.
TEST_P(TurnedCopy, MeetsThePatchInOneCurveWithFewCells) {
  const testing::CubicPair pair = testing::cubic_pair(testing::constant(0));  // one surface
  const double angle = GetParam() * std::numbers::pi / 180;
  const BezierSurface a = pair.a, b = turned(pair.b, middle_of(a), angle);

  const SurfaceIntersection found = intersect(a, b);

  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_EQ(components(found), (Components{.open = 1}));
  EXPECT_LT(found.certificate.certified, 200);
  ASSERT_EQ(found.curves.size(), 1u);
  // The normals of the two points that meet differ by a part of the turn.
  EXPECT_NEAR(found.curves[0].least_angle / angle, 0.48, 0.02);
}

// Cut into patches, so that the curve crosses their borders, or runs close beside them.
BezierSurface in_patches(const BezierSurface& surface, const std::vector<double>& u_cuts,
                         const std::vector<double>& v_cuts) {
  BezierSurface cut = surface;
  cut.patches = subdivide(surface.patches(0, 0), u_cuts, v_cuts);
  cut.u_knots = u_cuts;
  cut.v_knots = v_cuts;
  return cut;
}

TEST_P(TurnedCopy, MeetsThePatchInOneCurveAcrossTheBordersOfItsPatches) {
  const testing::CubicPair pair = testing::cubic_pair(testing::constant(0));
  const double angle = GetParam() * std::numbers::pi / 180;
  const BezierSurface b = turned(pair.b, middle_of(pair.a), angle);
  const SurfaceIntersection whole = intersect(pair.a, b);
  const std::vector<double> thirds{0, 0.31, 0.64, 1}, halves{0, 0.47, 1}, uncut{0, 1};
  for (const auto& [u, v] : {std::pair{thirds, thirds}, {halves, uncut}, {uncut, thirds}}) {
    const SurfaceIntersection found =
        intersect(in_patches(pair.a, halves, halves), in_patches(b, u, v));
    EXPECT_EQ(found.status, Status::Complete);
    EXPECT_EQ(components(found), (Components{.open = 1}));
    EXPECT_LT(found.certificate.certified, 3000);
    ASSERT_EQ(found.curves.size(), 1u);
    EXPECT_NEAR(found.curves[0].length, whole.curves.at(0).length, 1e-7);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, TurnedCopy, ::testing::Values(20, 5, 1, 0.2, 0.05, 0.01));

}  // namespace
}  // namespace blossom
