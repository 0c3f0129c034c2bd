// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets whose edges have radii of their own: by closed forms, where they meet, and which are
// refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Elips.hxx>

#include "adapters/occt/blending/continuity.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/fillet.h"
#include "core/base/errors.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

using testing::expect_sound;
using testing::told;

constexpr double kCut = 1 - std::numbers::pi / 4;

// The edge whose middle is there.
int edge_at(const TopoDS_Shape& shape, const Vec3& middle) {
  for (const EdgeFacts& each : edge_facts(shape))
    if (distance(each.middle, middle) < 1e-6) return each.number;
  ADD_FAILURE() << "no edge there";
  return 0;
}

double volume(const FilletResult& made) {
  double all = 0;
  for (const FilletedSolid& each : made.solids) all += each.volume;
  return all;
}

double total_area(const TopoDS_Shape& shape) {
  double all = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    all += area(TopoDS::Face(it.Current()));
  return all;
}

// Radii of the cylinders of blends, by the edge that they are named after.
std::map<int, double> radii_of(const FilletResult& made) {
  std::map<int, double> radii;
  for (const FilletedSolid& solid : made.solids)
    for (const FilletFace& each : solid.faces) {
      const auto cylinder =
          Handle(Geom_CylindricalSurface)::DownCast(BRep_Tool::Surface(each.face));
      if (each.from == 0 && !cylinder.IsNull()) radii[each.edge] = cylinder->Radius();
    }
  return radii;
}

// How deep a fillet of radius r lies below the face, so far from its edge.
double depth(double r, double away) {
  return away >= r ? 0 : r - std::sqrt(r * r - (r - away) * (r - away));
}

// What two fillets take off that meet in a corner of a box, each along `length`: the deeper one
// counts. Depths as sines of angles, whose integrand is smooth at the edges.
double taken_by_two(double a, double b, double length) {
  const int n = 2000;
  double both = 0;  // what they have in common: the lesser depth
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double s = (i + 0.5) / n, t = (k + 0.5) / n;  // shares, squared: denser at the edges
      both += std::min(depth(a, a * s * s), depth(b, b * t * t)) * 4 * s * t;
    }
  both *= a * b / (n * static_cast<double>(n));
  return kCut * length * (a * a + b * b) - both;
}

TEST(FilletRadii, OfEdgesApartAreEachTheirOwn) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const int low = edge_at(box, {0, 0, 5}), high = edge_at(box, {10, 10, 5});
  const int third = edge_at(box, {0, 10, 5});

  const FilletResult made =
      fillet(box, {low, high, third}, {.radius = 3, .own = {{low, {1}}, {high, {2}}}});

  expect_sound(made);
  EXPECT_NEAR(volume(made), 1000 - 10 * kCut * (1 + 4 + 9), 1e-9);
  EXPECT_EQ(radii_of(made), (std::map<int, double>{{low, 1}, {high, 2}, {third, 3}}));
}

TEST(FilletRadii, OfTwoEdgesThatMeetRunIntoEachOther) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const int along_x = edge_at(box, {5, 0, 10}), along_y = edge_at(box, {0, 5, 10});

  const FilletResult made =
      fillet(box, {along_x, along_y}, {.own = {{along_x, {1}}, {along_y, {2}}}});

  expect_sound(made);
  EXPECT_TRUE(made.notes.empty()) << made.notes.front();
  EXPECT_NEAR(volume(made), 1000 - taken_by_two(1, 2, 10), 1e-5);
}

TEST(FilletRadii, OfThreeEdgesInACornerAreFilled) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const std::map<int, EdgeRadius> own{{edge_at(box, {5, 0, 10}), {1}},
                                      {edge_at(box, {0, 5, 10}), {2}},
                                      {edge_at(box, {0, 0, 5}), {1.5}}};
  std::vector<int> edges;
  for (const auto& [edge, radius] : own) edges.push_back(edge);

  const FilletResult made = fillet(box, edges, {.own = own});

  expect_sound(made);
  EXPECT_EQ(radii_of(made).size(), 3U);
}

// Case A4 of Open CASCADE's blend/simple, whose answer has this area.
TEST(FilletRadii, OfThreeEdgesOfAPlateTakeTheAreaOfOpenCascades) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(100., 100., 10.).Shape();
  BRepFilletAPI_MakeFillet theirs(plate);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(plate, TopAbs_EDGE, edges);
  const std::map<int, EdgeRadius> own{{5, {10}}, {6, {5}}, {10, {5}}};  // upright, above
  for (const auto& [edge, of] : own) theirs.Add(of.radius, TopoDS::Edge(edges(edge)));
  theirs.Build();
  ASSERT_TRUE(theirs.IsDone());

  const FilletResult made = fillet(plate, {5, 6, 10}, {.own = own});

  expect_sound(made);
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_NEAR(total_area(made.solids.front().solid), total_area(theirs.Shape()), 1e-6);
}

TEST(FilletRadii, MayChangeAlongOneEdgeOnly) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const int low = edge_at(box, {0, 0, 5}), high = edge_at(box, {10, 10, 5});

  const FilletResult made = fillet(
      box, {low, high}, {.radius = 1, .own = {{high, {1, RadiusLaw::linear({0, 1}, 2, 3)}}}});

  expect_sound(made);
  const double taken = 1000 - volume(made) - 10 * kCut;
  EXPECT_NEAR(taken, 10 * kCut * (4 + 6 + 9) / 3, 0.1);
  EXPECT_EQ(radii_of(made), (std::map<int, double>{{low, 1}}));
}

// A box with a rounded vertical edge: the edges of its top go on in the arc.
class FilletRadiiOfAChain : public ::testing::Test {
 protected:
  FilletRadiiOfAChain() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
    shape_ = fillet(box, {edge_at(box, {0, 0, 5})}, {.radius = 3}).solids.front().solid;
    along_x_ = edge_at(shape_, {6.5, 0, 10});
    along_y_ = edge_at(shape_, {0, 6.5, 10});
  }
  TopoDS_Shape shape_;
  int along_x_ = 0, along_y_ = 0;
};

TEST_F(FilletRadiiOfAChain, ThatDifferAreRefusedInWords) {
  const FilletResult made =
      fillet(shape_, {along_x_, along_y_}, {.own = {{along_x_, {1}}, {along_y_, {2}}}});

  EXPECT_TRUE(made.solids.empty());
  ASSERT_EQ(made.refused.size(), 1U);
  EXPECT_EQ(made.refused.front().edge, std::max(along_x_, along_y_));
  EXPECT_NE(made.refused.front().cause.find("edge " + std::to_string(std::min(along_x_, along_y_)) +
                                            " goes on in it smoothly"),
            std::string::npos)
      << told(made);
}

TEST_F(FilletRadiiOfAChain, OneOfAnEdgeHoldsForAllAndIsToldOfTheOthers) {
  const FilletResult made =
      fillet(shape_, {along_x_, along_y_}, {.radius = 2, .own = {{along_x_, {1}}}});
  const FilletResult same = fillet(shape_, {along_x_}, {.radius = 1});

  expect_sound(made);
  EXPECT_NEAR(volume(made), volume(same), 1e-9);
  ASSERT_EQ(made.notes.size(), 1U);
  EXPECT_EQ(made.notes.front(), "edge " + std::to_string(along_y_) + " has the radius of edge " +
                                    std::to_string(along_x_) + ", which goes on in it smoothly");
}

// The concave edge comes first; the others get other numbers in what it makes.
TEST(FilletRadii, KeepToTheirEdgesWhereOneKindComesFirst) {
  const TopoDS_Shape angle =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10., 10., 10.).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(5, 5, -1), 6, 6, 12).Shape())
          .Shape();
  const int inner = edge_at(angle, {5, 5, 5});
  const int along_x = edge_at(angle, {7.5, 5, 10}), along_y = edge_at(angle, {5, 7.5, 10});
  const int far = edge_at(angle, {0, 0, 5});
  std::map<int, EdgeRadius> own{{inner, {1}}, {far, {3}}, {along_x, {0.5}}, {along_y, {0.5}}};

  const FilletResult made = fillet(angle, {inner, along_x, along_y, far}, {.own = own});

  expect_sound(made);
  const std::map<int, double> radii = radii_of(made);
  for (const auto& [edge, of] : own) EXPECT_NEAR(radii.at(edge), of.radius, 1e-12) << edge;
}

// Two of one kind that would go on smoothly in each other over the end of the third, but for their
// radii: all three end before the corner. Where the third is much the larger one, the face that
// turns by three quarters of a circle grows over what that fills.
TEST(FilletRadii, OfBothKindsThatAllDifferLeaveACornerThatIsFilled) {
  const TopoDS_Shape angle =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10., 10., 10.).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(5, 5, -1), 6, 6, 12).Shape())
          .Shape();
  const int inner = edge_at(angle, {5, 5, 5});
  const int along_x = edge_at(angle, {7.5, 5, 10}), along_y = edge_at(angle, {5, 7.5, 10});
  for (const double of_inner : {0.5, 1.0, 2.0}) {
    std::map<int, EdgeRadius> own{{inner, {of_inner}}, {along_x, {0.5}}, {along_y, {0.4}}};

    const FilletResult made = fillet(angle, {inner, along_x, along_y}, {.own = own});

    expect_sound(made);
    const std::map<int, double> radii = radii_of(made);
    for (const auto& [edge, of] : own) EXPECT_NEAR(radii.at(edge), of.radius, 1e-12) << edge;
    const FilletedSolid& solid = made.solids.front();
    TopTools_IndexedMapOfShape numbers;
    TopExp::MapShapes(solid.solid, TopAbs_FACE, numbers);
    std::set<int> of_corner;
    for (const FilletFace& each : solid.faces)
      if (each.from == 0 && each.edge == 0) of_corner.insert(numbers.FindIndex(each.face));
    EXPECT_GE(of_corner.size(), 6U);
    for (const EdgeContinuity& each : edge_continuity(solid.solid)) {
      if (!each.found ||
          (of_corner.count(each.faces[0]) == 0 && of_corner.count(each.faces[1]) == 0))
        continue;
      EXPECT_LT(each.found->angle.value, 1e-6) << each.number;
    }
  }
}

// A thin bore beside the inner corner is cut off by the fill, or lies where that would go on in the
// upper face: this is told of the corner.
TEST(FilletRadii, OfBothKindsHaveNoRoomForACornerBesideABore) {
  const TopoDS_Shape angle =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10., 10., 10.).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(5, 5, -1), 6, 6, 12).Shape())
          .Shape();
  for (const double away : {0.04, 0.06}) {
    const gp_Ax2 axis(gp_Pnt(5 - away, 5 - away, -1), gp::DZ());
    const TopoDS_Shape bored =
        BRepAlgoAPI_Cut(angle, BRepPrimAPI_MakeCylinder(axis, 0.03, 12).Shape()).Shape();
    const int inner = edge_at(bored, {5, 5, 5});
    const int along_x = edge_at(bored, {7.5, 5, 10}), along_y = edge_at(bored, {5, 7.5, 10});
    const std::map<int, EdgeRadius> own{{inner, {0.5}}, {along_x, {0.5}}, {along_y, {0.4}}};

    FilletOptions options{.own = own, .largest = false};
    const FilletResult made = fillet(bored, {inner, along_x, along_y}, options);

    EXPECT_TRUE(made.solids.empty());
    ASSERT_EQ(made.refused.size(), 1U);
    const FilletRefusal& why = made.refused.front();
    EXPECT_EQ(why.fault, FilletFault::Corner) << why.text();
    ASSERT_TRUE(why.point);
    EXPECT_LT(distance(*why.point, {5, 5, 10}), 1e-9) << away << why.text();
  }
}

// Radii that change along edges do so from each end of one to that of the next.
TEST(FilletRadii, ThatChangeAlongAllEdgesOfAnAngle) {
  const TopoDS_Shape angle =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10., 10., 10.).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(5, 5, -1), 6, 6, 12).Shape())
          .Shape();
  std::vector<int> edges(18);
  std::iota(edges.begin(), edges.end(), 1);
  FilletOptions options;
  for (const RadiusLaw& law :
       {RadiusLaw::linear({0, 1}, 0.6, 0.3), RadiusLaw::table({0, 0.5, 1}, {0.4, 0.6, 0.4})}) {
    options.law = law;

    const FilletResult made = fillet(angle, edges, options);

    expect_sound(made);
    EXPECT_EQ(made.edges.size(), 18U);
  }
}

TEST(FilletRadii, TooLargeIsToldOfTheEdgeThatHasIt) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const int low = edge_at(box, {0, 0, 5}), high = edge_at(box, {10, 10, 5});
  FilletOptions options{.radius = 1, .own = {{high, {12}}}};

  const FilletResult made = fillet(box, {low, high}, options);

  ASSERT_EQ(made.refused.size(), 1U);
  EXPECT_EQ(made.refused.front().edge, high);
  ASSERT_TRUE(made.refused.front().largest) << told(made);
  EXPECT_NEAR(*made.refused.front().largest, 10, 1e-6);

  options.partial = true;
  const FilletResult part = fillet(box, {low, high}, options);
  EXPECT_EQ(part.edges, std::vector<int>{low});
  EXPECT_NEAR(volume(part), 1000 - 10 * kCut, 1e-9);
}

// The face between is 10 wide: with 4 beside it, 6 is left.
TEST(FilletRadii, TooLargeForTheOthersLeavesThoseAsTheyAre) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const int low = edge_at(box, {0, 0, 5}), high = edge_at(box, {10, 0, 5});

  const FilletResult made = fillet(box, {low, high}, {.own = {{low, {4}}, {high, {8}}}});

  ASSERT_EQ(made.refused.size(), 1U);
  ASSERT_TRUE(made.refused.front().largest) << told(made);
  EXPECT_LE(*made.refused.front().largest, 6 + 1e-9);
  EXPECT_GE(*made.refused.front().largest, 6 / 1.01);
  EXPECT_NE(told(made).find("smaller radii of edge " + std::to_string(high) + " were tried"),
            std::string::npos)
      << told(made);
}

TEST(FilletRadii, ThatAddUpToTheWidthOfAFaceConsumeIt) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const int low = edge_at(box, {0, 0, 5}), high = edge_at(box, {10, 0, 5});

  const FilletResult made = fillet(box, {low, high}, {.own = {{low, {4}}, {high, {6}}}});

  expect_sound(made);
  EXPECT_NEAR(volume(made), 1000 - 10 * kCut * (16 + 36), 1e-9);
}

TEST(FilletRadii, AskForWhatMakesSense) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const auto asked = [&](const std::map<int, EdgeRadius>& own) {
    return fillet(box, {1, 2}, {.own = own});
  };
  EXPECT_THROW(asked({{3, {1}}}), InvalidInput);
  EXPECT_THROW(asked({{1, {0}}}), InvalidInput);
  EXPECT_THROW(asked({{1, {-1}}}), InvalidInput);
  EXPECT_THROW(asked({{1, {NAN}}}), InvalidInput);
  EXPECT_THROW(fillet(box, {1}, {.own = {{1, {1}}}, .chamfer = ChamferSize{1, {}, {}}}),
               InvalidInput);
}

// A law that has a knot in the middle of a closed edge, where a border of the face's patches is,
// too, but for rounding.
TEST(FilletOfChangingRadius, GoesRoundAClosedEdgeWithAKnotOnABorderOfPatches) {
  BRepOffsetAPI_ThruSections maker(true);
  for (const auto& [a, b, z] :
       {std::array{10., 6., 0.}, std::array{11., 7., 10.}, std::array{4., 4., 20.}})
    maker.AddWire(BRepBuilderAPI_MakeWire(
        BRepBuilderAPI_MakeEdge(gp_Elips(gp_Ax2(gp_Pnt(0, 0, z), gp::DZ()), a, b))));
  const TopoDS_Shape bottle = maker.Shape();
  const RadiusLaw law = RadiusLaw::table({0, 0.5, 1}, {0.3, 0.6, 0.3});
  int rounded = 0;
  for (const EdgeFacts& each : edge_facts(bottle)) {
    if (each.kind != EdgeKind::Convex) continue;
    const FilletResult made = fillet(bottle, {each.number}, {.law = law});
    expect_sound(made);
    ++rounded;
  }
  EXPECT_EQ(rounded, 2);
}

// A blind hole in the side of a rod, a little off its middle: beside it the wall is 3.7 thick on
// one side. Balls of more than half of that do not go through there, but come round behind the
// bottom of the hole: that way is none along the rim.
TEST(FilletOfARimBesideAThinWall, IsRefusedForBallsThatDoNotGoThrough) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(8.464, 40).Shape();
  const gp_Ax2 axis(gp_Pnt(0, -0.13, 20), gp_Dir(1, 0, 0));
  const TopoDS_Shape shape =
      BRepAlgoAPI_Cut(rod, BRepPrimAPI_MakeCylinder(axis, 4.634, 20).Shape()).Shape();
  int rim = 0;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Convex && each.length > 10 && each.middle[0] > 1) rim = each.number;
  ASSERT_GT(rim, 0);
  EXPECT_EQ(fillet(shape, {rim}, {.radius = 1.8, .largest = false}).solids.size(), 1U);
  const FilletResult made = fillet(shape, {rim}, {.radius = 1.9, .largest = false});
  EXPECT_TRUE(made.solids.empty());
  ASSERT_FALSE(made.refused.empty());
  EXPECT_EQ(made.refused.front().fault, FilletFault::LeavesFace);
  ASSERT_TRUE(made.refused.front().point);
  EXPECT_LT((*made.refused.front().point)[1], -4.764);  // beside the thin wall
}

}  // namespace
}  // namespace blossom::occt
