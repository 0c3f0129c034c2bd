// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom intersect` on surfaces whose intersection is known by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

// The bowl z = x^2 + y^2 and a lid at some height; a circle of radius sqrt(height).
class IntersectCommand : public ::testing::Test {
 protected:
  Finished intersect(double height, std::vector<std::string> options) {
    testing::write({testing::bowl()}, folder / "bowl.brep");
    testing::write({testing::lid(height)}, folder / "lid.brep");
    options.insert(options.begin(), {"intersect", folder / "bowl.brep", folder / "lid.brep"});
    return blossom(options);
  }

  testing::TestFolder folder;
};

void expect_circle(const json& curve, double radius, double height) {
  const json& points = curve["points"];
  ASSERT_EQ(points.size(), curve["uv_a"].size());
  ASSERT_EQ(points.size(), curve["uv_b"].size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i][0], y = points[i][1], z = points[i][2];
    EXPECT_NEAR(std::hypot(x, y), radius, 1e-9);
    EXPECT_NEAR(z, height, 1e-9);
    EXPECT_NEAR(2 * curve["uv_a"][i][0].get<double>() - 1, x, 1e-9);
    EXPECT_NEAR(2 * curve["uv_a"][i][1].get<double>() - 1, y, 1e-9);
    EXPECT_NEAR(3 * curve["uv_b"][i][0].get<double>() - 1.5, x, 1e-9);
    EXPECT_NEAR(3 * curve["uv_b"][i][1].get<double>() - 1.5, y, 1e-9);
  }
}

TEST_F(IntersectCommand, FindsTheClosedCircle) {
  const Finished run = intersect(0.25, {"--json", "-"});

  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const json report = json::parse(run.out);
  EXPECT_EQ(report["status"], "complete");
  ASSERT_EQ(report["curves"].size(), 1u);
  const json& curve = report["curves"][0];
  EXPECT_EQ(curve["closed"], true);
  EXPECT_EQ(curve["tangential"], false);
  EXPECT_EQ(curve["face_a"], 1);
  EXPECT_EQ(curve["face_b"], 1);
  EXPECT_GE(curve["points"].size(), 48u);
  EXPECT_EQ(curve["points"].front(), curve["points"].back());
  EXPECT_NEAR(curve["length"].get<double>(), std::numbers::pi, 1e-6);
  expect_circle(curve, 0.5, 0.25);
}

TEST_F(IntersectCommand, SaysThatACircleIsOneAndWritesIt) {
  const Finished run = intersect(0.25, {"--json", "-", "-o", folder / "circle.step"});

  ASSERT_EQ(run.code, 0) << run.err;
  const json conic = json::parse(run.out)["curves"][0]["conic"];
  EXPECT_EQ(conic["type"], "circle");
  EXPECT_NEAR(conic["radius"].get<double>(), 0.5, 1e-12);
  EXPECT_NEAR(conic["centre"][2].get<double>(), 0.25, 1e-12);
  EXPECT_EQ(conic["range"], (json{0.0, 2 * std::numbers::pi}));
  EXPECT_NE(testing::text_of(folder / "circle.step").find("CIRCLE("), std::string::npos);
  const occt::Model again = occt::read_model(folder / "circle.step");
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(again.shape(), TopAbs_EDGE, edges);
  ASSERT_EQ(edges.Extent(), 1);
  const BRepAdaptor_Curve curve(TopoDS::Edge(edges(1)));
  EXPECT_EQ(curve.GetType(), GeomAbs_Circle);
  EXPECT_TRUE(curve.IsClosed());
}

TEST_F(IntersectCommand, WritesAnEllipseAsOne) {
  testing::write({testing::half_pipe()}, folder / "pipe.brep");
  const gp_Pln oblique(gp_Pnt(0, 0, 0.4), gp_Dir(0.2, 0, 1));
  testing::write({BRepBuilderAPI_MakeFace(oblique, -3, 3, -3, 3).Face()}, folder / "plane.brep");

  const Finished run = blossom({"intersect", folder / "pipe.brep", folder / "plane.brep", "--json",
                                "-", "-o", folder / "ellipse.step"});

  ASSERT_EQ(run.code, 0) << run.err;
  const json conic = json::parse(run.out)["curves"][0]["conic"];
  EXPECT_EQ(conic["type"], "ellipse");
  EXPECT_NEAR(conic["major"].get<double>(), std::hypot(1, 0.2), 1e-11);
  EXPECT_NEAR(conic["minor"].get<double>(), 1, 1e-11);
  EXPECT_NE(testing::text_of(folder / "ellipse.step").find("ELLIPSE("), std::string::npos);
}

TEST_F(IntersectCommand, FindsTheFourArcsInTheCorners) {
  const double radius = std::sqrt(1.25);
  const double arc = radius * (std::numbers::pi / 2 - 2 * std::acos(1 / radius));

  const Finished run = intersect(1.25, {"--json", "-"});

  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  ASSERT_EQ(report["curves"].size(), 4u);
  for (const json& curve : report["curves"]) {
    EXPECT_EQ(curve["closed"], false);
    EXPECT_NEAR(curve["length"].get<double>(), arc, 1e-6);
    expect_circle(curve, radius, 1.25);
  }
}

TEST_F(IntersectCommand, ProvesThatThereIsNothing) {
  const Finished run = intersect(2.5, {"--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["status"], "complete");
  for (const char* list : {"curves", "points", "nodes", "overlaps", "places"})
    EXPECT_EQ(report[list], json::array()) << list;
}

TEST_F(IntersectCommand, SaysWhatContactsAreOn) {
  const json touch = json::parse(intersect(0, {"--json", "-"}).out);
  ASSERT_EQ(touch["points"].size(), 1u);
  EXPECT_EQ(touch["points"][0]["on_a"], (json{{"kind", "face"}, {"number", 1}}));

  const json corners = json::parse(intersect(2, {"--json", "-"}).out);
  ASSERT_EQ(corners["points"].size(), 4u);
  std::vector<int> vertices;
  for (const json& point : corners["points"]) {
    EXPECT_EQ(point["on_a"]["kind"], "vertex");
    vertices.push_back(point["on_a"]["number"]);
    EXPECT_EQ(point["on_b"], (json{{"kind", "face"}, {"number", 1}}));
  }
  std::ranges::sort(vertices);
  EXPECT_EQ(vertices, (std::vector{1, 2, 3, 4}));
}

TEST_F(IntersectCommand, MakesOneCurveOfPiecesBetweenSeams) {
  const TopoDS_Face sphere = BRepPrimAPI_MakeSphere(1).Face();
  const TopoDS_Face plane =
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0.8, 0, 0), gp_Dir(1, 0, 0)), -2, 2, -2, 2);
  testing::write({sphere}, folder / "sphere.brep");
  testing::write({plane}, folder / "plane.brep");
  const Finished run = blossom({"intersect", folder / "sphere.brep", folder / "plane.brep",
                                "--json", "-", "-o", folder / "edges.brep"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  ASSERT_EQ(report["curves"].size(), 1u);
  const json& curve = report["curves"][0];
  EXPECT_EQ(curve["closed"], true);
  EXPECT_EQ(curve["edges"], 2);
  EXPECT_EQ(curve["points"].front(), curve["points"].back());
  EXPECT_EQ(curve["points"].size(), curve["uv_a"].size());
  EXPECT_NEAR(curve["length"], 1.2 * std::numbers::pi, 1e-9);
  EXPECT_EQ(curve["conic"]["type"], "circle");
  EXPECT_NEAR(curve["conic"]["radius"], 0.6, 1e-9);
  const double turn =
      curve["conic"]["range"][1].get<double>() - curve["conic"]["range"][0].get<double>();
  EXPECT_NEAR(turn, 2 * std::numbers::pi, 1e-9);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(occt::read_model(folder / "edges.brep").shape(), TopAbs_EDGE, edges);
  EXPECT_EQ(edges.Extent(), 2);
}

TEST_F(IntersectCommand, ReportsTheBoundaryOfAnOverlap) {
  testing::write({testing::bowl()}, folder / "bowl.brep");
  const Finished run =
      blossom({"intersect", folder / "bowl.brep", folder / "bowl.brep", "--json", "-"});

  EXPECT_EQ(run.code, 0) << run.err;  // a face and its copy, without any difference
  const json report = json::parse(run.out);
  EXPECT_EQ(report["curves"], json::array());
  ASSERT_EQ(report["overlaps"].size(), 1u);
  const json& overlap = report["overlaps"][0];
  EXPECT_EQ(overlap["edges_a"].size(), 4u);
  EXPECT_EQ(overlap["edges_a"], overlap["edges_b"]);
  EXPECT_EQ(overlap["face_a"], 1);
  EXPECT_EQ(overlap["face_b"], 1);
  EXPECT_EQ(overlap["boundary"].front(), overlap["boundary"].back());
  ASSERT_EQ(overlap["boundary"].size(), overlap["uv_a"].size());
  ASSERT_EQ(overlap["boundary"].size(), overlap["uv_b"].size());
  for (const json& p : overlap["boundary"])
    EXPECT_NEAR(std::max(std::abs(p[0].get<double>()), std::abs(p[1].get<double>())), 1, 1e-9);
  ASSERT_EQ(report["places"].size(), 1u);
  EXPECT_EQ(report["places"][0]["kind"], "overlap");
}

TEST_F(IntersectCommand, ReportHasEveryFieldOfItsSchema) {
  const Finished run = intersect(0.25, {"--json", "-", "--repeat", "3"});
  const json report = json::parse(run.out);
  EXPECT_EQ(report["schema"], "blossom.intersection/1");
  EXPECT_EQ(report["a"], (folder / "bowl.brep").string());
  EXPECT_EQ(report["b"], (folder / "lid.brep").string());
  EXPECT_GT(report["seconds"].get<double>(), 0);
  EXPECT_GT(report["seconds_first"].get<double>(), 0);
  for (const char* list : {"curves", "points", "nodes", "overlaps", "places"})
    EXPECT_TRUE(report[list].is_array()) << list;
  const json& curve = report["curves"][0];
  EXPECT_GE(curve["degree"].get<int>(), 1);
  EXPECT_GT(curve["poles"].get<int>(), curve["degree"].get<int>());
  for (const char* side : {"a", "b", "between"}) {
    EXPECT_GE(curve["deviation"][side].get<double>(), 0) << side;
    EXPECT_LE(curve["deviation"][side].get<double>(), 1e-6) << side;
  }
  EXPECT_EQ(curve["deviation_proven"], true);
  for (const char* count : {"excluded", "certified", "critical", "cells_bezier", "cells_monomial"})
    EXPECT_TRUE(report["certificate"][count].is_number_integer()) << count;
  EXPECT_GT(report["certificate"]["certified"].get<long>(), 0);
}

TEST_F(IntersectCommand, WithAFormUsesThatFormOnly) {
  const json bezier = json::parse(intersect(0.25, {"--json", "-", "--form", "bezier"}).out);
  EXPECT_EQ(bezier["certificate"]["cells_monomial"], 0);
  EXPECT_GT(bezier["certificate"]["cells_bezier"].get<long>(), 0);
  const json monomial = json::parse(intersect(0.25, {"--json", "-", "--form", "monomial"}).out);
  EXPECT_EQ(monomial["certificate"]["cells_bezier"], 0);
  EXPECT_GT(monomial["certificate"]["cells_monomial"].get<long>(), 0);
}

TEST_F(IntersectCommand, OutOfBudgetSaysStoppedAndListsOpenPlaces) {
  const Finished run = intersect(0.25, {"--json", "-", "--budget", "1"});
  EXPECT_EQ(run.code, 4) << run.err;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["status"], "stopped");
  ASSERT_FALSE(report["places"].empty());
  EXPECT_EQ(report["places"][0]["kind"], "open");
}

TEST_F(IntersectCommand, ExitCodeSaysTheStatus) {
  // The lid touches the bottom of the bowl: whether that is proven or within tolerance, the two
  // must agree, and the contact must be in the answer.
  const Finished run = intersect(0, {"--json", "-"});
  const json report = json::parse(run.out);
  const std::string status = report["status"];
  EXPECT_EQ(run.code, status == "complete" ? 0 : status == "tolerance" ? 3 : 4) << status;
  EXPECT_NE(status, "stopped");
  EXPECT_FALSE(report["points"].empty() && report["places"].empty());
}

TEST_F(IntersectCommand, SummarisesForPeopleUnlessQuiet) {
  const Finished loud = intersect(0.25, {});
  EXPECT_NE(loud.out.find("complete, 1 curve (1 closed)"), std::string::npos) << loud.out;
  EXPECT_EQ(intersect(0.25, {"--quiet"}).out, "");
}

TEST_F(IntersectCommand, NumbersFacesAsInTheFile) {
  testing::write({testing::lid(2.5), testing::lid(0.25), testing::lid(0.5)}, folder / "lids.brep");
  testing::write({testing::bowl()}, folder / "bowl.brep");
  const Finished run = blossom(
      {"intersect", folder / "bowl.brep", (folder / "lids.brep").string() + "#1,3", "--json", "-"});
  const json report = json::parse(run.out);
  ASSERT_EQ(report["curves"].size(), 1u);
  EXPECT_EQ(report["curves"][0]["face_b"], 3);
}

TEST_F(IntersectCommand, WritesEdgesThatLieOnBothSurfaces) {
  ASSERT_EQ(intersect(0.25, {"-o", folder / "edges.brep"}).code, 0);

  const occt::Model model = occt::read_model(folder / "edges.brep");
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(model.shape(), TopAbs_EDGE, edges);
  ASSERT_EQ(edges.Extent(), 1);
  const TopoDS_Edge& edge = TopoDS::Edge(edges(1));
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  for (const int side : {1, 2}) {
    Handle(Geom2d_Curve) pcurve;
    Handle(Geom_Surface) surface;
    TopLoc_Location place;
    BRep_Tool::CurveOnSurface(edge, pcurve, surface, place, first, last, side);
    ASSERT_FALSE(pcurve.IsNull()) << side;
    for (int i = 0; i <= 100; ++i) {
      const double t = first + (last - first) * i / 100;
      const gp_Pnt2d uv = pcurve->Value(t);
      EXPECT_LE(curve->Value(t).Distance(surface->Value(uv.X(), uv.Y())),
                BRep_Tool::Tolerance(edge));
    }
  }
}

TEST_F(IntersectCommand, TellsThatThereIsNoEdgeToWrite) {
  const std::string file = folder / "edges.step";
  const Finished run = intersect(-1, {"-o", file});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "blossom: " + file + " is not written: no curve and no point was found\n");
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(IntersectCommand, WritesStepWithThePairsName) {
  ASSERT_EQ(intersect(1.25, {"-o", folder / "edges.step"}).code, 0);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(occt::read_model(folder / "edges.step").shape(), TopAbs_EDGE, edges);
  EXPECT_EQ(edges.Extent(), 4);
  EXPECT_NE(testing::text_of(folder / "edges.step").find("bowl.brep#1 x lid.brep#1"),
            std::string::npos);
}

TEST_F(IntersectCommand, InterruptedLeavesNothingBehind) {
  testing::write({testing::bowl()}, folder / "bowl.brep");
  testing::write({testing::lid(0.25)}, folder / "lid.brep");
  const Finished run = blossom(
      {"intersect", folder / "bowl.brep", folder / "lid.brep", "-o", folder / "edges.step",
       "--json", folder / "report.json", "--picture", folder / "a.png", "--repeat", "1000000"},
      "timeout --foreground --preserve-status -s INT 1");
  EXPECT_EQ(run.code, 130);
  EXPECT_EQ(run.err, "blossom: interrupted, nothing was written\n");
  EXPECT_EQ(folder.listing(), (std::vector<std::string>{"bowl.brep", "lid.brep"}));
}

TEST_F(IntersectCommand, InterruptedTwiceStillAnswers130) {
  // Without --foreground, timeout signals the program and then its whole group.
  testing::write({testing::bowl()}, folder / "bowl.brep");
  const Finished run =
      blossom({"intersect", folder / "bowl.brep", folder / "bowl.brep", "--repeat", "1000000"},
              "timeout --preserve-status -s INT 1");
  EXPECT_EQ(run.code, 130);
  EXPECT_EQ(run.err, "blossom: interrupted, nothing was written\n");
}

TEST_F(IntersectCommand, DrawsTheSamePictureEveryTime) {
  ASSERT_EQ(intersect(0.25, {"--picture", folder / "one.png"}).code, 0);
  ASSERT_EQ(intersect(0.25, {"--picture", folder / "two.png"}).code, 0);
  const std::string one = testing::text_of(folder / "one.png");
  EXPECT_EQ(one.substr(1, 3), "PNG");
  EXPECT_TRUE(one == testing::text_of(folder / "two.png"));
}

}  // namespace
}  // namespace blossom
