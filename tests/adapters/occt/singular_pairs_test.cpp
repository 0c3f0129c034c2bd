// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrics and tori that touch, or nearly, where their parameters are singular too: at poles, along
// seams, in an apex. In both orders, with the seams elsewhere, and turned as a whole.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <gp_Trsf.hxx>

#include "core/bounds/box_tree.h"
#include "tests/adapters/occt/analytic_faces.h"

namespace blossom::occt::analytic {
namespace {

Maker half_sphere(const gp_Dir& axis) {
  return [=](double spin) {
    return face(new Geom_SphericalSurface(frame(O, axis, spin), 2), kTurn, {0, kPi / 2});
  };
}

// Two cylinders about axes that cross at an angle; the first is the larger one. Both branches, by
// chords round the smaller one: where they come near each other they turn in few of them.
double crossing_length(double large, double small, double degrees) {
  constexpr int kChords = 400'000;
  const double angle = degrees * kPi / 180, s = std::sin(angle), c = std::cos(angle);
  double sum = 0;
  for (const double side : {1.0, -1.0}) {
    gp_Pnt last;
    for (int i = 0; i <= kChords; ++i) {
      const double t = 2 * kPi * i / kChords, x = small * std::cos(t), y = small * std::sin(t);
      const double along = (x * c + side * std::sqrt(large * large - y * y)) / s;
      const gp_Pnt point(along * s - x * c, y, along * c + x * s);
      if (i > 0) sum += point.Distance(last);
      last = point;
    }
  }
  return sum;
}

struct SingularRow {
  std::string name;
  Maker a, b;
  double length = 0;
  double left_out = 0;  // part of the length that may lie in places
  int nodes = 0;
};

void add_cylinders(std::vector<SingularRow>& rows) {
  for (const double degrees : {5.0, 2.0, 1.0}) {
    const double half = degrees * kPi / 360, long_axis = 2 / std::sin(half);
    const double height = 1.2 * long_axis + 2;
    const std::string at = "_at_" + std::to_string(static_cast<int>(degrees));
    rows.push_back({"equal_cylinders" + at, cylinder(O, Z, 2, height),
                    cylinder(O, tilted(degrees), 2, height),
                    perimeter(2, long_axis) + perimeter(2, 2 / std::cos(half)), 1e-3, 2});
    for (const double less : {1e-3, 1e-6})
      rows.push_back({"cylinders" + at + (less > 1e-4 ? "_almost_equal" : "_hardly_apart"),
                      cylinder(O, Z, 2, height), cylinder(O, tilted(degrees), 2 - less, height),
                      crossing_length(2, 2 - less, degrees), 1e-7});
  }
}

void add_cones(std::vector<SingularRow>& rows) {
  const double s = std::sin(kPi / 6), c = std::cos(kPi / 6);
  rows.insert(
      rows.end(),
      {{"cones_of_one_apex", cone(O, Z, 10), cone(O, tilted(40), 10), 20 / c, 1e-6},
       {"cylinder_through_apex", cone(O, Z, 10), cylinder({1, 0, 0}, Z, 1), 9.688448, 1e-6},
       {"cylinder_along_inside_of_cone", cone(O, Z, 10),
        cylinder({4.5 * s - 0.4 * c, 0, 4.5 * c + 0.4 * s}, tilted(30), 0.4, 3.5), 7, 1e-6}});
}

void add_spheres(std::vector<SingularRow>& rows) {
  const double figure_eight = 20.333756, viviani = 15.280791;
  rows.insert(
      rows.end(),
      {{"plane_through_poles_along_seam", plane(O, {0.8, 0, -0.6}, 10), sphere(O, 2, {0.6, 0, 0.8}),
        4 * kPi, 1e-6},
       {"plane_through_poles", plane(O, {2, -1, 0}, 10), sphere(O, 2, {1, 2, 3}), 4 * kPi, 1e-6},
       {"sphere_in_tube_round_poles", cylinder(O, X, 2), sphere(O, 2), 4 * kPi, 1e-5},
       {"tube_on_pole", cylinder({0, 0, 0.5}, X, 1.5), sphere(O, 2), figure_eight, 1e-4, 1},
       {"viviani_on_pole", cylinder({0, 0, 1}, X, 1, 3), sphere(O, 2), viviani, 1e-4, 1},
       {"tube_through_pole", cylinder({0, 0.4, 2 - std::sqrt(0.84)}, X, 1), sphere(O, 2), 13.283845,
        1e-6}});
}

const std::vector<SingularRow>& rows() {
  static const std::vector<SingularRow> all = [] {
    std::vector<SingularRow> made;
    add_cylinders(made);
    add_cones(made);
    add_spheres(made);
    return made;
  }();
  return all;
}

class SingularPairs : public ::testing::TestWithParam<int> {
 protected:
  const SingularRow& row() const { return rows()[static_cast<std::size_t>(GetParam())]; }

  void expect_settled(const TopoDS_Face& a, const TopoDS_Face& b) const {
    const ShapeIntersection found = intersect({a}, {b});
    double length = 0;
    std::size_t nodes = 0, points = 0;
    for (const FaceIntersection& pair : found.pairs) {
      nodes += pair.found.nodes.size();
      points += pair.found.points.size();
      for (const IntersectionCurve& curve : pair.found.curves) length += curve.length;
    }
    EXPECT_LE(found.status, Status::Tolerance);
    EXPECT_NEAR(length, row().length, row().left_out * row().length);
    EXPECT_EQ(static_cast<int>(nodes), row().nodes);
    EXPECT_EQ(points, 0);
  }
};

TEST_P(SingularPairs, AreSettledInBothOrders) {
  const TopoDS_Face a = row().a(0), b = row().b(0);
  expect_settled(a, b);
  expect_settled(b, a);
}

TEST_P(SingularPairs, AreSettledWithTheSeamsElsewhere) {
  expect_settled(row().a(kSpin), row().b(kSpin));
}

TEST_P(SingularPairs, AreSettledTurned) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1({0.1, 0.2, 0.3}, {0.3, -0.5, 0.8}), 0.7);
  const TopLoc_Location place(turn);
  const auto turned = [&](const TopoDS_Face& face) { return TopoDS::Face(face.Moved(place)); };
  const TopoDS_Face a = turned(row().a(kSpin)), b = turned(row().b(1.6 * kSpin));
  expect_settled(a, b);
  expect_settled(b, a);
}

INSTANTIATE_TEST_SUITE_P(Rows, SingularPairs, ::testing::Range(0, static_cast<int>(rows().size())),
                         [](const auto& which) {
                           return rows()[static_cast<std::size_t>(which.param)].name;
                         });

// A tip that reaches through a surface, or ends before it, by less than the tolerance meets it in a
// point; the loop round it is far shorter than a curve can be.
TEST(TipOfACone, MeetsWhatIsWithinToleranceInOnePoint) {
  const TopoDS_Face tip = cone(O, Z, 10)(kSpin);
  for (const double reach : {5e-8, 1e-9, 1e-10, 0.0, -1e-10, -1e-9, -5e-8})
    for (const double degrees : {0.0, 10.0, 40.0}) {
      const gp_Dir up = tilted(degrees);
      const gp_Pnt end = O.Translated(gp_Vec(up) * reach);
      for (const TopoDS_Face& other :
           {plane(end, up)(0), sphere(end.Translated(gp_Vec(up) * -2), 2)(0),
            cylinder(end.Translated(gp_Vec(up) * -2), gp_Dir(0, 1, 0), 2)(0)}) {
        const ShapeIntersection found = intersect({tip}, {other});
        EXPECT_LE(found.status, Status::Tolerance) << reach << ' ' << degrees;
        ASSERT_EQ(found.pairs.size(), 1) << reach << ' ' << degrees;
        EXPECT_TRUE(found.pairs[0].found.curves.empty()) << reach << ' ' << degrees;
        EXPECT_LE(found.pairs[0].found.points.size(), 1) << reach << ' ' << degrees;
        const auto holds_tip = [](const Place& place) {
          return meet(widened({place.box_low, place.box_high}, 1e-7), {{0, 0, 0}, {0, 0, 0}});
        };
        EXPECT_TRUE(std::ranges::any_of(found.pairs[0].found.places, holds_tip))
            << reach << ' ' << degrees;
      }
    }
}

// A cell of one surface as small as can be beside one of the other that is not: halves of the other
// one tell nothing new, however many there are.
TEST(TipOfACone, IsSettledWhereCellsOfTheOtherSurfaceCannotBeHalved) {
  const double size = 300;
  const TopoDS_Face tip = cone(O, Z, size)(0);
  const ShapeIntersection found = intersect({tip}, {sphere({-1.3 * size, 0, 0}, 1.3 * size)(0)});
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.pairs.size(), 1);
  double length = 0;
  for (const IntersectionCurve& curve : found.pairs[0].found.curves) length += curve.length;
  EXPECT_GT(length, 2 * size);
}

struct TouchingRow {
  std::string name;
  Maker a, b;
  double length;
  Status status;
};

// Tangential curves through poles, with the seams elsewhere.
const std::vector<TouchingRow>& touching_rows() {
  const auto slim_cone = [](double spin) {
    return face(new Geom_ConicalSurface(frame(O, tilted(10), spin), kPi / 9, 0), kTurn,
                {0, 8 / std::cos(kPi / 9)});
  };
  static const std::vector<TouchingRow> all{
      {"cones_of_one_apex", cone(O, Z, 10), slim_cone, 8 / std::cos(kPi / 9), Status::Tolerance},
      {"sphere_in_tube_of_torus", torus(O, 5, 2), sphere({5, 0, 0}, 2), 4 * kPi, Status::Complete}};
  return all;
}

class TouchingThroughPoles : public ::testing::TestWithParam<int> {};

TEST_P(TouchingThroughPoles, HaveOneCurveOfFullLength) {
  const TouchingRow& row = touching_rows()[static_cast<std::size_t>(GetParam())];
  const ShapeIntersection found = intersect({row.a(kSpin)}, {row.b(1.6 * kSpin)});
  EXPECT_EQ(found.status, row.status);
  ASSERT_EQ(found.pairs.size(), 1);
  double length = 0;
  for (const IntersectionCurve& curve : found.pairs[0].found.curves) {
    EXPECT_TRUE(curve.tangential);
    length += curve.length;
  }
  EXPECT_NEAR(length, row.length, 1e-6 * row.length);
  EXPECT_TRUE(found.pairs[0].found.points.empty());
}

INSTANTIATE_TEST_SUITE_P(Rows, TouchingThroughPoles,
                         ::testing::Range(0, static_cast<int>(touching_rows().size())),
                         [](const auto& which) {
                           return touching_rows()[static_cast<std::size_t>(which.param)].name;
                         });

// Each piece of it is found from both sides of the torus's seam.
TEST(TouchingAlongSeam, IsInFewPieces) {
  const TopoDS_Face ball = sphere({5, 0, 0}, 2, Y)(0), tube = torus(O, 5, 2)(0);
  for (const auto& [a, b] : {std::pair{ball, tube}, std::pair{tube, ball}}) {
    const ShapeIntersection found = intersect({a}, {b});
    ASSERT_EQ(found.pairs.size(), 1);
    double length = 0;
    for (const IntersectionCurve& curve : found.pairs[0].found.curves) length += curve.length;
    EXPECT_NEAR(length, 4 * kPi, 1e-5);
    EXPECT_LE(found.pairs[0].found.curves.size(), 2);
  }
}

TopoDS_Face octant(double from, double beyond = 0) {
  const double end = from + kPi / 2 + beyond;
  return face(new Geom_SphericalSurface(frame(O, Z, 0), 2), {from, end}, {0, kPi / 2});
}

double total_length(const ShapeIntersection& found) {
  double length = 0;
  for (const FaceIntersection& pair : found.pairs)
    for (const IntersectionCurve& curve : pair.found.curves) length += curve.length;
  return length;
}

TEST(PartsOfASphere, BesideEachOtherTouchAlongTheirBorder) {
  const TopoDS_Face a = octant(0), b = octant(kPi / 2);
  for (const auto& [first, second] : {std::pair{a, b}, std::pair{b, a}}) {
    const ShapeIntersection found = intersect({first}, {second});
    EXPECT_EQ(found.status, Status::Complete);
    ASSERT_EQ(found.pairs.size(), 1);
    EXPECT_TRUE(found.pairs[0].found.overlaps.empty());
    EXPECT_TRUE(found.pairs[0].found.points.empty());
    EXPECT_NEAR(total_length(found), kPi, 1e-6);
  }
}

TEST(PartsOfASphere, NearlyBesideEachOtherTouchWithinTolerance) {
  for (const double beyond : {-2.5e-8, 2.5e-8}) {
    const ShapeIntersection found = intersect({octant(0, beyond)}, {octant(kPi / 2)});
    EXPECT_EQ(found.status, Status::Tolerance) << beyond;
    EXPECT_NEAR(total_length(found), kPi, 1e-6) << beyond;
  }
}

TEST(PartsOfASphere, OppositeEachOtherTouchInTheirPole) {
  const TopoDS_Face a = octant(0.3), b = octant(kPi + 0.3);
  for (const auto& [first, second] : {std::pair{a, b}, std::pair{b, a}}) {
    const ShapeIntersection found = intersect({first}, {second});
    EXPECT_EQ(found.status, Status::Complete);
    ASSERT_EQ(found.pairs.size(), 1);
    EXPECT_TRUE(found.pairs[0].found.overlaps.empty() && found.pairs[0].found.curves.empty());
    ASSERT_EQ(found.pairs[0].found.points.size(), 1);
    EXPECT_LE(distance(found.pairs[0].found.points[0].point, Vec3{0, 0, 2}), 1e-9);
  }
}

// The area inside of a boundary on a sphere about its centre, by a's parameters, as that between it
// and the upper pole; a step over the seam is none.
double area_on_sphere(const std::vector<SurfacePoint>& boundary, double r) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < boundary.size(); ++i) {
    const Vec2 &p = boundary[i].uv_a, &q = boundary[i + 1].uv_a;
    sum += r * r * (1 - std::sin(0.5 * (p[1] + q[1]))) * std::remainder(q[0] - p[0], 2 * kPi);
  }
  return sum;
}

// Of two half spheres with an angle between their axes; a seam to a pole on its border may divide
// it.
void expect_lune(const ShapeIntersection& found, double angle, std::size_t parts) {
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.pairs.size(), 1);
  EXPECT_EQ(found.pairs[0].found.overlaps.size(), parts);
  EXPECT_TRUE(found.pairs[0].found.points.empty() && found.pairs[0].found.curves.empty());
  double sum = 0;
  for (const Overlap& region : found.pairs[0].found.overlaps)
    sum += area_on_sphere(region.boundary, 2);
  const double area = 2 * 4 * (kPi - angle);
  EXPECT_NEAR(sum, area, 1e-3 * area);
}

TEST(HalfSpheres, HaveALuneInCommonThatHoldsAPole) {
  const gp_Dir axis(1, 2, 3);
  for (const bool turned : {false, true}) {
    const TopoDS_Face a = half_sphere(turned ? axis : Z)(kSpin);
    const TopoDS_Face b = half_sphere(turned ? Z : axis)(kSpin);
    expect_lune(intersect({a}, {b}), axis.Angle(Z), 1);
  }
}

TEST(HalfSpheres, AreSettledWithAPoleOnEachOthersBorder) {
  const TopoDS_Face a = half_sphere(Z)(kSpin), b = half_sphere(X)(kSpin);
  expect_lune(intersect({a}, {b}), kPi / 2, 2);
}

// Each pole is in the common region, and so no point of its own, wherever the seams begin.
TEST(HalfSpheres, ThatAreOneMeetInNoPointBesides) {
  const TopoDS_Face a = half_sphere(Z)(0), b = half_sphere(Z)(kSpin);
  const ShapeIntersection found = intersect({a}, {b});
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.pairs.size(), 1);
  EXPECT_EQ(found.pairs[0].found.overlaps.size(), 1);
  EXPECT_TRUE(found.pairs[0].found.points.empty());
}

// So far from the origin that roundings of small cells are above what counts as flat.
TEST(Spheres, TouchAPlaneWithTheirPole) {
  const gp_Dir axis(0.99939082701909576, 0, -0.03489949670250099);
  const gp_Pnt centre(139.33392669754599, 744.33392669754699, -305);
  const double r = 25;
  const Handle(Geom_Surface) ball = new Geom_SphericalSurface(gp_Ax3(centre, axis), r);
  const Handle(Geom_Surface) plane = new Geom_Plane(centre.Translated(r * gp_Vec(axis)), axis);
  const TopoDS_Face a = BRepBuilderAPI_MakeFace(plane, -100, 120, -300, 3, 1e-7).Face();
  const TopoDS_Face b = BRepBuilderAPI_MakeFace(ball, 2.4, 3.9, 0.001, kPi / 2, 1e-7).Face();
  for (const bool swapped : {false, true}) {
    const ShapeIntersection found = swapped ? intersect({b}, {a}) : intersect({a}, {b});
    EXPECT_EQ(found.status, Status::Complete);
    EXPECT_LT(found.certificate.critical, 10'000);
    ASSERT_EQ(found.pairs.size(), 1u);
    EXPECT_TRUE(found.pairs[0].found.curves.empty());
    EXPECT_EQ(found.pairs[0].found.points.size(), 1u);
  }
}

}  // namespace
}  // namespace blossom::occt::analytic
