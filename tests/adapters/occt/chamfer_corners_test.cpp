// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners of three and more chamfers.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Plane.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Circ.hxx>
#include <gp_Vec.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;

template <class Fits>
std::vector<int> convex_edges(const TopoDS_Shape& shape, const Fits& fits) {
  std::vector<int> found;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Convex && fits(each)) found.push_back(each.number);
  return found;
}

std::vector<int> convex_edges(const TopoDS_Shape& shape) {
  return convex_edges(shape, [](const EdgeFacts&) { return true; });
}

// Convex and concave.
std::vector<int> sharp_edges(const TopoDS_Shape& shape) {
  std::vector<int> found = convex_edges(shape);
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Concave) found.push_back(each.number);
  return found;
}

FilletResult chamfered(const TopoDS_Shape& shape, const std::vector<int>& edges, double distance) {
  FilletOptions options;
  options.chamfer = ChamferSize{distance};
  return fillet(shape, edges, options);
}

// One sound solid, smaller than before.
void expect_smaller(const FilletResult& made) {
  testing::expect_sound(made);
  if (made.solids.size() == 1) {
    EXPECT_LT(made.solids.front().volume, made.volume_before);
  }
}

std::vector<TopoDS_Face> corners(const FilletResult& made) {
  std::vector<TopoDS_Face> found;
  for (const FilletFace& each : made.solids.front().faces)
    if (each.from == 0 && each.edge == 0) found.push_back(each.face);
  return found;
}

// Squares at heights 0, 10 and 20, turned by an angle each time: the sides are twisted.
TopoDS_Shape twisted_loft() {
  BRepOffsetAPI_ThruSections maker(true);
  for (const double z : {0., 10., 20.}) {
    BRepBuilderAPI_MakePolygon square;
    for (int i = 0; i < 4; ++i) {
      const double angle = 0.02 * z + (i + 0.5) * kPi / 2;
      square.Add(gp_Pnt(8 * std::cos(angle), 8 * std::sin(angle), z));
    }
    square.Close();
    maker.AddWire(square.Wire());
  }
  return maker.Shape();
}

TopoDS_Shape chamfered_box() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 16, 12).Shape();
  return chamfered(box, convex_edges(box), 2).solids.front().solid;
}

// Under a spline, half a turn round.
TopoDS_Shape half_dome() {
  TColgp_Array1OfPnt points(1, 4);
  points(1) = {9, 0, 0};
  points(2) = {10, 0, 5};
  points(3) = {6, 0, 11};
  points(4) = {5, 0, 17};
  const Handle(Geom_BSplineCurve) side = GeomAPI_PointsToBSpline(points).Curve();
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), points(1)).Edge(),
                               BRepBuilderAPI_MakeEdge(side).Edge(),
                               BRepBuilderAPI_MakeEdge(points(4), gp_Pnt(0, 0, 17)).Edge(),
                               BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 17), gp_Pnt(0, 0, 0)).Edge());
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(wire.Wire()).Shape();
  return BRepPrimAPI_MakeRevol(face, gp_Ax1(gp::Origin(), gp::DZ()), kPi).Shape();
}

TEST(ChamferCorner, OfThreeBesideCurvedFacesIsAPlane) {
  const TopoDS_Shape shape = twisted_loft();
  const FilletResult made = chamfered(shape, convex_edges(shape), 0.3);
  expect_smaller(made);
  const std::vector<TopoDS_Face> found = corners(made);
  EXPECT_GE(found.size(), 8U);
  for (const TopoDS_Face& each : found)
    EXPECT_FALSE(Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(each)).IsNull());
}

// A prism over a polygon, upright.
TopoDS_Shape prism(const std::vector<gp_Pnt>& points, double height) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& each : points) polygon.Add(each);
  polygon.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Shape(),
                               gp_Vec(0, 0, height))
      .Shape();
}

// What chamfers of all edges of an angle take. At a depth s below a side the outline has moved by
// d - s, has five corners with less of them than upright chamfers take, s^2 / 2, and the inner
// corner filled by (2 d - s)^2 / 2: below the plane through the inner corner, in which the chamfers
// meet.
double taken_of_angle(double perimeter, double height, double d) {
  return (perimeter + 2 * height) * d * d - 22.0 / 3 * d * d * d;
}

// Two convex edges and a concave one: a line goes over the upper face from one rim to the other,
// through the corner itself.
TEST(ChamferCorner, OfBothKindsIsAPlaneBetweenAllThree) {
  const TopoDS_Shape angle =
      prism({{0, 0, 0}, {30, 0, 0}, {30, 8, 0}, {8, 8, 0}, {8, 30, 0}, {0, 30, 0}}, 20);
  for (const double d : {0.16, 2.4, 3.92}) {
    const FilletResult made = chamfered(angle, sharp_edges(angle), d);
    testing::expect_sound(made);
    ASSERT_EQ(made.solids.size(), 1U);
    EXPECT_NEAR(made.volume_before - made.solids.front().volume, taken_of_angle(120, 20, d), 1e-9);
    EXPECT_EQ(corners(made).size(), 12U);
    EXPECT_TRUE(made.notes.empty());
  }
}

// The line across the upper face goes over a bore: this is told of the corner.
TEST(ChamferCorner, OfBothKindsHasNoRoomOverABore) {
  const TopoDS_Shape angle =
      prism({{0, 0, 0}, {30, 0, 0}, {30, 8, 0}, {8, 8, 0}, {8, 30, 0}, {0, 30, 0}}, 20);
  const gp_Ax2 axis(gp_Pnt(7.5, 8.5, -1), gp::DZ());
  const TopoDS_Shape bored =
      BRepAlgoAPI_Cut(angle, BRepPrimAPI_MakeCylinder(axis, 0.03, 22).Shape()).Shape();
  std::vector<int> edges;
  for (const EdgeFacts& each : edge_facts(bored))
    if (std::abs(distance(each.middle, {8, 8, 20}) - 0.5 * each.length) < 1e-9)
      edges.push_back(each.number);
  ASSERT_EQ(edges.size(), 3U);
  FilletOptions options{.largest = false};
  for (const double second : {1.0, 0.9}) {
    options.chamfer = ChamferSize{1, second};
    const FilletResult made = fillet(bored, edges, options);
    ASSERT_EQ(made.refused.size(), 1U);
    const FilletRefusal& why = made.refused.front();
    EXPECT_EQ(why.fault, FilletFault::Corner) << why.text();
    EXPECT_LT(distance(why.point.value_or(Vec3{}), {8, 8, 20}), 1e-9) << why.text();
  }
}

// A lens, 4 thick between its points: borders that are 2.5 away from its sides do not cross.
TEST(ChamferCorner, WhoseBordersDoNotCrossInANarrowFaceHasNoRoom) {
  const auto side = [](double y) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, y, 0), gp::DZ()), 10, 20).Shape();
  };
  const TopoDS_Shape lens = BRepAlgoAPI_Common(side(-8), side(8)).Shape();
  FilletOptions options{.largest = false};
  options.chamfer = ChamferSize{2.5};
  const FilletResult made = fillet(lens, convex_edges(lens), options);
  ASSERT_FALSE(made.refused.empty());
  const FilletRefusal& why = made.refused.front();
  EXPECT_EQ(why.fault, FilletFault::Corner) << why.text();
  EXPECT_NEAR(std::abs(why.point.value_or(Vec3{})[0]), 6, 1e-6) << why.text();  // a point of it
}

// The angle between the walls of the notch is 60 degrees: the line across the upper face goes over
// what was open. And of unlike distances, where the corner is in no plane.
TEST(ChamferCorner, OfBothKindsBesideANotch) {
  const TopoDS_Shape notched = prism({{0, 0, 0},
                                      {30, 0, 0},
                                      {30, 30, 0},
                                      {21, 30, 0},
                                      {15, 30 - 6 * std::sqrt(3.), 0},
                                      {9, 30, 0},
                                      {0, 30, 0}},
                                     10);
  testing::expect_sound(chamfered(notched, sharp_edges(notched), 0.8));
  FilletOptions unlike;
  unlike.chamfer = ChamferSize{0.8, 0.5};
  testing::expect_sound(fillet(notched, sharp_edges(notched), unlike));
}

// A rib with a slanting back against a wall, three thick: at half of that the chamfers beside it
// meet, and nothing is left between the fills at both ends of its upper edge.
TEST(ChamferCorner, OfBothKindsMeetsTheNextOne) {
  const TopoDS_Shape foot = BRepPrimAPI_MakeBox(40, 30, 4).Shape();
  const TopoDS_Shape wall = BRepPrimAPI_MakeBox(4, 30, 30).Shape();
  BRepBuilderAPI_MakePolygon side({4, 13, 4}, {20, 13, 4}, {4, 13, 26}, true);
  const TopoDS_Shape rib =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(side.Wire()).Shape(), gp_Vec(0, 3, 0)).Shape();
  ShapeUpgrade_UnifySameDomain whole(
      BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(foot, wall).Shape(), rib).Shape());
  whole.Build();
  for (const double d : {1.49, 1.5}) {
    const FilletResult made = chamfered(whole.Shape(), sharp_edges(whole.Shape()), d);
    testing::expect_sound(made);
    EXPECT_TRUE(made.notes.empty());
  }
}

TEST(ChamferCorner, OfFourThatLieInNoPlaneIsFilled) {
  const TopoDS_Shape shape = chamfered_box();
  const std::vector<int> edges = convex_edges(shape);
  ASSERT_EQ(edges.size(), 48U);
  const FilletResult made = chamfered(shape, edges, 0.2);
  expect_smaller(made);
  EXPECT_EQ(corners(made).size(), 24U * 4);
}

// The fill goes on to the edge that stays, and begins in its point.
TEST(ChamferCorner, LeavesOneOfFourEdgesAsItIs) {
  const TopoDS_Shape shape = chamfered_box();
  // At the vertex (0, 2, 2) of the face x = 0.
  std::vector<int> edges;
  for (const EdgeFacts& each : edge_facts(shape)) {
    Vec3 end = each.middle - Vec3{0, 2, 2};
    if (std::abs(norm(end) - 0.5 * each.length) < 1e-9) edges.push_back(each.number);
  }
  ASSERT_EQ(edges.size(), 4U);
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    std::vector<int> three = edges;
    three.erase(three.begin() + static_cast<std::ptrdiff_t>(left_out));
    expect_smaller(chamfered(shape, three, 0.2));
  }
}

TEST(ChamferOfARevolvedSpline, IsMadeOfHalfCirclesAndAllEdges) {
  const TopoDS_Shape shape = half_dome();
  const auto circles = convex_edges(shape, [](const EdgeFacts& each) {
    return std::abs(each.middle[0]) < 1e-9 && each.middle[1] > 1;
  });
  ASSERT_EQ(circles.size(), 2U);
  for (const int each : circles) expect_smaller(chamfered(shape, {each}, 0.2));
  expect_smaller(chamfered(shape, convex_edges(shape), 0.2));
}

// A plate whose upright edges are rounded by 2.
TopoDS_Shape rounded_plate() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 30, 5).Shape();
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  BRepFilletAPI_MakeFillet rounded(box);
  for (const EdgeFacts& each : edge_facts(box))
    if (std::abs(each.middle[2] - 2.5) < 1e-9) rounded.Add(2, TopoDS::Edge(edges(each.number)));
  return rounded.Shape();
}

int upper_side(const TopoDS_Shape& plate) {
  for (const EdgeFacts& each : edge_facts(plate))
    if (distance(each.middle, {0, 15, 5}) < 1e-6) return each.number;
  ADD_FAILURE() << "no edge there";
  return 0;
}

// Straight parts are 84 long in all; the corners make one turn of a triangle whose centre is a
// third of the distance inside of the arcs.
TEST(ChamferOfARoundedPlate, IsMadeUpToTheRadiusOfItsArcs) {
  const TopoDS_Shape plate = rounded_plate();
  for (const double d : {0.1, 0.5, 0.79, 0.9, 1.0, 1.15, 1.2, 1.5, 1.95, 1.999, 2.0}) {
    const FilletResult made =
        fillet(plate, {upper_side(plate)}, {.chamfer = ChamferSize{d, {}, {}}});
    testing::expect_sound(made);
    if (made.solids.empty()) continue;
    const double cut = d * d / 2 * (84 + 2 * std::numbers::pi * (2 - d / 3));
    EXPECT_NEAR(made.volume_before - made.solids.front().volume, cut, 1e-8) << d;
    EXPECT_EQ(made.edges.size(), 8U);
  }
}

TEST(ChamferOfACylinder, OfTheRadiusIsAPointedCone) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  int upper = 0;
  for (const EdgeFacts& each : edge_facts(cylinder))
    if (each.kind == EdgeKind::Convex && each.middle[2] > 4) upper = each.number;
  const FilletResult made = fillet(cylinder, {upper}, {.chamfer = ChamferSize{2, {}, {}}});
  testing::expect_sound(made);
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_NEAR(made.solids.front().volume, (12 + 8.0 / 3) * std::numbers::pi, 1e-9);
  EXPECT_EQ(made.solids.front().faces.size(), 3U);
}

TEST(ChamferOfARoundedPlate, FillsCornersWhereBordersOfArcsWouldTurnBack) {
  const TopoDS_Shape plate = rounded_plate();
  double last = 0;
  for (const double d : {2.001, 2.5, 4.0}) {
    const FilletResult made =
        fillet(plate, {upper_side(plate)}, {.chamfer = ChamferSize{d, {}, {}}});
    testing::expect_sound(made);
    ASSERT_FALSE(HasFailure()) << d;
    EXPECT_EQ(made.notes.size(), 4U);
    const double taken = made.volume_before - made.solids.front().volume;
    EXPECT_GT(taken, last);
    last = taken;
  }
}

// Where bores cross, edges are splines in two parts, which go on in each other.
TEST(ChamferOfCrossingBores, IsMadeOfAnyDistance) {
  const gp_Ax2 along(gp_Pnt(-60, 0, 0), gp::DX());
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-50, -30, -30), gp_Pnt(50, 30, 40)).Shape();
  const TopoDS_Shape bored = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(along, 17, 120));
  const TopoDS_Shape crossed = BRepAlgoAPI_Cut(bored, BRepPrimAPI_MakeCylinder(11, 60));
  const auto crossing = convex_edges(crossed, [](const EdgeFacts& each) {
    return std::hypot(each.middle[1], each.middle[2]) < 17.1 && std::abs(each.middle[0]) < 12;
  });
  ASSERT_FALSE(crossing.empty());
  double last = 0;
  for (const double d : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0}) {
    const FilletResult made = chamfered(crossed, crossing, d);
    testing::expect_sound(made);
    ASSERT_FALSE(HasFailure()) << d;
    const double taken = made.volume_before - made.solids.front().volume;
    EXPECT_GT(taken, last);
    last = taken;
  }
}

// Beside its upper circle the sides of such a loft go on smoothly in the vertices alone: an edge
// between two of them begins there.
TEST(ChamferOfALoft, GoesRoundItsCircleOverTheEdgesThatBeginThere) {
  BRepBuilderAPI_MakePolygon square(gp_Pnt(-20, -20, 0), gp_Pnt(20, -20, 0), gp_Pnt(20, 20, 0),
                                    gp_Pnt(-20, 20, 0), Standard_True);
  BRepBuilderAPI_MakeWire circle;
  const gp_Circ round(gp_Ax2(gp_Pnt(0, 0, 40), gp::DZ()), 12);
  for (int i = 0; i < 4; ++i)
    circle.Add(BRepBuilderAPI_MakeEdge(round, (i - 1.5) * kPi / 2, (i - 0.5) * kPi / 2));
  BRepOffsetAPI_ThruSections loft(Standard_True, Standard_True);
  loft.AddWire(square);
  loft.AddWire(circle);
  const TopoDS_Shape shape = loft.Shape();
  const auto upper = convex_edges(
      shape, [](const EdgeFacts& each) { return std::abs(each.middle[2] - 40) < 1e-6; });
  ASSERT_GE(upper.size(), 4U);
  for (const double d : {0.01, 0.1, 0.5, 2.0, 5.0}) {
    const FilletResult made = chamfered(shape, {upper.front()}, d);
    testing::expect_sound(made);
    EXPECT_EQ(made.edges.size(), upper.size()) << d;
  }
}

// Of the band between a parabola, y = x x / 40 where |x| <= 10, and its offset inwards.
double band_area(double offset) {
  constexpr int kParts = 2000;
  const auto height = [&](double x) {
    double t = x;  // whose offset is above x
    for (int i = 0; i < 50; ++i) t = x + offset * (t / 20) / std::hypot(1, t / 20);
    return t * t / 40 + offset / std::hypot(1, t / 20) - x * x / 40;
  };
  double sum = 0;
  for (int i = 0; i < kParts; ++i) sum += height(20 * (i + 0.5) / kParts - 10);
  return sum * 20 / kParts;
}

// Its ends are slanted: borders go on past them, on the parabola's own way on. Each layer of what
// is cut off is a band.
TEST(ChamferOfASplineEdge, GoesOnPastItsEndsWhereItsFacesCross) {
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = {-10, 2.5, 0};
  poles(2) = {0, -2.5, 0};
  poles(3) = {10, 2.5, 0};
  BRepBuilderAPI_MakePolygon sides(poles(3), gp_Pnt(10, 20, 0), gp_Pnt(-10, 20, 0), poles(1));
  BRepBuilderAPI_MakeWire outline(BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)));
  outline.Add(sides.Wire());
  const TopoDS_Shape shape =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()), gp_Vec(0, 0, 10));
  const auto edge = convex_edges(shape, [](const EdgeFacts& each) {
    return std::abs(each.middle[2] - 10) < 1e-6 && each.middle[1] < 2;
  });
  ASSERT_EQ(edge.size(), 1U);
  for (const double d : {0.3, 1.5, 4.0})
    for (const auto& angle : {std::optional<double>{}, std::optional<double>{kPi / 4}}) {
      FilletOptions options;
      options.chamfer = ChamferSize{d, {}, angle};
      const FilletResult made = fillet(shape, edge, options);
      ASSERT_EQ(made.solids.size(), 1U);
      testing::expect_sound(made);
      EXPECT_TRUE(made.notes.empty()) << made.notes.front();
      // Simpson's rule over the layers.
      double removed = 0;
      for (const auto& [share, weight] : {std::pair{0., 1.}, {0.5, 4.}, {1., 1.}})
        removed += d / 6 * weight * band_area(share * d);
      EXPECT_NEAR(made.volume_before - made.solids.front().volume, removed, 1e-4 * removed) << d;
    }
}

TEST(ChamferRefuses, SaysThatNoDistanceWorksThatWasTried) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  FilletOptions options;
  options.chamfer = ChamferSize{1, {}, 2.0};  // away from the other face
  const FilletResult made = fillet(box, {1}, options);
  ASSERT_EQ(made.refused.size(), 1U);
  const std::string text = made.refused.front().text();
  EXPECT_NE(text.find("of the smaller and larger distances tried none works either"),
            std::string::npos)
      << text;
}

// The middle of the steps, which go beyond the edge by some distances, is rounded to 0.
TEST(ChamferRefuses, DistancesBesideWhichTheEdgeIsNothing) {
  const TopoDS_Shape bar = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 10, 10).Shape(),
                                           BRepPrimAPI_MakeBox(5, 10, 10).Shape());
  const std::vector<EdgeFacts> edges = edge_facts(bar);
  EXPECT_EQ(edges.size(), 12u);
  for (const EdgeFacts& each : edges) {
    const FilletResult made = chamfered(bar, {each.number}, 2.459e69);
    EXPECT_TRUE(made.solids.empty());
    EXPECT_FALSE(made.refused.empty());
  }
}

TEST(ChamferRefuses, WithTheLargestDistanceThatWorks) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  for (const auto& second : {std::optional<double>{}, std::optional<double>{6}}) {
    FilletOptions options;
    options.chamfer = ChamferSize{12, second};
    const FilletResult made = fillet(shape, {1}, options);
    EXPECT_TRUE(made.solids.empty());
    ASSERT_EQ(made.refused.size(), 1U);
    const FilletRefusal& why = made.refused.front();
    ASSERT_TRUE(why.largest) << why.text();
    EXPECT_LE(*why.largest, 10);
    EXPECT_GE(*why.largest, 9.9);
    EXPECT_NE(why.text().find("the largest distance that works is 9.9"), std::string::npos)
        << why.text();
  }
}

TEST(ChamferRefuses, ToldWhatStopsLargerDistances) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 20., 20.).Shape();
  const FilletResult made = chamfered(box, sharp_edges(box), 6);
  ASSERT_EQ(made.refused.size(), 1U);
  const FilletRefusal& why = made.refused.front();
  ASSERT_TRUE(why.largest) << why.text();
  EXPECT_NEAR(*why.largest, 5, 1e-3);
  EXPECT_NE(why.text().find("; larger distances are stopped by another blend"), std::string::npos)
      << why.text();
}

}  // namespace
}  // namespace blossom::occt
