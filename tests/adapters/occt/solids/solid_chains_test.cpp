// SPDX-License-Identifier: LGPL-2.1-or-later
// Results of results: solids on a grid, put together and cut again and again, so that the part
// comes to touch itself along edges and in walls, and has ever more faces, edges and seams.
//
// A chain is named by its seed. BLOSSOM_TRIALS sets how many there are, BLOSSOM_SEED the first;
// what goes wrong is written to the working folder as chain_SEED_{a,b}.brep.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <numbers>
#include <string>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/solids/random_solids.h"
#include "tests/support/random.h"

namespace blossom::occt {
namespace {

constexpr int kChainSteps = 10;

double volume_of(const TopoDS_Shape& shape) {
  double sum = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    sum += cone_volume(TopoDS::Face(it.Current()), {0, 0, 0});
  return sum;
}

struct Made {
  TopoDS_Shape shape;
  std::string fault;
};

Made combined(const TopoDS_Shape& a, const TopoDS_Shape& b, SolidOperation operation) {
  const SolidTrimResult made = trim_solids(trim_tool(a), {trim_tool(b)}, operation);
  if (!made.obstacles.empty()) return {{}, made.obstacles.front()};
  const TopoDS_Shape shape = compound_of(made.solids);
  return {shape, testing::unsound(shape)};
}

// What is wrong with a step, whose volume is told by that of what both have in common as well.
std::string fault_of(const Made& made, const TopoDS_Shape& a, const TopoDS_Shape& b, bool fuse) {
  if (!made.fault.empty()) return made.fault;
  const Made common = combined(a, b, SolidOperation::Common);
  if (!common.fault.empty()) return "common: " + common.fault;
  const double whole = volume_of(a) + (fuse ? volume_of(b) : 0);
  const double off = volume_of(made.shape) + volume_of(common.shape) - whole;
  return std::abs(off) <= 1e-6 * whole ? "" : "volumes are off by " + std::to_string(off);
}

// Empty where all steps are right.
std::string chain_fault(int seed) {
  testing::Random random(static_cast<std::uint32_t>(seed));
  TopoDS_Shape part = testing::random_tool(random).shape();
  for (int step = 0; step < kChainSteps; ++step) {
    const TopoDS_Shape tool = testing::random_tool(random).shape();
    const bool fuse = testing::pick(random, 0, 2) > 0;
    const Made made = combined(part, tool, fuse ? SolidOperation::Fuse : SolidOperation::Cut);
    if (const std::string fault = fault_of(made, part, tool, fuse); !fault.empty()) {
      BRepTools::Write(part, ("chain_" + std::to_string(seed) + "_a.brep").c_str());
      BRepTools::Write(tool, ("chain_" + std::to_string(seed) + "_b.brep").c_str());
      return "step " + std::to_string(step) + (fuse ? ", fuse: " : ", cut: ") + fault;
    }
    part = made.shape;
    if (!TopExp_Explorer(part, TopAbs_SOLID).More()) break;
  }
  return "";
}

TEST(SolidChains, StayRight) {
  const int first = testing::setting("BLOSSOM_SEED", 0),
            trials = testing::setting("BLOSSOM_TRIALS", 4);
  int wrong = 0;
  for (int seed = first; seed < first + trials; ++seed) {
    const std::string fault = chain_fault(seed);
    if (fault.empty()) continue;
    ++wrong;
    std::cout << "chain " << seed << ", " << fault << std::endl;
  }
  std::cout << trials << " chains of " << kChainSteps << " from seed " << first << ": " << wrong
            << " faults\n";
  EXPECT_EQ(wrong, 0);
}

TopoDS_Shape notch(double from, double height) {
  const TopoDS_Wire triangle =
      BRepBuilderAPI_MakePolygon({-0.5, 0, from}, {-2, 1, from}, {-2, -1, from}, true).Wire();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(triangle).Face(), gp_Vec(0, 0, height))
      .Shape();
}

// The edge of the notch lies in the side of the hole, and ends in the middle of it.
TEST(SolidChains, FillANotchThatTouchesAHole) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, 0), gp_Pnt(2, 2, 1)).Shape(),
                     rod = BRepPrimAPI_MakeCylinder(0.5, 1).Shape();
  const Made drilled = combined(plate, rod, SolidOperation::Cut);
  const Made notched = combined(drilled.shape, notch(0, 0.5), SolidOperation::Cut);
  ASSERT_EQ(notched.fault, "");
  const double whole = volume_of(drilled.shape);
  for (const auto& [from, height, added] :
       {std::array{0.0, 0.5, 0.0}, {0.0, 0.25, -0.375}, {-1.0, 1.5, 1.5}, {-1.0, 3.0, 3.0}}) {
    const Made filled = combined(notched.shape, notch(from, height), SolidOperation::Fuse);
    EXPECT_EQ(filled.fault, "") << "from " << from;
    EXPECT_NEAR(volume_of(filled.shape), whole + added, 1e-12) << "from " << from;
  }
}

// Beside a rod stand another one and two blocks, which touch it in lines; the lid is up to its
// middle, or level with the lower block, whose rim touches that of the rod in the lid's face.
TEST(SolidChains, CoverRodsAndBlocksThatTouchInLines) {
  TopoDS_Shape part = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, -2), gp_Pnt(24, 16, 0)).Shape();
  const auto rod = [](double x, double y) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, 0), gp::DZ()), 2, 5).Shape();
  };
  for (const TopoDS_Shape& standing :
       {rod(6, 6), rod(6, 2), BRepPrimAPI_MakeBox(gp_Pnt(8, 4, 0), gp_Pnt(12, 8, 5)).Shape(),
        BRepPrimAPI_MakeBox(gp_Pnt(4, 8, 0), gp_Pnt(8, 12, 3)).Shape()}) {
    const Made made = combined(part, standing, SolidOperation::Fuse);
    ASSERT_EQ(made.fault, "");
    part = made.shape;
  }
  const double whole = volume_of(part), base = 8 * std::numbers::pi + 32;  // of all below the lid
  for (const auto& [from, to] : {std::array{2.0, 3.0}, {2.0, 4.0}, {3.0, 5.0}}) {
    const TopoDS_Shape lid = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, from), gp_Pnt(24, 16, to)).Shape();
    const double common = (to - from) * (base - 16) + (from < 3 ? 16 : 0);
    for (const SolidOperation operation : {SolidOperation::Fuse, SolidOperation::Cut}) {
      const Made made = combined(part, lid, operation);
      EXPECT_EQ(made.fault, "") << "lid from " << from << " to " << to;
      const double added = operation == SolidOperation::Fuse ? 384 * (to - from) : 0;
      EXPECT_NEAR(volume_of(made.shape), whole + added - common, 1e-9)
          << "lid from " << from << " to " << to;
    }
  }
}

}  // namespace
}  // namespace blossom::occt
