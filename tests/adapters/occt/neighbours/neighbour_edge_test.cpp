// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/neighbours/neighbour_edge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/faces/face_data.h"
#include "adapters/occt/faces/pairs/shared_edges.h"
#include "core/math/vec.h"

namespace blossom::occt {
namespace {

constexpr double kRadius = 10;

// The rim of a cylinder between its side and its top, whose parameter is the angle.
class Rim : public ::testing::Test {
 protected:
  Rim() {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(BRepPrimAPI_MakeCylinder(kRadius, 5).Shape(), TopAbs_FACE, faces);
    const TopoDS_Face side = TopoDS::Face(faces(1)), top = TopoDS::Face(faces(2));
    side_ = face_data(side, 1e-7);
    top_ = face_data(top, 1e-7);
    edges_ = shared_edges(side, top);
  }

  static const Coedge& use(const FaceTrims& trims, int edge) {
    for (const auto& loop : trims.loops)
      for (const Coedge& coedge : loop)
        if (coedge.edge == edge) return coedge;
    throw std::logic_error("the edge is not there");
  }

  // Whether the hull of two points beside the rim at angles is near it.
  bool is_near(double from, double to, double beside, double reach) const {
    const NeighbourEdge edge(side_.trims, top_.trims, edges_.at(0),
                             use(side_.trims, edges_[0].in_a), use(top_.trims, edges_[0].in_b));
    const auto at = [&](double angle) {
      return Vec3{(kRadius + beside) * std::cos(angle), (kRadius + beside) * std::sin(angle), 5};
    };
    const Vec3 origin{1, 2, 3}, a = at(from) - origin, b = at(to) - origin;
    const std::vector<double> hull{a[0], b[0], a[1], b[1], a[2], b[2]};
    return edge.is_near(0.5 * (from + to), hull.data(), 2, origin, reach);
  }

  FaceData side_, top_;
  std::vector<SharedEdge> edges_;
};

TEST_F(Rim, IsNearAPointWithinReach) {
  ASSERT_EQ(edges_.size(), 1u);
  EXPECT_TRUE(is_near(1, 1, 1e-6, 1.1e-6));
  EXPECT_FALSE(is_near(1, 1, 1e-6, 0.9e-6));
}

// A chord over an angle w is off its arc by r w^2 / 8.
TEST_F(Rim, IsNearAChordAsFarAsItsArcIs) {
  const double angle = 1e-3, sag = kRadius * angle * angle / 8;
  EXPECT_TRUE(is_near(1, 1 + angle, 0, 2 * sag));
  EXPECT_FALSE(is_near(1, 1 + angle, 0, 0.9 * sag));
  EXPECT_TRUE(is_near(1, 1 + 1e-4, 0, 0.9 * sag));
}

TEST_F(Rim, IsNotNearWhatGoesOnAlongIt) { EXPECT_FALSE(is_near(1, 1.5, 0, 1e-6)); }

}  // namespace
}  // namespace blossom::occt
