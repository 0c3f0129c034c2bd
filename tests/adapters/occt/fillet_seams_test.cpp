// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips that end in a closed face, across its seam.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeHalfSpace.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"
#include "tests/adapters/occt/fillet_volumes.h"

namespace blossom::occt {
namespace {

using testing::edges_where;

constexpr double kHeight = 75, kRadius = 40;

// A cylinder along x whose upper end is cut off at 45 degrees up to its middle line.
TopoDS_Shape chopped_cylinder(double degrees_of_seam) {
  const double angle = degrees_of_seam * std::numbers::pi / 180;
  const gp_Ax2 axis(gp::Origin(), gp::DX(), {0, std::sin(angle), std::cos(angle)});
  const gp_Pln cut({kHeight, 0, 0}, {1, -1, 0});
  const TopoDS_Shape below =
      BRepPrimAPI_MakeHalfSpace(BRepBuilderAPI_MakeFace(cut).Face(), gp_Pnt(0, 40, 0)).Solid();
  return BRepAlgoAPI_Common(BRepPrimAPI_MakeCylinder(axis, kRadius, kHeight).Shape(), below);
}

// The fillet of the middle line ends in the cylinder, whose seam is between the contacts, or at one
// of them, or in the vertex of the line.
TEST(FilletOfAChoppedCylinder, IsTheSameWhereverTheSeamIs) {
  for (const double radius : {0.5, 4.0, 5.0}) {
    const double reach = radius * std::tan(std::numbers::pi / 8);
    const double at_contact = std::asin(reach / kRadius) * 180 / std::numbers::pi;
    std::optional<double> volume;
    for (const double degrees :
         {90.0, 0.0, 180.0, 0.3, -0.3, 1.0, -1.0, 2.0, -2.0, 5.0, at_contact, -at_contact}) {
      SCOPED_TRACE(::testing::Message() << radius << ", seam at " << degrees);
      const TopoDS_Shape shape = chopped_cylinder(degrees);
      const std::vector<int> edges = edges_where(shape, EdgeKind::Convex, [](const Vec3& at) {
        return distance(at, Vec3{kHeight, 0, 0}) < 1e-6;
      });
      ASSERT_EQ(edges.size(), 1U);

      const FilletResult made = fillet(shape, edges, {.radius = radius});

      testing::expect_sound(made);
      ASSERT_EQ(made.solids.size(), 1U);
      EXPECT_TRUE(made.notes.empty()) << made.notes.front();
      if (!volume) volume = made.solids.front().volume;
      EXPECT_NEAR(made.solids.front().volume, *volume, 1e-10 * *volume);
    }
  }
}

}  // namespace
}  // namespace blossom::occt
