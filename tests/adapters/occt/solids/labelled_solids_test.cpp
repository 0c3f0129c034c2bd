// SPDX-License-Identifier: LGPL-2.1-or-later
// What faces are called on their way through an operation.
#include "adapters/occt/solids/labelled_solids.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/base/compounds.h"

namespace blossom::occt {
namespace {

TopoDS_Shape box_at(double x) { return BRepPrimAPI_MakeBox(gp_Pnt(x, 0, 0), 1, 1, 1).Shape(); }

TEST(LabelledSolids, CallFacesAsTheirInputsDo) {
  const TrimTool part = trim_tool(compound_of(std::vector<TopoDS_Shape>{box_at(0), box_at(3)}));
  const TrimTool first = trim_tool(box_at(0.5)), second = trim_tool(box_at(3.5));
  const InputFaceNames names = names_of_faces(part, {first, second});
  EXPECT_EQ(names[0].back(), "face 12 of the part");
  EXPECT_EQ(names[2].front(), "face 1 of tool 2");
  EXPECT_EQ(names_of_faces(part, {first})[1].front(), "face 1 of the tool");

  std::vector<SolidFace> known;
  for (const TopoDS_Face& face : part.faces)
    known.push_back({face, -1, static_cast<int>(known.size())});
  const LabelledSolid made = labelled({part.solids[1]}, known, names);
  EXPECT_EQ(face_name(made.solid, 0, "the part"), "face 7 of the part");
}

TEST(LabelledSolids, CountAllFacesOfAShape) {
  TrimTool some = trim_tool(box_at(0));
  some.places = {10, 11, 12, 13, 14, 15};
  EXPECT_EQ(face_name(some, 1, "the tool"), "face 12 of the tool");
}

}  // namespace
}  // namespace blossom::occt
