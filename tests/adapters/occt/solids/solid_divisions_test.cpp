// SPDX-License-Identifier: LGPL-2.1-or-later
// How often two solids are looked at.
#include <gtest/gtest.h>

#include <optional>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <ShapeFix_ShapeTolerance.hxx>

#include "adapters/occt/solids/solid_divisions.h"

namespace blossom::occt {
namespace {

// Whatever they lead to, at what is asked for and at what faces state. Another tolerance is told:
// that of all but the first and the third reading.
TEST(SolidDivisions, AreAtMostTwoReadingsOfThreeLooks) {
  for (const double stated : {1e-7, 1e-5}) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 2, 2).Shape();
    const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(1, 3).Shape();
    ShapeFix_ShapeTolerance().SetTolerance(box, stated);
    const TrimTool a = trim_tool(box), b = trim_tool(rod);
    const IntersectionOptions options;
    SolidDivisions divisions(a, b, 0, options);
    int readings = 0;
    while (const std::optional<SolidPieces> pieces = divisions.next()) {
      EXPECT_TRUE(pieces->obstacles.empty()) << readings;
      EXPECT_EQ(pieces->merged.empty(), readings == 0 || readings == 2) << readings;
      ++readings;
    }
    EXPECT_LE(readings, 6);
    EXPECT_GE(readings, 4);
  }
}

// Once there is no time left there is still the first answer, and no other.
TEST(SolidDivisions, EndWithTheLimit) {
  const TrimTool a = trim_tool(BRepPrimAPI_MakeBox(2, 2, 2).Shape());
  const TrimTool b = trim_tool(BRepPrimAPI_MakeCylinder(1, 3).Shape());
  IntersectionOptions options;
  options.cancelled = [] { return true; };
  SolidDivisions divisions(a, b, 0, options);
  const std::optional<SolidPieces> first = divisions.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->status, Status::Stopped);
  EXPECT_FALSE(divisions.next());
}

}  // namespace
}  // namespace blossom::occt
