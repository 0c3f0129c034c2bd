// SPDX-License-Identifier: LGPL-2.1-or-later
// Zebra stripes: what they cover, and where they lie.

#include "plugin/pictures/scene/zebra.h"

#include <gtest/gtest.h>

#include <cmath>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "core/math/index.h"

namespace blossom::cli {
namespace {

using namespace pictures;

std::vector<TopoDS_Face> zebra_faces(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  return faces;
}

double area_of(const PictureMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += norm(cross(mesh.points[index(b)] - mesh.points[index(a)],
                       mesh.points[index(c)] - mesh.points[index(a)])) /
            2;
  return area;
}

TEST(Zebra, StripesCoverEachFaceOnce) {
  for (const PictureMesh& mesh :
       picture_meshes(zebra_faces(BRepPrimAPI_MakeSphere(5).Shape()), 0.01, 0.1)) {
    const StripedMesh made = striped(mesh, {0, -1, 0}, {0, 0, 1});
    EXPECT_NEAR(area_of(made.dark) + area_of(made.light), area_of(mesh), 1e-9);
    EXPECT_GT(area_of(made.dark), 0.3 * area_of(mesh));
    EXPECT_GT(area_of(made.light), 0.3 * area_of(mesh));
    EXPECT_EQ(made.dark.border.size() + made.light.border.size(), mesh.border.size());
  }
}

TEST(Zebra, OnAPlaneIsOneStripe) {
  for (const PictureMesh& mesh :
       picture_meshes(zebra_faces(BRepPrimAPI_MakeBox(1, 2, 3).Shape()), 0.01, 0.1)) {
    const StripedMesh made = striped(mesh, unit(Vec3{1, -1, 1}), unit(Vec3{-1, 1, 2}));
    EXPECT_TRUE(made.dark.triangles.empty() != made.light.triangles.empty());
    EXPECT_NEAR(area_of(made.dark) + area_of(made.light), area_of(mesh), 1e-12);
  }
}

// Seen along y the height of the reflection at a point of the meridian x = 0 is twice its own, so
// 32 stripes of 180 degrees are 2.8125 degrees of latitude each, from the equator on.
TEST(Zebra, OnABallIsByTheHeightOfTheReflection) {
  const std::vector<PictureMesh> meshes =
      picture_meshes(zebra_faces(BRepPrimAPI_MakeSphere(1).Shape()), 1e-5, 0.01);
  const StripedMesh made = striped(meshes.front(), {0, -1, 0}, {0, 0, 1});
  int seen = 0;
  for (const auto& [a, b, c] : made.dark.triangles) {
    const Vec3 at =
        (made.dark.points[index(a)] + made.dark.points[index(b)] + made.dark.points[index(c)]) *
        (1.0 / 3);
    if (std::abs(at[0]) > 0.05 || at[1] > 0 || std::abs(at[2]) > 0.6) continue;
    const double stripe = std::asin(at[2]) * 180 / M_PI / 2.8125;
    const double into = stripe - 2 * std::floor(stripe / 2);  // dark ones are 0 to 1 of each two
    EXPECT_TRUE(into < 1.1 || into > 1.9) << stripe;
    ++seen;
  }
  EXPECT_GT(seen, 100);
}

}  // namespace
}  // namespace blossom::cli
