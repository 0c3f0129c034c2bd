// SPDX-License-Identifier: LGPL-2.1-or-later
// What no model has: compounds in compounds as deep as only hostile files are, places that scale,
// faces without surfaces or without ends, curves that end too soon.

#include <gtest/gtest.h>

#include <string>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <Poly_Triangulation.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp.hxx>
#include <gp_Pln.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/soundness.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::Folder;

TopoDS_Shape nested(TopoDS_Shape shape, int levels) {
  for (int i = 0; i < levels; ++i) {
    TopoDS_Compound around;
    BRep_Builder builder;
    builder.MakeCompound(around);
    builder.Add(around, shape);
    shape = around;
  }
  return shape;
}

TEST(NestedShapes, AreReadUpToAThousandLevels) {
  const Folder folder;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  BRepTools::Write(nested(box, 999), (folder / "deep.brep").c_str());
  EXPECT_EQ(read_model(folder / "deep.brep").face_count(), 6);
  BRepTools::Write(nested(box, 1000), (folder / "deeper.brep").c_str());
  try {
    read_model(folder / "deeper.brep");
    FAIL() << "is not refused";
  } catch (const BadModel& error) {
    EXPECT_TRUE(std::string(error.what()).ends_with("nested more than 1000 deep")) << error.what();
  }
}

// A box, and another one at a place whose first row is this instead of "1 0 0 5".
Model with_place(const std::string& row) {
  const Folder folder;
  gp_Trsf move;
  move.SetTranslation(gp_Vec(5, 0, 0));
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  builder.Add(both, BRepPrimAPI_MakeBox(1, 2, 3).Shape().Moved(move));
  BRepTools::Write(both, (folder / "placed.brep").c_str());
  std::string text = testing::content(folder / "placed.brep");
  const std::size_t start = text.find("Locations 1\n1\n") + 14;
  text.replace(start, text.find('\n', start) - start, row);
  testing::write_content(folder / "placed.brep", text);
  return read_model(folder / "placed.brep");
}

TEST(OddPlaces, FacesAtPlacesThatAreNoneAreLeftOut) {
  const Model model = with_place("3 0 0 5");
  EXPECT_EQ(model.face_count(), 6);
  ASSERT_EQ(model.reading().losses.size(), 1U);
  EXPECT_EQ(model.reading().losses[0].cause, "its place is no motion, with a scale or without");
  EXPECT_EQ(model.reading().losses[0].count, 6);
}

// Of what such a place makes no numbers, Open CASCADE may turn a curve round for ever.
TEST(OddPlaces, FacesOfSurfacesAtPlacesThatAreNoneAreLeftOut) {
  const Folder folder;
  gp_Trsf move;
  move.SetTranslation(gp_Vec(5, 0, 0));
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln()), TopLoc_Location(move), 1e-7);
  builder.Add(face, BRepBuilderAPI_MakePolygon({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, true).Wire());
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  builder.Add(both, face);
  BRepTools::Write(both, (folder / "placed.brep").c_str());
  std::string text = testing::content(folder / "placed.brep");
  const std::size_t start = text.find("Locations 1\n1\n") + 14;
  text.replace(start, text.find('\n', start) - start, "3 0 0 5");
  testing::write_content(folder / "placed.brep", text);
  const Model model = read_model(folder / "placed.brep");
  EXPECT_EQ(model.face_count(), 6);
  ASSERT_EQ(model.reading().losses.size(), 1U);
  EXPECT_EQ(model.reading().losses[0].cause,
            "the place of its surface is no motion, with a scale or without");
}

TEST(OddPlaces, MirroredFacesAreReadAndChecked) {
  const Model model = with_place("-1 0 0 5");
  ASSERT_EQ(model.face_count(), 12);
  for (int number = 1; number <= 12; ++number) EXPECT_NO_THROW(face_fault(model.face(number)));
}

std::string refusal_of_brep(const TopoDS_Shape& shape, const std::string& version = "") {
  const Folder folder;
  BRepTools::Write(shape, (folder / "part.brep").c_str());
  std::string text = testing::content(folder / "part.brep");
  if (!version.empty()) text.replace(text.find("V3") + 1, 1, version);
  testing::write_content(folder / "part.brep", text);
  try {
    read_model(folder / "part.brep");
  } catch (const BadModel& error) {
    const std::string what = error.what();
    return what.substr(what.find(": ") + 2);
  }
  return "accepted";
}

TopoDS_Shape solid_of_nothing() {
  TopoDS_Shell shell;
  TopoDS_Solid solid;
  BRep_Builder().MakeShell(shell);
  BRep_Builder().MakeSolid(solid);
  BRep_Builder().Add(solid, shell);
  return solid;
}

TEST(OddBreps, AreRefusedInWordsUnlessThereIsAFace) {
  EXPECT_EQ(refusal_of_brep(TopoDS_Shape()), "holds no shape");
  EXPECT_EQ(refusal_of_brep(solid_of_nothing()), "holds no shape");
  EXPECT_EQ(refusal_of_brep(BRepBuilderAPI_MakeFace(gp_Pln()).Shape()), "accepted");
  EXPECT_EQ(refusal_of_brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "9"),
            "is of no version that is known: 'CASCADE Topology V9, (c) Open Cascade'");
}

TEST(OddBreps, OfTrianglesAloneAreRefusedAsSuch) {
  const Handle(Poly_Triangulation) triangles = new Poly_Triangulation(3, 1, false);
  triangles->SetNode(2, gp_Pnt(1, 0, 0));
  triangles->SetNode(3, gp_Pnt(0, 1, 0));
  triangles->SetTriangle(1, Poly_Triangle(1, 2, 3));
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, triangles);
  EXPECT_EQ(refusal_of_brep(face),
            "holds no shape that can be used: face (face 1): it has triangles and no surface");
}

// A projection of Open CASCADE crashes on it.
TEST(OddBreps, CurvesThatLieEndlesslyFarAwayAreLeftOut) {
  const Folder folder;
  BRepTools::Write(BRepPrimAPI_MakeCylinder(3, 5).Shape(), (folder / "far.brep").c_str());
  std::string text = testing::content(folder / "far.brep");
  const std::size_t circle = text.find("\n2 0 0 5 ");
  ASSERT_NE(circle, std::string::npos);
  text.replace(circle + 3, 1, "1e300");
  testing::write_content(folder / "far.brep", text);
  const Model model = read_model(folder / "far.brep");
  EXPECT_EQ(model.face_count(), 1);
  for (int number = 1; number <= model.face_count(); ++number)
    EXPECT_NO_THROW(face_fault(model.face(number)));
  ASSERT_FALSE(model.reading().losses.empty());
  EXPECT_NE(model.reading().losses[0].cause.find("a number of the curve is not finite"),
            std::string::npos)
      << model.reading().losses[0].cause;
}

// A solid of revolution whose generatrix ends before its edge.
Model with_short_generatrix() {
  const Folder folder;
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 3);
  points->SetValue(1, gp_Pnt(5, 0, 0));
  points->SetValue(2, gp_Pnt(7, 0, 5));
  points->SetValue(3, gp_Pnt(4, 0, 10));
  GeomAPI_Interpolate curve(points, false, 1e-9);
  curve.Perform();
  BRepBuilderAPI_MakePolygon axis(gp_Pnt(4, 0, 10), gp_Pnt(0, 0, 10), gp_Pnt(0, 0, 0),
                                  gp_Pnt(5, 0, 0));
  BRepBuilderAPI_MakeWire wire(axis.Wire());
  wire.Add(BRepBuilderAPI_MakeEdge(curve.Curve()).Edge());
  const TopoDS_Shape profile = BRepBuilderAPI_MakeFace(wire.Wire(), true).Shape();
  const TopoDS_Shape solid = BRepPrimAPI_MakeRevol(profile, gp::OZ(), 4.0).Shape();
  BRepTools::Write(solid, (folder / "short.brep").c_str());
  std::string text = testing::content(folder / "short.brep");
  const std::string first_knot = "\n 0 3 ";
  const std::size_t last_knot = text.find(first_knot, text.find("\nCurves ")) + first_knot.size();
  text.replace(last_knot, text.find(' ', last_knot) - last_knot, "11.2");  // of 11.216
  testing::write_content(folder / "short.brep", text);
  return read_model(folder / "short.brep");
}

TEST(OddBreps, ABodyThatCannotBeCheckedIsAFinding) {
  const Soundness found = soundness(with_short_generatrix().shape());
  ASSERT_FALSE(found.problems.empty());
  EXPECT_EQ(found.problems.back(),
            "solid 1: it cannot be checked: its numbers make no such geometry");
}

}  // namespace
}  // namespace blossom::occt
