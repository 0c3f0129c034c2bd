// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets in solids, with volumes known by hand.
#include "adapters/occt/fillet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/sheet/fillet_limit.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/soundness.h"
#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "tests/adapters/occt/fillet_checks.h"
#include "tests/support/free_form_bodies.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

using testing::told;

constexpr double kPi = std::numbers::pi;
constexpr double kCut = 1 - kPi / 4;  // what a ball of radius 1 leaves of its square's corner

TopoDS_Shape box(double size) { return BRepPrimAPI_MakeBox(size, size, size).Shape(); }

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Trsf& move) {
  return BRepBuilderAPI_Transform(shape, move).Shape();
}

std::vector<int> all_edges(const TopoDS_Shape& shape) {
  std::vector<int> edges(edge_facts(shape).size());
  std::iota(edges.begin(), edges.end(), 1);
  return edges;
}

std::vector<int> edges_of_kind(const TopoDS_Shape& shape, EdgeKind kind) {
  std::vector<int> found;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == kind) found.push_back(each.number);
  return found;
}

// The edge whose middle is nearest to a point.
int edge_at(const TopoDS_Shape& shape, const Vec3& point) {
  const std::vector<EdgeFacts> facts = edge_facts(shape);
  return std::ranges::min_element(
             facts, {},
             [&](const EdgeFacts& each) {
               return each.kind == EdgeKind::Degenerate ? kInfinity : distance(each.middle, point);
             })
      ->number;
}

FilletResult rounded(const TopoDS_Shape& shape, const std::vector<int>& edges, double radius) {
  return fillet(shape, edges, {.radius = radius});
}

// One solid, sound by BRepCheck and by our own looks, of a volume.
void expect_volume(const FilletResult& made, double volume, double relative = 1e-10) {
  ASSERT_EQ(made.solids.size(), 1U) << told(made);
  EXPECT_TRUE(made.refused.empty()) << told(made);
  const TopoDS_Solid& solid = made.solids.front().solid;
  EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  const Soundness sound = soundness(solid);
  for (const FaceSoundness& face : sound.faces)
    for (const Problem& problem : face.problems) ADD_FAILURE() << problem.text();
  for (const EdgeSoundness& edge : sound.edges)
    for (const Problem& problem : edge.problems) ADD_FAILURE() << problem.text();
  EXPECT_TRUE(sound.problems.empty());
  EXPECT_NEAR(made.solids.front().volume, volume, relative * volume);
}

template <class Surface>
int count_of(const FilletResult& made) {
  int count = 0;
  for (const FilletFace& face : made.solids.front().faces)
    if (face.from == 0 && !Handle(Surface)::DownCast(BRep_Tool::Surface(face.face)).IsNull())
      ++count;
  return count;
}

TEST(FilletOfABox, OneEdgeBecomesAPieceOfACylinder) {
  for (const double radius : {0.5, 2.0, 9.0, 9.9}) {
    const FilletResult made = rounded(box(10), {1}, radius);
    expect_volume(made, 1000 - 10 * kCut * radius * radius);
    EXPECT_EQ(count_of<Geom_CylindricalSurface>(made), 1);
    EXPECT_EQ(made.solids.front().faces.size(), 7U);
  }
}

TEST(FilletOfABox, EveryEdgeIsAsGood) {
  for (const int edge : all_edges(box(10)))
    expect_volume(rounded(box(10), {edge}, 1.5), 1000 - 10 * kCut * 2.25);
}

TEST(FilletOfABox, ARadiusThatMeetsTheFarEdgesConsumesBothFaces) {
  const FilletResult made = rounded(box(10), {1}, 10);
  expect_volume(made, 1000 * (1 - kCut));
  EXPECT_EQ(made.solids.front().faces.size(), 5U);
}

TEST(FilletOfABox, TwoFilletsThatMeetInAFaceShareAnEdge) {
  const TopoDS_Shape shape = box(10);
  const FilletResult made =
      rounded(shape, {edge_at(shape, {5, 0, 10}), edge_at(shape, {5, 10, 10})}, 5);
  expect_volume(made, 1000 - 2 * 10 * kCut * 25);
  EXPECT_EQ(made.solids.front().faces.size(), 7U);
}

TEST(FilletOfABox, TwelveEdgesHaveSpheresForCorners) {
  for (const double radius : {1.0, 4.0, 4.99}) {
    const double s = 10 - 2 * radius;
    const FilletResult made = rounded(box(10), all_edges(box(10)), radius);
    expect_volume(made, s * s * s + 6 * s * s * radius + 3 * kPi * radius * radius * s +
                            4.0 / 3 * kPi * radius * radius * radius);
    EXPECT_EQ(count_of<Geom_SphericalSurface>(made), 8);
    EXPECT_EQ(count_of<Geom_CylindricalSurface>(made), 12);
  }
}

TEST(FilletOfABox, HalfItsSizeMakesABallOfIt) {
  const FilletResult made = rounded(box(10), all_edges(box(10)), 5);
  expect_volume(made, 4.0 / 3 * kPi * 125);
  EXPECT_EQ(made.solids.front().faces.size(), 8U);
}

// The groove of one edge is f(d) = r - sqrt(r^2 - (r - d)^2) wide at depth d, and what two of them
// have in common at a corner is the integral of f^2.
TEST(FilletOfABox, TwoEdgesAtAVertexMeetInAMitre) {
  const TopoDS_Shape shape = box(10);
  const FilletResult made =
      rounded(shape, {edge_at(shape, {5, 0, 10}), edge_at(shape, {0, 5, 10})}, 2);
  expect_volume(made, 1000 - 2 * 10 * kCut * 4 + 8 * (5.0 / 3 - kPi / 2));
}

TEST(FilletOfABox, FourEdgesRoundAFaceHaveFourMitres) {
  const TopoDS_Shape shape = box(10);
  std::vector<int> edges;
  for (const Vec3& at : {Vec3{5, 0, 10}, Vec3{0, 5, 10}, Vec3{5, 10, 10}, Vec3{10, 5, 10}})
    edges.push_back(edge_at(shape, at));
  expect_volume(rounded(shape, edges, 2), 1000 - 4 * 10 * kCut * 4 + 4 * 8 * (5.0 / 3 - kPi / 2));
}

TEST(FilletOfASolid, AConcaveEdgeIsFilledUpToItsEndFaces) {
  const TopoDS_Shape shape =
      BRepAlgoAPI_Cut(box(10), BRepPrimAPI_MakeBox(gp_Pnt(5, -1, 5), gp_Pnt(11, 11, 11)).Shape())
          .Shape();
  const FilletResult made = rounded(shape, edges_of_kind(shape, EdgeKind::Concave), 2);
  expect_volume(made, 750 + 10 * kCut * 4);
}

// Pappus: what is cut off has the area kCut r^2, its centroid is r (5/6 - pi/4) / kCut from both
// sides of the corner.
TEST(FilletOfASolid, RimsOfACylinderBecomePiecesOfTori) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  const double one = 2 * kPi * (5 * kCut - (5.0 / 6 - kPi / 4));
  const FilletResult made = rounded(shape, edges_of_kind(shape, EdgeKind::Convex), 1);
  expect_volume(made, 250 * kPi - 2 * one);
  EXPECT_EQ(count_of<Geom_ToroidalSurface>(made), 2);
}

TEST(FilletOfASolid, TheFootOfABossBecomesAPieceOfATorus) {
  const TopoDS_Shape shape =
      BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -2), gp_Pnt(10, 10, 0)).Shape(),
                       BRepPrimAPI_MakeCylinder(5, 10).Shape())
          .Shape();
  const FilletResult made = rounded(shape, edges_of_kind(shape, EdgeKind::Concave), 1);
  expect_volume(made, 800 + 250 * kPi + 2 * kPi * (5 * kCut + (5.0 / 6 - kPi / 4)));
}

// A plate whose vertical edges are round already: straight and circular edges take turns.
TEST(FilletOfAFillet, ItsRimIsOneChain) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(20, 10, 4).Shape();
  std::vector<int> upright;
  for (const Vec3& at : {Vec3{0, 0, 2}, Vec3{20, 0, 2}, Vec3{20, 10, 2}, Vec3{0, 10, 2}})
    upright.push_back(edge_at(plate, at));
  const FilletResult first = rounded(plate, upright, 3);
  const double around = 2 * (14 + 4), area = 200 - 4 * kCut * 9;
  expect_volume(first, 4 * area);
  const TopoDS_Shape round_plate = first.solids.front().solid;
  const FilletResult made = rounded(round_plate, {edge_at(round_plate, {10, 0, 4})}, 1);
  EXPECT_EQ(made.edges.size(), 8U);
  expect_volume(made, 4 * area - around * kCut - 2 * kPi * (3 * kCut - (5.0 / 6 - kPi / 4)));
}

class FilletOfFreeFormFaces : public ::testing::Test {
 protected:
  static FilletResult made(double height) {
    const TopoDS_Shape body = blossom::testing::free_form_body(height);
    return rounded(body, {edge_at(body, {0.5, 0.5, blossom::testing::base_cubic(0.5, 0.5)})}, 0.1);
  }
};

TEST_F(FilletOfFreeFormFaces, TheEdgeIsRoundedInTheBodyAbove) {
  expect_volume(made(2), 1.53632612576, 1e-7);
}

TEST_F(FilletOfFreeFormFaces, TheEdgeIsFilledInTheBodyBelow) {
  expect_volume(made(-1), 1.16367387424, 1e-7);
}

TEST(FilletStays, TheSameWhenTheBodyIsMovedTurnedOrScaled) {
  const TopoDS_Shape shape = box(10);
  const std::vector<int> edges{edge_at(shape, {5, 0, 10}), edge_at(shape, {0, 5, 10})};
  const double volume = 1000 - 2 * 10 * kCut * 4 + 8 * (5.0 / 3 - kPi / 2);
  gp_Trsf turn, shift;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(3, -1, 2)), 0.7);
  shift.SetTranslation(gp_Vec(120, -45, 300));
  expect_volume(rounded(moved(shape, shift * turn), edges, 2), volume);
  for (const double size : {1e-3, 1e3}) {
    gp_Trsf scale;
    scale.SetScale(gp_Pnt(0, 0, 0), size);
    const double tolerance = size < 1 ? 1e-4 : 1e-10;  // 1e-7 of a body of 0.01
    expect_volume(rounded(moved(shape, scale), edges, 2 * size), volume * size * size * size,
                  tolerance);
  }
}

TEST(FilletStays, TheSameForMirroredBodies) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
  expect_volume(rounded(moved(box(10), mirror), {1, 2}, 2),
                rounded(box(10), {1, 2}, 2).solids.front().volume);
}

// As Open CASCADE reads faces of IGES files.
TEST(FilletStays, TheSameAtPlacesThatMirror) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  const TopoDS_Shape there = cylinder.Moved(TopLoc_Location(mirror), false).Reversed();
  expect_volume(rounded(there, {1, 3}, 2), rounded(cylinder, {1, 3}, 2).solids.front().volume);
}

TEST(FilletRefuses, ARadiusForWhichThereIsNoRoom) {
  for (const double radius : {10.01, 11.0, 100.0, 1e6}) {
    const FilletResult made = rounded(box(10), {1}, radius);
    EXPECT_TRUE(made.solids.empty());
    ASSERT_EQ(made.refused.size(), 1U);
    EXPECT_EQ(made.refused.front().edge, 1);
    EXPECT_TRUE(made.refused.front().point.has_value());
  }
}

TEST(FilletRefuses, TwoFilletsThatTakeMoreOfAFaceThanThereIs) {
  const TopoDS_Shape shape = box(10);
  const FilletResult made =
      rounded(shape, {edge_at(shape, {5, 0, 10}), edge_at(shape, {5, 10, 10})}, 6);
  EXPECT_TRUE(made.solids.empty());
  ASSERT_FALSE(made.refused.empty());
  EXPECT_EQ(made.refused.front().fault, FilletFault::EdgeConsumed);
}

TEST(FilletRefuses, EdgesThatCannotBeRounded) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(5).Shape();
  const auto refusal = [](const TopoDS_Shape& shape, EdgeKind kind) {
    const FilletResult made = rounded(shape, {edges_of_kind(shape, kind).front()}, 1);
    EXPECT_TRUE(made.solids.empty());
    return made.refused.front();
  };
  EXPECT_EQ(refusal(cylinder, EdgeKind::Seam).fault, FilletFault::Nothing);
  EXPECT_NE(refusal(cylinder, EdgeKind::Seam).cause.find("seam"), std::string::npos);
  EXPECT_EQ(refusal(ball, EdgeKind::Degenerate).fault, FilletFault::Nothing);
}

TEST(FilletRefuses, FacesOfNoSolid) {
  TopoDS_Compound sheet;
  const BRep_Builder builder;
  builder.MakeCompound(sheet);
  TopExp_Explorer face(box(10), TopAbs_FACE);
  builder.Add(sheet, face.Current());
  const FilletResult made = rounded(sheet, {1}, 1);
  EXPECT_TRUE(made.solids.empty());
  EXPECT_EQ(made.refused.front().fault, FilletFault::Edge);
}

TEST(FilletRefuses, ASolidThatIsTurnedInsideOut) {
  const FilletResult made = rounded(box(10).Reversed(), {1}, 1);
  ASSERT_EQ(made.refused.size(), 1U);
  EXPECT_NE(made.refused.front().cause.find("inside out"), std::string::npos) << told(made);
}

TEST(FilletResultOf, ABoxIsTheSameWithoutVolumesOfWholeSolids) {
  const FilletResult made = fillet(box(10), {1}, {.radius = 2, .volumes = false});
  EXPECT_EQ(made.volume_before, 0);
  ASSERT_EQ(made.solids.size(), 1U) << told(made);
  EXPECT_EQ(made.solids.front().volume, 0);
  GProp_GProps properties;
  BRepGProp::VolumeProperties(made.solids.front().solid, properties);
  EXPECT_NEAR(properties.Mass(), 1000 - 10 * kCut * 4, 1e-9);
}

TEST(FilletRefuses, InPartWhatIsAskedForInPart) {
  const TopoDS_Shape shape = box(10);
  const int small = edge_at(shape, {5, 0, 10}), large = edge_at(shape, {5, 10, 0});
  FilletOptions options{.radius = 1, .own = {{large, {12}}}};
  EXPECT_TRUE(fillet(shape, {small, large}, options).solids.empty());
  options.partial = true;
  const FilletResult part = fillet(shape, {small, large}, options);
  ASSERT_EQ(part.solids.size(), 1U);
  EXPECT_EQ(part.edges, std::vector<int>{small});
  ASSERT_EQ(part.refused.size(), 1U);
  EXPECT_EQ(part.refused.front().edge, large);
}

TEST(FilletRefuses, EdgesWithNothingToRoundButRoundsTheOthers) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  const int seam = edges_of_kind(cylinder, EdgeKind::Seam).front();
  std::vector<int> edges = edges_of_kind(cylinder, EdgeKind::Convex);
  edges.push_back(seam);
  const FilletResult made = fillet(cylinder, edges, {.radius = 1});
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_EQ(made.edges.size(), 2U);
  ASSERT_EQ(made.refused.size(), 1U);
  EXPECT_EQ(made.refused.front().edge, seam);
  EXPECT_EQ(made.refused.front().fault, FilletFault::Nothing);
  // What cannot be made is told before them.
  const FilletResult none = fillet(cylinder, edges, {.radius = 20});
  EXPECT_TRUE(none.solids.empty());
  ASSERT_EQ(none.refused.size(), 2U);
  EXPECT_EQ(none.refused.back().edge, seam);
}

TEST(FilletRefuses, BadNumbers) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const double radius : {0.0, -1.0, kNone, kInfinity, -kInfinity})
    EXPECT_THROW(rounded(box(10), {1}, radius), InvalidInput) << radius;
  for (const int edge : {0, -1, 13, 1000, std::numeric_limits<int>::min()})
    EXPECT_THROW(rounded(box(10), {edge}, 1), InvalidInput) << edge;
  EXPECT_THROW(rounded(box(10), {}, 1), InvalidInput);
  EXPECT_THROW(rounded(TopoDS_Shape(), {1}, 1), InvalidInput);
}

TEST(FilletLeaves, TheGivenShapeAndOtherSolidsAsTheyWere) {
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  const TopoDS_Shape first = box(10);
  const TopoDS_Shape second = BRepPrimAPI_MakeBox(gp_Pnt(20, 0, 0), gp_Pnt(21, 1, 1)).Shape();
  builder.Add(both, first);
  builder.Add(both, second);
  const FilletResult made = rounded(both, {1}, 2);
  ASSERT_EQ(made.solids.size(), 2U) << told(made);
  EXPECT_TRUE(made.solids.back().solid.IsSame(second));
  EXPECT_NEAR(made.volume_before, 1001, 1e-9);
  const FilletResult again = rounded(both, {1}, 2);
  ASSERT_EQ(again.solids.size(), 2U);
  EXPECT_EQ(again.solids.front().volume, made.solids.front().volume);
}

TEST(EdgeFacts, TellHowFacesMeet) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  EXPECT_EQ(edges_of_kind(cylinder, EdgeKind::Convex).size(), 2U);
  EXPECT_EQ(edges_of_kind(cylinder, EdgeKind::Seam).size(), 1U);
  const EdgeFacts rim = edge_facts(
      cylinder)[static_cast<std::size_t>(edges_of_kind(cylinder, EdgeKind::Convex).front() - 1)];
  EXPECT_NEAR(rim.length, 10 * kPi, 1e-9);
  EXPECT_NEAR(rim.angle, kPi / 2, 1e-9);
  EXPECT_EQ(rim.faces.size(), 2U);
  EXPECT_EQ(edges_of_kind(box(1), EdgeKind::Convex).size(), 12U);
  const TopoDS_Shape room =
      BRepAlgoAPI_Cut(box(10), BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 1), gp_Pnt(9, 9, 9)).Shape())
          .Shape();
  EXPECT_EQ(edges_of_kind(room, EdgeKind::Concave).size(), 12U);
}

// Beside a knot line the largest radius was looked for in a piece of a few roundings, for ever.
TEST(FilletLimit, OfAnEdgeOfRealFacesIsFoundInAShortTime) {
  const char* data = blossom::testing::test_data();
  const std::filesystem::path file =
      std::filesystem::path(data != nullptr ? data : "") / "models/propeller.brep";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(file);
  const auto limit = fillet_limit(BodyEdges(model.shape()), 29, false, 0, 5);
  EXPECT_TRUE(!limit || limit->radius < 5);
}

}  // namespace
}  // namespace blossom::occt
