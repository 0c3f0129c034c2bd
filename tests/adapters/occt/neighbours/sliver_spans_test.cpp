// SPDX-License-Identifier: LGPL-2.1-or-later
// Spans as narrow as an edge is exact do not keep a face from being decided.

#include "core/neighbours/sliver_spans.h"

#include <gtest/gtest.h>

#include <numbers>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>

#include "adapters/occt/faces/face_data.h"
#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

constexpr double kNarrow = 1e-8;  // the first span's parameters
constexpr double kSwing = 3e-6;   // by which its poles go to and fro along the circle
constexpr int kDegree = 5;

// A tube of radius 10 whose circle begins with a narrow span that goes to and fro.
Handle(Geom_BSplineSurface) tube_with_sliver() {
  const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2(), 10);
  const Handle(Geom_BSplineCurve) round =
      GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(circle, 0, 2 * std::numbers::pi));
  round->IncreaseDegree(kDegree);
  const int poles = round->NbPoles() + kDegree, spans = round->NbKnots();
  TColgp_Array2OfPnt points(1, 2, 1, poles);
  TColStd_Array2OfReal weights(1, 2, 1, poles);
  for (int row = 1; row <= 2; ++row)
    for (int i = 1; i <= poles; ++i) {
      const bool of_sliver = i <= kDegree;
      gp_Pnt p = round->Pole(of_sliver ? 1 : i - kDegree);
      if (of_sliver && i > 1) p.SetY(i % 2 == 0 ? kSwing : -kSwing);
      p.SetZ(row == 1 ? 0 : 4);
      points(row, i) = p;
      weights(row, i) = round->Weight(of_sliver ? 1 : i - kDegree);
    }
  TColStd_Array1OfReal u(1, 2), v(1, spans + 1);
  TColStd_Array1OfInteger of_u(1, 2), of_v(1, spans + 1);
  u(1) = 0, u(2) = 1;
  of_u.Init(2);
  v(1) = -kNarrow, of_v(1) = kDegree + 1;
  for (int i = 1; i <= spans; ++i) {
    v(i + 1) = round->Knot(i);
    of_v(i + 1) = i == 1 ? kDegree : round->Multiplicity(i);
  }
  return new Geom_BSplineSurface(points, weights, u, v, of_u, of_v, 1, kDegree);
}

TopoDS_Face tube_face(double seam_tolerance) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(tube_with_sliver(), 1e-7).Face();
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::IsClosed(edge, face)) BRep_Builder().UpdateEdge(edge, seam_tolerance);
  }
  return face;
}

TEST(SliverSpans, AreTheSeamWithinItsTolerance) {
  const auto rest = without_sliver_spans(face_data(tube_face(1e-5), 1e-7));
  ASSERT_TRUE(rest.has_value());
  EXPECT_EQ(rest->surface.v_knots.front(), 0);
  EXPECT_NEAR(rest->within, kSwing, 1e-12);
}

TEST(SliverSpans, KeepNoFaceFromBeingProvenNotToMeetItself) {
  const auto found = self_intersect({tube_face(1e-5)}, SelfScope::EachFace);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_EQ(found.certificate.identified, 1);
  EXPECT_NEAR(found.certificate.identified_within, kSwing, 1e-12);
}

TEST(SliverSpans, AreNoneWhereTheSeamIsMoreExactThanThey) {
  const TopoDS_Face face = tube_face(1e-7);
  EXPECT_FALSE(without_sliver_spans(face_data(face, 1e-7)).has_value());
  EXPECT_NE(self_intersect({face}, SelfScope::EachFace).status, Status::Complete);
}

}  // namespace
}  // namespace blossom::occt
