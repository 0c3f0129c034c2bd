// SPDX-License-Identifier: LGPL-2.1-or-later
// `check`, `info` and `self-intersect` on many files, as a user runs them.

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
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

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class ManyFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    occt::Model box;
    box.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "box");
    occt::write_model(box, folder_ / "box.step");
    testing::write({testing::bowl()}, folder_ / "bowl.brep");
    testing::write_text(folder_ / "broken.step", "ISO-10303-21;\nHEADER;\n");
    box_ = folder_ / "box.step";
    bowl_ = folder_ / "bowl.brep";
    broken_ = folder_ / "broken.step";
    table_ = folder_ / "table.csv";
  }

  testing::TestFolder folder_;
  std::string box_, bowl_, broken_, table_;
};

TEST_F(ManyFiles, GiveARowEachEvenIfOneIsBroken) {
  const Finished run = blossom({"check", box_, broken_, bowl_, "--table", table_});
  EXPECT_EQ(run.code, 2);
  const std::vector<std::string> told = lines_of(run.out);
  ASSERT_EQ(told.size(), 3u) << run.out;
  EXPECT_EQ(told[0], box_ + ": sound, 6 faces, 12 edges");
  EXPECT_TRUE(told[1].starts_with(broken_ + ": holds no shape")) << told[1];
  EXPECT_TRUE(told[2].starts_with(bowl_ + ": ")) << told[2];
  EXPECT_NE(run.err.find("blossom: " + broken_), std::string::npos) << run.err;
  const std::vector<std::string> rows = lines_of(testing::text_of(table_));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0],
            "file,verdict,problems,faces,edges,open_edges,non_manifold_edges,gap,same_parameter,"
            "vertex_gap,tolerance,exit_code,error");
  EXPECT_TRUE(rows[1].starts_with(box_ + ",sound,0,6,12,0,0,")) << rows[1];
  EXPECT_TRUE(rows[2].starts_with(broken_ + ",,,,,,,,,,,2,")) << rows[2];
}

TEST_F(ManyFiles, AreInOneReport) {
  const Finished run = blossom({"info", box_, bowl_, "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json found = json::parse(run.out);
  EXPECT_EQ(found["schema"], "blossom.files/1");
  EXPECT_EQ(found["command"], "info");
  ASSERT_EQ(found["files"].size(), 2u);
  EXPECT_EQ(found["files"][0]["report"]["counts"]["faces"], 6);
  EXPECT_TRUE(found["files"][0]["error"].is_null());
}

TEST_F(ManyFiles, TakeTheOptionsOfTheCommand) {
  const Finished run = blossom(
      {"self-intersect", box_, bowl_, "--faces", "--tolerance", "1e-6", "--table", table_, "-q"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "");
  const std::vector<std::string> rows = lines_of(testing::text_of(table_));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_TRUE(rows[1].starts_with(box_ + ",none found,complete,0,0,0,0,")) << rows[1];
}

TEST_F(ManyFiles, MayBeOneWithATable) {
  EXPECT_EQ(blossom({"info", box_, "--table", table_}).code, 0);
  const std::vector<std::string> rows = lines_of(testing::text_of(table_));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_TRUE(rows[1].starts_with(box_ + ",1,1,6,12,8,MM,0.0,0.0,0.0,1.0,2.0,3.0,")) << rows[1];
}

TEST_F(ManyFiles, FailOnFindings) {
  occt::Model open;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  open.add(TopExp_Explorer(box, TopAbs_FACE).Current(), "side");
  occt::write_model(open, folder_ / "side.step");
  const std::vector<std::string> files{box_, folder_ / "side.step"};
  EXPECT_EQ(blossom({"check", files[0], files[1], "--fail-on", "findings"}).code, 0);
  EXPECT_EQ(blossom({"check", files[0], broken_, "--fail-on", "findings"}).code, 2);
}

TEST_F(ManyFiles, HaveNoOutputsOfSingleFiles) {
  const std::vector<std::vector<std::string>> outputs{{"-o", folder_ / "out.step"},
                                                      {"--picture", folder_ / "out.png"},
                                                      {"--html", folder_ / "out.html"},
                                                      {"--glb", folder_ / "out.glb"}};
  for (const auto& output : outputs) {
    const Finished run = blossom({"self-intersect", box_, bowl_, output[0], output[1]});
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find(" is for one file"), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace blossom
