// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom info`, `--version` and `--help`, as a user runs them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_Ax2.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

TEST(InfoCommand, TellsSurfaceDegreeSpansAndValidityOfEachFace) {
  const testing::TestFolder folder;
  testing::write({testing::bowl(), testing::half_pipe()}, folder / "parts.brep");

  const Finished run = blossom({"info", folder / "parts.brep", "--json", "-"});

  ASSERT_EQ(run.code, 0) << run.err;
  const json info = json::parse(run.out);
  EXPECT_EQ(info["schema"], "blossom.info/1");
  EXPECT_EQ(info["counts"]["faces"], 2);
  EXPECT_EQ(info["surfaces"], json({{"bezier", 2}}));
  EXPECT_EQ(info["valid"], true);
  EXPECT_NEAR(info["box"][1][2].get<double>(), 2, 1e-6);
  const json& pipe = info["faces"][1];
  EXPECT_EQ(pipe["number"], 2);
  EXPECT_EQ(pipe["degree"], json({3, 1}));
  EXPECT_EQ(pipe["spans"], json({1, 1}));
  EXPECT_EQ(pipe["rational"], true);
  EXPECT_EQ(info["faces"][0]["rational"], false);
  EXPECT_EQ(pipe["tolerance"], 1e-7);
  EXPECT_EQ(pipe["valid"], true);
}

TEST(InfoCommand, TellsRadiiNormalsAreasAndColours) {
  const testing::TestFolder folder;
  occt::Model model;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 2).Shape();
  const gp_Ax2 up(gp_Pnt(5, 4, 0), gp_Dir(0, 0, 1));
  model.add(BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(up, 1.5, 2).Shape()).Shape(), "plate",
            {1, 0, 0});
  model.add(BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(30, 0, 0), gp_Dir(0, 0, 1)), 2, 1, 1).Shape(), "");
  model.add(BRepPrimAPI_MakeSphere(gp_Pnt(0, 30, 0), 3).Shape(), "ball");
  model.add(BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(0, 0, 30), gp_Dir(1, 0, 0)), 5, 1).Shape(), "ring");
  occt::write_model(model, folder / "all.step");
  const Finished run = blossom({"info", folder / "all.step", "--faces", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  std::map<std::string, json> faces;
  for (const json& face : report["faces"]) faces[face["surface"]] = face;

  const json& bore = faces.at("cylinder");
  EXPECT_EQ(bore["radius"], 1.5);
  EXPECT_EQ(bore["hollow"], true);
  EXPECT_EQ(bore["on_axis"][0], 5);
  EXPECT_EQ(std::abs(bore["axis"][2].get<double>()), 1);
  EXPECT_NEAR(bore["area"].get<double>(), 2 * std::numbers::pi * 1.5 * 2, 1e-8);
  EXPECT_NEAR(bore["colour"][0].get<double>(), 1, 1e-12);
  EXPECT_EQ(bore["colour"][2], 0);
  EXPECT_NEAR(faces.at("cone")["half_angle"].get<double>(), std::numbers::pi / 4, 1e-12);
  EXPECT_FALSE(faces.at("cone").contains("colour"));
  EXPECT_EQ(faces.at("sphere")["centre"], json({0.0, 30.0, 0.0}));
  EXPECT_EQ(faces.at("sphere")["hollow"], false);
  EXPECT_EQ(faces.at("torus")["radii"], json({5.0, 1.0}));
  EXPECT_EQ(faces.at("plane")["normal"].size(), 3u);

  const std::string list = blossom({"info", folder / "all.step", "--faces"}).out;
  EXPECT_TRUE(std::regex_search(
      list, std::regex("cylinder +radius 1.5, hollow +18.8496 +1e-07 +valid +#ff0000 +plate\n")))
      << list;
  EXPECT_NE(list.find("normal 0, 0, 1 "), std::string::npos) << list;  // outward, of the top
  EXPECT_NE(list.find("half angle 45\u00b0"), std::string::npos) << list;
  EXPECT_FALSE(
      json::parse(blossom({"info", folder / "all.step", "--json", "-"}).out)["faces"][0].contains(
          "area"));
}

TEST(InfoCommand, ShowsTheModelAsAPictureAPageAndAModelOfTriangles) {
  const testing::TestFolder folder;
  testing::write({testing::bowl(), testing::half_pipe()}, folder / "parts.brep");
  const Finished run =
      blossom({"info", folder / "parts.brep", "--picture", folder / "a.png", "--html",
               folder / "a.html", "--glb", folder / "a.glb", "--view", "top"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(testing::text_of(folder / "a.png").substr(1, 3), "PNG");
  EXPECT_NE(testing::text_of(folder / "a.html").find("face 2\\nbezier"), std::string::npos);
  EXPECT_EQ(testing::text_of(folder / "a.glb").substr(0, 4), "glTF");
  // One picture is of one model.
  const Finished two = blossom(
      {"info", folder / "parts.brep", folder / "parts.brep", "--picture", folder / "b.png"});
  EXPECT_EQ(two.code, 2) << two.out;
}

TEST(InfoCommand, ShowsTheSizeOfABoxFarFromTheOriginAndNoRoundings) {
  const testing::TestFolder folder;
  occt::Model model;
  model.add(BRepPrimAPI_MakeBox(gp_Pnt(1e7, -1e-16, 0), 1, 2, 3).Shape(), "far");
  occt::write_model(model, folder / "far.brep");
  const Finished run = blossom({"info", folder / "far.brep"});
  EXPECT_NE(run.out.find("box (mm): [10000000, 0, 0] to [10000001, 2, 3]"), std::string::npos)
      << run.out;
}

TEST(InfoCommand, SaysThatAModelHasNoSurface) {
  const testing::TestFolder folder;
  occt::Model model;
  model.add(BRepBuilderAPI_MakePolygon(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Shape(), "wire");
  occt::write_model(model, folder / "wire.brep");
  const Finished run = blossom({"info", folder / "wire.brep"});
  EXPECT_NE(run.out.find("surfaces: none"), std::string::npos) << run.out;
}

TEST(InfoCommand, NamesFacesAfterTheirParts) {
  const testing::TestFolder folder;
  testing::write({testing::bowl(), testing::half_pipe()}, folder / "parts.step");
  const Finished run = blossom({"info", folder / "parts.step", "--json", "-"});
  const json info = json::parse(run.out);
  EXPECT_EQ(info["file_unit"], "MM");
  EXPECT_EQ(info["faces"][0]["name"], "part 1");
  EXPECT_EQ(info["faces"][1]["name"], "part 2");
}

TEST(InfoCommand, ListsOnlyTheChosenFaces) {
  const testing::TestFolder folder;
  testing::write({testing::bowl(), testing::half_pipe()}, folder / "parts.brep");
  const Finished run = blossom({"info", (folder / "parts.brep").string() + "#2", "--json", "-"});
  const json info = json::parse(run.out);
  ASSERT_EQ(info["faces"].size(), 1u);
  EXPECT_EQ(info["faces"][0]["number"], 2);
  EXPECT_EQ(info["counts"]["faces"], 1);
  const Finished all = blossom({"info", folder / "parts.brep", "--json", "-"});
  EXPECT_NE(info["box"], json::parse(all.out)["box"]);
}

TEST(InfoCommand, CountsASolidThatIsNamed) {
  const testing::TestFolder folder;
  occt::Model two;
  two.add(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), "Cube");
  two.add(BRepPrimAPI_MakeSphere(gp_Pnt(9, 0, 0), 2).Shape(), "Ball");
  occt::write_model(two, folder / "two.brep");
  const Finished run =
      blossom({"info", (folder / "two.brep").string() + "#solid:2", "--json", "-"});
  const json info = json::parse(run.out);
  EXPECT_EQ(info["counts"]["solids"], 1);
  EXPECT_EQ(info["counts"]["faces"], 1);
  EXPECT_NEAR(info["box"][0][0].get<double>(), 7, 1e-6);
}

// Faces inside the box of the corners say nothing new, but curved ones reach beyond them.
TEST(InfoCommand, BoxesFacesThatReachBeyondAllCorners) {
  const testing::TestFolder folder;
  const double along = std::sqrt(0.5), radius = 2;
  const gp_Ax2 axes(gp_Pnt(1, 2, 3), gp_Dir(along, along, 0));
  BRepPrimAPI_MakeBox cube(gp_Pnt(0.5, 1.5, 2.5), gp_Pnt(1.5, 2.5, 3.5));
  BRepPrimAPI_MakeSphere ball(axes, radius);
  testing::write({cube.TopFace(), ball.Face(), cube.LeftFace()}, folder / "ball.brep");
  const Finished run = blossom({"info", folder / "ball.brep", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json box = json::parse(run.out)["box"];
  const double middle[] = {1, 2, 3};
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(box[0][k].get<double>(), middle[k] - radius, 1e-6);
    EXPECT_NEAR(box[1][k].get<double>(), middle[k] + radius, 1e-6);
  }
}

TEST(InfoCommand, PrintsATableForPeople) {
  const testing::TestFolder folder;
  testing::write({testing::half_pipe()}, folder / "pipe.step");
  const Finished run = blossom({"info", folder / "pipe.step", "--faces"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(blossom({"info", folder / "pipe.step"}).out.find("degree"), std::string::npos);
  EXPECT_NE(run.out.find(", 1 face, "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("degree 3 x 1, spans 1 x 1, rational"), std::string::npos) << run.out;
  EXPECT_EQ(run.err, "");
}

// A prism over a corner that is nearly none: its angle in degrees has eleven characters.
TEST(InfoCommand, KeepsTheColumnsOfEdgesApart) {
  const testing::TestFolder folder;
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [x, y] :
       {std::pair{0.0, 0.0}, {1.0, 0.0}, {2.0, 1.2345e-5}, {2.0, 3.0}, {0.0, 3.0}})
    outline.Add(gp_Pnt(x, y, 0));
  outline.Close();
  const TopoDS_Face base = BRepBuilderAPI_MakeFace(outline.Wire()).Face();
  occt::Model model;
  model.add(BRepPrimAPI_MakePrism(base, gp_Vec(0, 0, 5)).Shape(), "prism");
  occt::write_model(model, folder / "prism.brep");

  const Finished run = blossom({"info", folder / "prism.brep", "--edges"});

  const std::regex row(R"( *\d+  \d+, \d+ +[a-z]+ +[0-9.e-]+ +[0-9.e-]+ +\[.*\])");
  std::istringstream lines(run.out.substr(run.out.find("  edge  faces")));
  std::string line;
  std::getline(lines, line);
  int rows = 0;
  for (; std::getline(lines, line); ++rows) EXPECT_TRUE(std::regex_match(line, row)) << line;
  EXPECT_EQ(rows, 15);
}

TEST(InfoCommand, TellsParametersOfEdgesAndWherePolesAre) {
  const testing::TestFolder folder;
  occt::Model model;
  model.add(BRepPrimAPI_MakeSphere(gp_Pnt(50, 30, 20), 10).Shape(), "ball");
  occt::write_model(model, folder / "ball.brep");
  ASSERT_EQ(blossom({"info", folder / "ball.brep", "--edges", "--json", folder / "r.json"}).code,
            0);
  const json edges = json::parse(testing::text_of(folder / "r.json"))["edges"];
  ASSERT_EQ(edges.size(), 3u);
  std::vector<double> heights;
  for (const json& edge : edges) {
    const std::string kind = edge["kind"];
    const double length = edge["parameters"][1].get<double>() - edge["parameters"][0].get<double>();
    EXPECT_NEAR(length, (kind == "seam" ? 1 : 2) * std::numbers::pi, 1e-9);
    if (kind == "point") heights.push_back(edge["middle"][2]);
  }
  std::sort(heights.begin(), heights.end());
  ASSERT_EQ(heights.size(), 2u);
  EXPECT_NEAR(heights[0], 10, 1e-9);
  EXPECT_NEAR(heights[1], 30, 1e-9);
}

TEST(Program, SaysItsVersionAndLicence) {
  const Finished run = blossom({"--version"});
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.out.find("blossom " BLOSSOM_VERSION), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("Licence: LGPL-2.1-or-later"), std::string::npos) << run.out;
  for (const char* library :
       {"Open CASCADE 7.", "oneTBB 20", "Boost 1.", "CLI11 ", "JSON for Modern C++ 3.", "zlib 1."})
    EXPECT_NE(run.out.find(library), std::string::npos) << run.out;
}

TEST(Program, ShowsOptionsOfACommandBeforeThoseOfMany) {
  const std::string help = blossom({"intersect", "--help"}).out;
  const std::size_t own = help.find("--joined"), shared = help.find("Shared");
  ASSERT_NE(own, std::string::npos);
  ASSERT_NE(shared, std::string::npos);
  EXPECT_LT(own, shared);
  EXPECT_GT(help.find("--time-limit"), shared);
  EXPECT_EQ(help.find("--form"), std::string::npos);
  EXPECT_NE(help.find("Exit status"), std::string::npos);
  EXPECT_EQ(help.find("model units"), std::string::npos);
}

TEST(Program, ShowsItsCommands) {
  const Finished run = blossom({"--help"});
  EXPECT_EQ(run.code, 0);
  for (const char* command :
       {"info", "check", "intersect", "trim", "blend", "subdivide", "convert", "query"})
    EXPECT_NE(run.out.find(command), std::string::npos) << run.out;
}

}  // namespace
}  // namespace blossom
