// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/fill_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/blending/blend_edges.h"

namespace blossom::occt {
namespace {

// A flat hole of n straight sides with a flat neighbour beyond each.
std::vector<FillSide> flat_hole(int n) {
  std::vector<FillSide> sides;
  const auto corner = [n](int k) {
    const double angle = 2 * std::numbers::pi * k / n;
    return Vec3{std::cos(angle), std::sin(angle), 0};
  };
  for (int k = 0; k < n; ++k) {
    const Vec3 a = corner(k), b = corner(k + 1), out = a + b;
    const auto row = [](const Vec3& p, double w) { return Vec4{p[0], p[1], p[2], w}; };
    sides.push_back({{row(a, 1), row(b, 1)}, {row(out, 0), row(out, 0)}, {}, FillContinuity::G1});
  }
  return sides;
}

TEST(FillFaces, ShareEachInnerEdgeBothWays) {
  for (const FillLayout layout : {FillLayout::Star, FillLayout::Ring}) {
    const int n = 5;
    const Fill made = fill(flat_hole(n), {.layout = layout});
    ASSERT_EQ(made.problem, FillProblem::None) << made.message;
    std::vector<TopoDS_Vertex> corners;
    for (const FillSide& side : flat_hole(n)) corners.push_back(vertex_at(projected(side.edge[0])));
    int borders = 0;
    std::vector<int> middles;
    const auto middle = [&](int side, const Vec3& point) {
      middles.push_back(side);
      const std::vector<Vec4> row = flat_hole(n)[static_cast<std::size_t>(side)].edge;
      EXPECT_LT(distance(point, 0.5 * (projected(row[0]) + projected(row[1]))), 1e-12);
      return vertex_at(point);
    };
    const auto faces = fill_faces(made, corners, middle, [&](const FillBorder& border) {
      ++borders;
      const TopoDS_Edge edge = edge_on(border.curve, {0, 1}, border.along ? border.from : border.to,
                                       border.along ? border.to : border.from);
      add_chart(edge, border.chart, border.patch);
      return PathEdge{edge, border.along};
    });
    EXPECT_EQ(borders, 2 * n);
    EXPECT_EQ(middles, (std::vector<int>{0, 1, 2, 3, 4}));
    ASSERT_EQ(faces.size(), made.patches.size());
    TopTools_IndexedMapOfShape edges;
    std::vector<int> forward, reversed;
    for (const FillFace& face : faces) {
      EXPECT_EQ(face.edges.size(), 4U);
      for (const TopoDS_Edge& edge : face.edges) {
        const auto at = static_cast<std::size_t>(edges.Add(edge)) - 1;
        forward.resize(std::max(forward.size(), at + 1));
        reversed.resize(forward.size());
        ++(edge.Orientation() == TopAbs_FORWARD ? forward : reversed)[at];
      }
    }
    int shared = 0;
    for (std::size_t i = 0; i < forward.size(); ++i) {
      EXPECT_LE(forward[i], 1);
      EXPECT_LE(reversed[i], 1);
      shared += forward[i] == 1 && reversed[i] == 1 ? 1 : 0;
    }
    EXPECT_EQ(static_cast<int>(forward.size()) - shared, 2 * n);
  }
}

}  // namespace
}  // namespace blossom::occt
