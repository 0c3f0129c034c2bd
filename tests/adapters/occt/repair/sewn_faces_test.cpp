// SPDX-License-Identifier: LGPL-2.1-or-later
// Loose faces become the solids that they close, and nothing else does.

#include "adapters/occt/repair/sewn_faces.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using Faces = std::vector<TopoDS_Face>;

/// The faces of a shape, which share nothing.
Faces loose_faces_of(const TopoDS_Shape& shape) {
  Faces faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(BRepBuilderAPI_Copy(it.Current()).Shape()));
  return faces;
}

TopoDS_Shape box(double x, double y, double z) { return BRepPrimAPI_MakeBox(x, y, z).Shape(); }

TopoDS_Shape bored_plate() {
  const gp_Ax2 axis(gp_Pnt(10, 10, -1), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(box(20, 20, 3), BRepPrimAPI_MakeCylinder(axis, 4, 5).Shape()).Shape();
}

void move(TopoDS_Face& face, double dz) {
  gp_Trsf up;
  up.SetTranslation(gp_Vec(0, 0, dz));
  face = TopoDS::Face(BRepBuilderAPI_Transform(face, up, true).Shape());
}

SewnFaces sewn(const Faces& faces, std::optional<double> within = {}) {
  return sewn_faces(faces, within, {});
}

double volume_of(const SewnFaces& made) {
  return std::accumulate(
      made.solids.begin(), made.solids.end(), 0.,
      [](double sum, const SewnSolid& solid) { return sum + testing::volume(solid.solid); });
}

TEST(SewnFaces, BoundTheSolidThatTheyWereTakenFrom) {
  const double pi = std::numbers::pi;
  const std::vector<std::pair<TopoDS_Shape, double>> cases = {
      {box(1, 2, 3), 6},
      {bored_plate(), 1200 - 48 * pi},
      {BRepPrimAPI_MakeCylinder(2, 5).Shape(), 20 * pi},
      {BRepPrimAPI_MakeSphere(3).Shape(), 36 * pi},
      {BRepPrimAPI_MakeTorus(5, 1).Shape(), 10 * pi * pi}};
  for (const auto& [shape, volume] : cases) {
    const Faces faces = loose_faces_of(shape);
    const SewnFaces made = sewn(faces);
    ASSERT_EQ(made.solids.size(), 1U);
    EXPECT_EQ(made.solids[0].faces.size(), faces.size());
    EXPECT_EQ(made.open_edges, 0);
    EXPECT_TRUE(BRepCheck_Analyzer(made.solids[0].solid).IsValid());
    EXPECT_NEAR(testing::volume(made.solids[0].solid), volume, 1e-6 * volume);
  }
}

TEST(SewnFaces, KeepTheirOrder) {
  const SewnFaces made = sewn(loose_faces_of(bored_plate()));
  ASSERT_EQ(made.solids.size(), 1U);
  std::size_t place = 0;
  for (TopExp_Explorer it(made.solids[0].solid, TopAbs_FACE); it.More(); it.Next()) {
    EXPECT_TRUE(it.Current().IsSame(made.solids[0].faces[place].second));
    EXPECT_EQ(made.solids[0].faces[place].first, place);
    ++place;
  }
}

TEST(SewnFaces, AreTurnedOutwardsHoweverTheyWereGiven) {
  Faces faces = loose_faces_of(box(1, 2, 3));
  faces[1].Reverse();
  faces[4].Reverse();
  EXPECT_NEAR(volume_of(sewn(faces)), 6, 1e-9);
}

TEST(SewnFaces, OfAShellInsideOfAnotherAreAVoid) {
  Faces faces = loose_faces_of(box(10, 10, 10));
  const Faces inner = loose_faces_of(BRepPrimAPI_MakeSphere(gp_Pnt(5, 5, 5), 3).Shape());
  faces.insert(faces.end(), inner.begin(), inner.end());
  const SewnFaces made = sewn(faces);
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_NEAR(volume_of(made), 1000 - 36 * std::numbers::pi, 1e-6);
}

TEST(SewnFaces, OfBodiesThatTouchInAFaceAreApart) {
  Faces faces = loose_faces_of(box(10, 10, 10));
  const Faces other = loose_faces_of(BRepPrimAPI_MakeBox(gp_Pnt(10, 0, 0), 10, 10, 10).Shape());
  faces.insert(faces.end(), other.begin(), other.end());
  const SewnFaces made = sewn(faces);
  ASSERT_EQ(made.solids.size(), 2U);
  for (const SewnSolid& solid : made.solids) EXPECT_NEAR(testing::volume(solid.solid), 1000, 1e-6);
}

TEST(SewnFaces, OfAThinTubeAreNotSewnAcrossItsWall) {
  const TopoDS_Shape tube = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(10.05, 100).Shape(),
                                            BRepPrimAPI_MakeCylinder(10, 100).Shape())
                                .Shape();
  EXPECT_NEAR(volume_of(sewn(loose_faces_of(tube))), std::numbers::pi * 100 * (10.05 * 10.05 - 100),
              1e-4);
}

TEST(SewnFaces, CloseGapsSmallBesideTheirBordersAndSayHowWide) {
  Faces faces = loose_faces_of(box(10, 10, 10));
  move(faces[5], 0.003);
  const SewnFaces made = sewn(faces);
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_NEAR(made.gap, 0.003, 1e-9);
  EXPECT_NEAR(volume_of(made), 1000, 1);
}

TEST(SewnFaces, AreSewnByTheirGapsNotByWhatTheirEdgesState) {
  const Faces faces = loose_faces_of(box(1, 1, 1));
  for (const TopoDS_Face& face : faces)
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      BRep_Builder().UpdateEdge(TopoDS::Edge(it.Current()), 0.6);
  const SewnFaces made = sewn(faces);
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_LT(made.within, 1e-6);
}

TEST(SewnFaces, LeaveWiderGapsOpenUnlessTheyAreAllowed) {
  Faces faces = loose_faces_of(box(10, 10, 10));
  move(faces[5], 0.5);
  const SewnFaces made = sewn(faces);
  EXPECT_TRUE(made.solids.empty());
  EXPECT_EQ(made.open_edges, 8);
  EXPECT_EQ(sewn(faces, 0.6).solids.size(), 1U);
}

TEST(SewnFaces, WithoutOneOfThemSayWhereTheyAreOpen) {
  Faces faces = loose_faces_of(box(10, 10, 10));
  faces.pop_back();  // the top
  const SewnFaces made = sewn(faces);
  EXPECT_TRUE(made.solids.empty());
  EXPECT_EQ(made.open_edges, 4);
  EXPECT_NEAR(made.open_at[2], 10, 1e-9);
}

TEST(SewnFaces, ThatLieApartOrOnEachOtherBoundNothing) {
  const Faces faces = loose_faces_of(box(10, 10, 10));
  EXPECT_EQ(sewn({faces[0], faces[1]}).open_edges, 0);
  EXPECT_TRUE(sewn({faces[0], faces[1]}).solids.empty());
  const TopoDS_Face again = TopoDS::Face(BRepBuilderAPI_Copy(faces[0]).Shape());
  EXPECT_TRUE(sewn({faces[0], again}).solids.empty());
}

TEST(SewnFaces, EndByTheExceptionOfTheirStop) {
  int asked = 0;
  const auto stop = [&asked] {
    if (++asked == 30) throw std::runtime_error("enough");
  };
  EXPECT_THROW(sewn_faces(loose_faces_of(box(1, 2, 3)), {}, stop), std::runtime_error);
}

}  // namespace
}  // namespace blossom::occt
