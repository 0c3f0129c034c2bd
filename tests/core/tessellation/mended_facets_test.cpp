// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/mended_facets.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace blossom {
namespace {

using Faults = std::map<int, std::size_t>;

constexpr FacetOptions kCoarse{.deviation = 0.01, .angle = 0};

// Vaults beside each other, 1 wide and 1 high, that share nothing.
void add_vault(ShapeModel& model, double x) {
  const int first = static_cast<int>(model.vertices.size());
  const std::array<Vec2, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  RationalBezierPatch patch{Grid<Vec4>(3, 2)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j)
      patch.points(i, j) = {x + 0.5 * i, double(j), i == 1 ? 2.0 : 0.0, 1};
  BezierSurface surface;
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  surface.patches(0, 0) = patch;
  surface.u_knots = surface.v_knots = {0, 1};
  ModelFace face;
  face.surface = surface;
  for (int k = 0; k < 4; ++k) {
    const Vec2 a = corners[static_cast<std::size_t>(k)],
               b = corners[static_cast<std::size_t>((k + 1) % 4)];
    model.vertices.push_back({x + a[0], a[1], 0});
    const Vec3 from{x + a[0], a[1], 0}, to{x + b[0], b[1], 0};
    const Vec3 top{x + 0.5, a[1], 2};
    const BezierCurve curve = k % 2 == 0 ? BezierCurve{{from, top, to}} : BezierCurve{{from, to}};
    const int next = first + (k + 1) % 4;
    face.edges.push_back(static_cast<int>(model.edges.size()));
    model.edges.push_back({curve_spans(curve), first + k, next});
    RegionBorder border;
    border.curve = planar_line(a, b, {0, 1});
    border.from = k;
    border.to = (k + 1) % 4;
    face.chart.borders.push_back(border);
  }
  face.chart.corners.assign(corners.begin(), corners.end());
  model.faces.push_back(face);
}

ShapeModel vaults(int count) {
  ShapeModel model;
  for (int k = 0; k < count; ++k) add_vault(model, 2.0 * k);
  return model;
}

std::size_t facets_in(const ShapeFacets& facets, std::size_t face) {
  return facets.faces[face].triangles.size();
}

TEST(MendedFacets, AreThoseOfTheShapeWhereNothingIsAtFault) {
  const ShapeFacets plain = shape_facets(vaults(2), kCoarse);
  const MendedFacets made =
      mended_facets(vaults(2), kCoarse, [](const ShapeFacets&) { return Faults{}; });
  EXPECT_EQ(made.facets.points, plain.points);
  EXPECT_TRUE(made.finer.empty());
  EXPECT_EQ(made.looked, 0);
}

TEST(MendedFacets, AreFinerOnTheFaceAtFaultAlone) {
  const ShapeFacets plain = shape_facets(vaults(2), kCoarse);
  const MendedFacets made = mended_facets(vaults(2), kCoarse, [&](const ShapeFacets& facets) {
    return facets_in(facets, 1) == facets_in(plain, 1) ? Faults{{1, 3}} : Faults{};
  });
  EXPECT_EQ(made.finer, (std::vector<int>{1}));
  EXPECT_EQ(made.looked, 1);
  EXPECT_EQ(facets_in(made.facets, 0), facets_in(plain, 0));
  EXPECT_NEAR(double(facets_in(made.facets, 1)), 2.0 * double(facets_in(plain, 1)), 2.0);
  EXPECT_LE(made.facets.faces[1].distance, 0.25 * kCoarse.deviation);
}

// Two surfaces that cross do so in ever more facets; beside them one becomes sound.
TEST(MendedFacets, LeaveFacesAsTheyAreWhoseFaultsBecomeMore) {
  const ShapeFacets plain = shape_facets(vaults(3), kCoarse);
  const auto faults = [&](const ShapeFacets& facets) {
    Faults found{{0, facets_in(facets, 0)}, {1, facets_in(facets, 1)}};
    if (facets_in(facets, 2) == facets_in(plain, 2)) found[2] = 1;
    return found;
  };
  const MendedFacets made = mended_facets(vaults(3), kCoarse, faults);
  EXPECT_EQ(made.finer, (std::vector<int>{2}));
  EXPECT_EQ(facets_in(made.facets, 0), facets_in(plain, 0));
  EXPECT_GT(facets_in(made.facets, 2), facets_in(plain, 2));
}

TEST(MendedFacets, AreNotTriedForEver) {
  std::size_t left = 1000;
  int looks = 0;
  const ShapeFacets plain = shape_facets(vaults(1), kCoarse);
  const MendedFacets made = mended_facets(vaults(1), kCoarse, [&](const ShapeFacets&) {
    ++looks;
    return Faults{{0, --left}};
  });
  EXPECT_EQ(looks, 4);  // at the deviation, and three times finer
  EXPECT_TRUE(made.finer.empty());
  EXPECT_EQ(made.looked, 0);
  EXPECT_EQ(made.facets.points, plain.points);
}

TEST(MendedFacets, AreNoneWhereTheyWouldBeFarMore) {
  const FacetOptions fine{.deviation = 2e-5, .angle = 0, .aspect = 1};
  int looks = 0;
  const MendedFacets made = mended_facets(vaults(1), fine, [&](const ShapeFacets& facets) {
    EXPECT_GT(facets_in(facets, 0), 12'500u);
    return Faults{{0, std::size_t(1000 - ++looks)}};
  });
  EXPECT_EQ(looks, 2);  // a quarter of the deviation is tried, a sixteenth is not
  EXPECT_TRUE(made.finer.empty());
}

TEST(MendedFacets, AreTheFirstOnesIfNobodyLooksAtFinerOnes) {
  int looks = 0;
  const MendedFacets made =
      mended_facets(vaults(1), kCoarse, [&](const ShapeFacets&) -> std::optional<Faults> {
        if (looks++ > 0) return {};
        return Faults{{0, 1}};
      });
  EXPECT_TRUE(made.finer.empty());
  EXPECT_EQ(made.looked, 0);
}

}  // namespace
}  // namespace blossom
