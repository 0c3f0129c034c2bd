// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of one model meet in what they share alone, or what else they have in common is found.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/intersection.h"
#include "tests/adapters/occt/ordinary_solids.h"

namespace blossom::occt {
namespace {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_FACE, map);
  std::vector<TopoDS_Face> faces;
  for (int i = 1; i <= map.Extent(); ++i) faces.push_back(TopoDS::Face(map(i)));
  return faces;
}

// A floor that goes on in a sheet: in the xz-plane a line to (4, 0) and a curve from there on.
std::vector<TopoDS_Face> floor_and_sheet(const std::vector<gp_Pnt>& poles) {
  TColgp_Array1OfPnt points(1, static_cast<int>(poles.size()));
  for (int i = 1; i <= points.Length(); ++i) points(i) = poles[static_cast<std::size_t>(i - 1)];
  const Handle(Geom_BezierCurve) curve = new Geom_BezierCurve(points);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(4, 0, 0)).Edge(),
                               BRepBuilderAPI_MakeEdge(curve).Edge());
  return faces_of(BRepPrimAPI_MakePrism(wire.Wire(), gp_Vec(0, 2, 0)).Shape());
}

TEST(NeighbourProof, LeavesNothingOfASheetThatGoesOnSmoothly) {
  const auto found = self_intersect(floor_and_sheet({{4, 0, 0}, {7, 0, 0}, {7, 0, 4}, {2, 0, 3}}),
                                    SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

TEST(NeighbourProof, FindsTheLineInWhichASmoothSheetComesBackThroughTheFloor) {
  const auto found = self_intersect(floor_and_sheet({{4, 0, 0}, {9, 0, 0}, {7, 0, 6}, {2, 0, -3}}),
                                    SelfScope::AllFaces);
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_EQ(found.pairs[0].found.curves.size(), 1u);
  EXPECT_NEAR(found.pairs[0].found.curves[0].length, 2, 1e-6);
}

TEST(NeighbourProof, FindsALineThatIsNearTheEdge) {
  const auto found = self_intersect(
      floor_and_sheet({{4, 0, 0}, {4.0003, 0, 1e-4}, {3.9997, 0, 3e-4}, {3.9998, 0, -3e-4}}),
      SelfScope::AllFaces);
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_EQ(found.pairs[0].found.curves.size(), 1u);
  EXPECT_NEAR(found.pairs[0].found.curves[0].length, 2, 1e-6);
}

TopoDS_Edge line_edge(const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
  return BRepBuilderAPI_MakeEdge(from, to).Edge();
}

// An edge of a surface along a straight line of its parameters.
TopoDS_Edge chart_edge(const Handle(Geom_Surface) & surface, const TopoDS_Vertex& at_from,
                       const TopoDS_Vertex& at_to, const gp_Pnt2d& from, const gp_Pnt2d& to) {
  const Handle(Geom2d_Line) line = new Geom2d_Line(from, gp_Dir2d(gp_Vec2d(from, to)));
  TopoDS_Edge edge =
      BRepBuilderAPI_MakeEdge(line, surface, at_from, at_to, 0, from.Distance(to)).Edge();
  BRepLib::BuildCurve3d(edge);
  return edge;
}

// The floor and a sheet that goes on smoothly, whose parameter along the common edge runs a
// thousand times faster behind a knot. The edge's curve in the chart does, too, so that it is
// exact; its curve in space is a plain line.
std::vector<TopoDS_Face> floor_and_uneven_sheet() {
  constexpr double kKnot = 1.013, kFast = 1000;
  const double last = kKnot + kFast * (2 - kKnot);
  TColgp_Array2OfPnt poles(1, 3, 1, 4);
  TColStd_Array1OfReal u(1, 3), v(1, 2);
  TColStd_Array1OfInteger of_u(1, 3), of_v(1, 2);
  const std::vector<double> y{0, kKnot, 2};
  for (int i = 1; i <= 3; ++i) {
    const double at = y[static_cast<std::size_t>(i - 1)];
    poles(i, 1) = gp_Pnt(4, at, 0);
    poles(i, 2) = gp_Pnt(7, at, 0);
    poles(i, 3) = gp_Pnt(7, at, 4);
    poles(i, 4) = gp_Pnt(2, at, 3);
    of_u(i) = i == 2 ? 1 : 2;
  }
  u(1) = 0, u(2) = kKnot, u(3) = last;
  v(1) = 0, v(2) = 1;
  of_v.Init(4);
  const Handle(Geom_BSplineSurface) surface =
      new Geom_BSplineSurface(poles, u, v, of_u, of_v, 1, 3);
  const auto vertex = [](double x, double at, double z) {
    return BRepBuilderAPI_MakeVertex(gp_Pnt(x, at, z)).Vertex();
  };
  const TopoDS_Vertex p = vertex(4, 0, 0), q = vertex(4, 2, 0);
  const TopoDS_Vertex left_p = vertex(0, 0, 0), left_q = vertex(0, 2, 0);
  const TopoDS_Vertex top_p = vertex(2, 0, 3), top_q = vertex(2, 2, 3);
  const TopoDS_Edge common = line_edge(p, q);
  BRepBuilderAPI_MakeWire outline(line_edge(left_p, p), common, line_edge(q, left_q),
                                  line_edge(left_q, left_p));
  const TopoDS_Face floor = BRepBuilderAPI_MakeFace(gp_Pln(), outline.Wire()).Face();

  TColgp_Array1OfPnt2d chart(1, 3);
  chart(1) = gp_Pnt2d(0, 0), chart(2) = gp_Pnt2d(kKnot, 0), chart(3) = gp_Pnt2d(last, 0);
  TColStd_Array1OfReal of_edge(1, 3);
  of_edge(1) = 0, of_edge(2) = kKnot, of_edge(3) = 2;
  const BRep_Builder builder;
  builder.UpdateEdge(common, new Geom2d_BSplineCurve(chart, of_edge, of_u, 1), surface,
                     TopLoc_Location(), 1e-7);
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, common.Oriented(TopAbs_FORWARD));
  builder.Add(wire, chart_edge(surface, q, top_q, {last, 0}, {last, 1}));
  builder.Add(wire, chart_edge(surface, top_q, top_p, {last, 1}, {0, 1}));
  builder.Add(wire, chart_edge(surface, top_p, p, {0, 1}, {0, 0}));
  TopoDS_Face sheet;
  builder.MakeFace(sheet, surface, 1e-7);
  builder.Add(sheet, wire);
  return {floor, sheet};
}

TEST(NeighbourProof, KnowsAnEdgeByItsOwnCurvesInTheCharts) {
  const auto found = self_intersect(floor_and_uneven_sheet(), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

// A plate between a line and a circle that leave its tip nearly in one direction.
TEST(NeighbourProof, LeavesNothingBesideEdgesThatMeetAtASmallAngle) {
  constexpr double kBend = 10, kAngle = 1e-3, kEnd = 6;
  const gp_Pnt centre(-kBend * std::sin(kAngle), kBend * std::cos(kAngle), 0);
  const gp_Circ circle(gp_Ax2(centre, gp_Dir(0, 0, 1)), kBend);
  const double up = centre.Y() - std::sqrt(kBend * kBend - std::pow(kEnd - centre.X(), 2));
  const gp_Pnt tip(0, 0, 0), end(kEnd, 0, 0), top(kEnd, up, 0);
  BRepBuilderAPI_MakeWire outline(BRepBuilderAPI_MakeEdge(tip, end).Edge(),
                                  BRepBuilderAPI_MakeEdge(end, top).Edge(),
                                  BRepBuilderAPI_MakeEdge(circle, tip, top).Edge());
  const TopoDS_Face plate = BRepBuilderAPI_MakeFace(outline.Wire(), true).Face();
  const auto found = self_intersect(faces_of(BRepPrimAPI_MakePrism(plate, gp_Vec(0, 0, 3)).Shape()),
                                    SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

// A sheet goes up from one side of a slit in the floor and comes down through the other one.
TEST(NeighbourProof, FindsTheLineBeyondASlitBesideTheEdge) {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = gp_Pnt(4, 0, 0), poles(2) = gp_Pnt(4, 0, 0.5);
  poles(3) = gp_Pnt(4.5, 0, 0.5), poles(4) = gp_Pnt(4.5, 0, -0.5);
  const TopoDS_Vertex corner = BRepBuilderAPI_MakeVertex(poles(1)).Vertex();
  const TopoDS_Vertex end = BRepBuilderAPI_MakeVertex(poles(4)).Vertex();
  BRepPrimAPI_MakePrism sheet(
      BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles), corner, end).Edge(), gp_Vec(0, 1.5, 0));
  const TopoDS_Edge side = TopoDS::Edge(sheet.Generated(corner).First());
  const auto line = [](double x0, double y0, double x1, double y1) {
    return BRepBuilderAPI_MakeEdge(gp_Pnt(x0, y0, 0), gp_Pnt(x1, y1, 0)).Edge();
  };
  BRepBuilderAPI_MakeWire outline(side);
  const std::vector<std::pair<double, double>> rest{{4, 1.5}, {4.01, 1.5}, {4.01, 0}, {8, 0},
                                                    {8, 2},   {0, 2},      {0, 0},    {4, 0}};
  for (std::size_t k = 0; k + 1 < rest.size(); ++k)
    outline.Add(line(rest[k].first, rest[k].second, rest[k + 1].first, rest[k + 1].second));
  std::vector<TopoDS_Face> faces = faces_of(sheet.Shape());
  faces.push_back(BRepBuilderAPI_MakeFace(gp_Pln(), outline.Wire()).Face());
  const auto found = self_intersect(faces, SelfScope::AllFaces);
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_EQ(found.pairs[0].found.curves.size(), 1u);
  EXPECT_NEAR(found.pairs[0].found.curves[0].length, 1.5, 1e-6);
}

// Its planes touch the balls at its corners, and have a vertex in common with them.
TEST(NeighbourProof, LeavesNothingOfALargeRoundedBlock) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(3000, 2000, 1000).Shape();
  BRepFilletAPI_MakeFillet fillet(block);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(block, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) fillet.Add(25, TopoDS::Edge(edges(i)));
  const auto found = self_intersect(faces_of(fillet.Shape()), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

TopoDS_Shape prism(const TopoDS_Wire& profile, const gp_Vec& along) {
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(profile).Face(), along).Shape();
}

// Both leave the edge in one direction: the angle between them is 0.
TEST(NeighbourProof, LeavesNothingOfAPlaneAndACylinderThatMeetInACusp) {
  const gp_Circ circle(gp_Ax2(gp_Pnt(-7.75, 0, 0.35), gp_Dir(0, -1, 0), gp_Dir(0, 0, -1)), 0.35);
  const gp_Pnt tip(-7.75, 0, 0), top(-7.4, 0, 0.35), corner(-7.4, 0, 0);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(corner, tip).Edge(),
                               BRepBuilderAPI_MakeEdge(circle, tip, top).Edge(),
                               BRepBuilderAPI_MakeEdge(top, corner).Edge());
  const auto found =
      self_intersect(faces_of(prism(wire.Wire(), gp_Vec(0, 2.2, 0))), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

// The plane's border turns by a right angle where the rounding ends, and goes on along it: a line
// and an arc that are tangent at the vertex.
TEST(NeighbourProof, LeavesNothingWhereAPlaneGoesOnBesideTheEndOfARounding) {
  const TopoDS_Shape short_block = BRepPrimAPI_MakeBox(1, 2, 1).Shape();
  BRepFilletAPI_MakeFillet fillet(short_block);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(short_block, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    gp_Pnt p, q;
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    p = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
    q = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if (p.Y() > 1 && q.Y() > 1 && p.Z() > 0.5 && q.Z() > 0.5) fillet.Add(0.5, edge);
  }
  BRepAlgoAPI_Fuse fuse(fillet.Shape(), BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), 2, 3, 1).Shape());
  fuse.SimplifyResult();
  const auto found = self_intersect(faces_of(fuse.Shape()), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

// A cylinder ends where a plane begins that is tangent to it: they share a vertex alone, and what
// ends there, an arc and a line, is tangent, too.
TEST(NeighbourProof, LeavesNothingWhereACylinderEndsOnATangentPlane) {
  const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 1), gp_Dir(0, 1, 0), gp_Dir(0, 0, -1)), 1);
  const gp_Pnt low(0, 0, 0), side(1, 0, 1), end(2, 0, 1), foot(2, 0, -1), corner(0, 0, -1);
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(circle, side, low).Edge();
  BRepBuilderAPI_MakeWire wire(
      BRepBuilderAPI_MakeEdge(low, corner).Edge(), BRepBuilderAPI_MakeEdge(corner, foot).Edge(),
      BRepBuilderAPI_MakeEdge(foot, end).Edge(), BRepBuilderAPI_MakeEdge(end, side).Edge());
  wire.Add(arc);
  BRepAlgoAPI_Fuse fuse(prism(wire.Wire(), gp_Vec(0, -2, 0)),
                        BRepPrimAPI_MakeBox(gp_Pnt(-1, 0, -1), gp_Pnt(3, 2, 0)).Shape());
  ASSERT_TRUE(fuse.IsDone());
  const auto found = self_intersect(faces_of(fuse.Shape()), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

// A rounded puck with an arm as high: the plane on top turns back round the end of the rounding,
// whose end leaves its corner beside an edge of the plane, and tangent to it.
TEST(NeighbourProof, LeavesNothingWhereARoundingEndsInACornerOfThePlane) {
  const TopoDS_Shape puck = BRepPrimAPI_MakeCylinder(2, 1).Shape();
  BRepFilletAPI_MakeFillet fillet(puck);
  for (TopExp_Explorer it(puck, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Pnt(TopExp::FirstVertex(edge)).Z() > 0.5 &&
        BRep_Tool::Pnt(TopExp::LastVertex(edge)).Z() > 0.5)
      fillet.Add(0.3, edge);
  }
  BRepAlgoAPI_Fuse fuse(fillet.Shape(),
                        BRepPrimAPI_MakeBox(gp_Pnt(-4, -0.8, 0), gp_Pnt(0, 0.8, 1)).Shape());
  ASSERT_TRUE(fuse.IsDone());
  ShapeUpgrade_UnifySameDomain unify(fuse.Shape());
  unify.Build();
  ASSERT_EQ(faces_of(unify.Shape()).size(), 7u);
  const auto found = self_intersect(faces_of(unify.Shape()), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

// Cones round one axis, whose common rim is a border of both that a search finds a line on.
TEST(NeighbourProof, LeavesNothingOfConesThatMeetInTheirRims) {
  BRepBuilderAPI_MakePolygon profile;
  for (const auto& [radius, height] : {std::pair{3.762697209595, 0.0},
                                       {9.389540377386, 0.0},
                                       {6.202837476318, 5.0},
                                       {3.463328950862, 7.828495702876},
                                       {2.963282202763, 9.0}})
    profile.Add(gp_Pnt(radius, 0, height));
  profile.Close();
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(profile.Wire()).Face();
  const TopoDS_Shape ring = BRepPrimAPI_MakeRevol(face, gp::OZ(), 0.5 * std::numbers::pi).Shape();
  const auto found = self_intersect(faces_of(ring), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

// Two rods side by side in one body, nearer than the tolerance: neither shares anything with the
// other, and a gap that is there is no answer to a user who asked for the tolerance.
TEST(NeighbourProof, FindsTheLineAlongWhichRodsAreNearerThanTheTolerance) {
  std::vector<TopoDS_Face> faces =
      faces_of(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-1, 0, 0), gp_Dir(0, 0, 1)), 1, 3).Shape());
  const auto right = faces_of(
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1 + 2e-9, 0, 0), gp_Dir(0, 0, 1)), 1, 3).Shape());
  faces.insert(faces.end(), right.begin(), right.end());
  const auto found = self_intersect(faces, SelfScope::AllFaces);
  double length = 0;
  for (const auto& pair : found.pairs)
    for (const IntersectionCurve& curve : pair.found.curves) length += curve.length;
  EXPECT_NEAR(length, 3, 1e-6);
}

// The cusp between a line and a curve that is tangent to it and bends back through it farther on.
TEST(NeighbourProof, FindsTheLineInWhichACuspOpensThroughThePlane) {
  const Handle(Geom_BezierCurve) curve = [] {
    TColgp_Array1OfPnt poles(1, 4);
    poles(1) = gp_Pnt(0, 0, 0);
    poles(2) = gp_Pnt(1, 0, 0);
    poles(3) = gp_Pnt(2, 0, 0.5);
    poles(4) = gp_Pnt(3, 0, -0.5);
    return new Geom_BezierCurve(poles);
  }();
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(gp_Pnt(4, 0, 0), gp_Pnt(0, 0, 0)).Edge(),
                               BRepBuilderAPI_MakeEdge(curve).Edge());
  const auto found = self_intersect(
      faces_of(BRepPrimAPI_MakePrism(wire.Wire(), gp_Vec(0, 2, 0)).Shape()), SelfScope::AllFaces);
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_EQ(found.pairs[0].found.curves.size(), 1u);
  EXPECT_NEAR(found.pairs[0].found.curves[0].length, 2, 1e-6);
}

// As at the tip of a drilled hole, a pole of both faces. Without a plane through it the halves take
// some 19,000 pairs of cells.
TEST(NeighbourProof, TakesFewPairsOfCellsAtTheTipOfHalfCones) {
  const gp_Pnt tip(0, 0, 0), rim(7, 0, 4);
  const TopoDS_Edge ruling = BRepBuilderAPI_MakeEdge(tip, rim).Edge();
  const gp_Ax1 axis(tip, gp_Dir(0, 0, 1));
  gp_Trsf turn;
  turn.SetRotation(axis, std::numbers::pi);
  const TopoDS_Shape half = BRepPrimAPI_MakeRevol(ruling, axis, std::numbers::pi).Shape();
  BRepBuilderAPI_Sewing sewing(1e-7);
  sewing.Add(half);
  sewing.Add(half.Moved(turn));
  sewing.Perform();
  const auto found = self_intersect(faces_of(sewing.SewedShape()), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_LT(found.certificate.excluded, 4000);
}

// The name of a failing solid has its seed.
TEST(NeighbourProof, LeavesNothingOfOrdinarySolids) {
  const int solids = std::getenv("BLOSSOM_TRIALS") != nullptr ? 120 : 10;
  for (int seed = 0; seed < solids; ++seed) {
    const testing::OrdinarySolid solid = testing::ordinary_solid(seed);
    if (solid.shape.IsNull()) continue;
    SCOPED_TRACE(std::to_string(seed) + ", " + solid.what);
    const auto found = self_intersect(faces_of(solid.shape), SelfScope::AllFaces);
    EXPECT_EQ(found.status, Status::Complete);
    EXPECT_TRUE(found.pairs.empty());
  }
}

TEST(NeighbourProof, FindsABarThatIsPushedThroughAnOrdinarySolid) {
  for (int seed = 0; seed < 4; ++seed) {
    const testing::OrdinarySolid solid = testing::ordinary_solid(seed);
    if (solid.shape.IsNull()) continue;
    SCOPED_TRACE(std::to_string(seed) + ", " + solid.what);
    Bnd_Box box;
    BRepBndLib::Add(solid.shape, box);
    const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
    const gp_Pnt start(0.6 * low.X() + 0.4 * high.X(), low.Y() - 1, 0.5 * (low.Z() + high.Z()));
    std::vector<TopoDS_Face> faces = faces_of(solid.shape);
    const double length = high.Y() - low.Y() + 2;
    for (const TopoDS_Face& face :
         faces_of(BRepPrimAPI_MakeCylinder(gp_Ax2(start, gp_Dir(0, 1, 0)), 0.1, length).Shape()))
      faces.push_back(face);
    const auto found = self_intersect(faces, SelfScope::AllFaces);
    std::size_t curves = 0;
    for (const FaceIntersection& pair : found.pairs) curves += pair.found.curves.size();
    EXPECT_GE(curves, 2u);
  }
}

}  // namespace
}  // namespace blossom::occt
