// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies with blends are the same for whoever reads them from a STEP file.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

// A disc with a hole aslant: its strips are closed splines, in either direction of their edges.
TopoDS_Shape bored_disc() {
  const TopoDS_Shape disc = BRepPrimAPI_MakeCone(10.86, 7.13, 17.16).Shape();
  const gp_Ax2 aslant(gp_Pnt(0, 0, -10), gp_Dir(-0.04, -0.08, 1));
  return BRepAlgoAPI_Cut(disc, BRepPrimAPI_MakeCylinder(aslant, 1.88, 40).Shape()).Shape();
}

TEST(BlendsInStepFiles, ClosedStripsStayPartsOfOneSolid) {
  const testing::Folder folder;
  const TopoDS_Shape disc = bored_disc();
  std::vector<int> sharp;
  for (const EdgeFacts& each : edge_facts(disc))
    if (each.kind == EdgeKind::Convex) sharp.push_back(each.number);
  ASSERT_EQ(sharp.size(), 4U);
  const FilletResult made = fillet(disc, sharp, {.radius = 0.2});
  ASSERT_EQ(made.solids.size(), 1U);

  Model model;
  model.add(made.solids.front().solid, "disc");
  write_model(model, folder / "disc.step");
  STEPControl_Reader reader;
  ASSERT_EQ(reader.ReadFile((folder / "disc.step").c_str()), IFSelect_RetDone);
  reader.TransferRoots();
  const TopoDS_Shape read = reader.OneShape();

  EXPECT_TRUE(BRepCheck_Analyzer(read).IsValid());
  for (const auto kind : {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE, TopAbs_EDGE})
    EXPECT_EQ(count(read, kind), count(made.solids.front().solid, kind));
  GProp_GProps properties;
  BRepGProp::VolumeProperties(read, properties, 1e-9);
  EXPECT_NEAR(properties.Mass(), made.solids.front().volume, 1e-6 * properties.Mass());
}

}  // namespace
}  // namespace blossom::occt
