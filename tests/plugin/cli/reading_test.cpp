// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that are damaged in parts: what is whole is used, and every command says what is not.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS_Face.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"
#include "tests/support/test_data.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

class Reading : public ::testing::Test {
 protected:
  Reading() {
    testing::write({testing::bowl(), testing::lid(0.25)}, folder / "whole.step");
    testing::write({testing::lid(-1)}, folder / "floor.brep");
    std::string text = testing::text_of(folder / "whole.step");
    testing::write_text(folder / "end.step", text.substr(0, text.rfind("END-ISO")));
    // One corner of the second face is a point in a plane.
    const std::size_t corner = text.find('#', text.rfind("VERTEX_POINT("));
    const std::string point = text.substr(corner, text.find(')', corner) - corner);
    const std::size_t numbers =
        text.find("(", text.find("CARTESIAN_POINT", text.find("\n" + point + " ")) + 16);
    text.erase(numbers + 1, text.find(',', numbers) - numbers);
    testing::write_text(folder / "corner.step", text);
  }

  json report_of(const std::string& file) const {
    return json::parse(blossom({"info", folder / file, "--json", "-"}).out);
  }

  testing::TestFolder folder;
};

TEST_F(Reading, WholeFilesAreReadWithoutAWord) {
  const Finished run = blossom({"info", folder / "whole.step"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(report_of("whole.step")["reading"][0]["grade"], "whole");
}

TEST_F(Reading, LossesThatTouchNoShapeAreALineAndNothingMore) {
  const Finished run = blossom({"info", folder / "end.step"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
  EXPECT_NE(run.err.find("read without 1 attribute"), std::string::npos) << run.err;
  EXPECT_EQ(report_of("end.step")["reading"][0]["grade"], "attributes lost");
  EXPECT_EQ(blossom({"info", folder / "end.step", "--strict"}).code, 0);
}

TEST_F(Reading, LossesOfShapeLowerTheStatusAndAreRefusedByStrict) {
  const Finished run = blossom({"info", folder / "corner.step"});
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
  EXPECT_NE(run.err.find("SHAPES ARE MISSING"), std::string::npos) << run.err;
  const json reading = report_of("corner.step")["reading"][0];
  EXPECT_EQ(reading["grade"], "shapes lost");
  EXPECT_EQ(reading["losses"][0]["what"], "face");
  EXPECT_TRUE(reading["losses"][0]["of_shape"]);
  const Finished strict = blossom({"info", folder / "corner.step", "--strict"});
  EXPECT_EQ(strict.code, 2);
  EXPECT_NE(strict.err.find("corner.step: is refused by --strict"), std::string::npos)
      << strict.err;
}

TEST_F(Reading, DamagedFacesOnWhichOpenCascadeCrashesAreLeftOut) {
  std::string text = testing::text_of(folder / "whole.step");
  const std::size_t bound = text.rfind("FACE_BOUND("), loop = text.find('#', bound);
  testing::write_text(folder / "loop.step", text.replace(loop, text.find(',', loop) - loop, "$"));
  const Finished run = blossom({"info", folder / "loop.step"});
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.err.find("FACE_BOUND: bound is missing"), std::string::npos) << run.err;
  EXPECT_EQ(report_of("loop.step")["counts"]["faces"], 1);
}

TEST_F(Reading, FacesThatHaveLostABorderAreLeftOutAndTold) {
  std::string text = testing::text_of(folder / "whole.step");
  const std::size_t used = text.find('#', text.rfind("ORIENTED_EDGE("));
  testing::write_text(folder / "open.step", text.replace(used, text.find(',', used) - used, "$"));
  EXPECT_EQ(report_of("open.step")["counts"]["faces"], 2);
  const Finished run = blossom({"intersect", folder / "open.step", folder / "floor.brep"});
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.err.find("open.step: face 2 has lost a border and is left out"), std::string::npos)
      << run.err;
}

// Two edges on one line round nothing.
TopoDS_Face face_of_no_width() {
  const TopoDS_Vertex a = BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 9)).Vertex(),
                      b = BRepBuilderAPI_MakeVertex(gp_Pnt(4, 0, 9)).Vertex();
  const TopoDS_Edge there = BRepBuilderAPI_MakeEdge(a, b), back = BRepBuilderAPI_MakeEdge(b, a);
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, new Geom_Plane(gp_Pnt(0, 0, 9), gp::DZ()), 1e-7);
  BRep_Builder().Add(face, BRepBuilderAPI_MakeWire(there, back).Wire());
  return face;
}

TEST_F(Reading, FacesOfNoWidthAreLeftOutAndTold) {
  testing::write({testing::lid(1), face_of_no_width(), testing::lid(2)}, folder / "line.brep");
  const std::string file = folder / "line.brep";
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"self-intersect", "--faces", file},
        {"query", "ray", file, "--from", "0.2,0.2,-9", "--direction", "0,0,1"}}) {
    const Finished run = blossom(command);
    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_NE(run.err.find("line.brep: face 2 has no width and is left out"), std::string::npos)
        << run.err;
  }
}

TEST_F(Reading, SolidsKeepTheirInsideBesideAFaceThatIsLeftOut) {
  occt::Model beside, cube;
  beside.add(face_of_no_width(), "");
  beside.add(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), "");
  occt::write_model(beside, folder / "stray.brep");
  cube.add(BRepPrimAPI_MakeBox(gp_Pnt(4, 4, 4), 1, 1, 1).Shape(), "");
  occt::write_model(cube, folder / "cube.brep");
  const std::string stray = folder / "stray.brep";
  const Finished mass = blossom({"query", "mass", stray, "--json", "-"});
  EXPECT_EQ(mass.code, 3) << mass.err;
  const nlohmann::json report = nlohmann::json::parse(mass.out, nullptr, false);
  ASSERT_TRUE(report.contains("total")) << mass.out;
  EXPECT_NEAR(report["total"].value("volume", 0.0), 1000, 1e-9);
  const Finished run = blossom({"query", "distance", stray, folder / "cube.brep"});
  EXPECT_NE(run.out.find("cube.brep is inside "), std::string::npos) << run.out;
}

TEST_F(Reading, NoStatusIsBetterThanToleranceThen) {
  const std::string floor = folder / "floor.brep";
  const Finished whole =
      blossom({"query", "distance", folder / "whole.step", floor, "--json", "-"});
  const Finished lost =
      blossom({"query", "distance", folder / "corner.step", floor, "--json", "-"});
  EXPECT_EQ(json::parse(whole.out)["status"], "complete");
  EXPECT_EQ(json::parse(lost.out)["status"], "tolerance");
  EXPECT_EQ(whole.code, 0) << whole.err;
  EXPECT_EQ(lost.code, 3) << lost.err;
  EXPECT_EQ(json::parse(lost.out)["reading"].size(), 2U);
}

// Open CASCADE's reader of IGES crashes on some of them.
TEST(ReadingCutFiles, AreReadInPartsOrRefusedInWords) {
  const testing::TestFolder folder;
  occt::Model model;
  model.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "box");
  for (const std::string ending : {".iges", ".step", ".brep"}) {
    const std::string file = folder / ("whole" + ending), cut = folder / ("cut" + ending);
    occt::write_model(model, file);
    const std::string text = testing::text_of(file);
    for (std::size_t k = 1; k < 20; ++k) {
      testing::write_text(cut, text.substr(0, text.size() * k / 20));
      const Finished run = blossom({"info", cut}, "timeout 10");
      EXPECT_TRUE(run.code == 2 || run.code == 3) << ending << " " << k << ": " << run.code;
      EXPECT_NE(run.err.find(cut + ": "), std::string::npos) << run.err;
      EXPECT_EQ(run.err.find("Standard_"), std::string::npos) << run.err;
    }
  }
}

/// Counts of a file of other readers' test data.
struct Known {
  const char* file;
  int solids, faces;
};

TEST(ReadingForeignFiles, GiveTheShapesThatOtherReadersFind) {
  const char* const data = blossom::testing::test_data();
  if (data == nullptr) GTEST_SKIP() << blossom::testing::kNoTestData;
  const std::filesystem::path files = std::filesystem::path(data) / "files";
  const Known known[] = {
      {"crash_2.igs", 0, 41},      {"refused_01.stp", 1, 6},   {"refused_02.stp", 0, 1},
      {"refused_03.stp", 1, 6},    {"refused_04.stp", 10, 96}, {"refused_05.stp", 1, 30},
      {"refused_06.stp", 4, 46},   {"refused_07.stp", 1, 12},  {"refused_08.stp", 1, 9},
      {"refused_09.stp", 11, 138}, {"refused_10.stp", 2, 16},  {"refused_11.stp", 1, 7},
      {"refused_12.stp", 0, 1},    {"refused_13.stp", 1, 415}, {"refused_14.stp", 1, 9},
      {"refused_15.igs", 0, 1}};
  for (const Known& one : known) {
    const Finished run = blossom({"info", files / one.file, "--json", "-"});
    ASSERT_TRUE(run.code == 0 || run.code == 3) << one.file << ": " << run.err;
    const json counts = json::parse(run.out)["counts"];
    EXPECT_EQ(counts["solids"], one.solids) << one.file;
    EXPECT_GE(counts["faces"], one.faces) << one.file;  // we save faces of solids that others drop
  }
  for (const char* file : {"hang_1.brep", "hang_2.brep"}) {
    const Finished run = blossom({"info", files / file}, "timeout 10");
    EXPECT_EQ(run.code, 2) << file;
    EXPECT_EQ(run.err.find("Standard_"), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace blossom
