// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/watertight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/faces/watertight_faces.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "core/blossom/triangle_composition.h"
#include "tests/adapters/occt/exchange/shapes_files.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  const SolidTrimResult made = trim_solids(trim_tool(a), {trim_tool(b)}, SolidOperation::Fuse);
  for (const std::string& obstacle : made.obstacles) ADD_FAILURE() << obstacle;
  return made.solids.empty() ? TopoDS_Shape() : TopoDS_Shape(made.solids.front());
}

TopoDS_Shape two_spheres() {
  return fused(BRepPrimAPI_MakeSphere(1), BRepPrimAPI_MakeSphere(gp_Pnt(0.7, 0.2, 0.3), 0.8));
}
TopoDS_Shape two_boxes() {
  return fused(BRepPrimAPI_MakeBox(2, 2, 2), BRepPrimAPI_MakeBox(gp_Pnt(1, 0.5, 0.7), 3, 1, 1));
}
TopoDS_Shape box_and_cylinder() {
  const gp_Ax2 axis(gp_Pnt(1, 1, 1), gp_Dir(0.2, 0.1, 1));
  return fused(BRepPrimAPI_MakeBox(2, 2, 2), BRepPrimAPI_MakeCylinder(axis, 0.6, 3));
}

BezierCurve side_curve(const WatertightPiece& piece, std::size_t k) {
  const auto* triangle = std::get_if<BezierTriangle>(&piece.form);
  EXPECT_NE(triangle, nullptr) << "only triangles are at edges";
  BezierCurve curve = triangle
                          ? side_of(*triangle, static_cast<int>(k), static_cast<int>((k + 1) % 3))
                          : BezierCurve{};
  if (!piece.along[k]) std::ranges::reverse(curve.points);
  return curve;
}

// Along every edge both triangles have the control points of the side, bit for bit.
int expect_common_points(const WatertightPieces& made) {
  std::map<int, int> uses;
  int common = 0;
  for (const WatertightPiece& piece : made.pieces)
    for (std::size_t k = 0; k < piece.sides.size(); ++k) {
      const WatertightSide& side = made.sides[static_cast<std::size_t>(piece.sides[k])];
      ++uses[piece.sides[k]];
      if (side.edge < 0 || side.curve.points.empty()) continue;
      EXPECT_EQ(side_curve(piece, k).points, side.curve.points);
      ++common;
    }
  for (const auto& [number, count] : uses) {
    const bool point = made.sides[static_cast<std::size_t>(number)].curve.points.empty();
    EXPECT_EQ(count, point ? 1 : 2);
  }
  return common;
}

void expect_sound(const WatertightShape& made, double tolerance) {
  ASSERT_TRUE(made.pieces.obstacle.empty()) << made.pieces.obstacle;
  EXPECT_GT(expect_common_points(made.pieces), 8);
  EXPECT_LE(made.pieces.deviation, tolerance);
  ASSERT_EQ(made.shape.ShapeType(), TopAbs_SOLID);
  EXPECT_TRUE(BRepCheck_Analyzer(made.shape).IsValid());
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndAncestors(made.shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  for (int k = 1; k <= faces_of_edge.Extent(); ++k)
    EXPECT_EQ(faces_of_edge(k).Extent(),
              BRep_Tool::Degenerated(TopoDS::Edge(faces_of_edge.FindKey(k))) ? 1 : 2);
}

TEST(Watertight, SpheresFusedHaveCommonControlPoints) {
  expect_sound(watertight(two_spheres()), 2e-6);
}

TEST(Watertight, BoxesFusedHaveCommonControlPoints) { expect_sound(watertight(two_boxes()), 1e-6); }

TEST(Watertight, ABoxAndACylinderFusedHaveCommonControlPoints) {
  expect_sound(watertight(box_and_cylinder()), 2e-6);
}

// The plane passes the poles by 2e-8, where its cut sweeps over half a turn of the sphere's chart.
TEST(Watertight, ASphereCutBesideItsPolesHasCommonControlPoints) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), std::numbers::pi / 4);
  const gp_Pnt low(-2e-8, -3.1, -3.2), high(3.3, 3.4, 3.5);
  const TopoDS_Shape box =
      BRepBuilderAPI_Transform(BRepPrimAPI_MakeBox(low, high).Shape(), turn, true).Shape();
  const SolidTrimResult made =
      trim_solids(trim_tool(BRepPrimAPI_MakeSphere(1)), {trim_tool(box)}, SolidOperation::Cut);
  ASSERT_EQ(made.solids.size(), 1u);
  expect_sound(watertight(made.solids.front()), 2e-6);
}

// A shell of the faces of a shape but the first ones.
TopoDS_Shape shell_without(const TopoDS_Shape& shape, int left_out) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (left_out-- <= 0) builder.Add(shell, it.Current());
  return shell;
}

TEST(Watertight, RefusesPiecesThatDoNotCloseOrAreNotValid) {
  const TopoDS_Shape box = shell_without(BRepPrimAPI_MakeBox(1, 2, 3), 0);
  EXPECT_EQ(watertight_fault(box, box), "");
  const TopoDS_Shape open = shell_without(box, 1);
  EXPECT_NE(watertight_fault(box, open).find("do not close"), std::string::npos);
  EXPECT_EQ(watertight_fault(open, open), "");  // open as it was

  const TopoDS_Shape bent = BRepPrimAPI_MakeBox(1, 2, 3);
  BRep_Builder().UpdateVertex(TopoDS::Vertex(TopExp_Explorer(bent, TopAbs_VERTEX).Current()),
                              gp_Pnt(9, 9, 9), 1e-7);
  const TopoDS_Shape invalid = shell_without(bent, 0);
  EXPECT_NE(watertight_fault(box, invalid).find("BRepCheck"), std::string::npos);
}

// Reading, dividing and writing ask; the last question is before the check by BRepCheck.
TEST(Watertight, EndsWhereItIsTold) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3);
  struct Ended {};
  int asked = 0;
  WatertightOptions options;
  options.ask = [&asked] { return ++asked > 0; };
  ASSERT_EQ(watertight(box, options).pieces.obstacle, "");
  for (int left : {0, asked / 2, asked - 1}) {
    int goes_on = left;
    options.ask = [&goes_on] { return goes_on-- > 0; };
    const WatertightShape made = watertight(box, options);
    EXPECT_TRUE(made.shape.IsNull());
    EXPECT_NE(made.pieces.obstacle, "");
    EXPECT_FALSE(made.pieces.open.empty());

    options.ask = [&left] { return left-- == 0 ? throw Ended() : true; };
    EXPECT_THROW(watertight(box, options), Ended);
  }
}

TEST(Watertight, KeepsSharedEdgesInBrepFiles) {
  const WatertightShape made = watertight(two_boxes());
  Model model;
  model.add(made.shape, "boxes");
  const testing::Folder folder;
  const auto file = folder / "watertight_boxes.brep";
  write_model(model, file);

  const Model back = read_model(file);
  TopTools_IndexedMapOfShape given, edges;
  TopExp::MapShapes(made.shape, TopAbs_EDGE, given);
  TopExp::MapShapes(back.shape(), TopAbs_EDGE, edges);
  EXPECT_EQ(edges.Extent(), given.Extent());
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape()).IsValid());
}

// Faces that share no edge: each is a copy of its own.
TopoDS_Shape loose_faces(const TopoDS_Shape& shape) {
  BRep_Builder builder;
  TopoDS_Compound loose;
  builder.MakeCompound(loose);
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    builder.Add(loose, BRepBuilderAPI_Copy(it.Current()).Shape());
  return loose;
}

TEST(Watertight, JoinsFacesWhoseEdgesRunAlongEachOther) {
  const WatertightShape made = watertight(loose_faces(two_spheres()));
  ASSERT_EQ(made.pieces.obstacle, "");
  EXPECT_GT(expect_common_points(made.pieces), 8);  // and every side has two pieces
  EXPECT_LE(made.pieces.deviation, 2e-6);
}

// Nothing says which of the two sides of a face that is turned against its neighbours is inside.
TEST(Watertight, DoesNotJoinFacesThatAreTurnedAgainstEachOther) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3);
  BRep_Builder builder;
  TopoDS_Compound loose;
  builder.MakeCompound(loose);
  bool first = true;
  for (TopExp_Explorer it(loose_faces(box), TopAbs_FACE); it.More(); it.Next(), first = false)
    builder.Add(loose, first ? it.Current().Reversed() : it.Current());
  const WatertightShape made = watertight(loose);
  ASSERT_EQ(made.pieces.obstacle, "");
  std::map<int, int> uses;
  for (const WatertightPiece& piece : made.pieces.pieces)
    for (const int side : piece.sides) ++uses[side];
  std::set<int> of_one, of_two;
  for (const auto& [side, count] : uses)
    (count == 1 ? of_one : of_two).insert(made.pieces.sides[static_cast<std::size_t>(side)].edge);
  of_two.erase(-1);              // inside of faces
  EXPECT_EQ(of_one.size(), 8u);  // four edges, twice
  EXPECT_EQ(of_two.size(), 8u);
}

// A triangle on z = x y + x (1 - x) / 20; its side at x = 1 is as long as the width, about.
WatertightPieces sliver(double width, int edge_of_short_side) {
  WatertightPieces pieces;
  pieces.vertices = {{1, 0, 0}, {1, width, width}, {0, 0, 0}};
  BezierTriangle form{2, {}};
  for (int nu = 0; nu <= 2; ++nu)
    for (int mu = 0; nu + mu <= 2; ++mu) {
      const double x = 0.5 * (nu + mu), y = 0.5 * mu;            // of the control points' places
      const double blossom = 0.5 * ((nu * mu) + mu * (mu - 1));  // of x y / width
      form.points.push_back({x, width * y, width * blossom + (2 - nu - mu) * (nu + mu) / 40.0});
    }
  WatertightPiece piece{0, form, {0, 1, 2}, {0, 1, 2}, {true, true, true}, 0};
  for (int k = 0; k < 3; ++k)
    pieces.sides.push_back(
        {k == 0 ? edge_of_short_side : -1, k, (k + 1) % 3, side_of(form, k, (k + 1) % 3)});
  pieces.pieces.push_back(std::move(piece));
  return pieces;
}

// Nodes inside, off the chords of both long sides, would stick out through the facets beside them.
TEST(Watertight, ASliverIsMeshedWithoutNodesInside) {
  for (const int edge : {-1, 7}) {
    const WatertightPieces pieces = sliver(1.4e-5, edge);
    PieceFaces writer(pieces);
    const TopoDS_Face face = writer.face_of(pieces.pieces.front());
    EXPECT_TRUE(BRepCheck_Analyzer(face).IsValid());
    EXPECT_LE(writer.flattened(), 1e-13);
    const BRepMesh_IncrementalMesh mesher(face, 0.1);
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    ASSERT_FALSE(mesh.IsNull());
    EXPECT_EQ(mesh->NbTriangles(), 1) << "edge " << edge;
  }
}

// On both sides of the point facets would have a node of their own between the same two corners.
TEST(Watertight, ATriangleAtAPoleIsMeshedWithoutNodesInside) {
  WatertightPieces pieces;
  pieces.vertices = {{0, 0, 0}, {1, 0, 0}};
  // a and b are the pole; both long sides bend, one upwards, one sideways.
  const BezierTriangle form{
      2, {{1, 0, 0}, {0.5, 0.1, 0}, {0, 0, 0}, {0.5, 0, 0.1}, {0, 0, 0}, {0, 0, 0}}};
  WatertightPiece piece{0, form, {0, 0, 1}, {0, 1, 2}, {true, true, true}, 0};
  pieces.sides = {{5, 0, 0, {}}, {-1, 0, 1, side_of(form, 1, 2)}, {6, 1, 0, side_of(form, 2, 0)}};
  pieces.pieces.push_back(std::move(piece));
  PieceFaces writer(pieces);
  const TopoDS_Face face = writer.face_of(pieces.pieces.front());
  EXPECT_TRUE(BRepCheck_Analyzer(face).IsValid());
  const BRepMesh_IncrementalMesh mesher(face, 0.2, false, 3);
  TopLoc_Location location;
  const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
  ASSERT_FALSE(mesh.IsNull());
  EXPECT_EQ(mesh->NbTriangles(), 1);
}

// A face of a real model that takes several rounds of dividing its edges.
TEST(Watertight, DividesTheEdgesOfABladeAgain) {
  const char* folder = blossom::testing::test_data();
  if (!folder) GTEST_SKIP() << blossom::testing::kNoTestData;
  const Model model = testing::repaired_model(std::string(folder) + "/models/propeller.brep");
  WatertightOptions options;
  options.tolerance = 1e-3;
  const WatertightShape made = watertight(model.face(2), options);
  EXPECT_EQ(made.pieces.obstacle, "");
  EXPECT_GT(made.pieces.pieces.size(), 10u);
  EXPECT_TRUE(BRepCheck_Analyzer(made.shape).IsValid());
}

// Straight arcs alone, as the degrees of its blades would have it, were refused: more than 5000 on
// one border.
TEST(Watertight, TakesABladeOfHighDegree) {
  const char* folder = blossom::testing::test_data();
  if (!folder) GTEST_SKIP() << blossom::testing::kNoTestData;
  const Model model = testing::repaired_model(std::string(folder) + "/models/propeller.brep");
  WatertightOptions options;
  options.tolerance = 1e-5;
  const WatertightShape made = watertight(model.face(25), options);
  EXPECT_EQ(made.pieces.obstacle, "");
  EXPECT_LT(made.pieces.pieces.size(), 400u);
}

// Its edges are up to 6e-3 off its faces, and lines between patches end next to each other.
TEST(Watertight, LetsTheFacesOfABodyAgreeOnTheirEdges) {
  const char* folder = blossom::testing::test_data();
  if (!folder) GTEST_SKIP() << blossom::testing::kNoTestData;
  const Model model = testing::repaired_model(std::string(folder) + "/models/s1_mainbody_back.stp");
  WatertightOptions options;
  options.tolerance = 1e-4;
  expect_sound(watertight(model.shape(), options), 1e-2);
}

// The same solid comes back, closed along the same number of edges, from a file that is no larger
// than so many patches need.
void expect_survives_step(const TopoDS_Shape& solid) {
  quiet_messages();
  const WatertightShape made = watertight(solid);
  ASSERT_EQ(made.pieces.obstacle, "");
  Model model;
  model.add(made.shape, "solid");
  const testing::Folder folder;
  const auto file = folder / "watertight_solid.step";
  write_model(model, file);
  EXPECT_LT(std::filesystem::file_size(file), 10000 * made.pieces.pieces.size());

  const Model back = read_model(file);
  ASSERT_EQ(back.shape().ShapeType(), TopAbs_SOLID);
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape()).IsValid());
  EXPECT_EQ(back.face_count(), static_cast<int>(made.pieces.pieces.size()));
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndAncestors(back.shape(), TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  for (int k = 1; k <= faces_of_edge.Extent(); ++k)
    EXPECT_EQ(faces_of_edge(k).Extent(),
              BRep_Tool::Degenerated(TopoDS::Edge(faces_of_edge.FindKey(k))) ? 1 : 2);
}

TEST(Watertight, SurvivesAStepFile) { expect_survives_step(box_and_cylinder()); }

TEST(Watertight, TrianglesAtAPoleSurviveAStepFile) {
  const SolidTrimResult cut = trim_solids(
      trim_tool(BRepPrimAPI_MakeSphere(1)),
      {trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0.3), gp_Pnt(2, 2, 2)))}, SolidOperation::Cut);
  ASSERT_EQ(cut.solids.size(), 1u);
  expect_survives_step(cut.solids.front());
}

}  // namespace
}  // namespace blossom::occt
