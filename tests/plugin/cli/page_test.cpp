// SPDX-License-Identifier: LGPL-2.1-or-later
// Pages and glTF files: what is in them, that they need nothing else, and that both can be read.

#include "plugin/pictures/page/page.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <regex>
#include <string>

#include <BRepBndLib.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Bnd_Box.hxx>
#include <RWGltf_CafReader.hxx>
#include <RWMesh_CoordinateSystemConverter.hxx>
#include <nlohmann/json.hpp>

#include "plugin/pictures/page/base64.h"
#include "plugin/pictures/page/glb.h"
#include "plugin/pictures/page/viewer_files.h"
#include "tests/plugin/cli/program.h"

namespace blossom::cli {
namespace {

using namespace pictures;

using nlohmann::json;

std::string encoded(const std::string& text) { return base64(std::as_bytes(std::span(text))); }

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encoded("\xFB\xFF"), "+/8=");
}

Picture bowl_picture() {
  Picture picture;
  picture.title = "bowl";
  picture.groups = {{{testing::bowl()}, kFirstColour, 1, "bowl", {"face 1"}}};
  picture.layers = {{"crossing",
                     kCurveColour,
                     LayerStyle::Curve,
                     {{{{0, 0, 0}, {0.5, 0, 0.25}, {1, 0, 1}}, "a curve"}}},
                    {"contact", kTouchColour, LayerStyle::Ring, {{{{0, 0, 0}}, "a contact"}}}};
  picture.facts = {"two facts", "of a </script> certificate"};
  return picture;
}

std::string page_of(const Picture& picture) { return page_html(picture, scene_meshes(picture)); }

std::string glb_of(const Picture& picture) { return glb_bytes(picture, scene_meshes(picture)); }

json data_of(const std::string& html) {
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = html.find(begin) + begin.size();
  return json::parse(html.substr(from, html.find("</script>", from) - from));
}

TEST(Page, HasEverythingThatThePictureHas) {
  const json data = data_of(page_of(bowl_picture()));
  EXPECT_EQ(data["title"], "bowl");
  EXPECT_EQ(data["groups"][0]["name"], "bowl");
  EXPECT_EQ(data["groups"][0]["faces"][0]["label"], "face 1");
  EXPECT_EQ(data["layers"][0]["style"], "curve");
  EXPECT_EQ(data["layers"][0]["items"][0]["label"], "a curve");
  EXPECT_EQ(data["layers"][1]["style"], "ring");
  EXPECT_EQ(data["facts"][1], "of a </script> certificate");
}

TEST(Page, NeedsNoNetworkAndAllowsNone) {
  std::string html = page_of(bowl_picture());
  EXPECT_NE(html.find("default-src 'none'; script-src 'sha256-"), std::string::npos);
  EXPECT_EQ(html.find("unsafe-inline"), std::string::npos);
  const std::size_t three = html.find(three_script().text);
  ASSERT_NE(three, std::string::npos);
  html.erase(three, three_script().text.size());  // it could fetch, if the policy allowed it
  EXPECT_FALSE(std::regex_search(html, std::regex("(src|href)=|https?:|@import|fetch\\(")));
}

TEST(Page, CarriesTheLicenceOfWhatDrawsIt) {
  EXPECT_EQ(three_script().text.find("/* three.js"), 0u);
  EXPECT_NE(three_script().text.find("The MIT License"), std::string::npos);
}

TEST(Page, TextOfTheSceneCannotEndItsElement) {
  const std::string html = page_of(bowl_picture());
  EXPECT_EQ(html.find("</script> certificate"), std::string::npos);
}

TEST(Page, GetsCoarserTrianglesRatherThanTooLarge) {
  Picture picture;
  picture.groups = {{{}, kFirstColour}};
  for (int i = 0; i < 500; ++i)
    picture.groups.front().faces.push_back(BRepPrimAPI_MakeSphere(gp_Pnt(3.0 * i, 0, 0), 1).Face());
  const std::string html = page_of(picture);
  EXPECT_LT(html.size(), kPageLimit);
  EXPECT_EQ(data_of(html)["groups"][0]["faces"].size(), 500u);
}

TEST(Glb, IsReadByOpenCascadeInItsUnitsAndAxes) {
  const testing::TestFolder folder;
  Picture picture;
  picture.groups = {
      {{BRepPrimAPI_MakeSphere(gp_Pnt(10, 20, 30), 5).Face()}, kFirstColour, 1, "ball"}};
  testing::write_text(folder / "ball.glb", glb_of(picture));

  RWGltf_CafReader reader;
  reader.SetSystemLengthUnit(0.001);
  reader.SetSystemCoordinateSystem(RWMesh_CoordinateSystem_Zup);
  ASSERT_TRUE(reader.Perform((folder / "ball.glb").c_str(), Message_ProgressRange()));
  Bnd_Box box;
  BRepBndLib::Add(reader.SingleShape(), box);
  const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
  EXPECT_NEAR(low.X(), 5, 0.1);
  EXPECT_NEAR(low.Y(), 15, 0.1);
  EXPECT_NEAR(low.Z(), 25, 0.1);
  EXPECT_NEAR(high.Z(), 35, 0.1);
}

TEST(Glb, HasCurvesAsLines) {
  const std::string bytes = glb_of(bowl_picture());
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 8, 4);
  EXPECT_EQ(bytes.size(), length);
  std::memcpy(&length, bytes.data() + 12, 4);
  const json scene = json::parse(bytes.substr(20, length));
  ASSERT_EQ(scene["nodes"].size(), 3u);
  EXPECT_EQ(scene["nodes"][1]["name"], "crossing");
  EXPECT_EQ(scene["meshes"][1]["primitives"][0]["mode"], 1);
  EXPECT_EQ(scene["accessors"][3]["count"], 4);  // two segments
}

TEST(PageOption, WritesPageAndModelBesideThePicture) {
  const testing::TestFolder folder;
  testing::write({testing::bowl()}, folder / "bowl.brep");
  testing::write({testing::half_pipe()}, folder / "pipe.brep");
  const testing::Finished run = testing::blossom(
      {"intersect", folder / "bowl.brep", folder / "pipe.brep", "--html", folder / "a.html",
       "--glb", folder / "a.glb", "--picture", folder / "a.png"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(testing::text_of(folder / "a.html").find("WebGL"), std::string::npos);
  EXPECT_EQ(testing::text_of(folder / "a.glb").substr(0, 4), "glTF");
  EXPECT_EQ(testing::text_of(folder / "a.png").substr(1, 3), "PNG");
}

}  // namespace
}  // namespace blossom::cli
