// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges that meet solids, sheets and other edges where it is known by hand.

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_Circ.hxx>

#include "adapters/occt/edge_intersection.h"

namespace blossom::occt {
namespace {

TopoDS_Edge segment(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepBuilderAPI_MakeEdge(from, to).Edge();
}

TopoDS_Edge ring(const gp_Pnt& middle, const gp_Dir& axis, double radius) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(middle, axis), radius)).Edge();
}

// [0, 4] x [0, 4] x [0, 4]
TopoDS_Shape cube() { return BRepPrimAPI_MakeBox(4., 4., 4.).Shape(); }

void expect_at(const EdgePoint& found, const Vec3& point) {
  EXPECT_LE(distance(found.point, point), 1e-9);
}

TEST(EdgeIntersection, ALineThroughASolidHasTheTwoPointsInWhichItCrossesFaces) {
  const EdgeIntersection met = intersect_edges({segment({1, 2, -3}, {1, 2, 7})}, cube());

  EXPECT_EQ(met.status, Status::Complete);
  ASSERT_EQ(met.points.size(), 2u);
  expect_at(met.points[0], {1, 2, 0});
  expect_at(met.points[1], {1, 2, 4});
  EXPECT_NEAR(met.points[0].parameter, 3, 1e-9);
  EXPECT_EQ(met.points[0].on.ShapeType(), TopAbs_FACE);
  EXPECT_TRUE(met.stretches.empty());
}

TEST(EdgeIntersection, ALineBesideASolidIsProvenToMissIt) {
  const EdgeIntersection met = intersect_edges({segment({5, 2, -3}, {5, 2, 7})}, cube());

  EXPECT_EQ(met.status, Status::Complete);
  EXPECT_TRUE(met.points.empty());
  EXPECT_TRUE(met.stretches.empty());
}

TEST(EdgeIntersection, ALineInsideOfASolidHasNothingInCommonWithItsBoundary) {
  const EdgeIntersection met = intersect_edges({segment({1, 1, 1}, {3, 3, 3})}, cube());

  EXPECT_EQ(met.status, Status::Complete);
  EXPECT_TRUE(met.points.empty());
}

TEST(EdgeIntersection, AnEndOnAFaceIsAPoint) {
  const EdgeIntersection met = intersect_edges({segment({1, 2, 4}, {1, 2, 9})}, cube());

  ASSERT_EQ(met.points.size(), 1u);
  expect_at(met.points[0], {1, 2, 4});
  EXPECT_EQ(met.points[0].on.ShapeType(), TopAbs_FACE);
}

TEST(EdgeIntersection, AWireThatEntersWithACornerOnTheFaceHasOnePointThere) {
  const EdgeIntersection met =
      intersect_edges({segment({1, 2, 9}, {1, 2, 4}), segment({1, 2, 4}, {2, 2, 1})}, cube());

  ASSERT_EQ(met.points.size(), 1u);
  expect_at(met.points[0], {1, 2, 4});
}

TEST(EdgeIntersection, APointOnAnEdgeIsOnTheEdgeAndNotOnItsFaces) {
  const EdgeIntersection met = intersect_edges({segment({3, 3, 4}, {5, 5, 4.})}, cube());
  const EdgeIntersection across = intersect_edges({segment({-1, 2, 5}, {1, 2, 3})}, cube());

  ASSERT_EQ(across.points.size(), 1u);
  expect_at(across.points[0], {0, 2, 4});
  EXPECT_EQ(across.points[0].on.ShapeType(), TopAbs_EDGE);
  EXPECT_TRUE(met.points.empty());  // the end of a stretch
}

TEST(EdgeIntersection, ALineThroughACornerIsOnTheVertex) {
  const EdgeIntersection met = intersect_edges({segment({3, 4, 5}, {5, 4, 3})}, cube());

  ASSERT_EQ(met.points.size(), 1u);
  expect_at(met.points[0], {4, 4, 4});
  EXPECT_EQ(met.points[0].on.ShapeType(), TopAbs_VERTEX);
}

TEST(EdgeIntersection, WhatLiesOnAFaceIsAStretchThatEndsAtItsBorder) {
  const EdgeIntersection met = intersect_edges({segment({-2, 1, 4}, {6, 1, 4})}, cube());

  EXPECT_TRUE(met.points.empty());
  ASSERT_EQ(met.stretches.size(), 1u);
  EXPECT_NEAR(met.stretches[0].length, 4, 1e-9);
  EXPECT_NEAR(met.stretches[0].range.from, 2, 1e-9);
  EXPECT_NEAR(met.stretches[0].range.to, 6, 1e-9);
  EXPECT_EQ(met.stretches[0].on.ShapeType(), TopAbs_FACE);
}

TEST(EdgeIntersection, WhatLiesAlongAnEdgeIsAStretchOfIt) {
  const EdgeIntersection met = intersect_edges({segment({1, 4, 4}, {9, 4, 4})}, cube());

  ASSERT_EQ(met.stretches.size(), 1u);
  EXPECT_NEAR(met.stretches[0].length, 3, 1e-9);
  EXPECT_EQ(met.stretches[0].on.ShapeType(), TopAbs_EDGE);
}

TEST(EdgeIntersection, ALineThatTouchesACylinderHasOnePointThere) {
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  const EdgeIntersection met = intersect_edges({segment({-4, 2, 1}, {4, 2, 1})}, pin);

  ASSERT_EQ(met.points.size(), 1u);
  EXPECT_LE(distance(met.points[0].point, {0, 2, 1}), 1e-3);
  EXPECT_TRUE(met.stretches.empty());
}

TEST(EdgeIntersection, ARingWhoseSeamLiesOnTheFaceHasThatPointOnce) {
  // It begins and ends at (3, 2, 4).
  const TopoDS_Edge round =
      BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({2, 2, 4}, {0, 1, 0}, {1, 0, 0}), 1)).Edge();
  const EdgeIntersection met = intersect_edges({round}, cube());

  ASSERT_EQ(met.points.size(), 2u);
  const bool seam_first = met.points[0].point[0] > 2;
  expect_at(met.points[seam_first ? 0 : 1], {3, 2, 4});
  expect_at(met.points[seam_first ? 1 : 0], {1, 2, 4});
}

TEST(EdgeIntersection, EdgesMeetEdgesInPointsAndStretches) {
  const EdgeIntersection crossing =
      intersect_edges({ring({0, 0, 0}, {0, 0, 1}, 2)}, segment({-3, 0, 0}, {3, 0, 0}));
  const EdgeIntersection along =
      intersect_edges({segment({0, 0, 0}, {5, 0, 0})}, segment({3, 0, 0}, {9, 0, 0}));

  EXPECT_EQ(crossing.points.size(), 2u);
  EXPECT_TRUE(along.points.empty());
  ASSERT_EQ(along.stretches.size(), 1u);
  EXPECT_NEAR(along.stretches[0].length, 2, 1e-9);
}

TEST(EdgeIntersection, TwoEdgesOnOneFaceThatTouchEndToEndHaveNoPointBesides) {
  const EdgeIntersection met =
      intersect_edges({segment({1, 1, 4}, {3, 1, 4}), segment({3, 1, 4}, {3, 1, 8})}, cube());

  EXPECT_EQ(met.stretches.size(), 1u);
  EXPECT_TRUE(met.points.empty());
}

TEST(EdgeIntersection, WhatIsDecidedExactlyIsComplete) {
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  const auto status = [](const TopoDS_Edge& edge, const TopoDS_Shape& shape) {
    return intersect_edges({edge}, shape).status;
  };
  EXPECT_EQ(status(segment({-1, 2, 5}, {1, 2, 3}), cube()), Status::Complete);    // an edge
  EXPECT_EQ(status(segment({-1, -1, -1}, {6, 6, 6}), cube()), Status::Complete);  // two corners
  EXPECT_EQ(status(segment({1, 2, 4}, {1, 2, 9}), cube()), Status::Complete);     // its own end
  EXPECT_EQ(status(segment({-2, 1, 4}, {6, 1, 4}), cube()), Status::Complete);    // in a face
  EXPECT_EQ(status(segment({1, 4, 4}, {9, 4, 4}), cube()), Status::Complete);     // along an edge
  EXPECT_EQ(status(ring({2, 2, 4}, {0, 0, 1}, 1), cube()), Status::Complete);
  EXPECT_EQ(status(segment({-4, 2, 1}, {4, 2, 1}), pin), Status::Complete);  // a touch
  EXPECT_EQ(status(segment({-4, 0, 6}, {0, 0, 4}), pin), Status::Complete);  // its rim
  EXPECT_EQ(status(ring({0, 0, 1}, {0, 0, 1}, 2), pin), Status::Complete);
  EXPECT_EQ(status(segment({0, 0, -4}, {0, 0, 4}), BRepPrimAPI_MakeSphere(3.).Shape()),
            Status::Complete);  // its poles
}

TEST(EdgeIntersection, WhatIsApartByLessThanTheToleranceIsNotDecided) {
  const double off = 4e-8;
  const auto status = [](const TopoDS_Edge& edge) {
    return intersect_edges({edge}, cube()).status;
  };
  EXPECT_EQ(status(segment({-1, 2, 5 + off}, {1, 2, 3 + off})), Status::Tolerance);
  EXPECT_EQ(status(segment({-1, 2, 5 - off}, {1, 2, 3 - off})), Status::Tolerance);
  EXPECT_EQ(status(segment({1, 2, 4 + off}, {1, 2, 9})), Status::Tolerance);
  EXPECT_EQ(status(segment({-2, 1, 4 + off}, {6, 1, 4 + off})), Status::Tolerance);
  EXPECT_EQ(status(segment({1, 4 + off, 4}, {9, 4 + off, 4})), Status::Tolerance);
}

TEST(EdgeIntersection, AReachedLimitIsSaid) {
  IntersectionOptions options;
  options.cancelled = [] { return true; };
  const EdgeIntersection met = intersect_edges({ring({0, 0, 0}, {0, 0, 1}, 2)},
                                               BRepPrimAPI_MakeSphere(2.5).Shape(), options);

  EXPECT_EQ(met.status, Status::Stopped);
  EXPECT_FALSE(met.reasons.empty());
}

}  // namespace
}  // namespace blossom::occt
