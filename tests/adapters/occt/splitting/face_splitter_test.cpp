// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/face_splitter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "tests/adapters/occt/trim_cases.h"

namespace blossom::occt {
namespace {

using namespace testing;

constexpr double kPi = std::numbers::pi;

TopoDS_Face square() { return BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4); }

TopoDS_Face square_with_hole() {
  const gp_Circ circle(gp_Ax2(gp_Pnt(2, 2, 0), gp_Dir(0, 0, -1)), 1);
  BRepBuilderAPI_MakeFace maker(square());
  maker.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)));
  return maker.Face();
}

TopoDS_Face cylinder() {
  return BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 2), 0, 2 * kPi, 0, 3, 1e-7);
}

TopoDS_Face sphere() {
  return BRepBuilderAPI_MakeFace(new Geom_SphericalSurface(gp_Ax3(), 2), 1e-7);
}

TopoDS_Face torus() {
  return BRepBuilderAPI_MakeFace(new Geom_ToroidalSurface(gp_Ax3(), 3, 1), 1e-7);
}

double smallest_area(const FaceSplit& split) {
  double least = 1e300;
  for (const FacePiece& piece : split.pieces) least = std::min(least, area(piece.face));
  return least;
}

TEST(FaceSplitter, StraightCutMakesTwoRectangles) {
  const TopoDS_Face face = square();
  const FaceSplit split = split_face(face, {line_cut(face, {1, 0}, {1, 4})});
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), 4, 1e-9);
}

TEST(FaceSplitter, ReversedFaceGivesReversedPieces) {
  const TopoDS_Face face = TopoDS::Face(square().Reversed());
  expect_sound(face, split_face(face, {line_cut(face, {1, 0}, {2, 4})}), 2);
}

TEST(FaceSplitter, CutThatOvershootsIsClipped) {
  const TopoDS_Face face = square();
  const FaceSplit split = split_face(face, {line_cut(face, {1, -3}, {1, 9})});
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), 4, 1e-9);
}

TEST(FaceSplitter, CutShortByLessThanTheToleranceStillDivides) {
  const TopoDS_Face face = square();
  expect_sound(face, split_face(face, {line_cut(face, {1, 6e-8}, {1, 4 - 6e-8})}), 2);
}

// The edge is off by up to its tolerance, and the cut by its own.
TEST(FaceSplitter, CutShortByLessThanBothTolerancesStillDivides) {
  const TopoDS_Face face = square();
  expect_sound(face, split_face(face, {line_cut(face, {1, 1.6e-7}, {1, 4 - 1.6e-7})}), 2);
  EXPECT_EQ(split_face(face, {line_cut(face, {1, 2.4e-7}, {1, 4 - 2.4e-7})}).pieces.size(), 1u);
}

TEST(FaceSplitter, CutThatEndsInsideIsLeftOutWithANote) {
  const TopoDS_Face face = square();
  const FaceSplit split = split_face(face, {line_cut(face, {1, 0}, {1, 3.9})});
  ASSERT_EQ(split.pieces.size(), 1u);
  EXPECT_TRUE(split.pieces[0].face.IsSame(face) || split.notes.size() == 1u);
  ASSERT_EQ(split.notes.size(), 1u);
  EXPECT_NE(split.notes[0].find("cut 1 ends inside"), std::string::npos);
}

std::vector<TopoDS_Edge> internal_edges(const TopoDS_Face& face) {
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (it.Current().Orientation() == TopAbs_INTERNAL) edges.push_back(TopoDS::Edge(it.Current()));
  return edges;
}

double length(const TopoDS_Edge& edge) {
  return GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge));
}

FaceSplit imprinted(const TopoDS_Face& face, const std::vector<FaceCut>& cuts) {
  return split_face(face, cuts, 1e-7, OpenCuts::Imprint);
}

TEST(FaceSplitter, CutThatEndsInsideIsImprintedOnRequest) {
  const TopoDS_Face face = square();
  const FaceSplit split = imprinted(face, {line_cut(face, {1, 0}, {1, 3})});
  expect_sound(face, split, 1);
  const std::vector<TopoDS_Edge> edges = internal_edges(split.pieces[0].face);
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_NEAR(length(edges[0]), 3, 1e-12);
  EXPECT_EQ(split.pieces[0].imprints.size(), 1u);
  // Its one end splits the side of the square, the other one is its own.
  EXPECT_EQ(edge_uses(split.pieces).size(), 6u);
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(split.pieces[0].face, TopAbs_VERTEX, vertices);
  EXPECT_EQ(vertices.Extent(), 6);
  EXPECT_NE(split.notes.at(0).find("imprinted"), std::string::npos);
}

TEST(FaceSplitter, ImprintsLieInThePieceRoundThem) {
  const TopoDS_Face face = TopoDS::Face(square_with_hole().Reversed());
  const FaceSplit split =
      imprinted(face, {line_cut(face, {0.5, 0}, {0.5, 4}), line_cut(face, {0.2, 1}, {0.3, 2}),
                       line_cut(face, {3.5, 2}, {2.5, 2}), line_cut(face, {3.2, 1}, {3.2, 3})});
  expect_sound(face, split, 2);
  for (const FacePiece& piece : split.pieces) {
    const bool small = area(piece.face) < 4;
    // The third cut ends in the rim of the hole, crosses the fourth one and goes on beyond it.
    EXPECT_EQ(internal_edges(piece.face).size(), small ? 1u : 4u);
  }
}

// Internal edges from an earlier cut, from (2, 0) to (2, 2).
TopoDS_Face square_with_internal_edge() {
  const TopoDS_Face face = square();
  return imprinted(face, {line_cut(face, {2, 0}, {2, 2})}).pieces[0].face;
}

TEST(FaceSplitter, InternalEdgeStaysInItsPiece) {
  const TopoDS_Face face = square_with_internal_edge();
  const FaceSplit split = split_face(face, {line_cut(face, {3, 0}, {3, 4})});
  expect_sound(face, split, 2);
  for (const FacePiece& piece : split.pieces)
    EXPECT_EQ(internal_edges(piece.face).size(), area(piece.face) > 8 ? 1u : 0u);
  EXPECT_TRUE(split.notes.empty());
}

TEST(FaceSplitter, InternalEdgeThatIsCutDividesOnOneSideAndStaysOnTheOther) {
  const TopoDS_Face face = square_with_internal_edge();
  const FaceSplit split = split_face(face, {line_cut(face, {0, 1}, {4, 1})});
  expect_sound(face, split, 3);
  for (const FacePiece& piece : split.pieces) {
    const std::vector<TopoDS_Edge> edges = internal_edges(piece.face);
    ASSERT_EQ(edges.size(), area(piece.face) > 8 ? 1u : 0u);
    for (const TopoDS_Edge& edge : edges) EXPECT_NEAR(length(edge), 1, 1e-12);
  }
}

TEST(FaceSplitter, InternalEdgeDividesTogetherWithACut) {
  const TopoDS_Face face = square_with_internal_edge();
  const FaceSplit split = split_face(face, {line_cut(face, {2, 2}, {4, 2})});
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), 4, 1e-12);
  for (const FacePiece& piece : split.pieces) EXPECT_TRUE(internal_edges(piece.face).empty());
}

TEST(FaceSplitter, FaceThatNothingDividesKeepsItsInternalEdge) {
  const TopoDS_Face face = square_with_internal_edge();
  const FaceSplit split = imprinted(face, {line_cut(face, {1, 4}, {1, 3})});
  expect_sound(face, split, 1);
  EXPECT_EQ(internal_edges(split.pieces[0].face).size(), 2u);
}

TEST(FaceSplitter, CutFromRimToHoleIsImprintedAsABridge) {
  const TopoDS_Face face = square_with_hole();
  const FaceSplit split = imprinted(face, {line_cut(face, {0, 2}, {2, 2})});
  expect_sound(face, split, 1);
  ASSERT_EQ(split.pieces[0].imprints.size(), 1u);
  EXPECT_NEAR(length(split.pieces[0].imprints[0]), 1, 1e-9);
}

TEST(FaceSplitter, CutThatStopsJustShortOfACornerStopsAtItsVertex) {
  const TopoDS_Face face = square();
  EdgeSplits splits(1e-7);
  FaceSplitter splitter(face, {line_cut(face, {2e-7, 2e-7}, {3, 3})}, splits, 1e-7);
  splitter.settle();
  const std::vector<CutStop> stops = splitter.stops(0);
  ASSERT_EQ(stops.size(), 2u);
  ASSERT_FALSE(stops[0].vertex.IsNull());
  EXPECT_LE(BRep_Tool::Pnt(stops[0].vertex).Distance(gp_Pnt(0, 0, 0)), 1e-12);
  EXPECT_TRUE(stops[1].vertex.IsNull());
}

TEST(FaceSplitter, EndsItsSearchesWhenTheLimitIsReached) {
  const TopoDS_Face face = square();
  bool over = false;
  const IntersectionOptions options{.cancelled = [&] { return over; }};
  const WorkLimit limit(options);
  EdgeSplits splits(1e-7);
  const std::vector<FaceCut> cuts{line_cut(face, {1, 0}, {1, 2}), line_cut(face, {0, 1}, {2, 1})};
  FaceSplitter splitter(face, cuts, splits, 1e-7, &limit);
  over = true;
  EXPECT_THROW(splitter.settle(), Failure);
  EXPECT_THROW(FaceSplitter(face, cuts, splits, 1e-7, &limit), Failure);
}

// Two cuts that end at one loose vertex of the other side, and reach a little beyond each other.
TEST(FaceSplitter, CutsThatMeetOneVertexOfTheOtherSideEndInOneNode) {
  constexpr double kBeyond = 5e-6;
  const TopoDS_Face face = square();
  EdgeSplits splits(1e-7);
  FaceSplitter splitter(
      face, {line_cut(face, {1, 0}, {1, 2 + kBeyond}), line_cut(face, {1 - kBeyond, 2}, {4, 2})},
      splits, 1e-7);
  splitter.settle();
  const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(1, 2, 0));
  BRep_Builder().UpdateVertex(vertex, 2 * kBeyond);
  splitter.meet(0, {1, vertex});
  splitter.meet(1, {0, vertex});
  splitter.tidy();
  EXPECT_EQ(splitter.stops(0).size(), 2u);
  EXPECT_EQ(splitter.stops(1).size(), 2u);
  EXPECT_EQ(splitter.stops(0)[1].parameter, 1);  // where the other side has its border
  const FaceSplit split = splitter.split();
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), 6, 4 * kBeyond);
  EXPECT_TRUE(split.notes.empty());
}

TEST(FaceSplitter, CutOutsideLeavesTheFaceItself) {
  const TopoDS_Face face = square();
  const FaceSplit split = split_face(face, {line_cut(face, {9, 0}, {9, 4})});
  ASSERT_EQ(split.pieces.size(), 1u);
  EXPECT_TRUE(split.pieces[0].face.IsSame(face));
  EXPECT_EQ(split.notes.size(), 1u);
}

TEST(FaceSplitter, DiagonalFromVertexToVertexMakesTwoTriangles) {
  const TopoDS_Face face = square();
  const FaceSplit split = split_face(face, {line_cut(face, {0, 0}, {4, 4})});
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), 8, 1e-9);
  for (const auto& [edge, count] : edge_uses(split.pieces)) EXPECT_LE(count, 2);
  EXPECT_EQ(edge_uses(split.pieces).size(), 5u);  // no old edge was split
}

TEST(FaceSplitter, ClosedCutMakesADiscAndAHole) {
  const TopoDS_Face face = square();
  const FaceSplit split = split_face(face, {loop_cut(face, {2, 2}, 1)});
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), kPi, 2e-3);
}

TEST(FaceSplitter, CutAcrossAHoleEndsAtItsRim) {
  const TopoDS_Face face = square_with_hole();
  const FaceSplit split = split_face(face, {line_cut(face, {2, 0}, {2, 4})});
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), 8 - kPi / 2, 1e-9);
}

TEST(FaceSplitter, CutBesideAHoleLeavesTheHoleWithItsPiece) {
  const TopoDS_Face face = square_with_hole();
  const FaceSplit split = split_face(face, {line_cut(face, {0.5, 0}, {0.5, 4})});
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), 2, 1e-9);
}

TEST(FaceSplitter, TwoCrossingCutsMakeFourPieces) {
  const TopoDS_Face face = square();
  const FaceSplit split =
      split_face(face, {line_cut(face, {1, 0}, {1, 4}), line_cut(face, {0, 3}, {4, 3})});
  expect_sound(face, split, 4);
  EXPECT_NEAR(smallest_area(split), 1, 1e-9);
}

TEST(FaceSplitter, CutsThatMeetInOnePointInsideDivideTogether) {
  const TopoDS_Face face = square();
  const FaceSplit split =
      split_face(face, {line_cut(face, {1, 0}, {2, 2}), line_cut(face, {2, 2}, {0, 3}),
                        line_cut(face, {4, 2}, {2, 2})});
  expect_sound(face, split, 3);
}

// A circle in another one that it touches, and crosses twice beside that by what they are off.
TEST(FaceSplitter, CutsThatTouchMeetInOneVertexThatCoversTheirCrossings) {
  constexpr double kOff = 2e-9;
  const double reach = std::sqrt(2 * kOff);
  const TopoDS_Face face = square();
  const FaceSplit split =
      split_face(face, {loop_cut(face, {2, 2}, 1), loop_cut(face, {2, 2.5 + kOff}, 0.5)});
  expect_sound(face, split, 3);
  double widest = 0;
  for (const FacePiece& piece : split.pieces)
    for (TopExp_Explorer it(piece.face, TopAbs_VERTEX); it.More(); it.Next())
      widest = std::max(widest, BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())));
  EXPECT_GE(widest, 0.9 * reach);
  EXPECT_LE(widest, 2 * reach);
}

TEST(FaceSplitter, RepeatedCutDividesOnce) {
  const TopoDS_Face face = square();
  const FaceSplit split =
      split_face(face, {line_cut(face, {1, 0}, {1, 4}), line_cut(face, {1, 4}, {1, 0})});
  expect_sound(face, split, 2);
  ASSERT_EQ(split.notes.size(), 1u);
}

TEST(FaceSplitter, CutAlongAnEdgeDividesNothingButIsReported) {
  const TopoDS_Face face = square();
  const FaceSplit split = split_face(face, {line_cut(face, {0, 0}, {4, 0})});
  ASSERT_EQ(split.pieces.size(), 1u);
  EXPECT_TRUE(split.pieces[0].face.IsSame(face));
  ASSERT_EQ(split.pieces[0].cuts.size(), 1u);
  EXPECT_EQ(split.pieces[0].cuts[0].cut, 0);
  EXPECT_LT(split.pieces[0].cuts[0].at.from, split.pieces[0].cuts[0].at.to);
}

TEST(FaceSplitter, CircleRoundACylinderMakesTwoBands) {
  const TopoDS_Face face = cylinder();
  const FaceSplit split = split_face(face, {line_cut(face, {0, 1}, {2 * kPi, 1})});
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), 4 * kPi, 1e-8);
}

TEST(FaceSplitter, LinesAlongACylinderKeepItsSeam) {
  const TopoDS_Face face = cylinder();
  const FaceSplit split =
      split_face(face, {line_cut(face, {1, 0}, {1, 3}), line_cut(face, {4, 3}, {4, 0})});
  expect_sound(face, split, 3);
  EXPECT_NEAR(smallest_area(split), 2 * 3 * 1, 1e-8);
}

TEST(FaceSplitter, CutAwayFromTheChartByAPeriodIsBroughtBack) {
  const TopoDS_Face face = cylinder();
  const FaceSplit split = split_face(face, {loop_cut(face, {2 * kPi + 3, 1.5}, 0.5)});
  expect_sound(face, split, 2);
}

TEST(FaceSplitter, CutAcrossTheSeamIsCutThere) {
  const TopoDS_Face face = cylinder();
  const FaceSplit split = split_face(face, {loop_cut(face, {2 * kPi, 1.5}, 0.5)});
  expect_sound(face, split, 3);  // two half discs, joined by the seam, and the rest
}

TEST(FaceSplitter, CutAlongTheSeamOfACylinderDividesWithAnotherOne) {
  const TopoDS_Face face = cylinder();
  const FaceSplit split =
      split_face(face, {line_cut(face, {0, 0}, {0, 3}), line_cut(face, {kPi, 0}, {kPi, 3})});
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), 6 * kPi, 1e-8);
}

TEST(FaceSplitter, EquatorMakesTwoHemispheres) {
  const TopoDS_Face face = sphere();
  const FaceSplit split = split_face(face, {line_cut(face, {0, 0}, {2 * kPi, 0})});
  expect_sound(face, split, 2);
  EXPECT_NEAR(smallest_area(split), 8 * kPi, 1e-8);
}

TEST(FaceSplitter, MeridiansEndInThePolesOfASphere) {
  const TopoDS_Face face = sphere();
  const FaceSplit split =
      split_face(face, {line_cut(face, {1, -kPi / 2}, {1, kPi / 2}),
                        line_cut(face, {1 + kPi, kPi / 2}, {1 + kPi, -kPi / 2})});
  expect_sound(face, split, 3);
  EXPECT_NEAR(smallest_area(split), 8, 1e-8);  // the lune of one radian
}

TEST(FaceSplitter, CirclesRoundATorusMakeTubes) {
  const TopoDS_Face face = torus();
  expect_sound(face, split_face(face, {line_cut(face, {2, 0}, {2, 2 * kPi})}), 2);
  expect_sound(face, split_face(face, {line_cut(face, {0, 2}, {2 * kPi, 2})}), 2);
}

TEST(FaceSplitter, ObliqueCutOfATorusCrossesBothSeams) {
  const TopoDS_Face face = torus();
  expect_sound(face, split_face(face, {line_cut(face, {5, 5}, {8, 8})}), 1);
  expect_sound(face, split_face(face, {loop_cut(face, {2 * kPi, 2 * kPi}, 1)}), 5);
}

TEST(FaceSplitter, RefusesAFaceWithoutWires) {
  TopoDS_Face bare;
  BRep_Builder().MakeFace(bare, new Geom_Plane(gp_Pln()), 1e-7);
  EXPECT_THROW(split_face(bare, {}), BadModel);
}

TopoDS_Wire closed_wire(const Handle(Geom_Surface) & surface,
                        const std::vector<gp_Pnt2d>& corners) {
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Handle(Geom2d_TrimmedCurve) segment =
        GCE2d_MakeSegment(corners[i], corners[(i + 1) % corners.size()]).Value();
    const Handle(Geom2d_Curve) side(segment);
    TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(side, surface);
    BRepLib::BuildCurve3d(edge);
    wire.Add(edge);
  }
  return wire.Wire();
}

// A strip goes one and a half times round the cylinder.
TEST(FaceSplitter, LaysEdgesInAFaceLongerThanAPeriod) {
  const Handle(Geom_Surface) surface = new Geom_CylindricalSurface(gp_Ax3(), 10);
  const double turn = 3 * kPi, rise = 9;
  const TopoDS_Face strip =
      BRepBuilderAPI_MakeFace(
          surface, closed_wire(surface, {{0, 0}, {turn, rise}, {turn, rise + 4}, {0, 4}}), true)
          .Face();
  for (const double part : {0.1, 0.35, 0.6, 0.75, 0.85}) {
    SCOPED_TRACE(part);
    const double u = part * turn, v = part * rise + 1;
    EdgeSplits splits(1e-7);
    FaceSplitter splitter(strip, {}, splits, 1e-7);
    splitter.settle();
    const TopoDS_Wire laid =
        closed_wire(surface, {{u, v}, {u + 0.4, v}, {u + 0.4, v + 1}, {u, v + 1}});
    for (TopExp_Explorer it(laid, TopAbs_EDGE); it.More(); it.Next())
      splitter.add_coincident(TopoDS::Edge(it.Current()), 1e-6, {});
    const FaceSplit split = splitter.split();
    EXPECT_EQ(split.pieces.size(), 2u);
    EXPECT_EQ(split.coincident.size(), 4u);
  }
}

// A flat parabola that leaves the face by 4e-9, from a corner of it to a place farther on than a
// touch is long.
TEST(FaceSplitter, CutThatKeepsToAnEdgeFromOutsideRunsAlongIt) {
  constexpr double kBend = 8e-5, kLength = 0.014;
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& corner :
       {gp_Pnt(0, 0, 0), gp_Pnt(4, 0, 0), gp_Pnt(4, 4, 0), gp_Pnt(2, 4, 0), gp_Pnt(0, 4, 0)})
    wire.Add(corner);
  wire.Close();
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire());
  // By the polar form of 4 + kBend * t * (kLength - t) with t = u - 2.
  const auto pole = [&](double s, double t) {
    return Vec2{2 + (s + t) / 2, 4 + kBend * (kLength * (s + t) / 2 - s * t)};
  };
  const Spline2 chart{2, {0, 4}, {3, 3}, {pole(-2, -2), pole(-2, 2), pole(2, 2)}};
  const FaceSplit split = split_face(face, {cut_along(face, chart)});
  EXPECT_EQ(split.pieces.size(), 3u);
  std::vector<CutUse> along;
  for (const FacePiece& piece : split.pieces)
    std::ranges::copy_if(piece.cuts, std::back_inserter(along), &CutUse::along);
  ASSERT_EQ(along.size(), 1u);
  EXPECT_NEAR(0.5 * (along.front().at.from + along.front().at.to), 2 + 0.5 * kLength, 1e-6);
}

// As of a body that touches itself: each edge has ends of its own.
TEST(FaceSplitter, TakesVerticesAtOnePlaceForOne) {
  EdgeSplits splits(1e-7);
  FaceSplitter splitter(square(), {}, splits, 1e-7);
  splitter.settle();
  const std::array<gp_Pnt, 3> corners{gp_Pnt(1, 1, 0), gp_Pnt(3, 1, 0), gp_Pnt(2, 3, 0)};
  for (std::size_t i = 0; i < corners.size(); ++i)
    splitter.add_coincident(
        BRepBuilderAPI_MakeEdge(corners[i], corners[(i + 1) % corners.size()]).Edge(), 1e-6, {});
  const FaceSplit split = splitter.split();
  EXPECT_EQ(split.pieces.size(), 2u);
  EXPECT_EQ(split.coincident.size(), 3u);
  EXPECT_NEAR(smallest_area(split), 2, 1e-12);
}

}  // namespace
}  // namespace blossom::occt
