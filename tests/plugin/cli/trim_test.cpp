// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom trim` on a bowl and a lid, whose pieces have areas known by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp_Explorer.hxx>
#include <gp_Pln.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/faces/area.h"
#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

// z = x^2 + y^2 below z = h: pi / 6 ((1 + 4 h)^(3/2) - 1).
double bowl_area(double height) {
  return std::numbers::pi / 6 * (std::pow(1 + 4 * height, 1.5) - 1);
}

class TrimCommand : public ::testing::Test {
 protected:
  Finished trim(double height, std::vector<std::string> options) {
    testing::write({testing::bowl()}, folder / "bowl.brep");
    testing::write({testing::lid(height)}, folder / "lid.brep");
    options.insert(options.begin(), {"trim", folder / "bowl.brep", folder / "lid.brep"});
    return blossom(options);
  }

  testing::TestFolder folder;
};

TEST_F(TrimCommand, ListsTheFirstOfManyPiecesAndWithVAll) {
  std::vector<std::string> words{"--keep", "all"};
  for (int k = 1; k <= 24; ++k)
    words.insert(words.end(), {"--plane", std::to_string(0.08 * k - 1) + ",0,0,1,0,0"});
  const Finished few = trim(-1, words);
  words.emplace_back("-v");
  const Finished all = trim(-1, words);

  EXPECT_EQ(few.code, 0) << few.err;
  EXPECT_NE(few.out.find("in 25 pieces"), std::string::npos) << few.out;
  EXPECT_NE(few.out.find("  and 5 more pieces, which -v lists\n"), std::string::npos) << few.out;
  EXPECT_EQ(std::ranges::count(few.out, '\n'), 22);
  EXPECT_EQ(std::ranges::count(all.out, '\n'), 26);
}

TEST_F(TrimCommand, ReportsPiecesWithSidesAndAreas) {
  const Finished run = trim(0.25, {"--keep", "all", "--json", "-"});

  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const json report = json::parse(run.out);
  EXPECT_EQ(report["schema"], "blossom.trim/1");
  EXPECT_EQ(report["status"], "complete");
  EXPECT_EQ(report["written"], false);
  EXPECT_TRUE(report["notes"].empty());
  ASSERT_EQ(report["pieces"].size(), 2u);
  double below = 0;
  for (const json& piece : report["pieces"]) {
    EXPECT_EQ(piece["face"], 1);
    EXPECT_EQ(piece["kept"], true);
    if (piece["side"] == "below") below += piece["area"].get<double>();
  }
  EXPECT_NEAR(below, bowl_area(0.25), 1e-7);
  EXPECT_NE(report["pieces"][0]["side"], report["pieces"][1]["side"]);
  const double before = report["areas"][0]["area"], after = report["areas"][0]["pieces"];
  EXPECT_NEAR(before, after, 1e-9 * before);
  EXPECT_GT(report["certificate"]["certified"], 0);
}

TEST_F(TrimCommand, TellsWhyItIsWithinToleranceOnly) {
  const Finished run = trim(0, {"--keep", "all"});
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.out.find("\n  the surfaces touch, or nearly, in places\n"), std::string::npos)
      << run.out;
}

TEST_F(TrimCommand, WritesTheCapBelowTheLid) {
  const Finished run = trim(0.25, {"--keep", "below", "-o", folder / "cap.step", "--quiet"});

  ASSERT_EQ(run.code, 0) << run.err;
  const occt::Model cap = occt::read_model(folder / "cap.step");
  ASSERT_EQ(cap.face_count(), 1);
  EXPECT_TRUE(BRepCheck_Analyzer(cap.shape()).IsValid());
  EXPECT_NEAR(occt::area(cap.face(1)), bowl_area(0.25), 1e-6);
}

TEST_F(TrimCommand, ImprintsACutThatEndsInsideWhereTheFormatHasInternalEdges) {
  const gp_Pln plane(gp_Pnt(0.5, 0.5, 0), gp_Dir(1, 0, 0));
  testing::write({BRepBuilderAPI_MakeFace(plane, -5, 5, -0.2, 0.2).Face()}, folder / "blade.brep");
  testing::write({testing::bowl()}, folder / "bowl.brep");
  for (const std::string ending : {"brep", "step", "iges"}) {
    const std::string output = folder / ("out." + ending);
    const Finished run = blossom(
        {"trim", folder / "bowl.brep", folder / "blade.brep", "--keep", "all", "-o", output});
    ASSERT_EQ(run.code, 0) << run.err;
    const bool kept = ending == "brep";
    EXPECT_NE(run.out.find(kept ? "imprinted" : "left out"), std::string::npos) << run.out;
    int internal = 0;
    const occt::Model made = occt::read_model(output);
    for (TopExp_Explorer it(made.shape(), TopAbs_EDGE); it.More(); it.Next())
      internal += it.Current().Orientation() == TopAbs_INTERNAL;
    EXPECT_EQ(internal, kept ? 1 : 0);
    EXPECT_TRUE(BRepCheck_Analyzer(made.shape()).IsValid());
  }
}

TEST_F(TrimCommand, CutsAtAPlaneAsAtALid) {
  testing::write({testing::bowl()}, folder / "bowl.brep");
  for (const auto& [plane, below] :
       {std::pair{"0,0,0.25,0,0,1", true}, {"9,9,0.25,0,0,-3", false}}) {
    const Finished run = blossom({"trim", folder / "bowl.brep", "--plane", plane, "--keep",
                                  below ? "below" : "above", "-o", folder / "cap.step"});
    ASSERT_EQ(run.code, 0) << run.err;
    const occt::Model cap = occt::read_model(folder / "cap.step");
    ASSERT_EQ(cap.face_count(), 1);
    EXPECT_NEAR(occt::area(cap.face(1)), bowl_area(0.25), 1e-6);
  }
  const Finished off = blossom(
      {"trim", folder / "bowl.brep", "--plane", "0,0,-1,0,0,1", "--keep", "above", "--json", "-"});
  EXPECT_EQ(off.code, 0);
  const json report = json::parse(off.out);
  ASSERT_EQ(report["pieces"].size(), 1U);
  EXPECT_EQ(report["pieces"][0]["side"], "above");
  EXPECT_EQ(report["planes"].size(), 1U);
}

TEST_F(TrimCommand, KeepsAPieceByTheNumberThatItPrinted) {
  ASSERT_EQ(trim(0.25, {"--keep", "1", "-o", folder / "one.brep"}).code, 0);
  ASSERT_EQ(trim(0.25, {"--keep", "2", "-o", folder / "two.brep"}).code, 0);
  const double one = occt::area(occt::read_model(folder / "one.brep").face(1));
  const double two = occt::area(occt::read_model(folder / "two.brep").face(1));
  EXPECT_NEAR(std::min(one, two), bowl_area(0.25), 1e-7);
  EXPECT_GT(std::max(one, two), 3);
}

TEST_F(TrimCommand, WritesNothingWhenTheIntersectionWasStopped) {
  const std::vector<std::string> options = {"--keep", "all", "--budget",
                                            "1",      "-o",  folder / "out.brep"};
  const Finished run = trim(0.25, options);

  EXPECT_EQ(run.code, 4);
  EXPECT_NE(run.err.find("--allow-incomplete"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out.brep"));

  std::vector<std::string> allowed = options;
  allowed.push_back("--allow-incomplete");
  EXPECT_EQ(trim(0.25, allowed).code, 4);
  EXPECT_TRUE(std::filesystem::exists(folder / "out.brep"));
}

TEST_F(TrimCommand, FailsWhenNothingIsLeftToWrite) {
  const std::string none = folder / "none.brep";
  const Finished run = trim(-1, {"--keep", "below", "-o", none});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.err, "blossom: " + none + " is not written: no piece is on the side to keep\n");
  EXPECT_FALSE(std::filesystem::exists(none));
  EXPECT_EQ(trim(-1, {"--keep", "below", "--json", "-"}).code, 0) << "no file was asked for";
}

TEST_F(TrimCommand, TellsAnOlderFileFromTheResult) {
  const std::string file = folder / "cap.brep";
  ASSERT_EQ(trim(0.25, {"--keep", "below", "-o", file}).code, 0);
  const std::string before = testing::text_of(file);
  const Finished run = trim(-1, {"--keep", "below", "-o", file});
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("; the file of that name is an older one"), std::string::npos) << run.err;
  EXPECT_EQ(testing::text_of(file), before);
}

TEST_F(TrimCommand, WritesWatertightPiecesAsNets) {
  const std::string output = folder / "nets.json";
  const Finished run = trim(0.25, {"--keep", "below", "--watertight", "-o", output, "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out)["watertight"];
  const json nets = json::parse(testing::text_of(output))["nets"];
  EXPECT_GT(report["triangles"].get<int>(), 0);
  EXPECT_EQ(static_cast<int>(nets.size()),
            report["patches"].get<int>() + report["triangles"].get<int>());
}

TEST_F(TrimCommand, RefusesAWordThatIsNoSide) {
  const Finished run = trim(0.25, {"--keep", "left"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("'left'"), std::string::npos) << run.err;
}

TEST_F(TrimCommand, RefusesInsideOfAnOpenToolAndANumberThatIsNotThere) {
  EXPECT_EQ(trim(0.25, {"--keep", "inside"}).code, 2);
  const Finished run = trim(0.25, {"--keep", "7"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("no piece 7"), std::string::npos) << run.err;
}

TEST_F(TrimCommand, DrawsAPicture) {
  ASSERT_EQ(trim(0.25, {"--keep", "below", "--picture", folder / "cap.png"}).code, 0);
  EXPECT_GT(std::filesystem::file_size(folder / "cap.png"), 1000u);
}

TEST_F(TrimCommand, NamesFacesByTheNumbersThatTheyHadBefore) {
  occt::Model box;
  box.add(BRepPrimAPI_MakeBox(2, 2, 2).Shape(), "box");
  occt::write_model(box, folder / "box.step");

  const Finished run =
      blossom({"trim", folder / "box.step", "--plane", "1,0,0,1,0,0", "--keep", "below"});

  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("of face 6 (box)"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace blossom
