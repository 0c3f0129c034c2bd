// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids whose edges state too small or too large tolerances are combined as if they stated true
// ones.
#include "adapters/occt/repair/edge_tolerances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/repair/edge_gaps.h"
#include "adapters/occt/repair/repair.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/exchange/shapes_files.h"
#include "tests/support/loose_shapes.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::cylinder_with_wide_rim;

using testing::kPi;
const IntersectionOptions kOptions;
const WorkLimit kNoLimit(kOptions);

double largest_tolerance(const TrimTool& solid, TopAbs_ShapeEnum kind) {
  return BRep_Tool::MaxTolerance(solid.solids.front(), kind);
}

TopoDS_Shape box_of_loose_edges(double tolerance) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 2, 2).Shape();
  const BRep_Builder builder;
  for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next())
    builder.UpdateEdge(TopoDS::Edge(it.Current()), tolerance);
  for (TopExp_Explorer it(box, TopAbs_VERTEX); it.More(); it.Next())
    builder.UpdateVertex(TopoDS::Vertex(it.Current()), tolerance);
  return box;
}

// A saddle over the unit square; one of its edges has a bump of some 6e-5 in space, a hundredth of
// its length wide, between the points at which Open CASCADE measures.
TopoDS_Face saddle_with_a_bump() {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(i, j, i * j);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Face();
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current());
  double first = 0, last = 0;
  const Handle(Geom_Curve) given = BRep_Tool::Curve(edge, first, last);
  const Handle(Geom_BSplineCurve) bump =
      GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(given, first, last));
  bump->IncreaseDegree(3);
  for (const double knot : {0.472, 0.4745, 0.477, 0.4795, 0.482})
    bump->InsertKnot(first + knot * (last - first));
  bump->SetPole(5, bump->Pole(5).Translated(gp_Vec(0, 0, 1e-4)));
  BRep_Builder().UpdateEdge(edge, bump, 1e-4);
  return face;
}

// A spline through 17 points of a quarter circle, pulled up to a face, with the circle as its lower
// edge: the two meet in all these points, and some 1e-5 apart between them.
TopoDS_Face interpolated_quarter() {
  constexpr int kSpans = 16;
  const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2(), 50);
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, kSpans + 1);
  const Handle(TColStd_HArray1OfReal) angles = new TColStd_HArray1OfReal(1, kSpans + 1);
  for (int i = 0; i <= kSpans; ++i) {
    angles->SetValue(i + 1, 0.5 * kPi * i / kSpans);
    points->SetValue(i + 1, circle->Value(angles->Value(i + 1)));
  }
  GeomAPI_Interpolate spline(points, angles, Standard_False, 1e-9);
  spline.Load(circle->DN(0, 1), circle->DN(0.5 * kPi, 1), Standard_False);
  spline.Perform();
  const Handle(Geom_Surface) wall = new Geom_SurfaceOfLinearExtrusion(spline.Curve(), gp::DZ());
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(wall, 0, 0.5 * kPi, 0, 10, 1e-7).Face();
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(it.Current()), first, last);
    const gp_Pnt from = curve->Value(first), to = curve->Value(last);
    if (std::abs(from.Z()) + std::abs(to.Z()) < 1e-6)
      BRep_Builder().UpdateEdge(TopoDS::Edge(it.Current()), circle, 1e-7);
  }
  return face;
}

// Of an edge's curves beyond its tolerance.
double largest_excess(const TopoDS_Shape& shape) {
  double largest = 0;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    for (TopExp_Explorer it(face.Current(), TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      const EdgeGaps gaps = edge_gaps(edge, TopoDS::Face(face.Current()));
      largest = std::max(largest, gaps.same_parameter - BRep_Tool::Tolerance(edge));
    }
  return largest;
}

Repairs raised_tolerances(const TopoDS_Shape& shape) {
  return Repairer(shape, StatedTolerances::Raised).repair_all({});
}

TEST(RaisedTolerances, CoverTheDistancesOfCurves) {
  const TopoDS_Shape cylinder = cylinder_with_wide_rim(1e-4);
  const Repairs raised = raised_tolerances(cylinder);
  EXPECT_EQ(raised.edges.size(), 1U);
  EXPECT_EQ(raised.vertices.size(), 1U);
  EXPECT_NEAR(raised.largest_tolerance(), 1.1e-4, 1e-9);
  EXPECT_LE(largest_excess(cylinder), 0);
}

TEST(RaisedTolerances, CoverDistancesBetweenInterpolatedPoints) {
  const TopoDS_Face face = interpolated_quarter();
  const Repairs raised = raised_tolerances(face);
  EXPECT_EQ(raised.edges.size(), 1U);
  const double step = 0.5 * kPi / 16, between = 50 * std::pow(step, 4) / 384;
  EXPECT_NEAR(raised.largest_tolerance(), 1.1 * between, 0.1 * between);
}

TEST(RaisedTolerances, AreThoseThatAreTooSmallAlone) {
  const TopoDS_Shape box = box_of_loose_edges(0.3);
  EXPECT_TRUE(raised_tolerances(box).empty());
  EXPECT_EQ(BRep_Tool::MaxTolerance(box, TopAbs_EDGE), 0.3);
}

TEST(RaisedTolerances, CoverNarrowGapsInFilesWithoutTolerances) {
  const testing::Folder folder;
  Model model;
  model.add(saddle_with_a_bump(), "saddle");
  for (const char* const name : {"saddle.step", "saddle.iges"}) {
    write_model(model, folder / name);
    Model back = read_model(folder / name);
    EXPECT_GT(largest_excess(back.shape()), 0) << name;  // as the reader left it
    EXPECT_FALSE(back.repair().edges.empty()) << name;
    EXPECT_LE(largest_excess(back.shape()), 0) << name;
    EXPECT_GE(BRep_Tool::MaxTolerance(back.shape(), TopAbs_EDGE), 5e-5) << name;
  }
}

TEST(TrueTolerances, LeaveAloneWhatIsTrue) {
  const TrimTool ball = trim_tool(BRepPrimAPI_MakeSphere(1).Shape());
  const TrueSolid made = with_true_tolerances(ball, kNoLimit);
  EXPECT_EQ(made.told, "");
  EXPECT_TRUE(made.solid.solids.front().IsEqual(ball.solids.front()));
}

TEST(TrueTolerances, AreNoLessThanTheDistancesOfCurves) {
  const TrimTool given = trim_tool(cylinder_with_wide_rim(1e-4));
  const TrueSolid made = with_true_tolerances(given, kNoLimit);
  EXPECT_NE(made.told.find("the curves of 1 edges are up to 0.0001 apart"), std::string::npos)
      << made.told;
  EXPECT_GE(largest_tolerance(made.solid, TopAbs_EDGE), 1e-4);
  EXPECT_GE(largest_tolerance(made.solid, TopAbs_VERTEX), 1e-4);
  EXPECT_LE(largest_tolerance(given, TopAbs_EDGE), 1.1e-7);  // the given solid keeps its own
}

TEST(TrueTolerances, AreNotFarAboveTheDistancesOfCurves) {
  const TrimTool given = trim_tool(box_of_loose_edges(0.3));
  const TrueSolid made = with_true_tolerances(given, kNoLimit);
  EXPECT_NE(made.told.find("12 edges state tolerances up to 0.3"), std::string::npos) << made.told;
  EXPECT_LE(largest_tolerance(made.solid, TopAbs_VERTEX), 1e-6);
  EXPECT_TRUE(BRepCheck_Analyzer(made.solid.solids.front()).IsValid());
  ASSERT_EQ(made.solid.faces.size(), given.faces.size());
  for (std::size_t i = 0; i < given.faces.size(); ++i) {
    EXPECT_EQ(made.solid.faces[i].Orientation(), given.faces[i].Orientation());
    EXPECT_EQ(BRep_Tool::Surface(made.solid.faces[i]), BRep_Tool::Surface(given.faces[i]));
  }
}

TEST(TrueTolerances, LetSolidsBeCutAcrossBadEdges) {
  const TrimTool half = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(0, -2, -2), gp_Pnt(3, 2, 3)).Shape());
  const SolidTrimResult rim =
      trim_solids(trim_tool(cylinder_with_wide_rim(1e-4)), {half}, SolidOperation::Cut);
  EXPECT_EQ(rim.obstacles, std::vector<std::string>{});
  ASSERT_EQ(rim.solids.size(), 1U);
  EXPECT_NEAR(rim.volumes.back().cut, kPi, 1e-3);
  ASSERT_EQ(rim.tolerances.size(), 1U);
  EXPECT_EQ(rim.tolerances.front().rfind("the part: ", 0), 0U);

  const TrimTool ball = trim_tool(BRepPrimAPI_MakeSphere(gp_Pnt(2, 1, 1.9), 0.5).Shape());
  const SolidTrimResult loose =
      trim_solids(trim_tool(box_of_loose_edges(0.3)), {ball}, SolidOperation::Cut);
  EXPECT_EQ(loose.obstacles, std::vector<std::string>{});
  ASSERT_EQ(loose.solids.size(), 1U);
  EXPECT_LE(loose.volumes.back().cut_error(), 1e-9);
}

}  // namespace
}  // namespace blossom::occt
