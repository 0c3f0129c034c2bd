// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of triangles as inputs of `blossom intersect` and `blossom query plane`.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom::testing {
namespace {

std::string cube_off(double at) {
  std::string text = "OFF\n8 6 0\n";
  for (int k = 0; k < 8; ++k) {
    for (const int bit : {1, 2, 4}) text += std::to_string(at + (k & bit ? 2 : 0)) + " ";
    text += "\n";
  }
  return text + "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
}

class MeshMeetings : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!kHasCgal) GTEST_SKIP() << kNoCgal;
    write_text(path("a.off"), cube_off(0));
    write_text(path("b.off"), cube_off(0.75));
    write_text(path("c.off"), cube_off(2));
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  nlohmann::json report(std::vector<std::string> arguments, int code = 0) {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Finished ran = blossom(arguments);
    EXPECT_EQ(ran.code, code) << ran.err;
    return ran.code == code ? nlohmann::json::parse(ran.out) : nlohmann::json();
  }

  int edges_in(const std::string& name) const {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(occt::read_model(path(name)).shape(), TopAbs_EDGE, edges);
    return edges.Extent();
  }

  TestFolder folder_;
};

TEST_F(MeshMeetings, OfTwoMeshesAreClosedPolylines) {
  const nlohmann::json found =
      report({"intersect", path("a.off"), path("b.off"), "-o", path("cut.step")});
  EXPECT_EQ(found["schema"], "blossom.mesh-intersection/1");
  EXPECT_EQ(found["status"], "complete");
  EXPECT_EQ(found["within"], 0.0);
  ASSERT_EQ(found["curves"].size(), 1u);
  EXPECT_EQ(found["curves"][0]["closed"], true);
  EXPECT_NEAR(found["curves"][0]["length"].get<double>(), 6 * 1.25, 1e-12);
  EXPECT_EQ(edges_in("cut.step"), 1);
}

TEST_F(MeshMeetings, ThatTouchAreWithinToleranceAndFarOnesNone) {
  const Finished text = blossom({"intersect", path("a.off"), path("a.off")});
  EXPECT_EQ(text.code, 3);
  EXPECT_NE(text.out.find("pairs of triangles in one plane overlap"), std::string::npos);
  const nlohmann::json corner = report({"intersect", path("a.off"), path("c.off")});
  EXPECT_TRUE(corner["curves"].empty());
  EXPECT_EQ(corner["points"], nlohmann::json::parse("[[2.0, 2.0, 2.0]]"));
  write_text(path("far.off"), cube_off(9));
  const Finished far = blossom(
      {"intersect", path("a.off"), path("far.off"), "--fail-on", "findings", "-o", path("n.step")});
  EXPECT_EQ(far.code, 0);
  EXPECT_NE(far.err.find("no curve and no point was found"), std::string::npos);
  EXPECT_EQ(blossom({"intersect", path("a.off"), path("b.off"), "--fail-on", "findings"}).code, 5);
}

TEST_F(MeshMeetings, OfAModelAreNearIt) {
  occt::Model ball;
  ball.add(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 1).Shape(), "ball");
  occt::write_model(ball, path("ball.step"));
  const nlohmann::json found = report({"intersect", path("ball.step"), path("a.off")}, 3);
  EXPECT_EQ(found["status"], "tolerance");
  const double within = found["within"];
  EXPECT_GT(within, 0);
  EXPECT_LT(within, 1e-3);
  ASSERT_EQ(found["curves"].size(), 1u);
  EXPECT_NEAR(found["curves"][0]["length"].get<double>(), 1.5 * std::numbers::pi, 0.01);
  for (const nlohmann::json& p : found["curves"][0]["points"]) {
    const double x = p[0], y = p[1], z = p[2];
    EXPECT_NEAR(std::hypot(x, y, z), 1, within + 1e-12);
    EXPECT_NEAR(std::min({x, y, z}), 0, 1e-12);
  }
}

TEST_F(MeshMeetings, WithPlanesAreReportedModelledAndDrawn) {
  const nlohmann::json found =
      report({"query", "plane", path("a.off"), "--offsets", "0.5:1.5:3", "-o", path("cuts.dxf")});
  EXPECT_EQ(found["schema"], "blossom.mesh-sections/1");
  ASSERT_EQ(found["planes"].size(), 3u);
  for (const nlohmann::json& plane : found["planes"]) {
    ASSERT_EQ(plane["curves"].size(), 1u);
    EXPECT_DOUBLE_EQ(plane["curves"][0]["length"].get<double>(), 8);
    EXPECT_DOUBLE_EQ(plane["area"].get<double>(), 4);
  }
  const std::string dxf = text_of(path("cuts.dxf"));
  EXPECT_NE(dxf.find("PLANE_3"), std::string::npos);
  EXPECT_NE(dxf.find("POLYLINE"), std::string::npos);
  std::size_t corners = 0;  // over four sides and four diagonals of each plane, and back
  for (std::size_t at = dxf.find("\nVERTEX\n"); at != std::string::npos;
       at = dxf.find("\nVERTEX\n", at + 1))
    ++corners;
  EXPECT_EQ(corners, 3u * 9);
  const std::vector<std::string> one{"query",    "plane",    path("a.off"), "--point",
                                     "0,0,0.25", "--normal", "0,0,1",       "-o"};
  for (const char* name : {"cut.step", "cut.brep"}) {
    std::vector<std::string> words = one;
    words.push_back(path(name));
    ASSERT_EQ(blossom(words).code, 0);
    EXPECT_EQ(edges_in(name), 1) << name;
  }
  EXPECT_EQ(report({"query", "plane", path("a.off"), "--point", "0,0,2", "--normal", "0,0,1"},
                   3)["planes"][0]["in_plane"],
            2);
}

TEST_F(MeshMeetings, AreShownWithBothMeshes) {
  ASSERT_EQ(blossom({"intersect", path("a.off"), path("b.off"), "--html", path("a.html")}).code, 0);
  const std::string page = text_of(path("a.html"));
  for (const char* words : {"a.off x b.off", "\"name\":\"b.off\"", "intersection"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
}

}  // namespace
}  // namespace blossom::testing
