// SPDX-License-Identifier: LGPL-2.1-or-later
// Compounds in compounds: as deep as no model is, so that hostile files take no time.

#include <gtest/gtest.h>

#include <string>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::Folder;

TopoDS_Shape nested(TopoDS_Shape shape, int levels) {
  for (int i = 0; i < levels; ++i) {
    TopoDS_Compound around;
    BRep_Builder builder;
    builder.MakeCompound(around);
    builder.Add(around, shape);
    shape = around;
  }
  return shape;
}

TEST(NestedShapes, AreReadUpToAThousandLevels) {
  const Folder folder;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  BRepTools::Write(nested(box, 999), (folder / "deep.brep").c_str());
  EXPECT_EQ(read_model(folder / "deep.brep").face_count(), 6);
  BRepTools::Write(nested(box, 1000), (folder / "deeper.brep").c_str());
  try {
    read_model(folder / "deeper.brep");
    FAIL() << "is not refused";
  } catch (const BadModel& error) {
    EXPECT_TRUE(std::string(error.what()).ends_with("nested more than 1000 deep")) << error.what();
  }
}

}  // namespace
}  // namespace blossom::occt
