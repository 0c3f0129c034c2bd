// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom subdivide`: golden control points, faces of several spans, edges, and what is refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <gp_Cylinder.hxx>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"
#include "tests/support/golden.h"

namespace blossom::testing {
namespace {

Json plain_point(const Json& fractions) {
  Json numbers = Json::array();
  for (const Json& fraction : fractions) numbers.push_back(static_cast<double>(number(fraction)));
  return numbers;
}

Json plain_points(const Json& list) {
  Json result = Json::array();
  for (const Json& entry : list) result.push_back(plain_point(entry));
  return result;
}

// The largest distance of a coordinate in two lists of the same shape.
double gap(const Json& a, const Json& b) {
  if (a.is_number() && b.is_number()) return std::abs(a.get<double>() - b.get<double>());
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, gap(a[i], b[i]));
  return largest;
}

double signed_area(const Json& corners) {
  const auto side = [&](std::size_t k, std::size_t coordinate) {
    return corners[k][coordinate].get<double>() - corners[0][coordinate].get<double>();
  };
  return (side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0)) / 2;
}

class Subdivide : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder / name).string(); }

  Json pieces(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "subdivide");
    arguments.insert(arguments.end(), {"--json", "-"});
    const Finished ran = blossom(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    if (ran.code != 0) return {};
    const Json report = Json::parse(ran.out);
    EXPECT_EQ(report["schema"], "blossom.subdivision/1");
    EXPECT_EQ(report["pieces"], report["nets"].size());
    return report["nets"];
  }

  // Exit code 2, one line on stderr with this text, nothing written.
  void expect_refused(std::vector<std::string> arguments, const std::string& why) {
    const std::vector<std::string> before = folder.listing();
    arguments.insert(arguments.begin(), "subdivide");
    arguments.insert(arguments.end(), {"-o", path("never.json")});
    const Finished ran = blossom(arguments);
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find(why), std::string::npos) << ran.err;
    EXPECT_EQ(folder.listing(), before);
  }

  TestFolder folder;
};

// The surface of the examples of Vlachkova 2025 as monomial coefficients.
class SubdivideExample : public Subdivide {
 protected:
  SubdivideExample() {
    Json net = {{"schema", "blossom.net/1"}, {"kind", "patch"}, {"form", "monomial"}};
    net["degree"] = {tables["n"], tables["m"]};
    for (const Json& row : tables["coefficients"]) net["points"].push_back(plain_points(row));
    write_text(folder / "surface.json", net.dump());
  }

  void expect_rectangle(const char* name, const std::vector<std::string>& ends) {
    std::vector<std::string> arguments = {path("surface.json"), "--rectangle"};
    arguments.insert(arguments.end(), ends.begin(), ends.end());
    const Json made = pieces(arguments);
    ASSERT_EQ(made.size(), 1u);
    EXPECT_EQ(made[0]["form"], "bezier");
    EXPECT_EQ(made[0]["degree"], Json({3, 2}));
    EXPECT_EQ(made[0]["rational"], false);
    Json wanted = Json::array();
    for (const Json& row : tables[name]["control_points"]) wanted.push_back(plain_points(row));
    EXPECT_LE(gap(made[0]["points"], wanted), 4e-15);
  }

  void expect_triangle(const char* name, const std::vector<std::string>& corners) {
    std::vector<std::string> arguments = {path("surface.json"), "--triangle"};
    arguments.insert(arguments.end(), corners.begin(), corners.end());
    const Json made = pieces(arguments);
    ASSERT_EQ(made.size(), 1u);
    EXPECT_EQ(made[0]["kind"], "triangle");
    EXPECT_EQ(made[0]["degree"], 5);
    for (const Json& entry : tables[name]["control_points"]) {
      const Json& found = made[0]["points"][entry["nu"].get<std::size_t>()];
      EXPECT_LE(gap(found[entry["mu"].get<std::size_t>()], plain_point(entry["value"])), 4e-15);
    }
  }

  Json tables = read_golden("vlachkova_tables.json");
};

TEST_F(SubdivideExample, RectanglesHaveThePointsOfTable1) {
  expect_rectangle("S1", {"0", "1", "0", "1"});
  expect_rectangle("S2", {"0.33333333333333333", "0.66666666666666667", "0.25", "0.75"});
}

TEST_F(SubdivideExample, TrianglesHaveThePointsOfTable2) {
  expect_triangle("S3", {"0", "0", "1", "0", "0", "1"});
  expect_triangle("S4", {"0", "0.5", "0.5", "0", "0.5", "0.5"});
}

TEST_F(SubdivideExample, ReversedRectanglesReverseTheNet) {
  const Json there = pieces({path("surface.json"), "--rectangle", "0", "1", "0.5", "1"});
  Json back = pieces({path("surface.json"), "--rectangle", "1", "0", "0.5", "1"})[0]["points"];
  std::reverse(back.begin(), back.end());
  EXPECT_LE(gap(there[0]["points"], back), 4e-15);
}

TEST_F(SubdivideExample, LevelsShareTheirBordersBitForBit) {
  const Json made = pieces({path("surface.json"), "--levels", "2"});
  ASSERT_EQ(made.size(), 16u);
  EXPECT_EQ(made[1]["u"], Json({0, 0.25}));
  EXPECT_EQ(made[1]["v"], Json({0.25, 0.5}));
  EXPECT_EQ(made[0]["points"][3], made[4]["points"][0]);
  for (std::size_t i = 0; i <= 3; ++i)
    EXPECT_EQ(made[0]["points"][i][2], made[1]["points"][i][0]) << i;
}

TEST_F(SubdivideExample, LevelsOfTrianglesAreQuartersInTheirPlaces) {
  const std::vector<std::string> place = {
      path("surface.json"), "--triangle", "0", "0", "1", "0", "0", "1"};
  std::vector<std::string> levels = place;
  levels.insert(levels.end(), {"--levels", "1"});
  const Json made = pieces(levels);
  ASSERT_EQ(made.size(), 4u);
  // A triangle cut out of the triangle is that cut out of the patch.
  std::vector<std::string> arguments = {"subdivide", place[0]};
  arguments.insert(arguments.end(), place.begin() + 1, place.end());
  arguments.insert(arguments.end(), {"-o", path("whole.json"), "-q"});
  ASSERT_EQ(blossom(arguments).code, 0);
  const Json inner = pieces({path("whole.json"), "--levels", "1"});
  ASSERT_EQ(inner.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(made[k]["corners"], inner[k]["corners"]);
    EXPECT_EQ(signed_area(made[k]["corners"]), 0.125);
    EXPECT_LE(gap(made[k]["points"], inner[k]["points"]), 1e-14);
  }
}

// A curve of the golden data as a file of nets.
Json q_net(const Json& entry) {
  Json net = {{"schema", "blossom.net/1"}, {"kind", "curve"}, {"form", "q-bezier"}};
  net["degree"] = entry["n"];
  net["interval"] = plain_point({entry["a"], entry["b"]});
  net["q"] = plain_point({entry["q1"], entry["q2"]});
  net["points"] = plain_points(entry["control_points"]);
  return net;
}

TEST_F(Subdivide, QHalvesHaveTheGoldenPoints) {
  const Json golden = read_golden("qblossom_golden.json");
  int checked = 0;
  for (const Json& entry : golden["cases"]) {
    const Rational a = number(entry["a"]), b = number(entry["b"]);
    const Json q = {static_cast<double>(number(entry["q1"])),
                    static_cast<double>(number(entry["q2"]))};
    const Json& cut = entry["subdivision"];
    if (number(cut["t"]) * 2 != a + b) continue;
    if (!cut["left_admissible"].get<bool>() || !cut["right_admissible"].get<bool>()) continue;
    write_text(folder / "curve.json", q_net(entry).dump());
    const Json halves =
        pieces({path("curve.json"), "--levels", "1", "--q", q[0].dump(), q[1].dump()});
    ASSERT_EQ(halves.size(), 2u) << entry["label"];
    EXPECT_EQ(halves[0]["form"], "q-bezier");
    EXPECT_LE(gap(halves[0]["points"], plain_points(cut["left"])), 1e-11) << entry["label"];
    EXPECT_LE(gap(halves[1]["points"], plain_points(cut["right"])), 1e-11) << entry["label"];
    ++checked;
  }
  EXPECT_GE(checked, 7);
}

TEST_F(Subdivide, QCurveWithoutQGivesClassicalPoints) {
  const Json golden = read_golden("qblossom_golden.json");
  int checked = 0;
  for (const Json& entry : golden["cases"]) {
    write_text(folder / "curve.json", q_net(entry).dump());
    const Json made = pieces({path("curve.json")});
    ASSERT_EQ(made.size(), 1u) << entry["label"];
    const Json wanted = plain_points(entry["classical"]);
    double size = 1;
    for (const Json& p : wanted) size = std::max(size, gap(p, Json({0, 0, 0})));
    EXPECT_LE(gap(made[0]["points"], wanted), 1e-12 * size) << entry["label"];
    ++checked;
  }
  EXPECT_GE(checked, 10);
}

TEST_F(Subdivide, QPointsForOtherParametersAreOfTheSameCurve) {
  const Json golden = read_golden("qblossom_golden.json");
  const Json& entry = golden["cases"][2];
  write_text(folder / "curve.json", q_net(entry).dump());
  const Json made = pieces({path("curve.json"), "--q", "3", "3"});
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0]["q"], Json({3.0, 3.0}));
  EXPECT_LE(gap(made[0]["points"], plain_points(entry["classical"])), 1e-13);
}

TEST_F(Subdivide, TakesWeightsBesideThePoints) {
  write_text(folder / "curve.json", R"({"schema":"blossom.net/1","kind":"curve","degree":1,)"
                                    R"("points":[[1,0,4],[0,2,0]],"weights":[1,3]})");
  const Json made = pieces({path("curve.json"), "--interval", "0", "0.5"});
  EXPECT_EQ(made[0]["rational"], true);
  EXPECT_EQ(made[0]["points"], Json({{1, 0, 4, 1}, {0.5, 3, 2, 2}}));
  EXPECT_EQ(pieces({path("curve.json"), "--interval", "0,0.5"}), made) << "as points are written";
}

TEST_F(Subdivide, WritesPiecesOfARationalFaceWithItsName) {
  write({half_pipe(), bowl()}, folder / "pipe.step");
  const Finished ran = blossom({"subdivide", path("pipe.step") + "#1", "--rectangle", "0.25",
                                "0.75", "0", "1", "--levels", "1", "-o", path("out.step")});
  ASSERT_EQ(ran.code, 0) << ran.err;

  const occt::Model model = occt::read_model(path("out.step"));
  ASSERT_EQ(model.face_count(), 4);
  EXPECT_EQ(model.face_names()[0].rfind("part 1", 0), 0u) << model.face_names()[0];
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
  const Handle(Geom_Surface) whole = BRep_Tool::Surface(half_pipe());
  const Handle(Geom_Surface) first = BRep_Tool::Surface(model.face(1));
  EXPECT_LE(first->Value(0, 0).Distance(whole->Value(0.25, 0)), 1e-14);
  EXPECT_LE(first->Value(1, 1).Distance(whole->Value(0.5, 0.5)), 1e-14);
  EXPECT_LE(first->Value(0.5, 0.5).Distance(whole->Value(0.375, 0.25)), 1e-14);
}

TEST_F(Subdivide, ClipsTheRectangleToTheSpansOfAFace) {
  write({four_spans()}, folder / "spans.brep");
  const Json made = pieces({path("spans.brep"), "--rectangle", "0.5", "5", "1", "1.25"});
  ASSERT_EQ(made.size(), 2u);
  EXPECT_EQ(made[0]["u"], Json({0.5, 1}));
  EXPECT_EQ(made[1]["u"], Json({1, 2}));
  EXPECT_EQ(made[1]["v"], Json({1, 1.25}));
  EXPECT_EQ(made[1]["face"], 1);
  EXPECT_EQ(made[1]["points"][1][1], Json({2, 1.25, 0}));
}

TEST_F(Subdivide, TellsOfFacesAndEdgesThatDoNotFillThePlace) {
  write({four_spans()}, folder / "spans.brep");
  const Finished beyond = blossom({"subdivide", path("spans.brep"), "--rectangle", "0.5", "5", "1",
                                   "1.25", "--json", path("report.json")});
  EXPECT_NE(
      beyond.out.find("\n  face 1 does not fill the place, its parameters are u [0, 2] and v ["),
      std::string::npos)
      << beyond.out;
  EXPECT_EQ(Json::parse(testing::text_of(path("report.json")))["clipped"][0]["u"], Json({0, 2}));
  const Finished within =
      blossom({"subdivide", path("spans.brep"), "--rectangle", "0.5", "2", "1", "1.25"});
  EXPECT_EQ(within.out.find("does not fill"), std::string::npos) << within.out;
  const Finished edge =
      blossom({"subdivide", path("spans.brep") + "#edge:1", "--interval", "-9", "99"});
  EXPECT_NE(edge.out.find("\n  edge 1 does not fill the place, its parameters are ["),
            std::string::npos)
      << edge.out;
}

TEST_F(Subdivide, TakesAnglesOfACylinder) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 2), 0, 1.5, 0, 1).Face();
  write({face}, folder / "cylinder.brep");
  const Json made =
      pieces({path("cylinder.brep"), "--rectangle", "0.5", "1.25", "0", "1", "--levels", "1"});
  ASSERT_EQ(made.size(), 4u);
  EXPECT_EQ(made[0]["angle"], Json({true, false}));
  EXPECT_EQ(made[0]["u"][0], 0.5);
  EXPECT_EQ(made[2]["u"][1], 1.25);
  for (const Json& net : made)
    for (const std::size_t end : {0u, 1u}) {
      const double angle = net["u"][end].get<double>();
      const Json& p = net["points"][end * (net["points"].size() - 1)][0];
      EXPECT_NEAR(p[0].get<double>() / p[3].get<double>(), 2 * std::cos(angle), 1e-14);
      EXPECT_NEAR(p[1].get<double>() / p[3].get<double>(), 2 * std::sin(angle), 1e-14);
    }
}

TEST_F(Subdivide, CutsTheTriangleAtTheSpansOfAFace) {
  write({four_spans()}, folder / "spans.brep");
  const Json made =
      pieces({path("spans.brep"), "--triangle", "0.25", "0.25", "1.75", "0.5", "0.5", "2.5"});
  double area = 0;
  for (const Json& triangle : made) {
    const Json &a = triangle["corners"][0], &b = triangle["corners"][1],
               &c = triangle["corners"][2];
    area += signed_area(triangle["corners"]);
    // x = u, y = v; the vertices in the order b: q_{0N}, c: q_{00}, a: q_{N0}.
    EXPECT_LE(gap(triangle["points"][0][2], Json({b[0], b[1], 0})), 1e-15);
    EXPECT_LE(gap(triangle["points"][0][0], Json({c[0], c[1], 0})), 1e-15);
    EXPECT_LE(gap(triangle["points"][2][0], Json({a[0], a[1], 0})), 1e-15);
  }
  // The whole triangle without its tip above v = 2, which is there from `left` to `right` wide.
  const double whole = (1.5 * 2.25 - 0.25 * 0.25) / 2;
  const double left = 0.25 + 0.25 * (1.75 / 2.25), right = 1.75 - 1.25 * (1.5 / 2.0);
  EXPECT_NEAR(area, whole - (right - left) * 0.5 / 2, 1e-14);
}

TEST_F(Subdivide, TakesEdgesWithAnInterval) {
  write({lid(2)}, folder / "lid.brep");
  const Finished ran = blossom({"subdivide", path("lid.brep"), "--interval", "0.25", "0.75", "-o",
                                path("edges.brep"), "--json", path("edges.json")});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const Json nets = Json::parse(text_of(path("edges.json")))["nets"];
  ASSERT_EQ(nets.size(), 4u);
  for (const Json& net : nets) {
    EXPECT_EQ(net["interval"], Json({0.25, 0.75}));
    EXPECT_NEAR(gap(net["points"][0], net["points"][1]), 1.5, 1e-15);
  }
  EXPECT_EQ(nets[3]["edge"], 4);
  EXPECT_EQ(
      Json::parse(blossom({"info", path("edges.brep"), "--json", "-"}).out)["counts"]["edges"], 4);
}

TEST_F(Subdivide, DrawsPieces) {
  write({bowl()}, folder / "bowl.brep");
  const Finished ran = blossom(
      {"subdivide", path("bowl.brep"), "--levels", "1", "--picture", path("bowl.png"), "--quiet"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(text_of(path("bowl.png")).substr(1, 3), "PNG");
}

TEST_F(Subdivide, RefusesPlacesThatDoNotFit) {
  write({bowl()}, folder / "bowl.brep");
  write_text(folder / "curve.json",
             R"({"schema":"blossom.net/1","kind":"curve","degree":1,"points":[[0,0,0],[1,0,0]]})");
  expect_refused({path("bowl.brep"), "--rectangle", "2", "3", "0", "1"},
                 "bowl.brep: what is to be cut out lies outside of the parameters [0, 1] x [0, 1]");
  expect_refused({path("curve.json"), "--rectangle", "0", "1", "0", "1"},
                 "curve.json: net 1: it is a curve");
  expect_refused({path("curve.json"), "--q", "2", "1", "--levels", "1", "--interval", "1", "1"},
                 "curve.json: net 1: ");
  expect_refused({path("bowl.brep"), "--levels", "20"}, "more than a million pieces");
  expect_refused({path("bowl.brep"), "--levels", "1", "--rectangle", "0", "1", "0", "1",
                  "--triangle", "0", "0", "1", "0", "0", "1"},
                 "--triangle");
  expect_refused({path("curve.json") + "#2"}, "curve.json: there is no net 2 in it, it has 1 net");
}

TEST_F(Subdivide, SaysWhyThereIsNoBasis) {
  write_text(folder / "curve.json", R"({"schema":"blossom.net/1","kind":"curve","degree":2,)"
                                    R"("points":[[0,0,0],[1,0,0],[1,1,0]]})");
  expect_refused({path("curve.json"), "--q", "2", "1", "--levels", "1"}, "[0.5, 1]");
}

// A file of nets with something wrong, and what the message says about it.
struct BadNet {
  std::string text;
  std::string why;

  friend std::ostream& operator<<(std::ostream& out, const BadNet& net) { return out << net.why; }
};

class BadNets : public Subdivide, public ::testing::WithParamInterface<BadNet> {};

TEST_P(BadNets, AreRefusedWithTheCause) {
  write_text(folder / "bad.json", GetParam().text);
  expect_refused({path("bad.json")}, GetParam().why);
}

const char* const kHead = R"({"schema":"blossom.net/1","kind":)";

INSTANTIATE_TEST_SUITE_P(
    Texts, BadNets,
    ::testing::Values(
        BadNet{"", "bad.json: the file is empty"}, BadNet{"[1,", "bad.json: no JSON: "},
        BadNet{"{}", "\"schema\" is not \"blossom.net/1\""},
        BadNet{R"({"schema":"blossom.net/1","nets":[]})", "there is no net"},
        BadNet{R"({"schema":"blossom.net/1"})", "net 1: there is no \"kind\""},
        BadNet{std::string(kHead) + R"("cube"})", "not \"cube\""},
        BadNet{std::string(kHead) + R"("curve"})", "net 1: there is no \"degree\""},
        BadNet{std::string(kHead) + R"("curve","form":"spline"})", "not \"spline\""},
        BadNet{std::string(kHead) + R"("curve","degree":26})", "\"degree\" is not in 1..25"},
        BadNet{std::string(kHead) + R"("curve","degree":1})", "there is no \"points\""},
        BadNet{std::string(kHead) + R"("curve","degree":1,"points":[[0,0,0]]})",
               "\"points\" has 1 entry, the degree wants 2"},
        BadNet{std::string(kHead) + R"("curve","degree":1,"points":[[0,0,0],[1,1]]})",
               "points[1] is no list of 3 or 4 coordinates"},
        BadNet{std::string(kHead) + R"("curve","degree":1,"points":[[0,0,0],[1,1,"x"]]})",
               "a coordinate of points[1] is no number"},
        BadNet{std::string(kHead) + R"("curve","degree":1,"points":[[0,0,0],[1,1,1e999]]})",
               "no JSON"},
        BadNet{std::string(kHead) + R"("curve","degree":1,"points":[[0,0,0,1],[1,1,0,0]]})",
               "a weight is 0.0, weights must be positive"},
        BadNet{std::string(kHead) + R"("curve","degree":1,"points":[[0,0,0],[1,1,0,1]]})",
               "points[1] has another number of coordinates"},
        BadNet{
            std::string(kHead) + R"("curve","degree":1,"points":[[0,0,0],[1,1,0]],"weights":[1]})",
            "\"weights\" has 1 entry"},
        BadNet{std::string(kHead) +
                   R"("curve","degree":1,"points":[[0,0,0],[1,1,0]],"interval":[1,1]})",
               "\"interval\" has equal ends"},
        BadNet{std::string(kHead) +
                   R"("patch","degree":[1,1],"points":[[[0,0,0],[0,1,0]],[[1,0,0]]]})",
               "points[1] has 1 entry, the degree wants 2"},
        BadNet{std::string(kHead) +
                   R"("curve","form":"q-bezier","degree":1,"points":[[0,0,0],[1,1,0]]})",
               "there is no \"q\""},
        BadNet{std::string(kHead) +
                   R"("curve","form":"monomial","scale":0,"degree":1,"points":[[0,0,0],[1,1,0]]})",
               "\"scale\" is 0"},
        BadNet{std::string(kHead) + R"("triangle","form":"monomial","degree":1,"points":[]})",
               "a triangle has the form \"bezier\""},
        BadNet{std::string(kHead) + R"("triangle","degree":1,"points":[[[0,0,0]],[[1,0,0]]]})",
               "points[0] has 1 entry, the degree wants 2"}));

}  // namespace
}  // namespace blossom::testing
