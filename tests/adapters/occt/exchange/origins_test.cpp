// SPDX-License-Identifier: LGPL-2.1-or-later
// Names and colours of parts that were made of other models' faces.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::Folder;
using testing::story;

// A slot across the plate of the machine: its red top comes in two, the slot is blue as the bar.
TEST(ShapesOrigins, FacesOfACombinedSolidLookLikeThoseTheyComeFrom) {
  const Folder folder;
  testing::write_machine(folder / "machine.step");
  const Model machine = read_model(folder / "machine.step");
  Model bar;
  bar.add(BRepPrimAPI_MakeBox(gp_Pnt(10, -5, 5), gp_Pnt(15, 35, 20)).Shape(), "Bar", {0, 0, 1});
  const TopoDS_Shape plate = TopExp_Explorer(machine.shape(), TopAbs_SOLID).Current();
  const SolidTrimResult made =
      trim_solids(trim_tool(plate), {trim_tool(bar.shape())}, SolidOperation::Cut);
  ASSERT_EQ(made.solids.size(), 1u);
  ASSERT_EQ(made.faces.size(), 10u);  // two of the top, five others, three of the slot
  std::vector<FaceOrigin> origins;
  for (const SolidFace& face : made.faces)
    origins.push_back({face.face, face.tool >= 0 ? &bar : &machine, face.from + 1});

  Model result;
  result.add_combined(made.solids[0], machine.part_name(1), origins);
  write_model(result, folder / "slotted.step");

  EXPECT_EQ(machine.part_name(1), "Base plate");
  EXPECT_EQ(machine.part_name(18), "Pin");
  const std::vector<std::string> names = read_model(folder / "slotted.step").face_names();
  const auto count = [&](const std::string& name) {
    return std::count(names.begin(), names.end(), name);
  };
  EXPECT_EQ(count("TopFace.1"), 1);
  EXPECT_EQ(count("TopFace.2"), 1);
  EXPECT_EQ(count("TopFace"), 0);
  EXPECT_EQ(count("SideFace"), 1);
  EXPECT_EQ(story(folder / "slotted.step"),
            "in millimetre\n"
            "Base plate 0.000..40.000 0.000..30.000 0.000..10.000 valid\n"
            "  * - #0000FF\n  * - #0000FF\n  * - #0000FF\n"
            "  * - #3366CC\n  * - #3366CC\n  * - #3366CC\n  * - #3366CC\n"
            "  * SideFace #00FF00\n  * TopFace.1 #FF0000\n  * TopFace.2 #FF0000\n");
}

TEST(ShapesOrigins, RejectFacesThatAreNotThere) {
  Model box, result;
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  box.add(shape, "Box");
  EXPECT_EQ(box.part_name(6), "Box");
  EXPECT_THROW(box.part_name(7), BadModel);
  EXPECT_THROW(result.add_combined(shape, "New", {{box.face(1), &box, 7}}), BadModel);
}

}  // namespace
}  // namespace blossom::occt
