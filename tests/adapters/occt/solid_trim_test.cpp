// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids combined, with volumes known by hand.
#include "adapters/occt/solid_trim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "core/base/errors.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;

TopoDS_Shape box(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepPrimAPI_MakeBox(from, to).Shape();
}

TopoDS_Shape ball(const gp_Pnt& centre, double radius) {
  return BRepPrimAPI_MakeSphere(centre, radius).Shape();
}

TopoDS_Shape turned(const TopoDS_Shape& shape, const gp_Dir& axis, double angle) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp::Origin(), axis), angle);
  return BRepBuilderAPI_Transform(shape, turn).Shape();
}

std::string words(const SolidTrimResult& result) {
  std::string text;
  for (const std::string& obstacle : result.obstacles) text += obstacle + "; ";
  return text;
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

struct Expected {
  double volume = 0;                          // of the common part
  std::size_t cut = 1, common = 1, fuse = 1;  // numbers of solids
};

// The independent measure: Open CASCADE's integrator.
double volume(const std::vector<TopoDS_Solid>& solids) {
  double sum = 0;
  for (const TopoDS_Solid& solid : solids) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid, properties, 1e-8);
    sum += properties.Mass();
  }
  return sum;
}

void expect_solids(const SolidTrimResult& result, std::size_t solids, double wanted, double size) {
  ASSERT_EQ(words(result), "");
  EXPECT_NE(result.status, Status::Stopped);
  EXPECT_EQ(result.solids.size(), solids);
  for (const TopoDS_Solid& solid : result.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  EXPECT_NEAR(volume(result.solids), wanted, 2e-6 * size);
  EXPECT_LE(result.volumes.back().cut_error(), 1e-8);
  EXPECT_LE(result.volumes.back().fuse_error(), 1e-8);
}

void expect_all(const TopoDS_Shape& a, const TopoDS_Shape& b, const Expected& expected) {
  const TrimTool part = trim_tool(a), tool = trim_tool(b);
  const SolidTrimResult cut = trim_solids(part, {tool}, SolidOperation::Cut);
  const double of_a = cut.volumes.back().part, of_b = cut.volumes.back().tool,
               common = expected.volume;
  expect_solids(cut, expected.cut, of_a - common, of_a);
  EXPECT_NEAR(cut.volumes.back().common, common, 1e-8 * of_a);
  expect_solids(trim_solids(part, {tool}, SolidOperation::Common), expected.common, common, of_a);
  expect_solids(trim_solids(part, {tool}, SolidOperation::Fuse), expected.fuse,
                of_a + of_b - common, of_a + of_b);
  expect_solids(trim_solids(part, {tool}, SolidOperation::Split), expected.cut + expected.common,
                of_a, of_a);
}

TEST(TrimSolids, CutsABoxByABox) {
  const TopoDS_Shape a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3.5, 4});
  expect_all(a, b, {1});
  const SolidTrimResult cut = trim_solids(trim_tool(a), {trim_tool(b)}, SolidOperation::Cut);
  ASSERT_EQ(cut.solids.size(), 1u);
  EXPECT_EQ(count(cut.solids[0], TopAbs_FACE), 9);
  EXPECT_EQ(count(cut.solids[0], TopAbs_EDGE), 21);
  EXPECT_EQ(count(cut.solids[0], TopAbs_VERTEX), 14);
}

TEST(TrimSolids, CutsABoxInTwoByABar) {
  expect_all(box({0, 0, 0}, {3, 1, 1}), box({1, -1, -1}, {2, 2, 2}), {1, 2, 1, 1});
}

TEST(TrimSolids, CutsABoxByABallAtItsCorner) {
  // Turned, so that neither its poles nor its seam lie in the box's faces.
  expect_all(box({0, 0, 0}, {2, 2, 2}), turned(ball({0, 0, 0}, 1), gp_Dir(1, 2, 3), 0.7),
             {kPi / 6});
}

TEST(TrimSolids, CutsABoxByABallThroughAFace) {
  // A cap of height 1/2 of a unit ball: pi h^2 (3 - h) / 3.
  expect_all(box({-2, -2, 0}, {2, 2, 3}), ball({0.1, 0.2, -0.5}, 1), {kPi * 0.25 * 2.5 / 3});
}

TEST(TrimSolids, CutsCylindersAtRightAngles) {
  // The bicylinder of radii 1 and 1/2, by quadrature over the thin one's section:
  // V = integral over the disc x^2 + y^2 <= 1/4 of 2 sqrt(1 - y^2).
  double wanted = 0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = kPi * (i + 0.5) / kSteps - kPi / 2, y = 0.5 * std::sin(angle);
    wanted += 4 * std::sqrt(1 - y * y) * 0.25 * std::cos(angle) * std::cos(angle) * kPi / kSteps;
  }
  const TopoDS_Shape thick = BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -2}, gp::DZ()), 1, 4).Shape();
  const TopoDS_Shape thin =
      BRepPrimAPI_MakeCylinder(gp_Ax2({-3, 0, 0.2}, gp::DX()), 0.5, 6).Shape();
  expect_all(thick, thin, {wanted, 1, 1, 1});
  expect_all(thin, thick, {wanted, 2, 1, 1});
}

TEST(TrimSolids, CutsATorusByABox) {
  // Half of it on the box's side of the plane x = 0.
  expect_all(BRepPrimAPI_MakeTorus(3, 1).Shape(), box({0, -5, -2}, {5, 5, 2}), {3 * kPi * kPi});
}

TEST(TrimSolids, LeavesAVoidWhereABallLiesInside) {
  const TopoDS_Shape a = box({-2, -2, -2}, {2, 2, 2}), b = ball({0.3, 0, 0}, 1);
  expect_all(a, b, {4 * kPi / 3});
  const SolidTrimResult cut = trim_solids(trim_tool(a), {trim_tool(b)}, SolidOperation::Cut);
  ASSERT_EQ(cut.solids.size(), 1u);
  EXPECT_EQ(count(cut.solids[0], TopAbs_SHELL), 2);
  expect_all(b, a, {4 * kPi / 3, 0, 1, 1});
}

TEST(TrimSolids, KeepsSolidsThatAreApart) {
  expect_all(box({0, 0, 0}, {1, 1, 1}), ball({5, 0, 0}, 1), {0, 1, 0, 2});
}

TEST(TrimSolids, AgreesWithOpenCascadeAboutTurnedBoxes) {
  const TopoDS_Shape a = box({-1, -1, -1}, {1, 1, 1});
  for (const double angle : {0.2, 0.7, 1.3}) {
    const TopoDS_Shape b = turned(a, gp_Dir(1, 2, 3), angle);
    BRepAlgoAPI_Common common(a, b);
    BRepAlgoAPI_Cut cut(a, b);
    GProp_GProps properties;
    BRepGProp::VolumeProperties(common.Shape(), properties, 1e-10);
    expect_all(a, b,
               {properties.Mass(), static_cast<std::size_t>(count(cut.Shape(), TopAbs_SOLID))});
  }
}

// A box whose top is `gap` too high, sewn: the edges round the top have that tolerance.
TopoDS_Shape loose_box(double gap) {
  BRepBuilderAPI_Sewing sewing(2 * gap);
  const TopoDS_Shape low = box({0, 0, 0}, {2, 2, 2}), high = box({0, 0, 0}, {2, 2, 2 + gap});
  int number = 0;
  for (TopExp_Explorer it(low, TopAbs_FACE); it.More(); it.Next())
    if (++number < 6) sewing.Add(it.Current());
  number = 0;
  for (TopExp_Explorer it(high, TopAbs_FACE); it.More(); it.Next())
    if (++number == 6) sewing.Add(it.Current());
  sewing.Perform();
  TopoDS_Solid solid;
  BRep_Builder().MakeSolid(solid);
  BRep_Builder().Add(solid, sewing.SewedShape());
  return solid;
}

TEST(TrimSolids, CutsThroughEdgesWithLooseTolerances) {
  constexpr double kGap = 1e-4;
  const TrimTool part = trim_tool(loose_box(kGap));
  double most = 0;
  for (const TopoDS_Face& face : part.faces)
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      most = std::max(most, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
  ASSERT_GE(most, kGap / 2);
  const TrimTool tool = trim_tool(turned(box({0.7, -1, 1}, {1.3, 3, 4}), gp_Dir(1, 2, 3), 0.2));
  for (const SolidOperation operation :
       {SolidOperation::Cut, SolidOperation::Common, SolidOperation::Fuse}) {
    const SolidTrimResult result = trim_solids(part, {tool}, operation);
    ASSERT_EQ(words(result), "");
    EXPECT_EQ(result.solids.size(), 1u);
    EXPECT_LE(result.volumes.back().cut_error(), kVolumeError);
    EXPECT_LE(result.volumes.back().fuse_error(), kVolumeError);
  }
}

// Where the top's own place for a crossing is 400 gaps from that of the sides.
TEST(TrimSolids, CutsThroughEdgesWithLooseTolerancesAtAFlatAngle) {
  constexpr double kGap = 1e-5, kSlope = 2.5e-3;
  const TrimTool part = trim_tool(loose_box(kGap));
  const TrimTool tool = trim_tool(turned(box({-1, -1, 2 + kSlope}, {4, 3, 4}), gp::DY(), kSlope));
  for (const SolidOperation operation :
       {SolidOperation::Cut, SolidOperation::Common, SolidOperation::Fuse}) {
    const SolidTrimResult result = trim_solids(part, {tool}, operation);
    ASSERT_EQ(words(result), "");
    EXPECT_EQ(result.solids.size(), 1u);
    EXPECT_NEAR(result.volumes.back().common, kSlope, 4 * kGap);
    EXPECT_LE(result.volumes.back().cut_error(), kVolumeError);
    EXPECT_LE(result.volumes.back().fuse_error(), kVolumeError);
  }
}

TopoDS_Shape turned_copy(const TopoDS_Shape& shape, double degrees, double part) {
  Bnd_Box around;
  BRepBndLib::Add(shape, around);
  const gp_Pnt low = around.CornerMin(), high = around.CornerMax();
  gp_Trsf turn, move;
  turn.SetRotation(
      gp_Ax1({0.5 * (low.X() + high.X()), 0.5 * (low.Y() + high.Y()), 0.5 * (low.Z() + high.Z())},
             gp_Dir(1, 2, 3)),
      degrees * kPi / 180);
  move.SetTranslation(part * gp_Vec(low, high).Magnitude() * gp_Vec(1, 0.5, 0.3));
  return BRepBuilderAPI_Transform(shape, move * turn, true).Shape();
}

TEST(TrimSolids, AgreesWithOpenCascadeAboutModelsAndTheirTurnedCopies) {
  const char* const folder = blossom::testing::test_data();
  if (folder == nullptr) GTEST_SKIP() << blossom::testing::kNoTestData;
  for (const auto& [name, degrees, part] :
       {std::tuple{"ball.brep", 23.0, 0.06}, std::tuple{"d150_wing.brep", 23.0, 0.06},
        std::tuple{"crankarm.brep", 23.0, 0.06}, std::tuple{"crankarm.brep", 2.0, 0.004}}) {
    const Model model = read_model(std::filesystem::path(folder) / "models" / name);
    const TopoDS_Shape copy = turned_copy(model.shape(), degrees, part);
    const SolidTrimResult result =
        trim_solids(trim_tool(model.shape()), {trim_tool(copy)}, SolidOperation::Common);
    ASSERT_EQ(words(result), "") << name;
    BRepAlgoAPI_Common common(model.shape(), copy);
    EXPECT_EQ(result.solids.size(), static_cast<std::size_t>(count(common.Shape(), TopAbs_SOLID)));
    GProp_GProps whole, properties;
    BRepGProp::VolumeProperties(model.shape(), whole);
    BRepGProp::VolumeProperties(common.Shape(), properties, 1e-8);
    // Solids of one input that touch each other are worked on apart. Open CASCADE's own result is
    // as exact as the edges of the models.
    double made = 0;
    for (const SolidVolumes& volumes : result.volumes) made += volumes.common;
    EXPECT_NEAR(made, properties.Mass(), 1e-6 * whole.Mass()) << name;
  }
}

// Faces up to 0.006 apart at their edges meet others at 0.7 degrees, so that the ends of cuts are
// up to 0.4 apart (s1_mainbody_back); a span of a surface is 1e-8 wide (elliptiplane). Open CASCADE
// finds other volumes.
TEST(TrimSolids, ClosesModelsWithLooseEdgesAgainstTheirTurnedCopies) {
  const char* const folder = blossom::testing::test_data();
  if (folder == nullptr) GTEST_SKIP() << blossom::testing::kNoTestData;
  for (const auto& [name, degrees, part, operation] :
       {std::tuple{"s1_mainbody_back.stp", 23.0, 0.06, SolidOperation::Cut},
        std::tuple{"s1_mainbody_back.stp", 2.0, 0.004, SolidOperation::Fuse},
        std::tuple{"elliptiplane.brep", 23.0, 0.06, SolidOperation::Common}}) {
    const Model model = read_model(std::filesystem::path(folder) / "models" / name);
    const TopoDS_Shape copy = turned_copy(model.shape(), degrees, part);
    const SolidTrimResult result =
        trim_solids(trim_tool(model.shape()), {trim_tool(copy)}, operation);
    ASSERT_EQ(words(result), "") << name;
    EXPECT_LE(result.volumes.back().cut_error(), 1e-12);
    EXPECT_LE(result.volumes.back().fuse_error(), 1e-12);
    for (const TopoDS_Solid& solid : result.solids)
      EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  }
}

// A plate with three holes at once: one through, one that ends inside, one beside the first.
// Between y = -f and f with f = x (1 - x) (40 (x - 1/2)^2 + 4 w), 10 x for x: two lobes and a
// waist.
TopoDS_Shape two_lobes(double w) {
  // Bezier coefficients of f: of x (1 - x) q, q = 40 (x - 1/2)^2 + 4 w of degree 2.
  const double ends = 10 + 4 * w, middle = -10 + 4 * w;
  const std::array<double, 5> f{0, ends / 4, middle / 3, ends / 4, 0};
  std::array<TopoDS_Edge, 2> sides;
  for (const int side : {0, 1}) {
    TColgp_Array1OfPnt poles(1, 5);
    for (int i = 0; i < 5; ++i)
      poles(i + 1) = gp_Pnt(2.5 * i, (side == 0 ? 1 : -1) * f[static_cast<std::size_t>(i)], -5);
    const Handle(Geom_BezierCurve) curve = new Geom_BezierCurve(poles);
    if (side == 1) curve->Reverse();
    sides[static_cast<std::size_t>(side)] = BRepBuilderAPI_MakeEdge(curve);
  }
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(
      gp_Pln(gp_Pnt(0, 0, -5), gp::DZ()), BRepBuilderAPI_MakeWire(sides[0], sides[1]).Wire());
  return BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, 20)).Shape();
}

// A waist of 2.4e-7 is no repeated cut: the two sides are apart beside it.
TEST(TrimSolids, CutAHoleWithAWaistOfAFewTolerances) {
  const double w = 1.2e-7, area = 2 * 10 * (1.0 / 3 + 4 * w / 6);
  const TrimTool part = trim_tool(box({-5, -5, 0}, {15, 5, 10})), tool = trim_tool(two_lobes(w));
  expect_solids(trim_solids(part, {tool}, SolidOperation::Common), 1, 10 * area, 2000);
  expect_solids(trim_solids(part, {tool}, SolidOperation::Cut), 1, 2000 - 10 * area, 2000);
}

// The second tool lies in the first one, and the others meet neither of these.
TEST(TrimSolids, CutsAtOnceWhatToolsThatAreApartCut) {
  const TrimTool plate = trim_tool(box({0, 0, 0}, {10, 10, 1}));
  const std::vector<TrimTool> tools{
      trim_tool(box({1, 1, -1}, {3, 3, 2})), trim_tool(box({1.5, 1.5, 0.2}, {2, 2, 0.8})),
      trim_tool(box({5, 1, -1}, {6, 2, 2})), trim_tool(box({8, 8, 0.5}, {11, 11, 2}))};
  const SolidTrimResult cut = trim_solids(plate, tools, SolidOperation::Cut);
  ASSERT_EQ(words(cut), "");
  EXPECT_EQ(cut.volumes.size(), 2u);
  EXPECT_NEAR(volume(cut.solids), 100 - 4 - 1 - 2, 1e-9);
  EXPECT_NEAR(cut.total.tools, 12 + 0.15 + 3 + 13.5, 1e-9);
  std::set<int> origins;
  for (const SolidFace& face : cut.faces) origins.insert(face.tool);
  EXPECT_EQ(origins, (std::set<int>{-1, 0, 2, 3}));
}

TEST(TrimSolids, TakesSeveralTools) {
  const TrimTool plate = trim_tool(box({0, 0, 0}, {4, 2, 1}));
  const std::vector<TrimTool> tools{trim_tool(box({0.5, 0.5, -1}, {1, 1, 2})),
                                    trim_tool(box({2, 0.5, 0.5}, {3, 1, 2})),
                                    trim_tool(box({1, 0.5, -1}, {1.5, 1, 2}))};
  const SolidTrimResult cut = trim_solids(plate, tools, SolidOperation::Cut);
  ASSERT_EQ(words(cut), "");
  ASSERT_EQ(cut.solids.size(), 1u);
  EXPECT_NEAR(volume(cut.solids), 8 - 0.25 - 0.25 - 0.25, 1e-9);
  EXPECT_EQ(cut.volumes.size(), 2u);  // the first two tools are apart
  for (const SolidFace& face : cut.faces) {
    ASSERT_LT(face.tool, 3);
    const auto& faces =
        face.tool < 0 ? plate.faces : tools[static_cast<std::size_t>(face.tool)].faces;
    ASSERT_LT(static_cast<std::size_t>(face.from), faces.size());
    EXPECT_EQ(BRep_Tool::Surface(face.face),
              BRep_Tool::Surface(faces[static_cast<std::size_t>(face.from)]));
  }
  const SolidTrimResult split = trim_solids(plate, tools, SolidOperation::Split);
  ASSERT_EQ(words(split), "");
  EXPECT_EQ(split.solids.size(), 4u);  // what the first and the last one cut out lies side by side
  EXPECT_NEAR(volume(split.solids), 8, 1e-9);
  const SolidTrimResult fuse = trim_solids(plate, tools, SolidOperation::Fuse);
  ASSERT_EQ(words(fuse), "");
  ASSERT_EQ(fuse.solids.size(), 1u);
  EXPECT_NEAR(volume(fuse.solids), 8 + 4 * 0.25 + 0.5, 1e-9);
  const SolidTrimResult common = trim_solids(plate, tools, SolidOperation::Common);
  EXPECT_EQ(words(common), "");
  EXPECT_TRUE(common.solids.empty());
}

// Slabs side by side fill all of the part, and others go across them.
TEST(TrimSolids, AreSplitByEachOfSeveralTools) {
  const TrimTool part = trim_tool(ball({0, 0, 0}, 1));
  std::vector<TrimTool> tools;
  for (const double from : {-2.0, -0.25, 0.5}) {
    tools.push_back(trim_tool(box({from, -2, -2}, {from < -1 ? -0.25 : from + 0.75, 2, 2})));
    tools.push_back(trim_tool(box({-2, -2, from}, {2, 2, from < -1 ? -0.25 : from + 0.75})));
  }
  const SolidTrimResult split = trim_solids(part, tools, SolidOperation::Split);
  ASSERT_EQ(words(split), "");
  EXPECT_EQ(split.solids.size(), 9u);
  EXPECT_NEAR(volume(split.solids), 4 * std::numbers::pi / 3, 1e-6);
}

TEST(TrimSolids, AreWholeOrStoppedWheneverTheyAreCancelled) {
  const TrimTool part = trim_tool(box({0, 0, 0}, {2, 2, 2})), tool = trim_tool(ball({2, 2, 2}, 1));
  bool whole = false;
  for (int allowed = 0; !whole && allowed < 4096; ++allowed) {
    std::atomic<int> asked = 0;
    const IntersectionOptions options{.cancelled = [&] { return asked++ >= allowed; }};
    const SolidTrimResult made = trim_solids(part, {tool}, SolidOperation::Cut, options);
    whole = made.obstacles.empty();
    EXPECT_EQ(made.status == Status::Stopped, !whole) << allowed << ": " << words(made);
    EXPECT_EQ(made.solids.size(), whole ? 1u : 0u);
  }
  EXPECT_TRUE(whole);
}

// A rod that lies in the end of a cone, along a line of it: right or refused, but nothing is
// thrown.
TEST(TrimSolids, RefusesPiecesThatCannotBeMeasured) {
  const TrimTool cone =
      trim_tool(BRepPrimAPI_MakeCone(gp_Ax2({0, 0, 0}, gp::DY(), gp::DZ()), 0.5, 1.5, 1).Shape());
  const TrimTool rod =
      trim_tool(BRepPrimAPI_MakeCylinder(gp_Ax2({0, 1, 0}, gp::DX(), gp::DY()), 1, 1).Shape());
  const SolidTrimResult made = trim_solids(cone, {rod}, SolidOperation::Common);
  if (made.obstacles.empty())
    EXPECT_LE(made.volumes.back().cut_error(), kVolumeError);
  else
    EXPECT_TRUE(made.solids.empty());
}

TEST(TrimSolids, RefusesWhatIsNotClosed) {
  const TopoDS_Shape a = box({0, 0, 0}, {1, 1, 1});
  const TrimTool open{{trim_tool(a).faces.front()}, {}};
  EXPECT_THROW(trim_solids(trim_tool(a), {open}, SolidOperation::Cut), InvalidInput);
  EXPECT_THROW(trim_solids(open, {trim_tool(a)}, SolidOperation::Fuse), InvalidInput);
  EXPECT_THROW(trim_solids(trim_tool(a), {}, SolidOperation::Cut), InvalidInput);
  const TrimTool nothing = trim_tool(TopoDS_Shape());
  for (const SolidOperation operation :
       {SolidOperation::Cut, SolidOperation::Common, SolidOperation::Fuse, SolidOperation::Split}) {
    EXPECT_THROW(trim_solids(nothing, {trim_tool(a)}, operation), BadModel);
    EXPECT_THROW(trim_solids(trim_tool(a), {nothing}, operation), BadModel);
  }
}

TEST(TrimSolids, TellHowManyShellsAreOpen) {
  const TrimTool a = trim_tool(box({0, 0, 0}, {1, 1, 1})), b = trim_tool(box({2, 0, 0}, {3, 1, 1}));
  const auto told = [&](const TrimTool& part) -> std::string {
    try {
      trim_solids(part, {b}, SolidOperation::Fuse);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return {};
  };
  const std::string begin = "trim: the part is no closed solid: ";
  const std::string end = "; solids are fused with solids, and sheets with sheets";
  TrimTool open{a.faces, {}};
  EXPECT_EQ(told(open), begin + "its shells close, but not all of them are in solids" + end);
  open.faces.pop_back();
  EXPECT_EQ(told(open), begin + "its shell is open, at 4 edges" + end);
  open.faces.insert(open.faces.end(), b.faces.begin(), b.faces.end());
  EXPECT_EQ(told(open), begin + "1 of its 2 shells is open, at 4 edges" + end);
}

}  // namespace
}  // namespace blossom::occt
