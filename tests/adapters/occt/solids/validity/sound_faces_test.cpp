// SPDX-License-Identifier: LGPL-2.1-or-later
// What is proven of faces is so by BRepCheck, and most that is valid is proven.
#include "adapters/occt/solids/validity/sound_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Plane.hxx>
#include <Poly_Array1OfTriangle.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/intersection_edges.h"
#include "tests/adapters/occt/ordinary_solids.h"
#include "tests/support/random.h"

namespace blossom::occt {
namespace {

bool is_valid(const TopoDS_Face& face) { return BRepCheck_Analyzer(face).IsValid(); }

struct Count {
  int valid = 0, proven = 0;

  void add(const TopoDS_Face& face) {
    const bool fine = is_valid(face), sound = is_sound_face(face);
    EXPECT_TRUE(fine || !sound);
    valid += fine;
    proven += sound;
  }
};

TEST(SoundFaces, AreMostOfOrdinarySolids) {
  Count count;
  for (int seed = 0; seed < testing::kOrdinaryFamilies; ++seed) {
    const TopoDS_Shape solid = testing::ordinary_solid(seed).shape;
    if (solid.IsNull()) continue;
    for (const TopoDS_Face& face : faces_of(solid)) count.add(face);
  }
  EXPECT_GT(count.valid, 90);
  EXPECT_GT(count.proven, 0.98 * count.valid);
}

TEST(SoundFaces, HaveCurvedBordersOnCurvedSurfaces) {
  Count count;
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Ax2({0, 1, 2}, gp_Dir(1, 2, 3)), 3).Shape();
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(3, 1).Shape();
  const TopoDS_Shape cone =
      BRepPrimAPI_MakeCone(gp_Ax2({0.3, 0.4, -4}, gp_Dir(0, 0.1, 1)), 2, 0.5, 9);
  for (const TopoDS_Shape& made :
       {BRepAlgoAPI_Cut(ball, ring).Shape(), BRepAlgoAPI_Cut(ring, cone).Shape(),
        BRepAlgoAPI_Cut(ball, cone).Shape()})
    for (const TopoDS_Face& face : faces_of(made)) count.add(face);
  EXPECT_GE(count.proven, count.valid - 1);  // one has ends that are farther apart
}

// A plane within a closed spline through random points, which mostly crosses itself.
TopoDS_Face face_within(const std::vector<Vec2>& points) {
  const auto through = new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    through->SetValue(static_cast<int>(i) + 1, {points[i][0], points[i][1], 0});
  GeomAPI_Interpolate interpolate(through, true, 1e-9);
  interpolate.Perform();
  const Handle(Geom_BSplineCurve) curve = interpolate.Curve();
  const double from = curve->FirstParameter(), to = curve->LastParameter();
  const double middle = 0.4 * from + 0.6 * to;
  TopoDS_Face face;
  const BRep_Builder builder;
  builder.MakeFace(face, new Geom_Plane(gp_Ax3()), 1e-7);
  const TopoDS_Edge first = BRepBuilderAPI_MakeEdge(curve, from, middle);
  const TopoDS_Edge second = BRepBuilderAPI_MakeEdge(curve, middle, to);
  builder.Add(face, BRepBuilderAPI_MakeWire(first, second).Wire());
  return face;
}

TEST(SoundFaces, AreValidWhateverTheirBordersDo) {
  auto random = blossom::testing::seeded(5);
  std::uniform_real_distribution<double> any(0, 1);
  Count count;
  for (int trial = 0; trial < 150; ++trial) {
    std::vector<Vec2> points(5);
    for (Vec2& point : points) point = Vec2{any(random), any(random)};
    count.add(face_within(points));
  }
  EXPECT_GT(count.valid, 10);
  EXPECT_LT(count.valid, 140);
  // BRepCheck takes what is on the left of a border that runs clockwise, all the rest of the plane.
  EXPECT_GT(count.proven, 0.5 * count.valid);
}

// Between a line and a curve above it.
struct Lens {
  TopoDS_Vertex left = BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 0)).Vertex();
  TopoDS_Vertex right = BRepBuilderAPI_MakeVertex(gp_Pnt(10, 0, 0)).Vertex();
  TopoDS_Edge line = BRepBuilderAPI_MakeEdge(left, right).Edge();
  TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(above(), right, left).Edge();

  static Handle(Geom_BSplineCurve) above() {
    TColgp_Array1OfPnt points(1, 4);
    points.SetValue(1, gp_Pnt(10, 0, 0));
    points.SetValue(2, gp_Pnt(7, 4, 0));
    points.SetValue(3, gp_Pnt(3, 4, 0));
    points.SetValue(4, gp_Pnt(0, 0, 0));
    return GeomConvert::CurveToBSplineCurve(new Geom_BezierCurve(points));
  }

  // Leaves the lens.
  TopoDS_Edge across() const {
    const TopoDS_Vertex top = BRepBuilderAPI_MakeVertex(gp_Pnt(5, 5, 0)).Vertex();
    return BRepBuilderAPI_MakeEdge(left, top).Edge();
  }

  TopoDS_Face face(const std::vector<TopoDS_Shape>& more_edges = {},
                   const std::vector<TopoDS_Shape>& more_parts = {}) const {
    const BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    builder.Add(wire, line);
    builder.Add(wire, arc);
    for (const TopoDS_Shape& edge : more_edges) builder.Add(wire, edge);
    wire.Closed(Standard_True);
    TopoDS_Face made;
    builder.MakeFace(made, new Geom_Plane(gp_Ax3()), 1e-7);
    builder.Add(made, wire);
    for (const TopoDS_Shape& part : more_parts) builder.Add(made, part);
    return made;
  }
};

TEST(SoundFaces, HaveNoEdgesAndVerticesThatAreInNoLoop) {
  const Lens lens;
  EXPECT_TRUE(is_valid(lens.face()));
  EXPECT_TRUE(is_sound_face(lens.face()));
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(lens.across()).Wire();
  for (const TopAbs_Orientation way : {TopAbs_INTERNAL, TopAbs_EXTERNAL}) {
    EXPECT_FALSE(is_sound_face(lens.face({lens.across().Oriented(way)})));
    EXPECT_FALSE(is_sound_face(lens.face({}, {wire.Oriented(way)})));
    EXPECT_FALSE(is_sound_face(lens.face({}, {lens.left.Oriented(way)})));
  }
}

// The polygon of the arc is its chord, on a triangle at a height.
TEST(SoundFaces, HavePolygonsThatFitTheirTriangulations) {
  for (const double height : {0.0, 1.0}) {
    const Lens lens;
    TColgp_Array1OfPnt nodes(1, 3);
    nodes.SetValue(1, gp_Pnt(10, 0, height));
    nodes.SetValue(2, gp_Pnt(0, 0, height));
    nodes.SetValue(3, gp_Pnt(5, 5, height));
    Poly_Array1OfTriangle triangles(1, 1);
    triangles.SetValue(1, Poly_Triangle(1, 2, 3));
    TColStd_Array1OfInteger ends(1, 2);
    TColStd_Array1OfReal parameters(1, 2);
    for (int i = 1; i <= 2; ++i) {
      ends.SetValue(i, i);
      parameters.SetValue(i, i - 1.0);
    }
    const Handle(Poly_Triangulation) triangulation = new Poly_Triangulation(nodes, triangles);
    const Handle(Poly_PolygonOnTriangulation) polygon =
        new Poly_PolygonOnTriangulation(ends, parameters);
    BRep_Builder().UpdateEdge(lens.arc, polygon, triangulation);
    EXPECT_EQ(is_valid(lens.face()), height == 0);
    EXPECT_EQ(is_sound_face(lens.face()), height == 0);
  }
}

// Curves in parameters moved, vertices moved, tolerances lowered.
TEST(SoundFaces, AreValidWhereModelsAreDamaged) {
  auto random = blossom::testing::seeded(6);
  std::uniform_real_distribution<double> any(0, 1);
  const BRep_Builder builder;
  Count count;
  for (int trial = 0; trial < 36; ++trial) {
    const TopoDS_Shape solid = testing::ordinary_solid(trial % testing::kOrdinaryFamilies).shape;
    if (solid.IsNull()) continue;
    const std::vector<TopoDS_Face> faces = faces_of(BRepBuilderAPI_Copy(solid).Shape());
    const TopoDS_Face face =
        faces[static_cast<std::size_t>(any(random) * static_cast<double>(faces.size()))];
    TopExp_Explorer it(face, TopAbs_EDGE);
    for (int skip = static_cast<int>(3 * any(random)); skip > 0 && it.More(); --skip) it.Next();
    if (!it.More()) continue;
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    const double by = std::pow(10, -14 * any(random));
    double from = 0, to = 0;
    const Handle(Geom2d_Curve) chart = BRep_Tool::CurveOnSurface(edge, face, from, to);
    if (!chart.IsNull() && trial % 3 != 0) chart->Translate(gp_Vec2d(by, 0.5 * by));
    if (trial % 3 == 0) {
      const TopoDS_Vertex vertex = TopoDS::Vertex(TopExp_Explorer(edge, TopAbs_VERTEX).Current());
      builder.UpdateVertex(vertex, BRep_Tool::Pnt(vertex).Translated({by, 0, by}), 1e-7);
    }
    count.add(face);
  }
  EXPECT_GT(count.valid, 0);
  EXPECT_GT(count.proven, 0);
  EXPECT_LT(count.valid, 34);
}

}  // namespace
}  // namespace blossom::occt
