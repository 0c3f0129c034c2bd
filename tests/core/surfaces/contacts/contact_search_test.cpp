// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/contact_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/surface_intersection.h"
#include "tests/support/cubic_family.h"
#include "tests/support/intersection_checks.h"

namespace blossom {
namespace {

constexpr double kBendX = 0.04, kBendY = 0.03;  // of the graph z = kBendX x^2 + kBendY y^2

struct Tip {
  double width;   // of the patch, to the distance from its pole
  double slope;   // of the gap across it, likewise
  double growth;  // of the gap along the border t = 1, to the distance squared
};

// The graph over a square round the origin.
BezierSurface base() {
  testing::Cubic z = testing::constant(0);
  z.coefficient[2][0] = kBendX;
  z.coefficient[0][2] = kBendY;
  return testing::graph(z, {-1.3, -1}, {2.3, 0}, {0, 2});
}

// A patch that narrows to a pole in the origin. With r = kLength (1 - s), q = 1 - t it is
//   x = -r,  y = -width r q,  z = kBendX x^2 + kBendY y^2 - slope r q + growth r^2,
// so it meets the graph where slope q = growth r: beside the border t = 1, the nearer to the pole
// the closer.
BezierSurface tip_of(const Tip& tip) {
  constexpr double kLength = 9;
  constexpr std::array<double, 3> kFirst{1, 0.5, 0}, kSecond{1, 0, 0};  // of 1 - s, (1 - s)^2
  Grid<Vec4> net(3, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto k = static_cast<std::size_t>(i), l = static_cast<std::size_t>(j);
      const double r = kLength * kFirst[k], rr = kLength * kLength * kSecond[k];
      const double q = kFirst[l], qq = kSecond[l];
      net(i, j) = {
          -r, -tip.width * r * q,
          (kBendX + tip.growth) * rr + kBendY * tip.width * tip.width * rr * qq - tip.slope * r * q,
          1};
    }
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{net});
  return surface;
}

Vec3 on_branch(const Tip& tip, double r) {
  const double y = -tip.width * r * r * tip.growth / tip.slope;
  return {-r, y, kBendX * r * r + kBendY * y * y};
}

bool is_branch(const Tip& tip, const IntersectionCurve& curve) {
  return std::ranges::all_of(curve.samples, [&](const SurfacePoint& s) {
    return distance(s.point, on_branch(tip, -s.point[0])) <= 1e-7;
  });
}

// How far from the pole the patch's border is within 1e-7 of the graph.
double border_contact(const Tip& tip) { return std::sqrt(1e-7 / tip.growth); }

bool is_border(const IntersectionCurve& curve) {
  return std::ranges::all_of(curve.samples,
                             [](const SurfacePoint& s) { return std::abs(s.point[1]) <= 1e-7; });
}

// So near to the pole the patch is narrower than 2^-22 of the other surface.
TEST(ContactSearch, LeavesNothingOpenBesideAPoleThatABranchComesToAlongTheBorder) {
  for (const Tip& tip : {Tip{0.2, 1e-4, 1e-3}, Tip{0.2, 2e-4, 1e-3}, Tip{0.1, 5e-5, 5e-4}}) {
    SCOPED_TRACE(tip.slope);
    const BezierSurface a = base(), b = tip_of(tip);
    for (const SurfaceIntersection& found : {intersect(a, b), intersect(b, a)}) {
      EXPECT_EQ(found.status, Status::Tolerance);
      ASSERT_FALSE(found.curves.empty());
      for (const IntersectionCurve& curve : found.curves)
        EXPECT_TRUE(is_branch(tip, curve) || is_border(curve));
      EXPECT_TRUE(std::ranges::none_of(
          found.places, [](const Place& place) { return place.kind == PlaceKind::Open; }));
      const testing::CurveDistance curves(found);
      for (const double part : {0.0, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 0.6, 1.0}) {
        const Vec3 p = on_branch(tip, part * tip.slope / tip.growth);
        EXPECT_TRUE(curves.to(p) <= 1e-7 || testing::in_some_place(found, p, 1e-7)) << part;
      }
      for (const Place& place : found.places)
        EXPECT_LE(distance(place.box_low, place.box_high), 1.5 * border_contact(tip));
    }
  }
}

constexpr Vec3 kTip{157.748326, -11.945224, -113.450995};

// A blend that ends in a pole on the bottom circle of a cone: its points, to one side of the plane
// of symmetry z = kTip z.
BezierSurface blend_to_tip() {
  constexpr std::array<Vec3, 5> kFoot{{{148.171655, -9.508330, -114.519979},
                                       {148.156414, -9.509005, -114.384975},
                                       {148.130529, -9.510152, -114.135212},
                                       {148.106255, -9.511227, -113.823555},
                                       {148.092732, -9.511826, kTip[2]}}};
  constexpr std::array<Vec3, 5> kMiddle{{{153.322712, -9.280192, -113.937304},
                                         {153.315778, -9.280499, -113.875887},
                                         {153.304002, -9.281021, -113.762263},
                                         {153.292960, -9.281510, -113.620482},
                                         {153.286808, -9.281783, kTip[2]}}};
  const auto at = [](Vec3 p, bool mirrored, double w) {
    if (mirrored) p[2] = 2 * kTip[2] - p[2];
    return Vec4{w * p[0], w * p[1], w * p[2], w};
  };
  Grid<Vec4> net(3, 9);
  for (int j = 0; j < 9; ++j) {
    const auto k = static_cast<std::size_t>(std::min(j, 8 - j));
    net(0, j) = at(kFoot[k], j > 4, 1);
    net(1, j) = at(kMiddle[k], j > 4, 0.9578);
    net(2, j) = at(kTip, false, 1);
  }
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{net});
  surface.rational = true;
  return surface;
}

// Half of a cone, in two patches: its bottom circle, v = 0, runs through the tip at u = 1/2.
BezierSurface half_cone() {
  const Vec2 centre{164.808147, 0};
  const double bottom = std::hypot(kTip[0] - centre[0], kTip[1] - centre[1]);
  const double middle = std::atan2(kTip[1] - centre[1], kTip[0] - centre[0]);
  const double half = std::numbers::pi / 4, height = 10, slope = 0.0874886635;
  BezierSurface surface{{0, 1, 2}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(2, 1);
  surface.rational = true;
  for (int k = 0; k < 2; ++k) {
    Grid<Vec4> net(3, 2);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j) {
        const double angle = middle + (i - 1 + 2 * k) * half, w = i == 1 ? std::cos(half) : 1;
        const double r = (bottom - (j == 0 ? 0 : height * slope)) / w;
        net(i, j) = {w * (centre[0] + r * std::cos(angle)), w * (centre[1] + r * std::sin(angle)),
                     w * (kTip[2] + (j == 0 ? 0 : height)), w};
      }
    surface.patches(k, 0) = RationalBezierPatch{net};
  }
  return surface;
}

// The part of the cone that counts begins beside the tip, as if trimmed within the tolerance of the
// vertex there.
TEST(ContactSearch, LeavesNothingOpenAroundAPoleWithoutTangentPlane) {
  const BezierSurface a = half_cone(), b = blend_to_tip();
  constexpr double kFrom = 0.5 - 2e-5;
  IntersectionOptions options;
  options.part_a = [](const Interval& u, const Interval&) {
    if (u.to < kFrom) return PartSide::Outside;
    return u.from > kFrom ? PartSide::Inside : PartSide::Mixed;
  };

  const SurfaceIntersection found = intersect(a, b, options);

  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_TRUE(testing::in_some_place(found, kTip, 1e-7));
  for (const Place& place : found.places) {
    EXPECT_NE(place.kind, PlaceKind::Open);
    EXPECT_LE(distance(place.box_low, place.box_high), 1e-3);
  }
}

// A small loop beside a touch is found by the cells of contacts.
TEST(ContactSearch, KeepsToItsBudgetOfCells) {
  constexpr double kAt = 0.43, kRadius = 1e-3;
  const testing::CubicPair pair = testing::cubic_pair(testing::loop(kAt, kAt, kRadius));
  EXPECT_EQ(intersect(pair.a, pair.b).status, Status::Complete);

  const SurfaceIntersection found = intersect(pair.a, pair.b, {.contact_budget = 1});

  EXPECT_EQ(found.status, Status::Stopped);
  const double x = kAt + kRadius;
  EXPECT_TRUE(testing::in_some_place(found, {x, kAt, testing::base_cubic()(x, kAt)}, 1e-9));
  const auto& reasons = found.certificate.reasons;
  EXPECT_EQ(std::ranges::count(reasons, "the budget of contact cells is spent"), 1);
}

}  // namespace
}  // namespace blossom
