// SPDX-License-Identifier: LGPL-2.1-or-later
// --reproduce: the inputs of a command that was stopped, without what it does not take.

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using testing::blossom;
using testing::Finished;

// A prism over a quadrilateral of which two sides cross at (5, 5).
TopoDS_Shape crossed_prism() {
  BRepBuilderAPI_MakePolygon border(gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(0, 10, 0),
                                    gp_Pnt(10, 10, 0), true);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(border.Wire()), gp_Vec(0, 0, 10)).Shape();
}

TopoDS_Shape pillar_at(double x) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, 4, -1), gp_Pnt(x + 2, 7, 19)).Shape();
}

void write_solids(const std::vector<TopoDS_Shape>& shapes, const std::filesystem::path& file) {
  occt::quiet_messages();
  occt::Model model;
  for (const TopoDS_Shape& shape : shapes) model.add(shape, "part");
  occt::write_model(model, file);
}

// Runs `repeat` in the folder.
Finished run_again(const std::filesystem::path& folder) {
  const std::filesystem::path err = folder / "err";
  const std::string program = std::filesystem::path(BLOSSOM_PROGRAM).parent_path();
  const std::string command = "PATH='" + program + "':$PATH sh '" + (folder / "repeat").string() +
                              "' >/dev/null 2>'" + err.string() + "'";
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), {}, testing::text_of(err)};
}

class Reproduction : public ::testing::Test {
 protected:
  Reproduction() {
    // The bowl meets one of the lids; with a budget of one pair of cells that is left open.
    testing::write({testing::lid(8), testing::lid(9), testing::bowl(), testing::lid(7)}, a);
    testing::write({testing::lid(-4), testing::lid(0.25), testing::lid(-5)}, b);
  }
  testing::TestFolder folder;
  const std::filesystem::path a = folder / "a's parts.brep", b = folder / "b.brep";
  const std::filesystem::path case_folder = folder / "case";
};

TEST_F(Reproduction, OfAStoppedCommandHasTheFacesThatItTakes) {
  const Finished run = blossom({"intersect", a, b, "--budget", "1", "-q", "--json",
                                folder / "out.json", "--reproduce", case_folder});
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(run.err, "blossom: " + (case_folder / "repeat").string() + " does it again\n");
  for (const char* name : {"input1.brep", "input2.brep"}) {
    const Finished info = blossom({"info", case_folder / name});
    EXPECT_NE(info.out.find(" 1 face,"), std::string::npos) << info.out;
  }
  EXPECT_EQ(run_again(case_folder).code, 4);
}

// With fewer faces the boolean would be refused, too, but for another reason.
TEST_F(Reproduction, OfARefusedBooleanHasTheSolidsOfThatRefusal) {
  write_solids({pillar_at(20), pillar_at(30), crossed_prism(), pillar_at(40), pillar_at(50)}, a);
  write_solids({pillar_at(70), pillar_at(4), pillar_at(80)}, b);
  const Finished run = blossom({"trim", a, b, "--solid", "cut", "-o", folder / "out.brep", "-q",
                                "--reproduce", case_folder});
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find(": the part meets itself: "), std::string::npos) << run.err;
  for (const char* name : {"input1.brep", "input2.brep"}) {
    const Finished info = blossom({"info", case_folder / name});
    EXPECT_NE(info.out.find(" 1 solid, 1 shell, 6 faces,"), std::string::npos) << info.out;
  }
  const Finished again = run_again(case_folder);
  EXPECT_EQ(again.code, 1);
  EXPECT_NE(again.err.find(": the part meets itself: "), std::string::npos) << again.err;
}

TEST_F(Reproduction, OfACommandThatIsDoneIsNotWritten) {
  EXPECT_EQ(blossom({"intersect", a, b, "-q", "--reproduce", case_folder}).code, 0);
  EXPECT_FALSE(std::filesystem::exists(case_folder));
}

TEST_F(Reproduction, OfAFailedWriteNeedsTheOutputAndKeepsIt) {
  const Finished run = blossom({"trim", a.string() + "#3", b.string() + "#1", "--keep", "7", "-o",
                                "/proc/out.step", "--reproduce", case_folder});
  EXPECT_EQ(run.code, 1) << run.err;
  const std::string repeat = testing::text_of(case_folder / "repeat");
  EXPECT_NE(repeat.find("'/proc/out.step'"), std::string::npos);
  EXPECT_EQ(repeat.find("--reproduce"), std::string::npos);
}

TEST_F(Reproduction, OfFilesThatAreNoModelsTakesThemAsTheyAre) {
  const std::filesystem::path mesh = folder / "bowl.stl";
  testing::write({testing::bowl()}, folder / "bowl.brep");
  ASSERT_EQ(blossom({"convert", folder / "bowl.brep", "-o", mesh, "-q"}).code, 0);
  const Finished run =
      blossom({"convert", mesh, "-o", "/proc/out.ply", "--reproduce", case_folder});
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_TRUE(run.err.ends_with("/repeat does it again\n")) << run.err;
  EXPECT_EQ(testing::text_of(case_folder / "input1.stl"), testing::text_of(mesh));
}

// A command that cannot go without its output writes it in the folder: what is there under that
// name elsewhere is no input, and stays.
TEST_F(Reproduction, OfACommandThatHasToWriteWritesInItsFolder) {
  const std::filesystem::path mesh = folder / "mesh.stl", bowl = folder / "bowl.brep";
  testing::write({testing::bowl()}, bowl);
  testing::write_text(mesh, "older");
  const Finished run = blossom({"convert", bowl, "-o", mesh, "--deviation", "1e-9", "--time-limit",
                                "0.3", "--log", folder / "log.jsonl", "--reproduce", case_folder});
  ASSERT_EQ(run.code, 4) << run.err;
  EXPECT_EQ(testing::text_of(mesh), "older");
  const std::string repeat = testing::text_of(case_folder / "repeat");
  EXPECT_TRUE(
      repeat.ends_with(" 'convert' 'input1.brep' '-o' 'output1.stl' '--deviation' '1e-9' "
                       "'--time-limit' '0.3'\n"))
      << repeat;
  const std::filesystem::directory_iterator files(case_folder);
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

}  // namespace
}  // namespace blossom
