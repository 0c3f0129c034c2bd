// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom self-intersect` on surfaces whose self-intersection is known by hand.

#include <gtest/gtest.h>

#include <numbers>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
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

// (t^2, t^3 - t) with t = 3 u - 1.5, moved along z by 2 v; it meets itself in x = 1, y = 0.
Handle(Geom_BezierSurface) loop() {
  const double x[] = {2.25, -0.75, -0.75, 2.25}, y[] = {-1.875, 3.875, -3.875, 1.875};
  TColgp_Array2OfPnt poles(1, 4, 1, 2);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(x[i], y[i], 2 * j);
  return new Geom_BezierSurface(poles);
}

TopoDS_Face face_of(double u_from, double u_to, double v_from, double v_to) {
  return BRepBuilderAPI_MakeFace(loop(), u_from, u_to, v_from, v_to, 1e-7).Face();
}

class SelfIntersectCommand : public ::testing::Test {
 protected:
  Finished self_intersect(const TopoDS_Face& face, std::vector<std::string> options) {
    testing::write({face}, folder / "face.brep");
    options.insert(options.begin(), {"self-intersect", folder / "face.brep"});
    return blossom(options);
  }

  testing::TestFolder folder;
};

TEST_F(SelfIntersectCommand, FindsTheLineOfALoop) {
  const Finished run = self_intersect(face_of(0, 1, 0, 1), {"--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["schema"], "blossom.self-intersection/1");
  EXPECT_EQ(report["status"], "complete");
  EXPECT_EQ(report["verdict"], "found");
  ASSERT_EQ(report["curves"].size(), 1u);
  const json& line = report["curves"][0];
  EXPECT_NEAR(line["length"], 2, 1e-9);
  EXPECT_EQ(line["face_a"], 1);
  EXPECT_EQ(line["face_b"], 1);
  for (std::size_t i = 0; i < line["points"].size(); ++i) {
    EXPECT_NEAR(line["points"][i][0], 1, 1e-9);
    EXPECT_NEAR(line["points"][i][1], 0, 1e-9);
    EXPECT_NEAR(line["uv_a"][i][0].get<double>() + line["uv_b"][i][0].get<double>(), 1, 1e-9);
  }
}

TEST_F(SelfIntersectCommand, KeepsWhatLiesWithinTheTrims) {
  Finished run = self_intersect(face_of(0.1, 0.9, 0.25, 0.75), {"--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  ASSERT_EQ(report["curves"].size(), 1u);
  EXPECT_NEAR(report["curves"][0]["length"], 1, 1e-6);

  // One of the two passes is cut off: u = 1/6.
  run = self_intersect(face_of(0.2, 1, 0, 1), {"--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(json::parse(run.out)["curves"].empty());
}

TEST_F(SelfIntersectCommand, WritesTheEdge) {
  const Finished run = self_intersect(face_of(0, 1, 0, 1), {"-o", folder / "edges.brep"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("face.brep with itself: found, complete, 1 curve (0 closed), "),
            std::string::npos)
      << run.out;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(occt::read_model(folder / "edges.brep").shape(), TopAbs_EDGE, edges);
  EXPECT_EQ(edges.Extent(), 1);
}

TEST_F(SelfIntersectCommand, TellsThatThereIsNoEdgeToWrite) {
  const Finished run = self_intersect(face_of(0.2, 1, 0, 1), {"-o", folder / "edges.brep"});
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.err.find("is not written: no curve and no point"), std::string::npos) << run.err;
}

TEST_F(SelfIntersectCommand, WithFacesComparesDifferentOnesToo) {
  testing::write({testing::bowl(), testing::lid(0.25)}, folder / "both.brep");
  const Finished each = blossom({"self-intersect", folder / "both.brep", "--json", "-"});
  ASSERT_EQ(each.code, 0) << each.err;
  EXPECT_TRUE(json::parse(each.out)["curves"].empty());

  const Finished all = blossom({"self-intersect", folder / "both.brep", "--faces", "--json", "-"});
  ASSERT_EQ(all.code, 0) << all.err;
  const json report = json::parse(all.out);
  ASSERT_EQ(report["curves"].size(), 1u);
  EXPECT_EQ(report["curves"][0]["face_a"], 1);
  EXPECT_EQ(report["curves"][0]["face_b"], 2);
  EXPECT_NEAR(report["curves"][0]["length"], std::numbers::pi, 1e-6);
}

TEST_F(SelfIntersectCommand, SaysWhereOnlyDifferentPartsMeet) {
  occt::quiet_messages();
  occt::Model model;
  model.add(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 4, 4, 4).Shape(), "Low");
  model.add(BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 4), 4, 4, 4).Shape(), "High");
  occt::write_model(model, folder / "stack.step");

  const Finished stack = blossom({"self-intersect", folder / "stack.step", "--faces"});
  const std::string said = "no part meets itself";
  EXPECT_NE(stack.out.find(said), std::string::npos) << stack.out;
  EXPECT_EQ(self_intersect(face_of(0, 1, 0, 1), {}).out.find(said), std::string::npos);
}

TEST_F(SelfIntersectCommand, FindsNothingOnASphere) {
  const TopoDS_Face sphere = BRepPrimAPI_MakeSphere(2).Face();
  const Finished run = self_intersect(sphere, {"--json", "-"});
  ASSERT_EQ(run.code, 0) << run.out << run.err;
  const json report = json::parse(run.out);
  EXPECT_TRUE(report["curves"].empty());
  EXPECT_TRUE(report["places"].empty());
  EXPECT_EQ(report["verdict"], "none found");
}

TEST_F(SelfIntersectCommand, FailsOnFindingsIfAsked) {
  EXPECT_EQ(self_intersect(face_of(0, 1, 0, 1), {"--fail-on", "findings"}).code, 5);
  const Finished none = self_intersect(face_of(0.2, 1, 0, 1), {"--fail-on", "findings"});
  EXPECT_EQ(none.code, 0);
  EXPECT_NE(none.out.find("none found, complete, no curve and no point, "), std::string::npos)
      << none.out;
}

TEST_F(SelfIntersectCommand, IsUndecidedWhenItWasStopped) {
  const Finished run = self_intersect(face_of(0, 1, 0, 1), {"--budget", "1", "--json", "-"});
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(json::parse(run.out)["verdict"], "undecided") << run.out;
}

TEST_F(SelfIntersectCommand, RefusesAMissingFile) {
  const Finished run = blossom({"self-intersect", folder / "none.brep"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("none.brep"), std::string::npos);
}

}  // namespace
}  // namespace blossom
