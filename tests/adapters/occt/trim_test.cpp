// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/trim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/convert/curves.h"
#include "adapters/occt/faces/area.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<PartFace> part_of(const TopoDS_Shape& shape, const std::set<int>& selected = {}) {
  std::vector<PartFace> part;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i)
    part.push_back({i, TopoDS::Face(faces(i)), selected.empty() || selected.contains(i)});
  return part;
}

TrimTool plane_tool(const gp_Pnt& at, const gp_Dir& normal, double size = 20) {
  return trim_tool(BRepBuilderAPI_MakeFace(gp_Pln(at, normal), -size, size, -size, size).Face());
}

// The shape with the faces replaced, all faces in one compound that shares the edges.
TopoDS_Shape rebuilt(const TopoDS_Shape& shape, const TrimResult& result) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const auto replaced = result.replacements.find(i);
    if (replaced == result.replacements.end())
      builder.Add(compound, faces(i));
    else
      for (const TopoDS_Face& face : replaced->second) builder.Add(compound, face);
  }
  return compound;
}

// Edges by the number of times that faces use them; degenerated ones left out.
std::map<int, int> uses_of_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  std::map<int, int> uses, count;
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
    if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) ++uses[edges.Add(it.Current())];
  for (const auto& [edge, times] : uses) ++count[times];
  return count;
}

double sum_of_areas(const TrimResult& result) {
  double sum = 0;
  for (const TrimPiece& piece : result.pieces) sum += piece.area;
  return sum;
}

double kept_area(const TrimResult& result) {
  double sum = 0;
  for (const TrimPiece& piece : result.pieces)
    if (piece.kept) sum += piece.area;
  return sum;
}

TEST(Trim, BoxCutByAPlaneStaysSewn) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 3, 2).Shape();
  const TrimResult result = trim(part_of(box), {plane_tool({1, 1, 1}, {1, 0.2, 0.1})});

  EXPECT_EQ(result.status, Status::Complete);
  EXPECT_TRUE(result.notes.empty()) << result.notes.front();
  EXPECT_EQ(result.pieces.size(), 10u);  // two faces on the sides, four cut in two
  const TopoDS_Shape whole = rebuilt(box, result);
  EXPECT_TRUE(BRepCheck_Analyzer(whole).IsValid());
  EXPECT_EQ(uses_of_edges(whole), (std::map<int, int>{{2, 12 + 4 + 4}}));
  EXPECT_NEAR(sum_of_areas(result), 52, 52e-9);
}

TEST(Trim, NeighbourOfACutFaceTakesTheSplitEdges) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 3, 2).Shape();
  const TrimResult result = trim(part_of(box, {6}), {plane_tool({1, 0, 0}, {1, 0, 0})});

  EXPECT_EQ(result.pieces.size(), 2u);
  EXPECT_EQ(result.replacements.size(), 3u);  // the top and its neighbours across the cut's ends
  const TopoDS_Shape whole = rebuilt(box, result);
  EXPECT_TRUE(BRepCheck_Analyzer(whole).IsValid());
  EXPECT_EQ(uses_of_edges(whole), (std::map<int, int>{{2, 12 + 2 + 1}}));
}

TEST(Trim, PiecesAboveLieWhereTheToolsNormalPoints) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 3, 2).Shape();
  TrimOptions options;
  options.keep = Keep::Above;
  const TrimResult above = trim(part_of(box), {plane_tool({1, 0, 0}, {1, 0, 0})}, options);
  EXPECT_NEAR(kept_area(above), 6 + 3 * 10, 1e-8);
  options.keep = Keep::Below;
  const TrimResult below = trim(part_of(box), {plane_tool({1, 0, 0}, {1, 0, 0})}, options);
  EXPECT_NEAR(kept_area(below), 6 + 1 * 10, 1e-8);
  const TrimResult turned = trim(part_of(box), {plane_tool({1, 0, 0}, {-1, 0, 0})}, options);
  EXPECT_NEAR(kept_area(turned), 6 + 3 * 10, 1e-8);
}

TEST(Trim, SideFollowsTheOrientationOfTheToolsFace) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 3, 2).Shape();
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln({1, 0, 0}, {1, 0, 0}), -9, 9, -9, 9);
  TrimOptions options;
  options.keep = Keep::Above;
  const TrimResult result = trim(part_of(box), {trim_tool(face.Reversed())}, options);
  EXPECT_NEAR(kept_area(result), 6 + 1 * 10, 1e-8);
}

TEST(Trim, FaceThatNoToolMeetsIsSidedByThePlane) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 3, 2).Shape();
  const TrimResult result = trim(part_of(box), {plane_tool({9, 0, 0}, {1, 0, 0})});
  for (const TrimPiece& piece : result.pieces) EXPECT_EQ(piece.side, PieceSide::Below);
  EXPECT_TRUE(result.replacements.empty());
}

TEST(Trim, SphereCutsADiscOutOfAFaceOfABox) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 4, 4).Shape();
  const TrimTool ball = trim_tool(BRepPrimAPI_MakeSphere(gp_Pnt(2, 2, 3.9), 1).Shape());
  ASSERT_TRUE(ball.is_solid());
  TrimOptions options;
  options.keep = Keep::Inside;
  const TrimResult result = trim(part_of(box), {ball}, options);
  EXPECT_EQ(result.pieces.size(), 7u);
  EXPECT_NEAR(kept_area(result), 0.99 * kPi, 1e-6);
  EXPECT_NEAR(sum_of_areas(result), 96, 96e-9);
}

TEST(Trim, CylinderCutByAPlaneHasBandsOfHandComputedArea) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 4).Shape();
  TrimOptions options;
  options.keep = Keep::Below;
  const TrimResult result = trim(part_of(cylinder), {plane_tool({0, 0, 1}, {0, 1, 3})}, options);
  EXPECT_TRUE(result.notes.empty()) << result.notes.front();
  EXPECT_NEAR(kept_area(result), 2 * kPi * 1 + kPi, 1e-6);
  EXPECT_TRUE(BRepCheck_Analyzer(rebuilt(cylinder, result)).IsValid());
}

TEST(Trim, SphereCutByAPlaneIsTwoCaps) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(2).Shape();
  TrimOptions options;
  options.keep = Keep::Above;
  const TrimResult result = trim(part_of(ball), {plane_tool({0, 0, 1}, {0, 0, 1})}, options);
  EXPECT_NEAR(kept_area(result), 2 * kPi * 2 * 1, 1e-6);
}

TEST(Trim, TwoPlanesCutAFaceInFour) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4);
  const TrimResult result =
      trim(part_of(face), {plane_tool({1, 0, 0}, {1, 0, 0}), plane_tool({0, 3, 0}, {0, 1, 0})});
  ASSERT_EQ(result.pieces.size(), 4u);
  std::map<PieceSide, double> area_of;
  for (const TrimPiece& piece : result.pieces) area_of[piece.side] += piece.area;
  EXPECT_NEAR(area_of[PieceSide::Above], 3, 1e-9);
  EXPECT_NEAR(area_of[PieceSide::Below], 3, 1e-9);
  EXPECT_NEAR(area_of[PieceSide::Mixed], 10, 1e-9);
}

TEST(Trim, ToolOfSeveralFacesCutsAcrossItsEdges) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4);
  const TrimTool corner = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(1, 1, -1), 2, 2, 2).Shape());
  TrimOptions options;
  options.keep = Keep::Outside;
  const TrimResult result = trim(part_of(face), {corner}, options);
  ASSERT_EQ(result.pieces.size(), 2u);
  EXPECT_NEAR(kept_area(result), 12, 1e-8);
}

TEST(Trim, KeepsThePieceWithTheNumberAndRefusesOneThatIsNotThere) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4);
  TrimOptions options;
  options.keep = Keep::Number;
  options.piece = 2;
  const TrimResult result = trim(part_of(face), {plane_tool({1, 0, 0}, {1, 0, 0})}, options);
  ASSERT_EQ(result.pieces.size(), 2u);
  EXPECT_FALSE(result.pieces[0].kept);
  EXPECT_TRUE(result.pieces[1].kept);
  options.piece = 3;
  EXPECT_THROW(trim(part_of(face), {plane_tool({1, 0, 0}, {1, 0, 0})}, options), InvalidInput);
}

TEST(Trim, RefusesInsideOfAnOpenTool) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4);
  TrimOptions options;
  options.keep = Keep::Inside;
  EXPECT_THROW(trim(part_of(face), {plane_tool({1, 0, 0}, {1, 0, 0})}, options), InvalidInput);
}

TEST(Trim, ContactAlongACurveDividesAndItsSidesAreDecidedByPoints) {
  const TopoDS_Face wall = BRepBuilderAPI_MakeFace(
      gp_Cylinder(gp_Ax3({0, 0, 0}, {0, 0, 1}, {-1, 0, 0}), 2), 0.5, 2 * kPi - 0.5, -3, 3);
  TrimOptions options;
  options.keep = Keep::Below;
  const TrimResult result = trim(part_of(wall), {plane_tool({2, 0, 0}, {1, 0, 0})}, options);
  ASSERT_EQ(result.pieces.size(), 2u);
  EXPECT_NEAR(sum_of_areas(result), 12 * (2 * kPi - 1), 1e-9);
  for (const TrimPiece& piece : result.pieces) {
    EXPECT_TRUE(BRepCheck_Analyzer(piece.shape).IsValid());
    EXPECT_EQ(piece.side, PieceSide::Below);
    EXPECT_NEAR(piece.area, 12 * (kPi - 0.5), 1e-6);
  }
  EXPECT_TRUE(result.notes.empty()) << result.notes[0];
}

TEST(Trim, ToolThatEndsInsideTheFaceIsImprinted) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4);
  const TrimResult result = trim(part_of(face), {plane_tool({2, 2, 0}, {1, 0, 0}, 1)});
  ASSERT_EQ(result.pieces.size(), 1u);
  EXPECT_TRUE(BRepCheck_Analyzer(result.pieces[0].shape).IsValid());
  EXPECT_NEAR(result.pieces[0].area, 16, 1e-12);
  EXPECT_EQ(uses_of_edges(result.pieces[0].shape), (std::map<int, int>{{1, 5}}));
  EXPECT_EQ(result.replacements.size(), 1u);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("face 1: cut 1 ends inside"), std::string::npos);
}

TEST(Trim, ToolThatEndsInsideLeavesNoImprintWhereASideIsKept) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4);
  TrimOptions options;
  options.keep = Keep::Above;
  const TrimResult result = trim(part_of(face), {plane_tool({2, 2, 0}, {1, 0, 0}, 1)}, options);
  ASSERT_EQ(result.pieces.size(), 1u);
  EXPECT_TRUE(result.pieces[0].shape.IsSame(face));
  ASSERT_GE(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("left out"), std::string::npos);
}

std::vector<std::pair<PieceSide, double>> sides_and_areas(const TrimResult& result) {
  std::vector<std::pair<PieceSide, double>> found;
  for (const TrimPiece& piece : result.pieces) {
    EXPECT_TRUE(BRepCheck_Analyzer(piece.shape).IsValid());
    found.emplace_back(piece.side, std::round(1e6 * piece.area) / 1e6);
  }
  std::sort(found.begin(), found.end());
  return found;
}

using Sides = std::vector<std::pair<PieceSide, double>>;

TEST(Trim, ABoxThatStandsOnAFaceCutsItsFootOut) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4);
  const TrimTool tool = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 0), gp_Pnt(2, 3, 1)).Shape());
  TrimResult result = trim(part_of(face), {tool});
  EXPECT_EQ(sides_and_areas(result), (Sides{{PieceSide::Outside, 14}, {PieceSide::On, 2}}));
  EXPECT_TRUE(result.notes.empty());
  TrimOptions options;
  options.keep = Keep::Outside;
  result = trim(part_of(face), {tool}, options);
  for (const TrimPiece& piece : result.pieces)
    EXPECT_EQ(piece.kept, piece.side == PieceSide::Outside);
}

TEST(Trim, FacesInOnePlaneCutEachOtherAlongTheirBorders) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4);
  const gp_Circ circle(gp_Ax2(gp_Pnt(4, 2, 0), gp::DZ()), 1);
  const TopoDS_Face disc =
      BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)));
  const TrimResult result = trim(part_of(face), {trim_tool(disc)});
  ASSERT_EQ(result.pieces.size(), 2u);
  const double half_disc = std::round(1e6 * kPi / 2) / 1e6;
  EXPECT_NEAR(sum_of_areas(result), 16, 1e-9);
  EXPECT_EQ(sides_and_areas(result).back(), (std::pair{PieceSide::On, half_disc}));
}

TEST(Trim, FacesAreWhollyCutOrStoppedWheneverTheyAreCancelled) {
  const std::vector<PartFace> part = part_of(BRepPrimAPI_MakeBox(2, 2, 2));
  const TrimTool ball = trim_tool(BRepPrimAPI_MakeSphere(gp_Pnt(2, 2, 2), 1));
  const std::size_t pieces = trim(part, {ball}).pieces.size();
  bool whole = false;
  for (int allowed = 0; !whole && allowed < 4096; ++allowed) {
    std::atomic<int> asked = 0;
    TrimOptions options;
    options.intersection.cancelled = [&] { return asked++ >= allowed; };
    const TrimResult result = trim(part, {ball}, options);
    whole = result.status != Status::Stopped;
    EXPECT_TRUE(!whole || result.pieces.size() == pieces) << allowed;
  }
  EXPECT_TRUE(whole);
}

TEST(Trim, CylindersInEachOtherCutBands) {
  const TopoDS_Shape part = BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, 0}, gp::DZ()), 1, 3).Shape();
  const gp_Ax2 turned(gp_Pnt(0, 0, 1), gp::DZ(), gp_Dir(1, 1, 0));
  const TopoDS_Shape tool = BRepPrimAPI_MakeCylinder(turned, 1, 1).Shape();
  const TrimResult result = trim(part_of(part, {1}), {trim_tool(tool)});
  ASSERT_EQ(result.pieces.size(), 3u);
  int on = 0;
  for (const TrimPiece& piece : result.pieces) {
    EXPECT_NEAR(piece.area, 2 * kPi, 1e-6);
    on += piece.side == PieceSide::On ? 1 : 0;
  }
  EXPECT_EQ(on, 1);
}

// A sheet that ends before it parts nothing of what reaches past it on both sides.
TEST(Trim, FaceThatPassesBesideASheetIsOnNoSideOfIt) {
  const TrimTool sheet = plane_tool(gp_Pnt(0, 0, 5), gp::DZ(), 1);
  const auto kept_of = [&](double low, double high) {
    const TopoDS_Face wall = BRepBuilderAPI_MakeFace(
        gp_Pln(gp_Ax3(gp_Pnt(3, 0, 0), gp::DX(), gp::DZ())), low, high, -1, 1);
    return trim({{1, wall, true}}, {sheet}, {.keep = Keep::Below, .intersection = {}});
  };
  for (const double reach : {4.0, 12.0}) {
    const TrimResult across = kept_of(-reach, 20);
    EXPECT_EQ(across.pieces.front().side, PieceSide::Unknown);
    EXPECT_EQ(across.status, Status::Tolerance);
  }
  EXPECT_EQ(kept_of(-4, 4).pieces.front().side, PieceSide::Below);
}

// A cut that ends beside a vertex is taken as one through it: the vertex has to hold both.
TEST(Trim, TolerancesThatGrowWithACutAreThoseOfTheResultAlone) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  const auto loosest = [](const TopoDS_Shape& shape) {
    double most = 0;
    for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next())
      most = std::max(most, BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())));
    return most;
  };
  const double before = loosest(box);
  const gp_Dir across(1, 1, 0);
  for (int round = 0; round < 3; ++round) {
    const TrimResult cut =
        trim(part_of(box), {plane_tool(gp_Pnt(2e-7, 10, 0), across)}, {.intersection = {}});
    EXPECT_EQ(loosest(box), before);
    const TopoDS_Shape made = rebuilt(box, cut);
    EXPECT_TRUE(BRepCheck_Analyzer(made).IsValid());
    EXPECT_EQ(uses_of_edges(made).count(1), 0u);
    EXPECT_GT(loosest(made), before);
  }
}

// A disc whose border is one period of a circle as a spline, from anywhere on.
TopoDS_Face spline_disc(const Handle(Geom_BSplineCurve) & circle, double from) {
  const BRep_Builder builder;
  const Handle(Geom2d_Curve) image = GeomAPI::To2d(circle, gp_Pln());
  TopoDS_Face disc;
  builder.MakeFace(disc, new Geom_Plane(gp_Pln()), Precision::Confusion());
  TopoDS_Wire border;
  builder.MakeWire(border);
  const double middle = from + 0.6 * circle->Period(), to = from + circle->Period();
  const TopoDS_Vertex start = BRepBuilderAPI_MakeVertex(circle->Value(from));
  const TopoDS_Vertex half = BRepBuilderAPI_MakeVertex(circle->Value(middle));
  for (const auto& [range, ends] : {std::pair{std::pair(from, middle), std::pair(start, half)},
                                    std::pair{std::pair(middle, to), std::pair(half, start)}}) {
    TopoDS_Edge edge;
    builder.MakeEdge(edge, circle, Precision::Confusion());
    builder.UpdateEdge(edge, image, disc, Precision::Confusion());
    builder.Range(edge, range.first, range.second);
    builder.Add(edge, ends.first.Oriented(TopAbs_FORWARD));
    builder.Add(edge, ends.second.Oriented(TopAbs_REVERSED));
    builder.Add(border, edge);
  }
  border.Closed(true);
  builder.Add(disc, border);
  return disc;
}

// Open CASCADE, and so FreeCAD, measures 0 where an edge lies outside of its curve's first period,
// and a wrong area of a face there.
TEST(Trim, EdgesOnPeriodicSplinesAreMeasuredRightByOpenCascade) {
  const auto circle = GeomConvert::CurveToBSplineCurve(new Geom_Circle(gp::XOY(), 2));
  for (const double from : {-9.1, -3.0, 0.0, 2.0, 6.5}) {
    const TopoDS_Face disc = spline_disc(circle, from);
    const TrimResult result = trim(part_of(disc), {plane_tool({0.5, 0, 0}, {1, 0.1, 0})});
    ASSERT_EQ(result.pieces.size(), 2u) << from;
    TopTools_IndexedMapOfShape given;
    TopExp::MapShapes(disc, TopAbs_EDGE, given);
    for (const TopoDS_Face& piece : result.replacements.at(1)) {
      GProp_GProps of_face;
      BRepGProp::SurfaceProperties(piece, of_face, 1e-9);
      EXPECT_NEAR(of_face.Mass(), area(piece), 1e-6) << from;
      for (TopExp_Explorer it(piece, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Current());
        if (given.Contains(edge)) continue;  // not cut: stays as it is
        EXPECT_NEAR(GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge)), edge_length(edge), 1e-6)
            << from;
      }
      EXPECT_TRUE(BRepCheck_Analyzer(piece).IsValid()) << from;
    }
  }
}

}  // namespace
}  // namespace blossom::occt
