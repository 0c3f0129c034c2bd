// SPDX-License-Identifier: LGPL-2.1-or-later
// Models that can be read, but are no good shapes; and programs that are killed.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using testing::blossom;
using testing::Finished;

const BRep_Builder kBuilder;

// A wire of three sides of a square on its plane.
TopoDS_Face face_with_open_wire() {
  TopoDS_Face face;
  kBuilder.MakeFace(face, new Geom_Plane(gp_Pln()), 1e-7);
  TopoDS_Wire wire;
  kBuilder.MakeWire(wire);
  const gp_Pnt corners[] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  for (int i = 0; i < 3; ++i)
    kBuilder.Add(wire, BRepBuilderAPI_MakeEdge(corners[i], corners[i + 1]).Edge());
  kBuilder.Add(face, wire);
  return face;
}

// A bow tie: two of the sides cross each other.
TopoDS_Face face_with_crossed_wire() {
  TopoDS_Face face;
  kBuilder.MakeFace(face, new Geom_Plane(gp_Pnt(0, 0, 1), gp::DZ()), 1e-7);
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& corner :
       {gp_Pnt(-3, -3, 1), gp_Pnt(5, 5, 1), gp_Pnt(5, -3, 1), gp_Pnt(-3, 5, 1)})
    polygon.Add(corner);
  polygon.Close();
  kBuilder.Add(face, polygon.Wire());
  return face;
}

// The side of a cylinder, whose edges are curves in space alone.
TopoDS_Face face_without_parameter_curves() {
  TopoDS_Face face;
  kBuilder.MakeFace(face, new Geom_CylindricalSurface(gp_Ax3(), 1), 1e-7);
  TopoDS_Wire wire;
  kBuilder.MakeWire(wire);
  const TopoDS_Edge low = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(), 1)).Edge();
  const gp_Ax2 above(gp_Pnt(0, 0, 2), gp::DZ());
  const TopoDS_Edge high = BRepBuilderAPI_MakeEdge(gp_Circ(above, 1)).Edge();
  const TopoDS_Vertex from = TopoDS::Vertex(TopExp_Explorer(low, TopAbs_VERTEX).Current());
  const TopoDS_Vertex to = TopoDS::Vertex(TopExp_Explorer(high, TopAbs_VERTEX).Current());
  const TopoDS_Edge seam = BRepBuilderAPI_MakeEdge(TopoDS::Vertex(from.Oriented(TopAbs_FORWARD)),
                                                   TopoDS::Vertex(to.Oriented(TopAbs_FORWARD)))
                               .Edge();
  for (const TopoDS_Shape& edge :
       {TopoDS_Shape(low), TopoDS_Shape(seam), high.Reversed(), seam.Reversed()})
    kBuilder.Add(wire, edge);
  kBuilder.Add(face, wire);
  return face;
}

// A box as a solid of its faces, some of which are turned or left out.
TopoDS_Solid box_of_faces(int turned, int left_out) {
  TopoDS_Shell shell;
  kBuilder.MakeShell(shell);
  int number = 0;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 2, 2).Shape();
  for (TopExp_Explorer face(box, TopAbs_FACE); face.More(); face.Next()) {
    ++number;
    if (number == left_out) continue;
    kBuilder.Add(shell, number == turned ? face.Current().Reversed() : face.Current());
  }
  TopoDS_Solid solid;
  kBuilder.MakeSolid(solid);
  kBuilder.Add(solid, shell);
  return solid;
}

class BadShapes : public ::testing::Test {
 protected:
  void SetUp() override {
    write(BRepPrimAPI_MakeSphere(gp_Pnt(1, 1, 1), 1.3).Shape(), "ball.brep");
  }
  void write(const TopoDS_Shape& shape, const std::string& name) {
    BRepTools::Write(shape, (folder / name).c_str());
  }
  // What is said of the shape as the part and as the tool, without a result.
  void expect_refused(const TopoDS_Shape& shape, const std::vector<std::string>& options,
                      const std::string& why) {
    write(shape, "bad.brep");
    for (const bool part : {true, false}) {
      std::vector<std::string> words{"trim", folder / (part ? "bad.brep" : "ball.brep"),
                                     folder / (part ? "ball.brep" : "bad.brep"), "-o",
                                     folder / "out.step"};
      words.insert(words.end(), options.begin(), options.end());
      const Finished run = blossom(words);
      EXPECT_EQ(run.code, 2) << run.err;
      EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
    }
    EXPECT_EQ(folder.listing(), (std::vector<std::string>{"bad.brep", "ball.brep"}));
  }

  testing::TestFolder folder;
};

TEST_F(BadShapes, AnOpenWireIsRefused) {
  expect_refused(face_with_open_wire(), {"--keep", "all"}, "bad.brep: a wire of face 1 is open");
}

TEST_F(BadShapes, AToolWhoseWireCrossesItselfIsTold) {
  write(face_with_crossed_wire(), "crossed.brep");
  const Finished run =
      blossom({"trim", folder / "ball.brep", folder / "crossed.brep", "--keep", "all"});
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.out.find("crossed.brep: face 1 is not valid (a wire meets itself"),
            std::string::npos)
      << run.out;
}

TEST_F(BadShapes, SolidsHaveToBeClosed) {
  expect_refused(box_of_faces(0, 6), {"--solid", "fuse"}, "is no closed solid");
}

TEST_F(BadShapes, AnOpenSolidIsCutAsASheetAndSaysSo) {
  write(box_of_faces(0, 6), "bad.brep");
  const Finished run = blossom({"trim", folder / "bad.brep", folder / "ball.brep", "--solid", "cut",
                                "-o", folder / "out.step"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("bad.brep is taken as a sheet: its shell is open"), std::string::npos)
      << run.out;
}

TEST_F(BadShapes, FacesOfASolidHaveToBeTurnedTheSameWay) {
  expect_refused(box_of_faces(3, 0), {"--solid", "cut"}, "are not all turned the same way");
}

TEST_F(BadShapes, SolidsInsideOutAreRefused) {
  expect_refused(BRepPrimAPI_MakeBox(2, 2, 2).Shape().Reversed(), {"--solid", "cut"},
                 "turned inside out");
}

TEST_F(BadShapes, MissingParameterCurvesAreMadeAndTold) {
  write(face_without_parameter_curves(), "tube.brep");
  const std::string told = "tube.brep: 4 missing parameter curves made";
  const Finished cut = blossom({"trim", folder / "tube.brep", folder / "ball.brep", "--keep",
                                "outside", "-o", folder / "cut.step"});
  EXPECT_TRUE(cut.code == 0 || cut.code == 3) << cut.code << cut.err;
  EXPECT_NE(cut.err.find(told), std::string::npos) << cut.err;
  const Finished copy = blossom({"convert", folder / "tube.brep", "-o", folder / "tube.step"});
  EXPECT_EQ(copy.code, 0) << copy.err;
  EXPECT_NE(copy.err.find(told), std::string::npos) << copy.err;
  const Finished sound = blossom({"check", folder / "tube.step", "--fail-on", "findings"});
  EXPECT_EQ(sound.code, 0) << sound.out << sound.err;
}

TEST_F(BadShapes, ToolsThatMissLeaveThePartAsItIs) {
  write(BRepPrimAPI_MakeBox(2, 2, 2).Shape(), "box.brep");
  write(BRepPrimAPI_MakeSphere(gp_Pnt(50, 1, 1), 1.3).Shape(), "away.brep");
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--keep", "outside"},
                                                  std::vector<std::string>{"--solid", "cut"}}) {
    std::vector<std::string> words{"trim", folder / "box.brep", folder / "away.brep", "-o",
                                   folder / "out.brep"};
    words.insert(words.end(), options.begin(), options.end());
    const Finished run = blossom(words);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(blossom({"check", folder / "out.brep", "--fail-on", "findings"}).code, 0);
  }
}

// Whenever the program ends, the old file or the whole new one is there, and nothing else.
TEST_F(BadShapes, KilledProgramsLeaveTheOldFileOrTheNewOne) {
  TopoDS_Compound many;
  kBuilder.MakeCompound(many);
  for (int i = 0; i < 200; ++i)
    kBuilder.Add(many, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(3 * i, 0, 0), gp::DZ()), 1, 2));
  write(many, "many.brep");
  for (const std::string signal : {"KILL", "TERM"})
    for (const std::string seconds : {"0.1", "0.3", "0.6"}) {
      testing::write_text(folder / "out.step", "old");
      const Finished run =
          blossom({"convert", folder / "many.brep", "-o", folder / "out.step"},
                  "timeout --foreground --preserve-status -s " + signal + " " + seconds);
      const std::string text = testing::text_of(folder / "out.step");
      // A signal after the renaming ends a program whose work is done.
      EXPECT_TRUE(run.code != 0 || text != "old") << signal << " after " << seconds;
      EXPECT_TRUE(text == "old" || text.ends_with("END-ISO-10303-21;\n"));
      // 143: it had not yet begun.
      const bool ended = signal == "TERM" ? run.code == 130 || run.code == 143 : run.code == 137;
      EXPECT_TRUE(run.code == 0 || ended) << run.code << run.err;
      EXPECT_EQ(folder.listing(), (std::vector<std::string>{"ball.brep", "many.brep", "out.step"}));
    }
}

}  // namespace
}  // namespace blossom
