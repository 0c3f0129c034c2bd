// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface that folds back along a smooth edge, within the edge's tolerance, as the ends of
// approximated surfaces do: what lies in the tube round the edge is the edge.

#include <gtest/gtest.h>

#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

constexpr double kWidth = 2;        // of both faces, along the edge
constexpr double kEdge = 4;         // where the edge is, in x
constexpr double kLastSpan = 1e-7;  // the last span of the floor, its parameters
constexpr double kEdgeTolerance = 4e-7;

struct Knots {
  std::vector<double> values;
  std::vector<int> multiplicities;
};

// Poles in the xz-plane, moved along y; u is y.
Handle(Geom_BSplineSurface)
    moved_along_y(const std::vector<gp_Pnt>& poles, const Knots& v_knots, int degree) {
  const int count = static_cast<int>(poles.size()), knots = static_cast<int>(v_knots.values.size());
  TColgp_Array2OfPnt points(1, 2, 1, count);
  for (int row = 1; row <= 2; ++row)
    for (int i = 1; i <= count; ++i)
      points(row, i) =
          poles[static_cast<std::size_t>(i - 1)].Translated(gp_Vec(0, row == 1 ? 0 : kWidth, 0));
  TColStd_Array1OfReal u(1, 2), v(1, knots);
  TColStd_Array1OfInteger of_u(1, 2), of_v(1, knots);
  u(1) = 0, u(2) = kWidth;
  of_u.Init(2);
  for (int i = 1; i <= knots; ++i) {
    v(i) = v_knots.values[static_cast<std::size_t>(i - 1)];
    of_v(i) = v_knots.multiplicities[static_cast<std::size_t>(i - 1)];
  }
  return new Geom_BSplineSurface(points, u, v, of_u, of_v, 1, degree);
}

// The edge from (x, 0, z) to (x, width, z).
TopoDS_Edge edge_at(const gp_Pnt& from) {
  return BRepBuilderAPI_MakeEdge(BRepBuilderAPI_MakeVertex(from).Vertex(),
                                 BRepBuilderAPI_MakeVertex(from.Translated(gp_Vec(0, kWidth, 0))))
      .Edge();
}

void put_on(const TopoDS_Edge& edge, const Handle(Geom_Surface) & surface, double v) {
  BRep_Builder().UpdateEdge(edge, new Geom2d_Line(gp_Pnt2d(0, v), gp_Dir2d(1, 0)), surface,
                            TopLoc_Location(), 1e-7);
}

// The side of a surface on which u is constant, between the vertices of two edges.
TopoDS_Edge side(const Handle(Geom_Surface) & surface, double u, const TopoDS_Vertex& low,
                 const TopoDS_Vertex& high, double v_low, double v_high) {
  const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(u, v_low), gp_Dir2d(0, 1));
  TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(line, surface, low, high, 0, v_high - v_low).Edge();
  BRepLib::BuildCurve3d(edge);
  return edge;
}

// A face between edges along its first and last v.
TopoDS_Face face_between(const Handle(Geom_Surface) & surface, const TopoDS_Edge& low,
                         const TopoDS_Edge& high) {
  double u_low = 0, u_high = 0, v_low = 0, v_high = 0;
  surface->Bounds(u_low, u_high, v_low, v_high);
  put_on(low, surface, v_low);
  put_on(high, surface, v_high);
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, low.Oriented(TopAbs_FORWARD));
  builder.Add(wire, side(surface, u_high, TopExp::LastVertex(low), TopExp::LastVertex(high), v_low,
                         v_high));
  builder.Add(wire, high.Oriented(TopAbs_REVERSED));
  builder.Add(
      wire, side(surface, u_low, TopExp::FirstVertex(low), TopExp::FirstVertex(high), v_low, v_high)
                .Oriented(TopAbs_REVERSED));
  TopoDS_Face face;
  builder.MakeFace(face, surface, 1e-7);
  builder.Add(face, wire);
  return face;
}

// A floor that goes beyond the edge by `fold` and comes back to it, and a sheet that goes on from
// there smoothly.
std::vector<TopoDS_Face> floor_that_folds_and_sheet(double fold) {
  const TopoDS_Edge left = edge_at({0, 0, 0}), common = edge_at({kEdge, 0, 0}),
                    top = edge_at({2, 0, 3});
  const auto floor = moved_along_y({{0, 0, 0}, {kEdge + fold, 0, 0}, {kEdge, 0, 0}},
                                   {{0, 1, 1 + kLastSpan}, {2, 1, 2}}, 1);
  const auto sheet =
      moved_along_y({{kEdge, 0, 0}, {7, 0, 0}, {7, 0, 4}, {2, 0, 3}}, {{0, 1}, {4, 4}}, 3);
  const std::vector<TopoDS_Face> faces{face_between(floor, left, common),
                                       face_between(sheet, common, top)};
  BRep_Builder().UpdateEdge(common, kEdgeTolerance);
  return faces;
}

TEST(FoldedBorder, IsTheEdgeWithinItsTolerance) {
  const auto found = self_intersect(floor_that_folds_and_sheet(3e-7), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

TEST(FoldedBorder, IsFoundWhereItLeavesTheTolerance) {
  const auto found = self_intersect(floor_that_folds_and_sheet(3e-5), SelfScope::AllFaces);
  EXPECT_TRUE(found.status != Status::Complete || !found.pairs.empty());
}

// Two sheets from one edge, 1.6 degrees apart. The lower one begins higher and crosses the upper
// one beside the edge, 35 times as far from it as it begins higher.
std::vector<TopoDS_Face> closed_fold(double higher, double tolerance) {
  const TopoDS_Edge common = edge_at({0, 0, 0});
  const BRep_Builder builder;
  builder.UpdateEdge(common, tolerance);
  for (const TopoDS_Vertex& end : {TopExp::FirstVertex(common), TopExp::LastVertex(common)})
    builder.UpdateVertex(end, 1.1 * higher);
  const Knots one_span{{0, 1}, {3, 3}};
  const auto upper = moved_along_y({{0, 0, 0}, {1, 0, 0}, {2, 0, 1}}, one_span, 2);
  const auto lower =
      moved_along_y({{0, 0, higher}, {1, 0, higher - 1 / 35.0}, {2, 0, -1}}, one_span, 2);
  return {face_between(upper, common, edge_at({2, 0, 1})),
          face_between(lower, common, edge_at({2, 0, -1}))};
}

TEST(NearlyTangentNeighbours, CrossBesideTheirEdgeNoDeeperThanItIsExact) {
  for (const double higher : {7.5e-8, 7.5e-6}) {
    const auto found = self_intersect(closed_fold(higher, 1.1 * higher), SelfScope::AllFaces);
    EXPECT_EQ(found.status, Status::Complete) << higher;
    EXPECT_TRUE(found.pairs.empty()) << higher;
  }
}

// What is not proven beside a shared edge is no find: the edge is what the model says of it.
TEST(NearlyTangentNeighbours, LeaveNoPlaceBesideAnEdgeThatIsLessExactThanItSays) {
  const auto found = self_intersect(closed_fold(1e-6, 1e-7), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_FALSE(found.certificate.reasons.empty());
}

}  // namespace
}  // namespace blossom::occt
