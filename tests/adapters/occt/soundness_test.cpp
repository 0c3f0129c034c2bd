// SPDX-License-Identifier: LGPL-2.1-or-later
// Faults planted by hand, each of a known size, and shapes without any.
#include "adapters/occt/soundness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/repair/edge_gaps.h"
#include "adapters/occt/solid_trim.h"

namespace blossom::occt {
namespace {

bool says(const std::vector<Problem>& problems, const std::string& word) {
  return std::any_of(problems.begin(), problems.end(), [&](const Problem& problem) {
    return problem.text().find(word) != std::string::npos;
  });
}

bool says(const std::vector<std::string>& problems, const std::string& word) {
  return std::any_of(problems.begin(), problems.end(), [&](const std::string& problem) {
    return problem.find(word) != std::string::npos;
  });
}

std::string all_problems(const Soundness& found) {
  std::string text;
  for (const std::string& problem : found.problems) text += problem + "; ";
  for (const FaceSoundness& face : found.faces)
    for (const Problem& problem : face.problems) text += problem.text() + "; ";
  for (const EdgeSoundness& edge : found.edges)
    for (const Problem& problem : edge.problems) text += problem.text() + "; ";
  return text;
}

// The unit square at z = 0 as a bilinear surface; x = u, y = v.
Handle(Geom_BezierSurface) square() {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(i, j, 0);
  return new Geom_BezierSurface(poles);
}

Handle(Geom_BezierCurve) bezier(const std::vector<gp_Pnt>& points) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) poles(static_cast<int>(i) + 1) = points[i];
  return new Geom_BezierCurve(poles);
}

// The square with another curve in space for the edge from (0, 0) to (1, 0).
TopoDS_Face square_with(const std::vector<gp_Pnt>& curve) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(square(), 1e-7).Face();
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    double first = 0, last = 0;
    const Handle(Geom_Curve) old = BRep_Tool::Curve(edge, first, last);
    if (old->Value(first).Y() == 0 && old->Value(last).Y() == 0)
      BRep_Builder().UpdateEdge(edge, bezier(curve), 1e-7);
  }
  return face;
}

const EdgeSoundness& worst(const Soundness& found) {
  return *std::max_element(
      found.edges.begin(), found.edges.end(),
      [](const auto& a, const auto& b) { return a.same_parameter < b.same_parameter; });
}

TEST(Soundness, FindsNothingWrongWithPrimitives) {
  for (const TopoDS_Shape& shape :
       {BRepPrimAPI_MakeBox(1, 2, 3).Shape(), BRepPrimAPI_MakeSphere(2).Shape(),
        BRepPrimAPI_MakeTorus(3, 1).Shape(), BRepPrimAPI_MakeCone(2, 0, 3).Shape()}) {
    const Soundness found = soundness(shape);
    EXPECT_EQ(all_problems(found), "");
    for (const EdgeSoundness& edge : found.edges) {
      EXPECT_LT(edge.gap, 1e-12);
      EXPECT_FALSE(edge.free);
      EXPECT_FALSE(edge.crowded);
    }
  }
}

TEST(Soundness, MeasuresAGapThatIsAboveTheStatedTolerance) {
  // The parabola 4 h t (1 - t) above the border: h = 1e-3 at the middle.
  const Soundness found = soundness(square_with({{0, 0, 0}, {0.5, 0, 2e-3}, {1, 0, 0}}));
  const EdgeSoundness& edge = worst(found);
  EXPECT_NEAR(edge.gap, 1e-3, 1e-8);  // 2e-6 relative: nearest points are not straight below
  EXPECT_NEAR(edge.same_parameter, 1e-3, 1e-12);
  EXPECT_EQ(edge.tolerance, 1e-7);
  EXPECT_TRUE(says(edge.problems, "apart by 0.001")) << all_problems(found);
}

TEST(Soundness, FindsANarrowGapBetweenSamplesThatCheckersTake) {
  // A bump a thousandth of the edge wide, off the middle.
  std::vector<gp_Pnt> poles;
  for (int i = 0; i <= 25; ++i) poles.emplace_back(i / 25.0, 0, i == 7 ? 1e-5 : 0);
  const double peak = 1e-5 * 480700 * std::pow(0.28, 7) * std::pow(0.72, 18);  // binom(25, 7)
  EXPECT_NEAR(worst(soundness(square_with(poles))).same_parameter, peak, 1e-12);
}

TEST(Soundness, TellsAnUnevenParameterFromAGap) {
  // x = t + 0.02 t (1 - t): off by 0.005 at the middle, never off the line.
  const Soundness found = soundness(square_with({{0, 0, 0}, {0.51, 0, 0}, {1, 0, 0}}));
  const EdgeSoundness& edge = worst(found);
  EXPECT_NEAR(edge.same_parameter, 0.005, 1e-12);
  EXPECT_LT(edge.gap, 1e-12);
  EXPECT_TRUE(says(edge.problems, "at the same parameter by 0.005")) << all_problems(found);
}

TEST(Soundness, MeasuresHowFarAnEdgeMissesItsVertices) {
  const Soundness found = soundness(square_with({{0, 0, 2e-4}, {1, 0, 1e-4}}));
  const EdgeSoundness& edge = worst(found);
  EXPECT_NEAR(edge.vertex_gap, 2e-4, 1e-15);
  EXPECT_EQ(edge.vertex_tolerance, 1e-7);
  EXPECT_TRUE(says(edge.problems, "misses a vertex")) << all_problems(found);
}

TEST(Soundness, CallsNumbersThatAreNoneAnInfiniteGap) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TopoDS_Face face = square_with({{0, 0, 0}, {0.5, nan, 0}, {1, 0, 0}});
  double most = 0;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    most = std::max(most, edge_gaps(TopoDS::Edge(it.Current()), face).gap);
  EXPECT_EQ(most, std::numeric_limits<double>::infinity());
}

TEST(Soundness, MissesAParametricCurve) {
  BRepBuilderAPI_MakeWire wire;
  const std::vector<gp_Pnt> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(bezier({corners[i], corners[i + 1]})).Edge());
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, square(), 1e-7);
  BRep_Builder().Add(face, wire.Wire());
  const Soundness found = soundness(face);
  ASSERT_EQ(found.edges.size(), 4u);
  for (const EdgeSoundness& edge : found.edges)
    EXPECT_TRUE(says(edge.problems, "no parametric curve"));
}

// The first faces of a box in one shell.
TopoDS_Shell shell_of(const TopoDS_Shape& box, int count) {
  TopoDS_Shell shell;
  BRep_Builder().MakeShell(shell);
  TopExp_Explorer it(box, TopAbs_FACE);
  for (int i = 0; i < count; ++i, it.Next()) BRep_Builder().Add(shell, it.Current());
  return shell;
}

TEST(Soundness, CountsFreeEdgesOfASheetWithoutBlame) {
  const Soundness found = soundness(shell_of(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), 5));
  EXPECT_EQ(all_problems(found), "");
  EXPECT_EQ(std::count_if(found.edges.begin(), found.edges.end(),
                          [](const EdgeSoundness& edge) { return edge.free; }),
            4);
}

TEST(Soundness, BlamesFreeEdgesOfASolid) {
  TopoDS_Solid solid;
  BRep_Builder().MakeSolid(solid);
  BRep_Builder().Add(solid, shell_of(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), 5));
  const Soundness found = soundness(solid);
  EXPECT_EQ(std::count_if(found.edges.begin(), found.edges.end(),
                          [](const EdgeSoundness& edge) { return says(edge.problems, "open"); }),
            4);
}

TEST(Soundness, FindsAnEdgeThatIsUsedThreeTimes) {
  TopoDS_Shell shell = shell_of(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), 6);
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(shell, TopAbs_EDGE).Current());
  const TopoDS_Vertex tip = BRepBuilderAPI_MakeVertex(gp_Pnt(-1, -1, 0.5));
  BRepBuilderAPI_MakeWire wire(edge);
  wire.Add(BRepBuilderAPI_MakeEdge(TopExp::LastVertex(edge), tip).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(tip, TopExp::FirstVertex(edge)).Edge());
  BRep_Builder().Add(shell, BRepBuilderAPI_MakeFace(wire.Wire(), Standard_True).Face());
  const Soundness found = soundness(shell);
  const auto crowded = std::count_if(found.edges.begin(), found.edges.end(),
                                     [](const EdgeSoundness& each) { return each.crowded; });
  EXPECT_EQ(crowded, 1);
  EXPECT_NE(all_problems(found).find("used 3 times"), std::string::npos) << all_problems(found);
}

// Two towers on one plate, on tiles that meet in a corner.
TEST(Soundness, LetsASolidTouchItselfAlongAnEdge) {
  const TrimTool plate = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, -1), 2, 2, 1).Shape());
  const TrimTool one = trim_tool(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  const TrimTool other = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 0), 1, 1, 1).Shape());
  const SolidTrimResult made = trim_solids(plate, {one, other}, SolidOperation::Fuse);
  ASSERT_EQ(made.solids.size(), 1U);
  const Soundness found = soundness(made.solids.front());
  EXPECT_EQ(std::count_if(found.edges.begin(), found.edges.end(),
                          [](const EdgeSoundness& each) { return each.crowded; }),
            1);
  EXPECT_EQ(all_problems(found), "");
}

TEST(Soundness, FindsASolidThatIsInsideOut) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  EXPECT_TRUE(says(soundness(box.Reversed()).problems, "inside out"));
}

// The rim of a cone beyond a ball that is off its centre by 3e-5: 1e-9 of volume between faces of
// 1e-4, for which Open CASCADE's integration has the wrong sign.
TEST(Soundness, MeasuresSlivers) {
  const TrimTool cone = trim_tool(BRepPrimAPI_MakeCone(1, 0, 1).Shape());
  const TrimTool ball = trim_tool(BRepPrimAPI_MakeSphere(gp_Pnt(2e-5, -2e-5, 0), 1).Shape());
  const SolidTrimResult made = trim_solids(cone, {ball}, SolidOperation::Cut);
  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  EXPECT_FALSE(says(soundness(made.solids.front()).problems, "inside out"));
  EXPECT_TRUE(says(soundness(made.solids.front().Reversed()).problems, "inside out"));
}

TEST(Soundness, FindsASolidWithoutFaces) {
  TopoDS_Solid empty;
  BRep_Builder().MakeSolid(empty);
  EXPECT_EQ(soundness(empty).problems, std::vector<std::string>{"solid 1: has no faces"});
}

TopoDS_Face polygon(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& corner : corners) wire.Add(corner);
  wire.Close();
  return BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), wire.Wire()).Face();
}

TEST(WireProblems, FindTheCornerThatLiesOnAnEdge) {
  const std::vector<Problem> problems =
      wire_problems(polygon({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {1, 0, 0}, {0, 2, 0}}));
  EXPECT_TRUE(says(problems, "meets itself at (1, 0, 0)"));
}

TEST(WireProblems, FindTheCrossingOfAnEight) {
  const std::vector<Problem> problems =
      wire_problems(polygon({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}));
  EXPECT_TRUE(says(problems, "meets itself")) << problems.size();
}

TEST(WireProblems, FindAWireThatEnclosesNothing) {
  EXPECT_TRUE(
      says(wire_problems(polygon({{0, 0, 0}, {2, 0, 0}, {1, 1e-9, 0}})), "encloses no more"));
  EXPECT_TRUE(wire_problems(polygon({{0, 0, 0}, {2, 0, 0}, {1, 1e-3, 0}})).empty());
}

TopoDS_Wire wire_along(const std::vector<gp_Pnt>& corners, TopAbs_Orientation orientation) {
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[i + 1]));
  TopoDS_Wire oriented;
  BRep_Builder().MakeWire(oriented);
  for (TopoDS_Iterator it(wire.Wire()); it.More(); it.Next())
    BRep_Builder().Add(oriented, it.Value().Oriented(orientation));
  return oriented;
}

TEST(OpenWires, AreNotThoseOfInnerEdges) {
  const std::vector<gp_Pnt> cut{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}};
  TopoDS_Face face = polygon({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}});
  EXPECT_FALSE(has_open_wire(face));
  BRep_Builder().Add(face, wire_along(cut, TopAbs_INTERNAL));
  EXPECT_FALSE(has_open_wire(face));
  EXPECT_FALSE(has_open_wire(TopoDS::Face(face.Reversed())));
  BRep_Builder().Add(face, wire_along(cut, TopAbs_FORWARD));
  EXPECT_TRUE(has_open_wire(face));
}

TEST(OpenWires, MayHaveInnerEdgesToo) {
  TopoDS_Wire closed = wire_along({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {0, 0, 0}}, TopAbs_FORWARD);
  TopoDS_Wire open = wire_along({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, TopAbs_FORWARD);
  for (TopoDS_Wire* const wire : {&closed, &open}) {
    const TopoDS_Vertex corner = TopExp::FirstVertex(
        TopoDS::Edge(TopExp_Explorer(*wire, TopAbs_EDGE).Current()), Standard_True);
    const TopoDS_Edge inner =
        BRepBuilderAPI_MakeEdge(corner, BRepBuilderAPI_MakeVertex(gp_Pnt(1, 1, 0)).Vertex());
    BRep_Builder().Add(*wire, inner.Oriented(TopAbs_INTERNAL));
    TopoDS_Face face;
    BRep_Builder().MakeFace(face, new Geom_Plane(gp_Pln(gp::XOY())), 1e-7);
    BRep_Builder().Add(face, *wire);
    EXPECT_EQ(has_open_wire(face), wire == &open);
  }
}

}  // namespace
}  // namespace blossom::occt
