// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom convert`: formats with names and colours, forms there and back, what is refused.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/faces/area.h"
#include "adapters/occt/shapes.h"
#include "core/forms/algebra/conversion.h"
#include "core/math/functions/quadrature.h"
#include "tests/plugin/cli/program.h"

namespace blossom::testing {
namespace {

class Convert : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder / name).string(); }

  // Converts and returns the report.
  nlohmann::json convert(const std::string& from, const std::string& to,
                         const std::string& form = {}) {
    std::vector<std::string> arguments = {"convert", path(from), "-o", path(to), "--json", "-"};
    if (!form.empty()) arguments.insert(arguments.end(), {"--to", form});
    const Finished ran = blossom(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.code == 0 ? nlohmann::json::parse(ran.out) : nlohmann::json();
  }

  nlohmann::json nets_of(const std::string& name) {
    return nlohmann::json::parse(text_of(path(name)))["nets"];
  }

  TestFolder folder;
};

double point_gap(const nlohmann::json& a, const nlohmann::json& b) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    largest = std::max(largest, std::abs(a[k].get<double>() - b[k].get<double>()));
  return largest;
}

TEST_F(Convert, KeepsNamesAndColoursBetweenModels) {
  occt::quiet_messages();
  occt::Model model;
  model.add(bowl(), "bowl", {0.25, 0.5, 0.75});
  model.add(lid(1), "lid");
  occt::write_model(model, path("a.step"));

  const nlohmann::json report = convert("a.step", "b.stp");

  EXPECT_EQ(report["schema"], "blossom.conversion/1");
  EXPECT_EQ(report["faces"], 2);
  EXPECT_EQ(report["to"], nullptr);
  EXPECT_EQ(occt::read_model(path("b.stp")).face_names(),
            (std::vector<std::string>{"bowl", "lid"}));
  EXPECT_NE(text_of(path("b.stp")).find("COLOUR_RGB"), std::string::npos);
}

TEST_F(Convert, RefusesAFaceWithAnOpenWire) {
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp::XOY()), 1e-7);
  const TopoDS_Wire wire =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Edge(),
                              BRepBuilderAPI_MakeEdge(gp_Pnt(1, 0, 0), gp_Pnt(1, 1, 0)).Edge());
  builder.Add(face, wire);
  write({BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1).Face(), face}, path("open.brep"));

  for (const char* to : {"open.step", "open.iges", "copy.brep"}) {
    const Finished ran = blossom({"convert", path("open.brep"), "-o", path(to)});
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("a wire of face 2 is open"), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(path(to)));
  }
  const Finished other = blossom({"convert", path("open.brep#1"), "-o", path("one.step")});
  EXPECT_EQ(other.code, 0) << other.err;
}

// An edge without any curve, of which none can be made.
TEST_F(Convert, LeavesOutAFaceThatStepHasNoWayToSay) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  const TopoDS_Face round = TopoDS::Face(TopExp_Explorer(rod, TopAbs_FACE).Current());
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(round, TopAbs_EDGE).Current());
  const BRep_Builder builder;
  builder.UpdateEdge(edge, Handle(Geom2d_Curve)(), round, BRep_Tool::Tolerance(edge));
  builder.UpdateEdge(edge, Handle(Geom_Curve)(), BRep_Tool::Tolerance(edge));
  occt::Model model;
  model.add(rod, "rod");
  model.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "box");
  occt::write_model(model, path("rod.brep"));
  const Finished ran = blossom({"convert", path("rod.brep"), "-o", path("rod.step")});
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_NE(ran.err.find("rod.step: written without face 1, whose edge 1 has no curve"),
            std::string::npos)
      << ran.err;
  EXPECT_EQ(occt::read_model(path("rod.step")).face_count(), 8);
}

TEST_F(Convert, KeepsAFaceWithAWireOfInnerEdges) {
  BRep_Builder builder;
  TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1).Face();
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(gp_Pnt(0.2, 0.5, 0), gp_Pnt(0.8, 0.5, 0)).Edge();
  builder.Add(wire, edge.Oriented(TopAbs_INTERNAL));
  builder.Add(face, wire);
  write({face}, path("inner.brep"));

  convert("inner.brep", "copy.brep");
  const TopoDS_Face kept = occt::read_model(path("copy.brep")).face(1);
  int inner = 0;
  for (TopExp_Explorer it(kept, TopAbs_EDGE); it.More(); it.Next())
    inner += it.Current().Orientation() == TopAbs_INTERNAL;
  EXPECT_EQ(inner, 1);

  convert("inner.brep", "copy.step");
  EXPECT_NEAR(occt::area(occt::read_model(path("copy.step")).face(1)), 1, 1e-12);
}

TEST_F(Convert, GoesThroughEveryModelFormat) {
  write({bowl()}, folder / "a.step");
  convert("a.step", "b.brep");
  convert("b.brep", "c.iges");
  convert("c.iges", "d.step");
  const occt::Model model = occt::read_model(path("d.step"));
  ASSERT_EQ(model.face_count(), 1);
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(model.face(1));
  EXPECT_LE(surface->Value(0.5, 0.25).Distance(gp_Pnt(0, -0.5, 0.25)), 1e-14);
}

TEST_F(Convert, TakesOnlyTheChosenFaces) {
  write({bowl(), lid(1), lid(2)}, folder / "a.step");
  convert("a.step#1,3", "b.step");
  EXPECT_EQ(occt::read_model(path("b.step")).face_names(),
            (std::vector<std::string>{"part 1", "part 3"}));
}

TEST_F(Convert, SplitsFacesIntoBezierPatches) {
  write({four_spans(), half_pipe()}, folder / "a.step");
  const nlohmann::json report = convert("a.step", "b.brep", "bezier");
  EXPECT_EQ(report["faces"], 2);
  EXPECT_EQ(report["nets"], 5);
  EXPECT_EQ(report["error"], 0);

  const occt::Model model = occt::read_model(path("b.brep"));
  ASSERT_EQ(model.face_count(), 5);
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
  for (int number = 1; number <= 5; ++number) {
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(model.face(number));
    EXPECT_TRUE(surface->IsKind(STANDARD_TYPE(Geom_BezierSurface))) << number;
  }
}

TopoDS_Face disc() {
  const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(gp::XOY(), 1));
  return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(circle).Wire());
}

TEST_F(Convert, SaysHowManyFacesLostTheirTrims) {
  write({disc(), bowl(), half_pipe(), four_spans()}, folder / "a.brep");
  EXPECT_EQ(convert("a.brep", "t.json", "monomial")["trims_left_out"], 1);
  EXPECT_EQ(convert("a.brep", "c.step")["trims_left_out"], 0);

  const Finished ran = blossom({"convert", path("a.brep"), "-o", path("b.json")});
  EXPECT_NE(ran.out.find(", the trims of 1 face left out"), std::string::npos) << ran.out;
}

TEST_F(Convert, FollowsTheTrimsOfADiscExactly) {
  write({disc(), bowl()}, folder / "a.brep");
  for (const char* form : {"bezier", "triangles"}) {
    const nlohmann::json report = convert("a.brep", "b.brep", form);
    EXPECT_EQ(report["trims_left_out"], 0);
    ASSERT_EQ(report["trimmed"].size(), 1u);
    const nlohmann::json& face = report["trimmed"][0];
    EXPECT_EQ(face["face"], 1);
    EXPECT_EQ(face["fitted"], 0);
    EXPECT_EQ(face["border_error"], 0);
    EXPECT_GT(face["exact"], 4);
  }
  // Triangles of bidegree (1, 1) under arcs of degree 2: every point of the circle's arcs.
  convert("a.brep", "t.json", "triangles");
  int on_circle = 0;
  for (const nlohmann::json& net : nets_of("t.json")) {
    if (net["kind"] != "triangle" || net["degree"] != 4 || net["face"] != 1) continue;
    EXPECT_TRUE(net["rational"]);
    for (const nlohmann::json& corner :
         {net["points"][4][0], net["points"][0][0], net["points"][0][4]}) {
      const double w = corner[3].get<double>();
      const double r = std::hypot(corner[0].get<double>(), corner[1].get<double>()) / w;
      on_circle += std::abs(r - 1) < 1e-14 ? 1 : 0;
    }
  }
  EXPECT_GE(on_circle, 16);
  const Finished ran = blossom({"convert", path("a.brep"), "-o", path("b.brep"), "--to", "bezier"});
  EXPECT_NE(ran.out.find("face 1: "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find(" exact pieces, 0 fitted\n"), std::string::npos) << ran.out;
}

// Of trimmed faces, and of untrimmed ones with one rule over all of each.
double trimmed_area(const occt::Model& model) {
  double sum = 0;
  for (int number = 1; number <= model.face_count(); ++number)
    sum += occt::area(model.face(number));
  return sum;
}
double untrimmed_area(const occt::Model& model) {
  double sum = 0;
  for (int number = 1; number <= model.face_count(); ++number) {
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(model.face(number));
    auto strip = [&](double u) {
      auto density = [&](double v) {
        gp_Pnt point;
        gp_Vec du, dv;
        surface->D1(u, v, point, du, dv);
        return du.Crossed(dv).Magnitude();
      };
      return quadrature::cell(density, 0, 1).value;
    };
    sum += quadrature::cell(strip, 0, 1).value;
  }
  return sum;
}

// A box, a sphere and a cylinder drilled: circles, seams, poles and intersection
// curves as trims. The pieces have the area of the faces.
class ConvertTrimmed : public Convert, public ::testing::WithParamInterface<int> {
 protected:
  static TopoDS_Shape drilled(int which) {
    const gp_Ax2 slanted(gp_Pnt(-2, 0.2, 0.1), gp_Dir(1, 0.1, 0.2));
    const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(slanted, 0.35, 4);
    switch (which) {
      case 0: return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, -1), 2, 2, 2), drill);
      case 1: return BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(1), drill);
      default: return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(1, 1), drill);
    }
  }
};

TEST_P(ConvertTrimmed, PiecesHaveTheAreaOfTheFaces) {
  occt::Model given;
  given.add(drilled(GetParam()), "drilled");
  occt::write_model(given, path("a.brep"));
  const double area = trimmed_area(given);

  const bool step = GetParam() % 2 == 0;
  const char* const file = step ? "b.step" : "b.brep";
  const nlohmann::json report = convert("a.brep", file, step ? "bezier" : "triangles");

  ASSERT_FALSE(report.is_null());
  EXPECT_EQ(report["trims_left_out"], 0);
  for (const nlohmann::json& face : report["trimmed"]) EXPECT_LE(face["border_error"], 1e-6);
  const occt::Model model = occt::read_model(path(file));
  EXPECT_EQ(model.face_count(), report["nets"]);
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
  EXPECT_NEAR(untrimmed_area(model), area, 1e-6 * area);
}

INSTANTIATE_TEST_SUITE_P(Shapes, ConvertTrimmed, ::testing::Range(0, 3));

TEST_F(Convert, BezierNetsComeBackBitForBit) {
  write({bowl()}, folder / "a.brep");
  convert("a.brep", "a.json");
  convert("a.json", "b.brep");
  convert("b.brep", "b.json");
  EXPECT_EQ(nets_of("a.json")[0]["points"], nets_of("b.json")[0]["points"]);
  EXPECT_EQ(nets_of("a.json")[0]["points"][1][1], nlohmann::json({0.0, 0.0, -2.0}));
  convert("b.json", "c.json");
  EXPECT_EQ(nets_of("b.json")[0]["points"], nets_of("c.json")[0]["points"]);
}

TEST_F(Convert, MonomialFormIsReCentred) {
  write({bowl()}, folder / "a.brep");
  convert("a.brep", "m.json", "monomial");
  const nlohmann::json net = nets_of("m.json")[0];
  EXPECT_EQ(net["form"], "monomial");
  EXPECT_EQ(net["centre"], nlohmann::json({0.5, 0.5}));
  EXPECT_EQ(net["scale"], nlohmann::json({0.5, 0.5}));
  // x = s, y = t, z = s^2 + t^2 for s = 2 u - 1, t = 2 v - 1.
  EXPECT_EQ(net["points"][0][0], nlohmann::json({0.0, 0.0, 0.0}));
  EXPECT_EQ(net["points"][1][0], nlohmann::json({1.0, 0.0, 0.0}));
  EXPECT_EQ(net["points"][2][0], nlohmann::json({0.0, 0.0, 1.0}));
  EXPECT_EQ(net["points"][0][2], nlohmann::json({0.0, 0.0, 1.0}));
}

TEST_F(Convert, RationalMonomialFormComesBackWithinItsBound) {
  write({half_pipe()}, folder / "a.brep");
  convert("a.brep", "a.json", "bezier");
  convert("a.json", "m.json", "monomial");
  convert("m.json", "b.json", "bezier");
  const nlohmann::json a = nets_of("a.json")[0], b = nets_of("b.json")[0];
  EXPECT_EQ(a["rational"], true);
  EXPECT_EQ(a["points"][0][0].size(), 4u);
  for (std::size_t i = 0; i <= 3; ++i)
    for (std::size_t j = 0; j <= 1; ++j)
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(a["points"][i][j][k].get<double>(), b["points"][i][j][k].get<double>(),
                    2 * round_trip_error(3, 1, Origin::Middle));
}

TEST_F(Convert, MonomialFormsAreInTheParametersOfTheirSpans) {
  write({four_spans()}, folder / "a.brep");
  convert("a.brep", "m.json", "monomial");
  const nlohmann::json net = nets_of("m.json")[2];
  EXPECT_EQ(net["u"], nlohmann::json({1, 2}));
  EXPECT_EQ(net["centre"], nlohmann::json({1.5, 0.5}));
  EXPECT_EQ(net["scale"], nlohmann::json({0.5, 0.5}));
  EXPECT_EQ(net["points"][0][0], nlohmann::json({1.5, 0.5, 0.0}));
  convert("m.json", "b.json", "bezier");
  EXPECT_EQ(nets_of("b.json")[2]["points"][1][0], nlohmann::json({2.0, 0.0, 0.0}));
}

TEST_F(Convert, MonomialFormsScaleWithTheDomainOfTheNet) {
  write_text(folder / "a.json",
             R"({"schema":"blossom.net/1","kind":"patch","degree":[1,1],"u":[1,4],"v":[-2,2],)"
             R"("points":[[[0,0,0],[0,1,0]],[[6,0,0],[6,1,0]]]})");
  convert("a.json", "m.json", "monomial");
  const nlohmann::json net = nets_of("m.json")[0];
  EXPECT_EQ(net["centre"], nlohmann::json({2.5, 0.0}));
  EXPECT_EQ(net["scale"], nlohmann::json({1.5, 2.0}));
  convert("m.json", "b.json", "bezier");
  EXPECT_EQ(nets_of("b.json")[0]["points"][1][1], nlohmann::json({6.0, 1.0, 0.0}));
}

TEST_F(Convert, KeepsTheOrientationOfFaces) {
  write({TopoDS::Face(lid(1).Reversed()), lid(2)}, folder / "a.brep");
  convert("a.brep", "b.brep", "triangles");
  const occt::Model model = occt::read_model(path("b.brep"));
  ASSERT_EQ(model.face_count(), 4);
  EXPECT_EQ(model.face(1).Orientation(), TopAbs_REVERSED);
  EXPECT_EQ(model.face(3).Orientation(), TopAbs_FORWARD);
}

TEST_F(Convert, MakesTwoTrianglesOfAPatchThatShareTheDiagonal) {
  write({bowl()}, folder / "a.brep");
  EXPECT_EQ(convert("a.brep", "t.json", "triangles")["nets"], 2);
  const nlohmann::json nets = nets_of("t.json");
  EXPECT_EQ(nets[0]["degree"], 4);
  EXPECT_EQ(nets[0]["corners"], nlohmann::json({{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(nets[1]["corners"], nlohmann::json({{1, 1}, {0, 1}, {1, 0}}));
  // The diagonal has no part of the first corner: row 0, from c to b and from b to c.
  for (std::size_t k = 0; k <= 4; ++k)
    EXPECT_LE(point_gap(nets[0]["points"][0][k], nets[1]["points"][0][4 - k]), 1e-15);
}

TEST_F(Convert, WritesTrianglesAsCollapsedPatches) {
  write({half_pipe()}, folder / "a.step");
  EXPECT_EQ(convert("a.step", "t.step", "triangles")["nets"], 2);
  const occt::Model model = occt::read_model(path("t.step"));
  ASSERT_EQ(model.face_count(), 2);
  EXPECT_EQ(model.face_names()[0].rfind("part 1", 0), 0u) << model.face_names()[0];
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
  // The corners of the lower left half are (0, 0), (1, 0), (0, 1); the last is the collapsed side.
  const Handle(Geom_Surface) whole = BRep_Tool::Surface(half_pipe());
  const Handle(Geom_Surface) half = BRep_Tool::Surface(model.face(1));
  for (const double v : {0.0, 0.25, 1.0})
    EXPECT_LE(half->Value(0, v).Distance(whole->Value(0, 1)), 1e-14);
  for (const double u : {0.25, 0.5, 1.0})
    for (const double v : {0.0, 0.5, 1.0})
      EXPECT_LE(half->Value(u, v).Distance(whole->Value(u * v, 1 - u)), 1e-14);
}

TEST_F(Convert, TrianglesAtAPoleSurviveAStepFile) {
  write_text(folder / "pole.json",
             R"({"schema":"blossom.net/1","kind":"patch","degree":[2,2],"points":[)"
             R"([[0,0,0],[1,0,1],[2,0,0]],[[0,1,1],[1,1,2],[2,1,1]],[[1,2,0],[1,2,0],[1,2,0]]]})");
  convert("pole.json", "pole.step", "triangles");
  const nlohmann::json info =
      nlohmann::json::parse(blossom({"info", path("pole.step"), "--json", "-"}).out);
  EXPECT_EQ(info["counts"]["faces"], 2);
  EXPECT_EQ(info["counts"]["edges"], 8);
  EXPECT_EQ(info["valid"], true);
  EXPECT_LE(info["tolerance"]["largest"], 1e-6);
}

TEST_F(Convert, RefusesFormsThatThereAreNot) {
  write({bowl()}, folder / "a.brep");
  write_text(folder / "curve.json",
             R"({"schema":"blossom.net/1","kind":"curve","degree":1,"points":[[0,0,0],[1,0,0]]})");
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& why) {
    const std::vector<std::string> before = folder.listing();
    const Finished ran = blossom(arguments);
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find(why), std::string::npos) << ran.err;
    EXPECT_EQ(folder.listing(), before);
  };
  refused({"convert", path("a.brep"), "-o", path("b.step"), "--to", "monomial"},
          "models have no monomial form");
  refused({"convert", path("curve.json"), "-o", path("b.json"), "--to", "triangles"},
          "curve.json: net 1: a curve cannot become triangles");
  refused({"convert", path("a.brep") + "#2", "-o", path("b.step")},
          "a.brep: there is no face 2 in it");
  refused({"convert", path("none.json"), "-o", path("b.step")}, "none.json: there is no such file");
}

}  // namespace
}  // namespace blossom::testing
