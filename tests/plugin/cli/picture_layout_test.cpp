// SPDX-License-Identifier: LGPL-2.1-or-later
// Where pictures are seen from, what stands round them, and what their colours mean.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "core/base/errors.h"
#include "plugin/pictures/image/annotations.h"
#include "plugin/pictures/image/drawing.h"
#include "plugin/pictures/image/raster/lettering.h"
#include "plugin/pictures/scene/hatch.h"
#include "plugin/pictures/scene/picture.h"
#include "plugin/pictures/scene/view.h"
#include "tests/plugin/cli/program.h"

namespace blossom::cli {
namespace {

using namespace pictures;

// A square of side 2 round the origin with a normal.
std::vector<Vec3> square(const Vec3& normal) {
  const Vec3 x = unit(cross(normal, Vec3{0.3, 0.5, 0.8})), y = unit(cross(normal, x));
  return {x, y, -x, -x, -y, x};
}

TEST(View, IsIsoWhateverThereIsToSee) {
  EXPECT_EQ(default_direction({}), (Vec3{1, -1, 1}));
  for (const Vec3& normal : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{1, -2, 3}})
    EXPECT_EQ(default_direction(square(normal)), (Vec3{1, -1, 1}));
}

TEST(View, IsAnotherOneWhereIsoSeesFacesEdgeOn) {
  const Vec3 normal = {1, 1, 0};  // at a right angle to iso
  EXPECT_GT(std::abs(dot(unit(default_direction(square(normal))), unit(normal))), 0.5);
}

TEST(View, TakesWordsAndDirections) {
  EXPECT_EQ(view_direction("top"), (Vec3{0, 0, 1}));
  EXPECT_EQ(view_direction("0,-2,0"), (Vec3{0, -1, 0}));
  for (const char* wrong : {"above", "0,0,0", "1,2", "1,2,x", ""})
    EXPECT_THROW(view_direction(wrong), InvalidInput) << wrong;
}

TEST(View, HasXToTheRightFromTheFrontAndFromAbove) {
  const Frame frame{0, 0, 100, 100};
  for (const char* word : {"front", "top"}) {
    const View view = view_from(view_direction(word), square({1, 1, 1}), frame);
    EXPECT_NEAR(view.right[0], 1, 1e-12) << word;
  }
  EXPECT_NEAR(view_from({0, 0, 1}, square({1, 1, 1}), frame).up[1], 1, 1e-12);
}

TEST(View, KeepsTheSceneWithinItsFrame) {
  const Frame frame{10, 20, 300, 100};
  const View view = view_from({1, -1, 1}, square({0, 0, 1}), frame);
  for (const Vec3& p : square({0, 0, 1})) {
    EXPECT_GT(view(p)[0], 10);
    EXPECT_LT(view(p)[0], 310);
    EXPECT_GT(view(p)[1], 20);
    EXPECT_LT(view(p)[1], 120);
  }
}

TEST(Lettering, HasAllOfAscii) {
  for (char c = '!'; c <= '~'; ++c) {
    const Lettering letter = lettering_of(std::string(1, c), 6);
    EXPECT_FALSE(letter.strokes.empty()) << c;
    for (const auto& stroke : letter.strokes)
      for (const Vec2& p : stroke) {
        EXPECT_GE(p[0], 0) << c;
        EXPECT_LE(p[0], 4) << c;
        EXPECT_GE(p[1], -7) << c;
        EXPECT_LE(p[1], 2) << c;
      }
  }
}

TEST(Lettering, HasABoxForEachCharacterThatItDoesNotKnow) {
  EXPECT_EQ(lettering_of("\u00E4\u6F22", 6).strokes.size(), 2u);
  EXPECT_NE(lettering_of("\u00B2", 6).strokes, lettering_of("\u00E4", 6).strokes);
}

TEST(Lettering, IsCutWithDotsToFit) {
  EXPECT_EQ(fitting("short", 10, 1000), "short");
  const std::string cut = fitting("a name that is much too long", 10, 100);
  EXPECT_TRUE(cut.ends_with("...")) << cut;
  EXPECT_LE(lettering_of(cut, 10).width, 100);
}

Image image_of(const Picture& picture) { return picture_image(picture, scene_meshes(picture)); }

Picture box_picture() {
  Picture picture;
  picture.groups = {{{testing::lid(0)}, kFirstColour, 1, "lid"}};
  return picture;
}

std::ptrdiff_t pixels_like(const Image& image, const Vec3& colour) {
  const auto near = [](std::uint8_t byte, double value) {
    return std::abs(byte - 255 * value) < 24;
  };
  return std::ranges::count_if(image.pixels, [&](const Colour& c) {
    return near(c.red, colour[0]) && near(c.green, colour[1]) && near(c.blue, colour[2]);
  });
}

TEST(Annotations, LeaveRoomToTitleAndLegend) {
  Picture picture = box_picture();
  const Frame plain = free_frame(picture);
  picture.title = "title";
  const Frame titled = free_frame(picture);
  EXPECT_GT(titled.top, plain.top);
  EXPECT_LT(titled.height, plain.height);
  picture.annotated = false;
  EXPECT_EQ(free_frame(picture).height, picture.height);
}

TEST(Annotations, AreDrawnBesideTheScene) {
  Picture picture = box_picture();
  const Image bare = [&] {
    Picture copy = picture;
    copy.groups.front().name.clear();
    return image_of(copy);
  }();
  picture.title = "A title";
  const Image titled = image_of(picture);
  constexpr Vec3 kInk = {0.13, 0.16, 0.20};
  EXPECT_GT(pixels_like(titled, kInk), pixels_like(bare, kInk) + 150);
}

TEST(Annotations, ManyGroupsDoNotHideWhatCurvesMean) {
  Picture picture = box_picture();
  for (int i = 0; i < 60; ++i) picture.groups.push_back({{testing::lid(0)}, kFirstColour, 1, "p"});
  picture.layers = {{"cut", kCurveColour, LayerStyle::Curve, {{{{0, 0, 0}, {1, 0, 0}}}}}};
  EXPECT_GT(free_frame(picture).height, picture.height * 0.6);
}

TEST(Picture, IsOfTheSizeAndFromTheSideThatIsAskedFor) {
  Picture picture = box_picture();
  picture.width = 320;
  picture.height = 200;
  const Image iso = image_of(picture);
  EXPECT_EQ(iso.width, 320);
  EXPECT_EQ(iso.pixels.size(), 320u * 200u);
  picture.view = "front";
  EXPECT_FALSE(image_of(picture).pixels == iso.pixels);
}

TEST(Hatch, LiesOnTheFaceWithinThePolygon) {
  const TopoDS_Face bowl = testing::bowl();
  const std::vector<std::vector<Vec3>> lines =
      hatch_lines(bowl, {{{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}}}, 0.1);
  EXPECT_GT(lines.size(), 5u);
  for (const auto& line : lines)
    for (const Vec3& p : line) {
      EXPECT_NEAR(p[2], p[0] * p[0] + p[1] * p[1], 1e-12);
      EXPECT_LE(std::max(std::abs(p[0]), std::abs(p[1])), 0.5 + 1e-12);
    }
}

TEST(Hatch, LeavesHolesOut) {
  const TopoDS_Face bowl = testing::bowl();
  const std::vector<Vec2> outer = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Vec2> hole = {{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}};
  const std::vector<std::vector<Vec3>> lines = hatch_lines(bowl, {outer, hole}, 0.05);
  EXPECT_GT(lines.size(), 10u);
  for (const auto& line : lines)
    for (const Vec3& p : line) EXPECT_GE(std::max(std::abs(p[0]), std::abs(p[1])), 0.2 - 1e-12);
}

TEST(Hatch, OfAWholeFaceFollowsItsWires) {
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  for (TopExp_Explorer it(pin, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    const auto lines = hatch_lines(face, wire_polygons(face), 0.5);
    EXPECT_GT(lines.size(), 4u);
    for (const auto& line : lines)
      for (const Vec3& p : line) {
        EXPECT_LE(std::hypot(p[0], p[1]), 2 + 1e-3);
        EXPECT_GE(p[2], -1e-12);
        EXPECT_LE(p[2], 5 + 1e-12);
      }
  }
}

// Pictures of the program itself, and what their colours say. A page holds the same layers as
// text.
class PictureOfCommand : public ::testing::Test {
 protected:
  void write(const TopoDS_Shape& shape, const char* name) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      faces.push_back(TopoDS::Face(it.Current()));
    testing::write(faces, folder / name);
  }

  std::string page_of(std::vector<std::string> words) {
    words.insert(words.end(), {"--html", folder / "out.html"});
    const testing::Finished run = testing::blossom(words);
    EXPECT_LE(run.code, 3) << run.err;
    return testing::text_of(folder / "out.html");
  }

  bool says(const std::string& page, const std::string& text) {
    return page.find("\"" + text + "\"") != std::string::npos;
  }

  const testing::TestFolder folder;
};

TEST_F(PictureOfCommand, IntersectTellsCrossingsFromOverlapsAndContacts) {
  write(BRepPrimAPI_MakeBox(10, 10, 4).Shape(), "a.brep");
  write(BRepPrimAPI_MakeBox(gp_Pnt(4, 3, 4), 10, 10, 4).Shape(), "b.brep");
  const std::string overlap = page_of({"intersect", folder / "a.brep", folder / "b.brep"});
  EXPECT_TRUE(says(overlap, "overlapping"));
  EXPECT_TRUE(says(overlap, "crossing"));
  EXPECT_FALSE(says(overlap, "unresolved"));

  write(BRepPrimAPI_MakeSphere(gp_Pnt(5, 5, 6), 2).Shape(), "ball.brep");
  const std::string touch = page_of({"intersect", folder / "a.brep", folder / "ball.brep"});
  EXPECT_TRUE(says(touch, "contact within tolerance"));
  EXPECT_FALSE(says(touch, "crossing"));
}

TEST_F(PictureOfCommand, TrimHasItsPiecesAndTheCurvesThatCut) {
  write(BRepPrimAPI_MakeBox(10, 10, 4).Shape(), "a.brep");
  const std::string page =
      page_of({"trim", folder / "a.brep", "--plane", "5,0,0,1,0,0", "--keep", "all"});
  EXPECT_TRUE(says(page, "cut"));
  EXPECT_TRUE(says(page, "piece 1: below"));
  EXPECT_TRUE(says(page, "piece 2: above"));
}

TEST_F(PictureOfCommand, CheckShowsOpenEdges) {
  testing::write({testing::bowl()}, folder / "bowl.brep");
  EXPECT_TRUE(says(page_of({"check", folder / "bowl.brep"}), "open edge"));
  EXPECT_TRUE(says(page_of({"check", "--continuity", folder / "bowl.brep"}), "not compared"));
}

}  // namespace
}  // namespace blossom::cli
