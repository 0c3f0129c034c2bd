// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query`, as a user runs it.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

class QueryCommand : public ::testing::Test {
 protected:
  // A bowl z = x^2 + y^2 and a lid at z = 1.
  void SetUp() override {
    testing::write({testing::bowl(), testing::lid(1)}, folder_ / "pot.brep");
    pot_ = folder_ / "pot.brep";
  }

  testing::TestFolder folder_;
  std::string pot_;
};

TEST_F(QueryCommand, ListsWhatARayHitsInOrder) {
  const Finished run = blossom(
      {"query", "ray", pot_, "--from", "0.5,0.25,3", "--direction", "0,0,-2", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json found = json::parse(run.out);
  EXPECT_EQ(found["schema"], "blossom.query/1");
  EXPECT_EQ(found["kind"], "ray");
  EXPECT_EQ(found["status"], "complete");
  ASSERT_EQ(found["hits"].size(), 2u);
  EXPECT_NEAR(found["hits"][0]["distance"].get<double>(), 2, 1e-12);
  EXPECT_EQ(found["hits"][0]["face"], 2);
  const json& bowl = found["hits"][1];
  EXPECT_NEAR(bowl["distance"].get<double>(), 3 - 0.3125, 1e-12);
  EXPECT_EQ(bowl["face"], 1);
  EXPECT_NEAR(bowl["uv"][0].get<double>(), 0.75, 1e-12);
  EXPECT_NEAR(bowl["uv"][1].get<double>(), 0.625, 1e-12);
  EXPECT_NEAR(bowl["point"][2].get<double>(), 0.3125, 1e-12);
  EXPECT_EQ(bowl["on"], json({{"kind", "face"}, {"number", 1}}));
  EXPECT_EQ(bowl["grazing"], false);
}

TEST_F(QueryCommand, CutsAModelWithAPlane) {
  const std::string wires = folder_ / "wires.brep";
  const Finished run = blossom({"query", "plane", pot_, "--point", "0,0,0.5", "--normal", "0,0,3",
                                "-o", wires, "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json found = json::parse(run.out);
  EXPECT_EQ(found["schema"], "blossom.query/1");
  EXPECT_EQ(found["kind"], "plane");
  EXPECT_EQ(found["status"], "complete");
  EXPECT_EQ(found["normal"], json({0.0, 0.0, 1.0}));
  ASSERT_EQ(found["wires"].size(), 1u);
  EXPECT_EQ(found["wires"][0]["closed"], true);
  EXPECT_NEAR(found["wires"][0]["length"].get<double>(), 6.283185307179586 * std::sqrt(0.5), 1e-8);
  EXPECT_EQ(found["curves"][0]["on"], json({{"kind", "face"}, {"number", 1}}));
  EXPECT_EQ(found["faces_in_plane"].size(), 0u);
  EXPECT_EQ(found["certificate"]["faces_searched"], 1);
  EXPECT_TRUE(std::filesystem::exists(wires));
}

TEST_F(QueryCommand, TellsThatThereIsNoWireToWrite) {
  const std::string wires = folder_ / "wires.brep";
  const Finished run = blossom({"query", "plane", pot_, "--point", "0,0,9", "--normal", "0,0,1",
                                "-o", wires, "--json", "-"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "blossom: " + wires + " is not written: no wire and no point was found\n");
  EXPECT_EQ(json::parse(run.out)["status"], "complete");
  EXPECT_FALSE(std::filesystem::exists(wires));
}

TEST_F(QueryCommand, RefusesAPlaneWithoutADirection) {
  const Finished run = blossom({"query", "plane", pot_, "--point", "0,0,0.5", "--normal", "0,0,0"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("--normal"), std::string::npos) << run.err;
}

TEST_F(QueryCommand, StopsAtTheFirstHitOfARay) {
  const Finished run = blossom(
      {"query", "ray", pot_, "--from", "0,0,3", "--direction", "0,0,-1", "--first", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json found = json::parse(run.out);
  ASSERT_EQ(found["hits"].size(), 1u);
  EXPECT_EQ(found["hits"][0]["face"], 2);
}

TEST_F(QueryCommand, SaysThatATouchIsWithinTolerance) {
  const Finished run =
      blossom({"query", "ray", pot_ + "#1", "--from", "-3,0,0", "--direction", "1,0,0"});
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.out.find("1 hit\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("grazing, tolerance"), std::string::npos) << run.out;
}

TEST_F(QueryCommand, LooksBothWaysAlongALine) {
  const std::vector<std::string> ray{"query",       "ray",   pot_,     "--from", "0,0,0.5",
                                     "--direction", "0,0,1", "--json", "-"};
  EXPECT_EQ(json::parse(blossom(ray).out)["hits"].size(), 1u);
  std::vector<std::string> line = ray;
  line.push_back("--line");
  const json hits = json::parse(blossom(line).out)["hits"];
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0]["distance"].get<double>(), -0.5, 1e-12);
}

TEST_F(QueryCommand, NamesTheEdgeOrVertexThatIsHit) {
  const Finished run = blossom({"query", "ray", pot_ + "#2", "--from", "-1.5,-1.5,3", "--direction",
                                "0,0,-1", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(json::parse(run.out)["hits"][0]["on"]["kind"], "vertex");
}

TEST_F(QueryCommand, TakesDirectionsThatStartWithAMinus) {
  const Finished run = blossom(
      {"query", "ray", pot_, "--from", "-3,0,0.5", "--direction", "-1,-0.5,0", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(json::parse(run.out)["hits"].empty());
}

TEST_F(QueryCommand, FindsTheNearestPoint) {
  const Finished run = blossom({"query", "point", pot_, "--at", "0.5,-0.25,1.5", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json found = json::parse(run.out);
  EXPECT_EQ(found["kind"], "point");
  EXPECT_NEAR(found["distance"][0].get<double>(), 0.5, 1e-9);
  EXPECT_NEAR(found["distance"][1].get<double>(), 0.5, 1e-12);
  EXPECT_EQ(found["nearest"]["on"], json({{"kind", "face"}, {"number", 2}}));
  EXPECT_NEAR(found["nearest"]["point"][0].get<double>(), 0.5, 1e-9);
}

TEST_F(QueryCommand, ListsAllFeetOfAPoint) {
  const Finished run =
      blossom({"query", "point", pot_ + "#2", "--at", "0.5,-0.25,1.5", "--all", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json feet = json::parse(run.out)["feet"];
  ASSERT_EQ(feet.size(), 5u);  // on the face and on its four sides
  EXPECT_NEAR(feet[0]["distance"].get<double>(), 0.5, 1e-12);
  EXPECT_EQ(feet[0]["extremum"], "minimum");
  EXPECT_EQ(feet[0]["on"]["kind"], "face");
  EXPECT_EQ(feet[4]["on"]["kind"], "edge");
}

TEST_F(QueryCommand, MeasuresTheDistanceOfTwoModels) {
  const Finished run = blossom({"query", "distance", pot_ + "#2", pot_ + "#1", "--json", "-"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(json::parse(run.out)["distance"][0], 0);
  testing::write({testing::lid(-2)}, folder_ / "floor.step");
  const std::string floor = folder_ / "floor.step";
  const Finished apart = blossom({"query", "distance", pot_, floor, "--json", "-"});
  ASSERT_EQ(apart.code, 0) << apart.err;
  const json found = json::parse(apart.out);
  EXPECT_NEAR(found["distance"][0].get<double>(), 2, 1e-9);
  EXPECT_NEAR(found["distance"][1].get<double>(), 2, 1e-12);
  EXPECT_EQ(found["nearest_a"]["on"]["number"], 1);
  EXPECT_NEAR(found["nearest_b"]["point"][2].get<double>(), -2, 1e-12);
}

TEST_F(QueryCommand, TellsWhetherModelsMeet) {
  testing::write({testing::lid(-1)}, folder_ / "floor.brep");
  testing::write({testing::lid(0)}, folder_ / "table.brep");
  testing::write({testing::lid(0.5)}, folder_ / "ring.brep");
  const auto answer = [&](const std::string& a, const std::string& b, int code) {
    const Finished run = blossom({"query", "does-intersect", a, b, "--json", "-"});
    EXPECT_EQ(run.code, code) << run.err;
    return json::parse(run.out)["answer"].get<std::string>();
  };
  EXPECT_EQ(answer(pot_, folder_ / "floor.brep", 0), "no");
  EXPECT_EQ(answer(pot_ + "#1", folder_ / "ring.brep", 0), "yes");
  EXPECT_EQ(answer(pot_ + "#1", folder_ / "table.brep", 3), "touching");
}

void write_parts(const std::vector<std::pair<TopoDS_Shape, std::string>>& parts,
                 const std::filesystem::path& file) {
  occt::quiet_messages();
  occt::Model model;
  for (const auto& [shape, name] : parts) model.add(shape, name);
  occt::write_model(model, file);
}

class QueryOfSolids : public QueryCommand {
 protected:
  void SetUp() override {
    QueryCommand::SetUp();
    const TopoDS_Shape cube = BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, -2), gp_Pnt(2, 2, 2)).Shape();
    write_parts({{cube, "Box"}}, box_);
    write_parts({{BRepPrimAPI_MakeSphere(1).Shape(), "Ball"}}, ball_);
    write_parts({{BRepPrimAPI_MakeSphere(gp_Pnt(9, 0, 0), 1).Shape(), "Far"},
                 {BRepPrimAPI_MakeSphere(gp_Pnt(2, 0, 0), 1).Shape(), "Near"}},
                two_);
  }

  const std::string box_ = folder_ / "box.step", ball_ = folder_ / "ball.step",
                    two_ = folder_ / "two.step";
};

TEST_F(QueryOfSolids, KnowsThatABallInABoxMeetsIt) {
  const Finished run = blossom({"query", "does-intersect", ball_, box_, "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json found = json::parse(run.out);
  EXPECT_EQ(found["answer"], "yes");
  EXPECT_EQ(found["relation"], "a inside b");
  EXPECT_EQ(found["distance"], json({0.0, 0.0}));
  EXPECT_GT(found["boundary_distance"][0], 0);
  EXPECT_EQ(found["solids_a"], 1);
  EXPECT_EQ(found["surface_faces_a"], 0);
  const Finished turned = blossom({"query", "does-intersect", box_, ball_});
  EXPECT_NE(turned.out.find("yes, " + ball_ + " is inside " + box_), std::string::npos)
      << turned.out;
}

TEST_F(QueryOfSolids, MeetingModelsAreFindingsOnlyIfThatIsAsked) {
  const auto code = [&](const std::string& other, const std::vector<std::string>& more) {
    std::vector<std::string> words{"query", "does-intersect", box_, other};
    words.insert(words.end(), more.begin(), more.end());
    return blossom(words).code;
  };
  const std::string far = (folder_ / "far.brep").string();
  testing::write({testing::lid(100)}, far);
  EXPECT_EQ(code(ball_, {}), 0);
  EXPECT_EQ(code(ball_, {"--fail-on", "findings"}), 5);
  EXPECT_EQ(code(far, {"--fail-on", "findings"}), 0);
}

TEST_F(QueryOfSolids, FindingsOfDistancesNeedAnAllowedOne) {
  const Finished run = blossom({"query", "distance", box_, ball_, "--fail-on", "findings"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("--fail-on needs --within"), std::string::npos) << run.err;
}

TEST_F(QueryOfSolids, TellsTheDistanceOfBoundariesApart) {
  const Finished run = blossom({"query", "distance", ball_, box_, "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json found = json::parse(run.out);
  EXPECT_EQ(found["distance"], json({0.0, 0.0}));
  EXPECT_NEAR(found["boundary_distance"][0].get<double>(), 1, 1e-9);
  EXPECT_NEAR(found["boundary_distance"][1].get<double>(), 1, 1e-12);
  EXPECT_EQ(found["relation"], "a inside b");
  const std::string text = blossom({"query", "distance", ball_, box_}).out;
  EXPECT_NE(text.find("boundaries: distance 1"), std::string::npos) << text;
}

TEST_F(QueryOfSolids, TakesNamedFacesForASurfaceAndSaysSo) {
  const std::string wall = box_ + "#1";
  const Finished run = blossom({"query", "does-intersect", ball_, wall});
  EXPECT_EQ(run.out.rfind(ball_ + " - " + wall + ": no\n", 0), 0U) << run.out;
  EXPECT_NE(run.out.find(wall + " is taken as a surface"), std::string::npos) << run.out;
  const json found = json::parse(blossom({"query", "distance", ball_, wall, "--json", "-"}).out);
  EXPECT_NEAR(found["distance"][1].get<double>(), 1, 1e-12);
  EXPECT_EQ(found["solids_b"], 0);
  EXPECT_EQ(found["surface_faces_b"], 1);
  const Finished sheets = blossom({"query", "does-intersect", pot_, box_});
  EXPECT_NE(sheets.out.find("it has no closed solid"), std::string::npos) << sheets.out;
}

TEST_F(QueryOfSolids, ListsPairsByTheirParts) {
  const Finished run = blossom({"query", "does-intersect", two_, box_, "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json found = json::parse(run.out);
  EXPECT_EQ(found["relation"], "crossing");
  ASSERT_EQ(found["pairs"].size(), 1U);
  EXPECT_EQ(found["pairs"][0],
            json::parse(R"({"a": {"solid": 2, "part": "Near"}, "b": {"solid": 1, "part": "Box"},
                            "relation": "crossing", "status": "complete"})"));
  const std::string text = blossom({"query", "does-intersect", two_, box_}).out;
  EXPECT_NE(text.find("solid 2 of " + two_ + " (Near) - "), std::string::npos) << text;
}

TEST_F(QueryOfSolids, TellWhereAPointLies) {
  const auto place = [&](const std::string& at) {
    const Finished run = blossom({"query", "point", box_, "--at", at, "--json", "-"});
    return json::parse(run.out)["solids"][0]["place"].get<std::string>();
  };
  EXPECT_EQ(place("0.5,0.25,1"), "inside");
  EXPECT_EQ(place("0.5,0.25,2"), "on the boundary");
  EXPECT_EQ(place("0.5,0.25,3"), "outside");
  const std::string text = blossom({"query", "point", box_, "--at", "0,0,1"}).out;
  EXPECT_NE(text.find("inside: solid 1 of " + box_), std::string::npos) << text;
}

TEST_F(QueryOfSolids, TellsMassesPartByPartAndInAll) {
  const Finished run = blossom({"query", "mass", two_, "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json found = json::parse(run.out);
  const double ball = 4 * 3.141592653589793 / 3;
  EXPECT_EQ(found["kind"], "mass");
  EXPECT_EQ(found["status"], "complete");
  ASSERT_EQ(found["parts"].size(), 2U);
  const json& near = found["parts"][1];
  EXPECT_EQ(near["name"], "Near");
  EXPECT_EQ(near["solid"], 2);
  EXPECT_NEAR(near["volume"].get<double>(), ball, 1e-9);
  EXPECT_NEAR(near["area"].get<double>(), 3 * ball, 1e-9);
  EXPECT_NEAR(near["centre"][0].get<double>(), 2, 1e-9);
  EXPECT_NEAR(near["inertia"][2][2].get<double>(), 0.4 * ball, 1e-9);
  EXPECT_NEAR(found["total"]["volume"].get<double>(), 2 * ball, 1e-9);
  EXPECT_NEAR(found["total"]["centre"][0].get<double>(), 5.5, 1e-9);
  EXPECT_NEAR(found["total"]["inertia"][2][2].get<double>(), ball * (0.8 + 2 * 3.5 * 3.5), 1e-8);
  EXPECT_NE(blossom({"query", "mass", box_}).out.find("Box: volume 64 mm³, area 96 mm²"),
            std::string::npos);
}

TEST_F(QueryOfSolids, GivesSurfacesAnAreaAndNoVolume) {
  const json found = json::parse(blossom({"query", "mass", box_ + "#1", "--json", "-"}).out);
  ASSERT_EQ(found["parts"].size(), 1U);
  EXPECT_EQ(found["parts"][0]["solid"], nullptr);
  EXPECT_NEAR(found["parts"][0]["area"].get<double>(), 16, 1e-12);
  EXPECT_FALSE(found["parts"][0].contains("volume"));
  EXPECT_EQ(found["total"], nullptr);
}

TEST_F(QueryCommand, StopsWhenTheTimeIsSpent) {
  const Finished run = blossom({"query", "ray", pot_, "--from", "0,0,10", "--direction", "0,0.1,-1",
                                "--time-limit", "1e-9", "--json", "-"});
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_EQ(json::parse(run.out)["status"], "stopped");
  EXPECT_TRUE(json::parse(run.out)["hits"].empty());
}

// What needs no search is proven in any time; the status is no weaker than what is known.
TEST_F(QueryCommand, TakesATimeLimitForEveryKind) {
  const std::vector<std::vector<std::string>> all{
      {"query", "plane", pot_, "--point", "0,0,0.5", "--normal", "0.1,0,1"},
      {"query", "point", pot_, "--at", "0.3,0.2,1", "--all"},
      {"query", "mass", pot_},
      {"query", "distance", pot_ + "#2", pot_ + "#1"},
      {"query", "does-intersect", pot_ + "#2", pot_ + "#1"}};
  for (std::vector<std::string> arguments : all) {
    arguments.insert(arguments.end(), {"--time-limit", "60", "--json", "-"});
    const Finished run = blossom(arguments);
    EXPECT_NE(json::parse(run.out)["status"], "stopped") << arguments[1] << run.err;
    EXPECT_EQ(blossom({"query", arguments[1], "--time-limit", "0"}).code, 2) << arguments[1];
  }
}

TEST_F(QueryCommand, RefusesQuestionsThatMakeNoSense) {
  struct Bad {
    std::vector<std::string> arguments;
    std::string says;
  };
  const std::string missing = folder_ / "missing.step";
  const std::vector<Bad> all{
      {{"query"}, "query needs one of its commands"},
      {{"query", "ray", pot_}, "query ray needs --from X,Y,Z"},
      {{"query", "ray", pot_, "--from", "0,0,0", "--direction", "0,0,0"}, "zero vector"},
      {{"query", "ray", pot_, "--from", "0,0", "--direction", "0,0,1"}, "three finite numbers"},
      {{"query", "ray", pot_, "--from", "0,0,0,0", "--direction", "0,0,1"}, "three finite"},
      {{"query", "ray", pot_, "--from", "0,nan,0", "--direction", "0,0,1"}, "three finite"},
      {{"query", "ray", pot_, "--from", "0,0,0", "--direction", "0,inf,1"}, "three finite"},
      {{"query", "ray", pot_, "--from", "0,0,0", "--direction", "0,x,1"}, "three finite"},
      {{"query", "ray", pot_, "--from", "0,0,0", "--direction", "0,0,1", "--tolerance", "0"},
       "--tolerance"},
      {{"query", "point", pot_}, "query point needs --at X,Y,Z"},
      {{"query", "point", pot_, "--at", "1;2;3"}, "three finite numbers"},
      {{"query", "point", missing, "--at", "1,2,3"}, "missing.step"},
      {{"query", "distance", pot_}, "needs two models; the second is missing"},
      {{"query", "distance", pot_, missing}, "missing.step"},
      {{"query", "does-intersect", pot_, missing}, "missing.step"},
      {{"query", "does-intersect", pot_, pot_, "--budget", "0"}, "--budget"},
      {{"query", "ray", missing, "--from", "0,0,0", "--direction", "0,0,1"}, "missing.step"},
      {{"query", "ray", pot_ + "#7", "--from", "0,0,0", "--direction", "0,0,1"}, "7"},
  };
  for (const Bad& bad : all) {
    const Finished run = blossom(bad.arguments);
    EXPECT_EQ(run.code, 2) << bad.says << run.out;
    EXPECT_NE(run.err.find(bad.says), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace blossom
