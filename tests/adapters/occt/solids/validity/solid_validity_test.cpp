// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids are valid where BRepCheck says so of all but the faces that were given.
#include "adapters/occt/solids/validity/solid_validity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

const TopTools_MapOfShape kNone;

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  return faces;
}

TopoDS_Solid solid_of(const std::vector<TopoDS_Face>& faces) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const TopoDS_Face& face : faces) builder.Add(shell, face);
  shell.Closed(Standard_True);
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

// A box with one vertex off the edges that end in it.
struct BadCorner {
  TopoDS_Solid box = BRepPrimAPI_MakeBox(2, 2, 2).Solid();
  TopoDS_Vertex corner = TopoDS::Vertex(TopExp_Explorer(box, TopAbs_VERTEX).Current());

  BadCorner() { BRep_Builder().UpdateVertex(corner, gp_Pnt(5, 5, 5), 1e-7); }

  bool is_at(const TopoDS_Face& face) const {
    for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next())
      if (it.Current().IsSame(corner)) return true;
    return false;
  }
};

void expect_as_brepcheck(const TopoDS_Solid& solid, bool is) {
  EXPECT_EQ(BRepCheck_Analyzer(solid).IsValid(), is);
  EXPECT_EQ(is_valid(solid, kNone), is);
}

TEST(SolidValidity, IsThatOfBRepCheckWhereNothingIsKnown) {
  expect_as_brepcheck(BRepPrimAPI_MakeBox(1, 2, 3).Solid(), true);
  expect_as_brepcheck(TopoDS::Solid(BRepPrimAPI_MakeCylinder(1, 2).Solid()), true);
  expect_as_brepcheck(BadCorner().box, false);
}

TEST(SolidValidity, OpenShellsAndTurnedFacesAreNoSolids) {
  std::vector<TopoDS_Face> faces = faces_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  std::vector<TopoDS_Face> turned = faces;
  turned.front().Reverse();
  expect_as_brepcheck(solid_of(turned), false);
  faces.pop_back();
  expect_as_brepcheck(solid_of(faces), false);
  TopTools_MapOfShape known;
  for (const TopoDS_Face& face : faces) known.Add(face);
  EXPECT_FALSE(is_valid(solid_of(faces), known));
  EXPECT_FALSE(is_valid(solid_of(turned), known));
}

TEST(SolidValidity, KnownFacesAreAsTheyWereGiven) {
  const BadCorner bad;
  TopTools_MapOfShape known, others;
  for (const TopoDS_Face& face : faces_of(bad.box))
    (bad.is_at(face) ? known : others).Add(face.Reversed());
  EXPECT_EQ(known.Extent(), 3);
  EXPECT_TRUE(is_valid(bad.box, known));
  EXPECT_FALSE(is_valid(bad.box, others));
}

TopoDS_Vertex lone_vertex(const gp_Pnt& point) { return BRepBuilderAPI_MakeVertex(point).Vertex(); }

// The parabola that starts in the origin with a slope, and meets the x-axis again at a distance.
TopoDS_Edge parabola_of(double slope, double again, const TopoDS_Vertex& from,
                        const TopoDS_Vertex& to) {
  const double end = BRep_Tool::Pnt(to).X();
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = gp::Origin();
  poles(2) = gp_Pnt(end / 2, slope * end / 2, 0);
  poles(3) = gp_Pnt(end, slope * end * (1 - end / again), 0);
  return BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles), from, to).Edge();
}

// The tolerance of a vertex after corners of a flat face are covered. Its wire is two edges with a
// tolerance, and one apart from them, so that BRepCheck finds it open.
double covered(const TopoDS_Vertex& vertex, const TopoDS_Edge& a, const TopoDS_Edge& b,
               double tolerance) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Edge& edge : {a, b}) {
    builder.UpdateEdge(edge, tolerance);
    builder.Add(wire, edge);
  }
  builder.Add(wire, BRepBuilderAPI_MakeEdge(gp_Pnt(0, -5, 0), gp_Pnt(1, -5, 0)).Edge());
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln()), Precision::Confusion());
  builder.Add(face, wire);
  EXPECT_FALSE(BRepCheck_Analyzer(face).IsValid());
  cover_tangent_corners({solid_of({face})}, kNone);
  return BRep_Tool::Tolerance(vertex);
}

// They keep within 0.01 of each other up to 20, where they cross; curves of their length that touch
// do so for 2.5.
TEST(TangentCorners, AreNotCoveredUpToWhereEdgesWithWideTolerancesCross) {
  const TopoDS_Vertex corner = lone_vertex(gp::Origin());
  const TopoDS_Edge line = BRepBuilderAPI_MakeEdge(corner, lone_vertex({40, 0, 0})).Edge();
  const TopoDS_Edge other = parabola_of(1e-3, 20, corner, lone_vertex({40, -0.04, 0}));
  EXPECT_LT(covered(corner, line, other, 1e-2), 1e-2);
}

TEST(TangentCorners, AreNotCoveredUpToAnotherCommonVertex) {
  const TopoDS_Vertex corner = lone_vertex(gp::Origin()), end = lone_vertex({0.1, 0, 0});
  const TopoDS_Edge line = BRepBuilderAPI_MakeEdge(corner, end).Edge();
  const TopoDS_Edge other = parabola_of(0.1, 0.1, corner, end);
  EXPECT_LT(covered(corner, line, other, 1e-2), 1e-2);
  EXPECT_LT(BRep_Tool::Tolerance(end), 1e-2);
}

// Beside either end, which are one vertex.
TEST(TangentCorners, OfAClosedEdgeAreCovered) {
  for (const double angle : {-1e-3, 1e-3}) {
    const TopoDS_Vertex corner = lone_vertex({10, 0, 0});
    const Handle(Geom_Circle) circle = new Geom_Circle(gp::XOY(), 10);
    const TopoDS_Edge rim =
        BRepBuilderAPI_MakeEdge(circle, corner, corner, 0, 2 * std::numbers::pi).Edge();
    const gp_Pnt crossing(10 * std::cos(angle), 10 * std::sin(angle), 0);
    const gp_Pnt far(10 + 500 * (crossing.X() - 10), 500 * crossing.Y(), 0);
    const TopoDS_Edge line = BRepBuilderAPI_MakeEdge(corner, lone_vertex(far)).Edge();
    const double tolerance = covered(corner, rim, line, 1e-5);
    EXPECT_GT(tolerance, 1e-2);
    EXPECT_LT(tolerance, 1.2e-2);
  }
}

// A tube without a pipe through it, whose side touches the tube's seam where patches of both end.
// At the tolerance asked for a solid comes out of it that is not valid.
TEST(SolidValidity, IsAskedForAtEveryWayOfDividing) {
  const char* const folder = blossom::testing::test_data();
  if (folder == nullptr) GTEST_SKIP() << blossom::testing::kNoTestData;
  const auto solid = [&](const char* name) {
    return trim_tool(read_model(std::string(folder) + "/solids/" + name).shape());
  };
  const SolidTrimResult cut =
      trim_solids(solid("cut_39.a.brep"), {solid("cut_39.b.brep")}, SolidOperation::Cut);
  ASSERT_EQ(cut.obstacles.empty() ? std::string() : cut.obstacles.front(), "");
  ASSERT_EQ(cut.solids.size(), 1u);
  EXPECT_TRUE(BRepCheck_Analyzer(cut.solids.front()).IsValid());
  EXPECT_NEAR(cut.total.result, 3540411.58, 0.1);
}

}  // namespace
}  // namespace blossom::occt
