// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom intersect` of edges and wires, where their common points are known by hand.

#include <gtest/gtest.h>

#include <set>
#include <string>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

// The cube [0, 4]^3, and a wire that comes down into it, and leaves it to the right.
class IntersectEdgesCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    occt::quiet_messages();
    write("cube.step", "Cube", BRepPrimAPI_MakeBox(4., 4., 4.).Shape());
    write("wire.step", "Path",
          BRepBuilderAPI_MakePolygon(gp_Pnt(1, 1, 9), gp_Pnt(1, 1, 2), gp_Pnt(8, 1, 2)).Shape());
  }

  void write(const std::string& file, const std::string& name, const TopoDS_Shape& shape) {
    occt::Model model;
    model.add(shape, name);
    occt::write_model(model, folder / file);
  }

  Finished run(const std::string& a, const std::string& b, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"intersect", folder / a, folder / b});
    return blossom(options);
  }

  testing::TestFolder folder;
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(IntersectEdgesCommand, AWireHasThePointsInWhichItCrossesASolid) {
  const Finished found = run("wire.step", "cube.step", {"--json", "-"});

  ASSERT_EQ(found.code, 0) << found.err;
  EXPECT_EQ(found.err, "");
  const json report = json::parse(found.out);
  EXPECT_EQ(report["status"], "complete");
  ASSERT_EQ(report["edge_points"].size(), 2u);
  std::set<std::string> kinds;
  for (const json& point : report["edge_points"]) {
    EXPECT_EQ(point["on_a"]["kind"], "edge");
    EXPECT_EQ(point["on_b"]["kind"], "face");
    const bool top = point["point"][2] > 3;
    EXPECT_NEAR(point["point"][0].get<double>(), top ? 1 : 4, 1e-9);
    EXPECT_NEAR(point["point"][1].get<double>(), 1, 1e-9);
    EXPECT_NEAR(point["point"][2].get<double>(), top ? 4 : 2, 1e-9);
  }
  EXPECT_EQ(report["joined"]["points"], 2);
}

TEST_F(IntersectEdgesCommand, EitherInputMayBeTheWire) {
  const Finished found = run("cube.step", "wire.step");

  EXPECT_EQ(found.code, 0) << found.err;
  EXPECT_TRUE(holds(found.out, "complete, 2 points")) << found.out;
  EXPECT_TRUE(holds(found.out, "(Cube) x edge 1: point near (1, 1, 4)")) << found.out;
}

TEST_F(IntersectEdgesCommand, AnEdgeIsNamedByItsNumber) {
  const Finished found = run("wire.step#edge:2", "cube.step#face:2", {"--json", "-"});

  ASSERT_EQ(found.code, 0) << found.err;
  const json report = json::parse(found.out);
  ASSERT_EQ(report["edge_points"].size(), 1u);
  EXPECT_EQ(report["edge_points"][0]["on_a"], (json{{"kind", "edge"}, {"number", 2}}));
  EXPECT_EQ(report["edge_points"][0]["on_b"], (json{{"kind", "face"}, {"number", 2}}));
}

TEST_F(IntersectEdgesCommand, ANamedEdgeOfASolidIsTakenAlone) {
  const Finished found = run("cube.step#edge:1", "wire.step");

  EXPECT_EQ(found.code, 0) << found.err;
  EXPECT_TRUE(holds(found.out, "no curve and no point")) << found.out;
}

TEST_F(IntersectEdgesCommand, WhatLiesOnAFaceIsToldWithItsLength) {
  write("line.step", "Line", BRepBuilderAPI_MakeEdge(gp_Pnt(-2, 1, 4), gp_Pnt(7, 1, 4)).Shape());

  const Finished found =
      run("line.step", "cube.step", {"--json", folder / "r.json", "-o", folder / "out.step"});

  EXPECT_EQ(found.code, 0) << found.err;
  EXPECT_TRUE(holds(found.out, "1 common stretch of 4 mm")) << found.out;
  EXPECT_TRUE(holds(found.out, "common stretch of length 4 from (0, 1, 4) to (4, 1, 4)"))
      << found.out;
  const json report = json::parse(testing::text_of(folder / "r.json"));
  ASSERT_EQ(report["edge_stretches"].size(), 1u);
  EXPECT_NEAR(report["edge_stretches"][0]["length"].get<double>(), 4, 1e-9);
  const occt::Model again = occt::read_model(folder / "out.step");
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(again.shape(), TopAbs_EDGE, edges);
  EXPECT_EQ(edges.Extent(), 1);
}

TEST_F(IntersectEdgesCommand, EdgesBesideFacesCountWhereTheyAreNamed) {
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(20, 0, 0), 4., 4., 4.).Shape());
  builder.Add(both, BRepBuilderAPI_MakeEdge(gp_Pnt(1, 1, -5), gp_Pnt(1, 1, 9)).Edge());
  write("mixed.step", "Mixed", both);

  const Finished all = run("mixed.step", "cube.step");
  EXPECT_TRUE(holds(all.err, "1 edge without faces left out; name it to intersect it, as #edge:13"))
      << all.err;
  EXPECT_TRUE(holds(all.out, "no curve and no point")) << all.out;
  const Finished named = run("mixed.step#edge:13", "cube.step");
  EXPECT_EQ(named.err, "");
  EXPECT_TRUE(holds(named.out, "complete, 2 points")) << named.out;
}

TEST_F(IntersectEdgesCommand, CurvesMeetCurves) {
  write("ring.step", "Ring",
        BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({1, 1, 2}, {0, 0, 1}), 3)).Shape());

  const Finished found = run("ring.step", "wire.step", {"-o", folder / "out.brep"});

  EXPECT_EQ(found.code, 0) << found.err;
  EXPECT_TRUE(holds(found.out, "1 point")) << found.out;
  EXPECT_TRUE(holds(found.out, "edge 1 x edge 2: point near (4, 1, 2)")) << found.out;
  const occt::Model again = occt::read_model(folder / "out.brep");
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(again.shape(), TopAbs_VERTEX, vertices);
  EXPECT_EQ(vertices.Extent(), 1);
}

TEST_F(IntersectEdgesCommand, WiresApartAreProvenToHaveNoPoint) {
  write("far.step", "Far", BRepBuilderAPI_MakeEdge(gp_Pnt(20, 0, 0), gp_Pnt(30, 0, 0)).Shape());

  const Finished found = run("far.step", "cube.step", {"-o", folder / "out.step"});

  EXPECT_EQ(found.code, 0) << found.err;
  EXPECT_TRUE(holds(found.out, "complete, no curve and no point")) << found.out;
  EXPECT_TRUE(holds(found.err, "no curve and no point was found")) << found.err;
}

TEST_F(IntersectEdgesCommand, PicturesAndPagesShowEdgesAndPoints) {
  const Finished found =
      run("wire.step", "cube.step", {"--picture", folder / "p.png", "--html", folder / "p.html"});
  const Finished wires = run("wire.step", "wire.step#edge:1", {"--picture", folder / "w.png"});

  EXPECT_EQ(found.code, 0) << found.err;
  EXPECT_TRUE(holds(testing::text_of(folder / "p.html"), "face 5 (Cube)"));
  EXPECT_EQ(testing::text_of(folder / "p.png").substr(1, 3), "PNG");
  EXPECT_EQ(wires.code, 0) << wires.err;
  EXPECT_EQ(testing::text_of(folder / "w.png").substr(1, 3), "PNG");
}

TEST_F(IntersectEdgesCommand, FindingsCountForTheExitCode) {
  EXPECT_EQ(run("wire.step", "cube.step", {"--fail-on", "findings"}).code, 5);
}

}  // namespace
}  // namespace blossom
