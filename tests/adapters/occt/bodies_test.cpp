// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/compounds.h"
#include "tests/adapters/occt/solids/solid_contacts.h"
#include "tests/support/shapes.h"

namespace blossom::occt {
namespace {

using testing::box;
using testing::random_point;
using testing::seeded;
using testing::turned;
using testing::uniform;

TopoDS_Shape ball(const Vec3& centre, double radius) {
  return BRepPrimAPI_MakeSphere(gp_Pnt(centre[0], centre[1], centre[2]), radius).Shape();
}

// Of edge length 2 h about the origin.
TopoDS_Shape cube(double h) { return box(gp_Pnt(-h, -h, -h), gp_Pnt(h, h, h)); }

// A cube of 2 h with a cubic cavity of 2 c.
TopoDS_Shape hollow(double h, double c) { return BRepAlgoAPI_Cut(cube(h), cube(c)).Shape(); }

TopoDS_Shape sheet(double z, double half) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), -half, half, -half, half)
      .Shape();
}

ModelRelation found(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  Bodies first(a), second(b);
  return relation_of(first, second, meeting(first.boundary(), second.boundary()));
}

Relation turned_round(Relation relation) {
  if (relation == Relation::AInsideB) return Relation::BInsideA;
  return relation == Relation::BInsideA ? Relation::AInsideB : relation;
}

// In both orders.
void expect_relation(const TopoDS_Shape& a, const TopoDS_Shape& b, Relation expected) {
  EXPECT_STREQ(to_string(found(a, b).relation), to_string(expected));
  EXPECT_STREQ(to_string(found(b, a).relation), to_string(turned_round(expected)));
}

TEST(Bodies, OfAModelAreItsClosedSolidsAndTheRest) {
  const Bodies one(cube(1));
  ASSERT_EQ(one.all().size(), 1U);
  EXPECT_EQ(one.all().front().solid, 1);
  const Bodies both(compound_of(std::vector{sheet(5, 1), cube(1), ball({9, 0, 0}, 1)}));
  ASSERT_EQ(both.all().size(), 3U);
  EXPECT_EQ(both.all()[1].solid, 2);
  EXPECT_FALSE(both.all()[2].is_solid());
  EXPECT_EQ(both.all()[2].faces, 1);
}

TEST(Bodies, OfAnOpenShellAreASurface) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(cube(1), TopAbs_FACE, faces);
  const Bodies open(compound_of(std::vector{faces(1), faces(2), faces(3), faces(4), faces(5)}));
  ASSERT_EQ(open.all().size(), 1U);
  EXPECT_FALSE(open.all().front().is_solid());
  EXPECT_EQ(open.all().front().faces, 5);
}

TEST(BodyRelation, KnowsABallInABox) {
  expect_relation(ball({0, 0, 0}, 1), cube(2), Relation::AInsideB);
  expect_relation(ball({0, 0, 0}, 1), ball({0.2, 0.1, 0}, 2), Relation::AInsideB);
  expect_relation(ball({5, 0, 0}, 1), cube(2), Relation::Disjoint);
  expect_relation(ball({2, 0, 0}, 1), cube(2), Relation::Crossing);
  const ModelRelation inside = found(ball({0, 0, 0}, 1), cube(2));
  EXPECT_EQ(inside.status, Status::Complete);
  EXPECT_EQ(inside.pairs.size(), 1U);
}

// The boxes of both overlap, so only rays tell.
TEST(BodyRelation, KnowsDisjointSolidsWithinEachOthersBox) {
  const TopoDS_Shape ring =
      BRepAlgoAPI_Cut(cube(3),
                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -9), gp_Dir(0, 0, 1)), 2, 20))
          .Shape();
  expect_relation(ring, ball({0, 0, 0}, 1), Relation::Disjoint);
  expect_relation(ring, ball({0, 0, 0}, 2.2), Relation::Crossing);
}

TEST(BodyRelation, TakesACavityForOutside) {
  expect_relation(hollow(5, 3), ball({0, 0, 0}, 1), Relation::Disjoint);
  expect_relation(hollow(5, 3), hollow(2, 1), Relation::Disjoint);
  expect_relation(hollow(5, 3), ball({4, 0, 0}, 0.5), Relation::BInsideA);
  expect_relation(hollow(5, 3), cube(9), Relation::AInsideB);
  expect_relation(hollow(5, 3), hollow(9, 6), Relation::Disjoint);
  expect_relation(hollow(5, 3), hollow(9, 1), Relation::AInsideB);
}

// Boundaries are apart, and yet none holds the other.
TEST(BodyRelation, KnowsABoxThatFillsACavityAndMore) {
  const ModelRelation filled = found(hollow(5, 3), cube(4));
  EXPECT_EQ(filled.relation, Relation::Crossing);
  EXPECT_EQ(filled.status, Status::Complete);
}

TEST(BodyRelation, OfSolidsInContactHandsOutWhatTheirFacesHaveInCommon) {
  const ModelRelation touching =
      found(box(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1)), box(gp_Pnt(1, 0.2, 0.2), gp_Pnt(2, 0.8, 0.8)));
  ASSERT_EQ(touching.pairs.size(), 1U);
  ASSERT_TRUE(touching.pairs.front().faces);
  const FacesMet& faces = *touching.pairs.front().faces;
  EXPECT_EQ(faces.a.size(), 6U);
  EXPECT_EQ(faces.b.size(), 6U);
  EXPECT_TRUE(std::ranges::any_of(faces.found.pairs, [](const FaceIntersection& pair) {
    return !pair.found.overlaps.empty();
  }));
}

TEST(BodyRelation, TellsTouchingFromOverlapping) {
  expect_relation(box(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1)), box(gp_Pnt(1, 0, 0), gp_Pnt(2, 1, 1)),
                  Relation::Touching);
  expect_relation(box(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1)),
                  box(gp_Pnt(1, 0.3, 0.2), gp_Pnt(2, 4, 1.5)), Relation::Touching);
  expect_relation(ball({0, 0, 0}, 1), ball({2, 0, 0}, 1), Relation::Touching);
  // All crossings lie in edges, and no face crosses another one inside of both.
  expect_relation(box(gp_Pnt(0, 0, 0), gp_Pnt(2, 2, 2)), box(gp_Pnt(1, 0, 0), gp_Pnt(3, 2, 2)),
                  Relation::Crossing);
}

TEST(BodyRelation, KnowsContactFromInside) {
  expect_relation(box(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1)), box(gp_Pnt(0, -1, -1), gp_Pnt(3, 3, 3)),
                  Relation::AInsideB);
  expect_relation(ball({0, 0, 1}, 1), box(gp_Pnt(-3, -3, 0), gp_Pnt(3, 3, 5)), Relation::AInsideB);
  // A plug in its hole.
  const TopoDS_Shape plug =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1)), 0.5, 2).Shape();
  expect_relation(BRepAlgoAPI_Cut(cube(1), plug).Shape(), plug, Relation::Touching);
}

// What is within tolerance counts as one, whichever way it is off.
TEST(BodyRelation, OfContactsIsTheSameWithinTolerance) {
  for (const double off : {-4e-8, -1e-8, -1e-9, 1e-9, 1e-8, 4e-8}) {
    SCOPED_TRACE(off);
    const TopoDS_Shape unit_box = box(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1));
    const auto touching = found(unit_box, box(gp_Pnt(1 + off, 0.3, 0.2), gp_Pnt(2, 4, 1.5)));
    // A gap is proven to be one.
    EXPECT_TRUE(touching.relation == Relation::Touching ||
                (off > 0 && touching.relation == Relation::Disjoint))
        << to_string(touching.relation);
    EXPECT_EQ(found(unit_box, box(gp_Pnt(off, -1, -1), gp_Pnt(3, 3, 3))).relation,
              Relation::AInsideB);
  }
}

TEST(BodyRelation, KnowsASheetThatStandsOnABoxOrHangsInIt) {
  const auto standing = [](double from, double to) {
    return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)), -1, 1, -to, -from)
        .Shape();
  };
  expect_relation(standing(2, 3), cube(2), Relation::Touching);
  expect_relation(standing(1, 2), cube(2), Relation::AInsideB);
  expect_relation(standing(1, 3), cube(2), Relation::Crossing);
  expect_relation(standing(-3, 1.9), cube(2), Relation::Crossing);
}

TEST(BodyRelation, IsKnownOfEdgesAndVerticesInContact) {
  const auto point = [](double x, double y, double z) {
    return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, z)).Shape();
  };
  const auto line = [](double from, double to) {
    return BRepBuilderAPI_MakeEdge(gp_Pnt(from, 0, 0), gp_Pnt(to, 0, 0)).Shape();
  };
  expect_relation(point(2, 2, 2), cube(2), Relation::Touching);
  expect_relation(point(2, 0, 0), cube(2), Relation::Touching);
  expect_relation(point(1, 0, 0), cube(2), Relation::AInsideB);
  expect_relation(line(2, 5), cube(2), Relation::Touching);
  expect_relation(line(0, 2), cube(2), Relation::AInsideB);
  expect_relation(line(-5, 5), cube(2), Relation::Crossing);
  expect_relation(line(-2, 2), cube(2), Relation::AInsideB);
  // A corner is crossed beside the middle of the edge.
  const TopoDS_Shape past = BRepBuilderAPI_MakeEdge(gp_Pnt(-9, 1, 0), gp_Pnt(2, -6, 0)).Shape();
  const TopoDS_Shape corner = BRepBuilderAPI_MakeEdge(gp_Pnt(1, 9, 0), gp_Pnt(2.1, 1, 0)).Shape();
  expect_relation(past, cube(2), Relation::Disjoint);
  expect_relation(corner, cube(2), Relation::Crossing);
  EXPECT_EQ(found(point(2, 0, 0), cube(2)).status, Status::Tolerance);
}

TEST(BodyRelation, KnowsEqualSolids) {
  expect_relation(cube(1), cube(1), Relation::Equal);
  expect_relation(cube(1), box(gp_Pnt(-1, -1, -1), gp_Pnt(1, 1, 1)), Relation::Equal);
}

TEST(BodyRelation, TakesASheetForASurface) {
  expect_relation(sheet(0, 1), cube(2), Relation::AInsideB);
  expect_relation(sheet(0, 3), cube(2), Relation::Crossing);
  expect_relation(sheet(2.5, 1), cube(2), Relation::Disjoint);
  expect_relation(sheet(0, 1), hollow(5, 3), Relation::Disjoint);
  expect_relation(sheet(0, 1), sheet(1, 1), Relation::Disjoint);
  expect_relation(sheet(2, 1), cube(2), Relation::Touching);
  // Some of the sheets are inside.
  expect_relation(compound_of(std::vector{sheet(0, 1), sheet(3, 1)}), cube(2), Relation::Crossing);
}

TEST(BodyRelation, IsTheOneOfPairsOfSolids) {
  const TopoDS_Shape two = compound_of(std::vector{cube(1), ball({5, 0, 0}, 1)});
  const ModelRelation one_inside = found(two, cube(2));
  EXPECT_EQ(one_inside.relation, Relation::Crossing) << "the other one is outside";
  ASSERT_EQ(one_inside.pairs.size(), 1U);
  EXPECT_EQ(one_inside.pairs.front().a, 0U);
  EXPECT_EQ(one_inside.pairs.front().relation, Relation::AInsideB);
  expect_relation(two, cube(9), Relation::AInsideB);
  expect_relation(two, ball({2.5, 0, 0}, 0.3), Relation::Disjoint);
}

TEST(BodyRelation, StopsWhenTheTimeIsSpent) {
  Bodies a(ball({0, 0, 0}, 1)), b(cube(2));
  const ShapeMeeting boundaries = meeting(a.boundary(), b.boundary());
  const ModelRelation stopped =
      relation_of(a, b, boundaries, 1e-7, {.cancelled = [] { return true; }});
  EXPECT_EQ(stopped.relation, Relation::Unknown);
  EXPECT_EQ(stopped.status, Status::Stopped);
}

class BodyRelationProperty : public ::testing::TestWithParam<int> {};

TEST_P(BodyRelationProperty, OfBallsIsThatOfTheirCentresAndRadii) {
  auto random = seeded(GetParam());
  const double r = uniform(random, 0.2, 2), s = uniform(random, 0.2, 2);
  const Vec3 at = random_point(random),
             to = at + uniform(random, 0, 4) * unit(random_point(random));
  const double gap = norm(to - at);
  if (std::min(std::abs(gap - r - s), std::abs(gap - std::abs(r - s))) < 1e-3) GTEST_SKIP();
  Relation expected = Relation::Crossing;
  if (gap > r + s) expected = Relation::Disjoint;
  if (gap < std::abs(r - s)) expected = r < s ? Relation::AInsideB : Relation::BInsideA;
  const ModelRelation told = found(ball(at, r), ball(to, s));
  EXPECT_STREQ(to_string(told.relation), to_string(expected));
  EXPECT_EQ(told.status, Status::Complete);
}

// Of boxes along the axes the interval of each axis tells; both are turned.
TEST_P(BodyRelationProperty, OfBoxesIsThatOfTheirIntervals) {
  auto random = seeded(1000 + GetParam());
  std::array<Vec3, 2> low, high;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 3; ++k) {
      low[i][k] = uniform(random, -2, 0.5);
      high[i][k] = low[i][k] + uniform(random, 0.3, i == 0 ? 1.5 : 4);
    }
  bool apart = false, a_in_b = true, b_in_a = true;
  for (int k = 0; k < 3; ++k) {
    apart = apart || high[0][k] < low[1][k] || high[1][k] < low[0][k];
    a_in_b = a_in_b && low[1][k] < low[0][k] && high[0][k] < high[1][k];
    b_in_a = b_in_a && low[0][k] < low[1][k] && high[1][k] < high[0][k];
  }
  Relation expected = Relation::Crossing;
  if (apart) expected = Relation::Disjoint;
  if (a_in_b) expected = Relation::AInsideB;
  if (b_in_a) expected = Relation::BInsideA;
  const auto placed = [&](int i) {
    return turned(
        box(gp_Pnt(low[i][0], low[i][1], low[i][2]), gp_Pnt(high[i][0], high[i][1], high[i][2])),
        gp_Dir(1, 2, 3), 0.1 * GetParam());
  };
  const ModelRelation told = found(placed(0), placed(1));
  EXPECT_STREQ(to_string(told.relation), to_string(expected));
  EXPECT_EQ(told.status, Status::Complete);
}

INSTANTIATE_TEST_SUITE_P(Seeds, BodyRelationProperty, ::testing::Range(0, 40));

std::vector<PointPlace> places(const TopoDS_Shape& shape, const Vec3& point) {
  Bodies bodies(shape);
  return places_of(bodies, point, nearest_point(bodies.boundary(), point));
}

TEST(PointPlaces, AreOfEachSolid) {
  using enum PointPlace;
  EXPECT_EQ(places(hollow(5, 3), {4, 0.1, 0.2}), std::vector{Inside});
  EXPECT_EQ(places(hollow(5, 3), {0, 0, 0}), std::vector{Outside}) << "in the cavity";
  EXPECT_EQ(places(hollow(5, 3), {0.3, 3, 0}), std::vector{OnBoundary});
  EXPECT_EQ(places(hollow(5, 3), {0.3, 3 - 5e-8, 0}), std::vector{OnBoundary});
  EXPECT_EQ(places(hollow(5, 3), {0.3, 3 + 1e-6, 0}), std::vector{Inside});
  const TopoDS_Shape two = compound_of(std::vector{cube(1), ball({0, 0, 0}, 2), cube(3)});
  EXPECT_EQ(places(two, {0, 0, 1}), (std::vector{OnBoundary, Inside, Inside}));
  EXPECT_EQ(places(two, {0, 0, 2.5}), (std::vector{Outside, Outside, Inside}));
  EXPECT_TRUE(places(sheet(0, 1), {0, 0, 1}).empty());
}

}  // namespace
}  // namespace blossom::occt
