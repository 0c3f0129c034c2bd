// SPDX-License-Identifier: LGPL-2.1-or-later
// Places that do more than move: what they scale or mirror is read at that size, once.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/brep_bytes.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::Folder;

TopoDS_Shape at_place(const TopoDS_Shape& shape, const TopLoc_Location& place) {
  TopoDS_Shape there = shape;
  there.Location(place, false);
  return there;
}

gp_Trsf scaling(double factor) {
  gp_Trsf trsf;
  trsf.SetScale(gp_Pnt(1, 2, 3), factor);
  return trsf;
}

gp_Trsf mirroring() {
  gp_Trsf trsf;
  trsf.SetMirror(gp_Ax2(gp_Pnt(9, 0, 0), gp_Dir(1, 0, 0)));
  return trsf;
}

gp_Trsf turning() {
  gp_Trsf trsf;
  trsf.SetRotation(gp_Ax1(gp_Pnt(0, 1, 0), gp_Dir(1, 1, 1)), 0.7);
  return trsf;
}

double volume_of_solid(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

gp_Pnt centre_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.CentreOfMass();
}

int number_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(shape, kind, all);
  return all.Extent();
}

Model read_back(const TopoDS_Shape& shape) {
  const Folder folder;
  BRepTools::Write(shape, (folder / "placed.brep").c_str());
  return read_model(folder / "placed.brep");
}

TEST(ScalingPlaces, GiveTheShapeThatSize) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  const Model model = read_back(at_place(box, scaling(2)));
  EXPECT_EQ(model.face_count(), 6);
  EXPECT_NEAR(volume_of_solid(model.shape()), 48, 1e-9);
  EXPECT_NEAR(centre_of(model.shape()).Distance({0, 0, 0}), 0, 1e-9);
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
  EXPECT_TRUE(model.reading().losses.empty());
  ASSERT_EQ(model.reading().notes.size(), 1U);
  EXPECT_EQ(model.reading().notes[0],
            "6 faces are scaled or mirrored by their places (by 2): their geometry was made so");
}

TEST(ScalingPlaces, ScaleTolerances) {
  const Model model = read_back(at_place(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), scaling(1000)));
  for (TopExp_Explorer edge(model.shape(), TopAbs_EDGE); edge.More(); edge.Next())
    EXPECT_NEAR(BRep_Tool::Tolerance(TopoDS::Edge(edge.Current())), 1e-4, 1e-12);
}

TEST(ScalingPlaces, MirroredSolidsKeepTheirInside) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  const Model model = read_back(at_place(cylinder, mirroring()));
  EXPECT_NEAR(volume_of_solid(model.shape()), 2 * M_PI, 1e-9);
  EXPECT_NEAR(centre_of(model.shape()).Distance({18, 0, 1}), 0, 1e-9);
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
  ASSERT_EQ(model.reading().notes.size(), 1U);
}

// Places in places, whose scales multiply: 1, 2, -1 inside of -2.
TEST(ScalingPlaces, AreFollowedThroughAllLevels) {
  for (const TopoDS_Shape& solid :
       {BRepPrimAPI_MakeBox(1, 2, 3).Shape(), BRepPrimAPI_MakeCylinder(1, 2).Shape()}) {
    const TopLoc_Location inner = TopLoc_Location(mirroring()) * TopLoc_Location(turning());
    const TopLoc_Location outer =
        TopLoc_Location(turning()) * TopLoc_Location(scaling(2)) * TopLoc_Location(mirroring());
    const TopoDS_Shape whole = at_place(
        compound_of(std::vector{solid, at_place(solid, scaling(2)), at_place(solid, inner)}),
        outer);
    const Model model = read_back(whole);
    const double one = volume_of_solid(solid);
    EXPECT_NEAR(volume_of_solid(model.shape()), 8 * one + 64 * one + 8 * one, 1e-9 * one);
    EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
    const gp_Pnt inside = centre_of(solid);
    const TopLoc_Location places[] = {outer, outer * TopLoc_Location(scaling(2)), outer * inner};
    int i = 0;
    for (TopExp_Explorer each(model.shape(), TopAbs_SOLID); each.More(); each.Next(), ++i)
      EXPECT_NEAR(
          centre_of(each.Current()).Distance(inside.Transformed(places[i].Transformation())), 0,
          1e-9);
    EXPECT_EQ(i, 3);
  }
}

TEST(ScalingPlaces, LeaveSharedWhatIsShared) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  const TopExp_Explorer shared(box, TopAbs_FACE);
  // Two shells that have a face in common, and the first one once more, turned.
  TopoDS_Compound faces = compound_of(std::vector{box, shared.Current(), at_place(box, turning())});
  const Model model = read_back(at_place(faces, scaling(3)));
  EXPECT_EQ(model.face_count(), 12);
  EXPECT_EQ(number_of(model.shape(), TopAbs_EDGE), 24);
  TopoDS_Iterator part(model.shape());
  const TopoDS_Shape first = part.Value();
  part.Next(), part.Next();
  EXPECT_TRUE(part.Value().IsPartner(first));
}

TEST(ScalingPlaces, OfFacesInOneShellAreFollowed) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  TopoDS_Shell shell;
  BRep_Builder().MakeShell(shell);
  const TopLoc_Location twice(scaling(2));
  for (TopExp_Explorer face(box, TopAbs_FACE); face.More(); face.Next()) {
    BRep_Builder().Add(shell, at_place(face.Current(), twice));
  }
  const Model model = read_back(shell);
  EXPECT_EQ(model.face_count(), 6);
  EXPECT_EQ(number_of(model.shape(), TopAbs_EDGE), 12);
  EXPECT_NEAR(std::abs(volume_of_solid(model.shape())), 48, 1e-9);
}

TEST(ScalingPlaces, AreReadInBinaryFormAndAsBytes) {
  const Folder folder;
  const TopoDS_Shape scaled = at_place(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), scaling(2));
  std::ostringstream bytes;
  BinTools::Write(scaled, bytes);
  testing::write_content(folder / "placed.bin", bytes.str());
  EXPECT_NEAR(volume_of_solid(read_model(folder / "placed.bin").shape()), 48, 1e-9);
  EXPECT_NEAR(volume_of_solid(shape_from_bytes(bytes.str(), "the box")), 48, 1e-9);
}

// A box at a place whose first row is this instead of "1 0 0 5".
TopoDS_Shape moved_box() {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(5, 0, 0));
  return BRepPrimAPI_MakeBox(1, 2, 3).Shape().Moved(move);
}

std::string refusal_with_row(const std::string& row) {
  const Folder folder;
  BRepTools::Write(moved_box(), (folder / "placed.brep").c_str());
  std::string text = testing::content(folder / "placed.brep");
  const std::size_t start = text.find("Locations 1\n1\n") + 14;
  text.replace(start, text.find('\n', start) - start, row);
  testing::write_content(folder / "placed.brep", text);
  try {
    read_model(folder / "placed.brep");
  } catch (const BadModel& error) {
    const std::string what = error.what();
    return what.substr(what.rfind(": ") + 2);
  }
  return "accepted";
}

TEST(PlacesThatAreNone, AreRefusedInWords) {
  const std::string words = "its place is no motion, with a scale or without";
  EXPECT_EQ(refusal_with_row("3 0 0 5"), words);    // one direction alone
  EXPECT_EQ(refusal_with_row("1 0.5 0 5"), words);  // slants, and keeps the volume
  EXPECT_EQ(refusal_with_row("nan 0 0 5"), words);
  EXPECT_EQ(refusal_with_row("0 0 0 5"), words);
  EXPECT_EQ(refusal_with_row("1.000001 0 0 5"), "accepted");  // single precision
}

TEST(PlacesThatAreNone, AreRefusedInBinaryFormToo) {
  const Folder folder;
  std::ostringstream out;
  BinTools::Write(moved_box(), out);
  std::string bytes = out.str();
  const double three = 3;
  std::memcpy(bytes.data() + bytes.find("Locations 1\n") + 13, &three, sizeof(three));
  testing::write_content(folder / "placed.bin", bytes);
  EXPECT_THROW(read_model(folder / "placed.bin"), BadModel);
}

}  // namespace
}  // namespace blossom::occt
