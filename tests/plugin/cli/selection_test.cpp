// SPDX-License-Identifier: LGPL-2.1-or-later
// Inputs that name parts, solids, faces and edges of a model, as a user writes them.

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

void write_unnamed(const TopoDS_Shape& shape, const std::filesystem::path& file) {
  occt::Model model;
  model.add(shape, "");
  occt::write_model(model, file);
}

class Selectors : public ::testing::Test {
 protected:
  // A plate of six faces, a shaft of three that goes through it, and a lid above both.
  void SetUp() override {
    occt::Model model;
    model.add(BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, 0), 10, 10, 2).Shape(), "Plate");
    model.add(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -4), gp_Dir(0, 0, 1)), 1, 10).Shape(),
              "Shaft");
    model.add(BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, 9), 10, 10, 1).Shape(), "Lid");
    occt::write_model(model, folder_ / "rig.step");
    file_ = folder_ / "rig.step";
  }

  json report(std::vector<std::string> words) {
    words.insert(words.end(), {"--json", "-"});
    const Finished run = blossom(words);
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  }

  std::vector<int> faces_of(const std::string& selector) {
    std::vector<int> numbers;
    const json found = report({"info", file_ + "#" + selector});
    for (const json& face : found["faces"]) numbers.push_back(face["number"]);
    return numbers;
  }

  testing::TestFolder folder_;
  std::string file_;
};

TEST_F(Selectors, NamePartsSolidsAndFacesOfParts) {
  EXPECT_EQ(faces_of("Shaft"), (std::vector{7, 8, 9}));
  EXPECT_EQ(faces_of("solid:2"), (std::vector{7, 8, 9}));
  EXPECT_EQ(faces_of("Shaft/Face3"), (std::vector{9}));
  EXPECT_EQ(faces_of("face:4"), (std::vector{4}));
  EXPECT_EQ(faces_of("Lid/face1,2,Shaft/Solid1"), (std::vector{2, 7, 8, 9, 10}));
}

TEST_F(Selectors, NameEntitiesAsOtherProgramsDo) {
  EXPECT_EQ(faces_of("Face3"), (std::vector{3}));
  EXPECT_EQ(faces_of("face12,Shaft/Face3,Solid1"), (std::vector{1, 2, 3, 4, 5, 6, 9, 12}));
  const auto nearest = [&](const char* edge) {
    return report({"query", "point", file_ + "#" + edge, "--at", "0,0,0"})["distance"];
  };
  EXPECT_EQ(nearest("Edge2"), nearest("edge:2"));
  occt::Model named;
  named.add(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), "A");
  named.add(BRepPrimAPI_MakeBox(gp_Pnt(2, 0, 0), 1, 1, 1).Shape(), "Face3");
  occt::write_model(named, folder_ / "named.step");
  file_ = folder_ / "named.step";
  EXPECT_EQ(faces_of("Face3").front(), 7);  // what is called so goes first
  EXPECT_EQ(faces_of("face:3"), (std::vector{3}));
}

TEST_F(Selectors, ServeModelsWithoutNames) {
  write_unnamed(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), folder_ / "unnamed.step");
  file_ = folder_ / "unnamed.step";
  EXPECT_EQ(faces_of("Face3"), (std::vector{3}));
  EXPECT_EQ(faces_of("Solid1").size(), 6u);
  const Finished missing = blossom({"info", file_ + "#Face9"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_NE(missing.err.find("there is no face 9 in it, it has 6 faces"), std::string::npos)
      << missing.err;
}

TEST_F(Selectors, NameEdgesAndFacesOfBlends) {
  const std::string box = folder_ / "box.step";
  write_unnamed(BRepPrimAPI_MakeBox(9, 9, 9).Shape(), box);
  const auto edges_of = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"blend", "fillet", box});
    words.insert(words.end(), {"--radius", "1"});
    return report(words)["edges"].dump();
  };
  EXPECT_EQ(edges_of({"--edge", "Edge2,edge3"}), edges_of({"--edge", "2,3"}));
  EXPECT_EQ(edges_of({"--between", "Face1,Face3"}), edges_of({"--between", "1,3"}));
  EXPECT_EQ(blossom({"blend", "fillet", box, "--edge", "Edge2:1"}).code, 0);
  EXPECT_EQ(blossom({"blend", "strip", box + "#Face1", box + "#Face2", "--edge-a", "Edge1"}).code,
            blossom({"blend", "strip", box + "#1", box + "#2", "--edge-a", "1"}).code);
}

TEST_F(Selectors, NamePartsWithCommasAndTheWholeModel) {
  occt::Model model;
  model.add_assembly({{"Gear, big", BRepPrimAPI_MakeBox(1, 1, 1).Shape()},
                      {"Gear, 2", BRepPrimAPI_MakeBox(gp_Pnt(2, 0, 0), 1, 1, 1).Shape()},
                      {"Gear", BRepPrimAPI_MakeBox(gp_Pnt(4, 0, 0), 1, 1, 1).Shape()}},
                     "Box");
  occt::write_model(model, folder_ / "gears.step");
  file_ = folder_ / "gears.step";
  EXPECT_EQ(faces_of("Gear, big").front(), 1);
  EXPECT_EQ(faces_of("Gear, 2").front(), 7);
  EXPECT_EQ(faces_of("Gear, big/Face2,Gear,7"), (std::vector{2, 7, 13, 14, 15, 16, 17, 18}));
  EXPECT_EQ(faces_of("Box/Gear"), (std::vector{13, 14, 15, 16, 17, 18}));
  const Finished none = blossom({"info", file_ + "#Pulley"});
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("there are 'Gear, big', 'Gear, 2' and 'Gear'"), std::string::npos)
      << none.err;
  EXPECT_EQ(blossom({"info", file_ + "#Gear, none"}).code, 2);
  EXPECT_EQ(blossom({"info", file_ + "#1,Gear,x-3"}).code, 2);
}

TEST_F(Selectors, NamePartsOfWhichEdgesAreRounded) {
  const json edges = report({"info", file_ + "#Lid", "--edges"})["edges"];
  ASSERT_EQ(edges.size(), 12u);
  const int first = edges[0]["number"];
  EXPECT_GT(first, 12);
  const std::string out = folder_ / "made.step", number = std::to_string(first);
  const auto made = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all{"blend", "fillet", file_ + "#Lid", "-o", out};
    all.insert(all.end(), words.begin(), words.end());
    return blossom(all);
  };
  const Finished all = made({"--edges", "convex", "--radius", "0.2"});
  EXPECT_EQ(all.code, 0) << all.err;
  EXPECT_NE(all.out.find("2 other parts are written as they were"), std::string::npos) << all.out;
  EXPECT_NE(all.out.find("  volume of all parts "), std::string::npos) << all.out;
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(occt::read_model(out).shape(), TopAbs_SOLID, solids);
  EXPECT_EQ(solids.Extent(), 3);
  EXPECT_EQ(report({"info", out})["counts"]["faces"], 6 + 3 + 26);
  EXPECT_EQ(made({"--edges", number, "--radius", "0.2"}).code, 0);
  EXPECT_EQ(made({"--edge", "Lid/Edge1:0.2"}).code, 0);
  const Finished beside = made({"--edges", "1", "--radius", "0.2"});
  EXPECT_EQ(beside.code, 2);
  EXPECT_NE(beside.err.find("edge 1 is of another part"), std::string::npos) << beside.err;
  const Finished nowhere = made({"--edges", "999", "--radius", "0.2"});
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_NE(nowhere.err.find("there is no edge 999, only 1 to"), std::string::npos) << nowhere.err;
  const Finished face =
      blossom({"blend", "chamfer", file_ + "#1", "--edges", "1", "--distance", "1"});
  EXPECT_NE(face.err.find("chamfers are made in whole models and parts"), std::string::npos)
      << face.err;
}

TEST_F(Selectors, SayWhatBecomesOfOtherParts) {
  const Finished left = blossom({"convert", file_ + "#Lid", "-o", folder_ / "lid.step"});
  EXPECT_NE(left.out.find("2 other parts are left out"), std::string::npos) << left.out;
  const Finished mesh = blossom({"convert", file_ + "#Lid,Shaft", "-o", folder_ / "lid.stl"});
  EXPECT_NE(mesh.out.find("1 other part is left out"), std::string::npos) << mesh.out;
  const Finished kept = blossom({"trim", file_ + "#Lid", "--plane", "0,0,9.5,0,0,1", "--keep",
                                 "below", "-o", folder_ / "kept.step"});
  EXPECT_NE(kept.out.find("2 other parts are written as they were"), std::string::npos) << kept.out;
  // Counted before faces have other numbers.
  const Finished base = blossom({"trim", file_ + "#Plate", "--plane", "0,0,0.5,0,0,1", "--keep",
                                 "above", "-o", folder_ / "base.step"});
  EXPECT_NE(base.out.find("2 other parts are written"), std::string::npos) << base.out;
  const Finished two = blossom({"blend", "fillet", file_ + "#Plate,Shaft", "--edges", "all",
                                "--radius", "0.1", "-o", folder_ / "two.step"});
  EXPECT_NE(two.out.find("1 other part is written as it was"), std::string::npos) << two.out;
  const Finished all = blossom(
      {"blend", "fillet", file_, "--edges", "all", "--radius", "0.1", "-o", folder_ / "all.step"});
  EXPECT_EQ(all.out.find("other part"), std::string::npos) << all.out;
  const Finished cut = blossom({"trim", file_ + "#Lid", "--plane", "0,0,9.5,0,0,1", "--solid",
                                "cut", "-o", folder_ / "cut.step"});
  EXPECT_NE(cut.out.find("2 other parts are left out"), std::string::npos) << cut.out;
  // A tool of the same file is not left out.
  const Finished fuse = blossom(
      {"trim", file_ + "#Lid", file_ + "#Shaft", "--solid", "fuse", "-o", folder_ / "fuse.step"});
  EXPECT_NE(fuse.out.find("1 other part is left out"), std::string::npos) << fuse.out << fuse.err;
}

TEST_F(Selectors, NameSolidsWithAnInside) {
  const json found = report({"query", "distance", file_ + "#Shaft", file_ + "#Lid"});
  EXPECT_NEAR(found["distance"][1], 3, 1e-9);
  EXPECT_EQ(found["solids_a"], 1);
  const json meets = report({"query", "does-intersect", file_ + "#Shaft", file_ + "#solid:1"});
  EXPECT_EQ(meets["answer"], "yes");
  EXPECT_EQ(meets["pairs"][0]["a"]["solid"], 2);
  EXPECT_EQ(meets["pairs"][0]["b"]["solid"], 1);
}

TEST_F(Selectors, AreToldOfHitsAndPairs) {
  const Finished ray =
      blossom({"query", "ray", file_, "--from", "4,4,20", "--direction", "0,0,-1"});
  EXPECT_NE(ray.out.find(" of Lid\n"), std::string::npos) << ray.out;
  EXPECT_NE(ray.out.find(" of Plate\n"), std::string::npos) << ray.out;
  write_unnamed(BRepPrimAPI_MakeBox(gp_Pnt(-9, -9, 1), 18, 18, 0.5).Shape(), folder_ / "cut.brep");
  const Finished pair = blossom({"intersect", folder_ / "cut.brep", file_ + "#Plate"});
  EXPECT_NE(pair.out.find("  face 5 x Plate, face "), std::string::npos) << pair.out;
}

TEST_F(Selectors, NameEdges) {
  const json whole = report({"info", file_, "--edges"});
  const json middle = whole["edges"][0]["middle"];
  // The first edge stands upright.
  const auto beside = [&](int k, double by) {
    return std::to_string(middle[static_cast<std::size_t>(k)].get<double>() + by);
  };
  const std::string at = beside(0, -3) + "," + beside(1, -4) + "," + beside(2, 0);
  const json found = report({"query", "point", file_ + "#edge:1", "--at", at});
  EXPECT_NEAR(found["distance"][1], 5, 1e-6);
  EXPECT_EQ(found["nearest"]["on"]["kind"], "edge");
  const Finished faces = blossom({"check", file_ + "#edge:1"});
  EXPECT_EQ(faces.code, 2);
  EXPECT_NE(faces.err.find("an edge is named where faces are wanted"), std::string::npos);
}

TEST_F(Selectors, CombineTwoSolidsOfOneFile) {
  const std::string out = folder_ / "made.step";
  const json made =
      report({"trim", file_ + "#solid:1", file_ + "#Shaft", "--solid", "fuse", "-o", out});
  const double plate = 200, shaft = 10 * 3.141592653589793, common = shaft / 5;
  EXPECT_NEAR(made["total"]["result"], plate + shaft - common, 1e-6);
  const occt::Model model = occt::read_model(out);
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(model.shape(), TopAbs_SOLID, solids);
  EXPECT_EQ(solids.Extent(), 1);  // the lid is not in it
  EXPECT_EQ(model.part_name(1), "Plate");
}

TEST_F(Selectors, CutFacesByASolid) {
  const json made = report({"trim", file_ + "#Plate/Face5", file_ + "#Shaft", "--keep", "outside"});
  EXPECT_EQ(made["pieces"].size(), 2u);
}

struct Refusal {
  const char* selector;
  const char* words;
};

class BadSelectors : public Selectors, public ::testing::WithParamInterface<Refusal> {};

TEST_P(BadSelectors, AreRefusedWithTheNearestNames) {
  const Finished run = blossom({"info", file_ + "#" + GetParam().selector});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find(GetParam().words), std::string::npos) << run.err;
}

INSTANTIATE_TEST_SUITE_P(
    Words, BadSelectors,
    ::testing::Values(Refusal{"Shft",
                              "there is no part and no face 'Shft' in it; did you mean 'Shaft'?"},
                      Refusal{"Turbine", "there are 'Plate', 'Shaft' and 'Lid'"},
                      Refusal{"Shaft/Face9", "there is no face 9 in 'Shaft', it has 3 faces"},
                      Refusal{"solid:4", "there is no solid 4 in it, it has 3 solids"},
                      Refusal{"edge:400", "there is no edge 400 in it"},
                      Refusal{"solid:x", "'solid:x' has no number"}));

TEST_F(Selectors, AreFoundInATree) {
  occt::Model model;
  model.add_assembly({{"left", BRepPrimAPI_MakeBox(1, 1, 1).Shape()},
                      {"right", BRepPrimAPI_MakeBox(gp_Pnt(2, 0, 0), 1, 1, 1).Shape()}},
                     "Frame");
  const std::string file = folder_ / "frame.step";
  occt::write_model(model, file);
  const Finished run = blossom({"info", file, "--tree"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("    Frame\n      left: solid 1, faces 1-6\n"), std::string::npos)
      << run.out;
  const json tree = report({"info", file, "--tree"})["tree"];
  ASSERT_EQ(tree.size(), 1u);
  EXPECT_EQ(tree[0]["product"], "Frame");
  EXPECT_EQ(tree[0]["parts"][1]["name"], "right");
  EXPECT_EQ(tree[0]["parts"][1]["faces"], (json{7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(report({"info", file + "#right"})["faces"].size(), 6u);
  EXPECT_EQ(report({"info", file + "#Frame"})["faces"].size(), 12u);
}

TEST_F(Selectors, AreBesideParameterRanges) {
  const json face = report({"info", file_ + "#Shaft/Face1"})["faces"][0];
  ASSERT_EQ(face["surface"], "cylinder");
  EXPECT_NEAR(face["parameters"][0][1].get<double>() - face["parameters"][0][0].get<double>(),
              2 * 3.141592653589793, 1e-9);
  EXPECT_NEAR(face["parameters"][1][1].get<double>() - face["parameters"][1][0].get<double>(), 10,
              1e-9);
  EXPECT_NE(blossom({"info", file_ + "#Shaft/Face1", "-v"}).out.find("        u 0 to 6.28319, v "),
            std::string::npos);
}

}  // namespace
}  // namespace blossom
