// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of pictures as triangles: how near they are, how they are turned, and what stands for a
// face that has none.

#include "plugin/pictures/scene/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include "core/math/index.h"
#include "plugin/pictures/image/drawing.h"
#include "plugin/pictures/scene/scene.h"
#include "plugin/pictures/scene/view.h"
#include "tests/plugin/cli/program.h"

namespace blossom::cli {
namespace {

using namespace pictures;

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  return faces;
}

// A square whose border runs along its diagonals.
TopoDS_Face bow_tie() {
  BRepBuilderAPI_MakePolygon wire(gp_Pnt(0, 0, 0), gp_Pnt(10, 10, 0), gp_Pnt(10, 0, 0),
                                  gp_Pnt(0, 10, 0), Standard_True);
  return BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire());
}

// A sliver, 0.03 long and 3e-5 wide: far below the deviation.
TEST(PictureMesh, HasTrianglesForTheLeastFace) {
  const gp_Pnt a(2.93e-5, 0, 0), b(0, 0.013, 0), c(0, -0.0176, 0);
  const gp_Pnt on_ab(2.09e-5, 0.0065, 0), on_cb(3.74e-5, -0.0023, 0);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, on_ab, b).Value()));
  wire.Add(BRepBuilderAPI_MakeEdge(a, c));
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(c, on_cb, b).Value()));
  const TopoDS_Face sliver = BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire());
  EXPECT_FALSE(picture_meshes({sliver}, 0.5, 0.2).front().triangles.empty());
}

TEST(PictureMesh, IsWithinAPixelOfTheFaceHoweverLargeThePicture) {
  for (const int width : {100, 1200, 8000}) {
    Picture picture;
    picture.width = picture.height = width;
    picture.groups = {{faces_of(BRepPrimAPI_MakeSphere(gp_Pnt(7, 8, 9), 5).Shape()), kFirstColour}};
    const std::vector<SceneMesh> meshes = scene_meshes(picture);
    const std::vector<Vec3> corners = scene_corners(meshes);
    double farthest = 0;  // of triangles within the sphere
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const Vec3 middle = (corners[i] + corners[i + 1] + corners[i + 2]) * (1.0 / 3);
      farthest = std::max(farthest, 5 - distance(middle, Vec3{7, 8, 9}));
    }
    const Frame frame = {0, 0, double(width), double(width)};
    const double pixels = view_from(scene_direction(picture, corners), corners, frame).scale;
    EXPECT_LT(farthest * pixels, 1) << width;
    EXPECT_GT(farthest * pixels, 0.05) << width;  // and no finer than can be seen
  }
}

TEST(PictureMesh, BorderHasNoSeamAndClosesRoundEachEnd) {
  double length = 0;
  for (const TopoDS_Face& face : faces_of(BRepPrimAPI_MakeCylinder(2, 10).Shape())) {
    const PictureMesh mesh = picture_meshes({face}, 1e-3, 0.2).front();
    for (const auto& [from, to] : mesh.border) {
      EXPECT_NEAR(mesh.points[index(from)][2], mesh.points[index(to)][2], 1e-12);
      length += distance(mesh.points[index(from)], mesh.points[index(to)]);
    }
  }
  EXPECT_NEAR(length, 4 * 2 * M_PI * 2, 0.05);  // two circles, each of two faces
}

TEST(PictureMesh, TrianglesAndNormalsPointOutOfASolid) {
  const std::vector<TopoDS_Face> faces = faces_of(BRepPrimAPI_MakeCylinder(2, 10).Shape());
  double volume = 0;
  for (const PictureMesh& mesh : picture_meshes(faces, 1e-3, 0.2)) {
    for (const auto& [a, b, c] : mesh.triangles)
      volume += dot(mesh.points[index(a)], cross(mesh.points[index(b)], mesh.points[index(c)])) / 6;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      EXPECT_GT(dot(mesh.normals[i], mesh.points[i] - Vec3{0, 0, 5}), 0);
  }
  EXPECT_NEAR(volume, M_PI * 4 * 10, 0.5);
}

TEST(PictureMesh, FaceThatIsShownTwiceHasTrianglesTwice) {
  const std::vector<PictureMesh> meshes =
      picture_meshes({testing::bowl(), testing::lid(0.5), testing::bowl()}, 0.01, 0.2);
  const TopoDS_Face bowl = testing::bowl();
  const std::vector<PictureMesh> same = picture_meshes({bowl, bowl}, 0.01, 0.2);
  EXPECT_EQ(meshes.size(), 3u);
  EXPECT_EQ(same[0].triangles, same[1].triangles);
  EXPECT_FALSE(same[1].triangles.empty());
}

TEST(PictureMesh, FaceWithoutTrianglesHasItsBorderAndTheReason) {
  const std::vector<PictureMesh> meshes = picture_meshes({bow_tie(), testing::bowl()}, 0.01, 0.2);
  EXPECT_TRUE(meshes[0].triangles.empty());
  EXPECT_EQ(meshes[0].border.size(), 4u);
  EXPECT_EQ(meshes[0].obstacle, "its borders cross each other");
  EXPECT_FALSE(meshes[1].triangles.empty());
  EXPECT_EQ(meshes[1].obstacle, "");
}

TEST(PictureMesh, FaceWithoutTrianglesIsOutlinedInItsColour) {
  Picture picture;
  picture.groups = {{{bow_tie()}, {0.9, 0.1, 0.1}}};
  const Image image = picture_image(picture, scene_meshes(picture));
  EXPECT_GT(std::ranges::count_if(image.pixels,
                                  [](const Colour& c) { return c.red > 200 && c.green < 60; }),
            2000);
}

TEST(PictureOption, SaysWhichFacesAreNotFilledAndDrawsTheOthers) {
  const testing::TestFolder folder;
  testing::write({bow_tie(), testing::bowl()}, folder / "bow.brep");
  const testing::Finished run =
      testing::blossom({"check", folder / "bow.brep", "--picture", folder / "bow.png"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("the picture shows 1 face by edges alone: its borders cross each other"),
            std::string::npos)
      << run.err;
  EXPECT_FALSE(testing::text_of(folder / "bow.png").empty());
}

}  // namespace
}  // namespace blossom::cli
