// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom blend fill`: the written faces, the report, the refusals.

#include <gtest/gtest.h>

#include <numbers>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/blending/hole.h"
#include "adapters/occt/face_colours.h"
#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"
#include "tests/support/face_holes.h"
#include "tests/support/measures.h"

namespace blossom::testing {
namespace {

class BlendFill : public ::testing::Test {
 protected:
  BlendFill() {
    write({squarely_holed()}, folder / "square.brep");
    write({slantly_holed()}, folder / "slant.step");
    write({bowl()}, folder / "bowl.brep");
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }

  TestFolder folder;
};

TEST_F(BlendFill, WritesValidFacesAndReportsTheirContinuity) {
  const Finished ran = blossom({"blend", "fill", path("square.brep"), "--edges", "8,5,7,6", "-o",
                                path("out.step"), "--json", "-"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json report = nlohmann::json::parse(ran.out);
  EXPECT_EQ(report["schema"], "blossom.blend/1");
  EXPECT_EQ(report["kind"], "fill");
  ASSERT_EQ(report["holes"].size(), 1u);
  const nlohmann::json& hole = report["holes"][0];
  EXPECT_EQ(hole["layout"], "star");
  EXPECT_EQ(hole["reached"], "G1");
  EXPECT_EQ(hole["sides"].size(), 4u);
  EXPECT_LE(hole["inside"]["normal_angle"], 1e-12);
  for (const nlohmann::json& side : hole["sides"]) {
    EXPECT_EQ(side["exact"], true);
    EXPECT_EQ(side["asked"], "G1");
    EXPECT_LE(side["normal_angle"], 1e-12);
  }
  const occt::Model model = occt::read_model(path("out.step"));
  EXPECT_EQ(model.face_count(), 4);
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
}

TEST_F(BlendFill, JoinsTheFillToTheModel) {
  const Finished ran = blossom({"blend", "fill", path("square.brep"), "--edges", "5,6,7,8",
                                "--continuity", "G2", "--sew", "-o", path("out.step")});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const occt::Model model = occt::read_model(path("out.step"));
  EXPECT_EQ(model.face_count(), 5);
  EXPECT_EQ(occt::open_edges(model.shape()).size(), 4u);
}

// A cup has a round hole that no patch can continue; in a plate the plane goes on.
TEST_F(BlendFill, ClosesRoundHolesByThePlaneInWhichTheyLie) {
  occt::quiet_messages();
  occt::Model cup, plate;
  cup.add(BRepPrimAPI_MakeCylinder(10, 20).Shape(), "Cup");
  cup.replace_faces({{2, {}}});
  write_model(cup, folder / "cup.step");
  plate.add(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40, 30, 20).Shape(),
                      BRepPrimAPI_MakeCylinder(gp_Ax2({20, 15, -5}, {0, 0, 1}), 5, 40).Shape())
          .Shape(),
      "Plate");
  for (int number = 1; number <= plate.face_count(); ++number)
    if (BRepAdaptor_Surface(plate.face(number)).GetType() == GeomAbs_Cylinder) {
      plate.replace_faces({{number, {}}});
      break;
    }
  write_model(plate, folder / "plate.step");

  const Finished steep = blossom({"blend", "fill", path("cup.step"), "-o", path("no.step")});
  EXPECT_EQ(steep.code, 2);
  EXPECT_NE(steep.err.find("a flat face in it meets the neighbour at edge"), std::string::npos)
      << steep.err;
  EXPECT_NE(steep.err.find("of 90 degrees; G0 asks for no tangent planes"), std::string::npos)
      << steep.err;
  const Finished closed = blossom(
      {"blend", "fill", path("cup.step"), "--continuity", "G0", "--sew", "-o", path("full.step")});
  EXPECT_EQ(closed.code, 0) << closed.err;
  EXPECT_NE(closed.out.find("a flat face, G0"), std::string::npos) << closed.out;
  EXPECT_NEAR(volume(occt::read_model(path("full.step")).shape()), std::numbers::pi * 2000, 1e-6);
  const Finished smooth =
      blossom({"blend", "fill", path("plate.step"), "--sew", "-o", path("whole.step")});
  EXPECT_EQ(smooth.code, 0) << smooth.err;
  EXPECT_NE(smooth.out.find("a flat face, G1"), std::string::npos) << smooth.out;
  EXPECT_NEAR(volume(occt::read_model(path("whole.step")).shape()), 24000, 1e-6);
}

TEST_F(BlendFill, ClosesASolidThatKeepsItsNamesLooksAndAssembly) {
  occt::Model open;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 3, 2).Shape();
  open.add(box, "Tray", {1, 0, 0});
  open.add(BRepPrimAPI_MakeBox(gp_Pnt(9, 0, 0), 1, 1, 1).Shape(), "Pin", {0, 0, 1});
  open.replace_faces({{6, {}}});  // the top
  write_model(open, folder / "tray.step");
  const Finished ran = blossom({"blend", "fill", path("tray.step"), "--continuity", "G0", "--sew",
                                "-o", path("closed.step")});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const occt::Model model = occt::read_model(path("closed.step"));
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(model.shape(), TopAbs_SOLID, solids);
  EXPECT_EQ(solids.Extent(), 2);
  EXPECT_NEAR(volume(model.shape()), 4 * 3 * 2 + 1, 1e-9);
  const std::vector<std::string> parts = model.part_paths();
  const std::vector<std::optional<occt::FaceColour>> colours = occt::face_colours(model);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_pin = i + 6 >= parts.size();
    EXPECT_EQ(parts[i], is_pin ? "Pin" : "Tray") << i;
    ASSERT_TRUE(colours[i].has_value()) << i;
    EXPECT_EQ(colours[i]->at(0) > 0.5, !is_pin) << i;
  }
}

TEST_F(BlendFill, WithoutEdgesFillsHolesAndNotTheOuterBorder) {
  const Finished ran = blossom({"blend", "fill", path("square.brep"), "--json", "-"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json report = nlohmann::json::parse(ran.out);
  EXPECT_EQ(report["holes"].size(), 1u);
  EXPECT_TRUE(report["refused"].empty());
  ASSERT_EQ(report["outer_borders"].size(), 1u);
  EXPECT_EQ(report["outer_borders"][0].size(), 4u);
}

TEST_F(BlendFill, SaysThatASheetWithoutAHoleHasNone) {
  testing::write({testing::lid(0)}, folder / "lid.brep");
  const Finished ran = blossom({"blend", "fill", path("lid.brep"), "-o", path("out.step")});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find(" are the outer border of a sheet; name them to close it"),
            std::string::npos)
      << ran.err;
}

TEST_F(BlendFill, TakesAContinuityForEachEdge) {
  const Finished ran = blossom({"blend", "fill", path("square.brep"), "--edges", "5,6,7,8",
                                "--continuity", "G1,G0,G1,G0", "--json", "-"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json report = nlohmann::json::parse(ran.out);
  for (const nlohmann::json& side : report["holes"][0]["sides"])
    EXPECT_EQ(side["asked"], side["edge"].get<int>() % 2 == 1 ? "G1" : "G0");
}

TEST_F(BlendFill, TellsPeopleWhatItFilled) {
  const Finished ran = blossom({"blend", "fill", path("slant.step"), "--edges", "5,6,7,8"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("filled 1 hole of"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("was fitted within"), std::string::npos) << ran.out;
}

TEST_F(BlendFill, RefusesWhatIsNoHoleAndWritesNothing) {
  const struct {
    std::vector<std::string> options;
    const char* reason;
  } rows[] = {
      {{"--edges", "5,6,7"}, "ends"},
      {{"--edges", "5,6,7,9"}, "there is no edge 9"},
      {{"--edges", "5,5,6,7,8"}, "named twice"},
      {{"--edges", "1,2,3,4"}, "hole's side"},
      {{"--edges", "5,6,7,8", "--continuity", "G3"}, "G0, G1 or G2"},
      {{"--edges", "5,6,7,8", "--continuity", "G1,G2"}, "2 words for 4 edges"},
      {{"--edges", "5,6,7,8", "--tolerance", "0"}, "positive"},
      {{"--edges", "five"}, "five"},
      {{"--layout", "flower"}, "star"},
  };
  for (const auto& row : rows) {
    std::vector<std::string> arguments{"blend", "fill", path("square.brep"), "-o",
                                       path("out.step")};
    arguments.insert(arguments.end(), row.options.begin(), row.options.end());
    const Finished ran = blossom(arguments);
    EXPECT_EQ(ran.code, 2) << row.reason;
    EXPECT_NE(ran.err.find(row.reason), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(path("out.step"))) << row.reason;
  }
}

}  // namespace
}  // namespace blossom::testing
