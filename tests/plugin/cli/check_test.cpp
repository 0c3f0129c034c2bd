// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom check` on sound and unsound models, as a user runs it.

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

void write_shape(const TopoDS_Shape& shape, const std::filesystem::path& file) {
  occt::quiet_messages();
  occt::Model model;
  model.add(shape, "part");
  occt::write_model(model, file);
}

TopoDS_Solid open_box() {
  TopoDS_Shell shell;
  TopoDS_Solid solid;
  BRep_Builder().MakeShell(shell);
  BRep_Builder().MakeSolid(solid);
  TopExp_Explorer it(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), TopAbs_FACE);
  for (int i = 0; i < 5; ++i, it.Next()) BRep_Builder().Add(shell, it.Current());
  BRep_Builder().Add(solid, shell);
  return solid;
}

TEST(CheckCommand, AnswersZeroForASoundBox) {
  const testing::TestFolder folder;
  write_shape(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), folder / "box.step");
  const Finished run = blossom({"check", folder / "box.step"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("box.step: sound, 6 faces, 12 edges"), std::string::npos) << run.out;
}

TEST(CheckCommand, ReportsAnOpenSolidWithItsEdges) {
  const testing::TestFolder folder;
  write_shape(open_box(), folder / "open.brep");
  const Finished run = blossom({"check", folder / "open.brep", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["schema"], "blossom.check/1");
  EXPECT_EQ(report["verdict"], "not sound");
  EXPECT_EQ(report["sound"], false);
  EXPECT_EQ(report["summary"]["free_edges"], 4);
  EXPECT_EQ(report["faces"].size(), 5u);
  ASSERT_EQ(report["edges"].size(), 12u);
  int free = 0;
  for (const json& edge : report["edges"]) {
    EXPECT_LT(edge["gap"].get<double>(), 1e-12);
    EXPECT_EQ(edge["tolerance"], 1e-7);
    EXPECT_EQ(edge["free"].get<bool>(), !edge["problems"].empty());
    EXPECT_EQ(edge["faces"].size(), edge["free"].get<bool>() ? 1u : 2u);
    free += edge["free"].get<bool>() ? 1 : 0;
  }
  EXPECT_EQ(free, 4);
}

TEST(CheckCommand, LooksAtTheChosenFacesAlone) {
  const testing::TestFolder folder;
  testing::write({testing::bowl(), testing::half_pipe()}, folder / "parts.brep");
  const Finished run = blossom({"check", (folder / "parts.brep").string() + "#2", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.out << run.err;
  const json report = json::parse(run.out);
  ASSERT_EQ(report["faces"].size(), 1u);
  EXPECT_EQ(report["faces"][0]["number"], 2);
  EXPECT_EQ(report["edges"].size(), 4u);
}

TEST(CheckCommand, WritesTheReportBesideTheText) {
  const testing::TestFolder folder;
  write_shape(open_box(), folder / "open.brep");
  const Finished run = blossom({"check", folder / "open.brep", "--json", folder / "check.json"});
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.out.find("open.brep: not sound: 4 problems, "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("4 open edges"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("the solid is open there"), std::string::npos) << run.out;
  EXPECT_EQ(json::parse(testing::text_of(folder / "check.json"))["sound"], false);
}

TEST(CheckCommand, SaysOnceWhatIsWrongWithManyEdges) {
  const testing::TestFolder folder;
  // Two corners of a box with loose ends, 3e-3 and 5e-3 from their vertices; six edges.
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  for (TopExp_Explorer it(box, TopAbs_VERTEX); it.More(); it.Next()) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(it.Current());
    const gp_Pnt p = BRep_Tool::Pnt(vertex);
    const double off = p.Distance({0, 0, 0}) == 0 ? 3e-3 : p.Distance({1, 1, 1}) == 0 ? 5e-3 : 0;
    if (off > 0) BRep_Builder().UpdateVertex(vertex, p.Translated({off, 0, 0}), 1e-7);
  }
  BRepTools::Write(box, (folder / "loose.brep").c_str());

  const Finished run = blossom({"check", folder / "loose.brep", "--json", folder / "loose.json"});

  EXPECT_EQ(run.code, 0);
  const json report = json::parse(testing::text_of(folder / "loose.json"));
  std::size_t edges = 0;
  for (const json& edge : report["edges"]) edges += edge["problems"].size();
  EXPECT_EQ(edges, 6u);
  const auto line = run.out.find("  6 edges (faces 1-6): it misses a vertex, at worst edge ");
  ASSERT_NE(line, std::string::npos) << run.out;
  EXPECT_NE(run.out.find("by 0.005, more than the tolerance 1e-07\n", line), std::string::npos);
  EXPECT_EQ(run.out.find("misses", line + 40), std::string::npos) << run.out;
}

TEST(CheckCommand, FailsOnFindingsIfAsked) {
  const testing::TestFolder folder;
  write_shape(open_box(), folder / "open.brep");
  EXPECT_EQ(blossom({"check", folder / "open.brep", "--fail-on", "findings"}).code, 5);
  write_shape(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), folder / "box.brep");
  EXPECT_EQ(blossom({"check", folder / "box.brep", "--fail-on", "findings"}).code, 0);
}

TEST(CheckCommand, NamesThePartOfAFace) {
  const testing::TestFolder folder;
  testing::write({testing::bowl()}, folder / "bowl.brep");
  BRep_Builder builder;
  TopoDS_Face face = testing::bowl();
  const TopExp_Explorer wire(face, TopAbs_WIRE);
  builder.Add(face, wire.Current().Reversed());  // a second wire on top of the first
  occt::quiet_messages();
  occt::Model model;
  model.add(face, "Bolt");
  occt::write_model(model, folder / "twice.step");
  const Finished run = blossom({"check", folder / "twice.step"});
  EXPECT_NE(run.out.find("face 1 (Bolt): "), std::string::npos) << run.out << run.err;
}

TEST(CheckCommand, RefusesWhatIsNoModel) {
  const testing::TestFolder folder;
  testing::write_text(folder / "words.brep", "no model at all\n");
  const Finished run = blossom({"check", folder / "words.brep"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("is no BREP file"), std::string::npos) << run.err;
  EXPECT_EQ(blossom({"check", folder / "nowhere.step"}).code, 2);
  testing::write({testing::bowl()}, folder / "bowl.brep");
  EXPECT_EQ(blossom({"check", (folder / "bowl.brep").string() + "#2"}).code, 2);
}

}  // namespace
}  // namespace blossom
