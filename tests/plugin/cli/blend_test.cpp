// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom blend strip`: the written face, the report, the refusals.

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom::testing {
namespace {

class BlendStrip : public ::testing::Test {
 protected:
  BlendStrip() {
    write({half_pipe()}, folder / "pipe.step");
    write({lid(2), lid(5)}, folder / "lids.brep");
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }

  TestFolder folder;
};

TEST_F(BlendStrip, WritesOneValidFaceAndReportsItsContinuity) {
  const Finished ran = blossom({"blend", "strip", path("pipe.step"), path("lids.brep") + "#2",
                                "--edge-a", "vmax", "-o", path("out.step"), "--json", "-"});

  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json report = nlohmann::json::parse(ran.out);
  EXPECT_EQ(report["schema"], "blossom.blend/1");
  EXPECT_EQ(report["kind"], "strip");
  EXPECT_EQ(report["a"]["edge"], "vmax");
  EXPECT_EQ(report["b"]["face"], 2);
  EXPECT_EQ(report["rational"], true);
  EXPECT_LE(report["continuity"]["gap"], 1e-13);
  EXPECT_LE(report["continuity"]["normal_angle"], 1e-12);
  EXPECT_GT(report["continuity"]["a"]["scale"], 0);
  EXPECT_EQ(report["source_error"], 0);

  const occt::Model model = occt::read_model(path("out.step"));
  ASSERT_EQ(model.face_count(), 1);
  EXPECT_TRUE(BRepCheck_Analyzer(model.face(1)).IsValid());
  const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(model.face(1)));
  ASSERT_FALSE(surface.IsNull());
  EXPECT_EQ(surface->UDegree(), report["degree"][0]);
  EXPECT_EQ(surface->VDegree(), 3);
}

TEST_F(BlendStrip, WeightsScaleTheTangents) {
  const auto scale = [&](const std::string& weight) {
    const Finished ran =
        blossom({"blend", "strip", path("lids.brep#1"), path("lids.brep#2"), "--edge-a", "umax",
                 "--edge-b", "umin", "--weight-a", weight, "--json", "-"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    return nlohmann::json::parse(ran.out)["continuity"]["a"]["scale"].get<double>();
  };

  EXPECT_NEAR(scale("3") / scale("1"), 3, 1e-12);
}

TEST_F(BlendStrip, TellsPeopleWhatItJoined) {
  const Finished ran =
      blossom({"blend", "strip", path("lids.brep#1"), path("pipe.step"), "--edge-b", "vmin"});

  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find(" to " + path("pipe.step") + " vmin"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("largest gap"), std::string::npos) << ran.out;
}

TEST_F(BlendStrip, ContinuesCurvaturesFromAnEdgeByItsNumber) {
  const Finished ran = blossom({"blend", "strip", path("pipe.step"), path("lids.brep#2"),
                                "--edge-b", "6", "--continuity", "G2", "--json", "-"});

  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json report = nlohmann::json::parse(ran.out);
  EXPECT_EQ(report["b"]["edge"], 6);
  EXPECT_EQ(report["b"]["exact"], true);
  EXPECT_EQ(report["degree"][1], 5);
  EXPECT_EQ(report["continuity"]["order"], 2);
  EXPECT_LE(report["continuity"]["curvature_difference"], 1e-9);
}

TEST_F(BlendStrip, NamesTheEdgesOfTheFaceIfItHasNotTheOneThatWasMeant) {
  const Finished ran =
      blossom({"blend", "strip", path("pipe.step"), path("lids.brep#2"), "--edge-b", "1"});

  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("lids.brep#2: edge 1 is none of the face, which has 5, 6, 7, 8"),
            std::string::npos)
      << ran.err;
}

TEST_F(BlendStrip, RefusesWhatIsNotOneFace) {
  const Finished ran = blossom({"blend", "strip", path("lids.brep"), path("pipe.step")});

  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find(path("lids.brep") + ": a strip starts from one face, these are 2"),
            std::string::npos)
      << ran.err;
}

TEST_F(BlendStrip, RefusesBadOptionsAndWritesNothing) {
  const auto refused = [&](std::vector<std::string> more) {
    std::vector<std::string> all{"blend",           "strip", path("lids.brep#1"),
                                 path("pipe.step"), "-o",    path("never.step")};
    all.insert(all.end(), more.begin(), more.end());
    const Finished ran = blossom(all);
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_FALSE(ran.err.empty());
    EXPECT_FALSE(std::filesystem::exists(path("never.step")));
  };

  refused({"--edge-a", "left"});
  refused({"--weight-b", "0"});
  refused({"--weight-b", "nan"});
  refused({"--weight-b", "inf"});
  EXPECT_EQ(blossom({"blend"}).code, 2);
  EXPECT_EQ(blossom({"blend", "strip", path("lids.brep#1"), path("lids.brep#1"), "--edge-a", "umin",
                     "--edge-b", "umin"})
                .code,
            2);
}

}  // namespace
}  // namespace blossom::testing
