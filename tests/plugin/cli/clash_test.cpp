// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom clash`, as a user runs it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using std::numbers::pi;
using testing::blossom;
using testing::Finished;

TopoDS_Shape box(double x, double y, double z, double a, double b, double c) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), a, b, c).Shape();
}

TopoDS_Shape ball(double x, double y, double z, double radius) {
  return BRepPrimAPI_MakeSphere(gp_Pnt(x, y, z), radius).Shape();
}

TopoDS_Shape rod(double x, double y, double z, double radius, double height) {
  const gp_Ax2 axis(gp_Pnt(x, y, z), gp_Dir(0, 0, 1));
  return BRepPrimAPI_MakeCylinder(axis, radius, height).Shape();
}

TopoDS_Shape twisted_loft() {
  BRepOffsetAPI_ThruSections loft(true, true);
  for (int k = 0; k < 3; ++k) {
    BRepBuilderAPI_MakePolygon section;
    for (int i = 0; i < 4; ++i) {
      const double radius = 8 + 1.6 * std::sin(5 * i + 3 * k), angle = 0.5 * pi * i + 0.1 * k;
      section.Add(gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), 10 * k));
    }
    section.Close();
    loft.AddWire(section.Wire());
  }
  return loft.Shape();
}

using Parts = std::vector<std::pair<std::string, TopoDS_Shape>>;

// Its border goes from the origin to (0, 0, height) and back on the plane x = 0.
TopoDS_Shape face_of_no_width(double height) {
  const TopoDS_Vertex low = BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 0));
  const TopoDS_Vertex high = BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, height));
  const TopoDS_Edge there = BRepBuilderAPI_MakeEdge(low, high),
                    back = BRepBuilderAPI_MakeEdge(high, low);
  const TopoDS_Wire border = BRepBuilderAPI_MakeWire(there, back);
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3({0, 0, 0}, {1, 0, 0}, {0, 1, 0})), border).Shape();
}

// A shaft pressed 0.05 into a bearing, a foot under a frame, a ball on it, a lid 2 away from it, a
// ball inside a box.
Parts machine() {
  const TopoDS_Shape bearing =
      BRepAlgoAPI_Cut(rod(200, 0, 0, 20, 15), rod(200, 0, -5, 10, 30)).Shape();
  return {{"Frame", box(0, 0, 0, 100, 100, 10)},  {"Foot", box(10, 10, -30, 20, 20, 30)},
          {"Ball", ball(50, 50, 15, 5)},          {"Lid", box(102, 0, 0, 20, 100, 10)},
          {"Shaft", rod(200, 0, -20, 10.05, 60)}, {"Bearing", bearing},
          {"Case", box(300, 0, 0, 30, 30, 30)},   {"Marble", ball(315, 15, 15, 5)}};
}

class ClashCommand : public ::testing::Test {
 protected:
  std::string file_of(const Parts& parts, const std::string& name) {
    occt::Model model;
    for (const auto& [part, shape] : parts) model.add(shape, part);
    occt::write_model(model, folder_ / name);
    return folder_ / name;
  }

  json report_of(std::vector<std::string> words, int code = 0) {
    words.insert(words.end(), {"--json", "-"});
    const Finished run = blossom(words);
    EXPECT_EQ(run.code, code) << run.err;
    return json::parse(run.out);
  }

  // The pair of two parts.
  static json pair_in(const json& report, const std::string& a, const std::string& b) {
    for (const json& pair : report["pairs"]) {
      const std::string name_a = report["parts"][pair["a"].get<std::size_t>()]["name"];
      const std::string name_b = report["parts"][pair["b"].get<std::size_t>()]["name"];
      if ((name_a == a && name_b == b) || (name_a == b && name_b == a)) return pair;
    }
    return {};
  }

  testing::TestFolder folder_;
};

TEST_F(ClashCommand, TellsInOneTableHowAllPartsLieToEachOther) {
  const std::string file = file_of(machine(), "machine.step");
  // That the ball touches in a point alone is known within tolerance.
  const json report = report_of({"clash", file, "--far"});
  EXPECT_EQ(report["schema"], "blossom.clash/1");
  EXPECT_EQ(report["pairs"].size(), 28u);
  EXPECT_EQ(report["counts"], (json{{"penetrates", 1},
                                    {"contained", 1},
                                    {"equal", 0},
                                    {"touches", 2},
                                    {"clear", 24},
                                    {"unknown", 0}}));

  const json shaft = pair_in(report, "Shaft", "Bearing");
  EXPECT_EQ(shaft["relation"], "penetrates");
  EXPECT_NEAR(shaft["common"]["volume"], pi * (10.05 * 10.05 - 100) * 15, 1e-4);
  EXPECT_NEAR(shaft["common"]["depth"][0], 0.05, 1e-6);
  EXPECT_GE(shaft["common"]["depth"][1], 0.05);
  EXPECT_LE(shaft["common"]["depth"][1], 0.051);

  const json foot = pair_in(report, "Foot", "Frame");
  EXPECT_EQ(foot["relation"], "touches");
  EXPECT_EQ(foot["contacts"][0]["kind"], "face");
  EXPECT_EQ(foot["contacts"][0]["box"], json({{10.0, 10.0, 0.0}, {30.0, 30.0, 0.0}}));

  const json on_it = pair_in(report, "Ball", "Frame");
  EXPECT_EQ(on_it["relation"], "touches");
  ASSERT_EQ(on_it["contacts"].size(), 1u);
  EXPECT_EQ(on_it["contacts"][0]["kind"], "point");
  EXPECT_NEAR(on_it["contacts"][0]["point"][2], 10, 1e-9);

  const json lid = pair_in(report, "Lid", "Frame");
  EXPECT_EQ(lid["relation"], "clear");
  EXPECT_NEAR(lid["distance"][0], 2, 1e-9);
  EXPECT_NEAR(lid["distance"][1], 2, 1e-9);

  const json marble = pair_in(report, "Marble", "Case");
  EXPECT_EQ(marble["relation"], "contained");
  EXPECT_NEAR(marble["common"]["volume"], 4.0 / 3 * pi * 125, 1e-4);
  EXPECT_NEAR(marble["boundary_distance"][1], 10, 1e-9);
}

// The ends lie in the other body's boundary, all of them, and have no depth.
TEST_F(ClashCommand, TellsTheDepthOfAPressedShaftThatEndsFlush) {
  const TopoDS_Shape bearing = BRepAlgoAPI_Cut(rod(0, 0, 0, 20, 10), rod(0, 0, -5, 10, 20)).Shape();
  const std::string file =
      file_of({{"Bearing", bearing}, {"Shaft", rod(0, 0, 0, 10.05, 10)}}, "flush.step");

  const json common = report_of({"clash", file})["pairs"][0]["common"];
  EXPECT_NEAR(common["depth"][0], 0.05, 1e-6);
  EXPECT_LE(common["depth"][1], 0.051);
}

// Where the head begins, the ring of the cover within the bolt lies along the end of the shank.
TEST_F(ClashCommand, TellsTheDepthOfATightBoltWhoseHeadLiesOnTheCover) {
  const TopoDS_Shape cover =
      BRepAlgoAPI_Cut(box(-10, -10, 0, 20, 20, 6), rod(0, 0, -5, 3, 20)).Shape();
  const TopoDS_Shape bolt = BRepAlgoAPI_Fuse(rod(0, 0, -8, 3.02, 14), rod(0, 0, 6, 5, 3)).Shape();
  const std::string file = file_of({{"Cover", cover}, {"Bolt", bolt}}, "bolt.step");

  const json common = report_of({"clash", file})["pairs"][0]["common"];
  EXPECT_NEAR(common["depth"][0], 0.02, 1e-6);
  EXPECT_LE(common["depth"][1], 0.0203);
}

TEST_F(ClashCommand, TellsWhereASheetCrossesASolid) {
  const TopoDS_Shape sheet =
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1)), -3, 20, 2, 8).Face();
  const std::string file =
      file_of({{"Block", box(0, 0, 0, 10, 10, 10)}, {"Sheet", sheet}}, "sheet.step");

  const json pair = report_of({"clash", file})["pairs"][0];
  EXPECT_EQ(pair["relation"], "penetrates");
  ASSERT_FALSE(pair["contacts"].empty());
  EXPECT_EQ(pair["contacts"][0]["kind"], "curve");
  EXPECT_NEAR(pair["contacts"][0]["point"][2], 5, 1e-9);
  EXPECT_NE(blossom({"clash", file}).out.find("curves, one of them at ("), std::string::npos);
}

// The rest would be the square of the parts.
TEST_F(ClashCommand, ListsPairsThatWereLookedAtAndCountsAll) {
  Parts row;
  for (int k = 0; k < 40; ++k)
    row.emplace_back("p" + std::to_string(k), box(1.5 * k, 0, 0, 1, 1, 1));
  const std::string file = file_of(row, "row.step");
  const json report = report_of({"clash", file});
  EXPECT_EQ(report["counts"]["clear"], 40 * 39 / 2);
  EXPECT_GE(report["pairs"].size(), 20u);
  EXPECT_LE(report["pairs"].size(), 40u);
  for (const json& pair : report["pairs"]) EXPECT_NEAR(pair["distance"][1], 0.5, 1e-9);
  const Finished run = blossom({"clash", file});
  EXPECT_NE(run.out.find("whose boxes are apart; --far lists them"), std::string::npos) << run.out;
  EXPECT_EQ(report_of({"clash", file, "--far"})["pairs"].size(), 40u * 39 / 2);
}

TEST_F(ClashCommand, SaysItInWordsAndAsATable) {
  const std::string file = file_of(machine(), "machine.step"), table = folder_ / "table.csv";
  const Finished run = blossom({"clash", file, "--far", "--table", table});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("complete, 8 parts, 28 pairs, 1 penetrates, 1 contained, 2 touches"),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("  penetrates  Shaft"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("Marble is inside"), std::string::npos) << run.out;
  const std::string rows = testing::text_of(table);
  EXPECT_EQ(rows.substr(0, rows.find('\n')),
            "a,b,relation,contact,volume,depth_lower,depth_upper,distance_lower,distance_upper,x,y,"
            "z,status,note");
  EXPECT_NE(rows.find("\nFrame,Foot,touches,face,"), std::string::npos) << rows;
  EXPECT_NE(rows.find("\nFrame,Lid,clear,,,,,"), std::string::npos) << rows;
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 29);
}

TEST_F(ClashCommand, WritesTheCommonBodies) {
  const std::string file = file_of(machine(), "machine.step"), common = folder_ / "common.step";
  ASSERT_EQ(blossom({"clash", file, "-o", common}).code, 0);
  const occt::Model model = occt::read_model(common);
  EXPECT_EQ(model.part_name(1), "Shaft x Bearing");
  EXPECT_EQ(model.part_name(model.face_count()), "Case x Marble");
}

TEST_F(ClashCommand, ShowsPartsAndWhatTheyHaveInCommon) {
  const std::string file = file_of(machine(), "machine.step");
  const std::string picture = folder_ / "machine.png", page = folder_ / "machine.html";
  const Finished run = blossom({"clash", file, "--picture", picture, "--html", page});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(testing::text_of(picture).substr(1, 3), "PNG");
  const std::string text = testing::text_of(page);
  for (const char* told : {"clashes of machine.step", "parts that clash", "in common", "touching",
                           "Shaft and Bearing"})
    EXPECT_NE(text.find(told), std::string::npos) << told;
}

TEST_F(ClashCommand, TellsSolidsWithoutNamesOfTwoModelsByTheirFiles) {
  const std::string a = file_of({{"", box(0, 0, 0, 2, 2, 2)}}, "a.brep");
  const std::string b = file_of({{"", box(1, 1, 1, 2, 2, 2)}}, "b.brep");
  const Finished run = blossom({"clash", a, b});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("  penetrates  a.brep solid 1  b.brep solid 1  volume 1 mm³"),
            std::string::npos)
      << run.out;
}

TEST_F(ClashCommand, MeasuresDistancesUpToAClearance) {
  const std::string file = file_of(
      {{"a", box(0, 0, 0, 1, 1, 1)}, {"b", box(1.5, 0, 0, 1, 1, 1)}, {"c", box(4, 0, 0, 1, 1, 1)}},
      "row.step");
  const json report = report_of({"clash", file, "--far", "--clearance", "1"});
  EXPECT_NEAR(pair_in(report, "a", "b")["distance"][1], 0.5, 1e-9);
  const json far = pair_in(report, "b", "c");
  EXPECT_EQ(far["relation"], "clear");
  EXPECT_NEAR(far["distance"][0], 1.5, 1e-6);
  EXPECT_TRUE(far["distance"][1].is_null());
  EXPECT_EQ(blossom({"clash", file, "--clearance", "1", "--fail-on", "findings"}).code, 5);
  EXPECT_EQ(blossom({"clash", file, "--clearance", "0.4", "--fail-on", "findings"}).code, 0);
}

// The boundaries are 10 apart, which is more than the clearance.
TEST_F(ClashCommand, ListsWhatIsDeepInsideOfAPartWhateverTheClearance) {
  const std::string file = file_of(machine(), "machine.step"), table = folder_ / "table.csv";
  const Finished run = blossom({"clash", file, "--clearance", "3", "--table", table});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("Marble is inside"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\n  23 pairs farther apart than 3; "), std::string::npos) << run.out;
  const std::string rows = testing::text_of(table);
  const std::string row = rows.substr(rows.find("\nCase,Marble,contained,"));
  EXPECT_EQ(row.find(",,,,complete"), std::string::npos) << "where it is deepest is missing\n"
                                                         << row;
}

// As most parts of an assembly beside its next edition are.
TEST_F(ClashCommand, BoundsTheDepthOfAShaftThatEndsFlushWithItsBearing) {
  const TopoDS_Shape bearing = BRepAlgoAPI_Cut(rod(0, 0, 0, 20, 10), rod(0, 0, 0, 10, 10)).Shape();
  const std::string file =
      file_of({{"Bearing", bearing}, {"Shaft", rod(0, 0, 0, 10.05, 10)}}, "flush.step");
  const json report = report_of({"clash", file});
  ASSERT_EQ(report["pairs"].size(), 1u);
  const json& depth = report["pairs"][0]["common"]["depth"];
  EXPECT_NEAR(depth[0], 0.05, 1e-6);
  EXPECT_LE(depth[1], 0.051);
}

TEST_F(ClashCommand, EqualPartsReachIntoEachOtherByNoMoreThanTheTolerance) {
  const std::string a =
      file_of({{"rod", rod(0, 0, 0, 3, 9)}, {"box", box(9, 0, 0, 5, 4, 3)}}, "old.step");
  const std::string b =
      file_of({{"rod", rod(0, 0, 0, 3, 9)}, {"box", box(9, 0, 0, 5, 4, 3)}}, "new.step");
  const json report = report_of({"clash", a, b});
  EXPECT_EQ(report["counts"]["equal"], 2);
  for (const json& pair : report["pairs"]) {
    if (pair["relation"] != "equal") continue;
    EXPECT_LE(pair["common"]["depth"][1], 1e-7);
  }
  const Finished run = blossom({"clash", a, b});
  EXPECT_EQ(run.out.find("deepest"), std::string::npos) << run.out;
}

// Its faces are told from each other within tolerance only.
TEST_F(ClashCommand, KnowsAPartThatIsThereTwice) {
  const std::string file = file_of({{"loft", twisted_loft()}}, "loft.step");
  const json report = report_of({"clash", file, file});
  EXPECT_EQ(report["status"], "complete");
  EXPECT_EQ(report["counts"]["equal"], 1);
}

TEST_F(ClashCommand, ComparesPartsOfTwoModelsWithEachOther) {
  const std::string a =
      file_of({{"one", box(0, 0, 0, 1, 1, 1)}, {"two", box(0.5, 0, 0, 1, 1, 1)}}, "a.step");
  const std::string b = file_of({{"post", box(0.25, 0.25, -1, 0.5, 0.5, 3)}}, "b.step");
  const json report = report_of({"clash", a, b});
  ASSERT_EQ(report["pairs"].size(), 2u);
  EXPECT_NEAR(pair_in(report, "one", "post")["common"]["volume"], 0.25, 1e-9);
  EXPECT_NEAR(pair_in(report, "two", "post")["common"]["volume"], 0.125, 1e-9);
}

// The cap of the ball is 0.3 high.
TEST_F(ClashCommand, BoundsTheDepthOfFreelyPlacedBodies) {
  const std::string file =
      file_of({{"block", box(0, 0, 0, 10, 10, 10)}, {"ball", ball(12, 5, 5, 2.3)}}, "deep.step");
  const json pair = pair_in(report_of({"clash", file}), "block", "ball");
  EXPECT_EQ(pair["relation"], "penetrates");
  EXPECT_NEAR(pair["common"]["volume"], pi * 0.09 * (2.3 - 0.1), 1e-6);
  EXPECT_LE(pair["common"]["depth"][0], 0.3 + 1e-7);
  EXPECT_GE(pair["common"]["depth"][1], 0.3);
  EXPECT_LE(pair["common"]["depth"][1], 0.304);
}

TEST_F(ClashCommand, TellsTouchesAlongEdges) {
  gp_Trsf turn, up;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)), pi / 4);
  up.SetTranslation(gp_Vec(0, 0, std::sqrt(0.5)));  // the lowest edge comes to z = 0
  const TopoDS_Shape wedge = box(0, 2, 0, 1, 3, 1).Moved(TopLoc_Location(up * turn));
  const std::string file =
      file_of({{"table", box(-5, 0, -8, 10, 10, 8)}, {"wedge", wedge}}, "edge.step");
  const json pair = pair_in(report_of({"clash", file}), "table", "wedge");
  EXPECT_EQ(pair["relation"], "touches");
  ASSERT_FALSE(pair["contacts"].empty());
  EXPECT_EQ(pair["contacts"][0]["kind"], "curve");
  EXPECT_NEAR(pair["contacts"][0]["box"][0][1], 2, 1e-6);
  EXPECT_NEAR(pair["contacts"][0]["box"][1][1], 5, 1e-6);
}

// A ring at three places of one file, turned and askew: it is made ready once.
TEST_F(ClashCommand, MeasuresInstancesWhereTheyArePlaced) {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(2, 0.5).Shape();
  gp_Trsf turn, beside, above;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0.7);
  beside.SetTranslation(gp_Vec(7, 0, 0));
  above.SetTranslation(gp_Vec(0, 0, 3));
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const gp_Trsf& place : {turn, beside * turn, above})
    builder.Add(all, ring.Moved(TopLoc_Location(place)));
  const std::string file = folder_ / "rings.brep";
  BRepTools::Write(all, file.c_str());
  const json report = report_of({"clash", file, "--clearance", "10"});
  EXPECT_NEAR(pair_in(report, "solid 1", "solid 2")["distance"][1], 2, 1e-9);
  EXPECT_NEAR(pair_in(report, "solid 1", "solid 3")["distance"][1], 2, 1e-9);
  const double askew = std::sqrt(3 * 3 + 3 * 3) - 1;  // of the circles that are nearest
  EXPECT_NEAR(pair_in(report, "solid 2", "solid 3")["distance"][1], askew, 1e-9);
}

// As FreeCAD makes tori: Open CASCADE's box of one has no height then, and the two do not meet.
TEST_F(ClashCommand, SeesATorusOfAnyAngles) {
  const TopoDS_Shape ring =
      BRepPrimAPI_MakeTorus(3, 1, -std::numbers::pi, std::numbers::pi).Shape();
  const std::string file =
      file_of({{"ring", ring}, {"block", box(2.5, -0.5, 0.5, 1, 1, 1)}}, "ring.step");
  EXPECT_EQ(pair_in(report_of({"clash", file}), "ring", "block")["relation"], "penetrates");
}

TEST_F(ClashCommand, LeavesPairsOfWhatCannotBeMeasuredOpenAndLooksAtTheOthers) {
  const std::string file = file_of({{"A", box(-1, -1, -1, 2, 2, 2)},
                                    {"B", box(0.5, 0.5, 0.5, 2, 2, 2)},
                                    {"C", face_of_no_width(1)}},
                                   "narrow.brep");
  const json report = report_of({"clash", file}, 3);
  EXPECT_EQ(report["counts"]["penetrates"], 1);
  EXPECT_EQ(report["counts"]["unknown"], 1);
  const Finished told = blossom({"clash", file});
  EXPECT_NE(told.out.find("they cannot be measured: the face's parameter box in "),
            std::string::npos)
      << told.out << told.err;
}

TEST_F(ClashCommand, RefusesAModelOfOnePart) {
  const Finished run = blossom({"clash", file_of({{"a", box(0, 0, 0, 1, 1, 1)}}, "one.step")});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("has one part alone"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace blossom
