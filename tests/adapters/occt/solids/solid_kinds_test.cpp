// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids that touch along seams, rims and poles, and solids that state how uncertain they are.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Line.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>

#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/solid_trim.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::kPi;

SolidTrimResult combined_solids(const TopoDS_Shape& a, const TopoDS_Shape& b,
                                SolidOperation operation) {
  return trim_solids(trim_tool(a), {trim_tool(b)}, operation);
}

std::string first_obstacle(const SolidTrimResult& made) {
  return made.obstacles.empty() ? std::string() : made.obstacles.front();
}

void expect_volume(const TopoDS_Shape& a, const TopoDS_Shape& b, SolidOperation operation,
                   double volume) {
  const SolidTrimResult made = combined_solids(a, b, operation);
  ASSERT_EQ(first_obstacle(made), "");
  EXPECT_EQ(made.solids.empty(), volume == 0);
  EXPECT_NEAR(made.total.result, volume, 1e-7 * (1 + volume));
  for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
}

// With the volume of both: each of the operations, in both orders.
void expect_volumes(const TopoDS_Shape& a, double of_a, const TopoDS_Shape& b, double of_b,
                    double common) {
  expect_volume(a, b, SolidOperation::Common, common);
  expect_volume(b, a, SolidOperation::Common, common);
  expect_volume(a, b, SolidOperation::Cut, of_a - common);
  expect_volume(b, a, SolidOperation::Cut, of_b - common);
  expect_volume(a, b, SolidOperation::Fuse, of_a + of_b - common);
}

TopoDS_Shape stating(const TopoDS_Shape& shape, double tolerance) {
  ShapeFix_ShapeTolerance().SetTolerance(shape, tolerance);
  return shape;
}

// The rim lies on the ball's equator, on a meridian through its poles, or on its seam.
TEST(SolidKinds, ABallRoundTheCentreOfACylindersEndIsHalfInIt) {
  const double ball = 4.0 / 3 * kPi * 64, cylinder = kPi * 16 * 8;
  for (const gp_Dir& axis : {gp_Dir(0, 0, 1), gp_Dir(0, 0, -1), gp_Dir(1, 0, 0), gp_Dir(-1, 0, 0),
                             gp_Dir(0, 1, 0), gp_Dir(0, -1, 0), gp_Dir(1, 2, 3)})
    expect_volumes(BRepPrimAPI_MakeCylinder(4, 8).Shape(), cylinder,
                   BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 8}, axis), 4).Shape(), ball, ball / 2);
}

// Where a ball has its poles does not matter: here a circle goes through one and is no meridian, or
// passes it closely.
TEST(SolidKinds, APoleMayLieOnTheCircleInWhichABallMeetsACylinder) {
  const double ball = 4.0 / 3 * kPi * 125, rod = kPi * 9 * 20;
  const TopoDS_Shape through =
      BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -10}, {0, 0, 1}), 3, 20).Shape();
  const TopoDS_Shape inside = BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -4}, {0, 0, 1}), 3, 8).Shape();
  for (const gp_Dir& axis :
       {gp_Dir(3, 0, 4), gp_Dir(0, -3, 4), gp_Dir(-9, 12, 20), gp_Dir(0, 0, 1), gp_Dir(1, 2, 3)}) {
    const TopoDS_Shape of = BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, axis), 5).Shape();
    expect_volumes(of, ball, through, rod, 4.0 / 3 * kPi * (125 - 64));
    expect_volumes(of, ball, inside, kPi * 9 * 8, kPi * 9 * 8);
  }
}

TEST(SolidKinds, APoleMayLieOnTheCircleInWhichABallMeetsAPlane) {
  const double cap = kPi * 1 * (3 * 5 - 1) / 3;
  for (const gp_Dir& axis : {gp_Dir(3, 0, 4), gp_Dir(0, 3, -4), gp_Dir(9, 12, 20)})
    expect_volumes(BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, axis), 5).Shape(), 4.0 / 3 * kPi * 125,
                   BRepPrimAPI_MakeBox(gp_Pnt(-9, -9, 4), gp_Pnt(9, 9, 9)).Shape(), 18 * 18 * 5,
                   cap);
}

// A swept wall is a rectangle of a cylinder, which is closed but has no period.
TEST(SolidKinds, ARodGoesOnAsASweptRod) {
  const TopoDS_Edge rim = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({0, 0, 0}, {0, 0, 1}), 4)).Edge();
  const TopoDS_Edge spine = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 20)).Edge();
  const TopoDS_Shape end = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(rim).Wire()).Shape();
  const TopoDS_Shape swept =
      BRepOffsetAPI_MakePipe(BRepBuilderAPI_MakeWire(spine).Wire(), end).Shape();
  const double rod = kPi * 16 * 20;
  for (const gp_Dir& seam : {gp_Dir(1, 0, 0), gp_Dir(1, 1, 0)})
    for (const double from : {-10.0, 0.0, 10.0, 20.0})
      expect_volumes(swept, rod,
                     BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, from}, {0, 0, 1}, seam), 4, 20).Shape(),
                     rod, kPi * 16 * (20 - std::abs(from)));
}

// Their seams lie along each other, in either direction.
TEST(SolidKinds, CylindersSideBySideHaveNothingInCommon) {
  const double thick = kPi * 625 * 50, thin = kPi * 225 * 50;
  const TopoDS_Shape first =
      BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -25}, {0, 0, 1}, {1, 0, 0}), 25, 50).Shape();
  for (const gp_Dir& seam : {gp_Dir(-1, 0, 0), gp_Dir(0, 1, 0)}) {
    expect_volumes(first, thick,
                   BRepPrimAPI_MakeCylinder(gp_Ax2({40, 0, 25}, {0, 0, -1}, seam), 15, 50).Shape(),
                   thin, 0);
    expect_volumes(first, thick,
                   BRepPrimAPI_MakeCylinder(gp_Ax2({40, 0, -25}, {0, 0, 1}, seam), 15, 50).Shape(),
                   thin, 0);
  }
}

TEST(SolidKinds, ContactsOfBoxesAndRoundSolidsAreComplete) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -5), gp_Pnt(5, 5, 5)).Shape();
  for (const TopoDS_Shape& other :
       {TopoDS_Shape(BRepPrimAPI_MakeSphere(gp_Pnt(8, 1, 2), 3).Shape()),
        TopoDS_Shape(BRepPrimAPI_MakeCylinder(gp_Ax2({8, 0, -2}, {0, 0, 1}), 3, 4).Shape()),
        TopoDS_Shape(BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -5}, {0, 0, 1}), 2, 10).Shape())}) {
    const SolidTrimResult made = combined_solids(box, other, SolidOperation::Fuse);
    EXPECT_EQ(first_obstacle(made), "");
    EXPECT_EQ(made.status, Status::Complete);
  }
}

// All that is known of the cylinder's caps is known to 1e-5, so the walls of half a micrometre
// between them and the faces of the box are none.
TEST(SolidKinds, AHoleThatEndsWithinWhatItsFacesStateGoesThrough) {
  constexpr double kWall = 5e-7, kSide = 500;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(kSide, kSide, kSide).Shape();
  const TopoDS_Shape cylinder =
      BRepPrimAPI_MakeCylinder(gp_Ax2({250, 250, kWall}, {0, 0, 1}), 76, kSide - 2 * kWall).Shape();
  const SolidTrimResult made = combined_solids(box, stating(cylinder, 1e-5), SolidOperation::Cut);
  ASSERT_EQ(first_obstacle(made), "");
  ASSERT_EQ(made.solids.size(), 1u);
  EXPECT_EQ(made.faces.size(), 7u);
  EXPECT_EQ(made.status, Status::Tolerance);
  int shells = 0;
  for (TopoDS_Iterator it(made.solids.front()); it.More(); it.Next()) ++shells;
  EXPECT_EQ(shells, 1);
}

// The upper one states more than the gap between the two.
TEST(SolidKinds, SolidsOnEachOtherWithinWhatTheyStateAreFusedToOne) {
  const TopoDS_Shape low = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(4, 4, 2)).Shape();
  const TopoDS_Shape high =
      BRepPrimAPI_MakeCylinder(gp_Ax2({2, 2, 2 + 2e-6}, {0, 0, 1}), 1, 3).Shape();
  const SolidTrimResult made = combined_solids(low, stating(high, 1e-5), SolidOperation::Fuse);
  ASSERT_EQ(first_obstacle(made), "");
  EXPECT_EQ(made.solids.size(), 1u);
  EXPECT_NEAR(made.total.result, 32 + 3 * kPi, 1e-4);
}

TEST(SolidKinds, BallsThatReachIntoEachOtherWithinWhatTheyStateTouch) {
  const TopoDS_Shape a = stating(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 40).Shape(), 3e-3);
  const TopoDS_Shape b = stating(BRepPrimAPI_MakeSphere(gp_Pnt(80 - 1e-5, 0, 0), 40).Shape(), 3e-3);
  const SolidTrimResult made = combined_solids(a, b, SolidOperation::Common);
  EXPECT_EQ(first_obstacle(made), "");
  EXPECT_TRUE(made.solids.empty());
}

// An eighth of a ball, and one that is turned by 20 degrees about two axes, so that they have the
// ball in common and a meridian of one goes past the pole of the other. The volume is that of Open
// CASCADE's result.
TEST(SolidKinds, OctantsOfOneBallWithOtherAxesAreDivided) {
  constexpr double kTurn = kPi / 9, kCommon = 388.059654;
  const double c = std::cos(kTurn), s = std::sin(kTurn);
  const auto octant = [](const gp_Dir& axis, const gp_Dir& first) {
    return BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, axis, first), 10, 0, kPi / 2, kPi / 2).Shape();
  };
  const TopoDS_Shape straight = octant({0, 0, 1}, {1, 1, 0});
  const TopoDS_Shape turned = octant({-s * c, -s * s, c}, {c * c, c * s, s});
  const SolidTrimResult common = combined_solids(straight, turned, SolidOperation::Common);
  ASSERT_EQ(first_obstacle(common), "");
  EXPECT_NEAR(common.total.result, kCommon, 1e-4);
}

// The ball's equator goes round the base, and its seam touches a side's circle at a corner.
TEST(SolidKinds, ABallMayPassThroughTheCornersOfThePrismThatItsSeamTouches) {
  for (const int sides : {5, 7}) {
    BRepBuilderAPI_MakePolygon outline;
    for (int i = 0; i < sides; ++i)
      outline.Add({10 * std::cos(2 * kPi * i / sides), 10 * std::sin(2 * kPi * i / sides), 0});
    outline.Close();
    const TopoDS_Shape prism =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 10));
    const double height = 10 * (1 - std::cos(kPi / sides));  // of the ball past a side
    const double past = kPi * height * height * (30 - height) / 6;
    expect_volumes(prism, 500 * sides * std::sin(2 * kPi / sides),
                   BRepPrimAPI_MakeSphere(10).Shape(), 4000 * kPi / 3,
                   2000 * kPi / 3 - sides * past);
  }
}

// The seam of both is the circle in which they touch, and the curves in which they cross beside it
// begin in two of its points, where the angle between them is 0. What is beyond the plane of
// symmetry is half of what they have in common: at each height an annulus beyond a line.
TEST(SolidKinds, RingsThatTouchInTheirSeamsCrossBesideThem) {
  constexpr double kRing = 100, kTube = 20;
  constexpr int kSteps = 20000;
  const auto segment = [](double r, double off) {
    return off < r ? r * r * std::acos(off / r) - off * std::sqrt(r * r - off * off) : 0;
  };
  double common = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = kPi * ((i + 0.5) / kSteps - 0.5);
    const double z = kTube * std::sin(angle), wide = kTube * std::cos(angle);
    common += 2 * (segment(kRing + wide, kRing - z) - segment(kRing - wide, kRing - z)) * wide *
              kPi / kSteps;
  }
  const double whole = 2 * kPi * kPi * kRing * kTube * kTube;
  expect_volumes(
      BRepPrimAPI_MakeTorus(kRing, kTube).Shape(), whole,
      BRepPrimAPI_MakeTorus(gp_Ax2({kRing, 0, kRing}, {1, 0, 0}, {0, 0, -1}), kRing, kTube).Shape(),
      whole, common);
}

// It does so along 1e-4, nowhere farther than 1e-8 from the rim.
TEST(SolidKinds, ARimMayReachThroughAWallByLessThanTheTolerance) {
  constexpr double kRadius = 0.717, kLess = 0.75 * kRadius;
  const TopoDS_Shape wall = BRepPrimAPI_MakeCylinder(3.2, 2).Shape();
  const gp_Ax2 place({3.2 - kRadius + 1.5e-9, 0, 1}, {0, 0, -1});
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(place, kRadius, 0, 4).Shape();
  const double common = kPi / 3 * (kRadius * kRadius + kRadius * kLess + kLess * kLess);
  expect_volumes(wall, kPi * 3.2 * 3.2 * 2, cone, kPi / 3 * kRadius * kRadius * 4, common);
}

// Open CASCADE sweeps a circle along an arc to a rectangle of a torus, which it gives no period.
TEST(SolidKinds, ABoxMayStandOnTheEndOfABentPipe) {
  const gp_Circ way(gp_Ax2({20, 0, 0}, {0, -1, 0}, {1, 0, 0}), 20);  // downwards
  const gp_Circ section(gp_Ax2({0, 0, 0}, {0, 0, 1}), 4);
  const TopoDS_Wire along =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(way, kPi, 1.5 * kPi).Edge()).Wire();
  const TopoDS_Wire round = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(section).Edge()).Wire();
  const TopoDS_Shape pipe =
      BRepOffsetAPI_MakePipe(along, BRepBuilderAPI_MakeFace(round).Face()).Shape();
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-3, -3, 0), gp_Pnt(3, 3, 5)).Shape();
  expect_volumes(pipe, 160 * kPi * kPi, box, 180, 0);
}

// Their curves cross in nodes, which are told by squares of coordinates.
TEST(SolidKinds, EqualRodsMayCrossFarFromTheOrigin) {
  const auto rod = [](const gp_Dir& along) {
    const gp_Pnt middle(-1e6, 1e6, 1e3);
    return BRepPrimAPI_MakeCylinder(gp_Ax2(middle.Translated(-4 * gp_Vec(along)), along), 1, 8)
        .Shape();
  };
  expect_volumes(rod(gp::DZ()), 8 * kPi, rod(gp_Dir(0.6, 0, 0.8)), 8 * kPi, 16 / (3 * 0.6));
}

// The circle in the side x = 0 and the seam end in the corner (0, 8, 0), where they touch edges; by
// what the ball is too high they cross these 3e-6 from there.
TEST(SolidKinds, WhatTouchesAnEdgeInACornerMayCrossItBesideThat) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0, 7, -2), gp_Pnt(4, 8, 0)).Shape();
  const double c = std::sqrt(3) / 2;
  const TopoDS_Shape ball =
      BRepPrimAPI_MakeSphere(gp_Ax2({-5e-12, 8, -2 + 2.2e-12}, {-c, 0, 0.5}, {0.5, 0, c}), 2);
  expect_volumes(box, 8, ball, 32 * kPi / 3, kPi / 4 * (4 - 1.0 / 3));
}

// Of what Open CASCADE makes of a rim and a curve that touch, the curve ends 6e-7 past the rim, and
// crosses it 7e-4 beside the vertex. That covers it with a tolerance which counts as far too large.
TEST(SolidKinds, CurvesMayCrossBesideTheVertexInWhichTheyAreSaidToTouch) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(1, 1.5, 2).Shape();
  const auto rod = [](const gp_Pnt& at, double height) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(at, {0, 0, 1}), 2, height).Shape();
  };
  const TopoDS_Shape part = BRepAlgoAPI_Common(cone, rod({0, -1, 0}, 2)).Shape();
  const TopoDS_Shape tool = rod({0, 1, 0.5}, 4);
  double sum = 0;
  for (const SolidOperation operation : {SolidOperation::Cut, SolidOperation::Common}) {
    const SolidTrimResult made = combined_solids(part, tool, operation);
    EXPECT_EQ(first_obstacle(made), "");
    for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
    sum += made.total.result;
  }
  EXPECT_NEAR(sum, 9.0661585, 1e-6);  // V(part), which is no closed form
}

// An edge lies in the face x = 0, and in the plane of the tool's, but 0.003 off the face y = 0,
// where it bounds that one by what it states. So that plane and the tool meet in it.
TEST(SolidKinds, FacesMeetWhatAnEdgeLiesInAlongTheEdgeThoughTheyAreOffIt) {
  const TopoDS_Shape part = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  const BRep_Builder builder;
  for (TopExp_Explorer it(part, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    const TopoDS_Vertex from = TopExp::FirstVertex(edge), to = TopExp::LastVertex(edge);
    const gp_Pnt p = BRep_Tool::Pnt(from), q = BRep_Tool::Pnt(to);
    if (p.X() + q.X() + p.Y() + q.Y() != 0) continue;
    builder.UpdateEdge(edge, new Geom_Line(gp_Pnt(0, 0.003, 0), gp::DZ()), 0.004);
    for (const TopoDS_Vertex& end : {from, to}) builder.UpdateVertex(end, 0.004);
  }
  const TopoDS_Shape tool = BRepPrimAPI_MakeBox(gp_Pnt(-5, -3, 2), gp_Pnt(0, 3, 8)).Shape();
  expect_volume(part, tool, SolidOperation::Fuse, 1180);
  expect_volume(part, tool, SolidOperation::Common, 0);
}

// Its edges lie in the faces of the copy that have their equals, with no search.
TEST(SolidKinds, ASolidOfSplinesIsOneWithItsCopy) {
  const TopoDS_Shape part =
      BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCone(2, 1, 3, kPi / 2).Shape()).Shape();
  const double volume = kPi / 4 * 7;
  expect_volumes(part, volume, BRepBuilderAPI_Copy(part).Shape(), volume, volume);
}

// Each has an edge of its own where they touch.
TEST(SolidKinds, CubesThatTouchAlongAnEdgeAreOneWithTheirCopies) {
  const BRep_Builder builder;
  TopoDS_Compound cubes;
  builder.MakeCompound(cubes);
  builder.Add(cubes, BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1)).Shape());
  builder.Add(cubes, BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 0), gp_Pnt(2, 2, 1)).Shape());
  const TopoDS_Shape copies = BRepBuilderAPI_Copy(cubes).Shape();
  expect_volume(cubes, copies, SolidOperation::Common, 2);
  expect_volume(cubes, copies, SolidOperation::Cut, 0);
}

TEST(SolidKinds, AFlatFaceMayBeASpline) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  const TopoDS_Shape spline = BRepBuilderAPI_NurbsConvert(box).Shape();
  const SolidTrimResult made = combined_solids(box, spline, SolidOperation::Fuse);
  ASSERT_EQ(first_obstacle(made), "");
  EXPECT_EQ(made.status, Status::Complete);
  EXPECT_NEAR(made.total.result, 6, 1e-12);
}

TEST(SolidKinds, InternalEdgesInFacesBoundNothing) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 2, 2).Shape();
  const BRep_Builder builder;
  TopoDS_Face face = faces_of(box).front();  // x = 0
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0.5, 0.5), gp_Pnt(0, 1.5, 1.5))
                        .Edge()
                        .Oriented(TopAbs_INTERNAL));
  face.Free(true);
  builder.Add(face, wire.Oriented(TopAbs_INTERNAL));
  EXPECT_TRUE(is_closed_solid(TopExp_Explorer(box, TopAbs_SOLID).Current()));
}

}  // namespace
}  // namespace blossom::occt
