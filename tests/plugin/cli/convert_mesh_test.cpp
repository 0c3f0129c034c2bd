// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom convert` to triangles: what is promised is in the report, and the files hold it.

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pln.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom::testing {
namespace {

class ConvertMesh : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder / name).string(); }

  void write(const TopoDS_Shape& shape, const std::string& name) {
    occt::quiet_messages();
    occt::Model model;
    model.add(shape, "part", {0.25, 0.5, 0.75});
    occt::write_model(model, path(name));
  }

  Finished run(const std::string& from, const std::string& to, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"convert", path(from), "-o", path(to)});
    return blossom(more);
  }

  nlohmann::json report(const std::string& from, const std::string& to,
                        std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--json", "-"});
    const Finished ran = run(from, to, more);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.code == 0 ? nlohmann::json::parse(ran.out) : nlohmann::json();
  }

  TestFolder folder;
};

// Of a binary STL.
double stl_volume(const std::string& bytes, std::uint32_t& facets) {
  std::memcpy(&facets, bytes.data() + 80, sizeof facets);
  double sum = 0;
  for (std::uint32_t k = 0; k < facets; ++k) {
    float p[12];
    std::memcpy(p, bytes.data() + 84 + 50 * static_cast<std::size_t>(k), sizeof p);
    const float *a = p + 3, *b = p + 6, *c = p + 9;
    sum += (double(a[0]) * (double(b[1]) * c[2] - double(b[2]) * c[1]) +
            double(a[1]) * (double(b[2]) * c[0] - double(b[0]) * c[2]) +
            double(a[2]) * (double(b[0]) * c[1] - double(b[1]) * c[0])) /
           6;
  }
  return sum;
}

// Rounding to single precision moves points of this ball by up to 1e-5.
TEST_F(ConvertMesh, KeepsTheDeviationInFilesOfSinglePrecision) {
  write(BRepPrimAPI_MakeSphere(gp_Pnt(90, 90, 90), 10), "a.step");

  const nlohmann::json made = report("a.step", "a.stl", {"--deviation", "0.002"});

  EXPECT_EQ(made["deviation"], 0.002);
  EXPECT_LE(made["distance"].get<double>(), 0.002);
  EXPECT_GT(made["distance"].get<double>(), 0.001);
}

TEST_F(ConvertMesh, WritesABinaryStlWithinTheDeviation) {
  write(BRepPrimAPI_MakeCylinder(10, 20), "a.step");

  const nlohmann::json made = report("a.step", "a.stl", {"--deviation", "0.01"});

  EXPECT_EQ(made["schema"], "blossom.mesh/1");
  EXPECT_EQ(made["closed"], true);
  if (kHasCgal) {
    EXPECT_EQ(made["crossings"], 0);
  }
  EXPECT_LE(made["distance"].get<double>(), 0.0101);
  const std::string bytes = text_of(path("a.stl"));
  std::uint32_t facets = 0;
  const double volume = stl_volume(bytes, facets);
  EXPECT_EQ(facets, made["triangles"]);
  EXPECT_EQ(bytes.size(), 84 + 50 * std::size_t{facets});
  const double exact = std::numbers::pi * 100 * 20;
  EXPECT_LT(volume, exact);
  EXPECT_GT(volume, exact - 0.0101 * 2 * std::numbers::pi * 10 * 30);
}

TEST_F(ConvertMesh, WritesAllFormatsAndSaysHowNearTheyAre) {
  write(BRepPrimAPI_MakeSphere(5), "ball.brep");
  for (const char* ending : {"stl", "ply", "obj", "off", "glb"}) {
    const std::string name = std::string("ball.") + ending;
    const Finished ran = run("ball.brep", name, {"--deviation", "0.1"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ran.out.find("of the faces, proven"), std::string::npos) << ran.out;
    EXPECT_GT(text_of(path(name)).size(), 1000u) << ending;
  }
  EXPECT_EQ(text_of(path("ball.glb")).substr(0, 4), "glTF");
}

TEST_F(ConvertMesh, NamesTheGroupsOfAnObjAsInputs) {
  write(BRepPrimAPI_MakeCylinder(3, 5), "rod.step");
  const nlohmann::json made = report("rod.step", "rod.obj", {"--deviation", "0.1"});
  EXPECT_EQ(made["rounding"], 0);
  std::istringstream lines(text_of(path("rod.obj")));
  std::vector<std::string> groups;
  std::size_t triangles = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("g ")) groups.push_back(line.substr(2));
    if (line.starts_with("f ")) ++triangles;
  }
  EXPECT_EQ(groups, (std::vector<std::string>{"part/Face1", "part/Face2", "part/Face3"}));
  EXPECT_EQ(triangles, made["triangles"]);
  const Finished named = blossom({"info", path("rod.step") + "#" + groups[1], "--json", "-"});
  EXPECT_EQ(nlohmann::json::parse(named.out)["faces"].size(), 1u) << named.err;
}

TEST_F(ConvertMesh, WritesASolidForEachFaceInStlAsText) {
  write(BRepPrimAPI_MakeCylinder(3, 5), "rod.step");
  const nlohmann::json made = report("rod.step", "rod.stl", {"--deviation", "0.1", "--text"});
  EXPECT_EQ(made["rounding"], 0);
  std::istringstream lines(text_of(path("rod.stl")));
  std::vector<std::string> begun, ended;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("solid ")) begun.push_back(line.substr(6));
    if (line.starts_with("endsolid ")) ended.push_back(line.substr(9));
  }
  EXPECT_EQ(begun, (std::vector<std::string>{"part/Face1", "part/Face2", "part/Face3"}));
  EXPECT_EQ(ended, begun);
  const Finished ran = blossom({"info", path("rod.stl"), "--json", "-"});
  const nlohmann::json read = nlohmann::json::parse(ran.out);
  EXPECT_EQ(read["triangles"], made["triangles"]);
  EXPECT_EQ(read["points"], made["points"]);
  EXPECT_EQ(read["closed"], true);
}

TEST_F(ConvertMesh, ReadsAnObjAsItWasWritten) {
  write(BRepPrimAPI_MakeSphere(5), "ball.brep");
  const nlohmann::json made = report("ball.brep", "ball.obj");
  const Finished ran = blossom({"info", path("ball.obj"), "--json", "-"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(nlohmann::json::parse(ran.out)["triangles"], made["triangles"]);
  EXPECT_EQ(nlohmann::json::parse(ran.out)["closed"], true);
}

TEST_F(ConvertMesh, KeepsNamesAndColoursInGlb) {
  write(BRepPrimAPI_MakeBox(1, 2, 3), "box.step");
  EXPECT_EQ(run("box.step", "box.glb").code, 0);
  const std::string bytes = text_of(path("box.glb"));
  EXPECT_NE(bytes.find("\"part\""), std::string::npos);
  EXPECT_NE(bytes.find("baseColorFactor"), std::string::npos);
}

TEST_F(ConvertMesh, TakesFinerOptionsByTheirWord) {
  write(BRepPrimAPI_MakeBox(1, 1, 1), "box.brep");
  EXPECT_EQ(report("box.brep", "a.ply")["triangles"], 12);
  EXPECT_GT(report("box.brep", "b.ply", {"--edge-length", "0.1"})["triangles"], 1000);
  write(BRepPrimAPI_MakeCylinder(1, 1), "rod.brep");
  EXPECT_LT(report("rod.brep", "c.ply", {"--deviation", "9", "--angle", "115"})["triangles"],
            report("rod.brep", "d.ply", {"--deviation", "9", "--angle", "11.5"})["triangles"]);
}

TEST_F(ConvertMesh, NamesOpenEdgesOfSingleFaces) {
  write(BRepPrimAPI_MakeBox(1, 1, 1), "box.brep");
  const Finished ran = blossom({"convert", path("box.brep") + "#1,2", "-o", path("open.stl")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("it is open at"), std::string::npos) << ran.out;
}

TEST_F(ConvertMesh, SaysWhichFacesCross) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(2, 2, 2).Shape());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 1), gp_Pnt(3, 3, 3)).Shape());
  write(both, "two.brep");
  const nlohmann::json made = report("two.brep", "two.stl");
  EXPECT_GT(made["crossings"], 0);
  EXPECT_EQ(made["crossing_faces"].size(), 6u);
  EXPECT_EQ(made["crossings_between_parts"], made["crossings"]);
  const std::string told = run("two.brep", "again.stl").out;
  EXPECT_NE(told.find("of triangles of different parts cross"), std::string::npos) << told;
  EXPECT_EQ(told.find("of triangles cross, of faces"), std::string::npos) << told;

  // A band that goes through itself is of one part.
  TopoDS_Compound crossed;
  builder.MakeCompound(crossed);
  builder.Add(crossed, BRepBuilderAPI_MakeFace(gp_Pln(), 0, 2, 0, 2).Face());
  builder.Add(crossed, BRepBuilderAPI_MakeFace(gp_Pln({1, 1, 0}, {1, 0, 0}), -1, 1, -1, 1).Face());
  write(crossed, "cross.brep");
  EXPECT_EQ(report("cross.brep", "cross.stl")["crossings_between_parts"], 0);
  EXPECT_NE(run("cross.brep", "again.stl").out.find("of triangles cross, of faces 1 and 2"),
            std::string::npos);
}

// A hollow ball, whose wall is thinner than the deviation: facets of it cross.
TEST_F(ConvertMesh, MeshesFacesFinerWhoseTrianglesWouldCross) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  TopoDS_Solid hollow;
  const BRep_Builder builder;
  builder.MakeSolid(hollow);
  const auto add = [&](double radius, const gp_Dir& axis, bool reversed) {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Ax2(gp::Origin(), axis), radius).Shape();
    const TopoDS_Shape shell = TopExp_Explorer(ball, TopAbs_SHELL).Current();
    builder.Add(hollow, reversed ? shell.Reversed() : shell);
  };
  add(10, gp::DZ(), false);
  add(9.5, gp_Dir(0.3, -0.2, 1), true);
  write(hollow, "hollow.brep");
  const nlohmann::json made = report("hollow.brep", "hollow.ply", {"--deviation", "1"});
  EXPECT_EQ(made["crossings"], 0);
  EXPECT_EQ(made["finer"], (std::vector<int>{1, 2}));
  EXPECT_LE(made["distance"], 0.5);
  const std::string told = run("hollow.brep", "again.ply", {"--deviation", "1"}).out;
  EXPECT_NE(told.find("2 faces meshed finer, as triangles crossed or turned over: 1, 2"),
            std::string::npos)
      << told;
  EXPECT_EQ(report("hollow.brep", "hollow.ply", {"--deviation", "0.1"})["finer"].size(), 0u);
}

TEST_F(ConvertMesh, SaysThatSomeFilesAreWrittenOnly) {
  write(BRepPrimAPI_MakeBox(1, 1, 1), "box.brep");
  for (const char* name : {"a.3mf", "a.glb"}) {
    ASSERT_EQ(run("box.brep", name).code, 0);
    const Finished read = blossom({"info", path(name)});
    EXPECT_EQ(read.code, 2);
    EXPECT_NE(read.err.find(".3mf and .glb are written only"), std::string::npos) << read.err;
  }
}

TEST_F(ConvertMesh, RefusesFormsOfSurfaces) {
  write(BRepPrimAPI_MakeBox(1, 1, 1), "box.brep");
  EXPECT_EQ(run("box.brep", "a.stl", {"--to", "bezier"}).code, 2);
  EXPECT_EQ(run("box.brep", "a.stl", {"--deviation", "-1"}).code, 2);
}

// What is left out is listed, and no limit stopped anything.
TEST_F(ConvertMesh, LeavesOutAFaceWhoseBorderCrosses) {
  BRepBuilderAPI_MakePolygon bow(gp_Pnt(5, 5, 50), gp_Pnt(9, 9, 50), gp_Pnt(9, 5, 50),
                                 gp_Pnt(5, 9, 50), true);
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(10, 20, 30).Shape());
  builder.Add(both, BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 50), gp::DZ()), bow.Wire()).Face());
  write(both, "both.brep");
  const Finished ran = run("both.brep", "both.stl", {"--json", "-"});
  EXPECT_EQ(ran.code, 3) << ran.err;
  const nlohmann::json made = nlohmann::json::parse(ran.out);
  EXPECT_EQ(made["triangles"], 12);
  ASSERT_EQ(made["refused"].size(), 1u);
  EXPECT_EQ(made["refused"][0]["face"], 7);
}

}  // namespace
}  // namespace blossom::testing
