// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves across the seams of closed faces are one curve, in as many edges as seams cut.

#include "core/surfaces/branches/seam_chains.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;

TopoDS_Face of(const Handle(Geom_Surface) & surface) {
  return BRepBuilderAPI_MakeFace(surface, 1e-7);
}

TopoDS_Face square(const gp_Pnt& at, const gp_Dir& normal) {
  return BRepBuilderAPI_MakeFace(gp_Pln(at, normal), -9, 9, -9, 9);
}

TopoDS_Face wall() {
  return BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 1), 0, 2 * kPi, 0, 4, 1e-7);
}

TopoDS_Face ball(const gp_Pnt& centre, double r) {
  return of(new Geom_SphericalSurface(gp_Ax3(centre, gp_Dir(1, 2, 3)), r));
}

struct Row {
  const char* name;
  TopoDS_Face a, b;
  std::size_t edges;           // of all curves
  std::vector<double> closed;  // lengths; 0 where it is not known
};

std::vector<Row> rows() {
  const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(gp_Ax3(), 3, 1);
  const TopoDS_Face sphere = of(new Geom_SphericalSurface(gp_Ax3(), 1));
  return {
      {"round a wall", wall(), square({0, 0, 1}, {0, 0, 1}), 1, {2 * kPi}},
      {"round a sphere", sphere, square({0, 0, 0.6}, {0, 0, 1}), 1, {1.6 * kPi}},
      {"a circle over a sphere's seam", sphere, square({0.8, 0, 0}, {1, 0, 0}), 2, {1.2 * kPi}},
      {"a loop over a wall's seam", wall(), ball({1, 0, 1}, 0.5), 3, {0}},
      {"a loop off it", wall(), ball({-1, 0, 1}, 0.5), 1, {0}},
      {"circles of a torus", of(torus), square({0, 0, 0}, {0.3, 1, 0}), 2, {2 * kPi, 2 * kPi}},
      {"a loop over both seams", of(torus), ball({4, 0, 0}, 0.5), 5, {0}},
      {"the same on a spline",
       of(GeomConvert::SurfaceToBSplineSurface(torus)),
       ball({4, 0, 0}, 0.5),
       5,
       {0}},
  };
}

TEST(SeamChains, MakeOneCurveOfItsPieces) {
  for (const Row& row : rows())
    for (const bool swapped : {false, true}) {
      SCOPED_TRACE(std::string(row.name) + (swapped ? ", swapped" : ""));
      const ShapeIntersection all =
          swapped ? intersect({row.b}, {row.a}) : intersect({row.a}, {row.b});
      ASSERT_EQ(all.pairs.size(), 1u);
      const FaceIntersection& pair = all.pairs[0];
      EXPECT_EQ(pair.edges.size(), row.edges);
      ASSERT_EQ(pair.chains.size(), row.closed.size());
      std::size_t uses = 0;
      for (std::size_t i = 0; i < pair.chains.size(); ++i) {
        const CurveChain& chain = pair.chains[i];
        EXPECT_TRUE(chain.closed);
        double length = 0;
        for (const ChainUse& use : chain.uses)
          length += pair.found.curves[static_cast<std::size_t>(use.curve)].length;
        if (row.closed[i] > 0) {
          EXPECT_NEAR(length, row.closed[i], 1e-6);
        }
        uses += chain.uses.size();
      }
      EXPECT_EQ(uses, pair.found.curves.size());
    }
}

TEST(SeamChains, PiecesFollowEachOther) {
  for (const Row& row : rows()) {
    const ShapeIntersection all = intersect({row.a}, {row.b});
    ASSERT_EQ(all.pairs.size(), 1u);
    const FaceIntersection& pair = all.pairs[0];
    for (const CurveChain& chain : pair.chains) {
      const auto end = [&](const ChainUse& use, bool last) {
        const auto& samples = pair.found.curves[static_cast<std::size_t>(use.curve)].samples;
        return (use.forward == last ? samples.back() : samples.front()).point;
      };
      for (std::size_t i = 0; i < chain.uses.size(); ++i)
        EXPECT_LE(
            distance(end(chain.uses[i], true), end(chain.uses[(i + 1) % chain.uses.size()], false)),
            1e-7)
            << row.name;
    }
  }
}

// Half a wall is not closed: its curve ends at its sides.
TEST(SeamChains, EndAtTheBordersOfOpenFaces) {
  const TopoDS_Face half =
      BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 1), 0, kPi, 0, 4, 1e-7);
  const ShapeIntersection all = intersect({half}, {square({0, 0, 1}, {0, 0, 1})});
  ASSERT_EQ(all.pairs.size(), 1u);
  ASSERT_EQ(all.pairs[0].chains.size(), 1u);
  EXPECT_FALSE(all.pairs[0].chains[0].closed);
}

}  // namespace
}  // namespace blossom::occt
