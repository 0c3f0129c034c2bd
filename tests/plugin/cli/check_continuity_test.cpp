// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom check --continuity`, as a user runs it.

#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

class CheckContinuityCommand : public ::testing::Test {
 protected:
  std::string written(const TopoDS_Shape& shape, const std::string& name) {
    occt::quiet_messages();
    occt::Model model;
    model.add(shape, "part");
    occt::write_model(model, folder_ / name);
    return folder_ / name;
  }

  testing::TestFolder folder_;
};

bool has(const Finished& run, const std::string& text) {
  return run.out.find(text) != std::string::npos;
}

TEST_F(CheckContinuityCommand, CountsEdgesByClassAndNamesTheWorst) {
  const std::string file = written(BRepPrimAPI_MakeCylinder(2, 5).Shape(), "pin.step");
  const Finished run = blossom({"check", "--continuity", file});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(has(run, "pin.step: 3 edges between faces (1 seam among them): 2 sharp (G0), 1 G2\n"))
      << run.out;
  EXPECT_TRUE(has(run,
                  "within gap 0.001 mm, angle 0.001 rad (0.0573 degrees), curvature 1 %; "
                  "proven for 3 of 3\n"))
      << run.out;
  EXPECT_TRUE(has(run, "largest gap ")) << run.out;
  EXPECT_TRUE(has(run, "sharp edges turn by 1.57 rad (90 degrees)")) << run.out;
  EXPECT_FALSE(has(run, "less than")) << run.out;
}

TEST_F(CheckContinuityCommand, ShowsZebraStripes) {
  const std::string file = written(BRepPrimAPI_MakeCylinder(2, 5).Shape(), "pin.step");
  const std::string plain = folder_ / "plain.png", zebra = folder_ / "zebra.png";
  EXPECT_EQ(blossom({"check", "--continuity", file, "--picture", plain}).code, 0);
  const Finished run = blossom({"check", "--continuity", file, "--zebra", "--picture", zebra});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_GT(std::filesystem::file_size(zebra), 1000U);
  EXPECT_NE(testing::text_of(zebra), testing::text_of(plain));
}

TEST_F(CheckContinuityCommand, TableHasALineForEveryEdge) {
  const std::string file = written(BRepPrimAPI_MakeSphere(3).Shape(), "ball.brep");
  for (const char* flag : {"--edges", "-v"}) {
    const Finished run = blossom({"check", "--continuity", flag, file});
    EXPECT_TRUE(has(run, "(seam of face 1): G2, gap ")) << run.out;
    EXPECT_TRUE(has(run, "(faces 1): degenerate\n")) << run.out;
    EXPECT_TRUE(has(run, "not compared: 2 degenerate edges\n")) << run.out;
  }
}

TEST_F(CheckContinuityCommand, ReportHasBoundsAndPlaces) {
  const std::string file = written(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "box.brep");
  const Finished run = blossom({"check", "--continuity", file, "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["schema"], "blossom.continuity/1");
  EXPECT_EQ(report["summary"]["G0"], 12);
  EXPECT_EQ(report["summary"]["proven"], 12);
  EXPECT_EQ(report["kinds"]["shared"], 12);
  EXPECT_EQ(report["require"], nullptr);
  ASSERT_EQ(report["edges"].size(), 12u);
  for (const json& edge : report["edges"]) {
    EXPECT_EQ(edge["class"], "G0");
    EXPECT_NEAR(edge["angle"]["value"].get<double>(), 1.5707963267948966, 1e-13);
    EXPECT_NEAR(edge["angle"]["bound"].get<double>(), 1.5707963267948966, 1e-10);
    EXPECT_EQ(edge["angle"]["point"].size(), 3u);
    EXPECT_EQ(edge["curvature"], nullptr);
  }
}

TEST_F(CheckContinuityCommand, EdgesLessThanRequiredAreFindings) {
  const std::string file = written(BRepPrimAPI_MakeCylinder(2, 5).Shape(), "pin.brep");
  const auto code = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"check", "--continuity", file});
    return blossom(more).code;
  };
  EXPECT_EQ(code({"--fail-on", "findings"}), 0);
  EXPECT_EQ(code({"--require", "G1"}), 0);
  EXPECT_EQ(code({"--require", "G1", "--fail-on", "findings"}), 5);
  EXPECT_EQ(code({"--require", "G1", "--angle", "91", "--fail-on", "findings"}), 0);
  EXPECT_EQ(code({"--require", "G1", "--angle", "89", "--fail-on", "findings"}), 5);
  EXPECT_EQ(code({"--require", "G2", "--angle", "91", "--fail-on", "findings"}), 5);
  EXPECT_EQ(code({"--angle", "181"}), 2);
  const Finished run = blossom({"check", "--continuity", file, "--require", "G1"});
  EXPECT_TRUE(has(run, "less than G1: 2 edges, ")) << run.out;
}

TEST_F(CheckContinuityCommand, FilletIsSmoothEnoughForG1) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  fillet.Add(2, TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current()));
  const std::string file = written(fillet.Shape(), "rounded.step");
  const Finished run = blossom({"check", "--continuity", file});
  EXPECT_TRUE(has(run, "2 G1")) << run.out;
  EXPECT_TRUE(has(run, "largest difference of curvature of G1 edges 100 % (0.5 / mm; at most "))
      << run.out;
}

TEST_F(CheckContinuityCommand, PictureHasTheColoursOfTheClasses) {
  const std::string file = written(BRepPrimAPI_MakeCylinder(2, 5).Shape(), "pin.brep");
  const Finished run = blossom({"check", "--continuity", file, "--picture", folder_ / "pin.png"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(has(run, "colours: sharp black")) << run.out;
  EXPECT_EQ(testing::text_of(folder_ / "pin.png").substr(1, 3), "PNG");
}

TEST_F(CheckContinuityCommand, FacesThatShareNoEdgeHaveNothingToCompare) {
  testing::write({testing::bowl(), testing::half_pipe()}, folder_ / "parts.brep");
  const Finished run = blossom({"check", "--continuity", folder_ / "parts.brep"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(has(run, "no two faces share an edge")) << run.out;
  EXPECT_TRUE(has(run, "8 open edges")) << run.out;
}

}  // namespace
}  // namespace blossom
