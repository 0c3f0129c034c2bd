// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/neighbours/neighbour_proof.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/base/work_limit.h"
#include "core/results/hermite_curves.h"
#include "tests/support/flat_trims.h"

namespace blossom {
namespace {

constexpr double kWithin = 1e-7;

// Over the unit square, from the x-axis on as a parabola through `middle` and `last`, which are
// the last two control points along v.
FaceData sheet(const Vec3& middle, const Vec3& last) {
  const Vec3 x{1, 0, 0};
  FaceData face;
  face.surface.u_knots = face.surface.v_knots = {0, 1};
  face.surface.patches = Grid<RationalBezierPatch>(1, 1);
  Grid<Vec4> net(2, 3);
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = static_cast<double>(i) * x + (k == 0 ? Vec3{} : k == 1 ? middle : last);
      net(i, k) = {p[0], p[1], p[2], 1};
    }
  face.surface.patches(0, 0).points = std::move(net);
  face.box = box_of(face.surface, kWithin);
  testing::FlatLoops loops;
  loops.add_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  SurfaceChart chart = testing::plane_chart();
  chart.jet = [=](const Vec2& uv) {
    const double v = uv[1];
    return SurfaceJet{uv[0] * x + (2 * v * (1 - v)) * middle + (v * v) * last, x,
                      (2 - 4 * v) * middle + (2 * v) * last};
  };
  face.trims = trims_of(chart, std::move(loops.vertices), std::move(loops.loops)).value();
  return face;
}

SharedEdge common_axis() {
  std::vector<HermiteJet> jets;
  for (int i = 0; i <= 4; ++i) {
    const double t = 0.25 * i;
    jets.push_back({{{t, 0, 0}, {t, 0}, {t, 0}}, {{1, 0, 0}, {1, 0}, {1, 0}}});
  }
  SharedEdge edge;
  edge.in_a = edge.in_b = 0;
  edge.curve = hermite_curve(jets, {0, 1});
  edge.tolerance = kOnWire;
  return edge;
}

bool are_proven(const FaceData& a, const FaceData& b) {
  const std::vector<SharedVertex> ends{{0, 0, {0, 0, 0}, kOnWire}, {1, 1, {1, 0, 0}, kOnWire}};
  const IntersectionOptions options;
  return meet_in_shared_only(a, b, {common_axis()}, ends, kWithin, WorkLimit(options)).proven;
}

const Vec3 kHalfY{0, 0.5, 0}, kY{0, 1, 0};

TEST(NeighbourProof, HoldsForSquaresAtAnAngle) {
  EXPECT_TRUE(are_proven(sheet(kHalfY, kY), sheet({0, 0, 0.5}, {0, 0, 1})));
  EXPECT_TRUE(are_proven(sheet(kHalfY, kY), sheet({0, -0.5, 0}, {0, -1, 0.1})));
}

TEST(NeighbourProof, FailsWhereOneComesBackToTheOther) {
  // It rises from the axis and crosses the other one at v = 2 / 3.
  EXPECT_FALSE(are_proven(sheet(kHalfY, kY), sheet({0, 0.5, 0.5}, {0, 1, -0.5})));
}

TEST(NeighbourProof, FailsWhereAFaceHasTheEdgeTwiceOrNotAtAll) {
  const FaceData a = sheet(kHalfY, kY);
  FaceData b = sheet({0, 0, 0.5}, {0, 0, 1});
  b.trims.loops.front()[2].edge = 0;
  EXPECT_FALSE(are_proven(a, b));
  for (const std::size_t i : {0u, 2u}) b.trims.loops.front()[i].edge = 7;
  EXPECT_FALSE(are_proven(a, b));
}

}  // namespace
}  // namespace blossom
