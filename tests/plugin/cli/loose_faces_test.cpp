// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of loose faces: commands that need solids sew them, and say so; others leave them.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"
#include "tests/support/endless_edges.h"

namespace blossom::testing {
namespace {

class LooseFaces : public ::testing::Test {
 protected:
  LooseFaces() {
    occt::quiet_messages();
    std::vector<TopoDS_Shape> faces;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
    for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next())
      faces.push_back(BRepBuilderAPI_Copy(it.Current()).Shape());
    write(faces, "box.brep");
    faces.pop_back();
    write(faces, "open.brep");
  }

  void write(const std::vector<TopoDS_Shape>& faces, const std::string& name) {
    occt::Model model;
    model.add(occt::compound_of(faces), "loose");
    occt::write_model(model, path(name));
  }

  std::string path(const std::string& name) const { return (folder / name).string(); }

  nlohmann::json mass_of(const std::string& name, const std::vector<std::string>& options = {}) {
    std::vector<std::string> words{"query", "mass", path(name), "--json", "-"};
    words.insert(words.end(), options.begin(), options.end());
    const Finished ran = blossom(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return nlohmann::json::parse(ran.out);
  }

  TestFolder folder;
};

TEST_F(LooseFaces, HaveTheVolumeOfTheSolidThatTheyClose) {
  const nlohmann::json report = mass_of("box.brep");
  EXPECT_NEAR(report["total"]["volume"], 6000, 1e-6);
  const nlohmann::json& sewn = report["repairs"][0]["sewn"];
  EXPECT_EQ(sewn["loose_faces"], 6);
  EXPECT_EQ(sewn["faces"], 6);
  EXPECT_EQ(sewn["solids"], 1);
  EXPECT_EQ(sewn["open_edges"], 0);
  EXPECT_TRUE(sewn["open_at"].is_null());
}

TEST_F(LooseFaces, AreToldToBeSewn) {
  const Finished ran = blossom({"check", path("box.brep")});
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.err.find("6 loose faces sewn into 1 solid, without gaps"), std::string::npos)
      << ran.err;
  EXPECT_NE(ran.out.find("0 open edges"), std::string::npos) << ran.out;
}

TEST_F(LooseFaces, AreRoundedCutAndWrittenAsASolid) {
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"blend", "fillet", path("box.brep"), "--edges", "all", "--radius", "1"},
           {"trim", path("box.brep"), "--plane", "0,0,5,0,0,1", "--solid", "cut"},
           {"convert", path("box.brep")}}) {
    std::vector<std::string> words = command;
    words.insert(words.end(), {"-o", path("out.step")});
    const Finished ran = blossom(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(occt::read_model(path("out.step")).shape(), TopAbs_SOLID, solids);
    EXPECT_EQ(solids.Extent(), 1) << command[0];
  }
}

TEST_F(LooseFaces, StayLooseWhereFacesAreEnough) {
  const Finished ran = blossom({"intersect", path("box.brep"), path("open.brep#1")});
  EXPECT_EQ(ran.err.find("sewn"), std::string::npos) << ran.err;
  EXPECT_NE(blossom({"info", path("box.brep")}).out.find("0 solids"), std::string::npos);
  EXPECT_NE(
      blossom({"info", path("box.brep"), "--edges"}).out.find("1 solid, 1 shell, 6 faces, 12"),
      std::string::npos);
}

TEST_F(LooseFaces, StayLooseIfThatIsAskedFor) {
  EXPECT_TRUE(mass_of("box.brep", {"--sew-gap", "0"})["total"].is_null());
}

// As Open CASCADE's general fuse has it; --sew-gap asks for a solid.
TEST_F(LooseFaces, ThatAreAClosedShellAreASheetWhereShapesAreCombined) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
  write({TopExp_Explorer(box, TopAbs_SHELL).Current()}, "shell.brep");
  const auto cut = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"trim",        path("shell.brep"), "--plane",
                                   "0,0,5,0,0,1", "--solid",          "cut",
                                   "-o",          path("cut.brep")};
    words.insert(words.end(), options.begin(), options.end());
    const Finished ran = blossom(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.out;
  };
  EXPECT_NE(cut({}).find("1 sheet"), std::string::npos);
  EXPECT_NE(cut({"--sew-gap", "1e-3"}).find("1 solid"), std::string::npos);
  EXPECT_NEAR(mass_of("shell.brep")["total"]["volume"], 6000, 1e-6);
}

TEST_F(LooseFaces, ThatOpenCascadeFailsToSewStayLoose) {
  std::vector<TopoDS_Shape> faces;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
  for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(BRepBuilderAPI_Copy(it.Current()).Shape());
  faces.front() = without_vertices(faces.front());
  write(faces, "damaged.brep");
  const Finished ran = blossom({"check", path("damaged.brep")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("its loose faces stay loose: "), std::string::npos) << ran.err;
}

TEST_F(LooseFaces, ThatDoNotCloseAreToldWithThePlace) {
  const Finished ran = blossom({"query", "mass", path("open.brep")});
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.err.find("5 loose faces close no solid: 4 edges open, the first at ("),
            std::string::npos)
      << ran.err;
}

}  // namespace
}  // namespace blossom::testing
