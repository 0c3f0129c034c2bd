// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/loose_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/repair/repair.h"
#include "adapters/occt/shapes.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

// A cylinder's face, and the circle that ends it.
struct Rim {
  TopoDS_Shape solid = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  TopoDS_Face face;
  TopoDS_Edge edge;

  Rim() {
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
      if (GeomAdaptor_Surface(BRep_Tool::Surface(TopoDS::Face(it.Current()))).GetType() ==
          GeomAbs_Cylinder)
        face = TopoDS::Face(it.Current());
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      if (!BRep_Tool::IsClosed(TopoDS::Edge(it.Current()), face)) edge = TopoDS::Edge(it.Current());
  }

  Handle(Geom2d_Curve) chart() const {
    double first = 0, last = 0;
    return BRep_Tool::CurveOnSurface(edge, face, first, last);
  }

  // Moves the curve in the parameters along the face, with the tolerance that covers it.
  void loosen(double by) {
    const Handle(Geom2d_Curve) moved =
        Handle(Geom2d_Curve)::DownCast(chart()->Translated(gp_Vec2d(0, by)));
    BRep_Builder().UpdateEdge(edge, moved, face, 1.1 * by);
    for (TopExp_Explorer it(edge, TopAbs_VERTEX); it.More(); it.Next())
      BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), 1.1 * by);
  }
};

std::vector<Repairs::RemadeCurve> remade_in(const TopoDS_Shape& shape) {
  return Repairer(shape, StatedTolerances::Kept).repair_all({}).remade;
}

TEST(LooseImages, AreMadeAnewFromCurvesInSpaceThatLieOnTheFace) {
  const Rim given;
  Rim loose;
  loose.loosen(0.01);
  const std::vector<Repairs::RemadeCurve> made = remade_in(loose.solid);
  ASSERT_EQ(made.size(), 1U);
  EXPECT_NEAR(made.front().gap, 0.01, 1e-12);
  EXPECT_LE(BRep_Tool::Tolerance(loose.edge), 1e-6);
  EXPECT_TRUE(BRepCheck_Analyzer(loose.solid).IsValid());
  for (const double t : {0.0, 1.0, 3.0, 6.2})
    EXPECT_LE(loose.chart()->Value(t).Distance(given.chart()->Value(t)), 1e-6) << t;
}

TEST(LooseImages, AreLeftWhereTheyAreSmall) {
  Rim loose;
  loose.loosen(1e-5);
  EXPECT_TRUE(remade_in(loose.solid).empty());
  EXPECT_TRUE(remade_in(Rim().solid).empty());
}

// 196 curves up to 0.06 off edges that lie on both faces within 3e-5.
TEST(LooseImages, LeaveNoGapsInAModelWhoseReaderMadeThem) {
  const char* const folder = blossom::testing::test_data();
  if (folder == nullptr) GTEST_SKIP() << blossom::testing::kNoTestData;
  Model model = read_model(std::string(folder) + "/models/boxed_sphere.step");
  EXPECT_EQ(model.repair().remade.size(), 196U);
  double largest = 0;
  for (TopExp_Explorer it(model.shape(), TopAbs_EDGE); it.More(); it.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
  EXPECT_LE(largest, 1e-3);
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
}

}  // namespace
}  // namespace blossom::occt
