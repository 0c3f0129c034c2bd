// SPDX-License-Identifier: LGPL-2.1-or-later
// What does not change the question does not change the answer: the order of the arguments, turns,
// and a scale that the tolerance follows. And results are solids like all others.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/solids/solid_contacts.h"

namespace blossom::occt {
namespace {

using testing::box;

constexpr double kSameVolume = 1e-9;  // of the part's

struct Answer {
  double volume = 0;
  std::size_t solids = 0, faces = 0;
};

Answer answer_of(const TopoDS_Shape& a, const TopoDS_Shape& b, SolidOperation operation,
                 double tolerance = 1e-7) {
  IntersectionOptions options;
  options.tolerances.point = tolerance;
  const SolidTrimResult made = trim_solids(trim_tool(a), {trim_tool(b)}, operation, options);
  EXPECT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  return {made.total.result, made.solids.size(), made.faces.size()};
}

void expect_same(const Answer& one, const Answer& other, double volume) {
  EXPECT_NEAR(one.volume, other.volume, kSameVolume * volume);
  EXPECT_EQ(one.solids, other.solids);
  EXPECT_EQ(one.faces, other.faces);
}

// Pairs that cross, touch, have faces on one plane, and are moved copies of each other.
std::vector<std::array<TopoDS_Shape, 2>> pairs() {
  const TopoDS_Shape block = box({0, 0, 0}, {10, 10, 10});
  const auto at = [](double x, double y, double z) { return gp_Ax2({x, y, z}, gp::DZ()); };
  return {{block, box({5, 5, 0}, {15, 15, 10})},
          {block, box({10, 2, 2}, {14, 8, 8})},
          {block, BRepPrimAPI_MakeCylinder(at(5, 5, -1), 3, 12)},
          {block, BRepPrimAPI_MakeCylinder(at(10, 5, 0), 3, 10)},
          {block, BRepPrimAPI_MakeSphere(gp_Pnt(10, 10, 10), 4)},
          {block, BRepPrimAPI_MakeCone(at(5, 5, 0), 4, 1, 10)},
          {block, BRepPrimAPI_MakeTorus(at(5, 5, 10), 4, 1.5)},
          {BRepPrimAPI_MakeCylinder(5, 10), BRepPrimAPI_MakeCylinder(at(1e-3, 2e-3, 0), 5, 10)},
          {BRepPrimAPI_MakeSphere(5), BRepPrimAPI_MakeCylinder(at(0, 0, -6), 2, 12)}};
}

TEST(SolidsAreTheSame, InEitherOrder) {
  for (const auto& [a, b] : pairs())
    for (const SolidOperation operation : {SolidOperation::Common, SolidOperation::Fuse})
      expect_same(answer_of(a, b, operation), answer_of(b, a, operation), 1000);
}

TEST(SolidsAreTheSame, Turned) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1({1, 2, 3}, gp_Dir(0.3, -0.5, 0.8)), 0.7);
  const auto turned = [&](const TopoDS_Shape& shape) {
    return BRepBuilderAPI_Transform(shape, turn, true).Shape();
  };
  for (const auto& [a, b] : pairs())
    for (const SolidOperation operation : {SolidOperation::Common, SolidOperation::Cut})
      expect_same(answer_of(a, b, operation), answer_of(turned(a), turned(b), operation), 1000);
}

TEST(SolidsAreTheSame, ScaledWithTheTolerance) {
  for (const double factor : {8.0, 1000.0}) {
    gp_Trsf scale;
    scale.SetScale({0, 0, 0}, factor);
    const auto scaled = [&](const TopoDS_Shape& shape) {
      return BRepBuilderAPI_Transform(shape, scale, true).Shape();
    };
    for (const auto& [a, b] : pairs()) {
      Answer large = answer_of(scaled(a), scaled(b), SolidOperation::Cut, factor * 1e-7);
      large.volume /= factor * factor * factor;
      expect_same(answer_of(a, b, SolidOperation::Cut), large, 1000);
    }
  }
}

// Holes, bosses and grooves, one into the other, on what the steps before have left.
TEST(ResultsOfResults, StayValidThroughTwentyOperations) {
  TopoDS_Shape body = box({-20, -20, 0}, {20, 20, 8});
  double volume = 40 * 40 * 8;
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const double angle = 0.9 * i, x = 13 * std::cos(angle), y = 13 * std::sin(angle);
    const gp_Ax2 axes({x, y, i % 2 == 0 ? -1.0 : 8.0}, gp::DZ());
    const TopoDS_Shape tool = i % 4 == 0   ? BRepPrimAPI_MakeCylinder(axes, 2.5, 10).Shape()
                              : i % 4 == 1 ? BRepPrimAPI_MakeCylinder(axes, 3, 4).Shape()
                              : i % 4 == 2 ? box({x - 2, y - 6, 6}, {x + 2, y + 6, 20})
                                           : BRepPrimAPI_MakeSphere(gp_Pnt(x, y, 8), 3.5).Shape();
    const SolidOperation operation = i % 2 == 0 ? SolidOperation::Cut : SolidOperation::Fuse;
    const SolidTrimResult made = trim_solids(trim_tool(body), {trim_tool(tool)}, operation);
    ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
    EXPECT_NEAR(made.total.part, volume, 1e-6 * volume);
    volume = made.total.result;
    body = compound_of(made.solids);
    EXPECT_TRUE(BRepCheck_Analyzer(body).IsValid());
  }
}

}  // namespace
}  // namespace blossom::occt
