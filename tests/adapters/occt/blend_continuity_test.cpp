// SPDX-License-Identifier: LGPL-2.1-or-later
// What other steps of Open CASCADE can do with blends: they refuse surfaces that are only C0, and
// measure them badly.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_MakeOffsetShape.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

void expect_c1(const FilletResult& made) {
  testing::expect_sound(made);
  for (TopExp_Explorer it(made.solids.front().solid, TopAbs_FACE); it.More(); it.Next()) {
    const auto spline =
        Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(it.Current())));
    if (!spline.IsNull()) {
      EXPECT_GE(spline->Continuity(), GeomAbs_C1);
    }
  }
}

std::vector<int> sharp_edges(const TopoDS_Shape& shape) {
  std::vector<int> edges;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Convex) edges.push_back(each.number);
  return edges;
}

// Circles over each other; the side leans so far that sections of its upper fillet are wide.
TopoDS_Shape vase() {
  BRepOffsetAPI_ThruSections maker(true);
  for (const auto& [height, radius] : {std::pair{0.0, 20.0}, {25.0, 12.0}, {60.0, 25.0}})
    maker.AddWire(BRepBuilderAPI_MakeWire(
        BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({0, 0, height}, {0, 0, 1}), radius))));
  maker.Build();
  return maker.Shape();
}

TEST(BlendContinuity, OfWideFilletsIsThatOfTheirFaces) {
  const TopoDS_Shape body = vase();
  const FilletResult made = fillet(body, sharp_edges(body), {.radius = 4});
  expect_c1(made);
  GProp_GProps of_occt;
  BRepGProp::VolumeProperties(made.solids.front().solid, of_occt);
  EXPECT_NEAR(of_occt.Mass(), made.solids.front().volume, 1e-7 * made.solids.front().volume);
  BRepOffsetAPI_MakeOffsetShape offset;
  offset.PerformByJoin(made.solids.front().solid, 1, 1e-3);
  EXPECT_TRUE(offset.IsDone());
}

TEST(BlendContinuity, OfChamfersIsC1AlongFittedEdges) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10).Shape();
  const TopoDS_Shape bored =
      BRepAlgoAPI_Cut(ball, BRepPrimAPI_MakeCylinder(gp_Ax2({3, 0, -20}, {0, 0, 1}), 4, 40).Shape())
          .Shape();
  FilletOptions options;
  options.chamfer = ChamferSize{1};
  expect_c1(fillet(bored, sharp_edges(bored), options));
}

}  // namespace
}  // namespace blossom::occt
