// SPDX-License-Identifier: LGPL-2.1-or-later
// Results through files: their volumes and areas change by no more than those of models that were
// not touched, and IGES files keep the looks that they can.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Hyperbola.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/faces/area.h"
#include "adapters/occt/repair/polar_faces.h"
#include "adapters/occt/repair/spline_hyperbolas.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/exchange/shapes_files.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

using testing::Folder;

// Relative changes that are none: by integration, and where IGES has curves in parameters made
// anew within 1e-7 on the way.
double none_for(const std::string& ending) { return ending == ".iges" ? 1e-7 : 1e-9; }

struct Sizes {
  double volume = 0;
  double area = 0;
};

Sizes sizes_of(const TopoDS_Shape& shape) {
  Sizes sizes;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    sizes.volume += cone_volume(TopoDS::Face(it.Current()), {});
    sizes.area += area(TopoDS::Face(it.Current()));
  }
  return sizes;
}

// What files change.
Sizes change_of(const TopoDS_Shape& shape, const std::string& ending) {
  const Folder folder;
  Model model;
  model.add(shape, "shape");
  write_model(model, folder / ("shape" + ending));
  const Model back = read_model(folder / ("shape" + ending));
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape()).IsValid());
  const int halves = ending == ".step" ? static_cast<int>(polar_faces(shape).size()) : 0;
  EXPECT_EQ(back.face_count(), model.face_count() + halves);
  const Sizes before = sizes_of(shape), after = sizes_of(back.shape());
  return {std::abs(after.volume - before.volume), std::abs(after.area - before.area)};
}

// Results beside part and tool, with absolute changes.
void expect_small_changes(const TopoDS_Shape& part, const TopoDS_Shape& tool,
                          const std::string& ending,
                          const std::vector<SolidOperation>& operations = {
                              SolidOperation::Cut, SolidOperation::Common, SolidOperation::Fuse}) {
  const Sizes size = sizes_of(part), of_part = change_of(part, ending),
              of_tool = change_of(tool, ending);
  const Sizes allowed{of_part.volume + of_tool.volume, of_part.area + of_tool.area};
  for (const SolidOperation operation : operations) {
    const SolidTrimResult made = trim_solids(trim_tool(part), {trim_tool(tool)}, operation);
    ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
    TopoDS_Compound solids;
    BRep_Builder().MakeCompound(solids);
    for (const TopoDS_Solid& solid : made.solids) BRep_Builder().Add(solids, solid);
    const Sizes change = change_of(solids, ending);
    EXPECT_LE(change.volume, 2 * allowed.volume + none_for(ending) * size.volume) << ending;
    EXPECT_LE(change.area, 2 * allowed.area + none_for(ending) * size.area) << ending;
  }
}

class RoundTrip : public ::testing::TestWithParam<const char*> {};

TEST_P(RoundTrip, OfABoxAndACylinder) {
  const gp_Ax2 axis(gp_Pnt(1, 1, 1), gp_Dir(0.2, 0.1, 1));
  expect_small_changes(BRepPrimAPI_MakeBox(2, 2, 2).Shape(),
                       BRepPrimAPI_MakeCylinder(axis, 0.6, 3).Shape(), GetParam());
}

TEST_P(RoundTrip, OfABallAndATorus) {
  const gp_Ax2 axis(gp_Pnt(0.7, 0.1, 0.2), gp_Dir(0.3, 0.2, 1));
  expect_small_changes(BRepPrimAPI_MakeSphere(1).Shape(),
                       BRepPrimAPI_MakeTorus(axis, 0.8, 0.3).Shape(), GetParam());
}

// Turned, and moved by a part of the size.
TopoDS_Shape turned(const TopoDS_Shape& shape, double part = 0) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  const gp_Pnt middle((box.CornerMin().XYZ() + box.CornerMax().XYZ()) / 2);
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1(middle, gp_Dir(0.3, 0.5, 0.81)), 0.4);
  move.SetTranslation(part * gp_Vec(box.CornerMin(), box.CornerMax()));
  return BRepBuilderAPI_Transform(shape, move * turn, true).Shape();
}

TEST(StepFiles, KeepTheSizesOfAWingWithoutItsTurnedCopy) {
  const char* folder = blossom::testing::test_data();
  if (!folder) GTEST_SKIP() << blossom::testing::kNoTestData;
  const Model model = testing::repaired_model(std::string(folder) + "/models/d150_wing.brep");
  expect_small_changes(model.shape(), turned(model.shape()), ".step", {SolidOperation::Cut});
}

// Ends of its edges are up to 3e-3 apart in their vertices.
TEST(StepFiles, KeepTheVolumeOfAModelWithLooseEdges) {
  const char* folder = blossom::testing::test_data();
  if (!folder) GTEST_SKIP() << blossom::testing::kNoTestData;
  const Model model = testing::repaired_model(std::string(folder) + "/models/s1_mainbody_back.stp");
  const TopoDS_Shape copy = turned(model.shape(), 0.06);
  const SolidTrimResult made =
      trim_solids(trim_tool(model.shape()), {trim_tool(copy)}, SolidOperation::Common);
  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  TopoDS_Compound solids;
  BRep_Builder().MakeCompound(solids);
  for (const TopoDS_Solid& solid : made.solids) BRep_Builder().Add(solids, solid);
  EXPECT_LE(change_of(solids, ".step").volume, 1e-5 * made.volumes.back().common);
}

INSTANTIATE_TEST_SUITE_P(Files, RoundTrip, ::testing::Values(".step", ".iges", ".brep"));

// Between an arc of a hyperbola with the half axes 2e-5 and 0.02 and its chord.
TopoDS_Face slim_face() {
  const Handle(Geom_Hyperbola) hyperbola =
      new Geom_Hyperbola(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(0.1, 0.2, 1)), 2e-5, 0.02);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(hyperbola, -1.0, 1.5));
  wire.Add(BRepBuilderAPI_MakeEdge(hyperbola->Value(1.5), hyperbola->Value(-1)));
  return BRepBuilderAPI_MakeFace(wire.Wire(), true);
}

bool has_conic_arc(const std::string& iges) {
  std::istringstream lines(iges);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("104,")) return true;
  return false;
}

TEST(IgesFiles, HaveSplinesForHyperbolasSinceReadersHangOnThem) {
  const Folder folder;
  Model model;
  model.add(slim_face(), "slim");
  write_model(model, folder / "slim.iges");
  ASSERT_FALSE(has_conic_arc(testing::content(folder / "slim.iges")));
  const Model back = read_model(folder / "slim.iges");
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape()).IsValid());
  const double size = area(model.face(1));
  EXPECT_NEAR(area(back.face(1)), size, 1e-3 * size);
}

TEST(SplineHyperbolas, KeepParametersAndGiveCurvesBack) {
  const TopoDS_Face face = slim_face();
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current());
  double first = 0, last = 0;
  const Handle(Geom_Curve) given = BRep_Tool::Curve(edge, first, last);
  ASSERT_TRUE(given->IsKind(STANDARD_TYPE(Geom_Hyperbola)));
  {
    const SplineHyperbolas splines(face);
    const Handle(Geom_Curve) spline = BRep_Tool::Curve(edge, first, last);
    ASSERT_TRUE(spline->IsKind(STANDARD_TYPE(Geom_BSplineCurve)));
    for (int i = 0; i <= 100; ++i) {
      const double t = first + (last - first) * i / 100;
      EXPECT_LE(spline->Value(t).Distance(given->Value(t)), 1e-9) << t;
    }
  }
  EXPECT_EQ(BRep_Tool::Curve(edge, first, last), given);
}

// A part of six faces in one colour but for the named one.
std::string told(const std::string& name, const std::string& size, const std::string& colour,
                 const std::string& face, const std::string& of_face) {
  std::string text = name + " " + colour + " " + size + " valid\n";
  for (int i = 0; i < 5; ++i) text += "  * - " + colour + "\n";
  return text + "  * " + face + " " + of_face + "\n";
}

// IGES has no assemblies: each instance is a part of its own, called by the way to it.
TEST(IgesFiles, HaveAPartForEachInstance) {
  const Folder folder;
  testing::write_works(folder / "in.step");
  const Model works = read_model(folder / "in.step");
  write_model(works, folder / "out.iges");
  const Model back = read_model(folder / "out.iges");
  EXPECT_EQ(back.part_paths(), works.part_paths());
  EXPECT_EQ(back.face_count(), 42);
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape()).IsValid());
  write_model(back, folder / "back.step");
  const std::string blue = "#0000FF", red = "#FF0000", yellow = "#FFFF00", violet = "#FF00FF";
  const std::string parts =
      told("machine:1/plate:1", "0.000..40.000 0.000..30.000 0.000..10.000", blue, "Top", red) +
      told("machine:1/bolt:1", "5.000..13.000 5.000..13.000 10.000..30.000", yellow, "Head",
           yellow) +
      told("machine:1/bolt:2", "25.000..33.000 5.000..13.000 10.000..30.000", blue, "Head", blue) +
      told("machine:2/plate:1", "-30.000..0.000 100.000..140.000 0.000..10.000", blue, "Top", red) +
      told("machine:2/bolt:1", "-13.000..-5.000 105.000..113.000 10.000..30.000", violet, "Head",
           violet) +
      told("machine:2/bolt:2", "-13.000..-5.000 125.000..133.000 10.000..30.000", blue, "Head",
           blue) +
      told("bolt:9", "200.000..208.000 0.000..8.000 0.000..20.000", yellow, "Head", yellow);
  EXPECT_EQ(testing::story(folder / "back.step").substr(0, 14 + 1 + parts.size()),
            "in millimetre\n" + parts + "l");  // layers have numbers only
}

TEST(IgesFiles, NamePartsByTheirRootsWhereThereAreSeveral) {
  const Folder folder;
  testing::write_roots(folder / "in.step");
  const Model roots = read_model(folder / "in.step");
  EXPECT_EQ(roots.part_paths(), std::vector<std::string>(12, "Block"));  // not "=>[0:1:1:2]"
  write_model(roots, folder / "out.iges");
  std::vector<std::string> names(6, "Left/Block");
  names.insert(names.end(), 6, "Right/Block");
  EXPECT_EQ(read_model(folder / "out.iges").part_paths(), names);
}

TEST(StepFiles, CallInstancesWithoutANameAsTheirParts) {
  const Folder folder;
  testing::write_roots(folder / "in.step");
  const Model roots = read_model(folder / "in.step");
  write_model(roots, folder / "out.step");
  std::ifstream written(folder / "out.step");
  const std::string text(std::istreambuf_iterator<char>(written), {});
  EXPECT_EQ(text.find("=>["), std::string::npos);
  const std::size_t usage = text.find("NEXT_ASSEMBLY_USAGE_OCCURRENCE(");
  EXPECT_EQ(text.substr(text.find(',', usage), 9), ",'Block',");
  EXPECT_EQ(read_model(folder / "out.step").part_paths(), roots.part_paths());
}

TEST(IgesFiles, KeepColoursOfFaces) {
  const Folder folder;
  testing::write_machine(folder / "in.step");
  write_model(read_model(folder / "in.step"), folder / "out.iges");
  const Model back = read_model(folder / "out.iges");
  write_model(back, folder / "back.step");
  const std::string story = testing::story(folder / "back.step");
  const auto count = [&](const std::string& line) {
    int found = 0;
    for (std::size_t at = story.find(line); at != std::string::npos; at = story.find(line, at + 1))
      ++found;
    return found;
  };
  EXPECT_EQ(count("plate:1 #3366CC 0"), 1) << story;
  EXPECT_EQ(count("pin:1 #CCCC00 "), 1) << story;
  EXPECT_EQ(count("pin:2 #CCCC00 "), 1) << story;
  EXPECT_EQ(count("* TopFace #FF0000\n"), 1) << story;
  EXPECT_EQ(count("* SideFace #00FF00\n"), 1) << story;
  EXPECT_EQ(count("* Right #FF00FF\n"), 2) << story;
}

// A part from an IGES file, cut, to IGES again.
TEST(IgesFiles, AreCutAndWritten) {
  const Folder folder;
  testing::write_machine(folder / "in.step");
  write_model(read_model(folder / "in.step"), folder / "in.iges");
  Model part = read_model(folder / "in.iges");
  Model tool;
  tool.add(BRepPrimAPI_MakeBox(gp_Pnt(18, -5, -5), gp_Pnt(22, 35, 40)).Shape(), "Saw");
  const SolidTrimResult made =
      trim_solids(trim_tool(part.shape()), {trim_tool(tool.shape())}, SolidOperation::Cut);
  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  std::vector<CombinedSolid> solids;
  for (const TopoDS_Solid& solid : made.solids) {
    solids.push_back({solid, {}});
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
      for (const SolidFace& face : made.faces)
        if (face.face.IsSame(it.Current()))
          solids.back().faces.push_back({face.face, face.tool < 0 ? &part : &tool, face.from + 1});
  }
  part.replace_solids(solids);
  write_model(part, folder / "out.iges");
  const Model back = read_model(folder / "out.iges");
  EXPECT_EQ(back.face_count(), 24);
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape()).IsValid());
  EXPECT_NEAR(sizes_of(back.shape()).volume, 36 * 30 * 10 + 2 * 8 * 8 * 20, 1e-6);
}

// Of a ball with a hole in its seam, as Open CASCADE writes it, its reader gives the hole alone.
TEST(StepFiles, HaveTheSideOfABorderThatTheySay) {
  const Folder own;
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(gp_Ax2(gp::Origin(), gp::DX()), 2, 25).Shape();
  STEPControl_Writer writer;
  writer.Transfer(BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(10).Shape(), rod).Shape(),
                  STEPControl_AsIs);
  ASSERT_EQ(writer.Write((own / "ball.step").c_str()), IFSelect_RetDone);
  const Model back = read_model(own / "ball.step");
  EXPECT_EQ(back.reading().grade(), ReadingGrade::Whole) << back.reading().summary();
  const double hole = 2 * std::numbers::pi / 3 * (1000 - std::pow(96, 1.5));
  EXPECT_NEAR(sizes_of(back.shape()).volume, 4 * std::numbers::pi / 3 * 1000 - hole, 1e-3);
}

}  // namespace
}  // namespace blossom::occt
