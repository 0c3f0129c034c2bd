// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom blend fillet`, `blossom blend chamfer` and `blossom info --edges`: what is written,
// reported and refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Cylinder.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/faces/area.h"
#include "adapters/occt/shapes.h"
#include "plugin/reports/text/words.h"
#include "tests/plugin/cli/program.h"

namespace blossom::testing {
namespace {

constexpr double kCut = 1 - std::numbers::pi / 4;

class BlendFillet : public ::testing::Test {
 protected:
  BlendFillet() {
    occt::Model model;
    model.add(BRepPrimAPI_MakeBox(10., 10., 10.).Shape(), "block", {1, 0, 0});
    occt::write_model(model, folder / "box.step");
    occt::Model round;
    round.add(BRepPrimAPI_MakeCylinder(5, 10).Shape(), "pin");
    occt::write_model(round, folder / "pin.step");
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  Finished fillet(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"blend", "fillet"});
    return blossom(arguments);
  }

  TestFolder folder;
};

TEST_F(BlendFillet, WritesAValidSolidWithNamesAndReportsIt) {
  const Finished ran = fillet(
      {path("box.step"), "--edge", "3", "--radius", "2", "-o", path("out.step"), "--json", "-"});

  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json report = nlohmann::json::parse(ran.out);
  EXPECT_EQ(report["schema"], "blossom.blend/1");
  EXPECT_EQ(report["kind"], "fillet");
  EXPECT_EQ(report["edges"], nlohmann::json::parse("[3]"));
  EXPECT_EQ(report["written"], true);
  EXPECT_NEAR(report["volume"]["before"], 1000, 1e-9);
  EXPECT_NEAR(report["volume"]["after"], 1000 - 40 * kCut, 1e-9);
  const occt::Model model = occt::read_model(path("out.step"));
  ASSERT_EQ(model.face_count(), 7);
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
  const std::vector<std::string> names = model.face_names();
  EXPECT_EQ(std::ranges::count(names, "fillet of edge 3"), 1);
  EXPECT_EQ(model.part_name(1), "block");
}

TEST_F(BlendFillet, TakesEdgesByListByPairOfFacesAndAll) {
  const auto edges = [&](const std::vector<std::string>& which) {
    std::vector<std::string> arguments{path("box.step"), "--radius", "1", "--json", "-"};
    arguments.insert(arguments.end(), which.begin(), which.end());
    const Finished ran = fillet(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return nlohmann::json::parse(ran.out)["edges"];
  };
  EXPECT_EQ(edges({"--edge", "1,2"}), nlohmann::json::parse("[1,2]"));
  EXPECT_EQ(edges({"--edge", "1", "--edge", "2"}), nlohmann::json::parse("[1,2]"));
  EXPECT_EQ(edges({"--edges", "1-3,Edge7"}), nlohmann::json::parse("[1,2,3,7]"));
  EXPECT_EQ(edges({"--between", "1,3"}).size(), 1U);
  EXPECT_EQ(edges({"--edges", "all"}).size(), 12U);
  EXPECT_EQ(edges({"--edges", "convex"}).size(), 12U);
}

TEST_F(BlendFillet, RefusesARadiusThatIsTooLargeAndWritesNothing) {
  const Finished ran = fillet({path("box.step"), "--edge", "1", "--radius", "12", "-o",
                               path("out.step"), "--json", path("report.json")});

  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("edge 1: "), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(path("out.step")));
  const nlohmann::json report = nlohmann::json::parse(text_of(path("report.json")));
  EXPECT_EQ(report["written"], false);
  ASSERT_EQ(report["refused"].size(), 1U);
  EXPECT_EQ(report["refused"][0]["edge"], 1);
  EXPECT_EQ(report["refused"][0]["fault"], "leaves face");
  EXPECT_EQ(report["refused"][0]["point"].size(), 3U);
  EXPECT_EQ(ran.out.find("edge 1: "), std::string::npos) << "told twice: " << ran.out;
}

TEST_F(BlendFillet, TellsTheVolumeThatIsThere) {
  const Finished ran = fillet({path("box.step"), "--edge", "3", "--radius", "2"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("\n  edge 3\n  volume 991.416 mm³, 8.58407 less than before\n"),
            std::string::npos)
      << ran.out;
}

TEST_F(BlendFillet, RoundsWhatCanBeRoundedWhenAskedForAPart) {
  const Finished ran = fillet(
      {path("box.step"), "--edge", "1:12,3:1", "--partial", "-o", path("out.step"), "--json", "-"});

  EXPECT_EQ(ran.code, 3) << ran.err;
  const nlohmann::json report = nlohmann::json::parse(ran.out);
  EXPECT_EQ(report["edges"], nlohmann::json({3}));
  EXPECT_EQ(report["refused"].size(), 1U);
  EXPECT_EQ(report["refused"][0]["fault"], "leaves face");
  EXPECT_TRUE(BRepCheck_Analyzer(occt::read_model(path("out.step")).shape()).IsValid());
}

TEST_F(BlendFillet, LeavesOutWhatHasNothingToRoundAndSaysSo) {
  const Finished named = fillet({path("pin.step"), "--edge", "1,2,3", "--radius", "1", "-o",
                                 path("out.step"), "--json", "-"});
  EXPECT_EQ(named.code, 3) << named.err;
  const nlohmann::json report = nlohmann::json::parse(named.out);
  EXPECT_EQ(report["edges"].size(), 2U);
  ASSERT_EQ(report["refused"].size(), 1U);
  EXPECT_EQ(report["refused"][0]["fault"], "nothing to round");
  EXPECT_EQ(report["written"], true);
  const std::string seam = std::to_string(report["refused"][0]["edge"].get<int>());
  const Finished alone =
      fillet({path("pin.step"), "--edge", seam, "--radius", "1", "-o", path("same.step")});
  EXPECT_EQ(alone.code, 3) << alone.err;
  EXPECT_NE(alone.out.find("the part is as it was"), std::string::npos) << alone.out;
  EXPECT_TRUE(std::filesystem::exists(path("same.step")));

  const Finished all = fillet({path("pin.step"), "--edges", "all", "--radius", "1"});
  EXPECT_EQ(all.code, 0) << all.err;
  EXPECT_NE(all.out.find("  nothing to blend at 1 seam edge\n"), std::string::npos) << all.out;
}

// A pin has three edges, and both rims one reason.
TEST_F(BlendFillet, PrintsALineForEachReasonAndAllOfThemIfVerbose) {
  EXPECT_EQ(
      reports::by_kind({"edge 1: leans on edge 9, at (1, -2.5, 1e-05)", "another",
                        "edge 3: leans on edge 4, at (0, 0, 0)",
                        "edge 12: leans on edge 1, at (0, 7, 0)"}),
      (std::vector<std::string>{
          "edge 1: leans on edge 9, at (1, -2.5, 1e-05); likewise edges 3 and 12", "another"}));
  std::vector<std::string> many;
  for (int i = 1; i <= 40; ++i) many.push_back("edge " + std::to_string(i) + ": too tight");
  EXPECT_EQ(reports::by_kind(many),
            (std::vector<std::string>{"edge 1: too tight; likewise edges 2, 3, 4, 5 and 35 more"}));

  std::vector<std::string> command{path("box.step"), "--edges", "1-4",           "--radius", "11",
                                   "--partial",      "--json",  path("all.json")};
  const auto lines = [](const Finished& ran) { return std::ranges::count(ran.out, '\n'); };
  const Finished few = fillet(command);
  command.emplace_back("-v");
  const Finished all = fillet(command);
  EXPECT_LT(lines(few), lines(all)) << few.out << all.out;
  EXPECT_NE(few.out.find("; likewise edge"), std::string::npos) << few.out;
  std::ifstream file(path("all.json"));
  EXPECT_EQ(nlohmann::json::parse(file)["refused"].size(), 4U);
}

TEST_F(BlendFillet, RefusesBadUsage) {
  const std::string box = path("box.step");
  const std::vector<std::vector<std::string>> rows{
      {box, "--radius", "1"},
      {box, "--edge", "1"},
      {box, "--edge", "1", "--radius", "0"},
      {box, "--edge", "1", "--radius", "-2"},
      {box, "--edge", "1", "--radius", "nan"},
      {box, "--edge", "1", "--radius", "inf"},
      {box, "--edge", "1", "--radius", "wide"},
      {box, "--edge", "1", "--radius", "2.."},
      {box, "--edge", "1", "--radius", "..2"},
      {box, "--edge", "1", "--radius", "2..0"},
      {box, "--edge", "1", "--radius", "2..3..4"},
      {box, "--edge", "1", "--radius", "1", "--section", "conic"},
      {box, "--edge", "1", "--radius", "1", "--section", "conic:1"},
      {box, "--edge", "1", "--radius", "1", "--section", "square"},
      {box, "--edge", "1:2,3"},
      {box, "--edge", "1:2", "--edges", "all"},
      {box, "--edge", "1:2", "--edge", "1:3"},
      {box, "--edge", "1:0"},
      {box, "--edge", "1:"},
      {box, "--edge", ":2"},
      {box, "--edge", "1:2:3"},
      {box, "--edge", "1:2", "--radius", "1", "--law", box},
      {box, "--edge", "1", "--radius", "1", "--setback", "0"},
      {box, "--edge", "0", "--radius", "1"},
      {box, "--edge", "13", "--radius", "1"},
      {box, "--edge", "-4", "--radius", "1"},
      {box, "--edge", "x", "--radius", "1"},
      {box, "--edges", "some", "--radius", "1"},
      {box, "--edges", "concave", "--radius", "1"},
      {box, "--between", "1", "--radius", "1"},
      {box, "--between", "1,2", "--radius", "1"},
      {box, "--between", "1,99", "--radius", "1"},
      {box + "#1", "--edge", "1", "--radius", "1"},
      {path("none.step"), "--edge", "1", "--radius", "1"},
      {box, "--edge", "1", "--radius", "1", "-o", box},
      {box, "--edge", "1", "--radius", "1", "-o", path("out.png")},
  };
  for (const auto& row : rows) {
    const Finished ran = fillet(row);
    EXPECT_EQ(ran.code, 2) << row.at(1) << ' ' << row.back() << '\n' << ran.err;
    EXPECT_NE(ran.err.find("blossom: "), std::string::npos);
  }
}

TEST_F(BlendFillet, ChangesItsRadiusAlongAnEdge) {
  const Finished ran = fillet(
      {path("box.step"), "--edge", "3", "--radius", "1..2", "-o", path("out.step"), "--json", "-"});

  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json report = nlohmann::json::parse(ran.out);
  EXPECT_TRUE(report["radius"].is_null());
  EXPECT_EQ(report["law"]["radii"], nlohmann::json({1, 2}));
  // More than the lesser radius takes all along, less than the greater one.
  const double less = 1000 - report["volume"]["after"].get<double>();
  EXPECT_GT(less, 10 * kCut);
  EXPECT_LT(less, 40 * kCut);
  EXPECT_TRUE(BRepCheck_Analyzer(occt::read_model(path("out.step")).shape()).IsValid());
}

TEST_F(BlendFillet, GivesEdgesRadiiOfTheirOwn) {
  const Finished ran = fillet({path("box.step"), "--edge", "1,3:2", "--edge", "7:1..2", "--radius",
                               "1", "-o", path("out.step"), "--json", "-"});

  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json report = nlohmann::json::parse(ran.out);
  EXPECT_EQ(report["radius"], 1);
  ASSERT_EQ(report["radii"].size(), 2U);
  EXPECT_EQ(report["radii"][0], nlohmann::json({{"edge", 3}, {"radius", 2}, {"law", nullptr}}));
  EXPECT_EQ(report["radii"][1]["law"]["radii"], nlohmann::json({1, 2}));
  EXPECT_NEAR(report["volume"]["after"], 1000 - 10 * kCut * (1 + 4 + 7.0 / 3), 0.05);
  EXPECT_TRUE(BRepCheck_Analyzer(occt::read_model(path("out.step")).shape()).IsValid());

  const Finished range = fillet({path("box.step"), "--edge", "1-3:2"});
  EXPECT_NE(range.out.find("fillet of edge 1 by 2, of edge 2 by 2, of edge 3 by 2"),
            std::string::npos)
      << range.out << range.err;

  const Finished all = fillet({path("box.step"), "--edge", "1:1,3:2"});
  EXPECT_EQ(all.code, 0) << all.err;
  EXPECT_NE(all.out.find("fillet of edge 1 by 1, of edge 3 by 2, 2 edges rounded"),
            std::string::npos)
      << all.out;
}

// All twelve edges of the box by radius 1: cylinders, each between two planes across its edge that
// lie so far from the edge's ends.
void expect_strips_end_before_corners(const TopoDS_Shape& made, double setback) {
  int strips = 0;
  for (TopExp_Explorer it(made, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    const BRepAdaptor_Surface surface(face);
    if (surface.GetType() != GeomAbs_Cylinder) continue;
    ++strips;
    EXPECT_NEAR(surface.Cylinder().Radius(), 1, 1e-9);
    EXPECT_NEAR(occt::area(face), std::numbers::pi / 2 * (10 - 2 * setback), 1e-9);
    const gp_Dir along = surface.Cylinder().Axis().Direction();
    for (TopExp_Explorer corner(face, TopAbs_VERTEX); corner.More(); corner.Next()) {
      const gp_Pnt point = BRep_Tool::Pnt(TopoDS::Vertex(corner.Current()));
      const double height = std::abs(along.XYZ().Dot(point.XYZ()));
      EXPECT_NEAR(std::min(height, 10 - height), setback, 1e-9);
    }
  }
  EXPECT_EQ(strips, 12);
}

TEST_F(BlendFillet, SetsCornersBack) {
  const Finished ran = fillet({path("box.step"), "--edges", "all", "--radius", "1", "--setback",
                               "2.5", "-o", path("out.step"), "--json", "-"});

  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(nlohmann::json::parse(ran.out)["setback"], 2.5);
  const TopoDS_Shape made = occt::read_model(path("out.step")).shape();
  EXPECT_TRUE(BRepCheck_Analyzer(made).IsValid());
  expect_strips_end_before_corners(made, 2.5);
}

TEST_F(BlendFillet, TakesConicsForSections) {
  const Finished ran = fillet({path("box.step"), "--edge", "3", "--radius", "2", "--section",
                               "conic:0.5", "-o", path("out.step"), "--json", "-"});

  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json report = nlohmann::json::parse(ran.out);
  EXPECT_EQ(report["rho"], 0.5);
  // A parabola leaves a third of the triangle of its end tangents.
  EXPECT_NEAR(report["volume"]["after"], 1000 - 10 * 2.0 / 3, 1e-6);
}

TEST_F(BlendFillet, ReadsALawFromAFile) {
  const auto rounded = [&](const std::string& law) {
    std::ofstream(path("law.json")) << law;
    return fillet({path("box.step"), "--edge", "3", "--law", path("law.json"), "--json", "-"});
  };
  const Finished ran = rounded(R"({"law": "table", "at": [0, 0.5, 1], "radii": [1, 2, 1]})");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(nlohmann::json::parse(ran.out)["law"]["at"], nlohmann::json({0, 0.5, 1}));
  for (const std::string law :
       {"", "[]", "{", R"({"law": "steep", "radii": [1, 2]})", R"({"law": "smooth", "radii": [1]})",
        R"({"law": "linear"})", R"({"law": "linear", "radii": [1, "2"]})",
        R"({"law": "linear", "radii": [1, -2]})", R"({"law": "table", "at": [0, 1], "radii": [1]})",
        R"({"law": "table", "at": [0.1, 1], "radii": [1, 2]})"}) {
    const Finished refused = rounded(law);
    EXPECT_EQ(refused.code, 2) << law << '\n' << refused.err;
    EXPECT_NE(refused.err.find("--law " + path("law.json") + ": "), std::string::npos)
        << law << '\n'
        << refused.err;
  }
}

TEST_F(BlendFillet, TakesSectionsWithTheCurvaturesOfFaces) {
  const Finished ran = fillet({path("box.step"), "--edge", "3", "--radius", "2", "--section", "g2",
                               "-o", path("out.step"), "--json", "-"});

  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(nlohmann::json::parse(ran.out)["section"], "g2");
  EXPECT_TRUE(BRepCheck_Analyzer(occt::read_model(path("out.step")).shape()).IsValid());
}

TEST_F(BlendFillet, ChamferCutsAnEdgeOff) {
  const double angle = std::numbers::pi / 6;
  const std::vector<std::pair<std::string, double>> rows{
      {"2", 2}, {"2,1", 1}, {"2:30", 2 * std::tan(angle)}};
  for (const auto& [distance, area] : rows) {
    const Finished ran = blossom({"blend", "chamfer", path("box.step"), "--edge", "3", "--distance",
                                  distance, "-o", path("out.step"), "--json", "-"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const nlohmann::json report = nlohmann::json::parse(ran.out);
    EXPECT_EQ(report["kind"], "chamfer");
    EXPECT_EQ(report["distance"], 2);
    EXPECT_NEAR(report["volume"]["after"], 1000 - 10 * area, 1e-9) << distance;
    const occt::Model model = occt::read_model(path("out.step"));
    EXPECT_EQ(std::ranges::count(model.face_names(), "chamfer of edge 3"), 1);
  }
}

TEST_F(BlendFillet, ChamferRefusesBadDistances) {
  for (const std::string distance : {"0", "-1", "x", "1,", ",1", "1,2,3", "1:180", "1:0", "1:"}) {
    const Finished ran =
        blossom({"blend", "chamfer", path("box.step"), "--edge", "1", "--distance", distance});
    EXPECT_EQ(ran.code, 2) << distance << '\n' << ran.err;
  }
}

TEST_F(BlendFillet, InfoListsTheEdgesThatItTakes) {
  const Finished ran = blossom({"info", path("pin.step"), "--edges", "--json", "-"});

  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json edges = nlohmann::json::parse(ran.out)["edges"];
  ASSERT_EQ(edges.size(), 3U);
  int convex = 0;
  for (const nlohmann::json& edge : edges) {
    if (edge["kind"] != "convex") continue;
    ++convex;
    EXPECT_EQ(edge["faces"].size(), 2U);
    EXPECT_NEAR(edge["length"], 10 * std::numbers::pi, 1e-9);
    EXPECT_NEAR(edge["angle"], std::numbers::pi / 2, 1e-9);
  }
  EXPECT_EQ(convex, 2);
  const Finished text = blossom({"info", path("pin.step"), "--edges"});
  EXPECT_NE(text.out.find("convex"), std::string::npos);
  EXPECT_NE(text.out.find("seam"), std::string::npos);
}

}  // namespace
}  // namespace blossom::testing
