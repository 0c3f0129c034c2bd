// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query`, as a user runs it.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

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
  EXPECT_EQ(answer(pot_ + "#1", folder_ / "table.brep", 3), "within tolerance");
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
      {{"query"}, "A subcommand is required"},
      {{"query", "ray", pot_}, "--from is required"},
      {{"query", "ray", pot_, "--from", "0,0,0", "--direction", "0,0,0"}, "zero vector"},
      {{"query", "ray", pot_, "--from", "0,0", "--direction", "0,0,1"}, "three finite numbers"},
      {{"query", "ray", pot_, "--from", "0,0,0,0", "--direction", "0,0,1"}, "three finite"},
      {{"query", "ray", pot_, "--from", "0,nan,0", "--direction", "0,0,1"}, "three finite"},
      {{"query", "ray", pot_, "--from", "0,0,0", "--direction", "0,inf,1"}, "three finite"},
      {{"query", "ray", pot_, "--from", "0,0,0", "--direction", "0,x,1"}, "three finite"},
      {{"query", "ray", pot_, "--from", "0,0,0", "--direction", "0,0,1", "--tolerance", "0"},
       "--tolerance"},
      {{"query", "point", pot_}, "--at is required"},
      {{"query", "point", pot_, "--at", "1;2;3"}, "three finite numbers"},
      {{"query", "point", missing, "--at", "1,2,3"}, "missing.step"},
      {{"query", "distance", pot_}, "b is required"},
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
