// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets of turned, moved and scaled bodies, and of the same faces in another order.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

using testing::told;

TopoDS_Wire rectangle(double inset, double z) {
  BRepBuilderAPI_MakePolygon made;
  made.Add({inset, inset, z});
  made.Add({60 - inset, inset, z});
  made.Add({60 - inset, 50 - inset, z});
  made.Add({inset, 50 - inset, z});
  made.Close();
  return made.Wire();
}

// Its walls lean by 4 degrees, and are splines.
TopoDS_Shape drafted_block() {
  BRepOffsetAPI_ThruSections loft(Standard_True, Standard_True);
  loft.AddWire(rectangle(0, 0));
  loft.AddWire(rectangle(30 * std::tan(4 * std::numbers::pi / 180), 30));
  return loft.Shape();
}

// Edges of about 40, 68 and 72 degrees, along which arcs of strips are of up to 140.
TopoDS_Shape sharp_prism() {
  BRepBuilderAPI_MakePolygon made({0, 0, 0}, {80, 0, 0}, {60, 50, 0}, Standard_True);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(made.Wire()).Face(), gp_Vec(10, 5, 40));
}

TopoDS_Shape with_faces_reversed_in_order(const TopoDS_Shape& of) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(of, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (std::size_t i = faces.size(); i-- > 0;) builder.Add(shell, faces[i]);
  shell.Closed(Standard_True);
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

// What all edges take, each with a radius of its own, in units of a body of that size; `of` has
// edges of the body, or of a copy of it, in the order of the body's numbers.
double taken(const TopoDS_Shape& body, const std::vector<TopoDS_Edge>& of, double size) {
  TopTools_IndexedMapOfShape numbers;
  TopExp::MapShapes(body, TopAbs_EDGE, numbers);
  std::vector<int> edges;
  FilletOptions options{.radius = 4 * size, .largest = false};
  for (std::size_t i = 0; i < of.size(); ++i) {
    edges.push_back(numbers.FindIndex(of[i]));
    options.own[edges.back()] = {size * (2 + 0.2 * static_cast<double>(i % 11)), {}};
  }
  const FilletResult made = fillet(body, edges, options);
  EXPECT_EQ(made.solids.size(), 1U) << told(made);
  if (made.solids.empty()) return 0;
  EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front().solid).IsValid());
  return (made.volume_before - made.solids.front().volume) / (size * size * size);
}

std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& body) {
  std::vector<TopoDS_Edge> all;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(body, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) all.push_back(TopoDS::Edge(edges(i)));
  return all;
}

TEST(FilletOfAllEdges, IsTheSameOfTurnedMovedAndScaledBodies) {
  const TopoDS_Shape wedge = BRepPrimAPI_MakeWedge(60, 40, 50, 15, 10, 45, 35).Shape();
  for (const TopoDS_Shape& body : {drafted_block(), wedge, sharp_prism()}) {
    const double volume = taken(body, edges_of(body), 1);
    EXPECT_NEAR(taken(with_faces_reversed_in_order(body), edges_of(body), 1), volume,
                1e-9 * volume);
    gp_Trsf turn, move, small, large;
    turn.SetRotation(gp_Ax1({1, 2, 3}, {3, -1, 2}), 0.7);
    move.SetTranslation({120, -45, 300});
    small.SetScale(gp::Origin(), 1e-3);
    large.SetScale(gp::Origin(), 1e3);
    for (const gp_Trsf& each : {turn, move, small, large}) {
      SCOPED_TRACE(each.ScaleFactor());
      const TopoDS_Shape copy = BRepBuilderAPI_Transform(body, each, Standard_True).Shape();
      EXPECT_NEAR(taken(copy, edges_of(copy), each.ScaleFactor()), volume, 1e-6 * volume);
    }
  }
}

}  // namespace
}  // namespace blossom::occt
