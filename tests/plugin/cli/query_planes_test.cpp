// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query plane` with many planes, and drawings of sections, as a user runs it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using std::numbers::pi;
using testing::blossom;
using testing::Finished;

// An entity of a DXF file: its kind, and its values by group code.
struct Entity {
  std::string kind;
  std::map<int, std::string> values;

  double number(int code) const { return std::stod(values.at(code)); }
};

struct Dxf {
  std::vector<std::string> layers;
  std::vector<Entity> entities;
};

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  if (!text.empty() && text.back() == '\r') text.pop_back();
  return text;
}

// Group codes and values by turns; sections and tables nest as they have to.
Dxf parsed(const std::string& text) {
  std::istringstream lines(text);
  std::string code, value, section, table;
  Dxf dxf;
  std::vector<Entity> all;
  while (std::getline(lines, code)) {
    EXPECT_TRUE(std::getline(lines, value)) << "a group code without a value";
    const int group = std::stoi(code);
    if (group == 0) all.push_back({trimmed(value), {}});
    EXPECT_FALSE(all.empty());
    if (group != 0) all.back().values.insert({group, trimmed(value)});
  }
  for (const Entity& entity : all) {
    if (entity.kind == "SECTION") {
      EXPECT_EQ(section, "");
      section = entity.values.at(2);
    } else if (entity.kind == "ENDSEC") {
      section = "";
    } else if (section == "TABLES" && entity.kind == "LAYER") {
      dxf.layers.push_back(entity.values.at(2));
    } else if (section == "ENTITIES") {
      dxf.entities.push_back(entity);
    }
  }
  EXPECT_EQ(section, "");
  EXPECT_EQ(all.back().kind, "EOF");
  return dxf;
}

class QueryPlanes : public ::testing::Test {
 protected:
  // A plate of 20 x 10 x 4 with a round hole of radius 3, and a ball of radius 2 beside it.
  void SetUp() override {
    const gp_Ax2 axis(gp_Pnt(10, 5, -1), gp_Dir(0, 0, 1));
    const TopoDS_Shape plate = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 10, 4).Shape(),
                                               BRepPrimAPI_MakeCylinder(axis, 3, 6).Shape());
    occt::Model model;
    model.add(plate, "Plate");
    model.add(BRepPrimAPI_MakeSphere(gp_Pnt(30, 5, 2), 2).Shape(), "Ball");
    occt::write_model(model, folder_ / "set.step");
    file_ = folder_ / "set.step";
  }

  Finished run(const std::vector<std::string>& words) {
    std::vector<std::string> all{"query", "plane", file_};
    all.insert(all.end(), words.begin(), words.end());
    return blossom(all);
  }

  json report(std::vector<std::string> words) {
    words.insert(words.end(), {"--json", "-"});
    const Finished made = run(words);
    EXPECT_EQ(made.code, 0) << made.err;
    return json::parse(made.out);
  }

  testing::TestFolder folder_;
  std::string file_;
};

TEST_F(QueryPlanes, CutsAtEvenOffsetsWithBothEnds) {
  const json found = report({"--offsets", "0.5:3.5:4"});
  EXPECT_EQ(found["schema"], "blossom.sections/1");
  EXPECT_EQ(found["status"], "complete");
  ASSERT_EQ(found["planes"].size(), 4u);
  for (int i = 0; i < 4; ++i) {
    const json& plane = found["planes"][static_cast<std::size_t>(i)];
    EXPECT_NEAR(plane["offset"], 0.5 + i, 1e-12);
    EXPECT_NEAR(plane["point"][2], 0.5 + i, 1e-12);
    ASSERT_EQ(plane["parts"].size(), 2u);
    EXPECT_EQ(plane["parts"][0]["part"], "Plate");
    EXPECT_EQ(plane["parts"][0]["wires"].size(), 2u);
    EXPECT_EQ(plane["parts"][1]["part"], "Ball");
    const double radius = std::sqrt(4 - (i - 1.5) * (i - 1.5));
    EXPECT_NEAR(plane["parts"][1]["wires"][0]["length"], 2 * pi * radius, 1e-8);
  }
}

TEST_F(QueryPlanes, CutsAtOneOffset) {
  const json found = report({"--offsets", "-0.5", "--point", "0,0,2"});
  ASSERT_EQ(found["planes"].size(), 1u);
  EXPECT_EQ(found["planes"][0]["offset"], -0.5);
  EXPECT_EQ(found["planes"][0]["point"], json({0, 0, 1.5}));
}

TEST_F(QueryPlanes, TakesPlanesAsTrimDoes) {
  const json one = report({"--plane", "0,0,1,0,0,2"});
  EXPECT_EQ(one["schema"], "blossom.query/1");
  EXPECT_EQ(one["wires"].size(), 3u);
  const json both = report({"--plane", "0,0,1,0,0,1", "--plane", "5,0,0,1,0,0"});
  ASSERT_EQ(both["planes"].size(), 2u);
  EXPECT_EQ(both["planes"][1]["point"], json({5, 0, 0}));
  EXPECT_EQ(run({"--plane", "0,0,1,0,0,0"}).code, 2);
  EXPECT_EQ(run({"--plane", "0,0,1,0,0,1", "--offsets", "1"}).code, 2);
}

TEST_F(QueryPlanes, TellsAreasWithoutHoles) {
  const json found = report({"--offsets", "2"});
  const json& parts = found["planes"][0]["parts"];
  EXPECT_NEAR(parts[0]["area"], 200 - 9 * pi, 1e-9);
  EXPECT_NEAR(parts[0]["wires"][0]["area"], 200, 1e-9);
  EXPECT_NEAR(parts[0]["wires"][1]["area"], 9 * pi, 1e-9);
  EXPECT_NEAR(parts[1]["area"], 4 * pi, 1e-9);
  const Finished told = run({"--offsets", "2"});
  EXPECT_NE(told.out.find("area 184.292"), std::string::npos) << told.out;  // 200 - 5 pi
  const Finished single = run({"--point", "0,0,2", "--normal", "0,0,1"});
  EXPECT_NE(single.out.find(", area 200\n"), std::string::npos) << single.out;
}

// Twice the area within a wire, positive if it runs counter-clockwise.
double doubled_area(const json& part, const json& wire) {
  std::vector<std::pair<double, double>> points;
  for (const json& use : wire["curves"]) {
    json samples = part["curves"][use["curve"].get<std::size_t>()]["points"];
    if (!use["forward"]) std::reverse(samples.begin(), samples.end());
    for (const json& p : samples) points.emplace_back(p[0], p[1]);
  }
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [x, y] = points[i];
    const auto& [u, v] = points[(i + 1) % points.size()];
    area += x * v - y * u;
  }
  return area;
}

TEST_F(QueryPlanes, TellsWhatIsNotProvenAndWhy) {
  testing::write({testing::bowl()}, folder_ / "bowl.brep");
  file_ = folder_ / "bowl.brep";
  const Finished many = run({"--offsets", "0:0.25:2"});
  EXPECT_EQ(many.code, 3) << many.err;
  EXPECT_NE(many.out.find(" (tolerance): the surfaces touch, or nearly, in places\n  plane 2"),
            std::string::npos)
      << many.out;
  const Finished one = run({"--point", "0,0,0", "--normal", "0,0,1"});
  EXPECT_EQ(one.code, 3) << one.err;
  EXPECT_NE(one.out.find(", 1 contact within tolerance, "), std::string::npos) << one.out;
  EXPECT_NE(one.out.find("  face 1: touching in a point near (0, 0, 0), "), std::string::npos)
      << one.out;
}

TEST_F(QueryPlanes, TurnsOuterWiresCounterClockwiseAndHolesClockwise) {
  const json found = report({"--offsets", "1:1:1"});
  const json& plate = found["planes"][0]["parts"][0];
  std::vector<double> areas;
  for (const json& wire : plate["wires"]) areas.push_back(doubled_area(plate, wire) / 2);
  std::sort(areas.begin(), areas.end());
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_NEAR(areas[0], -9 * pi, 0.5);
  EXPECT_NEAR(areas[1], 200, 1e-9);
}

TEST_F(QueryPlanes, WritesAProductForEachPlaneWithItsParts) {
  const std::string out = folder_ / "cuts.step";
  ASSERT_EQ(run({"--offsets", "1:3:2", "-o", out}).code, 0);
  const std::string text = testing::text_of(out);
  for (const char* name : {"'plane 1, offset 1'", "'plane 2, offset 3'", "'Plate'", "'Ball'"})
    EXPECT_NE(text.find(name), std::string::npos) << name;
  EXPECT_NE(text.find("CIRCLE("), std::string::npos);
  EXPECT_NE(text.find("LINE("), std::string::npos);
}

TEST_F(QueryPlanes, DrawsLinesCirclesAndArcsAsSuchInDxf) {
  const std::string out = folder_ / "cuts.dxf";
  ASSERT_EQ(run({"--offsets", "1:3:2", "-o", out}).code, 0);
  const Dxf dxf = parsed(testing::text_of(out));
  EXPECT_EQ(std::set<std::string>(dxf.layers.begin(), dxf.layers.end()),
            (std::set<std::string>{"0", "PLANE_1-Plate", "PLANE_1-Ball", "PLANE_2-Plate",
                                   "PLANE_2-Ball"}));
  std::map<std::string, int> kinds;
  for (const Entity& entity : dxf.entities)
    if (entity.values.at(8) == "PLANE_2-Plate") ++kinds[entity.kind];
  EXPECT_EQ(kinds, (std::map<std::string, int>{{"LINE", 4}, {"CIRCLE", 1}}));
  for (const Entity& entity : dxf.entities)
    if (entity.values.at(8) == "PLANE_2-Plate" && entity.kind == "CIRCLE") {
      EXPECT_NEAR(entity.number(10), 10, 1e-9);
      EXPECT_NEAR(entity.number(20), 5, 1e-9);
      EXPECT_NEAR(entity.number(30), 3, 1e-9);
      EXPECT_NEAR(entity.number(40), 3, 1e-9);
    }
}

TEST_F(QueryPlanes, CallsLayersLikePlanesThatHaveNames) {
  testing::write_text(folder_ / "planes.txt",
                      "0,0,1,0,0,1 deck, the lower one\n0,0,2,0,0,1 mid ship\n"
                      "0,0,3,0,0,1 mid-ship and much more of it\n0,0,4,0,0,1\n");
  const std::string out = folder_ / "named.dxf";
  ASSERT_EQ(run({"--planes", folder_ / "planes.txt", "-o", out}).code, 0);
  const Dxf dxf = parsed(testing::text_of(out));
  std::set<std::string> layers;
  for (const std::string& name : dxf.layers)
    if (name.ends_with("-Plate")) layers.insert(name);
  EXPECT_EQ(layers, (std::set<std::string>{"DECK__THE_LO-Plate", "MID_SHIP-Plate",
                                           "MID-SHIP_AND-Plate", "PLANE_4-Plate"}));
  ASSERT_EQ(run({"--planes", folder_ / "planes.txt", "-o", folder_ / "named.step"}).code, 0);
  EXPECT_NE(testing::text_of(folder_ / "named.step").find("'deck, the lower one'"),
            std::string::npos);
}

// "plane 2" is also what the second plane without a name would be called.
TEST_F(QueryPlanes, HasLayersForEachPlaneThoughNamesAreAlike) {
  testing::write_text(folder_ / "planes.txt",
                      "0,0,1,0,0,1 DECK\n0,0,2,0,0,1 deck\n0,0,3,0,0,1 DECK\n"
                      "0,0,1.5,0,0,1 plane 5\n0,0,2.5,0,0,1\n");
  const std::string out = folder_ / "alike.dxf";
  ASSERT_EQ(run({"--planes", folder_ / "planes.txt", "-o", out}).code, 0);
  std::map<std::string, std::set<double>> heights;
  for (const Entity& entity : parsed(testing::text_of(out)).entities)
    if (entity.kind == "CIRCLE" && entity.values.at(8).ends_with("-Plate"))
      heights[entity.values.at(8)].insert(entity.number(30));
  EXPECT_EQ(heights, (std::map<std::string, std::set<double>>{{"DECK-Plate", {1}},
                                                              {"DECK_2-Plate", {2}},
                                                              {"DECK_3-Plate", {3}},
                                                              {"PLANE_5-Plate", {1.5}},
                                                              {"PLANE_5_2-Plate", {2.5}}}));
}

TEST_F(QueryPlanes, HasLayersForEachPartThoughJoinedNamesAreAlike) {
  occt::Model model;
  model.add(BRepPrimAPI_MakeBox(1, 1, 4).Shape(), "B-Shaft");
  model.add(BRepPrimAPI_MakeBox(gp_Pnt(5, 0, 0), 1, 1, 4).Shape(), "Shaft");
  occt::write_model(model, folder_ / "shafts.step");
  file_ = folder_ / "shafts.step";
  testing::write_text(folder_ / "planes.txt", "0,0,1,0,0,1 DECK\n0,0,2,0,0,1 DECK-B\n");
  const std::string out = folder_ / "shafts.dxf";
  ASSERT_EQ(run({"--planes", folder_ / "planes.txt", "-o", out}).code, 0);
  std::map<std::string, int> lines;
  for (const Entity& entity : parsed(testing::text_of(out)).entities) ++lines[entity.values.at(8)];
  EXPECT_EQ(
      lines,
      (std::map<std::string, int>{
          {"DECK-B-Shaft", 4}, {"DECK-Shaft", 4}, {"DECK-B-B-Shaft", 4}, {"DECK-B-Shaft_2", 4}}));
}

TEST_F(QueryPlanes, CallsPartsAlikeInLayersOfAllPlanes) {
  // The first plane meets one of the parts with a long name, the second both, and the step of one.
  const std::string longest = "Getriebegehäuse, obere Hälfte, ";
  occt::Model model;
  model.add(BRepPrimAPI_MakeBox(gp_Pnt(20, 0, 4), 4, 4, 8).Shape(), longest + "links");
  model.add(BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(10, 10, 5).Shape(),
                             BRepPrimAPI_MakeBox(gp_Pnt(3, 3, 0), 4, 4, 12).Shape())
                .Shape(),
            longest + "rechts");
  file_ = folder_ / "halves.step";
  occt::write_model(model, file_);
  const std::string out = folder_ / "halves.dxf";
  ASSERT_EQ(run({"--offsets", "2:5:2", "-o", out}).code, 0);
  const Dxf dxf = parsed(testing::text_of(out));
  EXPECT_EQ(
      std::set<std::string>(dxf.layers.begin(), dxf.layers.end()),
      (std::set<std::string>{"0", "PLANE_1-Getriebegehaeuse_", "PLANE_2-Getriebegehaeuse_",
                             "PLANE_2-Getriebegehaeuse_-inner", "PLANE_2-Getriebegehaeus_2"}));
}

TEST_F(QueryPlanes, KeepsPartsInTheModelOfOnePlane) {
  const std::string out = folder_ / "one.step";
  ASSERT_EQ(run({"--point", "0,0,1", "--normal", "0,0,1", "-o", out}).code, 0);
  const std::string text = testing::text_of(out);
  for (const char* name : {"'Plate'", "'Ball'"})
    EXPECT_NE(text.find(name), std::string::npos) << name;
}

TEST_F(QueryPlanes, DrawsArcsCounterClockwiseFromTheirStart) {
  // Through the hole and the corner of the plate stands half a disc: half a circle and lines.
  const TopoDS_Shape disc =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 5, 1, pi / 2);
  occt::Model model;
  model.add(disc, "quarter");
  occt::write_model(model, folder_ / "quarter.step");
  const std::string out = folder_ / "quarter.dxf";
  const Finished made = blossom({"query", "plane", folder_ / "quarter.step", "--point", "0,0,0.5",
                                 "--normal", "0,0,1", "-o", out});
  ASSERT_EQ(made.code, 0) << made.err;
  const Dxf dxf = parsed(testing::text_of(out));
  ASSERT_EQ(dxf.entities.size(), 3u);
  for (const Entity& entity : dxf.entities) {
    EXPECT_EQ(entity.values.at(8), "PLANE_1");
    if (entity.kind != "ARC") continue;
    EXPECT_NEAR(entity.number(40), 5, 1e-9);
    EXPECT_NEAR(entity.number(50), 0, 1e-9);
    EXPECT_NEAR(entity.number(51), 90, 1e-9);
  }
}

TEST_F(QueryPlanes, KeepsWhatBoundsNoMaterialOutOfOutlines) {
  occt::Model model;
  model.add(BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(10, 10, 5).Shape(),
                             BRepPrimAPI_MakeBox(gp_Pnt(3, 3, 0), 4, 4, 12).Shape())
                .Shape(),
            "boss");
  occt::write_model(model, folder_ / "boss.step");
  const auto cut = [&](const std::string& out) {
    const Finished made = blossom({"query", "plane", folder_ / "boss.step", "--point", "0,0,5",
                                   "--normal", "0,0,1", "-o", out});
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.out.find("length 16, inside the section or only touching"), std::string::npos);
    return testing::text_of(out);
  };
  std::map<std::string, int> lines;
  for (const Entity& entity : parsed(cut(folder_ / "boss.dxf")).entities)
    ++lines[entity.values.at(8)];
  EXPECT_EQ(lines, (std::map<std::string, int>{{"PLANE_1", 4}, {"PLANE_1-inner", 4}}));
  EXPECT_NE(cut(folder_ / "boss.svg").find("stroke-dasharray"), std::string::npos);
}

TEST_F(QueryPlanes, HatchesSolidsInSvg) {
  const std::string out = folder_ / "cuts.svg";
  ASSERT_EQ(run({"--offsets", "1:3:3", "-o", out}).code, 0);
  const std::string svg = testing::text_of(out);
  for (const char* text : {"<svg ", "id=\"plane-3\"", "<title>Plate</title>", "url(#hatch-1)",
                           "url(#hatch-2)", "fill-rule=\"evenodd\"", "plane 2, offset 2"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST_F(QueryPlanes, TakesPlanesOfAFile) {
  testing::write_text(folder_ / "planes.txt",
                      "# two planes\n0,0,1, 0,0,2 deck\n\n10 5 2  1 0 0  # the middle\n");
  const json found = report({"--planes", folder_ / "planes.txt"});
  ASSERT_EQ(found["planes"].size(), 2u);
  EXPECT_EQ(found["planes"][0]["name"], "deck");
  EXPECT_EQ(found["planes"][0]["normal"], json({0.0, 0.0, 1.0}));
  EXPECT_TRUE(found["planes"][0]["offset"].is_null());
  EXPECT_EQ(found["planes"][1]["name"], "plane 2");
  EXPECT_EQ(found["planes"][1]["parts"].size(), 1u);  // the ball is beside it
  testing::write_text(folder_ / "bad.txt", "0,0,1,0,0,1\n0,0,1,0,0\n");
  const Finished bad = run({"--planes", folder_ / "bad.txt"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_NE(bad.err.find("line 2: '0,0,1,0,0' is not six"), std::string::npos) << bad.err;
}

TEST_F(QueryPlanes, ShowOfWhichPlaneAndPartACurveIs) {
  const std::string page = folder_ / "page.html", picture = folder_ / "picture.png";
  ASSERT_EQ(run({"--offsets", "1:3:2", "--html", page, "--picture", picture}).code, 0);
  const std::string html = testing::text_of(page);
  EXPECT_NE(html.find("sections of set.step"), std::string::npos);
  EXPECT_NE(html.find("plane 2, offset 3\\nBall"), std::string::npos);
  EXPECT_TRUE(testing::text_of(picture).starts_with("\x89PNG"));
}

TEST_F(QueryPlanes, TellsWhereNothingIsMet) {
  const std::string out = folder_ / "none.step";
  const Finished made = run({"--offsets", "50:60:3", "-o", out});
  EXPECT_EQ(made.code, 0);
  EXPECT_NE(made.out.find("plane 2, offset 55: 0 wires"), std::string::npos) << made.out;
  EXPECT_NE(made.err.find("is not written"), std::string::npos) << made.err;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(QueryPlanes, DrawNothingWhereNothingIsMet) {
  const std::string out = folder_ / "none.dxf";
  EXPECT_EQ(run({"--offsets", "50:60:3", "-o", out}).code, 0);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(QueryPlaneOfWires, FindsPointsAndEdgesInThePlane) {
  const testing::TestFolder folder;
  BRepBuilderAPI_MakePolygon way;  // up, along the plane, and down
  for (const gp_Pnt& p : {gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 2), gp_Pnt(4, 0, 2), gp_Pnt(4, 0, 0)})
    way.Add(p);
  BRepTools::Write(way.Wire(), (folder / "way.brep").c_str());
  const auto cut = [&](const char* plane) {
    const Finished run =
        blossom({"query", "plane", folder / "way.brep", "--plane", plane, "--json", "-"});
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  };
  const json across = cut("0,0,1,0,0,1");
  EXPECT_EQ(across["status"], "complete");
  ASSERT_EQ(across["points"].size(), 2U);
  EXPECT_EQ(across["nodes"][0]["on"], (json{{"kind", "edge"}, {"number", 1}}));
  EXPECT_EQ(across["nodes"][1]["point"], (json{4, 0, 1}));
  const json along = cut("0,0,2,0,0,1");
  EXPECT_TRUE(along["points"].empty());
  ASSERT_EQ(along["wires"].size(), 1U);
  EXPECT_EQ(along["wires"][0]["length"], 4);
  EXPECT_EQ(along["wires"][0]["bounding"], false);
  const Finished many = blossom({"query", "plane", folder / "way.brep", "--offsets", "0.5:1.5:2",
                                 "-o", folder / "cuts.step"});
  EXPECT_EQ(many.code, 0) << many.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "cuts.step"));
}

}  // namespace
}  // namespace blossom
