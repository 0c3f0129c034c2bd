// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of triangles as inputs of `blossom convert` and `blossom blend fill`.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "plugin/meshes/mesh_files.h"
#include "tests/plugin/cli/program.h"

namespace blossom::testing {
namespace {

// A cube without its top.
constexpr const char* kBox =
    "OFF\n8 5 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n4 0 3 2 1\n4 0 1 5 4\n"
    "4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

class MeshConversions : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  nlohmann::json report(std::vector<std::string> arguments, int code = 0) {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Finished ran = blossom(arguments);
    EXPECT_EQ(ran.code, code) << ran.err;
    return ran.code == code ? nlohmann::json::parse(ran.out) : nlohmann::json();
  }

  TestFolder folder_;
};

TEST_F(MeshConversions, FillHolesAndSayWhatIsThen) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  write_text(path("a.off"), kBox);
  const nlohmann::json told = report({"blend", "fill", path("a.off"), "-o", path("b.ply")});
  EXPECT_EQ(told["schema"], "blossom.mesh-fill/1");
  EXPECT_EQ(told["holes"][0]["sides"], nlohmann::json({4}));
  EXPECT_EQ(told["closed"], true);
  EXPECT_NEAR(told["volume"], 8, 1e-12);
  EXPECT_EQ(report({"check", path("b.ply")})["verdict"], "sound");
  EXPECT_EQ(report({"check", path("b.ply#fill")})["triangles"], 2);
  EXPECT_EQ(blossom({"blend", "fill", path("a.off"), "--sew", "-o", path("c.ply")}).code, 2);
}

TEST_F(MeshConversions, KeepVolumeGroupsAndColoursFromFormatToFormat) {
  occt::quiet_messages();
  occt::Model model;
  model.add(BRepPrimAPI_MakeCylinder(10, 20).Shape(), "rod", {0.2, 0.4, 1});
  occt::write_model(model, path("rod.step"));
  const nlohmann::json made = report({"convert", path("rod.step"), "-o", path("a.ply")});
  const meshes::FileMesh first = meshes::read_mesh_file(path("a.ply"));
  EXPECT_EQ(first.groups[0].name, "rod/Face1");
  EXPECT_EQ(first.groups[0].colour, (meshes::MeshColour{51, 102, 255}));
  EXPECT_EQ(blossom({"convert", path("a.ply"), "-o", path("b.off")}).code, 0);
  EXPECT_EQ(blossom({"convert", path("b.off"), "-o", path("c.ply"), "--text"}).code, 0);
  const meshes::FileMesh last = meshes::read_mesh_file(path("c.ply"));
  EXPECT_EQ(last.groups, first.groups);
  EXPECT_EQ(last.points, first.points);
  EXPECT_EQ(last.triangles, first.triangles);
  EXPECT_EQ(report({"info", path("c.ply")})["volume"], report({"info", path("a.ply")})["volume"]);
}

TEST_F(MeshConversions, MakeCurvedPatchesOfARegion) {
  write_text(path("a.off"), kBox);
  EXPECT_EQ(blossom({"convert", path("a.off"), "-o", path("b.step")}).code, 2);
  const nlohmann::json told =
      report({"convert", path("a.off"), "-o", path("b.step"), "--to", "bezier", "--crease", "115"});
  EXPECT_EQ(told["schema"], "blossom.mesh-patches/1");
  EXPECT_EQ(told["patches"], 30);
  EXPECT_EQ(told["sharp_sides"], 0);
  EXPECT_LT(told["largest_angle"], 1e-6);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(occt::read_model(path("b.step")).shape(), TopAbs_FACE, faces);
  EXPECT_EQ(faces.Extent(), 30);
  EXPECT_EQ(report({"convert", path("a.off"), "-o", path("c.json"), "--to", "triangles"})["degree"],
            4);
}

TEST_F(MeshConversions, AreCheckedBesideModels) {
  if (!kHasCgal) GTEST_SKIP() << kNoCgal;
  write_text(path("a.off"), kBox);
  occt::quiet_messages();
  occt::Model model;
  model.add(BRepPrimAPI_MakeCylinder(10, 20).Shape(), "rod");
  occt::write_model(model, path("rod.brep"));
  const Finished ran = blossom({"check", path("a.off"), path("rod.brep")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("not sound: 4 problems, 10 triangles"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("3 faces"), std::string::npos) << ran.out;
}

TEST_F(MeshConversions, AreRefusedByNameWhereTheyAreNoInput) {
  write_text(path("a.off"), kBox);
  const Finished ran = blossom({"self-intersect", path("a.off")});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("is of triangles"), std::string::npos) << ran.err;
}

TEST_F(MeshConversions, SayWhichGroupsThereAreNot) {
  write_text(path("a.off"), kBox);
  const Finished ran = blossom({"check", path("a.off#Face3")});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("there is no group 'Face3', it has none"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace blossom::testing
