// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids are valid where BRepCheck says so of all but the faces that were given.
#include "adapters/occt/solids/validity/solid_validity.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"

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

// A tube without a pipe through it, whose side touches the tube's seam where patches of both end.
// At the tolerance asked for a solid comes out of it that is not valid.
TEST(SolidValidity, IsAskedForAtEveryWayOfDividing) {
  const char* const folder = std::getenv("BLOSSOM_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "BLOSSOM_TEST_DATA is not set";
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
