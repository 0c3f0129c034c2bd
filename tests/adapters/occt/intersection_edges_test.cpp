// SPDX-License-Identifier: LGPL-2.1-or-later
// What two shapes have in common, as one shape.
#include "adapters/occt/intersection_edges.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

using std::numbers::pi;

struct Parts {
  int wires = 0, closed = 0, edges = 0, vertices = 0, lone = 0;
  double length = 0;
};

Parts parts_of(const TopoDS_Shape& all) {
  EXPECT_TRUE(BRepCheck_Analyzer(all).IsValid());
  Parts parts;
  TopTools_IndexedMapOfShape edges, vertices;
  TopExp::MapShapes(all, TopAbs_EDGE, edges);
  TopExp::MapShapes(all, TopAbs_VERTEX, vertices);
  parts.edges = edges.Extent();
  parts.vertices = vertices.Extent();
  for (int i = 1; i <= edges.Extent(); ++i)
    parts.length += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(TopoDS::Edge(edges(i))));
  for (TopoDS_Iterator it(all); it.More(); it.Next()) {
    const bool is_wire = it.Value().ShapeType() == TopAbs_WIRE;
    (is_wire ? parts.wires : parts.lone) += 1;
    if (is_wire && it.Value().Closed()) ++parts.closed;
  }
  return parts;
}

Parts common_of(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  const std::vector<TopoDS_Face> of_a = faces_of(a), of_b = faces_of(b);
  return parts_of(joined_intersection(intersect(of_a, of_b), of_a, of_b).wires);
}

void expect_wires(const Parts& found, const Parts& wanted) {
  EXPECT_EQ(found.wires, wanted.wires);
  EXPECT_EQ(found.closed, wanted.closed);
  EXPECT_EQ(found.edges, wanted.edges);
  EXPECT_EQ(found.vertices, wanted.vertices);
  EXPECT_EQ(found.lone, wanted.lone);
  EXPECT_NEAR(found.length, wanted.length, 1e-9);
}

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high) { return BRepPrimAPI_MakeBox(low, high); }

TEST(JoinedIntersection, OfABarThroughABlockIsTwoClosedWires) {
  expect_wires(common_of(box({0, 0, 0}, {4, 4, 4}), box({-1, 1, 1}, {5, 2, 3})),
               {.wires = 2, .closed = 2, .edges = 8, .vertices = 8, .length = 12});
}

// Both faces of either edge meet both of the other in it, and others in its ends.
TEST(JoinedIntersection, HasACommonEdgeOnce) {
  expect_wires(common_of(box({0, 0, 0}, {4, 1, 1}), box({1, 1, 1}, {3, 2, 2})),
               {.wires = 1, .edges = 1, .vertices = 2, .length = 2});
}

// The side and the bottom of the cylinder meet the plate in the same circle.
TEST(JoinedIntersection, HasAClosedEdgeOnce) {
  const TopoDS_Shape plate = box({-3, -3, -1}, {3, 3, 0});
  expect_wires(common_of(plate, BRepPrimAPI_MakeCylinder(1, 2).Shape()),
               {.wires = 1, .closed = 1, .edges = 1, .vertices = 1, .length = 2 * pi});
}

// The bar is as high as the block: three wires lead from one of two corners to the other.
TEST(JoinedIntersection, IsDividedWhereAThirdCurveEnds) {
  expect_wires(common_of(box({0, 0, 0}, {4, 4, 4}), box({1, -1, 3}, {2, 2, 4})),
               {.wires = 3, .edges = 7, .vertices = 6, .length = 9});
}

TEST(JoinedIntersection, HasAContactOnceWhereNoEdgePasses) {
  const Parts parts = common_of(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2}));
  EXPECT_EQ(parts.edges, 0);
  EXPECT_EQ(parts.lone, 1);
  const Parts ball =
      common_of(box({-3, -3, -1}, {3, 3, 0}), BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 1), 1).Shape());
  EXPECT_EQ(ball.edges, 0);
  EXPECT_EQ(ball.lone, 1);
}

// A cone's circle at its foot is an edge of both: it is found with its side and its bottom, begins
// in another place than the cylinder's, and is one edge.
TEST(JoinedIntersection, OfCirclesThatBeginElsewhereIsOne) {
  const TopoDS_Shape cone =
      BRepPrimAPI_MakeCone(gp_Ax2({0, 0, 2}, gp::DZ(), gp_Dir(0.6, 0.8, 0)), 1, 0.2, 1).Shape();
  const Parts parts = common_of(BRepPrimAPI_MakeCylinder(1, 2).Shape(), cone);
  EXPECT_EQ(parts.closed, 1);
  EXPECT_NEAR(parts.length, 2 * pi, 1e-9);
}

// Neighbours of which one states that its edges are off, as after a translation.
TEST(JoinedIntersection, JoinsWhatIsApartByWhatFacesState) {
  const double off = 1e-4;
  const TopoDS_Shape low = box({0, 0, 0}, {4, 4, 2}), high = box({0, off, 2}, {4, 4, 4});
  BRep_Builder builder;
  TopTools_IndexedMapOfShape edges;
  for (const TopoDS_Shape& each : {low, high}) TopExp::MapShapes(each, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    builder.UpdateEdge(TopoDS::Edge(edges(i)), 2 * off);
    for (const bool first : {true, false})
      builder.UpdateVertex(first ? TopExp::FirstVertex(TopoDS::Edge(edges(i)))
                                 : TopExp::LastVertex(TopoDS::Edge(edges(i))),
                           2 * off);
  }
  // The fronts of both, in a wall that crosses them.
  const std::vector<TopoDS_Face> fronts{faces_of(low)[2], faces_of(high)[2]};
  const std::vector<TopoDS_Face> wall = faces_of(box({1, -1, -1}, {2, 1, 5}));
  const Parts parts = parts_of(joined_intersection(intersect(fronts, wall), fronts, wall).wires);
  EXPECT_EQ(parts.wires, 2);
  EXPECT_EQ(parts.edges, 4);
  EXPECT_EQ(parts.vertices, 6);
}

// Open CASCADE's search for feet throws on curves that are about as short as its own tolerances. A
// cone of half angle 56 degrees, whose tip is 1.2 tolerances inside of a cylinder 10 degrees off.
TEST(CommonShape, HoldsLoopsOfAMillionth) {
  const double slope = std::tan(56 * pi / 180), tilt = 10 * pi / 180;
  const gp_Dir up(std::sin(tilt), 0, std::cos(tilt)), along(std::cos(tilt), 0, -std::sin(tilt));
  const gp_Pnt foot = gp_Pnt(0, 0, 1).Translated(gp_Vec(up) * -(1.3 + 1.2e-7));
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(slope, 0, 1).Face();
  const TopoDS_Shape cylinder =
      BRepPrimAPI_MakeCylinder(gp_Ax2(foot.Translated(gp_Vec(along) * -2.02), along), 1.3, 4)
          .Face();
  const Parts parts = common_of(cone, cylinder);
  EXPECT_GE(parts.wires, 2);  // and the curve in which the cylinder leaves the cone
  EXPECT_EQ(parts.closed, 1);
}

// No other face says where they end.
TEST(JoinedIntersection, OfSheetsHasTheBorderOfTheirCommonRegion) {
  const gp_Pln level(gp_Pnt(), gp_Dir(0, 0, 1));
  const TopoDS_Shape square = BRepBuilderAPI_MakeFace(level, 0, 4, 0, 4).Face();
  const TopoDS_Shape other = BRepBuilderAPI_MakeFace(level, 1, 6, 2, 6).Face();
  const Parts corner = common_of(square, other);
  EXPECT_NEAR(corner.length, 10, 1e-9);
  EXPECT_EQ(corner.edges, 4);
  EXPECT_EQ(corner.closed, 1);
  const gp_Circ round(gp_Ax2(gp_Pnt(2, 2, 0), gp_Dir(0, 0, 1)), 1);
  const TopoDS_Shape disc =
      BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(round))).Face();
  for (const Parts& inside : {common_of(square, disc), common_of(disc, square)}) {
    EXPECT_NEAR(inside.length, 2 * pi, 1e-9);
    EXPECT_EQ(inside.edges, 1);
  }
  EXPECT_NEAR(common_of(square, square).length, 16, 1e-9);
  // A region that is common by the tolerance alone has its border by that, too, and once.
  const gp_Pln above(gp_Pnt(0, 0, 5e-5), gp_Dir(0, 0, 1));
  const std::vector<TopoDS_Face> low{TopoDS::Face(square)};
  const std::vector<TopoDS_Face> high{BRepBuilderAPI_MakeFace(above, 1, 6, 2, 6).Face()};
  IntersectionOptions options;
  options.tolerances.point = 1e-4;
  const JoinedIntersection near = joined_intersection(intersect(low, high, options), low, high);
  EXPECT_TRUE(near.lost.empty());
  EXPECT_NEAR(parts_of(near.wires).length, 10, 1e-3);
  EXPECT_EQ(parts_of(near.wires).edges, 4);
  // Two of its edges lie on edges of the box.
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, -3), gp_Pnt(5, 5, 0)).Shape();
  const Parts on_box = common_of(box, square);
  EXPECT_NEAR(on_box.length, 16, 1e-9);
  EXPECT_EQ(on_box.edges, 4);
}

// They are edges of faces like others, though the region goes on over them.
TEST(JoinedIntersection, HasSeamsAndEdgesOverWhichACommonRegionGoesOn) {
  const auto tube = [](double from, double turn) {
    const gp_Ax2 axes(gp_Pnt(0, 0, from), gp_Dir(0, 0, 1),
                      gp_Dir(std::cos(turn), std::sin(turn), 0));
    return BRepPrimAPI_MakeCylinder(axes, 2, 4).Shape();
  };
  expect_wires(common_of(tube(0, 0), tube(2, 0)), {3, 2, 3, 2, 0, 8 * pi + 2});
  EXPECT_NEAR(common_of(tube(0, 0), tube(2, 1)).length, 8 * pi + 4, 1e-7);
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(2).Shape();
  EXPECT_NEAR(common_of(ball, ball).length, 2 * pi, 1e-7);
  // Half a tube has two plane faces that meet in its axis.
  const TopoDS_Shape half = BRepPrimAPI_MakeCylinder(2, 4, pi).Shape();
  const gp_Ax3 upright(gp_Pnt(), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0));
  const TopoDS_Shape wall = BRepBuilderAPI_MakeFace(gp_Pln(upright), -1, 1, 1, 3).Face();
  EXPECT_NEAR(common_of(half, wall).length, 8 + 2, 1e-7);
  EXPECT_NEAR(common_of(wall, half).length, 8 + 2, 1e-7);
}

// Of one shape each pair is listed once, so it matters to none in which order its faces come.
TEST(JoinedIntersection, OfOneShapeHasEdgesOverWhichACommonRegionGoesOnInAnyOrder) {
  const auto face = [](const std::array<gp_Pnt, 4>& p) {
    return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakePolygon(p[0], p[1], p[2], p[3], true)).Face();
  };
  // A shell that comes back to lie over its first two faces, which share an edge.
  const std::array<TopoDS_Face, 5> shell{
      face({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}),
      face({{{2, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}}}),
      face({{{0, 0, 0}, {2, 0, 0}, {3, 0.25, 1}, {1, 0.25, 1}}}),
      face({{{1, 0.25, 1}, {3, 0.25, 1}, {3, 0.5, 0}, {1, 0.5, 0}}}),
      face({{{1, 0.5, 0}, {3, 0.5, 0}, {3, 1.5, 0}, {1, 1.5, 0}}})};
  BRepBuilderAPI_Sewing sewing;
  for (const TopoDS_Face& each : shell) sewing.Add(each);
  sewing.Perform();
  for (const std::array<std::size_t, 5>& order :
       {std::array<std::size_t, 5>{0, 1, 2, 3, 4}, {0, 2, 3, 4, 1}, {4, 3, 2, 1, 0}}) {
    std::vector<TopoDS_Face> faces;
    for (const std::size_t i : order) faces.push_back(TopoDS::Face(sewing.Modified(shell[i])));
    const ShapeIntersection found = self_intersect(faces, SelfScope::AllFaces);
    EXPECT_NEAR(parts_of(joined_intersection(found, faces, faces).wires).length, 7, 1e-9);
  }
}

}  // namespace
}  // namespace blossom::occt
