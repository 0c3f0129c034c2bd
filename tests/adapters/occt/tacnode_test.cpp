// SPDX-License-Identifier: LGPL-2.1-or-later
// Two branches that touch in a point. Near it they lie side by side, and how far that is read as
// contact depends on the cells; it is one node with four arms all the same.

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/intersection.h"
#include "tests/support/random.h"

namespace blossom::occt {
namespace {

constexpr double kTolerance = 8e-7;
constexpr std::array kX{6.2109375, 1.2890625}, kY{0.1640625, 5.0859375};

// The graph over a rectangle, by rows of heights of its control points, along falling x or along y.
// The last one of each row has a weight.
TopoDS_Face graph(const std::vector<std::vector<double>>& heights, bool along_x,
                  double last_weight) {
  const int n = static_cast<int>(heights.size()), m = static_cast<int>(heights.front().size());
  const auto between = [](const std::array<double, 2>& ends, int i, int count) {
    return ends[0] + (ends[1] - ends[0]) * i / (count - 1);
  };
  TColgp_Array2OfPnt poles(1, n, 1, m);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      poles(i + 1, j + 1) =
          gp_Pnt(along_x ? between(kX, j, m) : between(kX, i, n),
                 along_x ? between(kY, i, n) : between(kY, j, m),
                 heights[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  TColStd_Array2OfReal weights(1, n, 1, m);
  weights.Init(1);
  for (int i = 1; i <= n; ++i) weights(i, m) = last_weight;
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles, weights), 1e-7).Face();
}

gp_Trsf random_motion(testing::Random& random) {
  const auto draw = [&] { return testing::uniform(random, -1, 1); };
  gp_Trsf turn, shift;
  turn.SetRotation(gp_Ax1(gp_Pnt(draw(), draw(), draw()), gp_Dir(draw(), draw(), draw())),
                   testing::uniform(random, 0.2, 3));
  shift.SetTranslation(gp_Vec(draw(), draw(), draw()));
  return shift * turn;
}

TEST(Tacnode, HasFourArmsHoweverItIsTurned) {
  const TopoDS_Face a = graph({{-3.41357421875, -3.41357421875},
                               {-4.23388671875, -3.61865234375},
                               {-4.43896484375, -3.61865234375},
                               {-4.02880859375, -3.41357421875}},
                              false, 0.5);
  const TopoDS_Face b = graph({{-5.2158684730529785, -6.6554207801818848, -5.903200626373291,
                                -7.2658486366271973, -5.2062554359436035},
                               {-0.60161066055297852, -1.8104500770568848, -0.93005609512329102,
                                -2.2670693397521973, -0.28438043594360352},
                               {-5.8311028480529785, -6.8092293739318848, -5.800661563873291,
                                -7.1120400428771973, -5.2062554359436035}},
                              true, 1);
  IntersectionOptions options;
  options.tolerances.point = kTolerance;
  testing::Random random = testing::seeded(3);
  for (int row = 0; row < 60; ++row) {
    const gp_Trsf motion = random_motion(random);
    const auto moved = [&](const TopoDS_Face& face) {
      return std::vector{TopoDS::Face(BRepBuilderAPI_Transform(face, motion, true).Shape())};
    };

    const ShapeIntersection found = intersect(moved(a), moved(b), options);

    EXPECT_EQ(found.status, Status::Tolerance) << row;
    ASSERT_EQ(found.pairs.size(), 1u) << row;
    const SurfaceIntersection& pair = found.pairs.front().found;
    double length = 0;
    for (const IntersectionCurve& curve : pair.curves) {
      length += curve.length;
      EXPECT_FALSE(curve.tangential) << row;
    }
    EXPECT_EQ(pair.curves.size(), 4u) << row;
    EXPECT_EQ(pair.nodes.size(), 1u) << row;
    EXPECT_NEAR(length, 11.45, 0.06) << row;  // an arm may end anywhere in the contact
  }
}

}  // namespace
}  // namespace blossom::occt
