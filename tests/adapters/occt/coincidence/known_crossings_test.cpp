// SPDX-License-Identifier: LGPL-2.1-or-later
// What faces have in common of the lines and conics in which their surfaces meet.

#include <gtest/gtest.h>

#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"
#include "core/bounds/box_tree.h"

namespace blossom::occt {
namespace {

// The floor z = 0 up to an end in y, and a cylinder of radius 1 that lies on it from y = 0 to 2.
ShapeIntersection cylinder_on_floor(double end) {
  const gp_Pln floor(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const gp_Cylinder cylinder(gp_Ax3(gp_Pnt(0, 0, 1), gp_Dir(0, 1, 0), gp_Dir(0, 0, 1)), 1);
  const TopoDS_Face a = BRepBuilderAPI_MakeFace(floor, -1, 1, -2, end).Face();
  const TopoDS_Face b = BRepBuilderAPI_MakeFace(cylinder, 2, 4, 0, 2).Face();
  return intersect(std::vector{a}, std::vector{b});
}

TEST(KnownCrossings, TouchAlongThePartOfALineThatBothFacesHave) {
  const auto found = cylinder_on_floor(0.5);
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_EQ(found.pairs[0].found.curves.size(), 1u);
  EXPECT_NEAR(found.pairs[0].found.curves[0].length, 0.5, 1e-9);
}

TEST(KnownCrossings, TouchInAPointWhereOneFaceEndsAndTheOtherBegins) {
  const auto found = cylinder_on_floor(0);
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_TRUE(found.pairs[0].found.curves.empty());
  for (const Place& place : found.pairs[0].found.places)
    EXPECT_LT(distance(place.box_low, place.box_high), 1e-2);
}

}  // namespace
}  // namespace blossom::occt
