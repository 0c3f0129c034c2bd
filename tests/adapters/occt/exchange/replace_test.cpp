// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces in the place of faces: the rest of the model stays what it was, in the file too.

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::volume;

using testing::Folder;
using testing::story;

/// A rectangular face cut along its diagonal into two that keep its four edges.
std::vector<TopoDS_Face> halves(const TopoDS_Face& face) {
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer e(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); e.More(); e.Next())
    edges.push_back(TopoDS::Edge(e.Current()));
  const auto next = [&](const TopoDS_Edge& edge) {
    for (const TopoDS_Edge& other : edges)
      if (TopExp::FirstVertex(other, true).IsSame(TopExp::LastVertex(edge, true))) return other;
    throw std::logic_error("no next edge");
  };
  const TopoDS_Edge a = edges[0], b = next(a), c = next(b), d = next(c);
  const TopoDS_Edge diagonal =
      BRepBuilderAPI_MakeEdge(TopExp::LastVertex(b, true), TopExp::FirstVertex(a, true));
  const auto half = [&](const TopoDS_Edge& x, const TopoDS_Edge& y, const TopoDS_Shape& z) {
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(x, y, TopoDS::Edge(z));
    const TopoDS_Face made = BRepBuilderAPI_MakeFace(BRep_Tool::Surface(face), wire);
    return TopoDS::Face(made.Oriented(face.Orientation()));
  };
  return {half(a, b, diagonal), half(c, d, diagonal.Reversed())};
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

Model model_of(const TopoDS_Shape& shape) {
  Model model;
  model.add(shape, "part");
  return model;
}

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(1, 2, 3).Shape(); }

TEST(ReplaceFaces, KeepsASolidValidWhenThePiecesMakeUpTheFace) {
  for (const bool reversed : {false, true})
    for (int number = 1; number <= 6; ++number) {
      Model model = model_of(reversed ? box().Reversed() : box());
      model.replace_faces({{number, halves(model.face(number))}});
      EXPECT_EQ(model.face_count(), 7);
      EXPECT_EQ(model.shape().ShapeType(), TopAbs_SOLID);
      EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid()) << number;
      EXPECT_NEAR(volume(model.shape()), reversed ? -6 : 6, 1e-12) << number;
    }
}

TEST(ReplaceFaces, LeavesAllOtherFacesAndTheirEdgesTheSame) {
  Model model = model_of(box());
  TopTools_IndexedMapOfShape before;
  TopExp::MapShapes(model.shape(), before);
  model.replace_faces({{4, halves(model.face(4))}});
  EXPECT_EQ(count(model.shape(), TopAbs_EDGE), 13);
  int kept = 0;
  for (int i = 1; i <= 7; ++i) kept += before.Contains(model.face(i));
  EXPECT_EQ(kept, 5);
}

TEST(ReplaceFaces, TurnsASolidWithAMissingFaceIntoAnOpenShell) {
  Model model = model_of(box());
  model.replace_faces({{2, {}}});
  EXPECT_EQ(model.face_count(), 5);
  EXPECT_EQ(model.shape().ShapeType(), TopAbs_SHELL);
  EXPECT_FALSE(BRep_Tool::IsClosed(model.shape()));
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
}

TEST(ReplaceFaces, MakesAShellOfEachPartWhenTheShellFallsApart) {
  Model model = model_of(box());
  model.replace_faces({{1, {}}, {2, {}}, {3, {}}, {4, {}}});
  EXPECT_EQ(model.face_count(), 2);
  EXPECT_EQ(model.shape().ShapeType(), TopAbs_COMPOUND);
  EXPECT_EQ(count(model.shape(), TopAbs_SHELL), 2);
}

TEST(ReplaceFaces, TakesOutPartsOfWhichNothingIsLeft) {
  const Folder folder;
  testing::write_machine(folder / "in.step");
  Model model = read_model(folder / "in.step");
  model.replace_faces({{7, {}}, {8, {}}, {9, {}}, {10, {}}, {11, {}}, {12, {}}});
  EXPECT_EQ(model.face_count(), 12);
  write_model(model, folder / "out.step");
  EXPECT_EQ(story(folder / "out.step").find("pin:1"), std::string::npos);
  EXPECT_NE(story(folder / "out.step").find("pin:2 of Pin #CCCC00 26.000"), std::string::npos);
}

TEST(ReplaceFaces, CutsAFaceBetweenTwoSolidsInBoth) {
  // Two boxes that share a face: a compsolid's way, as a compound of solids.
  const TopoDS_Shape left = box();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(left, TopAbs_FACE, faces);
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, left);
  builder.Add(both, left.Reversed());
  Model model = model_of(both);
  model.replace_faces({{3, halves(model.face(3))}});
  EXPECT_EQ(count(model.shape(), TopAbs_FACE), 7);
  EXPECT_NEAR(volume(model.shape()), 0, 1e-12);
}

TEST(ReplaceFaces, PutsPiecesOfAFaceAloneIntoAShell) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(box(), TopAbs_FACE, faces);
  Model model = model_of(faces(1));
  model.replace_faces({{1, halves(model.face(1))}});
  EXPECT_EQ(model.shape().ShapeType(), TopAbs_SHELL);
  EXPECT_EQ(model.face_count(), 2);
}

TEST(ReplaceFaces, NumbersTheNamesAndKeepsTheColours) {
  const Folder folder;
  testing::write_machine(folder / "in.step", "INCH");
  Model model = read_model(folder / "in.step");
  model.replace_faces({{6, halves(model.face(6))}, {1, halves(model.face(1))}});
  write_model(model, folder / "out.step");
  EXPECT_EQ(story(folder / "out.step"),
            "in INCH\n"
            "Machine 0.000..40.000 0.000..30.000 0.000..30.000 valid\n"
            "  plate:1 of Base plate #3366CC 0.000..40.000 0.000..30.000 "
            "0.000..10.000 valid\n"
            "    * SideFace #00FF00\n"
            "    * TopFace.1 #FF0000\n"
            "    * TopFace.2 #FF0000\n"
            "  pin:1 of Pin #CCCC00 6.000..14.000 11.000..19.000 10.000..30.000 valid\n"
            "    * Left\n"
            "    * Right #FF00FF\n"
            "  pin:2 of Pin #CCCC00 26.000..34.000 11.000..19.000 10.000..30.000 valid\n"
            "    * Left\n"
            "    * Right #FF00FF\n"
            "layer plates: Base plate\n");
  EXPECT_NEAR(volume(read_model(folder / "out.step").shape()), 14560, 1e-6);
}

TEST(ReplaceFaces, CutsAPartThatIsUsedTwiceOnlyWhereTheFaceWasNamed) {
  const Folder folder;
  testing::write_machine(folder / "in.step");
  for (const int number : {8, 14}) {
    Model model = read_model(folder / "in.step");
    model.replace_faces({{number, halves(model.face(number))}});
    EXPECT_EQ(model.face_count(), 19);
    EXPECT_NEAR(volume(model.shape()), 14560, 1e-6);
    write_model(model, folder / "out.step");
    const std::string told = story(folder / "out.step");
    const std::size_t second = told.find("  pin:2");
    const bool first_is_cut = told.find("Right.1 #FF00FF") < second;
    EXPECT_EQ(first_is_cut, number == 8) << told;
    EXPECT_NE(told.find("Right.2 #FF00FF"), std::string::npos) << told;
    EXPECT_NE(told.find("Right #FF00FF"), std::string::npos) << told;
    EXPECT_LT(told.find("* Left\n"), second) << told;
    EXPECT_NE(told.find("* Left\n", second), std::string::npos) << told;
    EXPECT_EQ(told.find("invalid"), std::string::npos) << told;
    EXPECT_EQ(read_model(folder / "out.step").face_count(), 19);
  }
}

TEST(ReplaceFaces, CutsBothUsesOfAPartDifferently) {
  const Folder folder;
  testing::write_machine(folder / "in.step");
  Model model = read_model(folder / "in.step");
  model.replace_faces({{8, halves(model.face(8))}, {13, {}}});
  EXPECT_EQ(model.face_count(), 18);
  write_model(model, folder / "out.step");
  const std::string told = story(folder / "out.step");
  const std::string first =
      told.substr(told.find("  pin:1"), told.find("  pin:2") - told.find("  pin:1"));
  const std::string second = told.substr(told.find("  pin:2"));
  EXPECT_NE(first.find("* Right.1"), std::string::npos) << told;
  EXPECT_NE(first.find("* Left\n"), std::string::npos) << told;
  EXPECT_EQ(second.find("* Left"), std::string::npos) << told;
  EXPECT_NE(second.find("* Right #FF00FF"), std::string::npos) << told;
}

TEST(ReplaceFaces, CutsOneBoxOfAnAssemblyThatIsUsedTwice) {
  const Folder folder;
  testing::write_pairs(folder / "in.step");
  Model model = read_model(folder / "in.step");
  ASSERT_EQ(model.face_count(), 24);
  model.replace_faces({{13, halves(model.face(13))}});
  write_model(model, folder / "out.step");
  EXPECT_EQ(story(folder / "out.step"),
            "in millimetre\n"
            "Pairs 12.000..25.000 0.000..2.000 0.000..3.000 valid\n"
            "  pair:1 of Pair 12.000..15.000 0.000..2.000 0.000..3.000 valid\n"
            "    box:1 of Box 2.000..3.000 0.000..2.000 0.000..3.000 valid\n"
            "      * Fläche\n"
            "    box:2 of Box 4.000..5.000 0.000..2.000 0.000..3.000 valid\n"
            "      * Fläche\n"
            "  pair:2 of Pair 22.000..25.000 0.000..2.000 0.000..3.000 valid\n"
            "    box:1 of Box 2.000..3.000 0.000..2.000 0.000..3.000 valid\n"
            "      * Fläche.1\n"
            "      * Fläche.2\n"
            "    box:2 of Box 4.000..5.000 0.000..2.000 0.000..3.000 valid\n"
            "      * Fläche\n");
  EXPECT_EQ(read_model(folder / "out.step").face_count(), 25);
}

TEST(ReplaceFaces, CutsSeveralBoxesOfAssembliesThatAreUsedTwice) {
  const Folder folder;
  testing::write_pairs(folder / "in.step");
  Model model = read_model(folder / "in.step");
  model.replace_faces({{1, halves(model.face(1))}, {7, halves(model.face(7))}, {19, {}}});
  EXPECT_EQ(model.face_count(), 25);
  write_model(model, folder / "out.step");
  const std::string told = story(folder / "out.step");
  int whole = 0, pieces = 0;
  for (std::size_t at = told.find("* Fl"); at != std::string::npos; at = told.find("* Fl", at + 1))
    ++(told.substr(at, 10).find('.') == std::string::npos ? whole : pieces);
  EXPECT_EQ(whole, 1) << told;
  EXPECT_EQ(pieces, 4) << told;
  EXPECT_EQ(read_model(folder / "out.step").face_count(), 25);
}

TEST(ReplaceFaces, WorksTwiceOnTheSameModel) {
  Model model = model_of(box());
  model.replace_faces({{1, halves(model.face(1))}});
  int square = 0;
  for (int i = 1; i <= model.face_count(); ++i)
    if (count(model.face(i), TopAbs_EDGE) == 4) square = i;
  model.replace_faces({{square, halves(model.face(square))}});
  EXPECT_EQ(model.face_count(), 8);
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
}

TEST(ReplaceFaces, ChangesNothingWhenANumberOrAPieceIsNoGood) {
  Model model = model_of(box());
  EXPECT_THROW(model.replace_faces({{1, {}}, {7, {}}}), BadModel);
  EXPECT_THROW(model.replace_faces({{1, {}}, {2, {TopoDS_Face()}}}), BadModel);
  EXPECT_EQ(model.face_count(), 6);
}

}  // namespace
}  // namespace blossom::occt
