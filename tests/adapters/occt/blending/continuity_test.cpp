// SPDX-License-Identifier: LGPL-2.1-or-later
// Continuity of models: what their edges are known to be.

#include "adapters/occt/blending/continuity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/strip.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;

TopoDS_Shape sewn(const std::vector<TopoDS_Shape>& faces, double tolerance = 1e-6) {
  BRepBuilderAPI_Sewing sewing(tolerance);
  sewing.SetNonManifoldMode(true);
  for (const TopoDS_Shape& face : faces) sewing.Add(face);
  sewing.Perform();
  return sewing.SewedShape();
}

TopoDS_Face face_over(const Handle(Geom_Surface) & surface, double u0, double u1, double v0,
                      double v1) {
  return BRepBuilderAPI_MakeFace(surface, u0, u1, v0, v1, 1e-7);
}

std::vector<EdgeContinuity> of_kind(const std::vector<EdgeContinuity>& edges, EdgeRole kind) {
  std::vector<EdgeContinuity> found;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(found),
               [&](const EdgeContinuity& edge) { return edge.kind == kind; });
  return found;
}

/// The one edge that two faces share.
EdgeContinuity the_shared(const TopoDS_Shape& shape, const ContinuityOptions& options = {}) {
  const auto shared = of_kind(edge_continuity(shape, options), EdgeRole::Shared);
  EXPECT_EQ(shared.size(), 1u);
  if (shared.empty()) return {};
  EXPECT_EQ(shared[0].problem, "");
  EXPECT_TRUE(shared[0].found.has_value());
  return shared[0];
}

/// A fillet's edges: those smoother than G0.
std::vector<EdgeContinuity> smooth_edges(const TopoDS_Shape& shape) {
  std::vector<EdgeContinuity> found;
  for (const EdgeContinuity& edge : edge_continuity(shape))
    if (edge.found && edge.smoothness >= Smoothness::G1) found.push_back(edge);
  return found;
}

/// z = height(x, y) through 10 x 10 points over a square of side 1 from a corner on.
Handle(Geom_BSplineSurface)
    graph(double x, double y, const std::function<double(double, double)>& height) {
  TColgp_Array2OfPnt points(1, 10, 1, 10);
  for (int i = 1; i <= 10; ++i)
    for (int j = 1; j <= 10; ++j) {
      const double px = x + (i - 1) / 9.0, py = y + (j - 1) / 9.0;
      points(i, j) = gp_Pnt(px, py, height(px, py));
    }
  return GeomAPI_PointsToBSplineSurface(points, 3, 5, GeomAbs_C2, 1e-6).Surface();
}

double wave(double x, double y) { return 0.2 * std::sin(2 * x) * std::cos(3 * y); }

TEST(EdgeContinuity, EdgesOfABoxAreProvenToBeRightAngles) {
  const auto edges = edge_continuity(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  ASSERT_EQ(edges.size(), 12u);
  for (const EdgeContinuity& edge : edges) {
    EXPECT_EQ(edge.kind, EdgeRole::Shared);
    ASSERT_TRUE(edge.found && edge.bounds) << edge.no_bounds << edge.problem;
    EXPECT_EQ(edge.smoothness, Smoothness::G0);
    EXPECT_TRUE(edge.proven);
    EXPECT_NEAR(edge.found->angle.value, kPi / 2, 1e-14);
    EXPECT_NEAR(edge.bounds->angle, kPi / 2, 1e-10);
    EXPECT_LE(edge.bounds->gap, 1e-13);
    EXPECT_EQ(edge.faces.size(), 2u);
  }
}

TEST(EdgeContinuity, SeamOfACylinderIsG2AndItsRimsAreSharp) {
  const auto edges = edge_continuity(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  ASSERT_EQ(edges.size(), 3u);
  const auto seams = of_kind(edges, EdgeRole::Seam);
  ASSERT_EQ(seams.size(), 1u);
  EXPECT_EQ(seams[0].smoothness, Smoothness::G2);
  EXPECT_TRUE(seams[0].proven) << seams[0].no_bounds;
  EXPECT_LE(seams[0].bounds->curvature, 1e-9);
  for (const EdgeContinuity& rim : of_kind(edges, EdgeRole::Shared)) {
    EXPECT_NEAR(rim.found->angle.value, kPi / 2, 1e-13);
    EXPECT_TRUE(rim.proven) << rim.no_bounds;
  }
}

TEST(EdgeContinuity, PolesOfASphereAreNotCompared) {
  const auto edges = edge_continuity(BRepPrimAPI_MakeSphere(3).Shape());
  EXPECT_EQ(of_kind(edges, EdgeRole::Degenerate).size(), 2u);
  const auto seams = of_kind(edges, EdgeRole::Seam);
  ASSERT_EQ(seams.size(), 1u);
  EXPECT_EQ(seams[0].smoothness, Smoothness::G2);
  EXPECT_FALSE(seams[0].proven);
}

TEST(EdgeContinuity, FilletOfABoxIsG1AndApartByItsCurvature) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  fillet.Add(2, TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current()));
  const auto smooth = smooth_edges(fillet.Shape());
  ASSERT_EQ(smooth.size(), 2u);
  for (const EdgeContinuity& edge : smooth) {
    EXPECT_EQ(edge.smoothness, Smoothness::G1);
    EXPECT_TRUE(edge.proven) << edge.no_bounds;
    EXPECT_NEAR(edge.found->difference.value, 0.5, 1e-12);
    EXPECT_NEAR(edge.bounds->difference, 0.5, 1e-8);
    EXPECT_NEAR(edge.found->curvature.value, 1, 1e-12);
  }
}

TEST(EdgeContinuity, TorusFilletOfACylinderIsProvenToBeG1) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  BRepFilletAPI_MakeFillet fillet(cylinder);
  for (TopExp_Explorer it(cylinder, TopAbs_EDGE); it.More(); it.Next())
    if (!BRep_Tool::IsClosed(TopoDS::Edge(it.Current()),
                             TopoDS::Face(TopExp_Explorer(cylinder, TopAbs_FACE).Current()))) {
      fillet.Add(1, TopoDS::Edge(it.Current()));
      break;
    }
  int rims = 0;
  for (const EdgeContinuity& edge : smooth_edges(fillet.Shape())) {
    if (edge.kind != EdgeRole::Shared) continue;
    ++rims;
    EXPECT_EQ(edge.smoothness, Smoothness::G1);
    EXPECT_TRUE(edge.proven) << edge.no_bounds;
    EXPECT_LE(edge.bounds->angle, 1e-9);
    EXPECT_NEAR(edge.found->difference.value, 1, 1e-9);
  }
  EXPECT_EQ(rims, 2);
}

TEST(EdgeContinuity, BicubicCutInTwoIsProvenToBeG2) {
  const auto surface = graph(0, 0, wave);
  double u0, u1, v0, v1;
  surface->Bounds(u0, u1, v0, v1);
  const double cut = 0.4 * u0 + 0.6 * u1;
  const EdgeContinuity edge =
      the_shared(sewn({face_over(surface, u0, cut, v0, v1), face_over(surface, cut, u1, v0, v1)}));
  EXPECT_EQ(edge.smoothness, Smoothness::G2);
  EXPECT_TRUE(edge.proven) << edge.no_bounds;
  EXPECT_LE(edge.bounds->gap, 1e-11);
  EXPECT_LE(edge.bounds->angle, 1e-9);
  EXPECT_LE(edge.bounds->curvature, 1e-6);
}

/// Two parabolic sheets that meet with one tangent plane at y = 1, curved by `a` and by `b`.
Handle(Geom_BSplineSurface) kinked(double a, double b) {
  TColgp_Array2OfPnt poles(1, 2, 1, 5);
  TColStd_Array1OfReal u(1, 2), v(1, 3);
  TColStd_Array1OfInteger mu(1, 2), mv(1, 3);
  for (int i = 1; i <= 2; ++i) {
    poles(i, 1) = gp_Pnt(i, 0, a / 2);
    poles(i, 2) = gp_Pnt(i, 0.5, 0);
    poles(i, 3) = gp_Pnt(i, 1, 0);
    poles(i, 4) = gp_Pnt(i, 1.5, 0);
    poles(i, 5) = gp_Pnt(i, 2, b / 2);
    u(i) = i - 1;
    mu(i) = 2;
  }
  for (int k = 1; k <= 3; ++k) {
    v(k) = k - 1;
    mv(k) = k == 2 ? 2 : 3;
  }
  return new Geom_BSplineSurface(poles, u, v, mu, mv, 1, 2);
}

TEST(EdgeContinuity, CutAlongAKnotSeesBothSidesOfIt) {
  const auto surface = kinked(0.5, -0.3);
  const EdgeContinuity edge =
      the_shared(sewn({face_over(surface, 0, 1, 0, 1), face_over(surface, 0, 1, 1, 2)}));
  EXPECT_EQ(edge.smoothness, Smoothness::G1);
  EXPECT_NEAR(edge.found->difference.value, 0.8, 1e-12);
  EXPECT_NEAR(edge.found->curvature.value, 0.8 / 0.5, 1e-12);
  EXPECT_TRUE(edge.proven);
}

TEST(EdgeContinuity, StripsGoOnFromBothFaces) {
  const auto a = graph(0, 0, wave);
  const auto b = graph(2, 0.1, [](double x, double y) { return 0.5 + wave(y, x); });
  const TopoDS_Face first = BRepBuilderAPI_MakeFace(a, 1e-7),
                    second = BRepBuilderAPI_MakeFace(b, 1e-7);
  const FaceStrip strip = strip_between(first, second);
  const auto edges = of_kind(edge_continuity(sewn({first, strip.face, second})), EdgeRole::Shared);
  ASSERT_EQ(edges.size(), 2u);
  for (const EdgeContinuity& edge : edges) {
    EXPECT_EQ(edge.smoothness, Smoothness::G1);
    EXPECT_TRUE(edge.proven) << edge.no_bounds;
    EXPECT_LE(edge.found->angle.value, 1e-9);
    EXPECT_LE(edge.bounds->angle, 1e-8);
  }
}

TEST(EdgeContinuity, FilletOfAFreeFormEdgeByOpenCascadeIsOffByMoreThanRounding) {
  // A block under a wavy top; the edge between top and front is filleted.
  const auto top = graph(0, 0, wave);
  const TopoDS_Face lid = BRepBuilderAPI_MakeFace(top, 1e-7);
  // The front shares the top's border y = 0: its points, moved down and outwards.
  TColgp_Array2OfPnt poles(1, top->NbUPoles(), 1, 3);
  for (int i = 1; i <= top->NbUPoles(); ++i) {
    const gp_Pnt p = top->Pole(i, 1);
    poles(i, 1) = p;
    poles(i, 2) = p.Translated({0, -0.1 * std::sin(i), -0.5});
    poles(i, 3) = p.Translated({0, 0.1, -1});
  }
  TColStd_Array1OfReal knots(1, 2);
  TColStd_Array1OfInteger multiplicities(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  multiplicities.Init(3);
  TColStd_Array1OfReal u(1, top->NbUKnots());
  TColStd_Array1OfInteger mu(1, top->NbUKnots());
  top->UKnots(u);
  top->UMultiplicities(mu);
  const Handle(Geom_BSplineSurface) wall =
      new Geom_BSplineSurface(poles, u, knots, mu, multiplicities, top->UDegree(), 2);
  const TopoDS_Shape both = sewn({lid, BRepBuilderAPI_MakeFace(wall, 1e-7)});
  const EdgeContinuity sharp = the_shared(both);
  EXPECT_EQ(sharp.smoothness, Smoothness::G0);
  BRepFilletAPI_MakeFillet fillet(both);
  fillet.Add(0.05, sharp.edge);
  fillet.Build();
  ASSERT_TRUE(fillet.IsDone());
  double most = 0;
  int rims = 0;
  for (const EdgeContinuity& edge : smooth_edges(fillet.Shape())) {
    if (edge.kind != EdgeRole::Shared) continue;
    ++rims;
    most = std::max(most, edge.found->angle.value);
    EXPECT_EQ(edge.smoothness, Smoothness::G1);
    EXPECT_FALSE(edge.proven);
    EXPECT_NE(edge.no_bounds, "");
    EXPECT_GT(edge.found->samples, 90);
  }
  EXPECT_GE(rims, 2);
  EXPECT_GT(most, 1e-6);
  EXPECT_LT(most, 1e-3);
}

/// Two squares side by side, the second higher by `gap`, that share an edge of that tolerance.
TopoDS_Shape stepped(double gap) {
  const auto square = [](double y, double z) {
    TColgp_Array2OfPnt poles(1, 2, 1, 2);
    for (int i = 1; i <= 2; ++i)
      for (int j = 1; j <= 2; ++j) poles(i, j) = gp_Pnt(i - 1, y + j - 1, z);
    return Handle(Geom_BezierSurface)(new Geom_BezierSurface(poles));
  };
  return sewn({BRepBuilderAPI_MakeFace(square(0, 0), 1e-7).Face(),
               BRepBuilderAPI_MakeFace(square(1, gap), 1e-7).Face()},
              2 * gap + 1e-6);
}

TEST(EdgeContinuity, GapIsThatBetweenTheFaces) {
  for (const double gap : {1e-5, 1e-2}) {
    const EdgeContinuity edge = the_shared(stepped(gap));
    EXPECT_NEAR(edge.found->gap.value, gap, 1e-12);
    EXPECT_EQ(edge.smoothness, gap < 1e-3 ? Smoothness::G2 : Smoothness::None);
  }
  EXPECT_EQ(the_shared(stepped(1e-2), {.tolerances = {.gap = 0.02}}).smoothness, Smoothness::G2);
}

TEST(EdgeContinuity, OffsetSurfacesAreSampledAndSaidToBe) {
  const Handle(Geom_Surface) offset = new Geom_OffsetSurface(graph(0, 0, wave), 0.05);
  double u0, u1, v0, v1;
  offset->Bounds(u0, u1, v0, v1);
  const double cut = (u0 + u1) / 2;
  const EdgeContinuity edge =
      the_shared(sewn({face_over(offset, u0, cut, v0, v1), face_over(offset, cut, u1, v0, v1)}));
  EXPECT_EQ(edge.smoothness, Smoothness::G2);
  EXPECT_FALSE(edge.proven);
  EXPECT_NE(edge.no_bounds, "");
}

TEST(EdgeContinuity, EdgesOfOneAndOfThreeFacesAreNamed) {
  const auto leaf = [](double angle) {
    const gp_Ax3 axes(gp_Pnt(0, 0, 0), gp_Dir(-std::sin(angle), std::cos(angle), 0),
                      gp_Dir(std::cos(angle), std::sin(angle), 0));
    return face_over(new Geom_Plane(axes), 0, 1, 0, 1);
  };
  const auto edges = edge_continuity(sewn({leaf(0), leaf(2), leaf(4)}));
  EXPECT_EQ(of_kind(edges, EdgeRole::NonManifold).size(), 1u);
  EXPECT_EQ(of_kind(edges, EdgeRole::Open).size(), 9u);
  for (const EdgeContinuity& edge : edges) EXPECT_FALSE(edge.found.has_value());
}

TEST(EdgeContinuity, ChosenFacesHaveOnlyTheEdgesBetweenThem) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  EXPECT_EQ(edge_continuity(box, {.faces = {1}}).size(), 0u);
  EXPECT_EQ(edge_continuity(box, {.faces = {1, 2}}).size(), 0u);  // opposite ones
  EXPECT_EQ(edge_continuity(box, {.faces = {1, 3}}).size(), 1u);
}

TEST(EdgeContinuity, EdgeWithoutACurveOnAFaceIsAProblemOfThatEdgeAlone) {
  const auto surface = graph(0, 0, wave);
  double u0, u1, v0, v1;
  surface->Bounds(u0, u1, v0, v1);
  const double cut = (u0 + u1) / 2;
  TopoDS_Shape both =
      sewn({face_over(surface, u0, cut, v0, v1), face_over(surface, cut, u1, v0, v1)});
  const TopoDS_Edge edge = the_shared(both).edge;
  const TopoDS_Face face = TopoDS::Face(TopExp_Explorer(both, TopAbs_FACE).Current());
  BRep_Builder().UpdateEdge(edge, Handle(Geom2d_Curve)(), face, 1e-7);
  const auto shared = of_kind(edge_continuity(both), EdgeRole::Shared);
  ASSERT_EQ(shared.size(), 1u);
  EXPECT_FALSE(shared[0].found.has_value());
  EXPECT_NE(shared[0].problem.find("no curve"), std::string::npos) << shared[0].problem;
}

TEST(EdgeContinuity, ScaledMirroredAndReversedShapesHaveTheSameFigures) {
  const auto a = graph(0, 0, wave);
  const auto b = graph(2, 0.1, [](double x, double y) { return 0.5 + wave(y, x); });
  const TopoDS_Face first = BRepBuilderAPI_MakeFace(a, 1e-7),
                    second = BRepBuilderAPI_MakeFace(b, 1e-7);
  const TopoDS_Shape shape = sewn({first, strip_between(first, second).face, second});
  const auto expected = edge_continuity(shape);
  const auto check = [&](const TopoDS_Shape& other, double factor) {
    const auto edges = edge_continuity(other);
    ASSERT_EQ(edges.size(), expected.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      ASSERT_EQ(edges[i].kind, expected[i].kind);
      if (!edges[i].found) continue;
      EXPECT_EQ(edges[i].smoothness, expected[i].smoothness);
      EXPECT_NEAR(edges[i].found->difference.value * factor, expected[i].found->difference.value,
                  1e-6 * expected[i].found->difference.value);
      EXPECT_NEAR(edges[i].found->angle.value, expected[i].found->angle.value, 1e-9);
    }
  };
  check(shape.Reversed(), 1);
  for (const double factor : {1e-3, 1e3}) {
    gp_Trsf scale;
    scale.SetScale(gp_Pnt(1, 2, 3), factor);
    check(BRepBuilderAPI_Transform(shape, scale, true).Shape(), factor);
  }
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 2, 3)));
  check(BRepBuilderAPI_Transform(shape, mirror, true).Shape(), 1);
}

TEST(EdgeContinuity, MirroredPlanesAreStillProven) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
  for (const EdgeContinuity& edge : edge_continuity(
           BRepBuilderAPI_Transform(BRepPrimAPI_MakeCylinder(2, 5).Shape(), mirror, true)
               .Shape())) {
    EXPECT_TRUE(edge.proven) << edge.no_bounds;
    EXPECT_EQ(edge.smoothness, edge.kind == EdgeRole::Seam ? Smoothness::G2 : Smoothness::G0);
    if (edge.kind == EdgeRole::Shared) {
      EXPECT_NEAR(edge.found->angle.value, kPi / 2, 1e-13);
    }
  }
}

TEST(EdgeContinuity, WorkStopsWhereTheTickThrows) {
  const auto stop = [] { throw std::length_error("stop"); };
  EXPECT_THROW(edge_continuity(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), {.tick = stop}),
               std::length_error);
}

}  // namespace
}  // namespace blossom::occt
