// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets and chamfers where edges close, meet others of another kind, or go on over smooth faces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_Plane.hxx>
#include <ShapeCustom.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/soundness.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

using testing::expect_sound;

constexpr double kPi = std::numbers::pi;
constexpr double kCut = 1 - kPi / 4;  // what a ball of radius 1 leaves of its square's corner

std::vector<int> sharp_edges(const TopoDS_Shape& shape) {
  std::vector<int> found;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Convex || each.kind == EdgeKind::Concave)
      found.push_back(each.number);
  return found;
}

std::vector<int> edges_of_kind(const TopoDS_Shape& shape, EdgeKind kind) {
  std::vector<int> found;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == kind) found.push_back(each.number);
  return found;
}

// The edges whose middles fit.
template <class Fits>
std::vector<int> edges_where(const TopoDS_Shape& shape, const Fits& fits) {
  std::vector<int> found;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Convex && fits(each.middle)) found.push_back(each.number);
  return found;
}

TopoDS_Face polygon(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& p : points) wire.Add(p);
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire());
}

TopoDS_Shape prism(const std::vector<gp_Pnt>& points, double height) {
  return BRepPrimAPI_MakePrism(polygon(points), gp_Vec(0, 0, height)).Shape();
}

void expect_volume(const FilletResult& made, double volume, double relative) {
  expect_sound(made);
  if (made.solids.empty()) return;
  EXPECT_NEAR(made.solids.front().volume, volume, relative * volume);
}

// A prism of a smooth outline with both rims rounded: at a distance d from its outline the section
// has the area A - L d + pi d^2, whatever the outline is (Steiner).
double rounded_prism(double area, double outline, double height, double r) {
  const double first = r * r - kPi * r * r / 4;                           // of d over the rim
  const double second = r * r * r * (2 - 1.0 / 3) - kPi * r * r * r / 2;  // of d^2
  return (height - 2 * r) * area + 2 * (r * area - outline * first + kPi * second);
}

TEST(FilletOfClosedEdges, RimsOfAnEllipticPrismAreRoundedAllTheWay) {
  const double a = 10, b = 6, height = 8, r = 1;
  const gp_Elips ellipse(gp_Ax2(gp_Pnt(0, 0, 0), gp::DZ()), a, b);
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(ellipse).Edge());
  const TopoDS_Shape shape =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(0, 0, height)).Shape();
  const double outline = 4 * a * std::comp_ellint_2(std::sqrt(1 - b * b / (a * a)));

  const FilletResult made = fillet(shape, sharp_edges(shape), {.radius = r});

  expect_volume(made, rounded_prism(kPi * a * b, outline, height, r), 1e-7);
}

TEST(FilletOfClosedEdges, WhereAPipeLeavesAnotherTheCornerIsFilled) {
  const TopoDS_Shape main = BRepPrimAPI_MakeCylinder(8, 40).Shape();
  const TopoDS_Shape branch =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 20), gp::DX()), 5, 20).Shape();
  const TopoDS_Shape shape = BRepAlgoAPI_Fuse(main, branch).Shape();

  const FilletResult made = fillet(shape, edges_of_kind(shape, EdgeKind::Concave), {.radius = 1});

  expect_sound(made);
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_GT(made.solids.front().volume, made.volume_before);
}

TEST(FilletOfMixedCorners, AllEdgesOfAnAngleAreRounded) {
  const double height = 20, r = 1;
  const TopoDS_Shape shape =
      prism({{0, 0, 0}, {30, 0, 0}, {30, 5, 0}, {5, 5, 0}, {5, 25, 0}, {0, 25, 0}}, height);
  const double area = 30 * 5 + 5 * 20 - 5 * kCut * r * r + kCut * r * r;
  const double outline = 110 - 6 * (2 - kPi / 2) * r;

  const FilletResult made = fillet(shape, sharp_edges(shape), {.radius = r});

  expect_volume(made, rounded_prism(area, outline, height, r), 1e-9);
  EXPECT_EQ(made.edges.size(), 18U);
}

TEST(FilletOfMixedCorners, BlendsAreNamedAfterTheEdgesThatWereGiven) {
  const TopoDS_Shape shape =
      prism({{0, 0, 0}, {30, 0, 0}, {30, 5, 0}, {5, 5, 0}, {5, 25, 0}, {0, 25, 0}}, 20);
  const FilletResult made = fillet(shape, sharp_edges(shape), {.radius = 1});
  expect_sound(made);
  ASSERT_EQ(made.solids.size(), 1U);
  int kept = 0, blends = 0;
  for (const FilletFace& face : made.solids.front().faces) {
    (face.from > 0 ? kept : blends) += 1;
    EXPECT_LE(face.from, 8);
    EXPECT_LE(face.edge, 18);
  }
  EXPECT_EQ(kept, 8);
  EXPECT_GE(blends, 18);
}

// A rib between the arms of an angle: of the three edges at the end of its slanting edge that one
// alone is convex, whether the foot across the rib's thickness is rounded or not. So it comes
// first, and the fillet of the feet goes round the rib.
TEST(FilletOfMixedCorners, FeetOfARibAreRoundedAfterItsSlantingEdge) {
  const TopoDS_Shape angle =
      prism({{0, 0, 0}, {40, 0, 0}, {40, 5, 0}, {5, 5, 0}, {5, 40, 0}, {0, 40, 0}}, 30);
  const TopoDS_Shape rib =
      BRepPrimAPI_MakePrism(polygon({{5, 5, 13}, {20, 5, 13}, {5, 20, 13}}), gp_Vec(0, 0, 4));
  const TopoDS_Shape shape = BRepAlgoAPI_Fuse(angle, rib).Shape();
  const auto edges_at = [](const TopoDS_Shape& of, const std::vector<Vec3>& middles) {
    std::vector<int> found;
    for (const EdgeFacts& each : edge_facts(of))
      for (const Vec3& at : middles)
        if (distance(each.middle, at) < 1e-6) found.push_back(each.number);
    return found;
  };
  const Vec3 slanting{12.5, 12.5, 17}, lying{12.5, 5, 17}, upright{5, 12.5, 17};

  const FilletResult made =
      fillet(shape, edges_at(shape, {slanting, lying, upright}), {.radius = 3});

  const FilletResult first = fillet(shape, edges_at(shape, {slanting}), {.radius = 3});
  ASSERT_EQ(first.solids.size(), 1U);
  const TopoDS_Shape& with_first = first.solids.front().solid;
  std::vector<int> feet;  // what is left of them begins in the inner corner
  for (const EdgeFacts& each : edge_facts(with_first))
    if (each.kind == EdgeKind::Concave && std::abs(each.middle[2] - 17) < 1e-6)
      feet.push_back(each.number);
  ASSERT_EQ(feet.size(), 2U);
  const FilletResult second = fillet(with_first, feet, {.radius = 3});
  ASSERT_EQ(second.solids.size(), 1U);
  expect_volume(made, second.solids.front().volume, 1e-9);
}

// The top of a bar on a plate, flush with the plate's side: where it is flush the foot is the one
// concave edge of three, at its other end the bar's rim is the one convex edge. As the rims go on
// in each other around the bar only one of these can come first.
// With all edges rounded nothing is left sharp.
void expect_all_rounded(const TopoDS_Shape& parts, double radius) {
  ShapeUpgrade_UnifySameDomain unified(parts);
  unified.Build();
  const TopoDS_Shape shape = TopExp_Explorer(unified.Shape(), TopAbs_SOLID).Current();
  std::vector<int> edges = edges_of_kind(shape, EdgeKind::Convex);
  std::ranges::copy(edges_of_kind(shape, EdgeKind::Concave), std::back_inserter(edges));

  const FilletResult made = fillet(shape, edges, {.radius = radius});

  expect_sound(made);
  EXPECT_TRUE(made.notes.empty()) << made.notes.front();
  ASSERT_FALSE(made.solids.empty());
  for (const EdgeKind kind : {EdgeKind::Convex, EdgeKind::Concave})
    EXPECT_TRUE(edges_of_kind(made.solids.front().solid, kind).empty());
}

// At its slope the convex edges would have to come first, and where it is flush with the plate the
// concave ones.
TEST(FilletOfMixedCorners, AllEdgesOfAPlateWithASlopingRibAreRounded) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(60, 40, 4).Shape();
  const TopoDS_Shape rib = BRepPrimAPI_MakePrism(
      polygon({{20, 0, 4}, {20, 30, 4}, {20, 20, 14}, {20, 0, 14}}), gp_Vec(6, 0, 0));
  expect_all_rounded(BRepAlgoAPI_Fuse(plate, rib), 1);
}

// In the corner where the block leaves the plate two edges of either kind meet, each in line with
// one of the other kind: their contacts on the face between run along each other.
TEST(FilletOfMixedCorners, AllEdgesOfABlockBesideAPlateAreRounded) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-9, 0, 0), 18, 20, 9).Shape();
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-13, 20, 0), 17, 6, 25).Shape();
  expect_all_rounded(BRepAlgoAPI_Fuse(plate, block), 1);
}

TEST(FilletOfMixedCorners, TheTopOfABarFlushWithItsPlateIsRounded) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(20, 5, 20).Shape();
  const TopoDS_Shape bar = BRepPrimAPI_MakeBox(gp_Pnt(15, 5, 6), 5, 10, 6).Shape();
  ShapeUpgrade_UnifySameDomain unified(BRepAlgoAPI_Fuse(plate, bar).Shape());
  unified.Build();
  const TopoDS_Shape shape = unified.Shape();
  std::vector<int> edges;
  for (const EdgeFacts& each : edge_facts(shape))
    if (std::abs(each.middle[2] - 12) < 1e-9 && each.middle[1] > 5 - 1e-9)
      edges.push_back(each.number);
  ASSERT_EQ(edges.size(), 4U);

  const FilletResult made = fillet(shape, edges, {.radius = 2});

  expect_sound(made);
  EXPECT_TRUE(made.notes.empty()) << made.notes.front();
}

// The top and the side of a bar, cut by planes at different slants: what lies beside the edge goes
// on smoothly, over borders that the contacts meet at different places.
TEST(FilletOverSmoothNeighbours, GoesOnWhereContactsMeetBordersApart) {
  for (const double slant : {0.0, 3.0, -3.0, 8.0}) {
    const double middle = 10;
    const TopoDS_Shape left =
        prism({{0, 0, 0}, {middle, 0, 0}, {middle + slant, 5, 0}, {0, 5, 0}}, 5);
    const TopoDS_Shape right =
        prism({{middle, 0, 0}, {20, 0, 0}, {20, 5, 0}, {middle + slant, 5, 0}}, 5);
    const TopoDS_Shape shape = BRepAlgoAPI_Fuse(left, right).Shape();
    const std::vector<int> edges = edges_where(
        shape, [](const Vec3& at) { return std::abs(at[1]) < 1e-9 && std::abs(at[2] - 5) < 1e-9; });
    ASSERT_EQ(edges.size(), 2U);

    const FilletResult made = fillet(shape, {edges.front()}, {.radius = 1});

    expect_volume(made, 20 * 25 - 20 * kCut, 1e-9);
  }
}

// As IGES files have cylinders. Open CASCADE's charts of contacts on them end at seams.
TEST(FilletOverSmoothNeighbours, IsTheSameOnSurfacesOfRevolution) {
  const gp_Circ circle(gp_Ax2({5, 5, 0}, {0, 0, 1}, {-1, 0, 0}), 5);  // the seam is at its start
  BRepBuilderAPI_MakeWire outline(BRepBuilderAPI_MakeEdge(circle, 0, std::numbers::pi / 2));
  const std::vector<gp_Pnt> corners{{5, 0, 0}, {60, 0, 0}, {60, 40, 0}, {0, 40, 0}, {0, 5, 0}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    outline.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[i + 1]));
  const TopoDS_Shape plain =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 50));
  const TopoDS_Shape turned = ShapeCustom::ConvertToRevolution(plain);
  std::vector<double> volumes;
  for (const TopoDS_Shape& shape : {plain, turned}) {
    const std::vector<int> top = edges_where(shape, [](const Vec3& at) {
      return std::abs(at[2] - 50) < 1e-9 && std::abs(at[0]) < 1e-9;
    });
    ASSERT_EQ(top.size(), 1U);
    const FilletResult made = fillet(shape, top, {.radius = 1});
    ASSERT_EQ(made.solids.size(), 1U) << testing::told(made);
    volumes.push_back(made.solids.front().volume);
  }
  EXPECT_NEAR(volumes[1], volumes[0], 1e-7);
}

// The far end of the border is known to a large tolerance only; a small ball does not come near it.
TEST(FilletOverSmoothNeighbours, IsAsExactAsIfTheFarEndsOfBordersWere) {
  const TopoDS_Shape left = prism({{0, 0, 0}, {30, 0, 0}, {11, 5, 0}, {0, 5, 0}}, 5);
  const TopoDS_Shape right = prism({{30, 0, 0}, {40, 0, 0}, {40, 5, 0}, {11, 5, 0}}, 5);
  for (const double far : {1e-7, 0.02}) {
    const TopoDS_Shape shape = BRepAlgoAPI_Fuse(left, right).Shape();
    for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next())
      if (const TopoDS_Vertex vertex = TopoDS::Vertex(it.Current());
          BRep_Tool::Pnt(vertex).Distance({11, 5, 5}) < 1e-6)
        BRep_Builder().UpdateVertex(vertex, far);
    const std::vector<int> edges = edges_where(
        shape, [](const Vec3& at) { return std::abs(at[1]) < 1e-9 && std::abs(at[2] - 5) < 1e-9; });
    const FilletSection parabola{SectionKind::Conic, 0.5};  // its strips are fitted

    const FilletResult made = fillet(shape, edges, {.radius = 0.01, .section = parabola});

    ASSERT_EQ(made.solids.size(), 1U) << testing::told(made);
    for (const FilletFace& face : made.solids.front().faces)
      for (TopExp_Explorer it(face.face, TopAbs_EDGE); face.from == 0 && it.More(); it.Next())
        EXPECT_LT(BRep_Tool::Tolerance(TopoDS::Edge(it.Current())), 1e-6) << far;
  }
}

TEST(FilletEnds, SlantedFacesOfAFrustumCloseTheStrip) {
  BRepOffsetAPI_ThruSections loft(true, true);
  for (const auto& [half, z] : {std::pair{10.0, 0.0}, {7.0, 12.0}}) {
    BRepBuilderAPI_MakePolygon wire(gp_Pnt(-half, -half, z), gp_Pnt(half, -half, z),
                                    gp_Pnt(half, half, z), gp_Pnt(-half, half, z), true);
    loft.AddWire(wire.Wire());
  }
  const TopoDS_Shape shape = loft.Shape();
  // Round the foot, up a corner, round the top.
  for (const Vec3& near : {Vec3{0, -10, 0}, Vec3{8.5, 8.5, 6}, Vec3{7, 0, 12}}) {
    const std::vector<int> edges =
        edges_where(shape, [&](const Vec3& at) { return distance(at, near) < 1e-6; });
    ASSERT_EQ(edges.size(), 1U);
    const int edge = edges.front();
    const FilletResult made = fillet(shape, {edge}, {.radius = 1});
    expect_sound(made);
    EXPECT_TRUE(made.notes.empty()) << edge << ": " << made.notes.front();
  }
}

// Two of three fillets do not go together; neither of them is the third's fault.
TEST(FilletInPart, KeepsWhatHasNoPartInAConflict) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(10., 10., 30.).Shape();
  const std::vector<int> upright =
      edges_where(shape, [](const Vec3& at) { return std::abs(at[2] - 15) < 1e-9; });
  ASSERT_EQ(upright.size(), 4U);

  const FilletResult made = fillet(shape, upright, {.radius = 6, .partial = true});

  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_EQ(made.edges.size(), 2U);  // opposite ones
  EXPECT_EQ(made.refused.size(), 2U);
  EXPECT_NEAR(made.solids.front().volume, 3000 - 2 * 30 * kCut * 36, 1e-6);
}

TEST(ChamferOfABox, ThreeMeetInAPlaneTriangle) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  FilletOptions options;
  options.chamfer = ChamferSize{1};

  const FilletResult made = fillet(shape, sharp_edges(shape), options);

  expect_volume(made, 1000 - 12 * 8 * 0.5 - 8 * 5.0 / 6, 1e-12);
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_EQ(made.solids.front().faces.size(), 26U);
}

TEST(ChamferOfACylinder, IsACone) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  FilletOptions options;
  options.chamfer = ChamferSize{1, 2};
  const std::vector<int> top =
      edges_where(shape, [](const Vec3& at) { return std::abs(at[2] - 10) < 1e-9; });
  ASSERT_EQ(top.size(), 1U);

  const FilletResult made = fillet(shape, top, options);

  expect_sound(made);
  ASSERT_EQ(made.solids.size(), 1U);
  int cones = 0;
  for (const FilletFace& face : made.solids.front().faces)
    if (!Handle(Geom_ConicalSurface)::DownCast(BRep_Tool::Surface(face.face)).IsNull()) ++cones;
  EXPECT_EQ(cones, 1);
  // The first distance is on the face of the smaller number: the side or the top.
  const auto ring = [](double down, double in) {
    return kPi * down * (25 - (25 + 5 * (5 - in) + (5 - in) * (5 - in)) / 3);
  };
  const double less = made.volume_before - made.solids.front().volume;
  EXPECT_LT(std::min(std::abs(less - ring(1, 2)), std::abs(less - ring(2, 1))), 1e-9);
}

// Coordinates have about 1e-13 at that distance, more than a small part of the chamfer's size.
TEST(ChamferOfALoft, IsMadeFarFromTheOrigin) {
  BRepOffsetAPI_ThruSections maker(true);
  for (const double z : {0., 12., 24.}) {
    const gp_Circ circle(gp_Ax2(gp_Pnt(500, -300, 400 + z), gp::DZ()), 8 + std::sin(z));
    maker.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()));
  }
  const TopoDS_Shape shape = maker.Shape();

  FilletOptions options;
  options.chamfer = ChamferSize{0.1};

  const FilletResult made = fillet(shape, edges_of_kind(shape, EdgeKind::Convex), options);

  expect_sound(made);
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_LT(made.solids.front().volume, made.volume_before);
}

// The rim of a loft whose sections have six bumps, as splines that close smoothly.
TEST(ChamferOfALoft, KeepsToItsBordersBetweenTheKnotsOfItsEdge) {
  BRepOffsetAPI_ThruSections maker(true);
  for (const double z : {0., 9., 18.}) {
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 6);
    for (int i = 0; i < 6; ++i) {
      const double angle = i * kPi / 3, reach = i % 2 == 0 ? 8 : 6 + z / 20;
      points->SetValue(i + 1, gp_Pnt(reach * std::cos(angle), reach * std::sin(angle), z));
    }
    GeomAPI_Interpolate closed(points, Standard_True, 1e-9);
    closed.Perform();
    maker.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(closed.Curve()).Edge()));
  }
  const TopoDS_Shape shape = maker.Shape();
  FilletOptions options;
  options.chamfer = ChamferSize{1};
  const std::vector<int> top =
      edges_where(shape, [](const Vec3& at) { return std::abs(at[2] - 18) < 1e-9; });
  ASSERT_FALSE(top.empty());

  const FilletResult made = fillet(shape, top, options);

  expect_sound(made);
  ASSERT_EQ(made.solids.size(), 1U);
  for (const EdgeSoundness& edge : soundness(made.solids.front().solid).edges)
    for (const Problem& problem : edge.problems) ADD_FAILURE() << edge.number << problem.text();
  for (const FilletFace& face : made.solids.front().faces) {
    const auto strip = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face.face));
    if (face.edge > 0 && !strip.IsNull()) {
      EXPECT_LT(strip->NbUKnots(), 200);
    }
  }
}

TEST(ChamferRefuses, BadSizes) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  for (const ChamferSize& size : {ChamferSize{0}, ChamferSize{-1}, ChamferSize{1, 0},
                                  ChamferSize{1, {}, 0}, ChamferSize{1, {}, kPi}}) {
    FilletOptions options;
    options.chamfer = size;
    EXPECT_ANY_THROW(fillet(shape, {1}, options));
  }
  FilletOptions wide;
  wide.chamfer = ChamferSize{11};
  EXPECT_TRUE(fillet(shape, {1}, wide).solids.empty());
}

// The ball rolls all round a knob on a ring, and comes back without a turn about either axis; a cut
// leaves an open part of that edge.
TEST(FilletOfALoop, ThatIsCutOpenGoesRoundNeitherSurface) {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(10, 3).Shape();
  const TopoDS_Shape knob = BRepPrimAPI_MakeSphere(gp_Pnt(13, 0, 0), 2.5).Shape();
  const TopoDS_Shape whole = BRepAlgoAPI_Fuse(ring, knob).Shape();
  const TopoDS_Shape rest = BRepPrimAPI_MakeBox(gp_Pnt(0, 0.7, -5), 30, 30, 10).Shape();
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(whole, rest).Shape();
  std::vector<int> loop;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Concave) loop.push_back(each.number);
  ASSERT_FALSE(loop.empty());
  const FilletResult made = fillet(shape, loop, {.radius = 0.4});
  testing::expect_sound(made);
  ASSERT_FALSE(HasFailure());
  EXPECT_GT(made.solids.front().volume, made.volume_before);
}

}  // namespace
}  // namespace blossom::occt
