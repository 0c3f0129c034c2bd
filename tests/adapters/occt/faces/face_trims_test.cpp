// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/face_trims.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/pcurves.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::kPi;

TopoDS_Face square() { return BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4); }

TopoDS_Face square_with_hole() {
  const gp_Circ circle(gp_Ax2(gp_Pnt(2, 2, 0), gp_Dir(0, 0, -1)), 1);
  BRepBuilderAPI_MakeFace maker(square());
  maker.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)));
  return maker.Face();
}

Spline2 line(const Vec2& from, const Vec2& to) { return {1, {0, 1}, {2, 2}, {from, to}}; }

void expect_intervals(const std::vector<Interval>& found, const std::vector<Interval>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(found[i].from, wanted[i].from, 1e-9);
    EXPECT_NEAR(found[i].to, wanted[i].to, 1e-9);
  }
}

// The control points of a circle lie outside of it, and of the surface that it just fits in.
TEST(FaceTrims, OvershootIsOfTheWireAndNotOfItsControlPoints) {
  const Handle(Geom_Plane) plane = new Geom_Plane(gp_Pln());
  const auto disc_in_a_square = [&](double half) {
    const Handle(Geom_RectangularTrimmedSurface) bounded =
        new Geom_RectangularTrimmedSurface(plane, -half, half, -half, half);
    const Handle(Geom_Surface) square = GeomConvert::SurfaceToBSplineSurface(bounded);
    const Handle(Geom2d_Curve) circle = new Geom2d_Circle(gp_Ax2d({0, 0}, {1, 0}), 1);
    TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle, square);
    BRepLib::BuildCurve3d(edge);
    return TopoDS::Face(
        BRepBuilderAPI_MakeFace(square, BRepBuilderAPI_MakeWire(edge).Wire()).Face());
  };
  EXPECT_LE(face_trims(disc_in_a_square(1)).overshoot, 1e-7);
  EXPECT_NEAR(face_trims(disc_in_a_square(0.9)).overshoot, 0.1, 1e-7);
}

TEST(ClipToTrims, CurveInsideANaturalFaceIsWhole) {
  EXPECT_TRUE(face_trims(square()).natural);
  expect_intervals(clip_to_trims(square(), line({1, 1}, {4, 3})), {{0, 1}});
}

TEST(ClipToTrims, CurveThatLeavesIsCutAtTheBorder) {
  expect_intervals(clip_to_trims(square(), line({-4, 1}, {6, 1})), {{0.4, 0.8}});
  expect_intervals(clip_to_trims(square(), line({5, 1}, {6, 1})), {});
}

TEST(ClipToTrims, HoleIsOutside) {
  EXPECT_FALSE(face_trims(square_with_hole()).natural);
  expect_intervals(clip_to_trims(square_with_hole(), line({0, 2}, {4, 2})), {{0, 0.25}, {0.75, 1}});
}

TEST(ClipToTrims, BorderCountsAsInside) {
  expect_intervals(clip_to_trims(square_with_hole(), line({-1, 0}, {3, 0})), {{0.25, 1}});
}

TEST(ClipToTrims, OrientationOfTheFaceDoesNotMatter) {
  const TopoDS_Face turned = TopoDS::Face(square_with_hole().Reversed());
  expect_intervals(clip_to_trims(turned, line({0, 2}, {4, 2})), {{0, 0.25}, {0.75, 1}});
}

TEST(ClipToTrims, PeriodsOfTheSurfaceAreTakenOff) {
  const TopoDS_Face band =
      BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 2), 1, 3, 0, 3, 1e-7);
  expect_intervals(clip_to_trims(band, line({2 * kPi, 1}, {2 * kPi + 4, 1})), {{0.25, 0.75}});
}

// Of radius 1, above the x-axis.
TopoDS_Face half_disc() {
  const gp_Circ circle(gp_Ax2(), 1);
  const TopoDS_Wire wire =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Pnt(-1, 0, 0), gp_Pnt(1, 0, 0)),
                              BRepBuilderAPI_MakeEdge(circle, 0, kPi));
  return BRepBuilderAPI_MakeFace(gp_Pln(), wire);
}

// A spline round the origin, over [0, 1], from 0.2 to 3 radians: radius 1, 32 waves of this height,
// and a bump of another one over the middle fifth.
Spline2 waves_round_origin(double height, double bump) {
  constexpr int kSpans = 256;
  const auto place = [&](double t) {
    const double across = std::max(0.0, 1 - std::abs(t - 0.5) / 0.1);
    const double radius = 1 + height * std::cos(64 * kPi * t) + bump * across * across;
    const double angle = 0.2 + 2.8 * t;
    return Vec2{radius * std::cos(angle), radius * std::sin(angle)};
  };
  const auto slope = [&](double t) { return (0.5 / 1e-6) * (place(t + 1e-6) - place(t - 1e-6)); };
  Spline2 spline{3, {}, {}, {place(0)}};
  for (int i = 0; i <= kSpans; ++i) {
    spline.knots.push_back(static_cast<double>(i) / kSpans);
    spline.multiplicities.push_back(i == 0 || i == kSpans ? 4 : 3);
    if (i == kSpans) break;
    const double from = spline.knots.back(), to = (i + 1.0) / kSpans, third = (to - from) / 3;
    spline.points.push_back(place(from) + third * slope(from));
    spline.points.push_back(place(to) - third * slope(to));
    spline.points.push_back(place(to));
  }
  return spline;
}

// About as far from the edge as may count as a meeting, with the edge's own tolerance of 1e-7.
TEST(ClipToTrims, CurveThatWeavesAlongAWireIsWhole) {
  const TopoDS_Face face = half_disc();
  expect_intervals(clip_to_trims(face, waves_round_origin(1.2e-7, 0)), {{0, 1}});
  expect_intervals(clip_to_trims(face, waves_round_origin(3e-8, 0)), {{0, 1}});
}

TEST(ClipToTrims, CurveThatWeavesAlongAWireIsCutWhereItLeavesIt) {
  const std::vector<Interval> parts = clip_to_trims(half_disc(), waves_round_origin(1.2e-7, 1e-3));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].from, 0);
  EXPECT_NEAR(parts[0].to, 0.4, 0.005);
  EXPECT_NEAR(parts[1].from, 0.6, 0.005);
  EXPECT_EQ(parts[1].to, 1);
}

// Between arc and diameter of a half disc, within tolerance of its corner: one meeting there,
// however the curve runs.
TEST(ClippedCurve, HasOneMeetingInTheCornerOfTwoEdgesThatItTouches) {
  const FaceTrims trims = face_trims(half_disc());
  const Vec2 below{1 - 1e-8 + 1e-5, -0.1}, above{1 - 1e-8 - 1e-5, 0.1};
  for (const Spline2& cut : {line(below, above), line(above, below)}) {
    const PlanarCurve curve = chart_curve(trims, cut);
    const ClippedCurve found = clipped(trims, curve, 1e-7);
    ASSERT_EQ(found.meetings.size(), 1);
    const Vec2 point = point_at(curve, found.meetings[0].at);
    EXPECT_NEAR(point[0] / trims.scale[0], 1, 2e-8);
    EXPECT_NEAR(point[1] / trims.scale[1], 0, 1e-7);
  }
}

// The square [0, 4]^2 with a vertex in the middle of its lower side, of which the edges beside it
// stop short by a gap each.
TopoDS_Face square_with_gap(double gap) {
  const std::array<gp_Pnt2d, 5> corners{gp_Pnt2d(0, 0), {2, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Handle(Geom_Plane) plane = new Geom_Plane(gp_Pln());
  const BRep_Builder builder;
  std::array<TopoDS_Vertex, 5> vertices;
  for (std::size_t i = 0; i < 5; ++i)
    builder.MakeVertex(vertices[i], gp_Pnt(corners[i].X(), corners[i].Y(), 0), 1.1 * gap);
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (std::size_t i = 0; i < 5; ++i) {
    const gp_Pnt2d from = corners[i], to = corners[(i + 1) % 5];
    TopoDS_Edge edge;
    builder.MakeEdge(edge);
    builder.UpdateEdge(edge, new Geom2d_Line(from, gp_Vec2d(from, to)), plane, {}, 1e-7);
    builder.Range(edge, i == 1 ? gap : 0, from.Distance(to) - (i == 0 ? gap : 0));
    builder.Add(edge, vertices[i].Oriented(TopAbs_FORWARD));
    builder.Add(edge, vertices[(i + 1) % 5].Oriented(TopAbs_REVERSED));
    builder.Add(wire, edge);
  }
  BRepLib::BuildCurves3d(wire);
  TopoDS_Face face;
  builder.MakeFace(face, plane, 1e-7);
  builder.Add(face, wire);
  return face;
}

TEST(ClipToTrims, CurveIsCutInTheGapOfAWire) {
  expect_intervals(clip_to_trims(square_with_gap(1e-3), line({2.0005, -1}, {2.0005, 5})),
                   {{1.0 / 6, 5.0 / 6}});
}

TEST(ClippedCurve, MeetsAnEndOfAnEdgeInTheGapOfAWire) {
  const FaceTrims trims = face_trims(square_with_gap(1e-3));
  const ClippedCurve found =
      clipped(trims, chart_curve(trims, line({2.0005, -1}, {2.0005, 3})), 1e-7);
  ASSERT_EQ(found.meetings.size(), 1u);
  EXPECT_NEAR(found.meetings[0].at, 0.25, 1e-12);
  const Coedge& met = trims.loops.front()[static_cast<std::size_t>(found.meetings[0].coedge)];
  const Vec2 end = point_at(met.curve, found.meetings[0].edge_parameter);
  EXPECT_NEAR(end[0] / trims.scale[0], 2, 1.1e-3);
}

TEST(FaceTrims, SidesOfASeamHaveCornersOfTheirOwn) {
  const FaceTrims trims = face_trims(
      BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 2), 0, 2 * kPi, 0, 3, 1e-7));
  EXPECT_EQ(trims.corners.size(), 4u);
  EXPECT_LE(trims.largest_gap, 1e-12);
  EXPECT_DOUBLE_EQ(trims.period[0], 2 * kPi * trims.scale[0]);
}

TEST(FaceTrims, RefuseAFaceWithoutWires) {
  TopoDS_Face bare;
  BRep_Builder().MakeFace(bare, new Geom_Plane(gp_Pln()), 1e-7);
  EXPECT_THROW(face_trims(bare), BadModel);
}

class PlanarCurveOf : public ::testing::Test {
 protected:
  static void expect_same(const Handle(Geom2d_Curve) & curve, const Interval& range, double error) {
    const PlanarCurve converted = planar_curve(curve, range);
    for (double s = 0; s <= 1; s += 1.0 / 64) {
      const gp_Pnt2d wanted = curve->Value(at(range, s));
      const Vec2 found = point_at(converted, at(range, s));
      EXPECT_LE(distance(found, Vec2{wanted.X(), wanted.Y()}), error) << "at " << s;
    }
  }
};

TEST_F(PlanarCurveOf, ConicsKeepTheirAngle) {
  const gp_Ax22d turned(gp_Pnt2d(1, 2), gp_Dir2d(0.6, 0.8), gp_Dir2d(0.8, -0.6));
  expect_same(new Geom2d_Circle(turned, 2), {0.3, 5}, 1e-14);
  expect_same(new Geom2d_Ellipse(turned, 3, 1), {-1, 2}, 1e-14);
}

TEST_F(PlanarCurveOf, OtherCurvesAreWithinTheirError) {
  expect_same(new Geom2d_Hyperbola(gp_Ax2d(), 2, 1), {-1, 1}, 1e-8);
  const Handle(Geom2d_Curve) ellipse = new Geom2d_Ellipse(gp_Ax2d(), 3, 2);
  expect_same(new Geom2d_OffsetCurve(ellipse, 0.5), {0, 3}, 1e-8);
}

TEST_F(PlanarCurveOf, EmptyRangeIsRefused) {
  EXPECT_THROW(planar_curve(new Geom2d_Circle(gp_Ax2d(), 1), {1, 1}), BadModel);
}

TEST(PartSide, TellsWhereARectangleLies) {
  const FaceTrims trims = face_trims(square_with_hole());
  EXPECT_EQ(part_side(trims, {0.1, 0.9}, {0.1, 0.9}), PartSide::Inside);
  EXPECT_EQ(part_side(trims, {1.5, 2.5}, {1.5, 2.5}), PartSide::Outside);
  EXPECT_EQ(part_side(trims, {0.5, 2}, {0.5, 2}), PartSide::Mixed);
  EXPECT_EQ(part_side(trims, {0, 4}, {0, 4}), PartSide::Mixed);
  EXPECT_EQ(part_side(trims, {4.5, 5}, {1, 2}), PartSide::Outside);
  // In the hole, though no corner of it is far from the wire.
  EXPECT_EQ(part_side(trims, {1.3, 2.7}, {1.3, 2.7}), PartSide::Outside);
  EXPECT_EQ(part_side(trims, {1.29, 2.71}, {1.29, 2.71}), PartSide::Mixed);
}

// The arc is one span, whose pieces' boxes reach much farther off it.
TEST(PartSide, TellsPointsCloseToACurvedWire) {
  const FaceTrims trims = face_trims(square_with_hole());
  for (int i = 0; i < 40; ++i) {
    const Vec2 out{std::cos(0.1 + i), std::sin(0.1 + i)};
    const auto side = [&](double radius) {
      const Vec2 at = Vec2{2, 2} + radius * out;
      return part_side(trims, {at[0], at[0]}, {at[1], at[1]});
    };
    EXPECT_EQ(side(1 + 1e-5), PartSide::Inside);
    EXPECT_EQ(side(1), PartSide::Mixed);
    EXPECT_EQ(side(1 - 1e-5), PartSide::Outside);
  }
}

TEST(PartSide, KnowsPeriods) {
  const Handle(Geom_CylindricalSurface) wall = new Geom_CylindricalSurface(gp_Ax3(), 1);
  const FaceTrims trims = face_trims(BRepBuilderAPI_MakeFace(wall, 6, 7, 0, 1, 1e-7));
  const double turn = 2 * kPi;
  EXPECT_NE(part_side(trims, {6.2 - turn, 6.4 - turn}, {0.2, 0.8}), PartSide::Outside);
  EXPECT_EQ(part_side(trims, {3, 4}, {0.2, 0.8}), PartSide::Outside);
}

// Points of a whole turn are in a face that is trimmed to another turn of the same surface.
TEST(FaceTrims, KnowThePeriodOfASurfaceThatEndsAfterOneTurn) {
  const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(gp_Ax3(), 3, 1);
  const Handle(Geom_Surface) turn =
      new Geom_RectangularTrimmedSurface(torus, 0, 0.5 * kPi, kPi, 3 * kPi);
  ASSERT_FALSE(turn->IsVPeriodic());
  const FaceTrims trims = face_trims(BRepBuilderAPI_MakeFace(turn, 1e-7).Face());
  EXPECT_NEAR(trims.period[1], 2 * kPi * trims.scale[1], 1e-12);
  for (const double v : {0.5 * kPi, 1.5 * kPi, 2.5 * kPi}) {
    EXPECT_EQ(part_side(trims, {1, 1}, {v, v}), PartSide::Inside) << v;
    EXPECT_EQ(part_side(trims, {2, 2}, {v, v}), PartSide::Outside) << v;
  }
}

}  // namespace
}  // namespace blossom::occt
