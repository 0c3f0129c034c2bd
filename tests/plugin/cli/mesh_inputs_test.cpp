// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of triangles as inputs: `blossom check` and `blossom query distance`.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <numbers>
#include <string>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "core/base/sanitizers.h"
#include "tests/plugin/cli/program.h"

namespace blossom::testing {
namespace {

constexpr const char* kTetrahedron =
    "OFF\n4 4 0\n0 0 0\n2 0 0\n0 2 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
constexpr const char* kOpen = "OFF\n4 3 0\n0 0 0\n2 0 0\n0 2 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n";

class MeshInputs : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder / name).string(); }

  void write(const TopoDS_Shape& shape, const std::string& name) {
    occt::quiet_messages();
    occt::Model model;
    model.add(shape, "part");
    occt::write_model(model, path(name));
  }

  nlohmann::json report(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Finished ran = blossom(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.code == 0 ? nlohmann::json::parse(ran.out) : nlohmann::json();
  }

  TestFolder folder;
};

TEST_F(MeshInputs, AreCheckedForSidesAndVolume) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  write_text(path("a.off"), kTetrahedron);
  const nlohmann::json found = report({"check", path("a.off")});
  EXPECT_EQ(found["schema"], "blossom.mesh-check/1");
  EXPECT_EQ(found["closed"], true);
  EXPECT_DOUBLE_EQ(found["volume"].get<double>(), 2);
  EXPECT_EQ(found["crossings"], 0);
}

TEST_F(MeshInputs, TellWhatTheyEncloseAndHowLargeTheyAre) {
  write_text(path("a.off"), kTetrahedron);
  const nlohmann::json found = report({"info", path("a.off")});
  EXPECT_EQ(found["schema"], "blossom.mesh-info/1");
  EXPECT_EQ(found["triangles"], 4);
  EXPECT_EQ(found["closed"], true);
  EXPECT_DOUBLE_EQ(found["volume"].get<double>(), 2);
  EXPECT_NEAR(found["area"].get<double>(), 8 + std::sqrt(22.0), 1e-12);
  EXPECT_EQ(found["box"], nlohmann::json::parse("[[0.0,0.0,0.0],[2.0,2.0,3.0]]"));
  EXPECT_NE(blossom({"info", path("a.off")}).out.find("closed, volume 2, area"), std::string::npos);
  EXPECT_EQ(blossom({"info", path("a.off"), "--edges"}).code, 2);

  write_text(path("b.off"), kOpen);
  const nlohmann::json open = report({"info", path("b.off")});
  EXPECT_EQ(open["closed"], false);
  EXPECT_TRUE(open["volume"].is_null());
  EXPECT_EQ(open["open_sides"], 3);
}

TEST_F(MeshInputs, TellTheirGroups) {
  write_text(path("a.obj"),
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\ng left\nf 1 2 3\ng right\nf 2 4 3\n");
  const nlohmann::json groups = report({"info", path("a.obj")})["groups"];
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0]["name"], "left");
  EXPECT_EQ(groups[1]["triangles"], 1);
  EXPECT_NE(blossom({"info", path("a.obj"), "--faces"}).out.find("right, 1 triangle"),
            std::string::npos);
}

TEST_F(MeshInputs, AreLinesOfATableBesideModels) {
  write(BRepPrimAPI_MakeBox(1, 2, 3), "box.brep");
  write_text(path("a.off"), kTetrahedron);
  const Finished ran = blossom({"info", path("box.brep"), path("a.off"), "--table", path("t.csv")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const std::string table = text_of(path("t.csv"));
  EXPECT_NE(table.find("box.brep"), std::string::npos) << table;
  EXPECT_NE(table.find(",closed"), std::string::npos) << table;
}

TEST_F(MeshInputs, AreShownWithTheirOpenSides) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  write_text(path("a.off"), kOpen);
  const Finished ran = blossom({"check", path("a.off"), "--html", path("a.html"), "--picture",
                                path("a.png"), "--glb", path("a.glb"), "--size", "200x150"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(text_of(path("a.html")).find("open side"), std::string::npos);
  EXPECT_NE(text_of(path("a.glb")).find("open side"), std::string::npos);
  EXPECT_EQ(text_of(path("a.png")).substr(1, 3), "PNG");
  write_text(path("b.off"), kTetrahedron);
  EXPECT_EQ(blossom({"info", path("b.off"), "--html", path("b.html")}).code, 0);
  EXPECT_NE(text_of(path("b.html")).find("4 triangles"), std::string::npos);
  EXPECT_EQ(text_of(path("b.html")).find("open side"), std::string::npos);
}

TEST_F(MeshInputs, AreShownWithTheTrianglesThatCross) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  write_text(path("a.off"),
             "OFF\n6 2 0\n0 0 0\n2 0 0\n0 2 0\n0.5 0.5 -1\n0.5 0.5 1\n3 3 0\n"
             "3 0 1 2\n3 3 4 5\n");
  ASSERT_EQ(blossom({"check", path("a.off"), "--html", path("a.html")}).code, 0);
  EXPECT_NE(text_of(path("a.html")).find("triangle 1 crosses triangle 2"), std::string::npos);
}

TEST_F(MeshInputs, AreShownWithTheirIntersectionsSectionsAndFillings) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  write_text(path("a.off"), kTetrahedron);
  write_text(path("b.off"), "OFF\n3 1 0\n-1 -1 1\n3 -1 1\n-1 3 1\n3 0 1 2\n");
  write_text(path("c.off"), kOpen);
  ASSERT_EQ(blossom({"blend", "fill", path("c.off"), "--html", path("f.html")}).code, 0);
  EXPECT_NE(text_of(path("f.html")).find("1 hole filled"), std::string::npos);
  ASSERT_EQ(blossom({"query", "plane", path("a.off"), "--point", "0,0,1", "--normal", "0,0,1",
                     "--html", path("p.html")})
                .code,
            0);
  EXPECT_NE(text_of(path("p.html")).find("closed, length"), std::string::npos);
  ASSERT_EQ(blossom({"intersect", path("a.off"), path("b.off"), "--html", path("i.html")}).code, 0);
  EXPECT_NE(text_of(path("i.html")).find("closed, length"), std::string::npos);
}

TEST_F(MeshInputs, SayHowManySidesAreOpen) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  write_text(path("a.off"), kOpen);
  EXPECT_EQ(report({"check", path("a.off")})["open_sides"], 3);
  EXPECT_EQ(blossom({"check", path("a.off"), "--fail-on", "findings"}).code, 5);
  EXPECT_NE(blossom({"check", path("a.off")}).out.find("3 sides of one triangle"),
            std::string::npos);
}

TEST_F(MeshInputs, ThatPromiseTenGigabytesAreRefused) {
  std::string bytes(84, ' ');
  const std::uint32_t count = 200'000'000;
  std::memcpy(bytes.data() + 80, &count, sizeof count);
  write_text(path("a.stl"), bytes);
  const Finished ran = blossom({"check", path("a.stl")});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("promises 200000000 facets"), std::string::npos) << ran.err;
}

TEST_F(MeshInputs, AreAsFarFromTheirModelAsTheyClaim) {
  write(BRepPrimAPI_MakeCylinder(10, 20), "rod.brep");
  const nlohmann::json made = [&] {
    const Finished ran = blossom(
        {"convert", path("rod.brep"), "-o", path("rod.stl"), "--deviation", "0.05", "--json", "-"});
    return nlohmann::json::parse(ran.out);
  }();
  const nlohmann::json found = report({"query", "distance", path("rod.stl"), path("rod.brep")});
  EXPECT_EQ(found["schema"], "blossom.mesh-distance/1");
  EXPECT_LE(found["lower"], made["distance"]);
  EXPECT_GE(found["upper"].get<double>(), 0.7 * made["distance"].get<double>());
  EXPECT_LE(found["upper"].get<double>(), 1.3 * found["lower"].get<double>());
}

TEST_F(MeshInputs, AreToldToBeAPartOrNotWithinADistance) {
  write(BRepPrimAPI_MakeCylinder(10, 20), "rod.brep");
  write(BRepPrimAPI_MakeCylinder(10.06, 20), "thick.brep");
  ASSERT_EQ(
      blossom({"convert", path("rod.brep"), "-o", path("rod.stl"), "--deviation", "0.02"}).code, 0);
  const auto asked = [&](const char* part, const char* within) {
    return blossom({"query", "distance", path("rod.stl"), path(part), "--within", within,
                    "--fail-on", "findings"});
  };
  const Finished yes = asked("rod.brep", "0.05"), no = asked("thick.brep", "0.05");
  EXPECT_EQ(yes.code, 0) << yes.err;
  EXPECT_NE(yes.out.find("yes, they are within 0.05"), std::string::npos) << yes.out;
  EXPECT_EQ(no.code, 5) << no.err;
  EXPECT_NE(no.out.find("no, they are not within 0.05"), std::string::npos) << no.out;
  EXPECT_EQ(
      blossom({"query", "distance", path("rod.stl"), path("thick.brep"), "--within", "0.05"}).code,
      0);
  const nlohmann::json found =
      report({"query", "distance", path("rod.stl"), path("thick.brep"), "--within", "0.2"});
  EXPECT_EQ(found["is_within"], true);
  EXPECT_GE(found["upper"].get<double>(), 0.06);
}

TEST_F(MeshInputs, WithColoursAreWrittenAs3mf) {
  write_text(path("a.off"),
             "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1 255 0 0\n3 0 1 3 255 0 0\n"
             "3 1 2 3 0 255 0\n3 0 3 2\n");
  const Finished ran = blossom({"convert", path("a.off"), "-o", path("a.3mf")});
  if (ran.err.find("not built in") != std::string::npos) GTEST_SKIP() << ran.err;
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(std::filesystem::exists(path("a.3mf")));
}

// A file of 4 GiB, most of which is behind its only facet, and takes no room on the disk.
TEST_F(MeshInputs, AreNotCopiedIntoMemory) {
#ifdef BLOSSOM_ADDRESS_SANITIZER
  GTEST_SKIP() << "the sanitizer takes more memory than the limit";
#endif
  std::string bytes(80, ' ');
  const std::uint32_t count = 1;
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const float x : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F})
    bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
  write_text(path("a.stl"), bytes);
  std::filesystem::resize_file(path("a.stl"), std::uintmax_t{4} << 30);
  const Finished ran = blossom({"info", path("a.stl")}, "prlimit --data=1000000000");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("1 triangle"), std::string::npos) << ran.out;
}

TEST_F(MeshInputs, ThatAreTheSameAreNotApart) {
  write(BRepPrimAPI_MakeSphere(10), "ball.brep");
  ASSERT_EQ(blossom({"convert", path("ball.brep"), "-o", path("ball.ply")}).code, 0);
  const nlohmann::json found = report({"query", "distance", path("ball.ply"), path("ball.ply")});
  EXPECT_LE(found["upper"].get<double>(), 1e-12);
}

TEST_F(MeshInputs, OfAnotherPartAreFarFromIt) {
  write(BRepPrimAPI_MakeBox(1, 1, 1), "a.brep");
  write(BRepPrimAPI_MakeBox(1, 1, 3), "b.brep");
  EXPECT_EQ(blossom({"convert", path("b.brep"), "-o", path("b.ply")}).code, 0);
  const nlohmann::json found = report({"query", "distance", path("a.brep"), path("b.ply")});
  // The middle of the lower lid is nearest to the walls.
  EXPECT_NEAR(found["a_to_b"]["upper"].get<double>(), 0.5, 1e-3);
  EXPECT_NEAR(found["b_to_a"]["lower"].get<double>(), 2, 1e-6);
  EXPECT_NEAR(found["upper"].get<double>(), 2, 1e-3);
  EXPECT_GE(found["upper"].get<double>(), 2);
}

TEST_F(MeshInputs, DeepChecksOfModelsCountCrossings) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  write(BRepPrimAPI_MakeCylinder(10, 20), "rod.brep");
  const nlohmann::json found = report({"check", path("rod.brep"), "--deep"})["triangles"];
  EXPECT_EQ(found["closed"], true);
  EXPECT_EQ(found["crossings"], 0);
  EXPECT_NEAR(found["volume"].get<double>(), std::numbers::pi * 2000, 60);
}

// However many triangles of parts that touch cross: here more than a report lists.
TEST_F(MeshInputs, DeepChecksOfPartsThatTouchFindNoFault) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  const gp_Ax2 along(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(along, 5, 20).Shape();
  const gp_Ax2 turned(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(2, 1, 0));
  const TopoDS_Shape bush = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(turned, 8, 20).Shape(),
                                            BRepPrimAPI_MakeCylinder(turned, 5, 20).Shape())
                                .Shape();
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, pin);
  builder.Add(both, bush);
  write(both, "fit.brep");
  const nlohmann::json made =
      report({"convert", path("fit.brep"), "-o", path("fit.stl"), "--deviation", "0.0005"});
  EXPECT_GT(made["crossings"], 1000);
  EXPECT_EQ(made["crossings_between_parts"], made["crossings"]);
  const nlohmann::json found = report({"check", path("fit.brep"), "--deep"})["triangles"];
  EXPECT_EQ(found["crossings"], 0);
  EXPECT_GT(found["crossings_between_parts"], 0);
}

}  // namespace
}  // namespace blossom::testing
