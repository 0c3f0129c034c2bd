// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom trim --solid`, as a user runs it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
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

constexpr double kCap = std::numbers::pi * 0.25 * 2.5 / 3;  // of height 1/2 of a unit ball

class TrimSolidsCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    write(BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, 0), gp_Pnt(2, 2, 3)).Shape(), "box.brep");
    write(BRepPrimAPI_MakeSphere(gp_Pnt(0.1, 0.2, -0.5), 1).Shape(), "ball.step");
    write(BRepPrimAPI_MakeBox(gp_Pnt(2, -2, 0), gp_Pnt(4, 2, 3)).Shape(), "beside.brep");
    write(BRepPrimAPI_MakeBox(gp_Pnt(9, 9, 9), gp_Pnt(10, 10, 10)).Shape(), "away.brep");
  }
  void write(const TopoDS_Shape& shape, const std::string& name) {
    occt::quiet_messages();
    occt::Model model;
    model.add(shape, name);
    occt::write_model(model, folder / name);
  }
  Finished combine(const std::string& tool, std::vector<std::string> options) {
    options.insert(options.begin(), {"trim", folder / "box.brep", folder / tool, "--solid"});
    return blossom(options);
  }

  testing::TestFolder folder;
};

// Lines through the box and past it.
TEST_F(TrimSolidsCommand, TakesNamedEdgesAsWires) {
  BRep_Builder builder;
  TopoDS_Compound lines;
  builder.MakeCompound(lines);
  for (const double y : {0., 9.})
    builder.Add(lines, BRepBuilderAPI_MakeEdge(gp_Pnt(-5, y, 1), gp_Pnt(5, y, 1)).Edge());
  write(lines, "lines.brep");
  const auto cut = [&](const std::string& edge) {
    const Finished run = blossom({"trim", (folder / "lines.brep").string() + "#edge:" + edge,
                                  folder / "box.brep", "--solid", "cut", "--json", "-"});
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  };
  const json through = cut("1"), past = cut("2");
  EXPECT_NEAR(through["wires"]["lengths"]["part"], 10, 1e-9);
  EXPECT_NEAR(through["wires"]["lengths"]["result"], 6, 1e-6);
  EXPECT_TRUE(through["idle"].empty());
  EXPECT_NEAR(past["wires"]["lengths"]["result"], 10, 1e-9);
  EXPECT_EQ(past["idle"].size(), 1U);
}

TEST_F(TrimSolidsCommand, TakesAModelTwice) {
  const std::string box = folder / "box.brep";
  for (const std::string& part : {box, box + "#edge:1"}) {
    const Finished run = blossom({"trim", part, box, box, "--solid", "common", "--json", "-"});
    ASSERT_LT(run.code, 4) << part << ": " << run.err;
    EXPECT_NE(json::parse(run.out)["status"], "stopped");
  }
}

TEST_F(TrimSolidsCommand, IsNamedWhereFacesAreWantedAndThereAreEdgesAlone) {
  write(BRepBuilderAPI_MakeEdge(gp_Pnt(-5, 0, 1), gp_Pnt(5, 0, 1)).Edge(), "line.brep");
  const std::string box = folder / "box.brep";
  for (const std::string& edges : {std::string(folder / "line.brep"), box + "#edge:1"}) {
    const Finished run =
        blossom({"query", "ray", edges, "--from", "0,0,9", "--direction", "0,0,-1"});
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find("'trim --solid', 'query distance' and 'query plane' take edges"),
              std::string::npos)
        << run.err;
  }
}

// Beside the box, farther away than the tolerance.
TEST_F(TrimSolidsCommand, FusesAcrossAGapThatFuzzyCovers) {
  write(BRepPrimAPI_MakeBox(gp_Pnt(2 + 1e-4, -2, 0), gp_Pnt(4, 2, 3)).Shape(), "near.brep");
  const auto solids_with = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"fuse", "-o", folder / "fused.brep"});
    const Finished run = combine("near.brep", options);
    EXPECT_TRUE(run.code == 0 || run.code == 3) << run.err;
    const occt::Model fused = occt::read_model(folder / "fused.brep");
    EXPECT_TRUE(BRepCheck_Analyzer(fused.shape()).IsValid());
    return fused.face_count();
  };
  EXPECT_EQ(solids_with({}), 12);
  EXPECT_EQ(solids_with({"--fuzzy", "2e-4"}), 10);
  const Finished alone = blossom(
      {"trim", folder / "box.brep", folder / "near.brep", "--keep", "all", "--fuzzy", "2e-4"});
  EXPECT_EQ(alone.code, 2);
  EXPECT_NE(alone.err.find("--fuzzy goes with --solid"), std::string::npos) << alone.err;
}

TEST_F(TrimSolidsCommand, WritesTheBoxWithoutTheBall) {
  const Finished run =
      combine("ball.step", {"cut", "-o", folder / "cut.step", "--json", folder / "cut.json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const occt::Model cut = occt::read_model(folder / "cut.step");
  EXPECT_EQ(cut.face_count(), 7);
  EXPECT_TRUE(BRepCheck_Analyzer(cut.shape()).IsValid());
  GProp_GProps properties;
  BRepGProp::VolumeProperties(cut.shape(), properties, 1e-8);
  EXPECT_NEAR(properties.Mass(), 48 - kCap, 1e-5);
  EXPECT_EQ(blossom({"check", folder / "cut.step", "--fail-on", "findings"}).code, 0);

  const json report = json::parse(testing::text_of(folder / "cut.json"));
  EXPECT_EQ(report["schema"], "blossom.solid/1");
  EXPECT_EQ(report["operation"], "cut");
  EXPECT_EQ(report["status"], "complete");
  EXPECT_EQ(report["written"], true);
  EXPECT_EQ(report["solids"], json::parse(R"([{"faces": 7, "voids": 0}])"));
  EXPECT_NEAR(report["volumes"]["common"].get<double>(), kCap, 1e-7);
  EXPECT_LT(report["volumes"]["cut_error"].get<double>(), 1e-9);
  EXPECT_LT(report["volumes"]["fuse_error"].get<double>(), 1e-9);
  EXPECT_TRUE(report["obstacles"].empty());
}

TEST_F(TrimSolidsCommand, CallsSolidsAsThePartsTheyComeFrom) {
  occt::Model block, bar;
  block.add(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(4, 1, 1)).Shape(), "Block", {1, 0, 0});
  bar.add(BRepPrimAPI_MakeBox(gp_Pnt(1, -1, -1), gp_Pnt(2, 2, 2)).Shape(), "Bar");
  occt::write_model(block, folder / "block.step");
  occt::write_model(bar, folder / "bar.step");
  const Finished run = blossom({"trim", folder / "block.step", folder / "bar.step", "--solid",
                                "cut", "-o", folder / "halves.step"});
  ASSERT_EQ(run.code, 0) << run.err;
  const occt::Model halves = occt::read_model(folder / "halves.step");
  ASSERT_EQ(halves.face_count(), 12);
  EXPECT_EQ(halves.part_name(1), "Block.1");
  EXPECT_EQ(halves.part_name(12), "Block.2");
}

TEST_F(TrimSolidsCommand, NamesPartsWithoutANameAfterTheFile) {
  ASSERT_EQ(combine("ball.step", {"cut", "-o", folder / "cut.step"}).code, 0);
  EXPECT_EQ(occt::read_model(folder / "cut.step").part_name(1), "box");
  const Finished run = blossom({"trim", folder / "ball.step", folder / "box.brep", "--solid", "cut",
                                "-o", folder / "rest.step"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(occt::read_model(folder / "rest.step").part_name(1), "ball.step");
}

// Both solids have the faces of the cut, where the file can say so.
TEST_F(TrimSolidsCommand, KeepsCommonFacesOfASplitInBrepFiles) {
  ASSERT_EQ(combine("ball.step", {"split", "-o", folder / "split.brep"}).code, 0);
  ASSERT_EQ(combine("ball.step", {"split", "-o", folder / "split.step"}).code, 0);
  const int in_brep = occt::read_model(folder / "split.brep").face_count();
  EXPECT_EQ(occt::read_model(folder / "split.step").face_count(), in_brep + 1);
}

TEST_F(TrimSolidsCommand, WritesWatertightPieces) {
  const Finished run = combine("ball.step", {"cut", "--watertight", "-o", folder / "cut.brep",
                                             "--json", folder / "cut.json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(testing::text_of(folder / "cut.json"))["watertight"];
  EXPECT_GT(report["common_sides"], 10);
  EXPECT_LE(report["deviation"], 1e-6);
  const occt::Model cut = occt::read_model(folder / "cut.brep");
  EXPECT_EQ(cut.face_count(), report["patches"].get<int>() + report["triangles"].get<int>());
  EXPECT_TRUE(BRepCheck_Analyzer(cut.shape()).IsValid());
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndAncestors(cut.shape(), TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  for (int k = 1; k <= faces_of_edge.Extent(); ++k)
    EXPECT_EQ(faces_of_edge(k).Extent(),
              BRep_Tool::Degenerated(TopoDS::Edge(faces_of_edge.FindKey(k))) ? 1 : 2);

  ASSERT_EQ(combine("ball.step", {"cut", "--watertight", "-o", folder / "nets.json"}).code, 0);
  const json nets = json::parse(testing::text_of(folder / "nets.json"))["nets"];
  EXPECT_EQ(nets.size(), static_cast<std::size_t>(cut.face_count()));
  EXPECT_EQ(std::ranges::count_if(nets, [](const json& net) { return net["kind"] == "triangle"; }),
            report["triangles"].get<int>());
}

TEST_F(TrimSolidsCommand, PrintsVolumesForPeople) {
  const Finished run = combine("ball.step", {"fuse"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("fuse, complete, 1 solid"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("volumes: part 48, tools "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("  checked: volumes add up within "), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("nothing is cut"), std::string::npos) << run.out;
}

TEST_F(TrimSolidsCommand, TellsThatNothingIsCut) {
  const Finished run = combine("beside.brep", {"cut"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("  nothing is cut: part and tools have no volume in common\n"),
            std::string::npos)
      << run.out;
}

TEST_F(TrimSolidsCommand, FusesSolidsThatShareAFace) {
  const Finished run = combine("beside.brep", {"fuse", "-o", folder / "out.step", "--json", "-"});
  EXPECT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_GT(report["certificate"]["identified"], 0);
  EXPECT_EQ(report["solids"], json::parse(R"([{"faces": 10, "voids": 0}])"));
  EXPECT_NEAR(report["volumes"]["fuse"].get<double>(), 72, 1e-9);
  EXPECT_EQ(blossom({"check", folder / "out.step", "--fail-on", "findings"}).code, 0);
}

TEST_F(TrimSolidsCommand, TakesSeveralTools) {
  write(BRepPrimAPI_MakeBox(gp_Pnt(9, 9, 9), gp_Pnt(10, 10, 10)).Shape(), "away.step");
  const Finished run =
      blossom({"trim", folder / "box.brep", folder / "ball.step", folder / "beside.brep",
               folder / "away.step", "--solid", "fuse", "-o", folder / "out.step", "--json", "-"});
  EXPECT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["tools"].size(), 3u);
  EXPECT_EQ(report["solids"].size(), 2u);
  ASSERT_EQ(report["steps"].size(), 3u);
  EXPECT_NEAR(report["steps"][0]["common"].get<double>(), kCap, 1e-7);
  EXPECT_NEAR(report["volumes"]["fuse"].get<double>(), 72 + 1 + 4 * std::numbers::pi / 3 - kCap,
              1e-6);
  // The last step has the part and two tools for its part; the total has all inputs.
  const json& total = report["total"];
  EXPECT_NEAR(total["part"].get<double>(), 48, 1e-9);
  EXPECT_NEAR(total["tools"].get<double>(), 24 + 1 + 4 * std::numbers::pi / 3, 1e-6);
  EXPECT_NEAR(total["result"].get<double>(), 72 + 1 + 4 * std::numbers::pi / 3 - kCap, 1e-6);
  const occt::Model made = occt::read_model(folder / "out.step");
  // A .brep has no names, so the box is called as its file.
  const std::set<std::string> names{made.part_name(1), made.part_name(made.face_count())};
  EXPECT_EQ(names, (std::set<std::string>{"away.step", "box"}));
}

TEST_F(TrimSolidsCommand, TellsWhatCountsAsOneWhereFacesCoincideRoughly) {
  write(BRepPrimAPI_MakeBox(gp_Pnt(2 - 4e-7, -2, 0), gp_Pnt(4, 2, 3)).Shape(), "rough.brep");
  const Finished run = combine("rough.brep", {"fuse", "-o", folder / "out.step"});
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.out.find("what is nearer to each other than 1e-06 counts as one"),
            std::string::npos)
      << run.out;
  const occt::Model fused = occt::read_model(folder / "out.step");
  GProp_GProps volume;
  BRepGProp::VolumeProperties(fused.shape(), volume);
  EXPECT_NEAR(volume.Mass(), 72, 1e-4);
}

TEST_F(TrimSolidsCommand, WritesNothingWhenTheIntersectionWasStopped) {
  write(BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(0.3, 0.2, 0.1), gp_Dir(1, 2, 3)), 1.5, 0.5).Shape(),
        "ring.brep");
  const Finished run = combine("ring.brep", {"cut", "--budget", "1", "-o", folder / "out.step"});
  EXPECT_EQ(run.code, 4);
  EXPECT_NE(run.err.find("is not written"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out.step"));
}

// Top and bottom have an outline that crosses itself, far from the ball.
TEST_F(TrimSolidsCommand, TellsOfInvalidFacesThatItKeeps) {
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [x, y] :
       {std::pair{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}, {0.2, 4.2}, {0.2, 3.9}})
    outline.Add(gp_Pnt(x, y, 0));
  outline.Close();
  const TopoDS_Face bottom = BRepBuilderAPI_MakeFace(gp_Pln(), outline.Wire());
  write(BRepPrimAPI_MakePrism(bottom, gp_Vec(0, 0, 3)).Shape(), "crossed.brep");
  write(BRepPrimAPI_MakeSphere(gp_Pnt(3.9, 1.5, 1.4), 1).Shape(), "knob.brep");
  const Finished run = blossom({"trim", folder / "crossed.brep", folder / "knob.brep", "--solid",
                                "cut", "--json", folder / "cut.json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(json::parse(testing::text_of(folder / "cut.json"))["invalid"].size(), 2U);
  EXPECT_NE(run.out.find(" is not valid (a wire meets itself"), std::string::npos);
}

TEST_F(TrimSolidsCommand, SaysThatNothingIsCommon) {
  const std::string step = folder / "out.step", png = folder / "out.png";
  testing::write_text(png, "older");
  const Finished run = combine("away.brep", {"common", "-o", step, "--picture", png});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.err, "blossom: " + step + " is not written: the result is empty\nblossom: " + png +
                         " is not written: the result is empty; the file of that name is an older "
                         "one, left as it was\n");
  EXPECT_FALSE(std::filesystem::exists(step));
  EXPECT_EQ(combine("away.brep", {"common"}).code, 0) << "no file was asked for";
}

double volume_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-8);
  return properties.Mass();
}

TEST_F(TrimSolidsCommand, TakesAPlaneForWhatIsAboveIt) {
  const auto cut = [&](const std::string& operation, const std::string& plane) {
    const std::string out = folder / "out.step";
    const Finished run =
        blossom({"trim", folder / "box.brep", "--plane", plane, "--solid", operation, "-o", out});
    EXPECT_EQ(run.code, 0) << run.err << run.out;
    return occt::read_model(out);
  };
  EXPECT_NEAR(volume_of(cut("cut", "0,0,1,0,0,1").shape()), 16, 1e-9);
  EXPECT_NEAR(volume_of(cut("common", "0,0,1,0,0,1").shape()), 32, 1e-9);
  EXPECT_NEAR(volume_of(cut("cut", "0,0,1,0,0,-2").shape()), 32, 1e-9);
  const occt::Model halves = cut("split", "0,0,1,0,0,1");
  EXPECT_EQ(halves.face_count(), 12);
  EXPECT_NEAR(volume_of(halves.shape()), 48, 1e-9);
  EXPECT_EQ(halves.part_name(1), "box.1");
  const std::vector<std::string> names = halves.face_names();
  EXPECT_EQ(std::ranges::count(names, "plane 1.1"), 1);
  EXPECT_EQ(std::ranges::count(names, "plane 1.2"), 1);
}

TEST_F(TrimSolidsCommand, SplitsByEachPlane) {
  const Finished run =
      blossom({"trim", folder / "box.brep", "--plane", "0,0,1,0,0,1", "--plane", "-1,0,0,1,0,0",
               "--plane", "0,0,9,0,0,1", "--solid", "split", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["solids"].size(), 4U);
  EXPECT_EQ(report["planes"].size(), 3U);
  EXPECT_EQ(report["planes"][1],
            json::parse(R"({"point": [-1.0, 0.0, 0.0], "normal": [1.0, 0.0, 0.0]})"));
  EXPECT_EQ(report["idle"], json::parse(R"(["plane 3 cuts nothing of what is in the result"])"));
}

TEST_F(TrimSolidsCommand, RefusesPlanesThatMakeNoSense) {
  const auto error = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"trim", folder / "box.brep"});
    const Finished run = blossom(options);
    EXPECT_EQ(run.code, 2) << run.out;
    return run.err;
  };
  EXPECT_NE(error({"--solid", "cut"}).find("--plane"), std::string::npos);
  EXPECT_NE(error({"--solid", "cut", "--plane", "0,0,1"}).find("six finite numbers"),
            std::string::npos);
  EXPECT_NE(error({"--solid", "cut", "--plane", "0,0,1,0,0,0"}).find("normal"), std::string::npos);
  EXPECT_NE(error({"--keep", "all", "--plane", "0,0,x,0,0,1"}).find("'0,0,x,0,0,1'"),
            std::string::npos);
  EXPECT_NE(error({"--solid", "fuse", "--plane", "0,0,1,0,0,1"}).find("fuse"), std::string::npos);
}

TEST_F(TrimSolidsCommand, SplitsByASheet) {
  const gp_Pln slope({0, 0, 1.5}, {0, 1, 2});
  write(BRepBuilderAPI_MakeFace(slope, -9, 9, -9, 9).Face(), "sheet.brep");
  const Finished run = combine(
      "sheet.brep", {"split", "-o", folder / "parts.step", "--json", folder / "split.json"});
  EXPECT_EQ(run.out.find("nothing is cut"), std::string::npos) << run.out;
  ASSERT_EQ(run.code, 0) << run.err;
  const occt::Model parts = occt::read_model(folder / "parts.step");
  EXPECT_EQ(parts.face_count(), 12);
  const json report = json::parse(testing::text_of(folder / "split.json"));
  EXPECT_EQ(report["solids"].size(), 2u);
  EXPECT_NEAR(report["total"]["result"].get<double>(), 48, 1e-9);
  EXPECT_EQ(report["total"]["tools"], 0);
}

TEST_F(TrimSolidsCommand, SplitsByAFaceOfASolid) {
  write(BRepPrimAPI_MakeBox(gp_Pnt(-9, -9, -9), gp_Pnt(9, 9, 1.5)).Solid(), "below.brep");
  const Finished run = combine("below.brep#6", {"split", "-o", folder / "parts.step"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("split, complete, 2 solids"), std::string::npos) << run.out;
}

TEST_F(TrimSolidsCommand, CutsASheetByASolid) {
  const gp_Pln level({0, 0, 1}, {0, 0, 1});
  write(BRepBuilderAPI_MakeFace(level, -9, 9, -9, 9).Face(), "sheet.brep");
  const Finished run = combine(
      "sheet.brep", {"common", "-o", folder / "inside.step", "--json", folder / "inside.json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("1 sheet"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("areas: part 0, tools 324, result"), std::string::npos) << run.out;
  const occt::Model inside = occt::read_model(folder / "inside.step");
  EXPECT_EQ(inside.face_count(), 1);
  const json report = json::parse(testing::text_of(folder / "inside.json"));
  EXPECT_EQ(report["sheets"].size(), 1u);
  EXPECT_TRUE(report["solids"].empty());
  EXPECT_NEAR(report["areas"]["result"].get<double>(), occt::area(inside.face(1)), 1e-9);
}

// A box in a file with a sheet before it, which has no inside.
TEST_F(TrimSolidsCommand, LeavesOutFacesBesideSolidsAndTellsIt) {
  occt::quiet_messages();
  occt::Model mixed;
  mixed.add(BRepBuilderAPI_MakeFace(gp_Pln({0, 0, 1}, {0, 0, 1}), -9, 19, -9, 19).Face(), "datum");
  mixed.add(BRepPrimAPI_MakeBox(gp_Pnt(3, -2, 0), gp_Pnt(5, 2, 3)).Shape(), "block");
  occt::write_model(mixed, folder / "mixed.step");
  for (const auto& [operation, volume] :
       {std::pair{"cut", 12.0}, {"common", 12.0}, {"fuse", 36.0}}) {
    const Finished run =
        blossom({"trim", folder / "mixed.step", folder / "beside.brep", "--solid", operation, "-o",
                 folder / "made.step", "--json", folder / "made.json"});
    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_NE(run.out.find("mixed.step is in no closed solid and left out"), std::string::npos)
        << run.out;
    const json report = json::parse(testing::text_of(folder / "made.json"));
    EXPECT_EQ(report["left_out"].size(), 1U);
    EXPECT_NEAR(report["total"]["result"].get<double>(), volume, 1e-9);
    const occt::Model made = occt::read_model(folder / "made.step");
    EXPECT_EQ(made.part_name(1).substr(0, 5), "block");
  }
}

TEST_F(TrimSolidsCommand, CutsAWireByASolid) {
  write(BRepBuilderAPI_MakePolygon(gp_Pnt(-3, 0, 1), gp_Pnt(1, 0, 1), gp_Pnt(1, 5, 1)).Shape(),
        "wire.brep");
  const auto trim = [&](const std::string& part, const std::string& tool,
                        const std::string& operation) {
    return blossom({"trim", folder / part, folder / tool, "--solid", operation, "-o",
                    folder / "cut.brep", "--json", folder / "cut.json"});
  };
  for (const auto& [operation, length] : {std::pair{"cut", 4.}, {"common", 5.}, {"split", 9.}}) {
    const Finished run = trim("wire.brep", "box.brep", operation);
    ASSERT_EQ(run.code, 0) << run.err;
    const json report = json::parse(testing::text_of(folder / "cut.json"));
    EXPECT_EQ(report["wires"]["lengths"]["part"], 9);
    EXPECT_NEAR(report["wires"]["lengths"]["result"], length, 1e-6);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(occt::read_model(folder / "cut.brep").shape(), TopAbs_EDGE, edges);
    EXPECT_EQ(report["wires"]["edges"], edges.Extent());
  }
  const Finished refused = trim("box.brep", "wire.brep", "cut");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("wires take nothing off faces and solids"), std::string::npos);
}

TEST_F(TrimSolidsCommand, RefusesWhatItCannotMean) {
  EXPECT_NE(combine("ball.step", {"join"}).err.find("'join'"), std::string::npos);
  EXPECT_EQ(combine("ball.step", {"join"}).code, 2);
  EXPECT_EQ(combine("ball.step", {"cut", "--keep", "all"}).code, 2);
  EXPECT_EQ(combine("ball.step#1", {"cut"}).code, 0) << "the ball has one face";
  EXPECT_EQ(combine("away.brep#1", {"cut"}).code, 2);
  testing::write({testing::bowl()}, folder / "bowl.brep");
  const Finished open = combine("bowl.brep", {"cut"});
  EXPECT_EQ(open.code, 2);
  EXPECT_NE(open.err.find("bowl.brep is no closed solid"), std::string::npos) << open.err;
  EXPECT_NE(open.err.find("a sheet takes nothing off a solid, split divides it by one"),
            std::string::npos)
      << open.err;
}

}  // namespace
}  // namespace blossom
