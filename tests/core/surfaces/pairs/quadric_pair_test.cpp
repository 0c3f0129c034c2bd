// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/quadric_pair.h"

#include <gtest/gtest.h>

#include "core/surface_intersection.h"
#include "tests/support/quadric_patches.h"

namespace blossom {
namespace {

using testing::cylinder_quarter;
using testing::sphere_octant;

// Four quarters about the z axis; with their mirror image below if `both`.
BezierSurface turned_round(const RationalBezierPatch& quarter, bool both) {
  BezierSurface surface{{0, 1, 2, 3, 4}, {0, 1}};
  if (both) surface.v_knots = {-1, 0, 1};
  surface.closed_u = surface.rational = true;
  surface.patches = Grid<RationalBezierPatch>(4, both ? 2 : 1, quarter);
  const int last = surface.patches.columns() - 1;
  for (int k = 1; k < 4; ++k) {
    surface.patches(k, last) = surface.patches(k - 1, last);
    for (Vec4& p : surface.patches(k, last).points.values()) p = {-p[1], p[0], p[2], p[3]};
  }
  for (int k = 0; both && k < 4; ++k) {
    const Grid<Vec4>& upper = surface.patches(k, 1).points;
    Grid<Vec4>& lower = surface.patches(k, 0).points;
    for (int i = 0; i < upper.rows(); ++i)
      for (int j = 0; j < upper.columns(); ++j) {
        const Vec4& p = upper(i, upper.columns() - 1 - j);
        lower(i, j) = {p[0], p[1], -p[2], p[3]};
      }
  }
  return surface;
}

bool is_whole(const BezierSurface& surface) {
  SurfaceCells cells(surface, {}, CellForm::Auto, 0.4865);
  QuadricBands bands(1e-7);
  return is_whole_quadric(cells, bands);
}

TEST(WholeQuadric, IsASphereFromPoleToPole) {
  EXPECT_TRUE(is_whole(turned_round(sphere_octant({}, 2), true)));
}

TEST(WholeQuadric, IsNoneWithABorderOrAnotherPatch) {
  EXPECT_FALSE(is_whole(turned_round(sphere_octant({}, 2), false)));
  EXPECT_FALSE(is_whole(turned_round(cylinder_quarter(2, 1), true)));
  BezierSurface lune = turned_round(sphere_octant({}, 2), true);
  lune.closed_u = false;
  EXPECT_FALSE(is_whole(lune));
  BezierSurface egg = turned_round(sphere_octant({}, 2), true);
  for (int k = 0; k < 4; ++k)
    for (Vec4& p : egg.patches(k, 0).points.values()) p[2] *= 1.5;
  EXPECT_FALSE(is_whole(egg));
}

// The first small enough cell at the pole.
Cell pole_cell(CellTree& tree) {
  int cell = 0;
  while (tree[cell].extent > 0.1) {
    const int child = tree.split(cell);
    cell = tree[child].v.to == 1 ? child : child + 1;
  }
  return tree[cell];
}

TEST(QuadricPair, TouchesAllOverAPoleOnlyIfTheQuadricsHardlyDifferThere) {
  const BezierSurface a = turned_round(sphere_octant({}, 2), false);
  for (const double up : {1e-8, 1e-6}) {
    const BezierSurface b = turned_round(sphere_octant({0, 0, up}, 2), false);
    SurfaceCells cells_a(a, {}, CellForm::Auto, 0.4865), cells_b(b, {}, CellForm::Auto, 0.4865);
    QuadricBands bands(1e-7);
    const QuadricPair pair(cells_a.tree(0), cells_b.tree(0), bands, false, 4);
    const Cell cell_a = pole_cell(cells_a.tree(0)), cell_b = pole_cell(cells_b.tree(0));

    EXPECT_EQ(pair.touch_all_over(cell_a, cell_b), up < 1e-7);
    EXPECT_TRUE(pair.cover_each_other(cell_a, cell_b));
    EXPECT_FALSE(pair.touch_all_over(cells_a.tree(0)[0], cell_b));  // too large
  }
}

TEST(QuadricPair, AWholeSphereCoincidesWithItselfWhateverTheAxis) {
  const BezierSurface a = turned_round(sphere_octant({}, 2), true);
  BezierSurface b = a;
  for (RationalBezierPatch& patch : b.patches.values())
    for (Vec4& p : patch.points.values())
      p = {p[0], 0.6 * p[1] - 0.8 * p[2], 0.8 * p[1] + 0.6 * p[2], p[3]};

  const SurfaceIntersection found = intersect(a, b);

  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.overlaps.size(), 1u);
  EXPECT_TRUE(found.overlaps[0].boundary.empty());
  EXPECT_TRUE(found.curves.empty() && found.points.empty());
  EXPECT_LT(found.certificate.critical, 20'000);
}

}  // namespace
}  // namespace blossom
